//! A scene at many values: sweeps and response curves.

use std::ops::ControlFlow;

use super::{Error, Job, Value};
use crate::known;
use crate::output::Table;
use crate::scene::{Scene, Template};
use crate::sweep::response::{Hold, ResponseCurve};
use crate::sweep::{Design, Request, Sweep};

impl Scene {
    /// Begins a sweep over an axis, written as for the option `--vary`: `start.speed=100 rpm:6000 rpm:200`,
    /// `parameters.zeta=0.02,0.05`, `parameters.T0=uniform:1 N*m:9 N*m`. The values of the axis replace a value of the same key that was
    /// set in code ([`Scene::with`]).
    pub fn vary(&self, axis: &str) -> Variation {
        let request = Request {
            vary: vec![axis.into()],
            overrides: self.overrides.clone(),
            record: vec!["events".into(), "extremes".into(), "energy".into()],
            ..Request::default()
        };
        Variation { scene: self.clone(), request, hold: Hold::Own }
    }

    /// The axis of a list of values, for [`Scene::vary`]: numbers \[SI\], and texts with units.
    ///
    /// ```
    /// use gearsim::{Scene, Value};
    ///
    /// let scene = Scene::of_model("chain_2").set("parameters.I1", 0.5).set("parameters.I2", 0.25);
    /// let scene = scene.set("parameters.k1", 1e4).set("run.t_end", "0.1 s").build()?;
    /// let axis = scene.axis("parameters.k1", &[Value::from(0.1), Value::from("2 kN*m/rad")]);
    /// assert_eq!(axis, "parameters.k1=0.1 N*m/rad,2 kN*m/rad");
    /// # Ok::<(), gearsim::Error>(())
    /// ```
    pub fn axis(&self, key: &str, values: &[Value]) -> String {
        let values: Vec<String> = values.iter().map(|value| value.listed(key, self.model)).collect();
        format!("{key}={}", values.join(","))
    }
}

/// A sweep that is being defined. See [`Scene::vary`].
#[derive(Debug, Clone)]
#[must_use = "a sweep runs by `run`"]
pub struct Variation {
    scene: Scene,
    request: Request,
    hold: Hold,
}

impl Variation {
    /// A further axis; the points are all combinations.
    pub fn vary(mut self, axis: &str) -> Self {
        self.request.vary.push(axis.into());
        self
    }

    /// The groups of quantities to record, e.g. `outputs`; without it, `events`, `extremes` and `energy`.
    pub fn record(mut self, groups: &[&str]) -> Self {
        self.request.record = groups.iter().map(|group| group.to_string()).collect();
        self
    }

    /// Start of the time span over which extremes and means are taken \[s\]; without it, 0.
    pub fn from(mut self, t: f64) -> Self {
        self.request.from = Some(t);
        self
    }

    /// What holds the speed of a response curve; without it, [`Hold::Own`].
    pub fn hold(mut self, hold: Hold) -> Self {
        self.hold = hold;
        self
    }

    /// Number of samples per grid point, and their seed. Needed if an axis is random.
    pub fn samples(mut self, samples: usize, seed: u64) -> Self {
        (self.request.samples, self.request.seed) = (Some(samples), seed);
        self
    }

    /// How the samples are chosen; without it, independently.
    pub fn design(mut self, design: Design) -> Self {
        self.request.design = design;
        self
    }

    /// Runs the points on all cores, and returns a table with one row per point. Its numbers do not depend on the number of cores. A
    /// point that cannot be run has a row that says why, in the columns `status` and `reason`. The column `remarks` has
    /// what a reader of a row must know.
    ///
    /// # Errors
    /// All mistakes in the axes and the request. No point has run then.
    pub fn run(&self) -> Result<Table, Error> {
        let job = self.job()?;
        job.table(&job.run(0..job.points(), None, |_| ControlFlow::Continue(()))?)
    }

    /// The checked sweep, whose points can be run in parts, on other machines too.
    ///
    /// # Errors
    /// As [`Variation::run`].
    pub fn job(&self) -> Result<Job, Error> {
        Job::new(self.sweep()?, &self.request)
    }

    /// The response curve over the only axis: every point starts from the settled state before it, upward, then downward. Statistics
    /// are taken over the last whole periods of the slowest excitation between [`Variation::from`] and the end of each point's run.
    ///
    /// # Errors
    /// If there is more than one axis, its values do not rise, the scene records no output, or [`Variation::hold`] names a parameter that
    /// cannot hold the speed.
    pub fn response(&self) -> Result<ResponseCurve, Error> {
        self.response_watched(&mut |_| {})
    }

    /// As [`Variation::response`]; `watch` is called many times with the number of finished points.
    ///
    /// # Errors
    /// As [`Variation::response`].
    pub fn response_watched(&self, watch: &mut dyn FnMut(usize)) -> Result<ResponseCurve, Error> {
        Ok(self.sweep()?.response(true, &self.hold, watch)?)
    }

    fn sweep(&self) -> Result<Sweep, Error> {
        let template = Template::again(&self.scene, &self.request.overrides)?;
        Ok(Sweep::of(template, known::models(), &self.request)?)
    }
}

#[cfg(test)]
mod tests {
    use crate::Scene;

    fn struck() -> Scene {
        let scene = Scene::of_model("chain_2").set("parameters.I1", 0.5).set("parameters.I2", 0.25);
        let scene = scene.set("parameters.k1", "10 kN*m/rad").set("start.theta1_dot", 1.0).set("run.t_end", "10 ms");
        scene.build().unwrap()
    }

    /// The values of an axis replace a value that was set in code. The result of each point is that of a scene with the value of the axis.
    #[test]
    fn an_axis_wins_over_a_value_that_was_set() {
        let scene = struck().with("parameters.k1", "12 kN*m/rad").unwrap();
        let table = scene.vary("parameters.k1=20 kN*m/rad,40 kN*m/rad").record(&["state"]).run().unwrap();
        assert_eq!(table.numbers("parameters.k1").unwrap(), [2e4, 4e4]);
        for (i, k) in [2e4, 4e4].into_iter().enumerate() {
            let run = struck().with("parameters.k1", k).unwrap().run().unwrap();
            let end = *run.trajectory().q_dot[0].last().unwrap();
            assert!((table.numbers("theta1_dot").unwrap()[i] / end - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_axis_of_a_response_wins_over_a_value_that_was_set() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/response.toml");
        let scene = Scene::load(path).unwrap().with("start.speed", "4000 rpm").unwrap();
        let response = scene.vary("start.speed=5000 rpm,5100 rpm").from(0.05).response().unwrap();
        let rpm = std::f64::consts::TAU / 60.0;
        let expected = [5000.0, 5100.0, 5100.0, 5000.0].map(|speed| speed * rpm);
        assert!(response.points.iter().zip(expected).all(|(point, value)| (point.value / value - 1.0).abs() < 1e-14));
    }
}
