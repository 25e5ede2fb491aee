//! A fan or a pump as load: T = -c omega |omega|, with |omega| smoothed at omega = 0: T = -c omega (omega² + w0²)^(1/2).
//!
//! It brakes rotation in either direction and never drives. The derivation refuses `|omega|`, like every piecewise function. The
//! smoothed torque differs from c omega |omega| by at most c w0²/2. It makes the cells nonlinear: they are integrated by a
//! stepping method.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// A fan on a body with the rotation `through` \[rad\] and the speed `omega` [rad/s], in the effect `fan`. Declares the
/// coefficient `cf` and the speed `w0`. Returns the name of the effect.
pub fn fan(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) -> String {
    let doc = "a fan as load: torque proportional to the square of the speed, against the rotation";
    m.part_effect("fan", part, doc, |m| {
        let doc = format!("torque of the fan of the {what} divided by the square of its speed");
        let c = m.parameter(&named("cf", part), "N*m*s^2/rad^2", None, Range::NotNegative, &doc);
        let doc = format!(
            "speed of the {what} below which the torque of its fan is linear instead of quadratic in the speed"
        );
        let corner = m.parameter(&named("w0", part), "rad/s", Some(0.01), Range::Positive, &doc);
        let torque = m.force(&named("T_fan", part), -c * omega * (omega.sq() + corner.sq()).sqrt());
        let doc = format!("torque of the fan of the {what}, against the rotation");
        m.torque(&named("fan", part), torque, through, &doc);
    })
}
