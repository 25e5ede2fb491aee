//! An overrunning (one-way) clutch, in the effect `overrunning_clutch`: it drives in one direction and lets the driven side run ahead.
//!
//! | mode | while | torque on the driven side |
//! | --- | --- | --- |
//! | locked | the torque R that the clutch transmits is between -Tdrag and Tmax | R, so that the rate is zero |
//! | overrun | the driven side is faster, x' < 0 | -Tdrag |
//! | slips | the driving side is faster, x' > 0: the clutch is overloaded | Tmax |
//!
//! The torque is bounded, as that of any real clutch: an impulse of a mesh makes it slip for an instant. In scenes without the effect the
//! clutch is open. Compare Modelica.Mechanics.Rotational.Components.OneWayClutch.

use gearsim_derive::{Expr, Model, Range};

use super::{named, observed};

/// A clutch between two rotors. `lead` \[rad\] is the rotation of the driving rotor minus the rotation of the driven rotor. Declares the
/// capacity `Tmax` and the drag torque `Tdrag`.
pub fn overrunning_clutch(m: &mut Model, part: &str, what: &str, lead: Expr) {
    let doc =
        "a one-way clutch: locked while it drives, free while the driven side is faster; without it the clutch is open";
    let (mut capacity, mut drag) = (Expr::from(0), Expr::from(0));
    let effect = m.part_effect("overrunning_clutch", part, doc, |m| {
        let doc = format!("capacity of the {what}: the largest torque that it transmits");
        capacity = m.parameter(&named("Tmax", part), "N*m", None, Range::Positive, &doc);
        let doc = format!("drag torque of the {what} while it overruns");
        drag = m.parameter(&named("Tdrag", part), "N*m", Some(0.0), Range::NotNegative, &doc);
    });
    let mut clutch = m.switch(&named("lead", part), "rad", lead, &effect, &format!("modes of the {what}"));
    let slips = clutch.factor(&named("slips", part), 0);
    let drags = clutch.factor(&named("drags", part), 0);
    let (rate, transmitted) = (clutch.over().dot(), clutch.reaction());
    let [zero, one] = [0, 1].map(Expr::from);
    clutch
        .mode("locked", &[zero, zero])
        .holds()
        .rests()
        .counts("clutch locked")
        .until("overrun", transmitted + drag)
        .until("slips", capacity - transmitted);
    clutch.mode("overrun", &[zero, -one]).until("locked", -rate);
    clutch.mode("slips", &[one, zero]).until("locked", rate);
    clutch.loss(slips * capacity + drags * drag);
    let lead = clutch.over();
    observed::clutch(m, &effect, part, what, lead);
}
