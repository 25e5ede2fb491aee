//! The equations of a scene in the form that analyses use: matrices, propagators and the start.

use crate::engine::cell::{self, Cell};
use crate::engine::equations::{DerivedModel, Equations, Known, Switching};
use crate::engine::error::Refusal;
use crate::engine::flanks;
use crate::engine::modal::Matrices;
use crate::engine::start;
use crate::engine::vector::{Matrix, Vector};
use crate::model::{Law, Model, Role, Start};
use crate::profile::Profile;
use crate::scene::Scene;

/// The equations of a scene. `k` holds the present value of each law; if it holds the stiffnesses alone, which come first, the other laws
/// are zero, or about a steady motion at their means. Every switch is as without its effect: every play is in contact, and its
/// deflection is counted from its edge.
pub struct System {
    equations: Box<dyn Equations>,
    model: &'static Model,
    about: Option<Steady>,
}

/// A steady motion, about which the equations are linearised.
#[derive(Debug, Clone)]
pub struct Steady {
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
    /// Why the motion meets both flanks of a mesh, in words: friction of the flanks, linearised, is that of one; `None` if it meets one.
    pub both_flanks: Option<String>,
}

impl System {
    /// The system of a scene with linear cells.
    ///
    /// # Errors
    /// If the model's cells are not linear, or its effects contradict one another.
    pub fn of(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        let terms = scene.effects.nonlinear(scene.model);
        if !terms.is_empty() {
            return Err(Refusal::Nonlinear { terms });
        }
        Self::linear_part(derived, scene)
    }

    /// The linear part of the equations of a scene, without the terms that are not.
    ///
    /// # Errors
    /// If the effects contradict one another.
    pub fn linear_part(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        Ok(System { equations: derived.equations(scene)?, model: scene.model, about: None })
    }

    /// The system of a scene. Forces that are not linear are linearised about the steady motion at the speeds of the start: friction of the
    /// flanks, motors, loads. Coordinates that are static by default are in equilibrium there.
    ///
    /// # Errors
    /// If the inertia depends on the coordinates, the effects contradict one another, or there is no equilibrium.
    pub fn about_steady_motion(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        let terms = scene.effects.nonlinear(scene.model);
        let linear = Self::linear_part(derived, scene)?;
        if terms.is_empty() {
            return Ok(linear);
        }
        let System { equations, model, .. } = linear;
        if !equations.is_inertia_constant() {
            return Err(Refusal::MovingInertia { terms });
        }
        let mut resting = scene.clone();
        for (given, coordinate) in resting.start.q.iter_mut().zip(model.coordinates) {
            if coordinate.start == Start::Static && !given.is_static() {
                *given = Start::Near(given.guess());
            }
        }
        let begun = start::begin(&*equations, &resting)?;
        let mean = |(law, given): (&Law, &Profile)| if law.role == Role::Error { 0.0 } else { given.mean() };
        let means: Vec<f64> = scene.present().map(|(law, given)| mean((law, given))).collect();
        let (q, q_dot) = (begun.absolute(), begun.state.q_dot.clone());
        let k = begun.levels(&resting);
        let is_force = |unit: &str| ["N", "N*m", "W"].contains(&unit);
        let is_there = |with: Option<&str>| with.is_none_or(|effect| scene.effects.has(effect, model));
        let outputs = model.outputs.iter().enumerate();
        // What a run alone knows, reactions and powers of torques, has no value here.
        let outputs = outputs.filter(|(_, output)| is_force(output.unit) && is_there(output.with) && !output.known);
        let value = |i: usize| equations.output(i, &q, &q_dot, &k, &Known::default());
        let outputs = outputs.map(|(i, output)| (output.name, output.unit, value(i))).collect();
        let both_flanks = flanks::both(&*equations, scene, (&begun.state.q, &q_dot), &k);
        Ok(System { equations, model, about: Some(Steady { q, q_dot, means, terms, outputs, both_flanks }) })
    }

    /// The steady motion about which it is linearised; `None` if it is linear.
    pub fn steady(&self) -> Option<&Steady> {
        self.about.as_ref()
    }

    /// V at the coordinates `q` (n) [J].
    pub fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        self.equations.potential(q, &self.values(k))
    }

    /// M, M⁻¹, C, K, f of the linear part.
    ///
    /// # Errors
    /// If M is not positive definite, or a number overflows.
    pub fn matrices(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        cell::matrices(&*self.equations, &self.values(k))
    }

    /// The same about the steady motion, C = -dF/dq' and K = -dF/dq there, while the laws keep their values. They need not be symmetric.
    ///
    /// # Errors
    /// Those of [`System::matrices`].
    pub fn linearised(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        let linear = self.matrices(k)?;
        let Some(Steady { q, q_dot, .. }) = &self.about else { return Ok(linear) };
        let flat = vec![0.0; self.model.laws.len()];
        let [by_q, by_speed] = self.equations.jacobian(q, q_dot, &self.values(k), &flat, &flat);
        Ok(Matrices { damping: -by_speed, stiffness: -by_q, ..linear })
    }

    /// The propagator: a small disturbance (dq, dq') at t = 0 gives its product with this matrix after the time `t` [s] (2n x
    /// 2n).
    ///
    /// # Errors
    /// Those of the modes of a cell.
    pub fn propagator(&self, k: &[f64], t: f64) -> Result<Matrix, Refusal> {
        let cell = Cell::new(&*self.equations, &self.values(k))?;
        let n = self.equations.coordinates();
        let mut propagator = Matrix::identity(2 * n, 2 * n);
        for column in 0..2 * n {
            let unit = |from: usize| Vector::from_fn(n, |i| f64::from(u8::from(from + i == column)));
            let flight = cell.difference(&unit(0), &unit(n));
            let (dq, dv) = flight.increments(&flight.at(t));
            for i in 0..n {
                propagator[(i, column)] += dq[i];
                propagator[(n + i, column)] += dv[i];
            }
        }
        Ok(propagator)
    }

    /// How law `i` switches with the effects of the scene.
    pub fn switching(&self, law: usize) -> Switching {
        self.equations.switching(law)
    }

    /// Speeds q' of rigid motion `i` of unit size (n).
    pub fn motion(&self, i: usize) -> Vector {
        self.equations.motion(i)
    }

    /// The coordinates at the start of a scene (n), including those in static equilibrium.
    ///
    /// # Errors
    /// If the forces do not determine that equilibrium.
    pub fn start(&self, scene: &Scene) -> Result<Vector, Refusal> {
        Ok(start::begin(&*self.equations, scene)?.absolute())
    }

    fn values(&self, k: &[f64]) -> Vec<f64> {
        let means = self.about.iter().flat_map(|about| &about.means).skip(k.len());
        self.model.in_contact(k.iter().chain(means).copied())
    }
}
