//! A whole run of a scene, from its equations to its energy account. Programs call [`Scene::run`](crate::Scene::run).

pub(crate) mod account;
mod compensated;
mod entry;
mod outcome;
mod rest;
mod together;

pub use account::Account;
pub use entry::Entry;
pub use outcome::{Digits, Outcome, Prospect, Solver};

pub use crate::engine::error::{Refusal, Stop};
pub use crate::engine::hybrid::Counts;

use std::time::{Duration, Instant};

use cpu_time::ThreadTime;
use indexmap::IndexMap;

use crate::engine::cell::Cell;
use crate::engine::equations::{DerivedModel, Equations};
use crate::engine::forcing::Forcing;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::Effort;
use crate::engine::record::{Recorder, State};
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::engine::switch::Switch;
use crate::methods::choice::{self, Choice};
use crate::methods::steps::BySteps;
use crate::scene::solver::Method;
use crate::scene::{Precision, Scene};
use crate::trajectory::Moment;

/// A scene that is ready to be run.
struct Prepared<'a> {
    simulation: Simulation<'a>,
    plan: Plan<'a>,
}

/// The remark on a run that does not use the tolerance of its scene.
const UNUSED_TOLERANCE: &str = "run.tolerance is not used: every cell is linear, and the exact method has no tolerance";

/// The scene of a run, the choice of its method, and remarks.
struct Plan<'a> {
    scene: &'a Scene,
    choice: Choice,
    /// Remarks for the reader of the result, a sentence each.
    remarks: Vec<String>,
}

impl<'a> Prepared<'a> {
    fn new(derived: &DerivedModel, scene: &'a Scene, equations: &'a dyn Equations) -> Result<Self, Refusal> {
        if scene.t_end.is_infinite() {
            return Err(Refusal::NoRun);
        }
        let begun = start::begin(equations, scene)?;
        let State { q, q_dot, .. } = &begun.state;
        if !equations.kinetic(q, q_dot).is_finite() {
            return Err(Refusal::StartOverflow);
        }
        // A constant M is checked when the first cell is computed.
        if !equations.is_inertia_constant() && equations.mass(q).cholesky().is_none() {
            return Err(Refusal::Mass);
        }
        let choice = choice::of(scene, &begun.laws)?;
        let unused =
            (choice.method == Method::Exact && scene.solver.states_tolerance).then(|| UNUSED_TOLERANCE.to_string());
        let remarks = unused.into_iter().collect();
        let forcing = Forcing::of(derived, scene);
        let compensated = scene.solver.precision == Precision::Compensated;
        let simulation = match choice::numerical(&choice, scene) {
            None if compensated => {
                compensated::compensate(derived, Simulation::exact(equations, scene, begun, forcing)?, scene)
            }
            None => Simulation::exact(equations, scene, begun, forcing),
            Some(_) if compensated => Err(Refusal::CompensatedNumerical(choice.why.clone())),
            Some((method, settings)) => {
                let now = Hybrid::new(equations, scene, begun, forcing);
                let solver = BySteps::new(&now, method, settings);
                Simulation::with(now, Box::new(solver))
            }
        }?;
        Ok(Prepared { simulation, plan: Plan { scene, choice, remarks } })
    }

    /// Runs the scene to its end, or until it must stop. `watch` gets the model time \[s\] as the run proceeds.
    fn run(self, watch: &mut dyn FnMut(f64)) -> Outcome {
        let Prepared { mut simulation, plan } = self;
        let mut recorder = plan.recorder(&simulation);
        let begin = ThreadTime::now();
        let output = &plan.scene.output;
        let stopped_by = simulation.run(Some((&mut recorder, output.rate, output.events)), watch).err();
        let cpu_seconds = since(begin);
        if stopped_by.is_some() {
            simulation.now.note(&mut recorder, Moment::Sample);
        }
        plan.outcome(simulation, recorder, stopped_by, cpu_seconds)
    }
}

impl<'a> Plan<'a> {
    /// A recorder whose account begins at the present state of the simulation.
    fn recorder(&self, simulation: &Simulation<'a>) -> Recorder<'a> {
        let (now, lengths) = (&simulation.now, simulation.turn_lengths());
        let mut recorder = Recorder::new(self.scene, now.equations, lengths, now.state.clone(), &now.k);
        recorder.most_rows = self.scene.output.most_rows;
        recorder.until = self.scene.output.most_time.map(|time| Instant::now() + time);
        recorder
    }

    /// The result of the simulation.
    fn outcome(
        self,
        mut simulation: Simulation<'_>,
        recorder: Recorder<'_>,
        stopped_by: Option<Stop>,
        cpu_seconds: f64,
    ) -> Outcome {
        let Plan { scene, choice, remarks } = self;
        let Effort { steps, rejected, replaced } = simulation.effort();
        let first = choice.method.name();
        let (method, why) = match replaced {
            Some((t, method)) => {
                (method, format!("{}; {first} until t = {t} s, where the cell proved stiff for it", choice.why))
            }
            None => (first, choice.why),
        };
        let now = simulation.now.clock.now();
        simulation.now.switches.iter_mut().for_each(|switch| switch.spend(now));
        let closes = account::closes(&simulation.now.laws);
        let contact = scene.model.in_contact(simulation.now.laws.iter().map(|law| law.level()));
        let rounding = account::rounding(&simulation.now, &contact);
        let mut outcome = Outcome {
            energy_at_start: recorder.energy_at_start,
            trajectory: recorder.trajectory,
            ignored: simulation.now.ignored,
            solver: Solver { method, why, steps, rejected },
            stopped_by,
            reference_frequency: reference_frequency(scene, simulation.now.equations),
            cpu_seconds,
            refuted: None,
            digits: None,
            remarks,
            counts: simulation.now.counts,
            modes: simulation.now.switches.iter().map(|switch| times(scene, switch)).collect(),
            impacts: impacts(&simulation.now.switches),
        };
        outcome.refuted = Account::of(&outcome, scene, rounding).filter(|account| closes && account.refutes());
        outcome
    }
}

/// The name of a switch; and for each of its modes the name and the time spent in it \[s\].
fn times(scene: &Scene, switch: &Switch) -> (&'static str, Vec<(&'static str, f64)>) {
    let spent = switch.spent().map(|(mode, time)| (mode.name, time));
    (scene.model.switches[switch.index].name, spent.collect())
}

/// The number of impacts of each kind, in the order of the switches.
fn impacts(switches: &[Switch]) -> Vec<(&'static str, u64)> {
    let mut kinds = IndexMap::new();
    for (kind, impacts) in switches.iter().flat_map(Switch::impacts) {
        *kinds.entry(kind).or_insert(0) += impacts;
    }
    kinds.into_iter().collect()
}

/// Processor time of this thread since `begin` [s], never 0.
fn since(begin: ThreadTime) -> f64 {
    begin.elapsed().max(Duration::from_nanos(1)).as_secs_f64()
}

/// Damped angular frequency of the lowest elastic mode at the mid stiffness [rad/s], where the cells are linear.
fn reference_frequency(scene: &Scene, equations: &dyn Equations) -> Option<f64> {
    if !scene.effects.nonlinear(scene.model).is_empty() {
        return None;
    }
    let cell = Cell::new(equations, &scene.model.in_contact(scene.mids())).ok()?;
    cell.modes.iter().map(|m| m.damped_frequency()).find(|w| *w > 0.0)
}
