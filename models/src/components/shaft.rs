//! A torsional shaft: V = k twist^2/2.

use gearsim_derive::{Expr, GearData, Model, Range, half};

use super::{named, observed};

/// A shaft between two rotors. `twist` \[rad\] is the difference of their rotations. `first` \[rad\] is the rotation of the rotor that leads if
/// the twist is positive; the output of the power that enters the shaft needs it. Declares the torsional stiffness `k`. Returns the deflection.
pub fn shaft(m: &mut Model, part: &str, what: &str, twist: Expr, first: impl Into<Option<Expr>>) -> Expr {
    let k = m.parameter(&named("k", part), "N*m/rad", None, Range::NotNegative, &stiffness_of(what));
    spring(m, part, what, (k, twist), first.into())
}

fn stiffness_of(what: &str) -> String {
    format!("torsional stiffness of the {what}")
}

fn spring(m: &mut Model, part: &str, what: &str, (k, twist): (Expr, Expr), first: Option<Expr>) -> Expr {
    let twist = m.deflection(&named("twist", part), twist);
    m.potential(half(k * twist.sq()));
    observed::shaft(m, part, what, twist, first);
    twist
}

/// A torsional spring between the ground and a body with the rotation `theta` \[rad\], in the effect `torsional_support`. It holds a body
/// that turns in scenes without the effect, such as the carrier of a stage whose ring turns. Declares the torsional stiffness `k`. The
/// derivation finds that a phase which follows this body rolls only in scenes without the effect.
pub fn torsional_support(m: &mut Model, part: &str, what: &str, theta: Expr) {
    m.part_effect("torsional_support", part, "a torsional spring to the ground: it holds what else turns", |m| {
        ground(m, part, what, theta);
    });
}

/// A torsional spring between the ground and a body with the rotation `theta` \[rad\]. Declares its torsional stiffness `k`.
pub fn ground(m: &mut Model, part: &str, what: &str, theta: Expr) {
    let k = m.gear_data(GearData::Support, &named("k", part), None, &stiffness_of(what));
    spring(m, part, what, (k, theta), Some(theta));
}
