//! A whole run of a scene, from its equations to its account.

pub mod account;

pub use account::Account;

use std::time::Duration;

use cpu_time::ThreadTime;
use xprec::Df64;

use crate::engine::cell::Cell;
use crate::engine::equations::{Derived, DerivedModel, Equations};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::record::Recorder;
use crate::engine::simulate::{Counts, Simulation};
use crate::engine::start::{self, Begun};
use crate::engine::system::System;
use crate::ensemble;
use crate::methods;
use crate::methods::advance::{Advance, Settings};
use crate::methods::choice::{self, Choice};
use crate::model::Model;
use crate::scene::{Precision, Scene};
use crate::trajectory::{Moment, Trajectory};

/// What a run came to.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Everything recorded; its last row is the state at the end, or where the run had to stop.
    pub trajectory: Trajectory,
    /// T + V at the start [J].
    pub energy_at_start: f64,
    /// Energy of bounces that were not followed to their ends [J], counted in the residual.
    pub ignored: f64,
    /// Events and costs.
    pub counts: Counts,
    /// How it was solved.
    pub solver: Solver,
    /// Why the run ended before its time, if it did.
    pub stopped_by: Option<Stop>,
    /// Damped angular frequency of the lowest elastic mode at the mid stiffness [rad/s].
    pub reference_frequency: Option<f64>,
    /// Processor time that the simulation took, with its recording [s].
    pub cpu_seconds: f64,
    /// The energy account, where it refutes the result.
    pub refuted: Option<Account>,
    /// How many digits of the result are left, where that was estimated.
    pub digits: Option<Digits>,
    /// What a reader of the result has to know beside it, a sentence each.
    pub remarks: Vec<String>,
}

/// How many digits of a result are left ([`crate::analysis::digits`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Digits {
    /// Of the state at the end, its worst coordinate or speed: 0 to 16.
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
    /// Steps that it tried in vain.
    pub rejected: u64,
}

/// A model as the program knows it: its description, and how to run a scene of it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// What scenes and people read.
    pub model: &'static Model,
    derived: DerivedModel,
}

impl Entry {
    /// The entry of a derived model.
    pub const fn new<D: Derived>() -> Entry {
        Entry { model: &D::MODEL, derived: DerivedModel::of::<D>() }
    }

    /// Runs a scene, telling the model time [s] to `watch` as it goes.
    ///
    /// # Errors
    /// Where the scene cannot be run.
    pub fn run(&self, scene: &Scene, watch: &mut dyn FnMut(f64)) -> Result<Outcome, Refusal> {
        run(&self.derived, scene, watch)
    }

    /// Runs scenes side by side ([`ensemble`]); of each, the start and the end are recorded and nothing between.
    ///
    /// # Errors
    /// For each, those of [`Entry::run`].
    pub fn ends(&self, scenes: &[Scene]) -> Vec<Result<Outcome, Refusal>> {
        side_by_side(&self.derived, scenes)
    }

    /// The equations of a scene, for analyses.
    ///
    /// # Errors
    /// Those of [`System::of`].
    pub fn system(&self, scene: &Scene) -> Result<System, Refusal> {
        System::of(&self.derived, scene)
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// Where its effects contradict one another.
    pub fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        self.derived.equations(scene)
    }

    /// Has a simulation carry state and time in twice the digits.
    ///
    /// # Errors
    /// Where damping couples the modes of a cell.
    pub fn compensate(&self, simulation: &mut Simulation<'_>, scene: &Scene) -> Result<(), Refusal> {
        compensate(&self.derived, simulation, scene)
    }
}

fn compensate(derived: &DerivedModel, simulation: &mut Simulation<'_>, scene: &Scene) -> Result<(), Refusal> {
    let parameters: Vec<Df64> = scene.parameters.iter().copied().map(Df64::from).collect();
    let mids: Vec<Df64> = scene.laws.iter().map(|law| law.exact_mid()).collect();
    simulation.compensate(&|k| (derived.exactly)(scene.effects.0, &parameters, &mids, k))
}

fn run(derived: &DerivedModel, scene: &Scene, watch: &mut dyn FnMut(f64)) -> Result<Outcome, Refusal> {
    let equations = derived.equations(scene)?;
    let begun = start::begin(&*equations, scene)?;
    let choice = choice::of(scene, &begun.laws)?;
    let (others, closes) = (begun.others.clone(), account::closes(&begun.laws));
    let outcome = match choice::numerical(&choice, scene) {
        None => exact(derived, scene, &*equations, begun, choice, watch),
        Some(_) if scene.solver.precision == Precision::Compensated => Err(Refusal::CompensatedNumerical(choice.why)),
        Some((method, settings)) => {
            let forcing = Forcing::of(derived, scene);
            Ok(numerical(scene, &*equations, begun, choice, (method, settings, forcing), watch))
        }
    }?;
    let refuted = Account::of(&outcome, scene).filter(|account| closes && account.refutes());
    Ok(Outcome { refuted, remarks: others.into_iter().chain(outcome.remarks).collect(), ..outcome })
}

/// By the exact engine.
fn exact(
    derived: &DerivedModel,
    scene: &Scene,
    equations: &dyn Equations,
    begun: Begun,
    choice: Choice,
    watch: &mut dyn FnMut(f64),
) -> Result<Outcome, Refusal> {
    let mut simulation = Simulation::begun(scene.model, equations, scene, begun, Forcing::of(derived, scene))?;
    if scene.solver.precision == Precision::Compensated {
        if let Some(torques) = scene.varying() {
            return Err(Refusal::CompensatedVarying { torques });
        }
        compensate(derived, &mut simulation, scene)?;
    }
    let mut recorder = recorder(scene, equations, &simulation);
    let begin = ThreadTime::now();
    let stopped_by = simulation.run(Some((&mut recorder, scene.output.rate, scene.output.events)), watch).err();
    let cpu_seconds = since(begin);
    if stopped_by.is_some() {
        simulation.note(&mut recorder, Moment::Sample);
    }
    Ok(ended(scene, equations, choice, &simulation, recorder, stopped_by, cpu_seconds))
}

/// Those that are exact and plain in lanes, the others by themselves.
fn side_by_side(derived: &DerivedModel, scenes: &[Scene]) -> Vec<Result<Outcome, Refusal>> {
    let prepare = |scene: &Scene| -> Result<_, Refusal> {
        let equations = derived.equations(scene)?;
        let begun = start::begin(&*equations, scene)?;
        let choice = choice::of(scene, &begun.laws)?;
        Ok((equations, begun, choice))
    };
    let prepared: Vec<_> = scenes.iter().map(prepare).collect();
    let plain = |scene: &Scene, choice: &Choice| {
        scene.solver.precision == Precision::Plain && choice::numerical(choice, scene).is_none()
    };
    // Those that are exact and plain, side by side.
    let (mut which, mut simulations) = (vec![], vec![]);
    for (i, (scene, prepared)) in scenes.iter().zip(&prepared).enumerate() {
        if let Ok((equations, begun, choice)) = prepared
            && plain(scene, choice)
            && scene.varying().is_none()
            && let Ok(simulation) = Simulation::begun(scene.model, &**equations, scene, begun.clone(), None)
        {
            which.push(i);
            simulations.push(simulation);
        }
    }
    let recorders = which.iter().zip(&simulations).map(|(&i, simulation)| {
        let mut recorder = recorder(&scenes[i], simulation.equations(), simulation);
        simulation.note(&mut recorder, Moment::Sample);
        recorder
    });
    let recorders: Vec<_> = recorders.collect();
    let begin = ThreadTime::now();
    let results = ensemble::run(&mut simulations);
    let each = since(begin) / simulations.len().max(1) as f64;
    let mut done: Vec<Option<Outcome>> = vec![None; scenes.len()];
    for (((&i, simulation), mut recorder), result) in which.iter().zip(&simulations).zip(recorders).zip(results) {
        simulation.note(&mut recorder, Moment::Sample);
        if let Ok((equations, begun, choice)) = &prepared[i] {
            let outcome = ended(&scenes[i], &**equations, choice.clone(), simulation, recorder, result.err(), each);
            let refuted = Account::of(&outcome, &scenes[i]);
            let refuted = refuted.filter(|account| account::closes(&simulation.laws) && account.refutes());
            let remarks = begun.others.iter().cloned().collect();
            done[i] = Some(Outcome { refuted, remarks, ..outcome });
        }
    }
    // The others by themselves.
    let one = |(done, scene): (Option<Outcome>, &Scene)| done.map_or_else(|| run(derived, scene, &mut |_| {}), Ok);
    done.into_iter().zip(scenes).map(one).collect()
}

fn recorder<'e>(scene: &Scene, equations: &'e dyn Equations, simulation: &Simulation<'_>) -> Recorder<'e> {
    let (lengths, state, levels) = (simulation.turn_lengths(), simulation.state.clone(), simulation.levels());
    let mut recorder = Recorder::new(scene.model, equations, lengths, state, levels);
    recorder.most_rows = scene.output.most_rows;
    recorder
}

/// What a simulation came to.
fn ended(
    scene: &Scene,
    equations: &dyn Equations,
    choice: Choice,
    simulation: &Simulation<'_>,
    recorder: Recorder<'_>,
    stopped_by: Option<Stop>,
    cpu_seconds: f64,
) -> Outcome {
    Outcome {
        energy_at_start: recorder.energy_at_start,
        trajectory: recorder.trajectory,
        ignored: simulation.ignored,
        counts: simulation.counts.clone(),
        solver: Solver { method: choice.method.name(), why: choice.why, steps: 0, rejected: 0 },
        stopped_by,
        reference_frequency: reference_frequency(scene, equations),
        cpu_seconds,
        refuted: None,
        digits: None,
        remarks: vec![],
    }
}

/// By a numerical method.
fn numerical(
    scene: &Scene,
    equations: &dyn Equations,
    begun: Begun,
    choice: Choice,
    (method, settings, forcing): (Box<dyn methods::Method>, Settings, Option<Forcing>),
    watch: &mut dyn FnMut(f64),
) -> Outcome {
    let mut advance = Advance::begun(equations, scene, begun, method, settings, forcing);
    let (lengths, state, levels) = (advance.turn_lengths(), advance.state(), advance.levels());
    let mut recorder = Recorder::new(scene.model, equations, lengths, state, &levels);
    recorder.most_rows = scene.output.most_rows;
    let begin = ThreadTime::now();
    let stopped_by = advance.run(Some((&mut recorder, scene.output.rate, scene.output.events)), watch).err();
    let cpu_seconds = since(begin);
    if stopped_by.is_some() {
        advance.note(&mut recorder, Moment::Sample);
    }
    let (method, why) = match advance.gave_way {
        Some(t) => {
            let first = choice.method.name();
            let why = format!("{}; {first} until t = {t} s, where the cell proved stiff for it", choice.why);
            (advance.method(), why)
        }
        None => (choice.method.name(), choice.why),
    };
    let (steps, rejected) = advance.steps;
    Outcome {
        energy_at_start: recorder.energy_at_start,
        trajectory: recorder.trajectory,
        ignored: 0.0,
        counts: advance.counts.clone(),
        solver: Solver { method, why, steps, rejected },
        stopped_by,
        reference_frequency: reference_frequency(scene, equations),
        cpu_seconds,
        refuted: None,
        digits: None,
        remarks: vec![],
    }
}

/// Processor time of this thread since `begin` [s], never 0.
fn since(begin: ThreadTime) -> f64 {
    begin.elapsed().max(Duration::from_nanos(1)).as_secs_f64()
}

/// Damped angular frequency of the lowest elastic mode at the mid stiffness [rad/s], where the cells are linear.
fn reference_frequency(scene: &Scene, equations: &dyn Equations) -> Option<f64> {
    let mids: Vec<f64> = scene.laws.iter().map(|l| l.mid()).collect();
    let cell = Cell::new(equations, &scene.model.in_contact(mids));
    let cell = cell.ok().filter(|_| scene.effects.nonlinear(scene.model).is_empty())?;
    cell.modes.iter().map(|m| m.damped_frequency()).find(|w| *w > 0.0)
}
