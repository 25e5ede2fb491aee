//! Elements with stiffness.

use gearsim_derive::{Expr, Model, Range, Start, half};

use super::{coordinate, damping};
use crate::components::{self, Sliding, damped_mesh, pressure_tangent, sliding_friction};

/// A torsional shaft.
pub fn shaft(m: &mut Model) {
    spring(m, "a shaft", "shaft {}");
}

/// A torsional spring between a rotor and the ground.
pub fn support(m: &mut Model) {
    spring(m, "a torsional support", "support {}");
}

fn spring(m: &mut Model, title: &str, what: &str) {
    m.title(title);
    m.source("an element of trains");
    let twist = coordinate(m, "theta", "rad", "twist");
    let twist = components::shaft(m, "x", what, twist, None);
    let doc = format!("torsional damping of the {what}: torque per speed");
    components::damper(m, "x", ["c", "N*m*s/rad", &doc], &[twist]);
    damping(m);
}

/// The axial motion of a rotor on a thrust bearing, with the mass that moves along the axis.
pub fn thrust_bearing(m: &mut Model) {
    m.title("a thrust bearing and the mass on it");
    m.source("an element of trains");
    let z = m.coordinate("z", "m", Start::Static, "axial displacement");
    let mass = m.parameter("ma_x", "kg", None, Range::Positive, "mass that moves along the axis on thrust bearing {}");
    m.kinetic(half(mass * z.dot().sq()));
    components::thrust_bearing(m, "x", "thrust bearing {}", z);
    components::damping(m);
}

/// A mesh.
pub fn mesh(m: &mut Model) {
    let (phase, s) = begin(m, "a mesh");
    damped_mesh(m, "x", "mesh {}", phase, s);
    damping(m);
}

/// A mesh with friction of the flanks.
pub fn mesh_with_friction(m: &mut Model) {
    let (phase, s) = begin(m, "a mesh with friction of the flanks");
    let psi = coordinate(m, "psi", "rad", "rotation of the first gear relative to the second");
    let mesh = damped_mesh(m, "x", "mesh {}", phase, s);
    let tau = pressure_tangent(m) * s;
    sliding_friction(m, "x", "mesh {}", "m", mesh, Sliding { phase, tau, psi });
    damping(m);
}

fn begin(m: &mut Model, title: &str) -> (Expr, Expr) {
    m.title(title);
    m.source("an element of trains");
    let phase = m.coordinate("phase", "rad", Start::At(0.0), "phase of the mesh; one pitch is 2 pi");
    let test = m.parameter("J_phase", "kg*m^2", None, Range::Positive, "test inertia, 0 in trains");
    m.kinetic(half(test * phase.dot().sq()));
    (phase, coordinate(m, "s", "m", "relative motion of the gears along the line of action"))
}
