//! A scene at many values: sweeps and response curves.

use std::ops::ControlFlow;

use super::{Error, Job};
use crate::known;
use crate::output::Table;
use crate::scene::{Scene, Template};
use crate::sweep::response::{Hold, Response};
use crate::sweep::{Design, Request, Sweep};

impl Scene {
    /// Begins a sweep over an axis, written as for the option `--vary`: `start.speed=100 rpm:6000 rpm:200`,
    /// `parameters.zeta=0.02,0.05`, `parameters.T0=uniform:1 N*m:9 N*m`.
    pub fn vary(&self, axis: &str) -> Variation {
        let request = Request {
            vary: vec![axis.into()],
            overrides: self.overrides.clone(),
            record: vec!["events".into(), "extremes".into(), "energy".into()],
            ..Request::default()
        };
        Variation { scene: self.clone(), request, hold: Hold::Own }
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
        self.request.from = t;
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

    /// Runs the points on all cores: a table with one row a point. Its numbers do not depend on the number of cores. A point that
    /// cannot be run has a row that says why, in the columns `status` and `reason`.
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
    pub fn response(&self) -> Result<Response, Error> {
        self.response_watched(&mut |_| {})
    }

    /// The same; `watch` is called many times with the number of finished points.
    ///
    /// # Errors
    /// As [`Variation::response`].
    pub fn response_watched(&self, watch: &mut dyn FnMut(usize)) -> Result<Response, Error> {
        Ok(self.sweep()?.response(true, &self.hold, watch)?)
    }

    fn sweep(&self) -> Result<Sweep, Error> {
        let template = Template::again(&self.scene, &self.request.overrides)?;
        Ok(Sweep::of(template, known::models(), &self.request)?)
    }
}
