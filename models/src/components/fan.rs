//! A fan or a pump as load: T = -c omega |omega|, with its corner at rest rounded: -c omega (omega² + w0²)^(1/2).
//!
//! It brakes rotation in either direction, and never drives. `|omega|` is refused by the derivation, as everything piecewise is;
//! at speeds beyond w0 the difference is c w0²/2 at most. It makes cells nonlinear: they are integrated by steps.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// A fan on what turns by `through` [rad] at the speed `omega`, in the effect `fan_load`. Declares `c` and `w0`.
pub fn fan(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("fan_load", "a fan as load: torque with the square of the speed, against it", |m| {
        let doc = format!("torque of the {what} as a fan, over the square of its speed");
        let c = m.parameter(&named("cf", part), "N*m*s^2/rad^2", None, Range::NotNegative, &doc);
        let doc = format!("speed of the {what} below which the fan's torque is straight instead of square");
        let corner = m.parameter(&named("w0", part), "rad/s", Some(0.01), Range::Positive, &doc);
        let torque = -c * omega * (omega.sq() + corner.sq()).sqrt();
        m.torque("fan", torque, through, "torque of the fan, against its rotation");
    });
}
