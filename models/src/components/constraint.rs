//! Rigidly meshing gears: N1 theta1 = N2 theta2, so that one rotation follows from the other and needs no coordinate.

use gearsim_derive::Expr;

/// The rotation \[rad\] of a gear with `n2` teeth that is driven without slip or deflection by a gear with `n1` teeth. The rotation of the driving
/// gear is `theta1` \[rad\]; each gear counts its own direction as positive. A closed clutch is `geared(theta, 1.into(), 1.into())`. A
/// body that a brake holds has the rotation 0.
pub fn geared(theta1: Expr, n1: Expr, n2: Expr) -> Expr {
    theta1 * n1 / n2
}
