//! Rayleigh damping, C = alpha_M M + beta_K K with the mid values of the mesh stiffnesses, in the effect `damping`.

use gearsim_derive::{Model, Range};

/// Damps every rotor and every spring that the model has so far: call it last. Declares `alpha_M` and `beta_K`.
#[allow(non_snake_case)] // the field's symbols
pub fn damping(m: &mut Model) {
    let alpha_M = m.parameter("alpha_M", "1/s", Some(0.0), Range::NotNegative, "damping in proportion to inertia");
    let beta_K = m.parameter("beta_K", "s", Some(0.0), Range::NotNegative, "damping in proportion to stiffness");
    m.effect("damping", "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness", |m| {
        m.rayleigh(alpha_M, beta_K);
        let taken = 2 * alpha_M * m.kinetic_energy();
        m.output("inertia_damping_loss", "W", taken, "power that the damping in proportion to inertia takes");
    });
}
