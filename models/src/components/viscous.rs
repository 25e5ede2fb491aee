//! A viscous damper, D = c omega^2/2, in the effect `viscous_friction`.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// Viscous friction against the rotation `theta` \[rad\] of a body, or the relative rotation of two. Declares its coefficient `c`.
pub fn viscous(m: &mut Model, part: &str, what: &str, theta: Expr) {
    m.part_effect("viscous_friction", part, "friction proportional to speed", |m| {
        let doc = format!("viscous friction of the {what}: torque per speed");
        let c = m.parameter(&named("c", part), "N*m*s/rad", None, Range::NotNegative, &doc);
        m.dissipation(half(c * theta.dot().sq()));
        let doc = format!("power that the viscous friction of the {what} takes");
        m.output(&observed::of_part("viscous_loss", part), "W", c * theta.dot().sq(), &doc);
    });
}
