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
/// balance, K q = f in their rows, the other coordinates given; in a nonlinear model, where their forces F vanish.
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
        match scene.model.nonlinear {
            "" => {
                for (i, x) in free.iter().zip(balance(equations, scene, &free, &state.q, &k)?) {
                    state.q[*i] = x;
                }
            }
            _ => rest(equations, scene, &free, &mut state.q, &k)?,
        }
    }
    Ok((state, laws))
}

/// Newton's steps for an equilibrium, and the part of the first one below which the last counts as none.
const MOST_STEPS: usize = 100;
const AT_REST: f64 = 1e-14;

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
        // M q'' = F: the derivatives of F by q are M times those of the accelerations.
        let mass = DMatrix::from_fn(N, N, |i, j| equations.mass()[i][j]);
        let [by_q, _] = equations.jacobian(&(*q).into(), &[0.0; N], k, &flat, &flat);
        let slopes = mass * DMatrix::from_fn(N, N, |i, j| by_q[i][j]);
        let slopes = DMatrix::from_fn(free.len(), free.len(), |i, j| slopes[(free[i], free[j])]);
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
    let (stiffness, load) = (equations.stiffness(k), equations.load());
    let k = DMatrix::from_fn(free.len(), free.len(), |i, j| stiffness[free[i]][free[j]]);
    let f = DVector::from_fn(free.len(), |i, _| {
        load[free[i]] - (0..N).filter(|j| !free.contains(j)).map(|j| stiffness[free[i]][j] * q[j]).sum::<f64>()
    });
    let balanced = k.lu().solve(&f).filter(|x| x.iter().all(|x| x.is_finite()));
    let balanced = balanced.ok_or_else(|| no_equilibrium(scene, free))?;
    Ok(balanced.iter().copied().collect())
}
