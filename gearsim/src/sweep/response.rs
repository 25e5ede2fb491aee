//! Response curves: a scene at one value after another, each from the settled state before it, upward and then downward. Where two
//! steady motions exist at one value, the two ways differ: jumps and hysteresis show.
//!
//! A varied speed, `start.speed`, is that of the rigid motion. The next point has the coordinates and speeds at the end of the point
//! before it, with the rigid motion changed so that its mean speed over the measured time would have been the new one.

use super::{Error, Status, Sweep, axis, impossible};
use crate::analysis::statistics::Statistics;
use crate::model::{Output, Start};
use crate::output::table::Values;
use crate::output::{OutputError, Table};
use crate::run::Outcome;
use crate::scene::Scene;
use crate::trajectory::Trajectory;

/// The points of a response curve.
#[derive(Debug, Clone)]
pub struct Response {
    /// The varied key.
    pub key: String,
    /// Its SI unit.
    pub unit: String,
    /// The observed outputs.
    pub outputs: Vec<&'static Output>,
    /// The points in the order in which they were run.
    pub points: Vec<Point>,
}

/// A point of a response curve.
#[derive(Debug, Clone)]
pub struct Point {
    /// Whether the value was reached from below.
    pub upward: bool,
    /// The value of the varied key [SI].
    pub value: f64,
    /// The mean speed of the model's first motion over the measured time [SI]; NaN if it has none.
    pub speed: f64,
    /// Statistics of each output over the measured time.
    pub observed: Vec<Option<Statistics>>,
    /// How the run ended.
    pub status: Status,
    /// Why it is not [`Status::Done`]; else empty.
    pub reason: String,
}

/// A motion of the model: the speeds of unit size, and the coordinate by which its size is measured.
struct Motion {
    unit: Vec<f64>,
    by: usize,
    /// Its number, if its speed is varied.
    varied: Option<usize>,
}

impl Sweep {
    /// The response over the only axis of the sweep, of the recorded outputs over the time from [`Sweep::from`] on; then downward, if
    /// `both`. `watch` is told the number of points done, during the runs too.
    ///
    /// # Errors
    /// If there is not exactly one axis with numbers in rising order, or the scene records no output.
    pub fn response(&self, both: bool, watch: &mut dyn FnMut(usize)) -> Result<Response, Error> {
        let [axis] = &self.plan.axes[..] else { return impossible("a response has one axis", "vary one key") };
        let texts: Vec<String> = (0..self.points).map(|i| self.plan.overrides(i).remove(0)).collect();
        let values: Vec<f64> = (0..self.points).map(|i| axis::si(&self.plan.values(i)[0])).collect();
        if self.plan.is_random() || values.len() < 2 || !values.windows(2).all(|pair| pair[0] < pair[1]) {
            let help = "give a rising range of numbers: start.speed=\"100 rpm:2000 rpm:50\"";
            return impossible(format!("the values of `{}` do not rise", axis.key), help);
        }
        let first = self.scene_at(&texts[0])?;
        if first.output.record.is_empty() {
            return impossible("the scene records no output", "name one: --output dte_12");
        }
        let motion = Motion::of(&first, &axis.key, self)?;
        let outputs = first.output.record.iter().map(|&i| &first.model.outputs[i]).collect();
        let mut response = Response { key: axis.key.clone(), unit: self.unit(), outputs, points: vec![] };
        let down = (0..values.len()).rev().filter(|_| both).map(|i| (false, i));
        let mut before: Option<Trajectory> = None;
        for (done, (upward, i)) in (0..values.len()).map(|i| (true, i)).chain(down).enumerate() {
            let mut scene = self.scene_at(&texts[i])?;
            if let Some(before) = &before {
                motion.go_on(&mut scene, before, self.from);
            }
            let outcome = self.entry.run(&scene, &mut |_| watch(done));
            response.points.push(self.observed(upward, values[i], &motion, &outcome, response.outputs.len()));
            before = outcome.ok().filter(|o| o.stopped_by.is_none() && o.refuted.is_none()).map(|o| o.trajectory);
            watch(done + 1);
        }
        Ok(response)
    }

    /// The scene with the varied value as an override. Its events are not recorded: extremes are those of the samples.
    fn scene_at(&self, text: &str) -> Result<Scene, Error> {
        let mut scene = self.template.scene(&[text.to_owned()], &[self.entry.model])?;
        scene.output.events = false;
        Ok(scene)
    }

    fn unit(&self) -> String {
        crate::scene::unit_of(&self.plan.axes[0].key, self.entry.model).unwrap_or_default()
    }

    fn observed(
        &self,
        upward: bool,
        value: f64,
        motion: &Motion,
        outcome: &Result<Outcome, impl std::fmt::Display>,
        outputs: usize,
    ) -> Point {
        let none =
            |status, reason| Point { upward, value, speed: f64::NAN, observed: vec![None; outputs], status, reason };
        let outcome = match outcome {
            Err(refusal) => return none(Status::Refused, refusal.to_string()),
            Ok(outcome) => outcome,
        };
        if let Some(stop) = &outcome.stopped_by {
            return none(Status::Stopped, stop.to_string());
        }
        if let Some(account) = &outcome.refuted {
            return none(Status::Refuted, account.to_string());
        }
        let run = &outcome.trajectory;
        let begin = run.t.partition_point(|&t| t < self.from);
        let observed = run.outputs.iter().map(|(_, x)| Statistics::of(&x[begin..], &run.moment[begin..])).collect();
        let speed = motion.mean_speed(run, self.from);
        Point { upward, value, speed, observed, status: Status::Done, reason: String::new() }
    }
}

impl Motion {
    /// The motion whose speed is varied, else the first one of the model.
    fn of(scene: &Scene, key: &str, sweep: &Sweep) -> Result<Motion, Error> {
        let named = |name: &str| key.strip_prefix("start.") == Some(name);
        let varied = scene.model.motions.iter().position(|motion| named(motion.name));
        let equations = sweep
            .entry
            .equations(scene)
            .map_err(|refusal| Error::Impossible { what: refusal.to_string(), help: "choose other effects".into() })?;
        let unit = match scene.model.motions.is_empty() {
            true => vec![0.0; equations.coordinates()],
            false => equations.motion(varied.unwrap_or(0)).to_vec(),
        };
        let by = (0..unit.len()).max_by(|&i, &j| unit[i].abs().total_cmp(&unit[j].abs())).unwrap_or(0);
        Ok(Motion { unit, by, varied })
    }

    /// Its mean size in a run from the time `from` \[s\] on.
    fn mean_speed(&self, run: &Trajectory, from: f64) -> f64 {
        let (begin, end) = (run.t.partition_point(|&t| t < from), run.len() - 1);
        (run.q[self.by][end] - run.q[self.by][begin]) / (run.t[end] - run.t[begin]) / self.unit[self.by]
    }

    /// Begins a scene where the run `before` it has ended, at the speed of the scene if that is varied.
    fn go_on(&self, scene: &mut Scene, before: &Trajectory, from: f64) {
        let more = match self.varied {
            Some(motion) => scene.start.motions[motion] - self.mean_speed(before, from),
            None => 0.0,
        };
        let last = |column: &Vec<f64>| column[column.len() - 1];
        scene.start.q = before.q.iter().map(|column| Start::At(last(column))).collect();
        scene.start.q_dot = before.q_dot.iter().zip(&self.unit).map(|(v, unit)| Some(last(v) + more * unit)).collect();
    }
}

impl Response {
    /// The points as a table: `upward`, the varied key, `mean_speed`, `status`, `reason`, and of each output the mean, the root mean
    /// square about the mean, and the peak-to-peak value.
    ///
    /// # Errors
    /// [`OutputError::Ragged`] never happens: all columns have one entry a point.
    pub fn table(&self) -> Result<Table, OutputError> {
        let mut table = Table::default();
        let numbers = |value: &dyn Fn(&Point) -> f64| Values::Number(self.points.iter().map(value).collect());
        let texts = |text: &dyn Fn(&Point) -> String| {
            Values::Text(self.points.iter().map(|point| text(point).into()).collect())
        };
        table.push("way", "", texts(&|point| if point.upward { "up".into() } else { "down".into() }))?;
        table.push(&self.key, &self.unit, numbers(&|point| point.value))?;
        table.push("mean_speed", "rad/s", numbers(&|point| point.speed))?;
        table.push("status", "", texts(&|point| point.status.name().into()))?;
        table.push("reason", "", texts(&|point| point.reason.clone()))?;
        for (i, output) in self.outputs.iter().enumerate() {
            for (what, value) in MEASURES {
                let of = |point: &Point| point.observed[i].as_ref().map_or(f64::NAN, value);
                table.push(&format!("{}_{what}", output.name), output.unit, numbers(&of))?;
            }
        }
        Ok(table)
    }
}

/// A measure of an output.
pub type Measure = fn(&Statistics) -> f64;

/// What is measured of an output: the name, and the value.
pub const MEASURES: [(&str, Measure); 3] =
    [("mean", |s| s.mean), ("rms", |s| s.rms), ("peak_to_peak", |s| s.max - s.min)];
