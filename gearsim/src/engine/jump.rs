//! The change of the speeds at a step of a stiffness: Eqs. (9) and (11) of Oh, Grosh & Barber (2005), in any number of
//! coordinates.
//!
//! With the normal speed v = n.q', the compliance G = n.M⁻¹n and the step of the potential energy dV at the same q: v+² = v² - 2 G dV. If
//! v+² >= 0, the motion is transmitted with q'+ = q' + (M⁻¹n/G)(v+ - v); otherwise it is reflected with v+ = -v. Only v+² decides; zero
//! counts as transmission. Steps of several laws at the same place of the same phase are one step, with the sum of their dV.

use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::vector::Vector;

/// The outcome of an impulse at a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passage {
    /// Transmission: the motion continues in the next cell.
    Transmitted,
    /// Reflection: the energy is not sufficient, and the motion turns back.
    Reflected,
}

/// The geometry of the steps of one law. It is constant during a run, unless M depends on the coordinates: then G and M⁻¹n are those of the
/// last event.
#[derive(Debug, Clone)]
pub struct Surface {
    /// Gradient n of the phase (n).
    pub normal: Vector,
    /// G = n.M⁻¹n.
    pub compliance: f64,
    /// M⁻¹n / G (n).
    pub direction: Vector,
}

impl Surface {
    /// The surface of law `law` at the coordinates `q`.
    pub fn new(equations: &dyn Equations, law: usize, q: &[f64]) -> Self {
        Surface {
            normal: equations.normal(law),
            compliance: equations.compliance(law, q),
            direction: equations.direction(law, q),
        }
    }

    /// The change of the speeds (n) at a step of the potential energy by `dv` [J] on the way to `side`.
    #[inline]
    pub fn jump(&self, q_dot: &Vector, side: Side, dv: f64) -> (Passage, Vector) {
        let v = self.normal.dot(q_dot);
        // v² - v+².
        let drop = 2.0 * self.compliance * dv;
        let square = v * v - drop;
        if square < 0.0 {
            return (Passage::Reflected, &self.direction * (-2.0 * v));
        }
        // v+ - v, computed without cancellation. Both have the direction of `side`, or are zero.
        let after = square.sqrt();
        let gained = if after > 0.0 || v != 0.0 { side.sign() * -drop / (after + v.abs()) } else { 0.0 };
        (Passage::Transmitted, &self.direction * gained)
    }

    /// Applies the change of [`Surface::jump`] to the speeds.
    pub fn pass(&self, q_dot: &mut Vector, side: Side, dv: f64) -> Passage {
        let (passage, gained) = self.jump(q_dot, side, dv);
        *q_dot += &gained;
        passage
    }
}
