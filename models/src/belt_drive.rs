//! A serpentine belt drive: a crankshaft drives an accessory; a tensioner arm with a spring keeps the slack span in tension.

use gearsim_derive::{Expr, Model, Range, Start, half};

use crate::components::{damping, driven, end_stop, ground, loaded, rotor};

/// Coordinates: the rotation of the crankshaft, which grows, and two small ones: the stretch of the pulling span and the
/// rotation of the tensioner arm.
#[allow(non_snake_case)] // the field's symbols
pub fn belt_drive(m: &mut Model) {
    m.title("a belt drive with a sprung tensioner");
    m.source("rotational model of Beikmann, Perkins & Ulsoy (1996), J. Vib. Acoust. 118(3), with one accessory");

    let r1 = m.parameter("r1", "m", None, Range::Positive, "radius of the crankshaft pulley");
    let r2 = m.parameter("r2", "m", None, Range::Positive, "radius of the accessory pulley");
    let a = m.parameter("a", "m", None, Range::Positive, "length that the slack span gains per radian of the arm");
    let theta = m.coordinate("theta", "rad", Start::At(0.0), "rotation of the crankshaft");
    let s = m.coordinate("s", "m", Start::Static, "stretch of the pulling span, relative to its tension at rest");
    let psi =
        m.coordinate("psi", "rad", Start::Static, "rotation of the tensioner arm, relative to its position at rest");
    let theta2 = (r1 * theta - s) / r2;

    rotor(m, "1", "crankshaft", theta);
    rotor(m, "2", "accessory", theta2);
    rotor(m, "t", "tensioner arm", psi);
    // A span of the belt is a linear spring.
    let span = |m: &mut Model, part: &str, what: &str, stretch: Expr| {
        let k =
            m.parameter(&format!("k{part}"), "N/m", None, Range::Positive, &format!("stiffness of the {what} span"));
        let stretch = m.deflection(&format!("s{part}"), stretch);
        m.potential(half(k * stretch.sq()));
        let doc = format!("force in the {what} span beyond its tension at rest, damper included");
        m.output(&format!("span_force{part}"), "N", m.spring(stretch) + m.damper(stretch), &doc);
        let doc = format!("power that the damper of the {what} span takes");
        m.output(&format!("span_loss{part}"), "W", m.damper(stretch) * stretch.dot(), &doc);
    };
    span(m, "_p", "pulling", s);
    span(m, "_s", "slack", a * psi - s);
    ground(m, "t", "spring of the tensioner arm", psi);
    end_stop(m, "t", "tensioner arm", ["rad", "N*m"], psi);
    driven(m, "crank", "crankshaft", theta);
    loaded(m, "load", "accessory", theta2);
    damping(m);
    m.motion("speed", "rad/s", &[(theta, 1.into())], "rotational speed of the crankshaft");
}
