//! Propagators of small disturbances of a steady motion, z' = A(t) z with z = (e, e'/omega) and the motions e that are not rigid.
//!
//! For forces that are not linear, A has their derivatives at the steady motion. Laws of friction follow curves within a stretch, so that A
//! varies there. It is integrated in steps of the fourth order in h, exp(h (A1 + A2)/2 + sqrt(3) h² (A2 A1 - A1 A2)/12), with A at the two
//! Gauss points (S. Blanes et al., Phys. Rep. 470, 2009, Magnus expansion).

use nalgebra::DMatrix;

use super::{Split, Stretch};
use crate::analysis::steady::SteadyLaw;
use crate::engine::Refusal;
use crate::engine::system::System;
use crate::tolerance::analysis::{MAGNUS_SPAN, MAGNUS_STEPS};

/// The propagator over a stretch.
///
/// # Errors
/// Those of [`System::linearised`].
pub fn propagator(
    system: &System,
    courses: &[SteadyLaw],
    stretch: &Stretch,
    split: &Split,
    omega: f64,
) -> Result<DMatrix<f64>, Refusal> {
    let whole = split.generator(system, &stretch.levels, omega)?;
    if courses.iter().all(|course| course.curves.is_empty()) {
        return Ok((whole * stretch.time).exp());
    }
    let steps = (stretch.time * whole.norm() / MAGNUS_SPAN).ceil().clamp(1.0, MAGNUS_STEPS);
    let h = stretch.time / steps;
    let at = |t: f64| split.generator(system, &courses.iter().map(|course| course.at(t)).collect::<Vec<_>>(), omega);
    let mut propagator = DMatrix::identity(whole.nrows(), whole.nrows());
    for step in 0..steps as usize {
        let middle = stretch.begin + (step as f64 + 0.5) * h;
        let apart = h * 3f64.sqrt() / 6.0;
        let (first, second) = (at(middle - apart)?, at(middle + apart)?);
        let twist = &second * &first - &first * &second;
        propagator = ((first + second) * (0.5 * h) + twist * (3f64.sqrt() / 12.0 * h * h)).exp() * propagator;
    }
    Ok(propagator)
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
