//! Held contact: a phase pressed against a step that it cannot climb, from when its bounces no longer count.
//!
//! Each reflection keeps the normal speed, damping takes from it, and the bounces come ever faster. Once the energy of
//! the normal motion E = v²/(2 G) is below [`HOLD`] of all energy and a bounce is short, the phase is held where it is:
//! n.q' = 0, under the reaction R. What is ignored is E at each hold; it is counted, and its sum is in the account.
//! The hold ends when
//! - R pulls, by [`RELEASE`] of the forces that make it up: the phase leaves the step it came from;
//! - the step vanishes, dV = 0: the phase slips through without loss; with play, that is also where the flanks beyond it part;
//! - a step of another stiffness gives an impulse: what is held is let go, and bounces or leaves.

use nalgebra::{DMatrix, DVector};

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::cells::{Prepared, Stand};
use crate::engine::crossing::{Cost, Lost, Side};
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::forcing::linear::Linear;
use crate::engine::forcing::window::Window;
use crate::engine::law::{self, Law};
use crate::engine::record::State;
use crate::engine::vector::{Matrix, Vector};
use crate::engine::watch::Watch;

/// Energy of the normal motion, relative to T + V, below which a pressed phase is held.
pub const HOLD: f64 = 1e-12;
/// A bounce is short if its time, times the fastest rate of the cell, is below this.
pub const SHORT: f64 = 1e-3;
/// A reaction pulls if it is below zero by this part of the forces that make it up.
pub const RELEASE: f64 = 1e-9;

/// Relative difference that is rounding.
const SAME: f64 = 1e-10;

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
pub struct Contact {
    /// The laws held, and at which side of their cell.
    pub laws: Vec<(usize, Side)>,
    /// The motion with the phases held.
    pub left: Prepared,
    /// The same, where torques vary.
    pub linear: Linear,
    /// Forces beside the equations' load as the hold began (N).
    further: Vector,
    watches: Vec<Ends>,
}

/// What can end the hold of a law.
#[derive(Debug, Clone)]
struct Ends {
    law: usize,
    ending: Ending,
    watch: Watch,
    /// How its value changes with the load.
    on_load: Vector,
}

/// Whether a phase that was just turned back at `side` is pressed against the step so hard, and bounces so little, that
/// it is to be held. `acceleration` is q'' now, `rate` bounds the rates of the cell, `energy` is T + V.
pub fn presses(law: &Law, side: Side, state: &State, acceleration: &Vector, rate: f64, energy: f64) -> bool {
    let v = law.surface.normal.dot(&state.q_dot).abs();
    let a = side.sign() * law.surface.normal.dot(acceleration);
    a > 0.0 && v * v <= HOLD * energy * 2.0 * law.surface.compliance && 2.0 * v * rate <= SHORT * a
}

impl Contact {
    /// Holds the phases of `held`, those of them whose reactions press; `None` if none does. Brings the normal speeds
    /// to rest and gives the energy that this ignores [J].
    ///
    /// # Errors
    /// Where the motion that is left has no modes.
    pub fn begin(
        equations: &dyn Equations,
        (laws, bands, k): Stand<'_>,
        mut held: Vec<(usize, Side)>,
        state: &mut State,
        further: &Vector,
    ) -> Result<(Option<Self>, f64), Refusal> {
        loop {
            if held.is_empty() {
                return Ok((None, 0.0));
            }
            // Outward normals, and the reactions (nᵀM⁻¹n)⁻¹ nᵀM⁻¹ (f - K q - C q') along them.
            let n = state.q.len();
            let normals = DMatrix::from_fn(n, held.len(), |i, c| {
                let (law, side) = held[c];
                side.sign() * laws[law].surface.normal[i]
            });
            let mass = equations.mass().cholesky().ok_or(Refusal::Mass)?;
            let mobility = mass.solve(&normals);
            let compliance = (normals.transpose() * &mobility).cholesky().ok_or(Refusal::Mass)?;
            let to_reactions = compliance.solve(&mobility.transpose());
            let (stiffness, damping) = (equations.stiffness(k), equations.damping(k));
            let load = equations.load(k);
            let load = DVector::from(&(load + further));

            let (cell, linear) = Cell::held(equations, k, &normals)?;
            let reactions: Vec<_> = held
                .iter()
                .enumerate()
                .map(|(c, &(law, _))| {
                    let w = to_reactions.rows(c, 1);
                    let row = |m: Matrix| Vector::from_fn(n, |i| -m[(0, i)]);
                    let (on_q, on_speed) = (row(w * &stiffness), row(w * &damping));
                    let loaded = (w * &load)[0];
                    let forces = loaded.abs() + on_q.abs().dot(&state.q.abs()) + on_speed.abs().dot(&state.q_dot.abs());
                    // Its zero is where it pulls by RELEASE.
                    let constant = loaded + RELEASE * forces;
                    let on_load = Vector::from_fn(n, |i| w[(0, i)]);
                    let watch = Watch::new(&cell, constant, on_q, on_speed);
                    Ends { law, ending: Ending::Release, watch, on_load }
                })
                .collect();
            if let Some(pulls) = reactions.iter().position(|w| w.watch.value(state) <= 0.0) {
                held.remove(pulls);
                continue;
            }

            let speeds = normals.transpose() * DVector::from(&state.q_dot);
            let impulses = compliance.solve(&speeds);
            let change = mobility * &impulses;
            state.q_dot -= &Vector::from(&change);
            state.lost = Vector::zeros(n);
            let ignored = 0.5 * speeds.dot(&impulses);

            let slips = held.iter().flat_map(|&(law, side)| {
                let watches = barriers(equations, (laws, bands, k), &cell, law, side, state).into_iter();
                watches.map(move |watch| Ends { law, ending: Ending::Slip, watch, on_load: Vector::zeros(n) })
            });
            let watches = reactions.into_iter().chain(slips).collect();
            let left = Prepared::new(cell, equations, (laws, bands, k));
            let contact = Contact { laws: held, left, linear, further: further.clone(), watches };
            return Ok((Some(contact), ignored));
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
        flight: &Flight<'_>,
        state: &State,
        mut horizon: f64,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<Option<(usize, Ending)>, Lost> {
        let mut first = None;
        for Ends { law, ending, watch, .. } in &self.watches {
            let mut trial = flight.begin();
            if watch.first_zero(watch.value(state), flight, horizon, &mut trial, cost)? {
                (horizon, first) = (trial.t, Some((*law, *ending)));
                *point = trial;
            }
        }
        Ok(first)
    }

    /// The first end of a hold in a window, before its part `until`: where, and which.
    pub fn first_in(
        &self,
        window: &Window<'_>,
        state: &State,
        load: &Vector,
        mut until: f64,
        cost: &mut Cost,
    ) -> Option<(f64, usize, Ending)> {
        let mut first = None;
        for Ends { law, ending, watch, on_load } in &self.watches {
            let value = watch.value(state) + on_load.dot(&(load - &self.further));
            let zero = watch.first_zero_in(value, on_load, window, cost);
            if let Some(x) = zero.filter(|x| *x < until) {
                (until, first) = (x, Some((x, *law, *ending)));
            }
        }
        first
    }
}

/// Whether a step of a law is none in the present cell, whatever the state: what it strains is out of contact.
pub fn is_void(equations: &dyn Equations, stand: Stand<'_>, (law, side): (usize, Side), state: &State) -> bool {
    let (beyond, k) = (law::beyond(stand, law, side, state), stand.2);
    equations.stiffness(k) == equations.stiffness(&beyond) && equations.load(k) == equations.load(&beyond)
}

/// What vanishes with the step of a law: of dV = q.dK q/2 - df.q + h
/// - that of a transmission error, dK = 0: it is linear;
/// - that of the stiffness of one deflection x = d.q, c x²/2 - g x + h with dK = c d dᵀ and df = g d, each of its zeros; of a
///   mere stiffness it is c (x - e)²/2.
///
/// Nothing where the law strains more than one deflection: they do not vanish together.
fn barriers(
    equations: &dyn Equations,
    stand: Stand<'_>,
    cell: &Cell,
    law: usize,
    side: Side,
    state: &State,
) -> Vec<Watch> {
    let (beyond, k) = (law::beyond(stand, law, side, state), stand.2);
    let (here, there) = (equations.stiffness(k), equations.stiffness(&beyond));
    let (load_here, load_there) = (equations.load(k), equations.load(&beyond));
    let (stiffness, load) = (there - here, load_there - &load_here);
    let n = load.len();
    let still = Vector::zeros(n);
    let h = equations.potential(&still, &beyond) - equations.potential(&still, k);
    if stiffness.amax() == 0.0 {
        return vec![Watch::new(cell, h, -load, still)];
    }
    let diagonal = stiffness.diagonal();
    let row = diagonal.iamax();
    let c = diagonal[row];
    let d = Vector::from_fn(n, |i| stiffness[(i, row)] / c);
    let g = load[row];
    let one = DMatrix::from_fn(n, n, |i, j| c * d[i] * d[j]);
    let of_one =
        (&stiffness - one).amax() <= SAME * stiffness.amax() && (&load - &(&d * g)).amax() <= SAME * load.amax();
    if !of_one {
        return vec![];
    }
    let (middle, square) = (g / c, (g / c).powi(2) - 2.0 * h / c);
    let at = |x: f64| Watch::new(cell, -x, d.clone(), still.clone());
    match square.abs() <= SAME * middle.powi(2) {
        true => vec![at(middle)],
        false if square < 0.0 => vec![],
        false => vec![at(middle - square.sqrt()), at(middle + square.sqrt())],
    }
}
