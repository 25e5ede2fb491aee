//! A mesh: V = k(phase) delta^2/2 along its line of action.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, MeshError, MeshStiffness, Model, half};

use super::{named, play};

/// A mesh that is deflected by `delta` [m], linear in the coordinates, less a [`transmission_error`] if it has one. Declares its stiffness law `k`, periodic in `phase`, of which one tooth pitch
/// is 2 pi, and with it the effects `stiffness_step`, `rigid_kinematics` and `frozen_phase`.
pub fn mesh(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> MeshStiffness {
    let k = stiffness(m, part, what, phase);
    let delta = m.deflection(&named("delta", part), delta);
    m.potential(half(k.value * delta.sq()));
    k
}

/// A mesh with backlash along its line of action, in the effect `backlash`: as [`mesh`], and declares the backlash `b` [m].
pub fn mesh_with_play(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> MeshStiffness {
    let k = stiffness(m, part, what, phase);
    let gap = play(m, part, what, "m", delta);
    m.potential(half(k.value * gap.touch * gap.over.sq()));
    k
}

/// The transmission error of a mesh along its line of action, in the effect of that name: `delta - e.value` is what the mesh
/// then feels. Declares its law `e` [m], periodic in `phase`, of which one tooth pitch is 2 pi.
pub fn transmission_error(m: &mut Model, part: &str, what: &str, phase: Expr) -> MeshError {
    let doc = format!("transmission error of the {what} along the line of action");
    m.transmission_error(&named("e", part), "m", phase, TAU, &doc)
}

fn stiffness(m: &mut Model, part: &str, what: &str, phase: Expr) -> MeshStiffness {
    let doc = format!("stiffness of the {what} along the line of action");
    m.mesh_stiffness(&named("k", part), "N/m", phase, TAU, &doc)
}
