//! The motion about which nonlinear equations are linearised: an equilibrium, a steady motion, or a place of a motion.
//!
//! | motion | when | matrices |
//! | --- | --- | --- |
//! | [`LinearisedAbout::Equilibrium`] | nothing turns, and F(q, 0) = 0 | constant |
//! | [`LinearisedAbout::Steady`] | M and F do not change as the coordinates move on at the speeds of the start | constant |
//! | [`LinearisedAbout::Place`] | otherwise, e.g. a crank turns, or is released out of equilibrium | those of one instant |

use crate::engine::equations::{Equations, Known};
use crate::engine::error::Refusal;
use crate::engine::flanks;
use crate::engine::start::{self, Initial};
use crate::engine::vector::{Matrix, Vector};
use crate::model::{Law, Role, Start};
use crate::profile::Profile;
use crate::scene::Scene;
use crate::tolerance::analysis::{AT_EQUILIBRIUM, SAME_EQUATIONS};

/// The kind of motion about which the equations are linearised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearisedAbout {
    /// A state of rest in which all forces vanish.
    Equilibrium,
    /// A motion at constant speeds, along which the equations do not change.
    Steady,
    /// An instant of a motion along which the equations change: its place and its speeds.
    Place,
}

/// A motion, about which the equations are linearised.
#[derive(Debug, Clone)]
pub struct Steady {
    /// Which kind of motion it is.
    pub motion: LinearisedAbout,
    /// The coordinates, with the elastic ones in static equilibrium [SI] (n).
    pub q: Vector,
    /// The speeds of the start [SI] (n).
    pub q_dot: Vector,
    /// The mean of each law over its period; of transmission errors zero.
    pub means: Vec<f64>,
    /// The terms that are linearised, in words.
    pub terms: String,
    /// The outputs of the model that are forces, torques or powers: name, unit and value.
    pub outputs: Vec<(&'static str, &'static str, f64)>,
    /// Why the motion meets both flanks of a mesh, in words; `None` if it meets one. Linearised friction is that of one flank.
    pub both_flanks: Option<String>,
}

impl Steady {
    /// Whether the matrices change along the motion. They are then those of one place of the motion.
    pub fn moves(&self) -> bool {
        self.motion == LinearisedAbout::Place
    }

    /// The motion of a scene whose `terms` are not linear.
    ///
    /// # Errors
    /// If there is no equilibrium of the elastic coordinates.
    pub fn of(equations: &dyn Equations, scene: &Scene, terms: String) -> Result<Steady, Refusal> {
        let model = scene.model;
        let mean = |(law, given): (&Law, &Profile)| if law.role == Role::Error { 0.0 } else { given.mean() };
        let means: Vec<f64> = scene.present().map(|(law, given)| mean((law, given))).collect();
        let (motion, begun) = find(equations, scene, &model.in_contact(means.iter().copied()))?;
        let (q, q_dot) = (begun.absolute(), begun.state.q_dot.clone());
        let k = begun.levels(scene);
        let is_force = |unit: &str| ["N", "N*m", "W"].contains(&unit);
        let outputs = model.outputs.iter().enumerate();
        // Reactions and powers of torques are known only in a run and have no value here.
        let outputs = outputs
            .filter(|(_, output)| is_force(output.unit) && scene.effects.activate(output.with, model) && !output.known);
        let value = |i: usize| equations.output(i, &q, &q_dot, &k, &Known::default());
        let outputs = outputs.map(|(i, output)| (output.name, output.unit, value(i))).collect();
        // At the pitch point the friction of a tooth pair has no lever arm. With the mean arm, the derivatives show which flank is loaded.
        let is_friction = |law: &Law| matches!(law.role, Role::Side | Role::Arm);
        let mut typical = k;
        for ((_, given), value) in scene.present().zip(&mut typical).filter(|((law, _), _)| is_friction(law)) {
            *value = given.mean();
        }
        let both_flanks = flanks::both(equations, scene, (&begun.state.q, &q_dot), &typical);
        Ok(Steady { motion, q, q_dot, means, terms, outputs, both_flanks })
    }
}

/// The motion of a scene, and the state from which it starts; `means` are the mean values of the laws.
fn find(equations: &dyn Equations, scene: &Scene, means: &[f64]) -> Result<(LinearisedAbout, Initial), Refusal> {
    let static_by_default = |i: usize| scene.model.coordinates[i].start == Start::Static;
    let begun = start::begin(equations, &settling(scene, static_by_default))?;
    let (q, q_dot) = (begun.absolute(), &begun.state.q_dot);
    let flat = vec![0.0; scene.model.laws.len()];
    if q_dot.iter().any(|v| *v != 0.0) {
        let moving = changes(equations, &q, q_dot, (means, &flat));
        return Ok((if moving { LinearisedAbout::Place } else { LinearisedAbout::Steady }, begun));
    }
    if is_balanced(equations, &q, (&begun.levels(scene), &flat)) {
        return Ok((LinearisedAbout::Equilibrium, begun));
    }
    // Otherwise all coordinates may move from their stated values to an equilibrium.
    if let Ok(settled) = start::begin(equations, &settling(scene, |_| true))
        && is_balanced(equations, &settled.absolute(), (&settled.levels(scene), &flat))
    {
        return Ok((LinearisedAbout::Equilibrium, settled));
    }
    Ok((if equations.is_inertia_constant() { LinearisedAbout::Steady } else { LinearisedAbout::Place }, begun))
}

/// The scene with the given coordinates in static equilibrium, found from their stated values.
fn settling(scene: &Scene, which: impl Fn(usize) -> bool) -> Scene {
    let mut settling = scene.clone();
    for (i, given) in settling.start.q.iter_mut().enumerate() {
        if which(i) && !given.is_static() {
            *given = Start::Near(given.guess());
        }
    }
    settling
}

/// Whether the forces vanish at rest at `q`, up to the rounding errors of `q`.
fn is_balanced(equations: &dyn Equations, q: &[f64], (k, flat): (&[f64], &[f64])) -> bool {
    let at_rest = Vector::zeros(q.len());
    let force = equations.force(q, &at_rest, k, flat);
    let [by_q, _] = equations.jacobian(q, &at_rest, k, flat, flat);
    let size = |i: usize| (0..q.len()).map(|j| (by_q[(i, j)] * q[j]).abs()).sum::<f64>();
    (0..q.len()).all(|i| force[i].abs() <= AT_EQUILIBRIUM * size(i))
}

/// Whether M or F change as the coordinates move on from `q` at the speeds `q_dot`, at fixed values and slopes of the laws.
fn changes(equations: &dyn Equations, q: &Vector, q_dot: &Vector, laws: (&[f64], &[f64])) -> bool {
    // Distances that are no whole numbers of turns, teeth or radians.
    const PLACES: [f64; 3] = [0.618_033_988_7, 1.732_050_807_5, 41.303_162_87];
    let fastest = q_dot.amax();
    PLACES.iter().any(|x| !are_same(equations, [q, &(q + &(q_dot * (x / fastest)))], q_dot, laws))
}

/// Whether M and F are the same at two places, up to rounding errors, at fixed values and slopes of the laws.
pub fn are_same(
    equations: &dyn Equations,
    [one, other]: [&Vector; 2],
    q_dot: &Vector,
    (k, flat): (&[f64], &[f64]),
) -> bool {
    let close = |a: &Matrix, b: &Matrix| (a - b).amax() <= SAME_EQUATIONS * a.amax().max(b.amax());
    let [a, b] = [one, other].map(|q| equations.mass(q));
    let [[a_q, a_v], [b_q, b_v]] = [one, other].map(|q| equations.jacobian(q, q_dot, k, flat, flat));
    if !(close(&a, &b) && close(&a_q, &b_q) && close(&a_v, &b_v)) {
        return false;
    }
    let [f, g] = [one, other].map(|q| equations.force(q, q_dot, k, flat));
    // Each force is known to the rounding errors of the place.
    let size = |i: usize| (0..f.len()).map(|j| (a_q[(i, j)] * other[j]).abs()).sum::<f64>().max(f[i].abs());
    (0..f.len()).all(|i| (f[i] - g[i]).abs() <= SAME_EQUATIONS * size(i))
}
