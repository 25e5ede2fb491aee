//! The state at t = 0 from what a scene says of it.

use nalgebra::{DMatrix, DVector, SVector};

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::Law;
use crate::engine::record::State;
use crate::model::Start;
use crate::scene::Scene;

/// The state at the start, and the laws where they stand then.
///
/// Speeds are those given, else those of the rigid motions. Coordinates said to be static are where their forces
/// balance, K q = f in their rows, the other coordinates given.
///
/// # Errors
/// Where that balance is not determined, or a phase too far off.
pub fn begin<const N: usize>(equations: &dyn Equations<N>, scene: &Scene) -> Result<(State<N>, Vec<Law<N>>), Refusal> {
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
    let mut state = State { q, q_dot, turns: [0; N] };
    let laws = Law::begin(equations, scene, &mut state)?;

    let free: Vec<usize> = (0..N).filter(|&i| scene.start.q[i] == Start::Static).collect();
    if !free.is_empty() {
        let k: Vec<f64> = laws.iter().map(|law| law.course(state.q[law.phase], 0.0)[0]).collect();
        for (i, x) in free.iter().zip(balance(equations, scene, &free, &state.q, &k)?) {
            state.q[*i] = x;
        }
    }
    Ok((state, laws))
}

/// Where the coordinates `free` are in balance, the others where they are in `q`.
fn balance<const N: usize>(
    equations: &dyn Equations<N>,
    scene: &Scene,
    free: &[usize],
    q: &SVector<f64, N>,
    k: &[f64],
) -> Result<Vec<f64>, Refusal> {
    let (stiffness, load) = (equations.stiffness(k), equations.load());
    let k = DMatrix::from_fn(free.len(), free.len(), |i, j| stiffness[free[i]][free[j]]);
    let f = DVector::from_fn(free.len(), |i, _| {
        load[free[i]] - (0..N).filter(|j| !free.contains(j)).map(|j| stiffness[free[i]][j] * q[j]).sum::<f64>()
    });
    let balanced = k.lu().solve(&f).filter(|x| x.iter().all(|x| x.is_finite()));
    let balanced = balanced.ok_or_else(|| Refusal::NoEquilibrium {
        coordinates: free.iter().map(|&i| scene.model.coordinates[i].name).collect::<Vec<_>>().join(", "),
    })?;
    Ok(balanced.iter().copied().collect())
}
