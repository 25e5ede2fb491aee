//! Viscous dampers, D = c x'^2/2, in the effect `viscous_friction`.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

const EFFECT: &str = "viscous_friction";
const DOC: &str = "friction proportional to speed";

/// Viscous friction against the rotation `theta` \[rad\] of a body, or the relative rotation of two. Declares its coefficient `c`.
pub fn viscous(m: &mut Model, part: &str, what: &str, theta: Expr) {
    m.part_effect(EFFECT, part, DOC, |m| {
        let doc = format!("viscous friction of the {what}: torque per speed");
        let c = m.parameter(&named("c", part), "N*m*s/rad", None, Range::NotNegative, &doc);
        m.dissipation(half(c * theta.dot().sq()));
        let doc = format!("power that the viscous friction of the {what} takes");
        m.output(&observed::of_part("viscous_loss", part), "W", c * theta.dot().sq(), &doc);
    });
}

/// A viscous damper parallel to springs, with the coefficient `c` [`unit`] along each of the named deflections `along`. `doc` describes the
/// coefficient. The outputs of the forces of these springs contain the damper, by [`Model::damper`] of `along`.
pub fn damper(m: &mut Model, part: &str, [c, unit, doc]: [&str; 3], along: &[Expr]) {
    m.part_effect(EFFECT, part, DOC, |m| {
        let c = m.parameter(&named(c, part), unit, None, Range::NotNegative, doc);
        along.iter().for_each(|x| m.dissipation(half(c * x.dot().sq())));
    });
}
