//! Response curves: a scene at one value after another, each from the settled state before it, upward and then downward. Where two
//! steady motions exist at one value, the two ways differ: jumps and hysteresis show.
//!
//! A varied speed, `start.speed`, is that of the rigid motion. The next point starts from the coordinates and speeds at the end of the
//! point before it, with the rigid motion changed so that its mean speed over the measured time would have been the new one. The set point
//! of a governor, or a torque, holds it there. Each point is measured over whole periods.

mod hold;
mod measure;
mod motion;
mod span;

use super::{Error, Status, Sweep, axis, impossible};
use crate::analysis::dynamic_factor::{self, DynamicFactor};
use crate::analysis::statistics::Statistics;
use crate::model::{Model, Output};
use crate::output::table::Values;
use crate::output::unit::readable;
use crate::output::{OutputError, Table, remarks};
use crate::run::Outcome;
use crate::scene::{Scene, list};
use crate::tolerance::analysis::{HELD_PART, SPEED_NOT_HELD};
use crate::trajectory::Trajectory;

pub use hold::Hold;
use hold::{Handle, Speed};
pub use measure::{MEASURES, Measure, measure};
use motion::UnitMotion;
use span::Excitations;
pub use span::Span;

/// Most runs of a point in the search for the parameter value that holds its speed; each step of Newton's method takes one.
const RUNS: usize = 6;

/// The points of a response curve.
#[derive(Debug, Clone)]
pub struct ResponseCurve {
    /// The varied key.
    pub key: String,
    /// Its SI unit.
    pub unit: String,
    /// Description of the key, in words.
    pub words: String,
    /// The model.
    pub model: &'static Model,
    /// The observed outputs.
    pub outputs: Vec<&'static Output>,
    /// The parameter that holds the speed: its name, and its SI unit.
    pub held: Option<(&'static str, &'static str)>,
    /// What holds the speed, or why nothing does: a sentence.
    pub holding: String,
    /// The points in the order in which they were run.
    pub points: Vec<ResponsePoint>,
}

/// A point of a response curve.
#[derive(Debug, Clone)]
pub struct ResponsePoint {
    /// Whether the value was reached from below.
    pub upward: bool,
    /// The value of the varied key \[SI\].
    pub value: f64,
    /// The mean speed of the varied motion, or of the model's first one, over the measured time \[SI\]; NaN if the model has no motion.
    pub speed: f64,
    /// Relative change of this speed over the measured time \[1\], without its oscillation; NaN if the model has no motion.
    pub drift: f64,
    /// The value of the parameter that holds the speed \[SI\]; NaN if no parameter holds it.
    pub hold: f64,
    /// What was measured; `None` if there is no result.
    pub span: Option<Span>,
    /// Statistics of each output over the measured time.
    pub observed: Vec<Option<Statistics>>,
    /// The dynamic factor of each output that is the force of a mesh, over the measured time.
    pub factors: Vec<Option<DynamicFactor>>,
    /// How the run ended.
    pub status: Status,
    /// Why it is not `done`; else empty.
    pub reason: String,
    /// What a reader of its numbers must know, a sentence each.
    pub remarks: Vec<String>,
}

impl Sweep {
    /// The response of the recorded outputs over the only axis of the sweep, first upward, then downward if `both`. Each point is measured
    /// from the time [`Sweep::from`] on. `watch` is called with the number of finished points, also during the runs.
    ///
    /// # Errors
    /// If there is not exactly one axis with numbers in rising order, the scene records no output, or the parameter of `hold` cannot hold
    /// the speed.
    pub fn response(&self, both: bool, hold: &Hold, watch: &mut dyn FnMut(usize)) -> Result<ResponseCurve, Error> {
        let [axis] = &self.plan.axes[..] else { return impossible("a response has one axis", "vary one key") };
        let texts: Vec<String> = (0..self.points).map(|i| self.plan.overrides(i).remove(0)).collect();
        let values: Vec<f64> = (0..self.points).map(|i| axis::si(&self.plan.values(i)[0])).collect();
        if self.plan.is_random() || values.len() < 2 || !values.windows(2).all(|pair| pair[0] < pair[1]) {
            let help = "give a rising range of numbers: start.speed=\"100 rpm:2000 rpm:50\"";
            return impossible(format!("the values of `{}` do not rise", axis.key), help);
        }
        let first = self.scene_at(&texts[0])?;
        if first.output.record.is_empty() {
            return impossible("the scene records no output", "name one in output.record: [\"dte_12\"]");
        }
        let motion = UnitMotion::of(&first, &axis.key, self)?;
        let (handle, holding) = self.handle(&self.scene_at(&texts[texts.len() - 1])?, &axis.key, &motion, hold)?;
        let outputs = first.output.record.iter().map(|&i| &first.model.outputs[i]).collect();
        let named = |handle: &Handle| {
            let parameter = &first.model.parameters[handle.parameter];
            (parameter.name, parameter.unit)
        };
        let (held, unit, words) = (handle.as_ref().map(named), self.unit(), words(&axis.key, first.model));
        let (key, model) = (axis.key.clone(), first.model);
        let mut response = ResponseCurve { key, unit, words, model, outputs, held, holding, points: vec![] };
        let down = (0..values.len()).rev().filter(|_| both).map(|i| (false, i));
        let (mut before, mut more): (Option<(Trajectory, f64)>, f64) = (None, 0.0);
        for (done, (upward, i)) in (0..values.len()).map(|i| (true, i)).chain(down).enumerate() {
            let at = At { text: &texts[i], motion: &motion, handle: handle.as_ref(), before: before.as_ref() };
            let mut point = ResponsePoint { upward, value: values[i], ..ResponsePoint::none(response.outputs.len()) };
            let ended = self.settled(&at, &mut more, &mut point, &mut |_| watch(done))?;
            before = ended.map(|run| (run, point.speed));
            response.points.push(point);
            watch(done + 1);
        }
        Ok(response)
    }

    /// What holds the speed of a scene, and a sentence about it.
    fn handle(
        &self,
        scene: &Scene,
        key: &str,
        motion: &UnitMotion,
        hold: &Hold,
    ) -> Result<(Option<Handle>, String), Error> {
        let free = |why: &str| Ok((None, format!("the speed is set at the start of each point, and not held: {why}")));
        let name = |handle: &Handle| scene.model.parameters[handle.parameter].name;
        let speed = motion.stated(scene);
        let mut all = match (hold, motion.varied) {
            (Hold::Nothing, _) => return free("`nothing` was chosen"),
            (Hold::Own, None) => return free(&format!("`{key}` is no speed; choose a parameter that holds it")),
            _ => Handle::all(scene, &self.entry, motion, speed),
        };
        all.retain(|handle| key.strip_prefix("parameters.") != Some(name(handle)));
        let found = match hold {
            Hold::By(wanted) => {
                let names: Vec<&str> = all.iter().map(name).collect();
                let Some(found) = all.iter().find(|handle| name(handle) == wanted) else {
                    let help =
                        if names.is_empty() { "no parameter can".into() } else { format!("choose {}", list(&names)) };
                    return impossible(format!("`{wanted}` cannot hold the speed"), help);
                };
                if speed == 0.0 {
                    return impossible("the scene states no speed that could be held", "set start.speed");
                }
                found.clone()
            }
            _ => match all.first() {
                None => return free("no torque of the scene acts on it alone"),
                Some(found) => found.clone(),
            },
        };
        let parameter = &scene.model.parameters[found.parameter];
        let says = format!("the speed is held by {}, {}", parameter.name, parameter.doc);
        Ok((Some(found), says))
    }

    /// Runs a point, again with a corrected parameter until its speed is held. `more` is the correction \[SI\], which is added to the
    /// scene's value of the parameter, and kept for the next point. Returns the run if it came to its end.
    fn settled(
        &self,
        at: &At<'_>,
        more: &mut f64,
        point: &mut ResponsePoint,
        watch: &mut dyn FnMut(f64),
    ) -> Result<Option<Trajectory>, Error> {
        let motion = at.motion;
        let mut shift = 0.0;
        for runs in 1.. {
            let mut scene = self.scene_at(at.text)?;
            let wanted = motion.stated(&scene);
            match at.before {
                Some((before, speed)) => {
                    let change = if motion.varied.is_some() || at.handle.is_some() { wanted - speed } else { 0.0 };
                    motion.go_on(&mut scene, before, change + shift);
                }
                None => motion.faster(&mut scene, shift),
            }
            if let Some(handle) = at.handle {
                handle.add(&mut scene, *more);
                point.hold = scene.parameters[handle.parameter];
            }
            let outcome = self.entry.run(&scene, watch);
            let Some(run) = point.judged(outcome) else { return Ok(None) };
            // The scene has just run, so its equations exist.
            let Ok(equations) = self.entry.equations(&scene) else { return Ok(None) };
            let span = Excitations::of(&scene, &*equations).span(&run, self.from);
            point.observe(&run, span);
            let factors = dynamic_factor::of(&scene, &self.entry, &run, span.begin);
            let of = |output: &Output| factors.iter().find(|factor| factor.force.name == output.name).cloned();
            point.factors = run.outputs.iter().map(|(output, _)| of(output)).collect();
            point.remarks = (scene.warnings.iter().cloned()).chain(remarks::of(&scene, &run, span.begin)).collect();
            if motion.unit.iter().all(|unit| *unit == 0.0) {
                return Ok(Some(run));
            }
            let speed = Speed::of(&scene, &*equations, motion, &run, &span);
            (point.speed, point.drift) = (speed.mean, speed.drift());
            let Some(handle) = at.handle.filter(|_| wanted != 0.0 && !speed.is_held(wanted)) else {
                return Ok(Some(run));
            };
            if runs == RUNS {
                if (speed.mean / wanted - 1.0).abs() > SPEED_NOT_HELD {
                    (point.status, point.reason) = (Status::Unheld, speed.unheld(wanted));
                }
                return Ok(Some(run));
            }
            // At rest the brake torque cannot be measured. It is measured while the train lost its speed.
            let braked = motion.until_lost(&run, wanted).filter(|_| speed.mean / wanted < HELD_PART);
            let speed = braked.map_or(speed, |span| Speed::of(&scene, &*equations, motion, &run, &span));
            let [parameter, start] = handle.step(&speed, wanted);
            *more += parameter;
            shift += start;
        }
        Ok(None)
    }

    /// The scene with the varied value as an override. Its events are recorded, so that extremes and means have no error from steps.
    fn scene_at(&self, text: &str) -> Result<Scene, Error> {
        let mut scene = self.template.scene(&[text.to_owned()], &[self.entry.model])?;
        scene.output.events = true;
        Ok(scene)
    }

    fn unit(&self) -> String {
        crate::scene::unit_of(&self.plan.axes[0].key, self.entry.model).unwrap_or_default()
    }
}

/// A key of a scene in words: the description of a parameter or a coordinate.
fn words(key: &str, model: &Model) -> String {
    let described = |name: &str, doc: &str| if doc.is_empty() { name.to_owned() } else { format!("{doc}, {name}") };
    match key.split_once('.') {
        Some(("parameters", name)) => {
            let doc = model.parameters.iter().find(|parameter| parameter.name == name).map_or("", |known| known.doc);
            described(name, doc)
        }
        Some(("start", name)) => match model.coordinates.iter().find(|coordinate| coordinate.name == name) {
            Some(coordinate) => format!("{} at the start", described(name, coordinate.doc)),
            None => name.replace('_', " "),
        },
        _ => key.to_owned(),
    }
}

#[test]
fn varied_keys_are_named_by_their_descriptions() {
    let model = crate::known::MODELS.iter().find(|entry| entry.model.name == "gear_pair").unwrap().model;
    assert_eq!(words("start.speed", model), "speed");
    assert_eq!(words("start.phi", model), format!("{}, phi at the start", model.coordinates[1].doc));
    assert!(words("parameters.T0", model).ends_with(", T0"), "{}", words("parameters.T0", model));
    assert_eq!(words("run.t_end", model), "run.t_end");
}

/// Where a point begins.
struct At<'a> {
    /// Its value, as an override.
    text: &'a str,
    motion: &'a UnitMotion,
    handle: Option<&'a Handle>,
    /// The point before it, and its mean speed.
    before: Option<&'a (Trajectory, f64)>,
}

impl ResponsePoint {
    /// A point that has not run.
    fn none(outputs: usize) -> ResponsePoint {
        ResponsePoint {
            upward: true,
            value: f64::NAN,
            speed: f64::NAN,
            drift: f64::NAN,
            hold: f64::NAN,
            span: None,
            observed: vec![None; outputs],
            factors: vec![None; outputs],
            status: Status::Done,
            reason: String::new(),
            remarks: vec![],
        }
    }

    /// The run if it came to its end; else the point says why not.
    fn judged(&mut self, outcome: Result<Outcome, impl std::fmt::Display>) -> Option<Trajectory> {
        let (status, reason) = match outcome {
            Err(refusal) => (Status::Refused, refusal.to_string()),
            Ok(Outcome { stopped_by: Some(stop), .. }) => (Status::Stopped, stop.to_string()),
            Ok(Outcome { refuted: Some(account), .. }) => (Status::Refuted, account.to_string()),
            Ok(outcome) => return Some(outcome.trajectory),
        };
        *self = ResponsePoint {
            upward: self.upward,
            value: self.value,
            status,
            reason,
            ..ResponsePoint::none(self.observed.len())
        };
        None
    }

    /// Takes the statistics of a run.
    fn observe(&mut self, run: &Trajectory, span: Span) {
        let of = |(_, x): &(_, Vec<f64>)| Statistics::between(&run.t, x, &run.moment, span.begin);
        (self.observed, self.span) = (run.outputs.iter().map(of).collect(), Some(span));
    }
}

impl ResponseCurve {
    /// The unit in which the varied value is shown to people, and the factor from the SI unit to it.
    pub fn shown_unit(&self) -> (&str, f64) {
        let largest = self.points.iter().map(|point| point.value.abs()).fold(0.0, f64::max);
        readable(&self.unit, largest)
    }

    /// The remarks of its points: for each finding the number of points, and the remark of the first one.
    pub fn remarks(&self) -> Vec<String> {
        remarks::counted("points", self.points.iter().map(|point| &point.remarks[..]))
    }

    /// The measures of an output.
    pub fn measures(&self, output: &Output) -> impl Iterator<Item = Measure> {
        MEASURES.into_iter().filter(|measure| (measure.is_of)(self.model, output))
    }

    /// The points as a table: `way`, the varied key, `mean_speed`, `speed_drift` over the measured time, the parameter that holds the
    /// speed, `measured_time`, `periods` and their kind (`period_of`), `status`, `reason`, `remarks`, and for each output the mean, the root
    /// mean square about the mean, and the peak-to-peak value; of the force of a mesh also its dynamic factor, K_v of ISO 6336-1, and how
    /// long and how hard the teeth pull.
    ///
    /// # Errors
    /// [`OutputError::Ragged`] never happens: all columns have one entry a point.
    pub fn table(&self) -> Result<Table, OutputError> {
        let mut table = Table::default();
        let numbers = |value: &dyn Fn(&ResponsePoint) -> f64| Values::Number(self.points.iter().map(value).collect());
        let texts = |text: &dyn Fn(&ResponsePoint) -> String| {
            Values::Text(self.points.iter().map(|point| text(point).into()).collect())
        };
        table.push("way", "", texts(&|point| if point.upward { "up".into() } else { "down".into() }))?;
        table.push(&self.key, &self.unit, numbers(&|point| point.value))?;
        table.push("mean_speed", "rad/s", numbers(&|point| point.speed))?;
        table.push("speed_drift", "1", numbers(&|point| point.drift))?;
        if let Some((name, unit)) = self.held {
            table.push(&format!("parameters.{name}"), unit, numbers(&|point| point.hold))?;
        }
        table.push("measured_time", "s", numbers(&|point| point.span.map_or(f64::NAN, |span| span.time())))?;
        table.push("periods", "", numbers(&|point| point.span.map_or(f64::NAN, |span| f64::from(span.periods))))?;
        table.push("period_of", "", texts(&|point| point.span.map_or_else(String::new, |span| span.of.into())))?;
        table.push("status", "", texts(&|point| point.status.name().into()))?;
        table.push("reason", "", texts(&|point| point.reason.clone()))?;
        table.push("remarks", "", texts(&|point| point.remarks.join(remarks::BETWEEN)))?;
        for (i, output) in self.outputs.iter().enumerate() {
            for measure in self.measures(output) {
                let name = format!("{}_{}", output.name, measure.name);
                table.push(&name, measure.unit(output), numbers(&|point| (measure.value)(point, i)))?;
            }
        }
        Ok(table)
    }
}
