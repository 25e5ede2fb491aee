//! Guards along the dense output of a step.

use std::sync::LazyLock;

use smallvec::SmallVec;

use crate::engine::crossing::{Cost, Side};
use crate::engine::motion::Guard;
use crate::engine::root::{self, Found};
use crate::engine::vector::Matrix;
use crate::methods::dense::Polynomial;
use crate::tolerance::events::GRAZE_DEPTH;

use super::motion::Step;

/// Number of values through which a guard is interpolated if it is not linear in the state. It is the largest number of coefficients of a
/// dense output.
const NODES: usize = 8;

/// The points of these values, as fractions of the step: the Chebyshev points of \[0, 1\], including its ends.
fn node(i: usize) -> f64 {
    0.5 * (1.0 - (std::f64::consts::PI * i as f64 / (NODES - 1) as f64).cos())
}

/// The matrix that turns values at the nodes into the coefficients of the polynomial through them (NODES x NODES).
static THROUGH: LazyLock<Matrix> = LazyLock::new(|| {
    let powers = Matrix::from_fn(NODES, NODES, |i, j| node(i).powi(j as i32));
    powers.try_inverse().expect("the nodes are distinct")
});

impl Step<'_, '_> {
    /// The first root of a guard in the step, for each side: the side and the fraction of the step.
    pub(super) fn crossings(&mut self, guard: Guard, cost: &mut Cost) -> SmallVec<[(Side, f64); 2]> {
        let mut crossings = SmallVec::new();
        let mut note = |side, found: Found| {
            (cost.steps, cost.grazes) = (cost.steps + found.steps, cost.grazes + found.grazes);
            crossings.extend(found.root.map(|x| (side, x)));
        };
        match guard {
            Guard::Phase(i) => {
                let law = &self.now.laws[i];
                let slack = self.solver.control.slack()[law.phase];
                for side in [Side::Upper, Side::Lower] {
                    let gap = self.dense.gap(law.phase, law.boundary(side), side.sign());
                    note(side, root::first_known_to(&gap, 4.0 * law.rounding(), slack));
                }
            }
            Guard::Exit(i, which) => {
                let (side, exit) = (Side::Lower, &self.now.guards.exits[i][which]);
                let gap = if self.now.steps_only() {
                    self.dense.from(self.now.left_to(exit), [&exit.guard.on_q, &exit.guard.on_speed])
                } else {
                    let left = self.solver.field.left(guard, side, 0.0, &self.start);
                    self.interpolated(guard, side, left.max(0.0) + self.now.slack_of(exit))
                };
                // `rounding` is 16 eps of the terms of the guard. The tolerance of the root search is 4 eps, as for a phase.
                note(side, root::first(&gap, 0.25 * self.now.rounding(&exit.guard, self.solver.fastest)));
            }
            Guard::Hold(which) => {
                let left = self.now.left_of_hold(which);
                let side = if left >= 0.0 { Side::Lower } else { Side::Upper };
                let gap = self.interpolated(guard, side, left.abs());
                note(side, root::first(&gap, GRAZE_DEPTH * left.abs()));
            }
        }
        crossings
    }

    /// The guard for `side` as a polynomial in the fraction of the step. `left` is its value at the start of the step.
    fn interpolated(&mut self, guard: Guard, side: Side, left: f64) -> Polynomial {
        let mut values = [left; NODES];
        for (i, value) in values.iter_mut().enumerate() {
            let x = node(i);
            *value = self.solver.field.left(guard, side, x * self.h, &self.dense.at(x));
        }
        let row = |j: usize| (0..NODES).map(|i| THROUGH[(j, i)] * values[i]).sum();
        let mut through: Polynomial = (0..NODES).map(row).collect();
        through[0] = left;
        through
    }
}
