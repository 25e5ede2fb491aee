//! An induction motor by the formula of Kloss, T = 2 T_b/(s/s_b + s_b/s) with the slip s = 1 - omega/n_s, in the effect
//! `induction_motor`.
//!
//! Steady torque against speed, the stator's resistance neglected (e.g. Fitzgerald, Kingsley & Umans, Electric Machinery, ch.
//! 6); written T = 2 T_b s s_b/(s² + s_b²), which is smooth at every speed, a generator's above n_s (s < 0) and a plugged motor's in
//! reverse (s > 1) included. What depends on speed so makes cells nonlinear: they are integrated by steps.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// An induction motor: `through` is how far it turns [rad], `omega` how fast. Declares the breakdown torque `Tb`, the slip
/// `sb` at which it has it, and the synchronous speed `ns`.
pub fn induction_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) {
    m.effect("induction_motor", "an induction motor, its torque by the formula of Kloss", |m| {
        let doc = format!("breakdown torque of the {what}, the largest it has");
        let breakdown = m.parameter(&named("Tb", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("slip at which the {what} has its breakdown torque");
        let at = m.parameter(&named("sb", part), "1", None, Range::Positive, &doc);
        let doc = format!("synchronous speed of the {what}");
        let synchronous = m.parameter(&named("ns", part), "rad/s", None, Range::Positive, &doc);
        let slip = 1 - omega / synchronous;
        let torque = 2 * breakdown * at * slip / (slip.sq() + at.sq());
        m.torque("induction", torque, through, "torque of the induction motor");
    });
}
