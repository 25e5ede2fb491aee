//! Holds: motions that a reaction prevents. A phase is held at a step that it cannot pass, once its bounces are negligible. A switch may
//! hold its deflection (dry friction at rest, a locked clutch).
//!
//! **Phases.** Each reflection keeps the normal speed, damping reduces it, and the bounces become ever shorter. Once the energy of the
//! normal motion E = v²/(2 G) is below the part `HOLD_ENERGY` of the total energy and a bounce is short, the phase is held where it is:
//! n.q' = 0, with the reaction R. E is neglected at each hold. The sum of the neglected energies is in the energy account. The hold ends
//! when
//! - R pulls by more than the errors of the solver ([`Hybrid::release`]): the phase moves away from the step;
//! - the step vanishes, dV = 0: the phase slips through without loss (with play, the flanks separate in the cell beyond at the same place);
//! - a step of another stiffness gives an impulse: all held motions are released, and bounce or leave.
//!
//! **Deflections.** A switch enters a mode that holds where the rate of its deflection is zero. The guards of this mode are linear in the
//! reaction, and the hold ends at the zero of a guard. Friction and clutches transmit bounded forces, so they transmit no impulse: the
//! deflection slips after an impulse, and sticks again later.
//!
//! With the outward normals n of the held phases and the gradients of the held deflections as columns of N, the remaining motion has the
//! mobility P = M⁻¹ - M⁻¹N (NᵀM⁻¹N)⁻¹ NᵀM⁻¹, and the reactions to the generalised forces F are R = (NᵀM⁻¹N)⁻¹ NᵀM⁻¹ F. N is constant. If M
//! depends on the coordinates, P and the factors of F in R do too, and are computed where they are needed ([`held`]). The same is done if a
//! switch holds a rate in which friction laws are factors: N then changes with the motion ([`Turned`]).

use nalgebra::{DMatrix, DVector};

use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::hybrid::Hybrid;
use crate::engine::law::LawState;
use crate::engine::motion::End;
use crate::engine::record::State;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::events::{HOLD_ENERGY, SHORT_BOUNCE};
use holds::Holds;
use reaction::centripetal;

mod holds;
mod reaction;
mod step;
mod watch;

pub use reaction::{held, still};
pub use step::is_void;
pub use watch::{StateForm, Watch};

/// How the hold of a law ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The reaction pulls: the phase leaves.
    Release,
    /// The step has vanished: the phase slips through.
    Slip,
}

/// Phases held at steps, and deflections held by switches.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The held laws, each with the side of its cell at which it is held.
    pub laws: Vec<(usize, Side)>,
    /// The switches that hold their deflections, and the column of N that is the gradient of each.
    pub switches: Vec<(usize, usize)>,
    /// N: the outward normals of the laws, then the gradients of the deflections (one column of n numbers each).
    pub normals: DMatrix<f64>,
    /// P, the mobility of the remaining motion (n x n), at the place where the hold began.
    pub mobility: Matrix,
    /// The functions that can end the holds.
    pub watches: Vec<Watch>,
    /// Those of `switches` whose held rates have friction laws as factors, which vary while the phase moves.
    turning: Vec<(usize, usize)>,
    /// The switches that cannot move. Their own hold or other holds keep the rate constant that decides whether they hold.
    pub locked: Vec<usize>,
}

/// Held motions whose gradients vary: Nᵀq' = 0 gives Nᵀq'' = -N'ᵀq'. With the force c = N (NᵀM⁻¹N)⁻¹ N'ᵀq' the reactions are those to
/// F + c, and q'' = P F - M⁻¹ c.
pub struct Turned {
    /// N (one column of n numbers per hold).
    pub normals: DMatrix<f64>,
    /// c (n).
    pub force: Vector,
}

/// Whether a phase that was just reflected at `side` must be held: it is pressed against the step, and its bounces are negligible.
/// `acceleration` is q'' now, `rate` bounds the rates of the cell, `energy` is T + V.
pub fn presses(law: &LawState, side: Side, state: &State, acceleration: &Vector, rate: f64, energy: f64) -> bool {
    let v = law.surface.normal.dot(&state.q_dot).abs();
    let a = side.sign() * law.surface.normal.dot(acceleration);
    a > 0.0 && v * v <= HOLD_ENERGY * energy * 2.0 * law.surface.compliance && 2.0 * v * rate <= SHORT_BOUNCE * a
}

impl Contact {
    /// Holds the phases of `laws` whose reactions press, and the deflections of switches in modes that hold. A switch whose mode does not
    /// admit the reaction goes on to the next mode. Sets the held speeds to zero. Returns the holds, `None` if nothing is held, and the
    /// neglected energy \[J\].
    ///
    /// # Errors
    /// If the mass matrix is not positive definite.
    pub fn begin(now: &mut Hybrid<'_>, mut laws: Vec<(usize, Side)>) -> Result<(Option<Self>, f64), Refusal> {
        loop {
            let holds = Holds::new(now, &laws)?;
            if holds.held.is_empty() {
                return Ok((None, 0.0));
            }
            let watches = holds.watches(now);
            let State { q, q_dot, .. } = &now.state;
            let force = now.force() + &holds.centripetal(now);
            // A deflection at rest stays held if its reaction is exactly at its bound, because nothing moves it yet. Example: without load,
            // reaction and bound are both zero; a switch that left its hold here would enter it again at once. A deflection that moves does
            // not begin to stick at the bound.
            let rests = |switch: usize| now.switches[switch].is_at_rest(now.equations, (q, q_dot), &now.k);
            let pulls = |watch: &&Watch| {
                let left = watch.form.value(q, q_dot, || force.clone());
                match watch.end {
                    End::Hold(_, Ending::Slip) => false,
                    End::Loose(switch, _) => left < 0.0 || left == 0.0 && !rests(switch),
                    _ => left <= 0.0,
                }
            };
            match watches.iter().find(pulls) {
                Some(Watch { end: End::Loose(switch, mode), .. }) => {
                    let (switch, mode) = (*switch, *mode);
                    now.set_mode(switch, mode);
                }
                Some(Watch { end: End::Hold(law, _), .. }) => {
                    let law = *law;
                    laws.retain(|held| held.0 != law);
                }
                _ => return holds.begin(now, watches),
            }
        }
    }

    /// N and the force c at a state, if friction laws are factors of held rates; otherwise `None`. `k_dot` gives the rates of the law
    /// values `k`.
    pub fn turned(
        &self,
        (equations, switches): (&dyn Equations, &[Switch]),
        (q, q_dot): (&[f64], &[f64]),
        k: &[f64],
        k_dot: impl FnOnce() -> Vec<f64>,
    ) -> Option<Turned> {
        if self.turning.is_empty() {
            return None;
        }
        let k_dot = k_dot();
        let mut normals = self.normals.clone();
        let mut drift = DVector::zeros(normals.ncols());
        for &(switch, column) in &self.turning {
            let switch = &switches[switch];
            normals.set_column(column, &DVector::from(&switch.held(equations, q, k)));
            drift[column] = switch.drift(equations, (q, q_dot), &k_dot);
        }
        let force = centripetal(&equations.mobility(q), &normals, &drift);
        Some(Turned { normals, force })
    }

    /// Whether friction laws are factors of held rates.
    pub fn turns(&self) -> bool {
        !self.turning.is_empty()
    }

    /// Whether a law's phase is held.
    pub fn holds(&self, law: usize) -> bool {
        self.laws.iter().any(|l| l.0 == law)
    }
}
