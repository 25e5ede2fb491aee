//! The step of the potential energy V at a boundary of a law, in double-double precision. For a phase that is held there, it is a quadratic
//! form in the coordinates.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::cells;
use crate::engine::crossing::Side;
use crate::engine::equations::{ExactCells, Matrices};
use crate::engine::hybrid::Hybrid;
use crate::engine::law;

/// The step of V from one cell to another one: dV = q.dK q/2 - df.q + h.
#[derive(Debug, Clone)]
pub struct StiffnessStep {
    /// dK (n x n).
    pub stiffness: DMatrix<Df64>,
    /// df (n). Loads that do not depend on the cell cancel.
    pub load: DVector<Df64>,
    /// h.
    pub at_zero: Df64,
}

impl StiffnessStep {
    /// From the cell `here` to the cell `beyond`.
    pub fn between(here: &Matrices<Df64>, beyond: &Matrices<Df64>) -> Self {
        StiffnessStep {
            stiffness: &beyond.stiffness - &here.stiffness,
            load: &beyond.load - &here.load,
            at_zero: beyond.at_zero - here.at_zero,
        }
    }
}

/// The change dV of the potential energy at the step of `law` that is met at `side` \[J\], at the coordinates `q`: as
/// [`law::barrier`] computes it.
pub fn barrier(exact: &dyn ExactCells, now: &Hybrid<'_>, law: usize, side: Side, q: &DVector<Df64>) -> Df64 {
    let (laws, state, q) = (&now.laws[..], &now.state, q.as_slice());
    let stand = (laws, &now.switches[..], &now.k[..]);
    let mut k = cells::values(exact, &now.switches, &now.k);
    if let Some(switches) = law::switches_beyond(now.equations, stand, law, side, state) {
        let mut beyond = now.k.clone();
        law::met(laws, law, side, state).for_each(|i| beyond[i] = laws[i].level_beyond(side));
        return exact.potential(q, &cells::values(exact, &switches, &beyond)) - exact.potential(q, &k);
    }
    let mut dv = Df64::from(0.0);
    for i in law::met(laws, law, side, state) {
        let step = Df64::from(laws[i].level_beyond(side)) - laws[i].level();
        dv += exact.step(i, q, &k, step);
        k[i] += step;
    }
    dv
}
