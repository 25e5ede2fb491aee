//! The state at t = 0 from what a scene says of it.

use nalgebra::{DMatrix, DVector, SVector};

use crate::engine::crossing::Side;
use crate::engine::dead_band::{DeadBand, Grip, Regime};
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::Law;
use crate::engine::record::State;
use crate::model::Start;
use crate::scene::Scene;

/// The state at the start, and the laws and dead bands where they stand then.
///
/// Speeds are those given, else those of the rigid motions. Coordinates said to be static are where their forces
/// balance, K q = f in their rows, the other coordinates given; in a nonlinear model, where their forces F vanish. With play,
/// on the flanks that the forces press together.
///
/// # Errors
/// Where that balance is not determined, or a phase too far off.
pub fn begin<const N: usize>(equations: &dyn Equations<N>, scene: &Scene) -> Result<Begun<N>, Refusal> {
    let mut q_dot = SVector::<f64, N>::zeros();
    for (i, size) in scene.start.motions.iter().enumerate() {
        q_dot += SVector::from(equations.motion(i)) * *size;
    }
    for (i, given) in scene.start.q_dot.iter().enumerate() {
        if let Some(given) = given {
            q_dot[i] = *given;
        }
    }
    let q = SVector::<f64, N>::from_fn(|i, _| match scene.start.q[i] {
        Start::At(x) => x,
        Start::Static => 0.0,
    });
    let mut state = State::new(q, q_dot, [0; N]);
    let laws = Law::begin(equations, scene, &mut state)?;

    let free: Vec<usize> = (0..N).filter(|&i| scene.start.q[i] == Start::Static).collect();
    let mut bands = DeadBand::all(equations, scene.model);
    let mut k = scene.model.in_contact(laws.iter().map(|law| law.course(state.q[law.phase], 0.0)[0]));
    bands.iter_mut().for_each(|band| band.follow(&k));
    let linear = scene.effects.nonlinear(scene.model).is_empty();
    if !free.is_empty() {
        on_flanks(&mut bands, |bands| {
            bands.iter().for_each(|band| band.write(&mut k));
            if !linear {
                rest(equations, scene, &free, &mut state.q, &k)?;
                return Ok(state);
            }
            for (i, x) in free.iter().zip(balance(equations, scene, &free, &state.q, &k)?) {
                state.q[*i] = x;
            }
            Ok(state)
        })?;
    }
    for band in &mut bands {
        let sides = [Side::Upper, Side::Lower].map(|side| (side, band.depth(side, &state)));
        let outwards = |side: Side| side.sign() * band.normal.dot(&state.q_dot) > 0.0;
        let resting = |side: Side| band.regime == Regime::Contact(side, Grip::Touch);
        let beyond = sides.into_iter().find(|&(side, x)| x > 0.0 || (x == 0.0 && (outwards(side) || resting(side))));
        band.regime = beyond.map_or(Regime::Free, |(side, _)| Regime::Contact(side, Grip::Touch));
    }
    bands.iter().for_each(|band| band.write(&mut k));
    for band in &mut bands {
        band.regime = band.gripped(band.elastic(equations, &k), &state);
    }
    Ok((state, laws, bands))
}

/// Finds the flanks on which dead bands rest: `balanced` gives the state with them where they stand. A band that does not
/// press on its drive flank is tried on the other, then free.
fn on_flanks<const N: usize>(
    bands: &mut [DeadBand<N>],
    mut balanced: impl FnMut(&[DeadBand<N>]) -> Result<State<N>, Refusal>,
) -> Result<(), Refusal> {
    bands.iter_mut().for_each(|band| band.regime = Regime::Contact(Side::Upper, Grip::Touch));
    // Each band is tried in three places at most; then the last attempt stands.
    for _ in 0..=2 * bands.len() {
        let state = balanced(bands)?;
        let lifted = bands.iter_mut().find(|band| match band.regime {
            Regime::Contact(side, _) => band.depth(side, &state) < 0.0,
            Regime::Free => false,
        });
        let Some(band) = lifted else { break };
        band.regime = match band.regime {
            Regime::Contact(Side::Upper, grip) => Regime::Contact(Side::Lower, grip),
            _ => Regime::Free,
        };
    }
    Ok(())
}

/// The state at the start, the laws, the dead bands.
pub type Begun<const N: usize> = (State<N>, Vec<Law<N>>, Vec<DeadBand<N>>);

/// Newton's steps for an equilibrium, and the part of the first one below which the last counts as none.
const MOST_STEPS: usize = 100;
const AT_REST: f64 = 1e-14;
/// Part of a coordinate over which slopes are differences.
const DIFFERENCE: f64 = 1e-6;

/// Moves the coordinates `free` of a nonlinear model to where their forces vanish at rest, by Newton's method from `q`.
fn rest<const N: usize>(
    equations: &dyn Equations<N>,
    scene: &Scene,
    free: &[usize],
    q: &mut SVector<f64, N>,
    k: &[f64],
) -> Result<(), Refusal> {
    let flat = vec![0.0; k.len()];
    let forces = |q: &SVector<f64, N>| {
        let all = equations.force(&(*q).into(), &[0.0; N], k, &flat);
        DVector::from_fn(free.len(), |i, _| all[free[i]])
    };
    let mut largest = 0.0f64;
    for _ in 0..MOST_STEPS {
        // Slopes by differences: near enough for Newton's method to gain six digits a step.
        let mut slopes = DMatrix::zeros(free.len(), free.len());
        for (j, &coordinate) in free.iter().enumerate() {
            let h = DIFFERENCE * q[coordinate].abs().max(1e-3);
            let [mut below, mut above] = [*q, *q];
            (below[coordinate], above[coordinate]) = (q[coordinate] - h, q[coordinate] + h);
            slopes.set_column(j, &((forces(&above) - forces(&below)) / (2.0 * h)));
        }
        let step = slopes.lu().solve(&forces(q)).filter(|x| x.iter().all(|x| x.is_finite()));
        let Some(step) = step else { break };
        for (i, dx) in free.iter().zip(step.iter()) {
            q[*i] -= dx;
        }
        largest = largest.max(step.amax());
        if step.amax() <= AT_REST * largest {
            return Ok(());
        }
    }
    Err(no_equilibrium(scene, free))
}

fn no_equilibrium(scene: &Scene, free: &[usize]) -> Refusal {
    let names: Vec<_> = free.iter().map(|&i| scene.model.coordinates[i].name).collect();
    Refusal::NoEquilibrium { coordinates: names.join(", ") }
}

/// Where the coordinates `free` are in balance, the others where they are in `q`.
fn balance<const N: usize>(
    equations: &dyn Equations<N>,
    scene: &Scene,
    free: &[usize],
    q: &SVector<f64, N>,
    k: &[f64],
) -> Result<Vec<f64>, Refusal> {
    let (stiffness, load) = (equations.stiffness(k), equations.load(k));
    let k = DMatrix::from_fn(free.len(), free.len(), |i, j| stiffness[free[i]][free[j]]);
    let f = DVector::from_fn(free.len(), |i, _| {
        load[free[i]] - (0..N).filter(|j| !free.contains(j)).map(|j| stiffness[free[i]][j] * q[j]).sum::<f64>()
    });
    let balanced = k.lu().solve(&f).filter(|x| x.iter().all(|x| x.is_finite()));
    let balanced = balanced.ok_or_else(|| no_equilibrium(scene, free))?;
    Ok(balanced.iter().copied().collect())
}
