//! The energy account of a run: if T + V - W + dissipated energy does not keep its value of the start, the result is wrong.

use std::fmt;

use crate::engine::equations::Switching;
use crate::engine::hybrid::Hybrid;
use crate::engine::law::LawState;
use crate::engine::vector::Matrix;
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
    /// Bound on the energy of rounding errors \[J\]. A train at rest has only such energy.
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

/// The energy of rounding errors at the end of a run, at the law values `k` \[J\]. It has two parts. The first is the strain energy of the
/// rounding errors of the coordinates: each coordinate is a sum of n modal coordinates, and each of these a sum of n coordinates. The
/// second is the kinetic energy that the rounding errors of the forces cause during the run: the forces on a loaded train that friction or
/// a clutch holds cancel to rounding errors.
pub fn rounding(now: &Hybrid<'_>, k: &[f64]) -> f64 {
    let n = now.state.q.len();
    let part = methods::REST_ROUNDING * n as f64;
    let time = now.clock.now();
    let energy = |matrix: &Matrix, off: &[f64]| -> f64 {
        let row = |i: usize| (0..n).map(|j| matrix[(i, j)].abs() * off[j]).sum::<f64>();
        (0..n).map(|i| 0.5 * off[i] * row(i)).sum()
    };
    let places: Vec<f64> = now.state.q.iter().map(|x| part * x.abs()).collect();
    let impulses: Vec<f64> = now.force().iter().map(|x| part * x.abs() * time).collect();
    energy(&now.equations.stiffness(k), &places) + energy(&now.equations.mobility(&now.state.q), &impulses)
}

/// Whether the account must close. It need not close if the scene omits the jump terms or prescribes a phase as a function of time, because
/// such equations do not conserve energy.
pub fn closes(laws: &[LawState]) -> bool {
    laws.iter().all(|law| matches!(law.switching, Switching::WithJump | Switching::Never))
}
