//! An induction motor by the formula of Kloss, T = 2 T_b/(s/s_b + s_b/s) with the slip s = 1 - omega/n_s, in the effect
//! `induction`.
//!
//! This is the steady torque against speed with the stator resistance neglected (e.g. Fitzgerald, Kingsley & Umans, Electric
//! Machinery, ch. 6). It is written T = 2 T_b s s_b/(s² + s_b²), which is smooth at every speed, also as a generator above n_s
//! (s < 0) and with reversed rotation (plugging, s > 1). It makes the cells nonlinear: they are integrated by a stepping method.

use gearsim_derive::{Expr, Model, Range};

use super::named;

/// An induction motor whose rotor has the rotation `through` \[rad\] and the speed `omega` [rad/s]. Declares the breakdown torque `Tb`, the slip
/// `sb` at which the motor has this torque, and the synchronous speed `ns`. Returns the name of the effect.
pub fn induction_motor(m: &mut Model, part: &str, what: &str, through: Expr, omega: Expr) -> String {
    m.part_effect("induction", part, "an induction motor, its torque by the formula of Kloss", |m| {
        let doc = format!("breakdown torque of the induction motor of the {what}, its largest torque");
        let breakdown = m.parameter(&named("Tb", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("slip at which the induction motor of the {what} has its breakdown torque");
        let at = m.parameter(&named("sb", part), "1", None, Range::Positive, &doc);
        let doc = format!("synchronous speed of the induction motor of the {what}");
        let synchronous = m.parameter(&named("ns", part), "rad/s", None, Range::Positive, &doc);
        let slip = 1 - omega / synchronous;
        let torque = m.force(&named("T_induction", part), 2 * breakdown * at * slip / (slip.sq() + at.sq()));
        let doc = format!("torque of the induction motor of the {what}");
        m.torque(&named("induction", part), torque, through, &doc);
    })
}
