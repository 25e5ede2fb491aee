//! The energy account of a run: T + V - W + dissipated energy keeps its value of the start, or the result is wrong.

use std::fmt;

use crate::engine::equations::{Equations, Switching};
use crate::engine::law::LawState;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::scene::solver::Method;
use crate::tolerance::methods;

/// The account at the row with the largest residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Account {
    /// Energy unaccounted for \[J\].
    pub residual: f64,
    /// The largest part of the account in the run: T, V, the energy dissipated, or the work of a torque \[J\].
    pub largest: f64,
    /// Allowed ratio of the residual to `largest`.
    pub allowed: f64,
    /// Strain energy of the rounding errors of the coordinates \[J\]: a train at rest has no other energy.
    pub rounding: f64,
}

impl Account {
    /// The account of `run`, a run of `scene`; `None` where nothing was recorded.
    pub fn of(run: &Outcome, scene: &Scene, rounding: f64) -> Option<Account> {
        let trajectory = &run.trajectory;
        let residual =
            trajectory.residual.iter().copied().reduce(|m, x| if x.abs() > m.abs() || x.is_nan() { x } else { m })?;
        let method = Method::ALL.iter().find(|(_, name)| *name == run.solver.method).map(|(method, _)| *method);
        let allowed = match method {
            Some(Method::Exact) | None => methods::EXACT_RESIDUAL,
            Some(method) if method.has_fixed_steps() => methods::FIXED_STEP_RESIDUAL,
            Some(_) => methods::STEP_RESIDUAL * scene.solver.tolerance,
        };
        Some(Account { residual, largest: trajectory.largest_energy(), allowed, rounding })
    }

    /// Whether the residual is larger than the method allows.
    pub fn refutes(&self) -> bool {
        self.residual.is_nan() || self.residual.abs() > self.allowed * self.largest + self.rounding
    }
}

impl fmt::Display for Account {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Account { residual, largest, allowed, .. } = self;
        write!(
            f,
            "{residual:.2e} J are unaccounted for, {:.1e} of the largest part of its energy account ({largest:.3e} J), where its \
             method allows {allowed:.0e}. Lower run.tolerance or run.step, if the scene has them; else this is a mistake in gearsim",
            residual.abs() / largest
        )
    }
}

/// The strain energy of the rounding errors of the coordinates `q` (n), at the law values `k` \[J\]. Each is a sum of n modal coordinates, and
/// these are sums of n coordinates.
pub fn rounding(equations: &dyn Equations, q: &[f64], k: &[f64]) -> f64 {
    let off: Vec<f64> = q.iter().map(|x| methods::COORDINATE_ROUNDING * q.len() as f64 * x.abs()).collect();
    let stiffness = equations.stiffness(k);
    let row = |i: usize| (0..q.len()).map(|j| stiffness[(i, j)].abs() * off[j]).sum::<f64>();
    (0..q.len()).map(|i| 0.5 * off[i] * row(i)).sum()
}

/// Whether the account must close. It need not if the scene leaves out the jump terms or moves a phase by time, because these equations do
/// not conserve energy.
pub fn closes(laws: &[LawState]) -> bool {
    laws.iter().all(|law| matches!(law.switching, Switching::WithJump | Switching::Never))
}
