//! A speed governor, T = c (n - omega): a torque proportional to the difference between the set point n and the speed.
//!
//! It is written in two parts, both of which leave the cells linear: the constant torque c n and D = c omega²/2, whose torque is
//! -c omega. The set point may vary in time. A DC motor at constant voltage has a torque of the same form.

use gearsim_derive::{Expr, Model, Range, half};

use super::named;

/// A motor with a governor, in the effect `governor`; `through` \[rad\] is its rotation, `omega` [rad/s] its speed. Declares
/// the gain `c` and the set point `n`. Returns the name of the effect.
pub fn governor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) -> String {
    let doc = "a motor with a speed governor: its torque is proportional to the set point minus the speed";
    m.part_effect("governor", part, doc, |m| {
        let doc = format!("gain of the governor of the {what}: torque per difference of set point and speed");
        let c = m.parameter(&named("c", part), "N*m*s/rad", None, Range::Positive, &doc);
        let doc = format!("set point of the speed governor of the {what}");
        let n = m.parameter(&named("n", part), "rad/s", None, Range::Any, &doc);
        let doc = format!("torque c n of the governor of the {what}; its part -c omega is in D");
        linear(m, &named("governor", part), [c * n, c], through, omega, &doc);
    })
}

/// A DC motor at constant voltage, in the effect `dc`. Its torque is T = T_s (1 - omega/n_0). Declares the stall torque `Ts` and the
/// no-load speed `n0`, at which the torque is zero. Returns the name of the effect.
pub fn dc_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) -> String {
    let doc = "a DC motor at constant voltage: its torque falls linearly from stall to no load";
    m.part_effect("dc", part, doc, |m| {
        let doc = format!("stall torque of the DC motor of the {what}");
        let stall = m.parameter(&named("Ts", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("no-load speed of the DC motor of the {what}");
        let free = m.parameter(&named("n0", part), "rad/s", None, Range::Positive, &doc);
        let doc = format!("torque Ts of the DC motor of the {what}; its part -Ts omega/n0 is in D");
        linear(m, &named("dc", part), [stall, stall / free], through, omega, &doc);
    })
}

/// T = constant - slope omega.
fn linear(m: &mut Model, name: &str, [constant, slope]: [Expr; 2], through: Expr, omega: Expr, doc: &str) {
    m.dissipation(half(slope * omega.sq()));
    let taken =
        "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed";
    let taken = m.output(&format!("braking_{name}"), "W", slope * omega.sq(), taken);
    m.torque(name, constant, through, doc);
    let given = "power that the motor gives: its whole torque times its speed, negative if it brakes";
    m.output(&format!("net_power_{name}"), "W", m.power(name) - taken, given);
}
