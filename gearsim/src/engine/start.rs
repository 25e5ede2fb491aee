//! The state at t = 0 from the start that a scene states.

mod equilibrium;

use crate::engine::crossing::Side;
use crate::engine::dead_band::{DeadBand, Grip, Regime};
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::{self, Law};
use crate::engine::record::State;
use crate::engine::vector::Vector;
use crate::scene::Scene;

use equilibrium::{Equilibrium, Settled, courses};

/// A start: the state, the laws in their cells, and the dead bands in their regimes.
#[derive(Clone)]
pub struct Begun {
    pub state: State,
    pub laws: Vec<Law>,
    pub bands: Vec<DeadBand>,
    /// Other static equilibria that were found, in words; `None` if there are none, or no static start is asked for.
    pub others: Option<String>,
}

impl Begun {
    /// The coordinates, with their whole turns (N).
    pub fn absolute(&self) -> Vector {
        self.state.unwrapped(&law::turn_lengths(self.state.q.len(), &self.laws))
    }
}

/// The state at the start.
///
/// The speeds are those given, otherwise those of the rigid motions. Coordinates with the value `static` are where the
/// generalised forces on them vanish; the other coordinates and the speeds have the given values, and each law is in the cell of
/// its phase. With play, the contacts are at the flanks that the forces press together. If there are several equilibria, it is
/// the one found from the stated value, or from zero.
///
/// # Errors
/// If the forces do not determine the equilibrium, or a phase is too large.
pub fn begin(equations: &dyn Equations, scene: &Scene) -> Result<Begun, Refusal> {
    let n = equations.coordinates();
    let mut q_dot = Vector::zeros(n);
    for (i, size) in scene.start.motions.iter().enumerate() {
        q_dot.add_times(*size, &equations.motion(i));
    }
    for (i, given) in scene.start.q_dot.iter().enumerate() {
        if let Some(given) = given {
            q_dot[i] = *given;
        }
    }
    let guess = Vector::from_fn(n, |i| scene.start.q[i].guess());
    let free: Vec<usize> = (0..n).filter(|&i| scene.start.q[i].is_static()).collect();
    let mut bands = DeadBand::all(equations, scene.model);
    let (mut state, mut others) = (State::new(guess.clone(), q_dot.clone()), None);
    let laws = if free.is_empty() {
        Law::begin(equations, scene, &mut state)?
    } else {
        let balance = Equilibrium { equations, scene, free: &free, q_dot };
        let mut settled = on_flanks(scene, &mut bands, |bands| balance.from(&guess, bands))?;
        let found = balance.others(&settled, &guess, &bands);
        others = balance.describe(&settled, &found);
        if !settled.stable
            && let Some(nearest) = found.iter().find(|other| other.stable)
        {
            // The equilibrium is unstable: take the nearest stable one.
            others = balance.describe(nearest, &[&found[..], &[settled]].concat());
            settled = nearest.clone();
        }
        state = settled.state;
        settled.laws
    };

    let [mut k, ..] = courses(scene, &state, &laws);
    for band in &mut bands {
        band.follow(&k);
        let sides = [Side::Upper, Side::Lower].map(|side| (side, band.depth(side, &state.q)));
        let outwards = |side: Side| side.sign() * band.normal.dot(&state.q_dot) > 0.0;
        let resting = |side: Side| band.regime == Regime::Contact(side, Grip::Touch);
        let beyond = sides.into_iter().find(|&(side, x)| x > 0.0 || (x == 0.0 && (outwards(side) || resting(side))));
        band.regime = beyond.map_or(Regime::Free, |(side, _)| Regime::Contact(side, Grip::Touch));
    }
    bands.iter().for_each(|band| band.write(&mut k));
    for band in &mut bands {
        band.regime = band.gripped(band.elastic(equations, &k), &state.q, &state.q_dot);
    }
    Ok(Begun { state, laws, bands, others })
}

/// Finds the flanks at which dead bands are in contact. `settle` gives the equilibrium for given regimes of the bands. A band
/// that is not pressed against its drive flank is tried on the coast flank, and then free.
fn on_flanks(
    scene: &Scene,
    bands: &mut [DeadBand],
    mut settle: impl FnMut(&[DeadBand]) -> Result<Settled, Refusal>,
) -> Result<Settled, Refusal> {
    bands.iter_mut().for_each(|band| band.regime = Regime::Contact(Side::Upper, Grip::Touch));
    // Each band has at most three regimes to try. After that the last result is used.
    for _ in 0..=2 * bands.len() {
        let settled = settle(bands)?;
        let lifted = bands.iter_mut().find(|band| match band.regime {
            Regime::Contact(side, _) => settled.depth(scene, band, side) < 0.0,
            Regime::Free => false,
        });
        let Some(band) = lifted else { return Ok(settled) };
        band.regime = match band.regime {
            Regime::Contact(Side::Upper, grip) => Regime::Contact(Side::Lower, grip),
            _ => Regime::Free,
        };
    }
    settle(bands)
}
