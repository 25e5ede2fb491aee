//! A traction motor with its converter: the peak torque up to the base speed, constant power above it, T = d Tp min(1, wb/|omega|) with the
//! base speed wb = Pp/Tp and the demand d, in the effect `traction`.
//!
//! This is the envelope of torque against speed of an electric vehicle's drive (e.g. Ehsani, Gao, Longo & Ebrahimi, Modern Electric,
//! Hybrid Electric, and Fuel Cell Vehicles, ch. 4; Husain, Electric and Hybrid Vehicles, ch. 7). d = 1 drives with the whole envelope,
//! d < 0 brakes. The derivation refuses `min` and `|omega|`, like every piecewise function. With x = omega/wb,
//!
//! ```text
//! max(1, |x|) = (|1 + x| + |1 - x|)/2,   T = 2 d Tp/(((1 + x)² + r²)^(1/2) + ((1 - x)² + r²)^(1/2)),
//! ```
//!
//! where r rounds the corners: the torque is lower by the share r/2 at the base speed, and by less than r²/(2 |1 - x²|) at any other speed
//! (r²/2 at rest). It makes the cells nonlinear: they are integrated by a stepping method.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// A traction motor with the rotation `through` \[rad\] and the speed `omega` [rad/s]. Declares the peak torque `Tp`, the peak power `Pp`, the
/// demand `d` and the rounding `round` of the corner at the base speed, relative to that speed. Returns the name
/// of the effect.
pub fn traction_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) -> String {
    let doc = "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
    m.part_effect("traction", part, doc, |m| {
        let peak = format!("peak torque of the traction motor of the {what}, up to its base speed");
        let peak = m.parameter(&named("Tp", part), "N*m", None, Range::Positive, &peak);
        let power = format!("peak power of the traction motor of the {what}, above its base speed Pp/Tp");
        let power = m.parameter(&named("Pp", part), "W", None, Range::Positive, &power);
        let demand = format!("demand on the traction motor of the {what}: 1 drives with its peak torque or power, -1 brakes with them");
        let demand = m.parameter(&named("d", part), "1", Some(1.0), Range::Any, &demand);
        let round = format!("rounding of the corner of the torque of the traction motor of the {what} at its base speed, relative to that");
        let round = m.parameter(&named("round", part), "1", Some(0.01), Range::Positive, &round);
        let x = m.constant(&named("per_wb", part), peak / power) * omega;
        let side = |x: Expr| ((1 + x).sq() + round.sq()).sqrt();
        let torque = m.force(&named("T_traction", part), 2 * demand * peak / (side(x) + side(-x)));
        let doc = format!("torque of the traction motor of the {what}");
        m.torque(&named("traction", part), torque, through, &doc);
    })
}
