//! Two gears on parallel shafts; the rotation of each is positive in its own direction.
//!
//! Let q1 = N1 theta1, q2 = N2 theta2 and h the base radius per tooth (r1 = h N1, r2 = h N2). The coordinates are the mean rotation
//! theta = (q1 + q2)/2, in which one pitch is 2 pi, and the relative motion of the gears along the line of action,
//! s = h (q1 - q2).

use gearsim_derive::{Expr, GearData, Model, Start};

use super::{Mesh, Sliding, mesh_with_play, named, sliding_friction};

/// A pair of gears: their rotations and numbers of teeth.
#[derive(Clone, Copy)]
pub struct Pair {
    /// Mean rotation, the phase of the mesh: a coordinate \[rad\].
    pub theta: Expr,
    /// Relative motion along the line of action: a coordinate \[m\]. It is the deflection of the mesh if the centres are fixed.
    pub s: Expr,
    /// Displacement \[m\] of the driving gear's flank along the line of action: r1 theta1.
    pub u1: Expr,
    /// Rotation of the driving gear \[rad\].
    pub theta1: Expr,
    /// Rotation of the driven gear \[rad\].
    pub theta2: Expr,
    /// Number of teeth of the driving gear.
    pub n1: Expr,
    /// Number of teeth of the driven gear.
    pub n2: Expr,
    /// Base radius per tooth \[m\].
    pub h: Expr,
}

/// Declares the number of teeth `N` and the base radius `r` \[m\] of the driving gear `a`, the number of teeth of the driven gear
/// `b`, and the coordinates `theta` and `s`, followed by the name `of_mesh`: `pair(m, "", "1", "2")` declares `theta`, `s`, `N1`,
/// `N2`, `r1`.
pub fn pair(m: &mut Model, of_mesh: &str, a: &str, b: &str) -> Pair {
    let teeth = |m: &mut Model, part: &str| {
        m.gear_data(GearData::Teeth, &named("N", part), None, &format!("number of teeth of gear {part}"))
    };
    let (n1, n2) = (teeth(m, a), teeth(m, b));
    let r = m.gear_data(GearData::BaseRadius, &named("r", a), None, &format!("base radius of gear {a}"));
    let h = m.constant(&format!("h{of_mesh}"), r / n1);
    let start = if of_mesh.is_empty() || of_mesh == "1" { Start::At(0.0) } else { Start::Static };
    let doc = format!("mean rotation of gears {a} and {b}; one pitch is 2 pi");
    let theta = m.coordinate(&format!("theta{of_mesh}"), "rad", start, &doc);
    let doc = format!("motion of gear {a} relative to gear {b} along the line of action");
    let s = m.coordinate(&format!("s{of_mesh}"), "m", Start::Static, &doc);
    let half = gearsim_derive::half(s / h);
    let u1 = h * theta + gearsim_derive::half(s);
    Pair { theta, s, u1, theta1: (theta + half) / n1, theta2: (theta - half) / n2, n1, n2, h }
}

impl Pair {
    /// The sum of the base radii \[m\].
    pub fn sum_of_base_radii(&self) -> Expr {
        self.h * (self.n1 + self.n2)
    }

    /// The mesh of the pair with all effects of meshes: steps of the stiffness, play, a transmission error, sliding friction. `tangent` is
    /// the tangent of the pressure angle. Declares what [`mesh_with_play`] and [`sliding_friction`] declare.
    pub fn mesh(&self, m: &mut Model, part: &str, what: &str, tangent: Expr) -> Mesh {
        let mesh = mesh_with_play(m, part, what, self.theta, self.s, self.u1);
        let (tau, psi) = (tangent * self.s, self.theta1 + self.theta2);
        let sliding = Sliding { phase: self.theta, tau, psi };
        sliding_friction(m, part, what, "m", mesh, sliding);
        mesh
    }
}
