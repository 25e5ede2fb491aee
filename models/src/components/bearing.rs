//! A radial bearing with the same stiffness in every direction: V = kb (x^2 + y^2)/2.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// A bearing that deflects by `x` and `y` [m]. Declares its radial stiffness `kb`.
pub fn bearing(m: &mut Model, part: &str, what: &str, [x, y]: [Expr; 2]) {
    let doc = format!("radial stiffness of the {what}");
    let k = m.parameter(&named("kb", part), "N/m", None, Range::NotNegative, &doc);
    let [x, y] = [("bx", x), ("by", y)].map(|(name, x)| m.deflection(&named(name, part), x));
    m.potential(half(k * x.sq()));
    m.potential(half(k * y.sq()));
    observed::bearing(m, part, what, [x, y]);
}
