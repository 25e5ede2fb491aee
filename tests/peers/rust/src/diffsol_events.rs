//! diffsol with its root finding, restarted at every root.
//!
//! For a fair comparison one solver object does the whole run and is stepped by hand. The stiffness is in a `Cell` that the closures
//! share, so nothing is rebuilt. At a root the solver returns to the root, the jump is applied, and the step size is kept. The matrices
//! are small dense ones of nalgebra. Absolute tolerances are proportional to the sizes of the coordinates. diffsol's roots have no
//! direction: the index says which end of the cell was met.

use std::cell::Cell;

use anyhow::bail;
use diffsol::Vector;
use diffsol::{NalgebraLU, NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason};

use crate::scene::{Motion, Scene};

type M = NalgebraMat<f64>;

macro_rules! problem {
    ($scene:expr, $here:expr, $tolerance:expr) => {
        OdeBuilder::<M>::new()
            .rtol($tolerance)
            .atol($scene.atol($tolerance))
            .p([])
            .rhs_implicit(
                |y, _p, _t, out| $scene.slope($here.get().0, y, out),
                |_y, _p, _t, v, out| $scene.slope_along($here.get().0, v, out),
            )
            .init(|_p, _t, y| y.copy_from_slice(&$scene.start), 4)
            .root(|y, _p, _t, out| out.copy_from_slice(&[y[0] - $here.get().1, y[0]]), 2)
            .build()
    };
}

/// A whole run by Tsitouras' explicit pair of order 5(4).
pub fn tsit45(scene: &Scene, tolerance: f64) -> anyhow::Result<Motion> {
    let here = Cell::new(scene.cell(0));
    let problem = problem!(scene, here, tolerance)?;
    run(scene, &here, problem.tsit45()?)
}

/// A whole run by backward differentiation formulae.
pub fn bdf(scene: &Scene, tolerance: f64) -> anyhow::Result<Motion> {
    let here = Cell::new(scene.cell(0));
    let problem = problem!(scene, here, tolerance)?;
    run(scene, &here, problem.bdf::<NalgebraLU<f64>>()?)
}

fn run<'a, Equations, Solver>(scene: &Scene, here: &Cell<(f64, f64)>, mut solver: Solver) -> anyhow::Result<Motion>
where
    Equations: OdeEquations<T = f64, V: Vector<T = f64>> + 'a,
    Solver: OdeSolverMethod<'a, Equations>,
{
    let mut motion = scene.begin();
    solver.set_stop_time(scene.t_end)?;
    loop {
        match solver.step()? {
            OdeSolverStopReason::RootFound(t, index) => {
                let y = solver.interpolate(t)?;
                motion.jump(scene, t, &read(&y), index == 0);
                here.set(scene.cell(motion.cell));
                solver.state_mut_back(t)?;
                let state = solver.state_mut();
                let mut slope = [0.0; 4];
                scene.slope(here.get().0, &motion.y, &mut slope);
                for i in 0..4 {
                    state.y.set_index(i, motion.y[i]);
                    state.dy.set_index(i, slope[i]);
                }
            }
            OdeSolverStopReason::TstopReached => {
                motion.y = read(solver.state().y);
                return Ok(motion);
            }
            OdeSolverStopReason::InternalTimestep => {
                if !read(solver.state().y).iter().all(|x| x.is_finite()) {
                    bail!("not finite at {} s", solver.state().t);
                }
            }
        }
    }
}

fn read(y: &impl Vector<T = f64>) -> [f64; 4] {
    std::array::from_fn(|i| y.get_index(i))
}
