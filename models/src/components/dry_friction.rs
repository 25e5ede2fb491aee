//! Dry friction of a bearing, a seal or a brake, in the effect `dry_friction`: Coulomb's law with true sticking.
//!
//! | mode | while | friction torque |
//! | --- | --- | --- |
//! | stuck | the torque R that the friction resists is at most the breakaway torque (1 + rise) Tc | R, so that the rate is zero |
//! | forward | x' > 0 | Tc, against the motion |
//! | backward | x' < 0 | Tc, against the motion |
//!
//! Source: J. P. Den Hartog, Trans. ASME 53 (1931), 107-115. The friction does not depend on speed or on load.

use gearsim_derive::{Expr, Model, Range};

use super::{named, observed};

/// Dry friction against the displacement `x` [rad or m], which is linear in the coordinates: the rotation of a rotor against the ground,
/// or the relative rotation of two. `unit` is that of x, `force` that of the friction, N*m or N. Declares the Coulomb torque `Tc` and the
/// relative excess `rise` of the breakaway torque.
pub fn dry_friction(m: &mut Model, part: &str, what: &str, [unit, force]: [&str; 2], x: Expr) {
    let doc =
        "dry friction with sticking: a constant torque against the motion, and at rest up to the breakaway torque";
    let (mut coulomb, mut rise) = (Expr::from(0), Expr::from(0));
    let effect = m.part_effect("dry_friction", part, doc, |m| {
        let doc = format!("Coulomb friction of the {what}: constant, against the motion");
        coulomb = m.parameter(&named("Tc", part), force, None, Range::NotNegative, &doc);
        let doc = format!("excess of the breakaway torque of the {what} over its Coulomb friction, relative to that");
        rise = m.parameter(&named("rise", part), "1", Some(0.0), Range::NotNegative, &doc);
    });
    let mut slip = m.switch(&named("slip", part), unit, x, &effect, &format!("dry friction of the {what}"));
    let direction = slip.factor(&named("dir", part), 0);
    let (rate, resisted, breakaway) = (slip.over().dot(), slip.reaction(), coulomb * (1 + rise));
    slip.mode("stuck", &[0.into()])
        .holds()
        .rests()
        .counts("stuck")
        .until("forward", breakaway - resisted)
        .until("backward", breakaway + resisted);
    slip.mode("forward", &[1.into()]).until("stuck", rate);
    slip.mode("backward", &[Expr::from(-1)]).until("stuck", -rate);
    slip.loss(direction * coulomb);
    let slip = slip.over();
    observed::friction(m, &effect, part, [what, force], slip);
}
