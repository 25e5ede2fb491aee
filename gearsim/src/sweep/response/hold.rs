//! Holds the speed of a scene by its own means: by the set point of its governor, or by a torque.
//!
//! A rigid motion z has the speed u, the momentum p = z.M q' and the inertia J = z.M z. For it:
//!
//! ```text
//! dp/dt = z.F = r      measured: the change of p over whole periods, divided by their time; springs do not contribute
//! c = -d(z.F)/du       by differences at the mean speed u: governors, motors, fans, dampers to the ground
//! b = d(z.F)/dP        of the parameter P, in which forces are linear
//! ```
//!
//! At the wanted speed v the force would be r - c (v - u). The parameter P + (c (v - u) - r)/b makes it zero: Newton's method, one step a
//! run. A part of v - u is the effect of the force until the middle of the measured time; the speed at the start is shifted by the rest.
//!
//! A run may lose its speed before the measured time, for example under dry friction. It has r = 0 while it is at rest. Its r is measured
//! from the start until half of the speed is lost.

use super::motion::UnitMotion;
use super::span::Span;
use crate::engine::equations::Equations;
use crate::engine::vector::{Vector, dot};
use crate::model::{Parameter, Varies};
use crate::output::number::short;
use crate::run::Entry;
use crate::scene::Scene;
use crate::tolerance::analysis::{CAME_TO_REST, HELD_SPEED, HELD_STEADY};
use crate::trajectory::{Trajectory, place};

/// How a response curve holds the speed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Hold {
    /// If a speed is varied: by the set point of a governor, else by a driving torque, else by another torque. If no speed is varied, the
    /// speed is not held.
    #[default]
    Own,
    /// By this parameter.
    By(String),
    /// The speed is not held: torques are those of the scene.
    Nothing,
}

impl Hold {
    /// The hold with a name: that of a parameter, or `nothing`; without a name, [`Hold::Own`].
    pub fn named(name: Option<&str>) -> Hold {
        match name {
            None => Hold::Own,
            Some("nothing") => Hold::Nothing,
            Some(parameter) => Hold::By(parameter.into()),
        }
    }
}

/// A parameter that can hold the speed.
#[derive(Debug, Clone)]
pub(super) struct Handle {
    /// Index of the parameter.
    pub parameter: usize,
    /// Force on the motion per unit of the parameter, b.
    unit: f64,
}

/// The mean speed of a run, and the force that changes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Speed {
    /// Mean over the measured time, u.
    pub mean: f64,
    /// Force on the motion, r.
    force: f64,
    /// Inertia of the motion, J.
    inertia: f64,
    /// Decrease of the force with the speed, c.
    drag: f64,
    /// Length of the measured time, and the time of its middle \[s\].
    times: [f64; 2],
}

impl Handle {
    /// The parameters of a scene that can hold the speed of `motion`, the best one first. `speed` is that of the scene \[SI\].
    pub(super) fn all(scene: &Scene, entry: &Entry, motion: &UnitMotion, speed: f64) -> Vec<Handle> {
        let active = |p: &Parameter| p.varies == Varies::AsLoad && scene.effects.activate(p.with, scene.model);
        let of = |parameter: usize| {
            let force = |value: f64| {
                let mut scene = scene.clone();
                scene.parameters[parameter] = value;
                let equations = entry.equations(&scene).ok()?;
                Some(motion.force(&scene, &*equations, 0.0))
            };
            let unit = force(1.0)? - force(0.0)?;
            (unit != 0.0 && unit.is_finite()).then_some(Handle { parameter, unit })
        };
        let active = scene.model.parameters.iter().enumerate().filter(|(_, p)| active(p));
        let mut all: Vec<Handle> = active.filter_map(|(i, _)| of(i)).collect();
        all.sort_by_key(|handle| {
            let is_set_point = scene.model.parameters[handle.parameter].unit == "rad/s";
            let drives = handle.unit * scene.parameters[handle.parameter] * speed > 0.0;
            (!is_set_point, !drives)
        });
        all
    }

    /// Adds `more` \[SI\] to the value of the parameter at all times.
    pub(super) fn add(&self, scene: &mut Scene, more: f64) {
        scene.parameters[self.parameter] += more;
        let own = scene.time_histories.iter_mut().filter(|(p, _)| *p == self.parameter);
        own.flat_map(|(_, history)| &mut history.pieces).for_each(|piece| piece.value += more);
    }

    /// The changes of the parameter and of the speed at the start with which a run of speed `speed` would have had the speed `wanted`.
    pub(super) fn step(&self, speed: &Speed, wanted: f64) -> [f64; 2] {
        let Speed { mean, force, inertia, drag, times: [_, middle] } = *speed;
        let imbalance = force - drag * (wanted - mean);
        // The effect of the imbalance until the middle of the measured time.
        let relaxed = drag * middle / inertia;
        let done = if relaxed.abs() < 1e-6 { middle / inertia } else { -(-relaxed).exp_m1() / drag };
        // A shift that decays before the middle of the measured time is left out.
        let shift = if relaxed < 1.0 { wanted - (mean - imbalance * done) } else { 0.0 };
        [-imbalance / self.unit, shift]
    }
}

impl Speed {
    /// The speed of a run over the measured time.
    pub(super) fn of(
        scene: &Scene,
        equations: &dyn Equations,
        motion: &UnitMotion,
        run: &Trajectory,
        span: &Span,
    ) -> Self {
        let state = |row: usize| -> [Vector; 2] {
            [&run.q, &run.q_dot].map(|columns| Vector::from_fn(columns.len(), |i| columns[i][row]))
        };
        let momentum = |row: usize| {
            let [q, q_dot] = state(row);
            dot(&motion.unit, &(&equations.mass(&q) * &q_dot))
        };
        let at = |t: f64| {
            let (row, share) = place(&run.t, t);
            let [before, after] = [momentum(row), momentum(row + 1)];
            before + share * (after - before)
        };
        let last = run.row_from(span.end).min(run.len() - 1);
        let inertia = dot(&motion.unit, &(&equations.mass(&state(last)[0]) * &motion.unit));
        let mean = motion.mean_speed(run, span);
        let near = 1e-3 * mean;
        let drag = if near == 0.0 {
            0.0
        } else {
            let force = |speed: f64| motion.force(scene, equations, speed);
            (force(mean - near) - force(mean + near)) / (2.0 * near)
        };
        let force = (momentum(last) - at(span.begin)) / span.time();
        Speed { mean, force, inertia, drag, times: [span.time(), 0.5 * (span.begin + span.end)] }
    }

    /// Relative change of the speed over the measured time \[1\].
    pub(super) fn drift(&self) -> f64 {
        self.force * self.times[0] / (self.inertia * self.mean)
    }

    /// Why the speed is not held, in words.
    pub(super) fn unheld(&self, wanted: f64) -> String {
        if (self.mean / wanted).abs() < CAME_TO_REST {
            return "the train comes to rest: what holds the speed does not overcome what brakes it".into();
        }
        format!(
            "the mean speed is {} rad/s instead of {} rad/s, and changes by {} % in the measured time: damping, or a longer time to settle, helps",
            short(self.mean),
            short(wanted),
            short(100.0 * self.drift())
        )
    }

    /// Whether the speed is steady and has the value `wanted`.
    pub(super) fn is_held(&self, wanted: f64) -> bool {
        self.drift().abs() <= HELD_STEADY && (self.mean / wanted - 1.0).abs() <= HELD_SPEED
    }
}
