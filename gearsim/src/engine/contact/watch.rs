//! Functions of the state whose zeros end holds.

use nalgebra::DMatrix;

use crate::engine::equations::Equations;
use crate::engine::motion::End;
use crate::engine::switch::Switch;
use crate::engine::vector::Vector;

/// A function of the state whose zero ends a hold.
#[derive(Debug, Clone)]
pub struct Watch {
    /// The event at the zero.
    pub end: End,
    /// The function.
    pub form: StateForm,
}

/// A linear function of the coordinates, the speeds and the generalised forces F (n each).
#[derive(Debug, Clone)]
pub struct StateForm {
    /// Its slopes along the coordinates.
    pub on_q: Vector,
    /// Those along the speeds.
    pub on_speed: Vector,
    /// Those along the forces: a multiple of a row of the matrix that gives the reactions from the forces.
    pub on_force: Vector,
    /// The number of that row, and the multiple; `None` if the function does not depend on reactions.
    pub(super) reaction: Option<(usize, f64)>,
    /// Its value where coordinates, speeds and forces are zero, without the margin.
    pub(super) constant: f64,
    /// How far a reaction may pull before the hold ends. It is 0 if the function does not depend on reactions.
    pub(super) margin: f64,
}

impl Watch {
    /// Its function at the coordinates `q` and the law values `k`. The guards of a switch may have curved laws as factors, and then change
    /// within a mode.
    pub fn at(&self, equations: &dyn Equations, switches: &[Switch], q: &[f64], k: &[f64]) -> StateForm {
        let (End::Loose(switch, beyond), Some((_, factor))) = (self.end, self.form.reaction) else {
            return self.form.clone();
        };
        let exits = switches[switch].exits(equations, q, k);
        let exit = exits.into_iter().find(|exit| exit.beyond == beyond && exit.guard.on_reaction == factor);
        let guard = exit.expect("the guard of which the hold was made").guard;
        let constant = guard.constant_at(k);
        StateForm { on_q: guard.on_q, on_speed: guard.on_speed, constant, ..self.form.clone() }
    }
}

impl StateForm {
    /// The function R + `margin`, where R = `on_force`.F is reaction number `which`.
    pub(super) fn reaction(on_force: Vector, which: usize, margin: f64) -> Self {
        let none = Vector::zeros(on_force.len());
        StateForm { on_q: none.clone(), on_speed: none, on_force, reaction: Some((which, 1.0)), constant: 0.0, margin }
    }

    /// Its value where coordinates, speeds and forces are zero.
    pub fn constant(&self) -> f64 {
        self.constant + self.margin
    }

    /// The same function with `to_reactions` as the matrix that gives the reactions from the forces (one row per reaction).
    pub fn at(&self, to_reactions: &DMatrix<f64>) -> Self {
        let row =
            |(which, factor): (usize, f64)| Vector::from_fn(self.on_force.len(), |i| factor * to_reactions[(which, i)]);
        StateForm { on_force: self.reaction.map_or_else(|| self.on_force.clone(), row), ..self.clone() }
    }

    /// The deflection with the gradient `on_q`, minus the value `at`.
    pub(super) fn deflection(on_q: Vector, at: f64) -> Self {
        let none = Vector::zeros(on_q.len());
        StateForm { on_q, on_speed: none.clone(), on_force: none, reaction: None, constant: -at, margin: 0.0 }
    }

    /// Its value at coordinates and speeds, with the generalised forces that `force` gives.
    pub fn value(&self, q: &[f64], q_dot: &[f64], force: impl FnOnce() -> Vector) -> f64 {
        self.on_q.dot(q) + self.on_speed.dot(q_dot) + self.on_force.dot(&force()) + self.constant()
    }
}
