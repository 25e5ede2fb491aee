//! A thrust bearing: V = ka z^2/2, D = ca z'^2/2 along the axis of a rotor.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// A bearing that deflects by the axial displacement `z` \[m\] of its rotor. Declares its axial stiffness `ka`, and its damping `ca` in the
/// effect `viscous_friction`.
pub fn thrust_bearing(m: &mut Model, part: &str, what: &str, z: Expr) {
    let doc = format!("axial stiffness of the {what}");
    let k = m.parameter(&named("ka", part), "N/m", None, Range::NotNegative, &doc);
    let z = m.deflection(&named("bz", part), z);
    m.potential(half(k * z.sq()));
    m.part_effect("viscous_friction", part, "friction proportional to speed", |m| {
        let doc = format!("axial damping of the {what}: force per speed");
        let c = m.parameter(&named("ca", part), "N*s/m", None, Range::NotNegative, &doc);
        m.dissipation(half(c * z.dot().sq()));
    });
    observed::thrust_bearing(m, part, what, z);
}
