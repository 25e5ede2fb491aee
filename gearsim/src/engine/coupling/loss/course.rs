//! Speeds of modes whose rates are slow for the duration of a flight: u(x) = sum w_p x^p with x = time/t in [0, 1].

use nalgebra::{Complex, DMatrix, DVector, DVectorView};

use crate::engine::mode::Mode;

/// Number of terms. With rates up to `SERIES_SPAN`/t the first omitted term is 0.5^16/16! = 7e-19 of the first.
const TERMS: usize = 16;

/// The coefficients w_p (TERMS vectors).
pub struct Course(Vec<DVector<f64>>);

impl Course {
    /// No motion, in `n` undamped modes.
    pub fn zero(n: usize) -> Course {
        Course(vec![DVector::zeros(n); TERMS])
    }

    /// Adds u = X1 a' + X2 a'' of a mode with the speed and acceleration `rates` at the start, for the duration `t` \[s\]. The derivatives of
    /// a' follow from one another, so that no term cancels.
    pub fn add(&mut self, mode: &Mode, rates: (f64, f64), t: f64, [x1, x2]: [DVectorView<'_, f64>; 2]) {
        let (mut y, mut y_dot, mut scale) = (rates.0, rates.1, 1.0);
        for (p, w) in self.0.iter_mut().enumerate() {
            w.axpy(scale * y, &x1, 1.0);
            w.axpy(scale * y_dot, &x2, 1.0);
            (y, y_dot) = (y_dot, mode.next(y, y_dot));
            scale *= t / (p + 1) as f64;
        }
    }

    /// The coefficients of G u.
    pub fn times(&self, damping: &DMatrix<f64>) -> Vec<DVector<f64>> {
        self.0.iter().map(|w| damping * w).collect()
    }

    /// ∫ uᵀG u dx over [0, 1], where `forces` are the coefficients of G u.
    pub fn integral(&self, forces: &[DVector<f64>]) -> f64 {
        let each = self.0.iter().enumerate();
        each.flat_map(|(p, w)| forces.iter().enumerate().map(move |(q, g)| w.dot(g) / (p + q + 1) as f64)).sum()
    }
}

/// I_p(z) = ∫ x^p e^{z x} dx over [0, 1] for p = 0, 1, ... (TERMS numbers), with Re z <= 0.
///
/// By parts, z I_p = e^z - p I_{p-1}. This recursion is stable upwards where p < |z|, and downwards where p > |z|. Downwards it begins so far
/// up that the error of the first value has no effect.
pub fn moments(z: Complex<f64>) -> [Complex<f64>; TERMS] {
    let (end, mut moments) = (z.exp(), [Complex::from(0.0); TERMS]);
    let upwards = (z.norm() as usize).min(TERMS);
    if upwards > 0 {
        moments[0] = (end - 1.0) / z;
    }
    for p in 1..upwards {
        moments[p] = (end - moments[p - 1] * p as f64) / z;
    }
    let mut above = Complex::from(0.0);
    for p in (upwards + 1..FIRST).rev() {
        above = (end - z * above) / p as f64;
        if p <= TERMS {
            moments[p - 1] = above;
        }
    }
    moments
}

/// Where the downward recursion begins. From there to p = TERMS the error of the first value is multiplied by |z|/p each time, in all by
/// 1e-28 or less.
const FIRST: usize = 5 * TERMS;
