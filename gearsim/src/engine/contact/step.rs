//! The step dV of V at a boundary, and where it vanishes.

use nalgebra::DMatrix;

use crate::engine::cells::Stand;
use crate::engine::contact::watch::StateForm;
use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::law;
use crate::engine::record::State;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::events::{DOUBLE_ZERO, ONE_DEFLECTION, QUADRATIC_STEP};

/// Whether dV of a law is zero at every state in the present cell, because the deflection that it strains is out of contact.
pub fn is_void(equations: &dyn Equations, stand: Stand<'_>, law: (usize, Side), state: &State) -> bool {
    StepOfV::new(equations, stand, law, state)
        .is_some_and(|StepOfV { stiffness, load, .. }| stiffness.amax() == 0.0 && load.amax() == 0.0)
}

/// The step of V at a boundary, dV = q.dK q/2 - df.q + h.
struct StepOfV {
    /// dK (n x n).
    stiffness: Matrix,
    /// df (n).
    load: Vector,
    /// h.
    at_zero: f64,
}

impl StepOfV {
    /// The step of a law at a side of its cell. `None` if dV is not quadratic in the coordinates.
    fn new(equations: &dyn Equations, stand: Stand<'_>, (law, side): (usize, Side), state: &State) -> Option<Self> {
        let (beyond, k, q) = (law::beyond(equations, stand, law, side, state), stand.2, &state.q);
        let stiffness = equations.stiffness(&beyond) - equations.stiffness(k);
        let load = equations.load(&beyond) - &equations.load(k);
        let still = Vector::zeros(load.len());
        let dv = |q: &[f64]| equations.potential(q, &beyond) - equations.potential(q, k);
        let at_zero = dv(&still);
        let (bent, pulled) = (0.5 * q.dot(&(&stiffness * q)), load.dot(q));
        let size = equations.potential(q, &beyond).abs() + bent.abs() + pulled.abs() + at_zero.abs();
        let error = dv(q) - (bent - pulled + at_zero);
        (error.abs() <= QUADRATIC_STEP * size).then_some(StepOfV { stiffness, load, at_zero })
    }
}

/// Linear functions of the coordinates that are zero where the step dV = q.dK q/2 - df.q + h at a boundary of a law is zero:
/// - for a transmission error dK = 0, and dV itself is linear;
/// - for the stiffness of one deflection x = d.q, dV = c x²/2 - g x + h with dK = c d dᵀ and df = g d, one function for each root x.
///
/// The list is empty if the law strains several deflections, which are not zero together, or if dV is not of this form. Laws of other
/// phases have their present values.
pub fn barriers(equations: &dyn Equations, stand: Stand<'_>, law: usize, side: Side, state: &State) -> Vec<StateForm> {
    let Some(StepOfV { stiffness, load, at_zero: h }) = StepOfV::new(equations, stand, (law, side), state) else {
        return vec![];
    };
    let n = load.len();
    if stiffness.amax() == 0.0 {
        return vec![StateForm::deflection(-load, -h)];
    }
    let diagonal = stiffness.diagonal();
    let row = diagonal.iamax();
    let c = diagonal[row];
    let d = Vector::from_fn(n, |i| stiffness[(i, row)] / c);
    let g = load[row];
    let one = DMatrix::from_fn(n, n, |i, j| c * d[i] * d[j]);
    let of_one = (&stiffness - one).amax() <= ONE_DEFLECTION * stiffness.amax()
        && (&load - &(&d * g)).amax() <= ONE_DEFLECTION * load.amax();
    if !of_one {
        return vec![];
    }
    let (middle, square) = (g / c, (g / c).powi(2) - 2.0 * h / c);
    let at = |x: f64| StateForm::deflection(d.clone(), x);
    match square.abs() <= DOUBLE_ZERO * middle.powi(2) {
        true => vec![at(middle)],
        false if square < 0.0 => vec![],
        false => vec![at(middle - square.sqrt()), at(middle + square.sqrt())],
    }
}
