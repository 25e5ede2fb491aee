//! Rigidly meshing gears: N1 theta1 = N2 theta2, so that one rotation follows from the other and needs no coordinate.

use gearsim_derive::Expr;

/// The rotation \[rad\], positive in its own direction, of a gear with `n2` teeth that meshes rigidly with a gear of `n1` teeth whose
/// rotation is `theta1` \[rad\]. A closed clutch is `geared(theta, 1.into(), 1.into())`; a body held by a brake has the rotation 0.
pub fn geared(theta1: Expr, n1: Expr, n2: Expr) -> Expr {
    theta1 * n1 / n2
}
