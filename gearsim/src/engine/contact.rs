//! Held contact: a phase pressed against a step that it cannot climb, from when its bounces no longer count.
//!
//! Each reflection keeps the normal speed, damping takes from it, and the bounces come ever faster. Once the energy of
//! the normal motion E = v²/(2 G) is below [`HOLD`] of all energy and a bounce is short, the phase is held where it is:
//! n.q' = 0, under the reaction R. What is ignored is E at each hold; it is counted, and its sum is in the account.
//! The hold ends when
//! - R pulls, by [`RELEASE`] of the forces that make it up: the phase leaves the step it came from;
//! - the step vanishes, dV = 0: the phase slips through without loss;
//! - a step of another stiffness gives an impulse: what is held is let go, and bounces or leaves.

use nalgebra::{DMatrix, DVector, SVector};

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::cells::Prepared;
use crate::engine::crossing::{Cost, Lost, Search, Side};
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::{self, Law};
use crate::engine::record::State;
use crate::engine::signal::Signal;

/// Energy of the normal motion, relative to T + V, below which a pressed phase is held.
pub const HOLD: f64 = 1e-12;
/// A bounce is short if its time, times the fastest rate of the cell, is below this.
pub const SHORT: f64 = 1e-3;
/// A reaction pulls if it is below zero by this part of the forces that make it up.
pub const RELEASE: f64 = 1e-9;

/// What ends a hold of one law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The reaction pulls: the phase leaves.
    Release,
    /// The step has vanished: the phase slips through.
    Slip,
}

/// Phases held at steps, and the motion that is left.
#[derive(Debug, Clone)]
pub struct Contact<const N: usize> {
    /// The laws held, and at which side of their cell.
    pub laws: Vec<(usize, Side)>,
    /// The motion with the phases held.
    pub left: Prepared<N>,
    watches: Vec<Watch<N>>,
}

/// A linear function of the state whose first zero ends a hold.
#[derive(Debug, Clone)]
struct Watch<const N: usize> {
    law: usize,
    ending: Ending,
    /// Its value is constant + on_q.q + on_speed.q'.
    on_q: SVector<f64, N>,
    on_speed: SVector<f64, N>,
    constant: f64,
    /// The same for modes.
    modal: (SVector<f64, N>, SVector<f64, N>),
}

/// Whether a phase that was just turned back at `side` is pressed against the step so hard, and bounces so little, that
/// it is to be held. `acceleration` is q'' now, `rate` bounds the rates of the cell, `energy` is T + V.
pub fn presses<const N: usize>(
    law: &Law<N>,
    side: Side,
    state: &State<N>,
    acceleration: &SVector<f64, N>,
    rate: f64,
    energy: f64,
) -> bool {
    let v = law.surface.normal.dot(&state.q_dot).abs();
    let a = side.sign() * law.surface.normal.dot(acceleration);
    a > 0.0 && v * v <= HOLD * energy * 2.0 * law.surface.compliance && 2.0 * v * rate <= SHORT * a
}

impl<const N: usize> Contact<N> {
    /// Holds the phases of `held`, those of them whose reactions press; `None` if none does. Brings the normal speeds
    /// to rest and gives the energy that this ignores [J].
    ///
    /// # Errors
    /// Where the motion that is left has no modes.
    pub fn begin(
        equations: &dyn Equations<N>,
        laws: &[Law<N>],
        mut held: Vec<(usize, Side)>,
        state: &mut State<N>,
    ) -> Result<(Option<Self>, f64), Refusal> {
        let k: Vec<f64> = laws.iter().map(Law::level).collect();
        loop {
            if held.is_empty() {
                return Ok((None, 0.0));
            }
            // Outward normals, and the reactions (nᵀM⁻¹n)⁻¹ nᵀM⁻¹ (f - K q - C q') along them.
            let normals = DMatrix::from_fn(N, held.len(), |i, c| {
                let (law, side) = held[c];
                side.sign() * laws[law].surface.normal[i]
            });
            let matrix = |rows: [[f64; N]; N]| DMatrix::from_fn(N, N, |i, j| rows[i][j]);
            let mass = matrix(equations.mass()).cholesky().ok_or(Refusal::Mass)?;
            let mobility = mass.solve(&normals);
            let compliance = (normals.transpose() * &mobility).cholesky().ok_or(Refusal::Mass)?;
            let to_reactions = compliance.solve(&mobility.transpose());
            let (stiffness, damping) = (matrix(equations.stiffness(&k)), matrix(equations.damping()));
            let load = DVector::from_row_slice(&equations.load());

            let reactions: Vec<Watch<N>> = held
                .iter()
                .enumerate()
                .map(|(c, &(law, _))| {
                    let w = to_reactions.rows(c, 1);
                    let row = |m: DMatrix<f64>| SVector::<f64, N>::from_fn(|i, _| -m[(0, i)]);
                    let (on_q, on_speed) = (row(w * &stiffness), row(w * &damping));
                    let loaded = (w * &load)[0];
                    let forces = loaded.abs() + on_q.abs().dot(&state.q.abs()) + on_speed.abs().dot(&state.q_dot.abs());
                    // Its zero is where it pulls by RELEASE.
                    let constant = loaded + RELEASE * forces;
                    let modal = (SVector::zeros(), SVector::zeros());
                    Watch { law, ending: Ending::Release, on_q, on_speed, constant, modal }
                })
                .collect();
            if let Some(pulls) = reactions.iter().position(|w| w.value(state) <= 0.0) {
                held.remove(pulls);
                continue;
            }

            let speeds = normals.transpose() * DVector::from_iterator(N, state.q_dot.iter().copied());
            let impulses = compliance.solve(&speeds);
            let change = mobility * &impulses;
            state.q_dot -= SVector::from_fn(|i, _| change[i]);
            let ignored = 0.5 * speeds.dot(&impulses);

            let cell = Cell::held(equations, &k, &normals)?;
            let barriers = held.iter().filter_map(|&(law, side)| barrier(equations, laws, law, side, state, &k));
            let mut watches: Vec<Watch<N>> = reactions.into_iter().chain(barriers).collect();
            for watch in &mut watches {
                let (on_moved, on_speed) = cell.follow(&watch.on_q, Some(&watch.on_speed));
                watch.modal = (on_moved, on_speed.unwrap_or_else(SVector::zeros));
            }
            let left = Prepared::new(cell, laws);
            return Ok((Some(Contact { laws: held, left, watches }), ignored));
        }
    }

    /// Whether a law's phase is held.
    pub fn holds(&self, law: usize) -> bool {
        self.laws.iter().any(|l| l.0 == law)
    }

    /// The first end of a hold before the horizon, with `point` moved there.
    ///
    /// # Errors
    /// Where the search does not end, or leaves the numbers.
    pub fn first_ending(
        &self,
        flight: &Flight<'_, N>,
        state: &State<N>,
        mut horizon: f64,
        point: &mut Point<N>,
        cost: &mut Cost,
    ) -> Result<Option<(usize, Ending)>, Lost> {
        let mut first = None;
        for watch in &self.watches {
            let value = watch.value(state);
            let (down, up) = if value >= 0.0 { (value, f64::INFINITY) } else { (f64::INFINITY, -value) };
            let on_speed = watch.modal.1.iter().any(|x| *x != 0.0).then_some(&watch.modal.1);
            let signal = Signal { flight, on_moved: &watch.modal.0, on_speed };
            let mut trial = flight.begin();
            if (Search { signal, rate: signal.derivatives(&trial)[1], down, up, horizon })
                .first(&mut trial, cost)?
                .is_some()
            {
                (horizon, first) = (trial.t, Some((watch.law, watch.ending)));
                *point = trial;
            }
        }
        Ok(first)
    }
}

impl<const N: usize> Watch<N> {
    fn value(&self, state: &State<N>) -> f64 {
        self.constant + self.on_q.dot(&state.q) + self.on_speed.dot(&state.q_dot)
    }
}

/// The deflection whose zero makes the step of a law vanish: dV = c (d.q)². `None` where the law strains more than one
/// deflection: they do not vanish together.
fn barrier<const N: usize>(
    equations: &dyn Equations<N>,
    laws: &[Law<N>],
    law: usize,
    side: Side,
    state: &State<N>,
    k: &[f64],
) -> Option<Watch<N>> {
    let mut beyond = k.to_vec();
    law::met(laws, law, side, state).for_each(|i| beyond[i] += laws[i].step(side));
    let (here, there) = (equations.stiffness(k), equations.stiffness(&beyond));
    let step = DMatrix::from_fn(N, N, |i, j| there[i][j] - here[i][j]);
    let row = (0..N).max_by(|&a, &b| step[(a, a)].abs().total_cmp(&step[(b, b)].abs()))?;
    let d = step.row(row).transpose() / step[(row, row)];
    let one = &d * d.transpose() * step[(row, row)];
    let rank_one = (&step - one).amax() <= 1e-10 * step.amax();
    let zero = SVector::zeros();
    rank_one.then(|| Watch {
        law,
        ending: Ending::Slip,
        on_q: SVector::from_fn(|i, _| d[i]),
        on_speed: zero,
        constant: 0.0,
        modal: (zero, zero),
    })
}
