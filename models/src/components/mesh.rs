//! A mesh: V = k(phase) delta^2/2 along its line of action.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, MeshStiffness, Model, half};

use super::named;

/// A mesh that is deflected by `delta` [m], linear in the coordinates. Declares its stiffness law `k`, periodic in `phase`, of which one tooth pitch
/// is 2 pi, and with it the effects `stiffness_step`, `rigid_kinematics` and `frozen_phase`.
pub fn mesh(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> MeshStiffness {
    let doc = format!("stiffness of the {what} along the line of action");
    let k = m.mesh_stiffness(&named("k", part), "N/m", phase, TAU, &doc);
    let delta = m.deflection(&named("delta", part), delta);
    m.potential(half(k.value * delta.sq()));
    k
}
