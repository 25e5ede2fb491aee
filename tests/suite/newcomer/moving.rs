//! Models whose inertia depends on the coordinates.

use gearsim_derive::{Expr, Model, Range, Start, half};
use gearsim_models::components::mesh_stiffness;
use gearsim_models::components::{rotor, slider_crank, universal_joint};

/// A pendulum in its horizontal displacement x = l sin phi: T = m l^2 x'^2/(2 (l^2 - x^2)), V = m g (l - (l^2 - x^2)^(1/2)).
pub fn pendulum(m: &mut Model) {
    m.title("a pendulum in its horizontal displacement");
    m.source("textbooks of mechanics");

    let [mass, l, g] = [("m", "kg"), ("l", "m"), ("g", "m/s^2")]
        .map(|(name, unit)| m.parameter(name, unit, None, Range::Positive, "of the pendulum"));
    let x = m.coordinate("x", "m", Start::At(0.0), "horizontal displacement");
    let height = l - (l.sq() - x.sq()).sqrt();
    m.kinetic(half(mass * (x.dot().sq() + height.dot().sq())));
    m.potential(mass * g * height);
}

/// Two pendulums, one below the other, in Cartesian coordinates of the masses.
pub fn double_pendulum(m: &mut Model) {
    m.title("a double pendulum");
    m.source("textbooks of mechanics");

    let g = m.parameter("g", "m/s^2", None, Range::Positive, "gravity");
    let (mut x, mut y) = (Expr::from(0), Expr::from(0));
    for part in ["1", "2"] {
        let mass = m.parameter(&format!("m{part}"), "kg", None, Range::Positive, "mass");
        let l = m.parameter(&format!("l{part}"), "m", None, Range::Positive, "length");
        let a = m.coordinate(&format!("a{part}"), "rad", Start::At(0.0), "angle from the vertical");
        (x, y) = (l * a.sin() + x, y - l * a.cos());
        m.kinetic(half(mass * x.dot().sq()));
        m.kinetic(half(mass * y.dot().sq()));
        m.potential(mass * g * y);
    }
}

/// A flywheel that turns a slider-crank, in an effect, and a load behind a universal joint, in another.
pub fn linkage(m: &mut Model) {
    m.title("a flywheel that turns a slider-crank and a universal joint");
    m.source("textbooks of mechanics");

    let theta = m.coordinate("theta", "rad", Start::At(0.0), "rotation of the flywheel");
    let psi = m.coordinate("psi", "rad", Start::At(0.0), "rotation of a wheel on a spring");
    rotor(m, "f", "flywheel", theta);
    rotor(m, "w", "wheel on a spring", psi);
    let k = mesh_stiffness(m, "k", "N*m/rad", theta, 1.0, "stiffness of the spring of the wheel");
    m.potential(half(k.value * psi.sq()));
    m.effect("crank", "a slider-crank on the flywheel", |m| {
        slider_crank(m, "p", "piston", theta);
    });
    m.effect("joint", "a rotor behind a universal joint", |m| {
        let speed = universal_joint(m, "", theta);
        let inertia = m.parameter("I_o", "kg*m^2", None, Range::Positive, "moment of inertia behind the joint");
        m.kinetic(half(inertia * speed.sq()));
    });
    m.motion("speed", "rad/s", &[(theta, 1.into())], "rotational speed of the flywheel");
}
