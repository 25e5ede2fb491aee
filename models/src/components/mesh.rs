//! A mesh: V = k(phase) delta^2/2 along its line of action.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, MeshError, Model, half};

use super::{named, play};

/// A mesh as its force has it.
#[derive(Clone, Copy)]
pub struct Mesh {
    /// Its stiffness, while its flanks touch: 0 where they do not.
    pub stiffness: Expr,
    /// What it feels of its deflection.
    pub delta: Expr,
}

/// A mesh that is deflected by `delta` [m], linear in the coordinates, less a [`transmission_error`] if it has one. Declares its stiffness law `k`, periodic in `phase`, of which one tooth pitch
/// is 2 pi, and with it the effects `stiffness_step`, `rigid_kinematics` and `frozen_phase`.
pub fn mesh(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> Mesh {
    let stiffness = stiffness(m, part, what, phase);
    let delta = m.deflection(&named("delta", part), delta);
    m.potential(half(stiffness * delta.sq()));
    Mesh { stiffness, delta }
}

/// A mesh with backlash along its line of action, in the effect `backlash`: as [`mesh`], and declares the backlash `b` [m].
pub fn mesh_with_play(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> Mesh {
    let k = stiffness(m, part, what, phase);
    let gap = play(m, part, what, "m", delta);
    m.potential(half(k * gap.touch * gap.over.sq()));
    Mesh { stiffness: k * gap.touch, delta: gap.over }
}

/// The transmission error of a mesh along its line of action, in the effect of that name: `delta - e.value` is what the mesh
/// then feels. Declares its law `e` [m], periodic in `phase`, of which one tooth pitch is 2 pi.
pub fn transmission_error(m: &mut Model, part: &str, what: &str, phase: Expr) -> MeshError {
    let doc = format!("transmission error of the {what} along the line of action");
    m.transmission_error(&named("e", part), "m", phase, TAU, &doc)
}

fn stiffness(m: &mut Model, part: &str, what: &str, phase: Expr) -> Expr {
    let doc = format!("stiffness of the {what} along the line of action");
    m.mesh_stiffness(&named("k", part), "N/m", phase, TAU, &doc).value
}
