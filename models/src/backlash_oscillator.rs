//! A rotor connected to the ground by a spring and a damper with play.

use gearsim_derive::{Model, Range, Start, half};

use crate::components::{driven, play, rotor};

/// Coordinate: the rotation phi of the rotor. Without the effect `backlash` the spring always acts.
pub fn backlash_oscillator(m: &mut Model) {
    m.title("a rotor on a spring and damper with play");
    m.source("Modelica Standard Library, Modelica.Mechanics.Rotational.Examples.Backlash");

    let phi = m.coordinate("phi", "rad", Start::At(0.0), "rotation");
    rotor(m, "", "rotor", phi);
    let c = m.parameter("c", "N*m/rad", None, Range::NotNegative, "stiffness of the contact");
    let gap = play(m, "", "contact", "rad", phi);
    m.potential(half(c * gap.touch * gap.over.sq()));
    m.effect("damping", "a damper parallel to the spring", |m| {
        let d = m.parameter("d", "N*m*s/rad", None, Range::NotNegative, "damping of the contact");
        m.dissipation(half(d * gap.damp * gap.over.dot().sq()));
    });
    driven(m, "motor", "rotor", phi);
    m.output(
        "contact_torque",
        "N*m",
        m.spring(gap.over) + m.damper(gap.over),
        "torque of the contact, damper included",
    );
    m.output("damper_loss", "W", m.damper(gap.over) * gap.over.dot(), "power that the damper of the contact takes");
    m.motion("speed", "rad/s", &[(phi, 1.into())], "rotational speed");
}
