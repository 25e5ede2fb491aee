//! Runs of scenes side by side.

use cpu_time::ThreadTime;

use crate::engine::error::Refusal;
use crate::engine::simulate::Simulation;
use crate::ensemble;
use crate::trajectory::Moment;

use super::{Outcome, Prepared, since};

/// Runs scenes with linear cells, constant torques and plain precision side by side, and records only their start and their end. Runs the
/// others one by one.
pub fn run(prepared: Vec<Result<Prepared<'_>, Refusal>>) -> Vec<Result<Outcome, Refusal>> {
    let fits = |simulation: &Simulation<'_>| simulation.cells().is_some() && simulation.now.forcing.is_none();
    let mut outcomes: Vec<Option<Result<Outcome, Refusal>>> = vec![None; prepared.len()];
    let (mut simulations, mut plans) = (vec![], vec![]);
    for (place, prepared) in prepared.into_iter().enumerate() {
        match prepared {
            Ok(Prepared { simulation, plan }) if fits(&simulation) => {
                let mut recorder = plan.recorder(&simulation);
                simulation.now.note(&mut recorder, Moment::Sample);
                simulations.push(simulation);
                plans.push((place, plan, recorder));
            }
            other => outcomes[place] = Some(other.map(|prepared| prepared.run(&mut |_| {}))),
        }
    }
    let begin = ThreadTime::now();
    let results = ensemble::run(&mut simulations);
    let each = since(begin) / simulations.len().max(1) as f64;
    for ((simulation, (place, plan, mut recorder)), result) in simulations.into_iter().zip(plans).zip(results) {
        simulation.now.note(&mut recorder, Moment::Sample);
        outcomes[place] = Some(Ok(plan.outcome(simulation, recorder, result.err(), each)));
    }
    outcomes.into_iter().flatten().collect()
}
