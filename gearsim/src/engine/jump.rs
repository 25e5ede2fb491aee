//! What the speeds do at a step of a stiffness: Eqs. (9), (11) of Oh, Grosh & Barber (2005), in any number of coordinates.
//!
//! v = n.q' is the normal speed, G = n.M⁻¹n, dV the step of potential energy at the same q:
//! v+² = v² - 2 G dV; transmitted with q'+ = q' + (M⁻¹n/G)(v+ - v) where that is >= 0, else reflected with v+ = -v.
//! One number decides. Equality transmits, with v+ = 0. Steps of several laws at the same place of the same phase are one
//! step, with the sum of their dV.

use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::vector::Vector;

/// What happened at a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passage {
    /// The motion went on into the next cell.
    Transmitted,
    /// The energy did not suffice: the motion turned back.
    Reflected,
}

/// The geometry of one law's steps, constant through a run.
#[derive(Debug, Clone)]
pub struct Surface {
    /// n, gradient of the phase (N).
    pub normal: Vector,
    /// G = n.M⁻¹n.
    pub compliance: f64,
    /// M⁻¹n / G (N).
    pub direction: Vector,
}

impl Surface {
    /// The surface of law `law`.
    pub fn new(equations: &dyn Equations, law: usize) -> Self {
        Surface {
            normal: equations.normal(law),
            compliance: equations.compliance(law),
            direction: equations.direction(law),
        }
    }

    /// What the speeds gain (N) at a step of the potential energy by `dv` [J], met on the way to `side`.
    #[inline]
    pub fn jump(&self, q_dot: &Vector, side: Side, dv: f64) -> (Passage, Vector) {
        let v = self.normal.dot(q_dot);
        let lost = 2.0 * self.compliance * dv;
        let square = v * v - lost;
        if square < 0.0 {
            return (Passage::Reflected, &self.direction * (-2.0 * v));
        }
        // v+ - v without cancellation; both lead to the side that is met, or are zero.
        let after = square.sqrt();
        let gained = if after > 0.0 || v != 0.0 { side.sign() * -lost / (after + v.abs()) } else { 0.0 };
        (Passage::Transmitted, &self.direction * gained)
    }

    /// Changes the speeds so.
    pub fn pass(&self, q_dot: &mut Vector, side: Side, dv: f64) -> Passage {
        let (passage, gained) = self.jump(q_dot, side, dv);
        *q_dot += &gained;
        passage
    }
}
