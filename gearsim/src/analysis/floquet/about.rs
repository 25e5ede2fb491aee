//! Propagators of small disturbances of a steady motion: z' = A(t) z with z = (e, e'/omega). e are the motions that are not rigid, and
//! omega is a unit of speed [1/s].
//!
//! For nonlinear forces, A contains their derivatives at the steady motion. If stiffnesses or laws of friction follow curves within a
//! stretch, A varies there, and its propagator is integrated ([`super::magnus`]).

use nalgebra::DMatrix;

use super::{FloquetError, Split, Stretch, magnus};
use crate::analysis::steady::SteadyLaw;
use crate::engine::Refusal;
use crate::engine::system::System;

/// The propagator over a stretch. `watch` is called at each step.
///
/// # Errors
/// Those of [`System::linearised`] and of [`magnus::propagator`].
pub fn propagator(
    system: &System,
    courses: &[SteadyLaw],
    stretch: &Stretch,
    split: &Split,
    omega: f64,
    watch: &dyn Fn(),
) -> Result<DMatrix<f64>, FloquetError> {
    if courses.iter().all(|course| course.curves.is_empty()) {
        return Ok((split.generator(system, &stretch.levels, omega)? * stretch.time).exp());
    }
    let levels = |t: f64| courses.iter().map(|course| course.at(t)).collect::<Vec<_>>();
    // At least two steps per period of the highest harmonic.
    let waves = courses.iter().map(|course| course.highest_order() * course.frequency() * stretch.time);
    let least = 2.0 * waves.fold(0.0, f64::max);
    let generator = |t: f64| {
        watch();
        split.generator(system, &levels(t), omega)
    };
    magnus::propagator(generator, [stretch.begin, stretch.time], least)
}

impl Split {
    /// A with the law values `k`.
    fn generator(&self, system: &System, k: &[f64], omega: f64) -> Result<DMatrix<f64>, Refusal> {
        let m = system.linearised(k)?;
        let e = self.elastic;
        let onto = &self.onto * &m.mobility;
        let mut a = DMatrix::zeros(2 * e, 2 * e);
        a.view_mut((0, e), (e, e)).fill_diagonal(omega);
        a.view_mut((e, 0), (e, e)).copy_from(&(&onto * &m.stiffness * &self.basis * (-1.0 / omega)));
        a.view_mut((e, e), (e, e)).copy_from(&(&onto * &m.damping * &self.basis * -1.0));
        Ok(a)
    }
}
