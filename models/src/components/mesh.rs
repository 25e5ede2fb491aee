//! A gear mesh: V = k(phase) delta^2/2, with delta along the line of action.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, MeshError, Model, half};

use super::{named, play};

/// The two factors of the spring force of a mesh.
#[derive(Clone, Copy)]
pub struct Mesh {
    /// Stiffness while the flanks are in contact, 0 while they are not.
    pub stiffness: Expr,
    /// Deflection in contact: less the transmission error and the edge of the backlash, if the mesh has them.
    pub delta: Expr,
}

/// A mesh with the deflection `delta` [m], which is linear in the coordinates; subtract a [`transmission_error`] from it if the mesh
/// has one. Declares its stiffness law `k` [N/m], periodic in `phase` [rad], in which one tooth pitch is 2 pi, and the effects
/// `stiffness_step`, `rigid_kinematics` and `frozen_phase`.
pub fn mesh(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> Mesh {
    let stiffness = stiffness(m, part, what, phase);
    let delta = m.deflection(&named("delta", part), delta);
    m.potential(half(stiffness * delta.sq()));
    Mesh { stiffness, delta }
}

/// A mesh as [`mesh`], with backlash in the effect `backlash`. Declares also the backlash `b` [m] along the line of action.
pub fn mesh_with_play(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> Mesh {
    let k = stiffness(m, part, what, phase);
    let gap = play(m, part, what, "m", delta);
    m.potential(half(k * gap.touch * gap.over.sq()));
    Mesh { stiffness: k * gap.touch, delta: gap.over }
}

/// The transmission error of a mesh along its line of action, in the effect `transmission_error`; the deflection of the mesh is
/// then `delta - e.value`. Declares its law `e` [m], periodic in `phase` [rad], in which one tooth pitch is 2 pi.
pub fn transmission_error(m: &mut Model, part: &str, what: &str, phase: Expr) -> MeshError {
    let doc = format!("transmission error of the {what} along the line of action");
    m.transmission_error([&named("e", part), part], "m", phase, TAU, &doc)
}

fn stiffness(m: &mut Model, part: &str, what: &str, phase: Expr) -> Expr {
    let doc = format!("stiffness of the {what} along the line of action");
    m.mesh_stiffness(&named("k", part), "N/m", phase, TAU, &doc).value
}
