//! End stops of a displacement, in the effect `end_stop`: elastic, with a damper that never pulls. Beyond a stop by the depth x the spring
//! has the force F_s = ks x and the damper would have F_d = cs x'.
//!
//! | mode | while | force of the stop |
//! | --- | --- | --- |
//! | free | between the stops | 0 |
//! | upper, lower | beyond a stop, -F_s <= F_d <= F_s | F_s + F_d |
//! | upper_hit, lower_hit | F_d > F_s | 2 F_s |
//! | upper_loose, lower_loose | F_d < -F_s | 0 |
//!
//! The damper is limited as in Modelica.Mechanics.Rotational.Components.ElastoBacklash2: the force does not step, and each mode is a linear
//! cell. One stop and no damper is the oscillator of S. W. Shaw & P. J. Holmes, J. Sound Vib. 90 (1983), 129-155.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// Stops of the displacement `x` [rad or m], which is linear in the coordinates. `unit` is that of x, `force` that of the stops, N*m or N.
/// Declares the places `hi` and `lo` of the upper and the lower stop, their stiffness `ks` and their damping `cs`.
pub fn end_stop(m: &mut Model, part: &str, what: &str, [unit, force]: [&str; 2], x: Expr) {
    let doc = "end stops: elastic, with a damper that never pulls, beyond an upper and a lower limit of a displacement";
    let mut limits = [Expr::from(0); 2];
    let (mut k, mut c) = (Expr::from(0), Expr::from(0));
    let effect = m.part_effect("end_stop", part, doc, |m| {
        limits = [("hi", "upper"), ("lo", "lower")].map(|(name, which)| {
            let doc = format!("place of the {which} stop of the {what}");
            m.parameter(&named(name, part), unit, None, Range::Any, &doc)
        });
        let doc = format!("stiffness of the stops of the {what}");
        k = m.parameter(&named("ks", part), &format!("{force}/{unit}"), None, Range::Positive, &doc);
        let doc = format!("damping of the stops of the {what}");
        c = m.parameter(&named("cs", part), &format!("{force}*s/{unit}"), Some(0.0), Range::NotNegative, &doc);
    });
    let mut stop = m.switch(&named("past", part), unit, x, &effect, &format!("end stops of the {what}"));
    let (touch, damp) = (named("at_stop", part), named("stop_damp", part));
    stop.damped(&touch, &damp);
    let touch = stop.factor(&touch, 1);
    stop.offset(&named("stop", part));
    let (damp, clip) = (stop.factor(&damp, 1), stop.factor(&named("stop_clip", part), 0));
    let (past, spring, damper) = (stop.over(), stop.spring(), stop.damper());
    let [zero, one] = [0, 1].map(Expr::from);
    let sides = [("upper", one, limits[0]), ("lower", -one, limits[1])];
    stop.mode("free", &[zero; 4]).rests().until("upper", limits[0] - past).until("lower", past - limits[1]);
    for (name, side, limit) in sides {
        let (hit, loose) = (format!("{name}_hit"), format!("{name}_loose"));
        stop.mode(name, &[one, limit, one, zero])
            .rests()
            .counts("stop met")
            .unless("free", side * past)
            .until(&loose, side * (spring + damper))
            .until(&hit, side * (spring - damper));
        stop.mode(&hit, &[one, limit, zero, one])
            .counts("stop met")
            .unless("free", side * past)
            .until(name, side * (damper - spring));
        stop.mode(&loose, &[one, limit, zero, -one])
            .counts("stop met")
            .until("free", side * past)
            .until(name, -side * (spring + damper));
    }
    stop.loss(clip * spring);
    m.effect(&effect, doc, |m| {
        m.potential(half(k * touch * past.sq()));
        m.dissipation(half(c * damp * past.dot().sq()));
    });
    observed::end_stop(m, &effect, part, [what, force], past);
}
