//! A whole run of a scene, from its equations to its account. Programs call [`Scene::run`](crate::Scene::run).

pub(crate) mod account;
mod rest;
mod together;

pub use account::Account;

pub use crate::engine::error::{Refusal, Stop};
pub use crate::engine::hybrid::Counts;

use std::time::Duration;

use cpu_time::ThreadTime;
use indexmap::IndexMap;
use xprec::Df64;

use crate::engine::cell::Cell;
use crate::engine::compensated::Given;
use crate::engine::equations::{Derived, DerivedModel, Equations};
use crate::engine::forcing::Forcing;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::Effort;
use crate::engine::record::{Recorder, State};
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::engine::switch::Switch;
use crate::engine::system::System;
use crate::engine::train::Elements;
use crate::methods::choice::{self, Choice};
use crate::methods::steps::BySteps;
use crate::model::Model;
use crate::scene::solver::Method;
use crate::scene::{Precision, Scene};
use crate::trajectory::{Moment, Trajectory};

/// The result of a run.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The recorded rows. The last one is the state at the end, or where the run had to stop.
    pub trajectory: Trajectory,
    /// T + V at the start \[J\].
    pub energy_at_start: f64,
    /// Energy of neglected bounces \[J\], counted in the residual.
    pub ignored: f64,
    /// Events and costs.
    pub counts: Counts,
    /// For each switch of the scene, by its name: the time spent in each of its modes \[s\].
    pub modes: Vec<(&'static str, Vec<(&'static str, f64)>)>,
    /// Impacts of each kind, by what the modes of the scene's switches count, e.g. "flanks met".
    pub impacts: Vec<(&'static str, u64)>,
    /// How it was solved.
    pub solver: Solver,
    /// Why the run ended before its time, if it did.
    pub stopped_by: Option<Stop>,
    /// Damped angular frequency of the lowest elastic mode at the mid stiffness [rad/s].
    pub reference_frequency: Option<f64>,
    /// Processor time that the simulation took, with its recording \[s\].
    pub cpu_seconds: f64,
    /// The energy account, if it refutes the result.
    pub refuted: Option<Account>,
    /// How many digits of the result are left, where that was estimated.
    pub digits: Option<Digits>,
    /// Remarks for the reader of the result, a sentence each.
    pub remarks: Vec<String>,
}

/// How many digits of a result are left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Digits {
    /// Digits of the least accurate coordinate or speed at the end: 0 to 16.
    pub at_end: f64,
    /// Time from which on none are left \[s\]; `None` where some are.
    pub none_from: Option<f64>,
}

/// How a run was solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Solver {
    /// The method, by its name in scenes; the one that took over, if one did.
    pub method: &'static str,
    /// Why it was this one.
    pub why: String,
    /// Steps of a numerical method; 0 for the exact one.
    pub steps: u64,
    /// Steps that were rejected.
    pub rejected: u64,
}

/// How a scene would be run.
#[derive(Debug, Clone, PartialEq)]
pub struct Prospect {
    /// The method, by its name in scenes.
    pub method: &'static str,
    /// Why it is this one.
    pub why: String,
    /// Coordinates at the start \[SI\] (n).
    pub q: Vec<f64>,
    /// Speeds at the start \[SI\] (n).
    pub q_dot: Vec<f64>,
}

/// A model as the program knows it: its description, and how to run a scene of it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The description of the model.
    pub model: &'static Model,
    derived: DerivedModel,
}

impl Entry {
    /// The entry of a derived model: `D` is a type that [`equations!`](crate::equations) defines.
    pub const fn new<D: Derived>() -> Entry {
        Entry { model: &D::MODEL, derived: DerivedModel::of::<D>() }
    }

    /// The entry of trains, whose parts a scene lists. `elements` are the elements of `model`, in its order.
    pub(crate) const fn train(model: &'static Model, elements: &'static Elements) -> Entry {
        Entry { model, derived: DerivedModel { model, source: elements } }
    }

    /// The entry with the description of a scene's model: that of a train has its parts.
    pub(crate) fn described(self, model: &'static Model) -> Entry {
        Entry { model, ..self }
    }

    /// Runs a scene, telling the model time \[s\] to `watch` as it goes.
    ///
    /// # Errors
    /// Where the scene cannot be run.
    pub fn run(&self, scene: &Scene, watch: &mut dyn FnMut(f64)) -> Result<Outcome, Refusal> {
        let equations = self.equations(scene)?;
        Ok(Prepared::new(&self.derived, scene, &*equations)?.run(watch))
    }

    /// How a scene would be run, and from where; it is not run.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    pub fn check(&self, scene: &Scene) -> Result<Prospect, Refusal> {
        let equations = self.equations(scene)?;
        let Prepared { simulation, plan } = Prepared::new(&self.derived, scene, &*equations)?;
        let (method, why) = (plan.choice.method.name(), plan.choice.why);
        Ok(Prospect { method, why, q: simulation.now.state.q.to_vec(), q_dot: simulation.now.state.q_dot.to_vec() })
    }

    /// Runs scenes side by side; of those with linear cells and constant torques, the start and the end are recorded
    /// and nothing between.
    ///
    /// # Errors
    /// For each, those of [`Entry::run`].
    pub fn ends(&self, scenes: &[Scene]) -> Vec<Result<Outcome, Refusal>> {
        let equations: Vec<_> = scenes.iter().map(|scene| self.equations(scene)).collect();
        let prepared = scenes.iter().zip(&equations).map(|(scene, equations)| match equations {
            Ok(equations) => Prepared::new(&self.derived, scene, &**equations),
            Err(refusal) => Err(refusal.clone()),
        });
        together::run(prepared.collect())
    }

    /// The equations of a scene, for analyses.
    ///
    /// # Errors
    /// Those of [`System::of`].
    pub(crate) fn system(&self, scene: &Scene) -> Result<System, Refusal> {
        System::of(&self.derived, scene)
    }

    /// The equations of a scene about its steady motion.
    ///
    /// # Errors
    /// Those of [`System::about_steady_motion`].
    pub(crate) fn about_steady_motion(&self, scene: &Scene) -> Result<System, Refusal> {
        System::about_steady_motion(&self.derived, scene)
    }

    /// The linear part of the equations of a scene.
    ///
    /// # Errors
    /// Those of [`System::linear_part`].
    pub(crate) fn linear_part(&self, scene: &Scene) -> Result<System, Refusal> {
        System::linear_part(&self.derived, scene)
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// Where its effects contradict one another.
    pub(crate) fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        self.derived.equations(scene)
    }

    /// A simulation of `scene` as [`Entry::run`] runs it, for programs that ask for its states; `equations` are those of the scene.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    pub(crate) fn simulation<'a>(
        &self,
        scene: &'a Scene,
        equations: &'a dyn Equations,
    ) -> Result<Simulation<'a>, Refusal> {
        Ok(Prepared::new(&self.derived, scene, equations)?.simulation)
    }

    /// A simulation of `scene` with state and time in double-double precision.
    ///
    /// # Errors
    /// If its cells cannot be solved in double-double precision.
    pub(crate) fn compensate<'a>(
        &self,
        simulation: Simulation<'a>,
        scene: &'a Scene,
    ) -> Result<Simulation<'a>, Refusal> {
        compensate(&self.derived, simulation, scene)
    }
}

fn compensate<'a>(
    derived: &DerivedModel,
    simulation: Simulation<'a>,
    scene: &'a Scene,
) -> Result<Simulation<'a>, Refusal> {
    let parameters: Vec<Df64> = scene.parameters.iter().copied().map(Df64::from).collect();
    let mids: Vec<Df64> = scene.laws.iter().map(|law| law.exact_mid()).collect();
    let k: Vec<Df64> = simulation.now.k.iter().copied().map(Df64::from).collect();
    let load = |parameters| derived.source.exactly(scene, parameters, mids.clone()).matrices(&k).load;
    let varies = scene.model.parameters.iter().map(|p| p.varies);
    let bare: Vec<Df64> = parameters.iter().zip(varies).map(|(x, v)| if v { Df64::from(0.0) } else { *x }).collect();
    // The forces are linear in a torque: subtract those at 0 from those at 1.
    let of_unit = |p: usize| {
        let mut unit = bare.clone();
        unit[p] = Df64::from(1.0);
        load(unit) - load(bare.clone())
    };
    let loads = simulation.now.forcing.iter().flat_map(|forcing| forcing.parameters()).map(of_unit).collect();
    let cells = derived.source.exactly(scene, parameters, mids.clone());
    simulation.compensate(Given { cells, loads })
}

/// A scene that is ready to be run.
struct Prepared<'a> {
    simulation: Simulation<'a>,
    plan: Plan<'a>,
}

/// Said of a run that does not use the tolerance of its scene.
const UNUSED_TOLERANCE: &str = "run.tolerance is not used: every cell is linear, and the exact method has no tolerance";

/// What is run, and how.
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
        // A constant M is checked with the first cell.
        if !equations.is_inertia_constant() && equations.mass(q).cholesky().is_none() {
            return Err(Refusal::Mass);
        }
        let choice = choice::of(scene, &begun.laws)?;
        let unused =
            (choice.method == Method::Exact && scene.solver.states_tolerance).then(|| UNUSED_TOLERANCE.to_string());
        let remarks = begun.others.iter().cloned().chain(unused).collect();
        let forcing = Forcing::of(derived, scene);
        let compensated = scene.solver.precision == Precision::Compensated;
        let simulation = match choice::numerical(&choice, scene) {
            None if compensated => compensate(derived, Simulation::exact(equations, scene, begun, forcing)?, scene),
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

    /// Runs it to the end, or to where it must stop.
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
    /// A recorder of a run from the present state of its simulation.
    fn recorder(&self, simulation: &Simulation<'a>) -> Recorder<'a> {
        let (now, lengths) = (&simulation.now, simulation.turn_lengths());
        let mut recorder = Recorder::new(self.scene, now.equations, lengths, now.state.clone(), &now.k);
        recorder.most_rows = self.scene.output.most_rows;
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

/// The name of a switch, and the time that it spent in each of its modes \[s\].
fn times(scene: &Scene, switch: &Switch) -> (&'static str, Vec<(&'static str, f64)>) {
    let spent = switch.spent().map(|(mode, time)| (mode.name, time));
    (scene.model.switches[switch.index].name, spent.collect())
}

/// The impacts of each kind, in the order of the switches.
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
    let mids: Vec<f64> = scene.laws.iter().map(|l| l.mid()).collect();
    let cell = Cell::new(equations, &scene.model.in_contact(mids)).ok()?;
    cell.modes.iter().map(|m| m.damped_frequency()).find(|w| *w > 0.0)
}
