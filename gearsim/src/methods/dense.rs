//! Dense output: the motion within a step, as a polynomial in the part x = (t - t_0)/h of it.

use nalgebra::SVector;

use super::flow::Flow;

/// Most coefficients of a dense output: DOP853's is of degree 7.
const MOST: usize = 8;

/// y(x) = sum c_j x^j for 0 <= x <= 1.
#[derive(Debug, Clone)]
pub struct Dense<const N: usize> {
    coefficients: [Flow<N>; MOST],
    degree: usize,
}

impl<const N: usize> Dense<N> {
    /// The polynomial with these coefficients, that of x^0 first.
    pub fn new(given: &[Flow<N>]) -> Self {
        let mut coefficients = [Flow::zero(); MOST];
        coefficients[..given.len()].copy_from_slice(given);
        Dense { coefficients, degree: given.len() - 1 }
    }

    /// y_0 + x (F_0 + (1 - x) (F_1 + x (F_2 + (1 - x) (F_3 + ...)))), the form in which Hairer, Norsett & Wanner give theirs.
    pub fn nested(start: &Flow<N>, f: &[Flow<N>]) -> Self {
        let mut c = [Flow::zero(); MOST];
        for (i, f) in f.iter().enumerate().rev() {
            c[0].add(1.0, f);
            // Times x, or times 1 - x.
            for j in (0..MOST).rev() {
                let below = if j > 0 { c[j - 1] } else { Flow::zero() };
                c[j] = if i % 2 == 0 { below } else { c[j].plus(-1.0, &below) };
            }
        }
        c[0].add(1.0, start);
        Dense { coefficients: c, degree: f.len() }
    }

    /// The motion at the part `x` of the step.
    #[inline]
    pub fn at(&self, x: f64) -> Flow<N> {
        let mut sum = self.coefficients[self.degree];
        for c in self.coefficients[..self.degree].iter().rev() {
            sum = c.plus(x, &sum);
        }
        sum
    }

    /// Coefficients of `bound` less coordinate `i`, times `sign`; how many there are.
    pub fn gap(&self, i: usize, bound: f64, sign: f64) -> ([f64; MOST], usize) {
        let mut gap = self.coefficients.map(|c| -sign * c.q[i]);
        gap[0] = sign * (bound - self.coefficients[0].q[i]);
        (gap, self.degree + 1)
    }

    /// Coefficients of constant + slopes.q; how many there are.
    pub fn along(&self, constant: f64, slopes: &SVector<f64, N>) -> ([f64; MOST], usize) {
        let mut along = self.coefficients.map(|c| slopes.dot(&c.q));
        along[0] += constant;
        (along, self.degree + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(x: f64) -> Flow<1> {
        Flow { q: SVector::from([x]), v: SVector::from([-x]), lost: 2.0 * x }
    }

    /// Both forms against the formulas themselves, in numbers that are exact.
    #[test]
    fn polynomials_are_what_they_say() {
        let dense = Dense::new(&[flow(1.0), flow(2.0), flow(-3.0)]);
        assert_eq!(dense.at(0.5), flow(1.25));
        let (gap, n) = dense.gap(0, 4.0, 1.0);
        assert_eq!(gap[..n], [3.0, -2.0, 3.0]);
        let nested = Dense::nested(&flow(1.0), &[flow(2.0), flow(3.0), flow(5.0), flow(7.0)]);
        let x = 0.25;
        assert_eq!(nested.at(x), flow(1.0 + x * (2.0 + (1.0 - x) * (3.0 + x * (5.0 + (1.0 - x) * 7.0)))));
    }
}
