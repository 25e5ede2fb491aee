//! The equations of a scene in the form that analyses use: matrices, propagators and the start.

mod about;

use nalgebra::DMatrix;

use crate::engine::cell::{self, Cell};
use crate::engine::equations::{DerivedModel, Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::modal::{Matrices, inverse_root};
use crate::engine::start;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::scene::Scene;

pub use about::{LinearisedAbout, Steady, are_same};

/// The equations of a scene. `k` holds the present value of each law; if it holds only the stiffnesses, which come first, the other laws
/// are zero, or at their means about a steady motion. Switches have no effect: flanks with play are in contact, and the deflection is
/// measured from the edge.
pub struct System {
    equations: Box<dyn Equations>,
    model: &'static Model,
    about: Option<Steady>,
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

    /// The linear part of the equations of a scene. Nonlinear terms are ignored.
    ///
    /// # Errors
    /// If the effects contradict one another.
    pub fn linear_part(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        Ok(System { equations: derived.equations(scene)?, model: scene.model, about: None })
    }

    /// The system of a scene. Nonlinear terms are linearised about a motion ([`Steady`]): an equilibrium if nothing turns, otherwise the
    /// steady motion at the speeds of the start. Coordinates that are static by default are in equilibrium there.
    ///
    /// # Errors
    /// If the effects contradict one another, M is not positive definite there, or there is no equilibrium.
    pub fn about_steady_motion(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        let terms = scene.effects.nonlinear(scene.model);
        let System { equations, model, .. } = Self::linear_part(derived, scene)?;
        let about = if terms.is_empty() { None } else { Some(Steady::of(&*equations, scene, terms)?) };
        Ok(System { equations, model, about })
    }

    /// The steady motion about which it is linearised; `None` if it is linear.
    pub fn steady(&self) -> Option<&Steady> {
        self.about.as_ref()
    }

    /// V at the coordinates `q` (n) [J].
    pub fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        self.equations.potential(q, &self.values(k))
    }

    /// The equations.
    pub fn equations(&self) -> &dyn Equations {
        &*self.equations
    }

    /// M, M⁻¹, C, K, f of the linear part. About a steady motion, M is that at its place. K is minus the derivative of F at rest and
    /// without friction, made symmetric, because these forces have a potential.
    ///
    /// # Errors
    /// If M is not positive definite, or a number overflows.
    pub fn matrices(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        let Some(Steady { q, .. }) = &self.about else { return cell::matrices(&*self.equations, &[], &self.values(k)) };
        let mass = self.equations.mass(q);
        if mass.iter().any(|x| !x.is_finite()) {
            return Err(Refusal::Overflow);
        }
        inverse_root(&mass)?; // an error if M is not positive definite
        let without_friction = self.model.in_contact(k.iter().copied());
        let (at_rest, flat) = (Vector::zeros(q.len()), vec![0.0; self.model.laws.len()]);
        let [by_q, _] = self.equations.jacobian(q, &at_rest, &without_friction, &flat, &flat);
        Ok(Matrices {
            mobility: self.equations.mobility(q),
            damping: self.equations.damping(&without_friction),
            stiffness: DMatrix::from_fn(q.len(), q.len(), |i, j| -0.5 * (by_q[(i, j)] + by_q[(j, i)])),
            load: (&self.equations.force(q, &at_rest, &without_friction, &flat)).into(),
            mass,
        })
    }

    /// The same about the steady motion, while the laws keep their values: C = -dF/dq' and K = d(M q'' - F)/dq there. They need not be
    /// symmetric.
    ///
    /// # Errors
    /// Those of [`System::matrices`].
    pub fn linearised(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        let linear = self.matrices(k)?;
        let Some(Steady { q, q_dot, .. }) = &self.about else { return Ok(linear) };
        let (k, flat) = (self.values(k), vec![0.0; self.model.laws.len()]);
        let [mut by_q, by_speed] = self.equations.jacobian(q, q_dot, &k, &flat, &flat);
        if !self.equations.is_inertia_constant() {
            by_q -= self.equations.inertia(q, &self.equations.acceleration(q, q_dot, &k, &flat));
        }
        Ok(Matrices { damping: -by_speed, stiffness: -by_q, ..linear })
    }

    /// The same system about another place of its motion, the coordinates moved by `dq` (n).
    pub fn moved(self, dq: &Vector) -> System {
        let about = self.about.map(|about| Steady { q: &about.q + dq, ..about });
        System { about, ..self }
    }

    /// The propagator P (2n x 2n): a small disturbance (dq, dq') at t = 0 becomes P (dq, dq') after the time `t` [s].
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

    /// The deflection of the switch of an effect, as that of a mesh with play, at the coordinates `q` and without the edge of its mode;
    /// `None` if the effect has no switch.
    pub fn switched(&self, effect: &str, q: &[f64]) -> Option<f64> {
        let i = self.model.switches.iter().position(|switch| switch.with == effect)?;
        let over = self.equations.deflection(self.equations.switched(i), q, &self.model.in_contact([]));
        Some(over.normal.dot(q))
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
