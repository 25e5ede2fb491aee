//! A speed governor, T = c (n - omega): a torque proportional to the difference between the set point n and the speed.
//!
//! It is written in two parts, both of which leave the cells linear: the constant torque c n and D = c omega²/2, whose torque is
//! -c omega. The set point may vary in time. A DC motor at constant voltage has a torque of the same form.

use gearsim_derive::{Expr, Model, Range, half};

use super::named;

/// A motor with a governor, in the effect `speed_governor`; `through` \[rad\] is its rotation, `omega` [rad/s] its speed. Declares
/// the gain `c` and the set point `n`.
pub fn governor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("speed_governor", "a speed governor: motor torque proportional to the set point minus the speed", |m| {
        let doc = format!("gain of the governor of the {what}: torque per difference of set point and speed");
        let c = m.parameter(&named("c", part), "N*m*s/rad", None, Range::Positive, &doc);
        let doc = format!("set point of the speed governor of the {what}");
        let n = m.parameter(&named("n", part), "rad/s", None, Range::Any, &doc);
        let doc = "torque c n of the governor; its part -c omega is in D";
        linear(m, "governor", c * n, c, through, omega, doc);
    });
}

/// A DC motor at constant voltage, in the effect `dc_motor`: T = T_s (1 - omega/n_0). Declares the stall torque `Ts` and the
/// no-load speed `n0`, at which the torque is zero.
pub fn dc_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("dc_motor", "a DC motor at constant voltage: its torque falls linearly from stall to no load", |m| {
        let doc = format!("stall torque of the {what}");
        let stall = m.parameter(&named("Ts", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("no-load speed of the {what}");
        let free = m.parameter(&named("n0", part), "rad/s", None, Range::Positive, &doc);
        let doc = "stall torque of the DC motor; the part proportional to the speed is in D";
        linear(m, "dc", stall, stall / free, through, omega, doc);
    });
}

/// T = constant - slope omega.
fn linear(m: &mut Model, name: &str, constant: Expr, slope: Expr, through: Expr, omega: Expr, doc: &str) {
    m.dissipation(half(slope * omega.sq()));
    let taken =
        "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed";
    m.output(&format!("{name}_braking"), "W", slope * omega.sq(), taken);
    m.torque(name, constant, through, doc);
}
