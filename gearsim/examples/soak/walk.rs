//! The run: a gear pair without damping whose motion never repeats, and its energy from time to time.

use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use gearsim::engine::equations;
use gearsim::engine::record::Recorder;
use gearsim::engine::simulate::Simulation;
use gearsim::generated::gear_pair::GearPair;
use gearsim::scene::{Precision, Scene};
use gearsim::trajectory::Moment;

/// Speed and pitch have no common measure, and at this torque a step takes or gives up to a twentieth of theta'^2: the
/// motion is chaotic, and no error meets itself again.
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

/// Samples of the energy over a run, evenly spaced but at its beginning.
const SAMPLES: u64 = 4096;
/// As many stretches of time without an event mean that the gear is caught for good.
const QUIET: u32 = 1000;

/// The energy error of a run at growing numbers of events.
pub struct Walk {
    /// Cell changes and reflections so far.
    pub events: Vec<u64>,
    /// T + V - W less its value at the start, over T + V at the start.
    pub error: Vec<f64>,
    /// Reflections among the events.
    pub reflections: u64,
    /// Model time [s].
    pub model_time: f64,
    /// What it took.
    pub elapsed: Duration,
}

impl Walk {
    /// Runs `events` events and hardly more, in a precision that scenes know by name.
    ///
    /// # Errors
    /// Where the engine stops, or events cease.
    pub fn run(events: u64, precision: &str) -> anyhow::Result<Walk> {
        let scene = scene(precision)?;
        let equations = equations::of::<GearPair, 2>(&scene)?;
        let begun = Instant::now();
        let mut simulation = Simulation::new(scene.model, &*equations, &scene)?;
        if scene.solver.precision == Precision::Compensated {
            gearsim::run::compensate::<GearPair, 2>(&mut simulation, &scene)?;
        }
        let (start, k) = (simulation.state, simulation.levels().to_vec());
        let mut recorder = Recorder::new(scene.model, &*equations, simulation.turn_lengths(), start, &k);
        let mut seconds_an_event = 1e-3;
        let mut walk = Walk { events: vec![], error: vec![], reflections: 0, model_time: 0.0, elapsed: Duration::ZERO };
        let (mut done, mut quiet) = (0, 0);
        while done < events {
            // Stretch by stretch, with a look at the energy after each.
            simulation.t_end += (done / 16).clamp(1, (events / SAMPLES).max(1)) as f64 * seconds_an_event;
            simulation.run(None, &mut |_| {}).with_context(|| format!("after {done} events"))?;
            let counts = &simulation.counts;
            let new = counts.events() - done;
            quiet = if new == 0 { quiet + 1 } else { 0 };
            if quiet > QUIET {
                bail!("after {done} events the gear meets no more steps");
            }
            if new > 0 {
                (done, walk.reflections) = (done + new, counts.reflections);
                seconds_an_event = simulation.t_end / done as f64;
                recorder.row(
                    simulation.t_end,
                    Moment::Sample,
                    &simulation.state,
                    simulation.levels(),
                    (0.0, simulation.ignored),
                );
                let residual = recorder.trajectory.residual.last().context("a row was written")?;
                walk.events.push(done);
                walk.error.push(residual / recorder.energy_at_start);
            }
        }
        Ok(Walk { model_time: simulation.t_end, elapsed: begun.elapsed(), ..walk })
    }
}

impl Walk {
    /// Events in all.
    pub fn total(&self) -> u64 {
        *self.events.last().unwrap_or(&0)
    }

    /// Indices of samples some ten percent of events apart.
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

/// The scene, its start and its numbers.
fn scene(precision: &str) -> anyhow::Result<Scene> {
    let model = gearsim::generated::MODELS.iter().map(|entry| entry.model).collect::<Vec<_>>();
    Scene::parse("soak", "the soak scene", SCENE, &[format!("run.precision={precision}")], &model)
        .map_err(|e| anyhow::anyhow!(e.render(100, false)))
}
