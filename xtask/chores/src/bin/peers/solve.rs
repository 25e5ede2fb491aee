//! Our own runs: the engine through its library, repeated in one process and without files, and the hand-written solvers.

use std::hint::black_box;
use std::time::Duration;

use anyhow::{Context, bail};
use cpu_time::ProcessTime;
use gearsim::__private::equations::DerivedModel;
use gearsim::__private::models::GearPair;
use gearsim::__private::{Simulation, ensemble};
use gearsim::run::Entry;
use gearsim::scene::Scene;
use gearsim::trajectory::Moment;
use serde_json::{Value, json};

use crate::case::{self, Case};
use crate::reference::word;

/// Number of times measured; the same as in tests/peers/clock.py.
const SAMPLES: usize = 5;
/// Each time is the mean of runs repeated for so long, because the clock of processor time may advance in ticks of 4 ms.
const SAMPLE: Duration = Duration::from_millis(200);

/// Runs a method on a scene: its events, the state at the end and processor times [s], as JSON.
///
/// # Errors
/// If the scene is not valid, the run stops before its end, or the method is unknown.
pub fn run(method: &str, case: &Case, quick: bool) -> anyhow::Result<Value> {
    let scene = case.scene(quick)?;
    let pair = case::pair(&scene);
    let (s, t_end) = (case::start(&scene, &pair), scene.t_end);
    match method {
        "gearsim" => engine(&scene),
        "hand-written" => {
            let run = pair.solve(s.theta, s.theta_dot, s.phi, s.phi_dot, t_end);
            let events: Vec<_> = run.events.iter().map(|e| json!([e.t, word(e.kind), e.cell_to])).collect();
            let end = [run.end_local, run.end.theta_dot, run.end.phi, run.end.phi_dot];
            let cpu = times(|| drop(black_box(pair.solve(black_box(s.theta), s.theta_dot, s.phi, s.phi_dot, t_end))));
            Ok(json!({ "prepare": 0.0, "cpu": cpu, "events": events, "cell": run.end_cell, "end": end }))
        }
        "hand-written, fast" => {
            let solve = || pair.solve_fast(black_box(s.theta), s.theta_dot, s.phi, s.phi_dot, t_end);
            let run = solve();
            let end = [run.end_local, run.end.theta_dot, run.end.phi, run.end.phi_dot];
            let cpu = times(|| {
                black_box(solve());
            });
            // It does not record events, only their number.
            let count = run.cell_changes + run.reflections;
            Ok(json!({ "prepare": 0.0, "cpu": cpu, "count": count, "cell": run.end_cell, "end": end }))
        }
        _ => bail!("there is no method `{method}`; the methods are: gearsim; hand-written; hand-written, fast"),
    }
}

/// The engine with its guaranteed crossings and its energy account. The time of a run includes computing the cells and the start.
fn engine(scene: &Scene) -> anyhow::Result<Value> {
    let begun = ProcessTime::now();
    let equations = DerivedModel::of::<GearPair>().equations(scene)?;
    let prepare = begun.elapsed().as_secs_f64();
    let solve = || -> anyhow::Result<_> {
        let mut alone = [Simulation::new(&*equations, black_box(scene))?];
        ensemble::run(&mut alone).into_iter().collect::<Result<(), _>>()?;
        let [simulation] = alone;
        Ok((simulation.now.state, simulation.now.laws[0].cell, simulation.now.laws[0].bounds().0))
    };
    let (state, cell, below) = solve()?;
    let cpu = times(|| {
        let _ = black_box(solve());
    });
    let cell = 2 * state.turns[0] + i64::try_from(cell).context("two cells a pitch")?;
    let end = [state.q[0] - below, state.q_dot[0], state.q[1], state.q_dot[1]];
    let events = events(scene)?;
    Ok(json!({ "prepare": prepare, "cpu": cpu, "events": events, "cell": cell, "end": end }))
}

/// The events of the engine's run, from the recorded states just before and just after each.
fn events(scene: &Scene) -> anyhow::Result<Vec<Value>> {
    let run = Entry::new::<GearPair>().run(scene, &mut |_| {})?;
    let (t, mut cell) = (run.trajectory, 0);
    let befores = (0..t.len()).filter(|&i| t.moment[i] == Moment::Before);
    Ok(befores
        .map(|i| {
            let (before, after) = (t.q_dot[0][i], t.q_dot[0][i + 1]);
            let reflected = before * after < 0.0;
            if !reflected {
                cell += if before > 0.0 { 1 } else { -1 };
            }
            json!([t.t[i], if reflected { "reflect" } else { "transmit" }, cell])
        })
        .collect())
}

/// Processor times of a run [s].
fn times(solve: impl Fn()) -> Vec<f64> {
    let sample = |_| {
        let (begun, mut runs) = (ProcessTime::now(), 0.0);
        let mut took = Duration::ZERO;
        while took < SAMPLE {
            solve();
            (runs, took) = (runs + 1.0, begun.elapsed());
        }
        took.as_secs_f64() / runs
    };
    (0..SAMPLES).map(sample).collect()
}
