//! Two gears that roll on each other on parallel shafts, each turning in its own direction.
//!
//! With q1 = N1 theta1, q2 = N2 theta2 and the base radius h of one tooth (r1 = h N1, r2 = h N2): their mean rotation
//! theta = (q1 + q2)/2, of which one pitch is 2 pi, and what they turn against each other along the line of action,
//! s = h (q1 - q2).

use gearsim_derive::{Expr, Model, Range, Start};

use super::named;

/// A pair of gears, and how they turn.
#[derive(Clone, Copy)]
pub struct Pair {
    /// Mean rotation, the phase of their mesh: a coordinate [rad].
    pub theta: Expr,
    /// What they turn against each other: a coordinate [m]; the mesh's deflection where their centres are fixed.
    pub s: Expr,
    /// Rotation of the driving gear [rad].
    pub theta1: Expr,
    /// Rotation of the driven gear [rad].
    pub theta2: Expr,
    /// Number of teeth of the driving gear.
    pub n1: Expr,
    /// Number of teeth of the driven gear.
    pub n2: Expr,
}

/// Declares teeth `N` and `r` of the driving gear `a`, teeth of the driven gear `b`, and the coordinates `theta` and `s`
/// of their mesh, named after it: `pair(m, "", "1", "2")` gives `theta`, `s`, `N1`, `N2`, `r1`.
pub fn pair(m: &mut Model, of_mesh: &str, a: &str, b: &str) -> Pair {
    let teeth = |m: &mut Model, part: &str| {
        m.parameter(&named("N", part), "1", None, Range::Positive, &format!("number of teeth of gear {part}"))
    };
    let (n1, n2) = (teeth(m, a), teeth(m, b));
    let r = m.parameter(&named("r", a), "m", None, Range::Positive, &format!("base radius of gear {a}"));
    let h = m.constant(&format!("h{of_mesh}"), r / n1);
    let start = if of_mesh.is_empty() || of_mesh == "1" { Start::At(0.0) } else { Start::Static };
    let doc = format!("mean rotation of gears {a} and {b}, one pitch 2 pi");
    let theta = m.coordinate(&format!("theta{of_mesh}"), "rad", start, &doc);
    let doc = format!("rotation of gear {a} beyond that of gear {b}, along the line of action");
    let s = m.coordinate(&format!("s{of_mesh}"), "m", Start::Static, &doc);
    let half = gearsim_derive::half(s / h);
    Pair { theta, s, theta1: (theta + half) / n1, theta2: (theta - half) / n2, n1, n2 }
}
