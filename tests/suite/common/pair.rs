//! A gear pair given by its numbers, and runs of it that start from any state. A scene file would not keep every bit of these numbers.

#![allow(dead_code)] // each test binary uses only some of these

use gearsim::__private::equations::DerivedModel;
use gearsim::__private::models::GearPair;
use gearsim::__private::{LawState, Recorder, Simulation, State};
use gearsim::model::Start;
use gearsim::run::{Counts, Stop};
use gearsim::scene::{Profile, Scene, Step};
use gearsim::trajectory::Trajectory;

use crate::common;

/// One pitch of theta [rad].
pub const PITCH: f64 = std::f64::consts::TAU;

/// A gear pair, its start and the length of its run, in SI units. N1 = 24 and N2 = 96, as in the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// Moments of inertia [kg m²].
    pub inertia: [f64; 2],
    /// Damping ratio.
    pub zeta: f64,
    /// Torque [N m].
    pub t0: f64,
    /// Levels of the stiffness [N m] and their widths [rad].
    pub steps: Vec<(f64, f64)>,
    /// theta and phi at the start [rad].
    pub q: [f64; 2],
    /// theta' and phi' at the start [rad/s].
    pub q_dot: [f64; 2],
    /// Length of the run [s].
    pub span: f64,
}

/// The end of a run: everything that another run needs to continue from there.
#[derive(Debug, Clone)]
pub struct Ran {
    pub state: State,
    pub cell: usize,
    pub laws: Vec<LawState>,
    /// Times of the events since the start of the run [s].
    pub times: Vec<f64>,
    pub counts: Counts,
    /// Why the run stopped early, if it did.
    pub stop: Option<Stop>,
}

impl Pair {
    /// The largest level of the stiffness [N m].
    pub fn stiffest(&self) -> f64 {
        self.steps.iter().fold(0.0, |m, (k, _)| m.max(*k))
    }

    /// M2 of the equations of motion [1/(kg m²)].
    pub fn m2(&self) -> f64 {
        0.5 * (24.0 * 24.0 / self.inertia[0] + 96.0 * 96.0 / self.inertia[1])
    }

    /// The larger of the two inertias I/N² over the smaller. The entries of M are their sum and their difference, so M holds the
    /// smaller one with a relative error that is this many times eps.
    pub fn ratio(&self) -> f64 {
        let ratio = self.inertia[1] / self.inertia[0] / 16.0;
        ratio.max(1.0 / ratio)
    }

    /// The scene of this gear pair: a scene of the paper with every number replaced.
    pub fn scene(&self) -> Scene {
        let mut scene = common::scene("oh2005/spectrum_600rpm_exact", &[]);
        scene.parameters[..6].copy_from_slice(&[24.0, 96.0, self.inertia[0], self.inertia[1], self.zeta, self.t0]);
        let steps = self.steps.iter().map(|(value, width)| Step { value: *value, width: *width }).collect();
        scene.laws = vec![Profile::stepping(steps)];
        scene.start.q = vec![Start::At(self.q[0]), Start::Static];
        scene.start.q_dot = self.q_dot.map(Some).to_vec();
        scene.t_end = self.span;
        scene.output.rate = 100.0 / self.span;
        scene
    }

    /// Runs the gear pair from its start.
    pub fn run(&self) -> Ran {
        self.run_from(None)
    }

    /// Runs the gear pair from the end of another run.
    pub fn run_on(&self, from: &Ran) -> Ran {
        self.run_from(Some(from))
    }

    fn run_from(&self, from: Option<&Ran>) -> Ran {
        let scene = self.scene();
        let equations = DerivedModel::of::<GearPair>().equations(&scene).expect("effects that go together");
        let mut simulation = Simulation::new(&*equations, &scene).expect("numbers that make a system");
        simulation.now.state.q[1] = self.q[1];
        if let Some(from) = from {
            simulation.go_on_from(from.state.clone(), from.laws.clone(), vec![]).expect("a cell of the same scene");
        }
        let mut times = vec![];
        let stop = loop {
            match simulation.step(&mut None) {
                Ok(true) => break None,
                Ok(false) => times.push(simulation.now.clock.now()),
                Err(stop) => break Some(stop),
            }
        };
        let (state, cell, laws, counts) = (
            simulation.now.state.clone(),
            simulation.now.cell().index(),
            simulation.now.laws.clone(),
            simulation.now.counts.clone(),
        );
        Ran { state, cell, laws, times, counts, stop }
    }

    /// The trajectory that the program's recorder writes, until the run ends or stops early.
    pub fn recorded(&self) -> Trajectory {
        let scene = self.scene();
        let equations = DerivedModel::of::<GearPair>().equations(&scene).expect("effects that go together");
        let mut simulation = Simulation::new(&*equations, &scene).expect("numbers that make a system");
        simulation.now.state.q[1] = self.q[1];
        let (state, k) = (simulation.now.state.clone(), simulation.now.k[..].to_vec());
        let mut recorder = Recorder::new(&scene, &*equations, simulation.turn_lengths(), state, &k);
        let _ = simulation.run(Some((&mut recorder, scene.output.rate, true)), &mut |_| {});
        recorder.trajectory
    }

    /// The scales by which states are compared, of theta [rad], phi [rad], theta' [rad/s] and phi' [rad/s].
    pub fn sizes(&self) -> [f64; 4] {
        let softest = self.steps.iter().fold(f64::INFINITY, |m, (k, _)| m.min(*k));
        let w = (self.m2() * self.stiffest()).sqrt();
        let phi = self.q[1].abs() + (self.t0 / softest).abs() + self.q_dot[1].abs() / w;
        let speed = self.q_dot[0].abs() + phi * w;
        [1.0, phi, speed, speed]
    }

    /// The largest difference of two states, each component over its size. Whole pitches count in theta.
    pub fn difference(&self, a: &State, b: &State) -> f64 {
        let turns = (a.turns[0] - b.turns[0]) as f64 * PITCH;
        let [q, v] = [&a.q - &b.q, &a.q_dot - &b.q_dot];
        let by = [q[0] + turns, q[1], v[0], v[1]];
        by.iter().zip(self.sizes()).map(|(x, size)| x.abs() / size).fold(0.0, f64::max)
    }

    /// The condition number of the run: the largest change of the end over the change of the start that causes it. Rounding
    /// errors grow by this factor. Infinite where the changed start meets other events.
    pub fn conditioning(&self) -> f64 {
        const SHIFT: f64 = 1e-8;
        let here = self.run();
        let mut worst = 1.0_f64;
        for i in 0..4 {
            let mut other = self.clone();
            let by = SHIFT * self.sizes()[i];
            let place = if i < 2 { &mut other.q[i] } else { &mut other.q_dot[i - 2] };
            *place += by;
            let there = other.run();
            if there.counts.cell_changes != here.counts.cell_changes
                || there.counts.reflections != here.counts.reflections
            {
                return f64::INFINITY;
            }
            worst = worst.max(self.difference(&here.state, &there.state) / SHIFT);
        }
        worst
    }
}
