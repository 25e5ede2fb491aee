//! A radial bearing with the same stiffness and the same damping in every direction: V = kb (x^2 + y^2)/2, D = cb (x'^2 + y'^2)/2.

use gearsim_derive::{Expr, Model, Range, half};

use super::{damper, named, observed};

/// A bearing that deflects by `x` and `y` \[m\]. Declares its radial stiffness `kb`, and its damping `cb` in the effect `viscous_friction`.
pub fn bearing(m: &mut Model, part: &str, what: &str, [x, y]: [Expr; 2]) {
    let doc = format!("radial stiffness of the {what}");
    let k = m.parameter(&named("kb", part), "N/m", None, Range::NotNegative, &doc);
    let [x, y] = [("bx", x), ("by", y)].map(|(name, x)| m.deflection(&named(name, part), x));
    m.potential(half(k * x.sq()));
    m.potential(half(k * y.sq()));
    bearing_damper(m, part, what, &[x, y]);
    observed::bearing(m, part, what, [x, y]);
}

/// Viscous dampers of a bearing along the named deflections `along` \[m\], in the effect `viscous_friction`. They act in addition to damping in
/// proportion to stiffness. Declares their coefficient `cb`.
pub fn bearing_damper(m: &mut Model, part: &str, what: &str, along: &[Expr]) {
    let doc = format!("radial damping of the {what}: force per speed");
    damper(m, part, ["cb", "N*s/m", &doc], along);
}
