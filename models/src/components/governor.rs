//! A speed governor: T = c (n - omega), in proportion to what the speed lacks of its set point.
//!
//! In two parts, both of which leave cells linear and exactly solved: the constant torque c n, whose work is that of the set
//! point, and D = c omega²/2, which takes c omega back. The set point may vary in time. A DC motor on a constant voltage is one.

use gearsim_derive::{Expr, Model, Range, half};

use super::named;

/// A motor with a governor, in the effect `speed_governor`: `through` is how far it turns [rad], `omega` how fast. Declares
/// `c` and the set point `n`.
pub fn governor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("speed_governor", "a governor that drives the motor in proportion to what its speed lacks", |m| {
        let doc = format!("torque of the {what}'s governor per speed that it lacks");
        let c = m.parameter(&named("c", part), "N*m*s/rad", None, Range::Positive, &doc);
        let doc = format!("speed that the {what}'s governor aims at");
        let n = m.parameter(&named("n", part), "rad/s", None, Range::Any, &doc);
        let doc = "torque c n of the governor; what it takes back, c omega, is in D";
        linear(m, "governor", c * n, c, through, omega, doc);
    });
}

/// A DC motor on a constant voltage, in the effect `dc_motor`: T = T_s (1 - omega/n_0). Declares the stall torque `Ts` and the
/// speed `n0` at which it has none.
pub fn dc_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("dc_motor", "a DC motor on a constant voltage: its torque falls straight from stall to no load", |m| {
        let doc = format!("stall torque of the {what}");
        let stall = m.parameter(&named("Ts", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("speed of the {what} without load");
        let free = m.parameter(&named("n0", part), "rad/s", None, Range::Positive, &doc);
        let doc = "stall torque of the DC motor; what speed takes of it is in D";
        linear(m, "dc", stall, stall / free, through, omega, doc);
    });
}

/// T = constant - slope omega.
fn linear(m: &mut Model, name: &str, constant: Expr, slope: Expr, through: Expr, omega: Expr, doc: &str) {
    m.dissipation(half(slope * omega.sq()));
    m.torque(name, constant, through, doc);
}
