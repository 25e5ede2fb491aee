//! Radau IIA of order 5: an implicit method for stiff cells.
//!
//! Collocation at c = (4 -+ sqrt 6)/10 and 1: Z_i = h sum_j a_ij f(y + Z_j). It is solved by a simplified Newton method in the
//! coordinates W = T⁻¹Z, in which A⁻¹ is block diagonal. This gives one real and one complex linear system. Each has N equations: the N
//! equations q' = v are eliminated. The error estimate is the embedded formula of order 3. Source: Hairer & Wanner, Solving Ordinary
//! Differential Equations II (1996), IV.8; the entries of T are those of their code `radau5`.

use nalgebra::{Complex, ComplexField, DMatrix, DVector, Dyn, LU};

use super::dense::Dense;
use super::field::Field;
use super::flow::{Flow, Scale};
use super::{Method, Trial};
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::methods::{NEWTON, NEWTON_ROUNDING};

/// The transformation T, with Z = T W.
const T: [[f64; 3]; 3] = [
    [0.09443876248897524, -0.1412552950209542, 0.03002919410514742],
    [0.2502131229653333, 0.20412935229379994, -0.3829421127572619],
    [1.0, 1.0, 0.0],
];
const T_INVERSE: [[f64; 3]; 3] = [
    [4.178718591551904, 0.32768282076106237, 0.5233764454994495],
    [-4.178718591551904, -0.32768282076106237, 0.4766235545005505],
    [0.5028726349457868, -2.571926949855605, 0.5960392048282249],
];
/// Maximum number of Newton iterations. If they do not converge, a shorter step is tried.
const MOST_NEWTON: u32 = 8;

/// The method with the stages of its last attempt.
#[derive(Debug, Clone)]
pub struct Radau {
    /// Allowed error of Newton's method, relative to the allowed error of a step.
    newton: f64,
    /// Rounding errors of the state, relative to the allowed error of a step.
    rounding: f64,
    /// The displacements Z of the stages.
    z: [Flow; 3],
}

/// One of the two linear systems with the matrix gamma I - J, reduced to N equations.
struct System<T: ComplexField> {
    gamma: T,
    by_q: Matrix,
    by_v: Matrix,
    lu: LU<T, Dyn, Dyn>,
}

impl<T: ComplexField<RealField = f64> + Copy> System<T> {
    /// (gamma² I - gamma J_v - J_q) x_q = r_v + gamma r_q - J_v r_q and (gamma² I - gamma J_v - J_q) x_v = gamma r_v + J_q r_q. The speeds
    /// x_v are solved for separately: in a very short step the difference x_v = gamma x_q - r_q would lose all digits.
    fn new(gamma: T, [by_q, by_v]: &[Matrix; 2]) -> Self {
        let lift = |x: f64| T::from_real(x);
        let n = by_q.nrows();
        let matrix = DMatrix::from_fn(n, n, |i, j| {
            let unit = if i == j { gamma * gamma } else { T::zero() };
            unit - gamma * lift(by_v[(i, j)]) - lift(by_q[(i, j)])
        });
        System { gamma, by_q: by_q.clone(), by_v: by_v.clone(), lu: matrix.lu() }
    }

    fn solve(&self, r_q: &DVector<T>, r_v: &DVector<T>) -> Option<(DVector<T>, DVector<T>)> {
        let n = r_q.len();
        let along = |a: &Matrix, i: usize| (0..n).fold(T::zero(), |sum, j| sum + T::from_real(a[(i, j)]) * r_q[j]);
        let of_q = DVector::from_fn(n, |i, _| r_v[i] + self.gamma * r_q[i] - along(&self.by_v, i));
        let of_v = DVector::from_fn(n, |i, _| self.gamma * r_v[i] + along(&self.by_q, i));
        Some((self.lu.solve(&of_q)?, self.lu.solve(&of_v)?))
    }
}

impl Radau {
    /// The method for a relative tolerance.
    pub fn new(tolerance: f64) -> Self {
        let rounding = NEWTON_ROUNDING / tolerance;
        let newton = rounding.max(tolerance.sqrt().min(NEWTON));
        Radau { newton, rounding, z: std::array::from_fn(|_| Flow::zero(0)) }
    }

    fn nodes() -> [f64; 3] {
        let s = 6f64.sqrt();
        [(4.0 - s) / 10.0, (4.0 + s) / 10.0, 1.0]
    }

    /// The real eigenvalue of A⁻¹, and one of the complex pair.
    fn eigenvalues() -> (f64, Complex<f64>) {
        let (a, b) = (3f64.powf(1.0 / 3.0), 3f64.powf(2.0 / 3.0));
        let imaginary = -0.5 * (3f64.powf(5.0 / 6.0) + 3f64.powf(7.0 / 6.0));
        (3.0 + b - a, Complex::new(3.0 + 0.5 * (a - b), imaginary))
    }

    fn combine(factors: &[f64; 3], of: &[Flow; 3]) -> Flow {
        (0..3).fold(Flow::zero(of[0].q.len()), |sum, i| sum.plus(factors[i], &of[i]))
    }

    /// The stages; `None` if Newton's method does not converge.
    fn stages(
        &self,
        field: &mut Field<'_>,
        start: &Flow,
        h: f64,
        scale: &Scale,
        real: &System<f64>,
        complex: &System<Complex<f64>>,
    ) -> Option<[Flow; 3]> {
        let nodes = Self::nodes();
        let n = start.q.len();
        let zero = || std::array::from_fn(|_| Flow::zero(n));
        let (mut w, mut z): ([Flow; 3], [Flow; 3]) = (zero(), zero());
        let mut before: Option<f64> = None;
        for iteration in 0..MOST_NEWTON {
            let f: [Flow; 3] = std::array::from_fn(|i| field.rate(nodes[i] * h, &start.plus(1.0, &z[i])));
            let g: [Flow; 3] = std::array::from_fn(|i| Self::combine(&T_INVERSE[i], &f));
            // Residuals of the transformed equations: T⁻¹f - gamma W.
            let residual = |flow: &Flow, w: &Flow, gamma: f64| flow.plus(-gamma, w);
            let r = residual(&g[0], &w[0], real.gamma);
            let (dq, dv) = real.solve(&DVector::from(&r.q), &DVector::from(&r.v))?;
            let pair = |a: &Vector, b: &Vector| DVector::from_fn(n, |i, _| Complex::new(a[i], b[i]));
            let (wq, wv) = (pair(&w[1].q, &w[2].q), pair(&w[1].v, &w[2].v));
            let (rq, rv) = (pair(&g[1].q, &g[2].q), pair(&g[1].v, &g[2].v));
            let (cq, cv) = complex.solve(&(rq - wq * complex.gamma), &(rv - wv * complex.gamma))?;
            let mut dw: [Flow; 3] = zero();
            for i in 0..n {
                (dw[0].q[i], dw[0].v[i]) = (dq[i], dv[i]);
                (dw[1].q[i], dw[1].v[i]) = (cq[i].re, cv[i].re);
                (dw[2].q[i], dw[2].v[i]) = (cq[i].im, cv[i].im);
            }
            let size = dw.iter().map(|dw| scale.norm(dw)).fold(0.0, f64::max);
            if !size.is_finite() {
                return None;
            }
            for i in 0..3 {
                w[i].add(1.0, &dw[i]);
            }
            z = std::array::from_fn(|i| Self::combine(&T[i], &w));
            // Below the rounding errors of the state, the corrections neither converge nor diverge.
            let known = size <= self.rounding;
            let Some(before) = before.replace(size) else { if known { break } else { continue } };
            let rate = size / before;
            if known || (rate < 1.0 && rate / (1.0 - rate) * size < self.newton) {
                break;
            }
            let left = (MOST_NEWTON - 1 - iteration) as i32;
            if rate >= 1.0 || rate.powi(left) / (1.0 - rate) * size > self.newton {
                return None;
            }
        }
        // The dissipated energy at the stages, by the same collocation formula: Z = h A f.
        let lost: [f64; 3] = std::array::from_fn(|i| field.lost(nodes[i] * h, &start.plus(1.0, &z[i])));
        for (z, row) in z.iter_mut().zip(weights()) {
            z.lost = h * (0..3).map(|j| row[j] * lost[j]).sum::<f64>();
        }
        Some(z)
    }
}

/// The matrix A of Radau IIA.
fn weights() -> [[f64; 3]; 3] {
    let s = 6f64.sqrt();
    [
        [(88.0 - 7.0 * s) / 360.0, (296.0 - 169.0 * s) / 1800.0, (-2.0 + 3.0 * s) / 225.0],
        [(296.0 + 169.0 * s) / 1800.0, (88.0 + 7.0 * s) / 360.0, (-2.0 - 3.0 * s) / 225.0],
        [(16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0],
    ]
}

impl Method for Radau {
    fn name(&self) -> &'static str {
        "radau"
    }

    fn exponent(&self) -> f64 {
        0.25
    }

    fn stability(&self) -> f64 {
        f64::INFINITY
    }

    fn attempt(&mut self, field: &mut Field<'_>, start: &Flow, rate: &Flow, h: f64, scale: &Scale) -> Option<Trial> {
        let jacobian = field.jacobian(0.0, start);
        let (mu, nu) = Self::eigenvalues();
        let real = System::<f64>::new(mu / h, &jacobian);
        let complex = System::<Complex<f64>>::new(nu / h, &jacobian);
        // `scale` is the allowed error, so the norm is 1 at the limit.
        self.z = self.stages(field, start, h, scale, &real, &complex)?;
        let end = start.plus(1.0, &self.z[2]);
        let at_end = field.rate(h, &end);

        // Error estimate: (mu/h I - J)⁻¹ (f_0 + E Z/h). A stiff component can make it exceed the limit; then it is filtered once more.
        let s = 6f64.sqrt();
        let e = Self::combine(&[(-13.0 - 7.0 * s) / 3.0, (-13.0 + 7.0 * s) / 3.0, -1.0 / 3.0], &self.z);
        let filtered = |r: &Flow| {
            let (q, v) = real.solve(&DVector::from(&r.q), &DVector::from(&r.v))?;
            Some(Flow { q: (&q).into(), v: (&v).into(), lost: 0.0 })
        };
        let mut error = filtered(&rate.plus(1.0 / h, &e))?;
        if scale.norm(&error) > 1.0 {
            let again = field.rate(0.0, &start.plus(1.0, &error));
            error = filtered(&again.plus(1.0 / h, &e))?;
        }
        Some(Trial { end, rate: at_end, error: scale.norm(&error), stiffness: 0.0 })
    }

    /// The collocation polynomial through the start and the three stages.
    fn dense(&mut self, _: &mut Field<'_>, start: &Flow, _: f64, _: &Trial) -> Dense {
        let s = 6f64.sqrt();
        let powers = [
            [13.0 / 3.0 + 7.0 * s / 3.0, 13.0 / 3.0 - 7.0 * s / 3.0, 1.0 / 3.0],
            [-23.0 / 3.0 - 22.0 * s / 3.0, -23.0 / 3.0 + 22.0 * s / 3.0, -8.0 / 3.0],
            [10.0 / 3.0 + 5.0 * s, 10.0 / 3.0 - 5.0 * s, 10.0 / 3.0],
        ];
        let [a, b, c] = powers.map(|factors| Self::combine(&factors, &self.z));
        Dense::new(&[start.clone(), a, b, c])
    }
}
