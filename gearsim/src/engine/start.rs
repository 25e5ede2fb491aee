//! The state at t = 0 from what a scene says of it.

use nalgebra::{DMatrix, DVector, SVector};

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::phase::Pitch;
use crate::engine::record::State;
use crate::model::Start;
use crate::scene::Scene;

/// The state at the start, the whole pitches its phase has gone, and the cell it is in.
///
/// Speeds are those given, else those of the rigid motions. Coordinates said to be static are where their forces
/// balance, K q = f in their rows, the other coordinates given.
pub fn begin<const N: usize>(
    equations: &dyn Equations<N>,
    scene: &Scene,
    pitch: &Pitch,
    phase: usize,
    rolling: bool,
) -> Result<(State<N>, i64, usize), Refusal> {
    let mut q_dot = SVector::<f64, N>::zeros();
    for (i, size) in scene.start.motions.iter().enumerate() {
        q_dot += SVector::from(equations.motion(i)) * *size;
    }
    for (i, given) in scene.start.q_dot.iter().enumerate() {
        if let Some(given) = given {
            q_dot[i] = *given;
        }
    }
    let mut q = SVector::<f64, N>::from_fn(|i, _| match scene.start.q[i] {
        Start::At(x) => x,
        Start::Static => 0.0,
    });
    let (pitches, rest, cell) = pitch.locate(q[phase], q_dot[phase]);
    let mut turns = [0; N];
    if rolling {
        q[phase] = rest;
        turns[phase] = pitches;
    }

    let free: Vec<usize> = (0..N).filter(|&i| scene.start.q[i] == Start::Static).collect();
    let (stiffness, load) = (equations.stiffness(&[pitch.level(cell)]), equations.load());
    let k = DMatrix::from_fn(free.len(), free.len(), |i, j| stiffness[free[i]][free[j]]);
    let f = DVector::from_fn(free.len(), |i, _| {
        load[free[i]] - (0..N).filter(|j| !free.contains(j)).map(|j| stiffness[free[i]][j] * q[j]).sum::<f64>()
    });
    let balanced = k.lu().solve(&f).filter(|x| x.iter().all(|x| x.is_finite()));
    let balanced = balanced.ok_or_else(|| Refusal::NoEquilibrium {
        coordinates: free.iter().map(|&i| scene.model.coordinates[i].name).collect::<Vec<_>>().join(", "),
    })?;
    for (i, x) in free.iter().zip(balanced.iter()) {
        q[*i] = *x;
    }
    Ok((State { q, q_dot, turns }, pitches, cell))
}
