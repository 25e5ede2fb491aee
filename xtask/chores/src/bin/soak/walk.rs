//! The run: a gear pair without damping in aperiodic motion, with its energy error at intervals.

use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use gearsim::__private::equations::DerivedModel;
use gearsim::__private::models::GearPair;
use gearsim::__private::{Inside, Recorder, Simulation};
use gearsim::run::Entry;
use gearsim::scene::{Precision, Scene};
use gearsim::trajectory::Moment;

/// At this torque a step of the stiffness changes theta'^2 by up to a twentieth. The motion is chaotic, so that rounding errors
/// do not repeat periodically.
const SCENE: &str = r#"
model = "gear_pair"
effects = ["stiffness_step", "torques"]
[parameters]
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
T0 = "40 N*m"
[laws.k]
steps = [{ value = "1.43 kN*m", width = "1.73 rad" }, { value = "2.78 kN*m" }]
[start]
theta_dot = "1597.1618033988749 rad/s"
theta = "0.5772156649015329 rad"
[run]
t_end = "1 s"
"#;

/// Number of samples of the energy in a run, evenly spaced except at its beginning.
const SAMPLES: u64 = 4096;
/// Number of intervals without an event after which the gear is considered to be trapped between two steps.
const QUIET: u32 = 1000;

/// The energy error of a run after increasing numbers of events.
pub struct Walk {
    /// Number of events, cell changes and reflections, up to each sample.
    pub events: Vec<u64>,
    /// T + V - W minus its value at the start, relative to T + V at the start.
    pub error: Vec<f64>,
    /// Number of reflections among the events.
    pub reflections: u64,
    /// Model time [s].
    pub model_time: f64,
    /// Elapsed time.
    pub elapsed: Duration,
}

impl Walk {
    /// Runs until there were `events` events, with the `precision` of a scene file.
    ///
    /// # Errors
    /// If the engine stops, or if no more events occur.
    pub fn run(events: u64, precision: &str) -> anyhow::Result<Walk> {
        let scene = scene(precision)?;
        let equations = DerivedModel::of::<GearPair>().equations(&scene)?;
        let begun = Instant::now();
        let mut simulation = Simulation::new(&*equations, &scene)?;
        if scene.solver.precision == Precision::Compensated {
            simulation = Entry::new::<GearPair>().compensate(simulation, &scene)?;
        }
        let (start, k) = (simulation.now.state.clone(), simulation.now.k[..].to_vec());
        let mut recorder = Recorder::new(&scene, &*equations, simulation.turn_lengths(), start, &k);
        let mut seconds_an_event = 1e-3;
        let mut walk = Walk { events: vec![], error: vec![], reflections: 0, model_time: 0.0, elapsed: Duration::ZERO };
        let (mut done, mut quiet) = (0, 0);
        while done < events {
            // One interval after another; the energy is recorded at the end of each in which there was an event.
            simulation.now.t_end += (done / 16).clamp(1, (events / SAMPLES).max(1)) as f64 * seconds_an_event;
            simulation.run(None, &mut |_| {}).with_context(|| format!("after {done} events"))?;
            let counts = &simulation.now.counts;
            let new = counts.events() - done;
            quiet = if new == 0 { quiet + 1 } else { 0 };
            if quiet > QUIET {
                bail!("after {done} events the gear reaches no more steps of its stiffness");
            }
            if new > 0 {
                (done, walk.reflections) = (done + new, counts.reflections);
                seconds_an_event = simulation.now.t_end / done as f64;
                let now = &simulation.now;
                recorder.row(now, (now.t_end, Moment::Sample), &now.state, &now.k, (0.0, now.ignored));
                let residual = recorder.trajectory.residual.last().context("a row was written")?;
                walk.events.push(done);
                walk.error.push(residual / recorder.energy_at_start);
            }
        }
        Ok(Walk { model_time: simulation.now.t_end, elapsed: begun.elapsed(), ..walk })
    }
}

impl Walk {
    /// Number of events of the whole run.
    pub fn total(&self) -> u64 {
        *self.events.last().unwrap_or(&0)
    }

    /// Indices of samples, each with about ten percent more events than the one before.
    pub fn spread(&self) -> impl Iterator<Item = usize> + '_ {
        let mut next = 0.0;
        (0..self.events.len()).filter(move |i| {
            let n = self.events[*i] as f64;
            let taken = n >= next;
            next = if taken { 1.1 * n } else { next };
            taken
        })
    }
}

/// The scene with the given precision.
fn scene(precision: &str) -> anyhow::Result<Scene> {
    let model = gearsim::models().iter().map(|entry| entry.model).collect::<Vec<_>>();
    Scene::parse("soak", "the soak scene", SCENE, &[format!("run.precision={precision}")], &model)
        .map_err(|e| anyhow::anyhow!(e.render(100, false)))
}
