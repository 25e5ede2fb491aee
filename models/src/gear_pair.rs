//! Two spur gears on rigid shafts: the model of the paper, Oh, Grosh & Barber (2005), Fig. 1.

use std::f64::consts::TAU;

use gearsim_derive::{GearData, Model, Range, Start, half};

use crate::components::{
    Mesh, Sliding, machines, mesh_stiffness, observed, play, pressure_tangent, sliding_friction, transmission_error,
};

/// Coordinates: the mean rotation theta and the relative deflection phi, both scaled so that one tooth pitch is 2 pi.
#[allow(non_snake_case)] // the paper's symbols
pub fn gear_pair(m: &mut Model) {
    m.title("two spur gears on rigid shafts");
    m.source("Oh, Grosh & Barber (2005), J. Vib. Acoust. 127(2), doi:10.1115/1.1891815");

    let N1 = m.gear_data(GearData::Teeth, "N1", Some(24.0), "number of teeth of the driving gear");
    let N2 = m.gear_data(GearData::Teeth, "N2", Some(96.0), "number of teeth of the driven gear");
    let I1 = m.parameter("I1", "kg*m^2", None, Range::Positive, "moment of inertia of the driving gear");
    let I2 = m.parameter("I2", "kg*m^2", None, Range::Positive, "moment of inertia of the driven gear");
    let zeta = m.parameter("zeta", "1", Some(0.0), Range::NotNegative, "damping factor of phi at the mid stiffness");
    let T0 = m.parameter(
        "T0",
        "N*m",
        None,
        Range::Any,
        "torque per tooth: T0 N1 drives the driving gear, T0 N2 loads the driven gear",
    );

    let theta = m.coordinate("theta", "rad", Start::At(0.0), "mean rotation, (N1 theta1 + N2 theta2)/2");
    let phi = m.coordinate("phi", "rad", Start::Static, "relative deflection, (N1 theta1 - N2 theta2)/2");
    let q1 = theta + phi; // N1 theta1
    let q2 = theta - phi; // N2 theta2

    m.kinetic(half(I1 * (q1.dot() / N1).sq()));
    m.kinetic(half(I2 * (q2.dot() / N2).sq()));

    let k = mesh_stiffness(
        m,
        "k",
        "N*m",
        theta,
        TAU,
        "mesh stiffness, 2 kt (rb1/N1)^2 with kt along the line of action, rb1 the base radius",
    );
    let e = transmission_error(
        m,
        ["e", ""],
        "rad",
        theta,
        TAU,
        "transmission error in phi, et N1/(2 rb1) with et along the line of action",
    );
    let gap = play(m, "", "mesh in phi, bt N1/(2 rb1) with bt along the line of action", "rad", phi - e);
    m.potential(k.value * gap.touch * gap.over.sq());

    let _M1 = m.constant("M1", 2 * m.inverse_mass(theta, phi));
    let M2 = m.constant("M2", 2 * m.inverse_mass(phi, phi));

    m.effect("damping", "Rayleigh damping of the relative motion, with the damping factor zeta", |m| {
        let C = m.constant("C", 2 * zeta * (k.mid / M2).sqrt());
        m.dissipation(C * gap.damp * gap.over.dot().sq());
    });
    m.effect("torques", "constant driving and load torque in balance", |m| {
        m.torque("drive", T0, q1, "torque T0 N1 on the driving gear");
        m.torque("load", -T0, q2, "torque -T0 N2 on the driven gear");
    });

    // In units of phi, with h = rb1/N1 and the base radius rb1: V = k phi², F = k phi/h and delta = 2 h phi, so that h cancels in the work.
    let angle = 2 * phi / N1;
    m.output(
        "dte",
        "rad",
        angle,
        "dynamic transmission error as a rotation of the driving gear, theta1 - N2/N1 theta2",
    );
    let torque = half(N1 * (m.spring(gap.over) + m.damper(gap.over)));
    let torque = m.output("mesh_torque", "N*m", torque, "torque of the mesh on the driving gear, damper included");
    let given = "power that the driving gear gives to the mesh: torque times its speed";
    m.output("mesh_power", "W", torque * (q1 / N1).dot(), given);
    let doc = "deflection of the mesh as a rotation of the driving gear, backlash not taken off";
    m.output("mesh_deflection", "rad", 2 * (phi - e) / N1, doc);
    let taken = m.damper(gap.over) * gap.over.dot();
    m.output("mesh_loss", "W", taken, "power that the damper of the mesh takes");
    for (part, what, rotation) in [("1", "driving gear", q1 / N1), ("2", "driven gear", q2 / N2)] {
        observed::rotor(m, part, what, rotation);
    }

    let tau = 2 * pressure_tangent(m) * phi;
    let mesh = Mesh { stiffness: k.value * gap.touch, delta: gap.over, flank: None };
    sliding_friction(m, "", "mesh", "rad", mesh, Sliding { phase: theta, tau, psi: q1 / N1 + q2 / N2 });

    // The torque T0 acts on both gears. The machines, whose torque depends on the speed, act on each gear separately.
    machines(m, "motor", "driving gear", q1 / N1);
    machines(m, "load", "driven gear", q2 / N2);

    m.motion("speed", "rad/s", &[(theta, N1)], "rotational speed of the driving gear");
}
