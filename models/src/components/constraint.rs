//! Rigid gears: N1 theta1 = N2 theta2, so that one rotation is written in the other and no coordinate is left for it.

use gearsim_derive::Expr;

/// The rotation of a gear with `n2` teeth, in its own direction, that meshes rigidly with one of `n1` teeth which turns
/// by `theta1` [rad]. A clutch that is held shut is `geared(theta, 1.into(), 1.into())`, and what a brake holds has no rotation: 0.
pub fn geared(theta1: Expr, n1: Expr, n2: Expr) -> Expr {
    theta1 * n1 / n2
}
