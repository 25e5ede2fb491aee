//! A model with several static equilibria.

use gearsim_derive::{Model, Range, Start, half};

/// A mass in a potential with two wells, V = k (x^2 - a^2)^2 / (8 a^2), under a constant force.
#[allow(non_snake_case)] // the field's symbols
pub fn double_well(m: &mut Model) {
    m.title("a mass in a potential with two wells");
    m.source("Duffing's oscillator, e.g. Guckenheimer & Holmes (1983), Section 2.2");

    let mass = m.parameter("m_p", "kg", Some(1.0), Range::Positive, "mass");
    let a = m.parameter("a", "m", Some(0.1), Range::Positive, "place of a well");
    let k = m.parameter("k_w", "N/m", Some(1000.0), Range::Positive, "stiffness in a well");
    let F = m.parameter("F", "N", Some(0.0), Range::Any, "constant force");
    let x = m.coordinate("x", "m", Start::Static, "place of the mass");
    m.kinetic(half(mass * x.dot().sq()));
    m.potential(k / (8 * a.sq()) * (x.sq() - a.sq()).sq());
    m.torque("push", F, x, "constant force on the mass");
}
