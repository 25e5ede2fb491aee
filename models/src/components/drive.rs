//! Motor and load: torques that are constant, or vary in time if a scene says so, in the effect `torques`.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// A motor that drives a body with the rotation `theta` [rad]. Declares its torque `T`.
pub fn drive(m: &mut Model, part: &str, what: &str, theta: Expr) {
    torque(m, part, &format!("driving torque of the {what}"), theta);
}

/// A load on a body with the rotation `theta` [rad], against that rotation. Declares its torque `T`.
pub fn load(m: &mut Model, part: &str, what: &str, theta: Expr) {
    torque(m, part, &format!("load torque of the {what}, against its rotation"), -theta);
}

fn torque(m: &mut Model, part: &str, doc: &str, through: Expr) {
    m.effect("torques", "constant torques of motor and load", |m| {
        let value = m.parameter(&named("T", part), "N*m", None, Range::Any, doc);
        m.torque(part, value, through, doc);
    });
}
