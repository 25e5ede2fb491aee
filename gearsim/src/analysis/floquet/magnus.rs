//! Propagators P of a linear system whose matrix varies, P' = A(t) P, by the Magnus expansion of the sixth order with A at the three Gauss
//! points of a step (S. Blanes et al., Phys. Rep. 470, 2009, Sec. 5.4). It is exact where A is constant, however fast the vibrations are.

use nalgebra::DMatrix;

use super::FloquetError;
use crate::tolerance::analysis::{MAGNUS_ERROR, MAGNUS_SHARE, MAGNUS_SPAN, MAGNUS_STEPS};

/// Maximum number of terms of the series of an exponential. Exponents of norms up to ten need fewer terms.
const MOST_TERMS: u32 = 60;

/// The Gauss points of a step of length `h` that begins at `t` [s].
pub(super) fn instants(t: f64, h: f64) -> [f64; 3] {
    let (middle, apart) = (t + 0.5 * h, h * 15f64.sqrt() / 10.0);
    [middle - apart, middle, middle + apart]
}

/// Advances P by a step of length `h` [s]. `at` is A at the Gauss points.
pub(super) fn advance(at: &[DMatrix<f64>; 3], h: f64, p: &mut DMatrix<f64>) {
    multiply_by_exponential(&exponent(at, h), p);
}

/// P over the time `span` [s] from `begin` on, in at least `least` steps. A step is halved if P over it differs from the product of P over
/// its halves by more than the tolerated error: friction changes fast near a pitch point, and slowly elsewhere.
///
/// # Errors
/// Those of `generator`, which computes A at a time; if P overflows; if a step would become too short.
pub(super) fn propagator<E>(
    generator: impl Fn(f64) -> Result<DMatrix<f64>, E>,
    [begin, span]: [f64; 2],
    least: f64,
) -> Result<DMatrix<f64>, FloquetError>
where
    FloquetError: From<E>,
{
    let first = generator(begin)?;
    let steps = (span * first.norm() / MAGNUS_SPAN).max(least).ceil().clamp(1.0, MAGNUS_STEPS);
    let parts = Parts { generator, span, size: first.nrows() };
    let h = span / steps;
    let mut p = DMatrix::identity(parts.size, parts.size);
    for step in 0..steps as usize {
        let t = begin + step as f64 * h;
        p = parts.refined(t, h, parts.step(t, h)?)? * p;
    }
    Ok(p)
}

/// Steps through a stretch of the length `span` \[s\].
struct Parts<G> {
    generator: G,
    span: f64,
    size: usize,
}

impl<E, G: Fn(f64) -> Result<DMatrix<f64>, E>> Parts<G>
where
    FloquetError: From<E>,
{
    /// P over one step.
    fn step(&self, t: f64, h: f64) -> Result<DMatrix<f64>, FloquetError> {
        let [before, middle, after] = instants(t, h).map(&self.generator);
        let mut p = DMatrix::identity(self.size, self.size);
        advance(&[before?, middle?, after?], h, &mut p);
        Ok(p)
    }

    /// P over a step, in as many parts as the tolerated error requires. `coarse` is P over the undivided step.
    fn refined(&self, t: f64, h: f64, coarse: DMatrix<f64>) -> Result<DMatrix<f64>, FloquetError> {
        let half = 0.5 * h;
        let [first, second] = [self.step(t, half)?, self.step(t + half, half)?];
        let fine = &second * &first;
        if fine.iter().any(|x| !x.is_finite()) {
            return Err(FloquetError::Overflow);
        }
        // The tolerated error is shared among the steps by their lengths, but no share is as small as rounding errors.
        let tolerated = MAGNUS_ERROR * (h / self.span).max(MAGNUS_SHARE);
        if (&fine - coarse).amax() <= tolerated * fine.amax() {
            return Ok(fine);
        }
        if half * MAGNUS_STEPS < self.span {
            return Err(FloquetError::Unresolved { most: MAGNUS_STEPS });
        }
        let first = self.refined(t, half, first)?;
        Ok(self.refined(t + half, half, second)? * first)
    }
}

/// The exponent of a step of length `h` \[s\] by Magnus' expansion of the sixth order. The arguments are A at the three Gauss points.
fn exponent([before, middle, after]: &[DMatrix<f64>; 3], h: f64) -> DMatrix<f64> {
    let twist = |a: &DMatrix<f64>, b: &DMatrix<f64>| a * b - b * a;
    let a1 = middle * h;
    let a2 = (after - before) * (h * 15f64.sqrt() / 3.0);
    let a3 = (after + before - middle * 2.0) * (h * 10.0 / 3.0);
    let c1 = twist(&a1, &a2);
    let c2 = twist(&a1, &(&a3 * 2.0 + &c1)) * (-1.0 / 60.0);
    let outer = twist(&(&a1 * -20.0 - &a3 + c1), &(a2 + c2));
    a1 + a3 * (1.0 / 12.0) + outer * (1.0 / 240.0)
}

/// Multiplies phi by exp(a) from the left, by the power series. The norm of `a` is about one: the angle of the fastest vibration in a step
/// \[rad\].
fn multiply_by_exponential(a: &DMatrix<f64>, phi: &mut DMatrix<f64>) {
    let mut term = phi.clone();
    for k in 1..=MOST_TERMS {
        term = a * term * (1.0 / f64::from(k));
        *phi += &term;
        if term.amax() <= 0.1 * f64::EPSILON * phi.amax() {
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The propagator of Hill's equation x'' = -(2 + cos 3t) x over one unit of time, in `n` steps.
    fn hill(n: u32) -> DMatrix<f64> {
        let h = 1.0 / f64::from(n);
        let generator = |t: f64| DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -2.0 - (3.0 * t).cos(), 0.0]);
        let mut phi = DMatrix::identity(2, 2);
        for step in 0..n {
            advance(&instants(f64::from(step) * h, h).map(generator), h, &mut phi);
        }
        phi
    }

    #[test]
    fn magnus_is_of_the_sixth_order() {
        let exact = hill(256);
        let error = |n| (hill(n) - &exact).amax();
        let orders = [2, 4].map(|n| (error(n) / error(2 * n)).log2());
        assert!(orders.iter().all(|order| (order - 6.0).abs() < 0.3), "{orders:?}");
        assert!((exact.determinant() - 1.0).abs() < 1e-13);
    }
}
