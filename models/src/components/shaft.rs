//! A torsional shaft: V = k twist^2/2.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// A shaft between two rotors whose rotations differ by `twist` \[rad\]; `first` is the rotation of the one that leads \[rad\], for the
/// power that enters there, if it is known. Declares its torsional stiffness `k`.
pub fn shaft(m: &mut Model, part: &str, what: &str, twist: Expr, first: impl Into<Option<Expr>>) {
    let doc = format!("torsional stiffness of the {what}");
    let k = m.parameter(&named("k", part), "N*m/rad", None, Range::NotNegative, &doc);
    let twist = m.deflection(&named("twist", part), twist);
    m.potential(half(k * twist.sq()));
    observed::shaft(m, part, what, twist, first.into());
}

/// A torsional spring between the ground and a body with the rotation `theta` \[rad\], in the effect `torsional_support`: it holds a body
/// that turns without the effect, such as the carrier of a stage whose ring turns. Declares its torsional stiffness `k`. A phase that
/// follows this body rolls only in scenes without the effect; the derivation finds this.
pub fn torsional_support(m: &mut Model, part: &str, what: &str, theta: Expr) {
    m.part_effect("torsional_support", part, "a torsional spring to the ground: it holds what else turns", |m| {
        ground(m, part, what, theta);
    });
}

/// A torsional spring between the ground and a body with the rotation `theta` \[rad\]. Declares its torsional stiffness `k`.
pub fn ground(m: &mut Model, part: &str, what: &str, theta: Expr) {
    shaft(m, part, what, theta, theta);
}
