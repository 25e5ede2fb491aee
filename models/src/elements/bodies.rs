//! Elements with inertia.

use gearsim_derive::{Expr, GearData, Model, Range, Start, half};

use crate::components::rotor as add_rotor;

/// A rotor.
pub fn rotor(m: &mut Model) {
    head(m, "a rotor");
    let theta = m.coordinate("theta", "rad", Start::Static, "rotation");
    add_rotor(m, "x", "rotor {}", theta);
    damping(m);
}

/// The masses of planets whose centres turn with a carrier: T = n m (a theta')^2/2 with the distance a = r_s (Z_r/Z_s + 1)/(2 cos alpha)
/// of the centres. Their rotations are those of rotors.
#[allow(non_snake_case)] // the field's symbols
pub fn planets(m: &mut Model) {
    head(m, "the masses of planets on a carrier");
    let theta = m.coordinate("theta", "rad", Start::Static, "rotation of the carrier");
    let n = m.parameter("np_x", "1", None, Range::Positive, "number of planets of {}");
    let mass = m.parameter("mp_x", "kg", None, Range::Positive, "mass of a planet of {}");
    let Z_s = m.gear_data(GearData::Teeth, "Zs_x", None, "number of teeth of the sun of {}");
    let Z_r = m.gear_data(GearData::Teeth, "Zr_x", None, "number of teeth of the ring of {}");
    let r_s = m.gear_data(GearData::BaseRadius, "rs_x", None, "base radius of the sun of {}");
    let alpha = "working pressure angle of {}";
    let alpha = m.gear_data(GearData::PressureAngle, "alpha_x", Some(20f64.to_radians()), alpha);
    let a = m.constant("a", half(r_s / Z_s * (Z_r + Z_s)) / alpha.cos());
    m.kinetic(half(n * mass * (a * theta.dot()).sq()));
    damping(m);
}

fn head(m: &mut Model, what: &str) {
    m.title(what);
    m.source("an element of trains");
}

/// Damping in proportion to inertia. Declares `alpha_M`.
#[allow(non_snake_case)] // the field's symbol
fn damping(m: &mut Model) {
    let alpha_M = m.parameter("alpha_M", "1/s", Some(0.0), Range::NotNegative, "damping in proportion to inertia");
    m.effect("damping", "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness", |m| {
        m.rayleigh(alpha_M, Expr::from(0));
        let taken = 2 * alpha_M * m.kinetic_energy();
        m.output("inertia_damping_loss", "W", taken, "power that the damping in proportion to inertia takes");
    });
}
