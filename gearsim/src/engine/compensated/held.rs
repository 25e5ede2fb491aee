//! Holds in double-double precision: the held motions, their reactions, and the guards that end the holds.
//!
//! The plain solver ends a hold a little late, when the reaction pulls by a margin of rounding errors
//! ([`RELEASE`](crate::tolerance::events::RELEASE)). The zero of the reaction lies before that time. It is computed here, and the free motion
//! starts there ([`Late`]).

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::State;
use super::cell::Cell;
use super::guard::{Guard, dot};
use super::step::StiffnessStep;
use crate::engine::contact::{Contact, Ending};
use crate::engine::crossing::Side;
use crate::engine::equations::{Affine, ExactCells};
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::End;
use crate::tolerance::events::DOUBLE_ZERO;

/// A cell in which motions are held.
#[derive(Debug)]
pub struct Held {
    /// The modes of the remaining motions.
    pub cell: Cell,
    /// The matrix that gives the reactions R from the forces F, one row for each hold, in the order of [`Contact`].
    to_reactions: DMatrix<Df64>,
    /// The steps at which the phases are held, in the order of [`Contact::laws`].
    steps: Vec<Option<StiffnessStep>>,
}

/// A hold that ended earlier than the plain engine noticed.
pub struct Late {
    /// The state where it ended.
    pub state: State,
    /// Time since then \[s\].
    pub by: Df64,
}

/// N, the gradients of the motions that a contact holds (one column of n numbers per hold).
pub fn normals(exact: &dyn ExactCells, now: &Hybrid<'_>, contact: &Contact, k: &[Df64]) -> DMatrix<Df64> {
    let n = now.state.q.len();
    let of_law = |&(law, side): &(usize, Side)| {
        let one = |i: usize| if i == now.laws[law].phase { side.sign() } else { 0.0 };
        DVector::from_fn(n, |i, _| Df64::from(one(i)))
    };
    let of_switch = |&(i, _): &(usize, usize)| exact.switched(now.switches[i].index, k).normal;
    let columns: Vec<_> = contact.laws.iter().map(of_law).chain(contact.switches.iter().map(of_switch)).collect();
    DMatrix::from_fn(n, columns.len(), |i, c| columns[c][i])
}

impl Held {
    /// The cell `held` with its reactions. `free` is the same cell without holds, `normals` are the gradients of the held motions, and
    /// `steps` the steps at which phases are held. `None` if the held motions are linearly dependent.
    pub fn new(held: Cell, free: &Cell, normals: &DMatrix<Df64>, steps: Vec<Option<StiffnessStep>>) -> Option<Self> {
        let response = free.mobility() * normals;
        let to_reactions = solve(normals.transpose() * &response, response.transpose())?;
        Some(Held { cell: held, to_reactions, steps })
    }

    /// Sets the held speeds of a state to zero.
    pub fn rest(&self, state: &mut State) {
        state.q_dot = &self.cell.shapes * (&self.cell.momentum * &state.q_dot);
    }

    /// The function whose zero ends a hold in the way `end`, for states close to `near`; `None` if there is none. `k` are the law values.
    pub fn guard(
        &self,
        exact: &dyn ExactCells,
        now: &Hybrid<'_>,
        k: &[Df64],
        (end, near): (End, &State),
    ) -> Option<Guard> {
        let contact = now.contact.as_ref()?;
        let matrices = &self.cell.matrices;
        let row = |c: usize| self.to_reactions.row(c).transpose();
        match end {
            End::Loose(i, mode) => {
                let switch = &now.switches[i];
                let exits = exact.exits(switch.index, switch.mode, k);
                let exit = exits.into_iter().find(|e| e.guard.on_reaction.hi() != 0.0 && e.beyond == mode)?;
                let c = contact.laws.len() + contact.switches.iter().position(|held| held.0 == i)?;
                let Affine { on_reaction, .. } = exit.guard;
                Some(Guard::affine(&exit.guard, k).with_forces(on_reaction, &row(c), matrices))
            }
            End::Hold(law, Ending::Release) => {
                let c = contact.laws.iter().position(|held| held.0 == law)?;
                let none = Affine::zero(now.state.q.len());
                Some(Guard::affine(&none, k).with_forces(Df64::from(1.0), &row(c), matrices))
            }
            End::Hold(law, Ending::Slip) => {
                let at = contact.laws.iter().position(|held| held.0 == law)?;
                self.steps[at].as_ref()?.zero(near)
            }
            _ => None,
        }
    }
}

/// A⁻¹B for a symmetric A, by Gauss-Jordan elimination; `None` if A is not positive definite.
fn solve(mut a: DMatrix<Df64>, mut b: DMatrix<Df64>) -> Option<DMatrix<Df64>> {
    let n = a.nrows();
    for i in 0..n {
        let pivot = a[(i, i)];
        if pivot.hi().is_nan() || pivot.hi() <= 0.0 {
            return None;
        }
        for x in a.row_mut(i).iter_mut().chain(b.row_mut(i).iter_mut()) {
            *x /= pivot;
        }
        for other in (0..n).filter(|other| *other != i) {
            let factor = a[(other, i)];
            for m in [&mut a, &mut b] {
                (0..m.ncols()).for_each(|j| m[(other, j)] = m[(other, j)] - factor * m[(i, j)]);
            }
        }
    }
    Some(b)
}

impl StiffnessStep {
    /// A linear function of the coordinates that has the same zero as this step, close to the state `near`. The step of a transmission
    /// error is itself linear. The step of the stiffness of one deflection is zero at two values of the deflection; the function is then
    /// the deflection minus the nearer value.
    fn zero(&self, near: &State) -> Option<Guard> {
        let StiffnessStep { stiffness, load, at_zero } = self;
        let n = load.len();
        let none = DVector::from_element(n, Df64::from(0.0));
        let guard = |on_q: DVector<Df64>, constant: Df64| {
            let (on_speed, on_force) = (none.clone(), none.clone());
            Some(Guard { constant, on_q, on_speed, on_force })
        };
        let row = (0..n).max_by(|&i, &j| stiffness[(i, i)].hi().abs().total_cmp(&stiffness[(j, j)].hi().abs()))?;
        let c = stiffness[(row, row)];
        if c.hi() == 0.0 {
            return guard(-load, *at_zero);
        }
        // dV = c x²/2 - g x + h with x = d.q.
        let d = stiffness.row(row).transpose() / c;
        let (middle, square) = (load[row] / c, (load[row] / c) * (load[row] / c) - *at_zero * 2.0 / c);
        let is_double = square.hi().abs() <= DOUBLE_ZERO * middle.hi() * middle.hi();
        let apart = if is_double || square.hi() < 0.0 { Df64::from(0.0) } else { square.sqrt() };
        let upper = dot(&d, &near.q).hi() > middle.hi();
        guard(d, -(if upper { middle + apart } else { middle - apart }))
    }
}
