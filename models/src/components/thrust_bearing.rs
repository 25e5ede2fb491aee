//! A thrust bearing: V = ka z^2/2, D = ca z'^2/2 along the axis of a rotor.

use gearsim_derive::{Expr, Model, Range, half};

use super::{damper, named, observed};

/// A bearing that deflects by the axial displacement `z` \[m\] of its rotor. Declares its axial stiffness `ka`, and its damping `ca` in the
/// effect `viscous_friction`.
pub fn thrust_bearing(m: &mut Model, part: &str, what: &str, z: Expr) {
    let doc = format!("axial stiffness of the {what}");
    let k = m.parameter(&named("ka", part), "N/m", None, Range::NotNegative, &doc);
    let z = m.deflection(&named("bz", part), z);
    m.potential(half(k * z.sq()));
    let doc = format!("axial damping of the {what}: force per speed");
    damper(m, part, ["ca", "N*s/m", &doc], &[z]);
    observed::thrust_bearing(m, part, what, z);
}
