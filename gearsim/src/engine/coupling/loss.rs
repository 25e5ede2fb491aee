//! Energy dissipated by modes that damping couples: ∫ uᵀG u dt with u = sum X1 a' + X2 a'', an integral of the speeds.
//!
//! In closed form, over all pairs of exponentials, with u = sum c phi e^{lambda t} and phi = X1 + lambda X2:
//!
//! ```text
//! ∫ uᵀG u dt = sum_{k,l} c_k c_l (phi_kᵀG phi_l) (e^{(lambda_k + lambda_l) t} - 1)/(lambda_k + lambda_l)
//! ```
//!
//! With e_k = e^{lambda_k t} - 1, one exponential for each mode, the numerator is e_k + e_l + e_k e_l. It cancels if two
//! eigenvalues are nearly opposite. The weight phi_kᵀG phi_l is then as small as their sum, because the dissipated energy is what
//! makes a mode decay. The error is therefore a rounding error of the energy of the modes.
//!
//! The two exponentials of a mode cancel if its rates are slow for the time t: a rigid motion with a weak damper of rate s is accelerated
//! by a as a t, but its exponentials have the size a/s. The speeds of such modes are a polynomial, their Taylor series w(x) = sum w_p x^p
//! with x = time/t ([`course`](self::course)). The integrals with it are
//!
//! ```text
//! ∫ e^{lambda t x} x^p dx = I_p(lambda t),   ∫ wᵀG w dx = sum w_pᵀG w_q/(p + q + 1)       over [0, 1]
//! ```
//!
//! Near critical damping the closed form cancels, and Gauss-Legendre quadrature is used.

use nalgebra::{Complex, DMatrix, DVector};

use crate::engine::modal::Coupled;
use crate::engine::mode::{GAUSS_16, Mode};
use crate::tolerance::modes::{DECAYED, EIGENVALUES_APART, QUADRATURE_PANEL, SERIES_SPAN};

use course::{Course, moments};

mod course;

/// The damped modes of one cell.
#[derive(Debug, Clone)]
pub struct Loss {
    modes: Vec<Mode>,
    /// X1, X2, G.
    by_speed: DMatrix<f64>,
    by_acceleration: DMatrix<f64>,
    damping: DMatrix<f64>,
    /// The closed form; `None` if two eigenvalues of a mode nearly coincide.
    closed: Option<Closed>,
}

/// The exponentials of all damped modes, and their weights phi_kᵀG phi_l/(lambda_k + lambda_l). If the sum of the two eigenvalues is zero,
/// the weight is not divided by it.
#[derive(Debug, Clone)]
struct Closed {
    /// For each exponential: index of the mode, lambda, and the other eigenvalue of the mode.
    exponents: Vec<(usize, Complex<f64>, Complex<f64>)>,
    weights: DMatrix<Complex<f64>>,
    /// phi = X1 + lambda X2 of each exponential.
    shapes: Vec<DVector<Complex<f64>>>,
}

impl Loss {
    pub fn new(coupled: &Coupled) -> Loss {
        let Coupled { modes, by_speed, by_acceleration, damping, .. } = coupled;
        let damped = |k: usize| {
            let seen = |x: &DMatrix<f64>| (damping * x.column(k)).amax() > 0.0;
            seen(by_speed) || seen(by_acceleration)
        };
        let damped: Vec<usize> = (0..modes.len()).filter(|&k| damped(k)).collect();
        Loss {
            closed: Closed::new(coupled, &damped),
            modes: modes.clone(),
            by_speed: by_speed.clone(),
            by_acceleration: by_acceleration.clone(),
            damping: damping.clone(),
        }
    }

    /// The integral from 0 to `t` \[s\], from the speeds a' and accelerations a'' of the modes at the start.
    pub fn until(&self, rates: &[(f64, f64)], t: f64) -> f64 {
        let Some(closed) = &self.closed else { return self.by_quadrature(rates, t) };
        let is_slow = |k: usize| self.modes[k].rate * t < SERIES_SPAN;
        let slow: Vec<usize> = closed.modes().filter(|&k| is_slow(k)).collect();
        let fast = closed.parts(rates, t, |k| !is_slow(k));
        if slow.is_empty() {
            return closed.of_exponentials(&fast);
        }
        let mut course = Course::zero(self.damping.nrows());
        slow.iter().for_each(|&k| {
            course.add(&self.modes[k], rates[k], t, [&self.by_speed, &self.by_acceleration].map(|x| x.column(k)))
        });
        let forces = course.times(&self.damping);
        closed.of_exponentials(&fast) + t * (closed.between(&fast, &forces, t) + course.integral(&forces))
    }

    /// Quadrature over panels. In each, the fastest mode that has not yet decayed turns by at most two radians, so that the
    /// 16-point rule is exact to rounding.
    fn by_quadrature(&self, rates: &[(f64, f64)], t: f64) -> f64 {
        let (mut begin, mut sum) = (0.0, 0.0);
        while begin < t {
            let alive = |mode: &&Mode| slowest(mode) * begin < DECAYED;
            let rate = self.modes.iter().filter(alive).map(|mode| mode.rate).fold(0.0, f64::max);
            let end = if rate > 0.0 { t.min(begin + QUADRATURE_PANEL / rate) } else { t };
            if end <= begin {
                break;
            }
            let half = 0.5 * (end - begin);
            for (x, weight) in GAUSS_16 {
                sum += weight
                    * half
                    * (self.power(rates, begin + half * (1.0 - x)) + self.power(rates, begin + half * (1.0 + x)));
            }
            begin = end;
        }
        sum
    }

    /// uᵀG u at the time `t`.
    fn power(&self, rates: &[(f64, f64)], t: f64) -> f64 {
        let speeds: Vec<(f64, f64)> = self
            .modes
            .iter()
            .zip(rates)
            .map(|(mode, &(v, a))| {
                let r = mode.response(t);
                let jerk = mode.next(v, a);
                (v + a * r.s1 - mode.omega2 * v * r.s2, a + jerk * r.s1 - mode.omega2 * a * r.s2)
            })
            .collect();
        let v = DVector::from_fn(speeds.len(), |i, _| speeds[i].0);
        let a = DVector::from_fn(speeds.len(), |i, _| speeds[i].1);
        let u = &self.by_speed * v + &self.by_acceleration * a;
        u.dot(&(&self.damping * &u))
    }
}

/// Lower bound of the decay rate of a mode \[1/s\].
fn slowest(mode: &Mode) -> f64 {
    let (sigma, omega2) = (mode.sigma, mode.omega2);
    if sigma * sigma <= omega2 { sigma } else { omega2 / (sigma + (sigma * sigma - omega2).sqrt()) }
}

impl Closed {
    fn new(coupled: &Coupled, damped: &[usize]) -> Option<Closed> {
        let mut exponents = vec![];
        for &k in damped {
            let Mode { sigma, omega2, .. } = coupled.modes[k];
            let omega = omega2.sqrt();
            let d = (omega - sigma) * (omega + sigma);
            if d.abs() < EIGENVALUES_APART * EIGENVALUES_APART * omega2.max(sigma * sigma) {
                return None;
            }
            let (first, second) = if d > 0.0 {
                (Complex::new(-sigma, d.sqrt()), Complex::new(-sigma, -d.sqrt()))
            } else {
                let fast = sigma + (-d).sqrt();
                (Complex::from(-omega2 / fast), Complex::from(-fast))
            };
            exponents.extend([(k, first, second), (k, second, first)]);
        }
        let shape = |&(k, lambda, _): &(usize, Complex<f64>, Complex<f64>)| {
            let complex = |x: &DMatrix<f64>| x.column(k).map(Complex::from);
            complex(&coupled.by_speed) + complex(&coupled.by_acceleration) * lambda
        };
        let shapes: Vec<DVector<Complex<f64>>> = exponents.iter().map(shape).collect();
        let damping = coupled.damping.map(Complex::from);
        let damped: Vec<DVector<Complex<f64>>> = shapes.iter().map(|shape| &damping * shape).collect();
        let weights = DMatrix::from_fn(shapes.len(), shapes.len(), |i, j| {
            let sum = exponents[i].1 + exponents[j].1;
            shapes[i].dot(&damped[j]) / if is_zero(sum) { 1.0.into() } else { sum }
        });
        Some(Closed { exponents, weights, shapes })
    }

    /// The damped modes.
    fn modes(&self) -> impl Iterator<Item = usize> {
        // Each mode has two exponentials, one after the other.
        self.exponents.iter().step_by(2).map(|(mode, ..)| *mode)
    }

    /// The exponentials of the modes that `which` selects, from the speeds and accelerations of the modes at the start.
    fn parts(&self, rates: &[(f64, f64)], t: f64, which: impl Fn(usize) -> bool) -> Vec<Part> {
        let part = |(index, &(k, lambda, other)): (usize, &(usize, Complex<f64>, Complex<f64>))| {
            let (v, a) = rates[k];
            let amplitude = (Complex::from(a) - other * v) / (lambda - other);
            Part { index, lambda, amplitude, grown: exp_m1(lambda * t), t }
        };
        self.exponents.iter().enumerate().filter(|(_, exponent)| which(exponent.0)).map(part).collect()
    }

    /// The integral for motions that consist of these exponentials.
    fn of_exponentials(&self, all: &[Part]) -> f64 {
        let mut sum = 0.0;
        for (j, one) in all.iter().enumerate() {
            let mut row = Complex::from(0.0);
            for (i, other) in all.iter().enumerate().skip(j) {
                let (e, f) = (other.grown, one.grown);
                let grown = if is_zero(other.lambda + one.lambda) { one.t.into() } else { e + f + e * f };
                let twice = if i == j { 1.0 } else { 2.0 };
                row += other.amplitude * self.weights[(other.index, one.index)] * grown * twice;
            }
            sum += (row * one.amplitude).re;
        }
        sum
    }

    /// Twice the integral over [0, 1] of the product of the exponentials with the forces `forces` of a course (coefficients of x^p).
    fn between(&self, all: &[Part], forces: &[DVector<f64>], t: f64) -> f64 {
        let of = |part: &Part| {
            let shape = &self.shapes[part.index];
            let each = moments(part.lambda * t).into_iter().zip(forces);
            let along = |g: &DVector<f64>| shape.iter().zip(g.iter()).map(|(phi, g)| phi * g).sum::<Complex<f64>>();
            2.0 * (part.amplitude * each.map(|(moment, g)| along(g) * moment).sum::<Complex<f64>>()).re
        };
        all.iter().map(of).sum()
    }
}

/// One exponential of a motion.
struct Part {
    /// Its index among the exponentials of the cell.
    index: usize,
    lambda: Complex<f64>,
    /// Its amplitude at the start.
    amplitude: Complex<f64>,
    /// e^{lambda t} - 1.
    grown: Complex<f64>,
    /// The duration t \[s\].
    t: f64,
}

fn is_zero(lambda: Complex<f64>) -> bool {
    lambda == Complex::from(0.0)
}

/// e^x - 1, without cancellation.
fn exp_m1(x: Complex<f64>) -> Complex<f64> {
    let (decay, (h, c)) = (x.re.exp_m1(), (0.5 * x.im).sin_cos());
    let e = 1.0 + decay;
    Complex::new(decay - 2.0 * h * h * e, 2.0 * h * c * e)
}

#[cfg(test)]
mod tests;
