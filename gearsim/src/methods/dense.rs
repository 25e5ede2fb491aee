//! Dense output: the motion within a step as a polynomial in x = (t - t_0)/h.

use smallvec::SmallVec;

use super::flow::Flow;
use crate::engine::vector::Vector;

/// Coefficients of a polynomial, beginning with that of x^0; DOP853 has eight.
pub type Polynomial = SmallVec<[f64; 8]>;

/// y(x) = sum c_j x^j for 0 <= x <= 1.
#[derive(Debug, Clone)]
pub struct Dense {
    /// Number of coordinates.
    n: usize,
    /// The coefficients of q, q' and the energy lost, one c_j after another.
    coefficients: Vec<f64>,
}

impl Dense {
    /// The polynomial with these coefficients, beginning with that of x^0.
    pub fn new(coefficients: &[Flow]) -> Self {
        let n = coefficients[0].q.len();
        let mut dense = Dense { n, coefficients: Vec::with_capacity(coefficients.len() * (2 * n + 1)) };
        coefficients.iter().for_each(|c| dense.push(c));
        dense
    }

    fn push(&mut self, c: &Flow) {
        self.coefficients.extend_from_slice(&c.q);
        self.coefficients.extend_from_slice(&c.v);
        self.coefficients.push(c.lost);
    }

    /// y_0 + x (F_0 + (1 - x) (F_1 + x (F_2 + (1 - x) (F_3 + ...)))), the form used by Hairer, Norsett & Wanner. `f` contains the F one
    /// after another, each as q, q' and the energy lost.
    pub fn nested(start: &Flow, f: &[f64]) -> Self {
        let (n, width) = (start.q.len(), 2 * start.q.len() + 1);
        let count = f.len() / width;
        // The coefficients of the polynomial are c[low] to c[high]. All others are zero.
        let mut c = vec![0.0; f.len() + width];
        let mut low = count.div_ceil(2);
        let mut high = low;
        for (i, f) in f.chunks_exact(width).enumerate().rev() {
            let (lowest, f) = (&mut c[low * width..][..width], &f[..width]);
            for l in 0..width {
                lowest[l] += f[l];
            }
            if i % 2 == 0 {
                // Multiply by x.
                low -= 1;
            } else {
                // Multiply by 1 - x.
                high += 1;
                for l in ((low + 1) * width..(high + 1) * width).rev() {
                    c[l] -= c[l - width];
                }
            }
        }
        let mut dense = Dense { n, coefficients: c };
        let (lowest, _) = dense.coefficients.split_at_mut(width);
        let (q, rest) = lowest.split_at_mut(n);
        let (v, lost) = rest.split_at_mut(n);
        q.iter_mut().zip(&*start.q).for_each(|(c, start)| *c += start);
        v.iter_mut().zip(&*start.v).for_each(|(c, start)| *c += start);
        lost[0] += start.lost;
        dense
    }

    /// The coefficients, beginning with that of x^0.
    fn powers(&self) -> impl DoubleEndedIterator<Item = &[f64]> {
        self.coefficients.chunks_exact(2 * self.n + 1)
    }

    /// The motion at the fraction `x` of the step.
    #[inline]
    pub fn at(&self, x: f64) -> Flow {
        let (n, width) = (self.n, 2 * self.n + 1);
        let mut powers = self.powers().rev();
        let mut sum: SmallVec<[f64; 21]> = SmallVec::from_slice(powers.next().unwrap_or_default());
        // Loops over an index of slices of known length: see `Vector`.
        let sum = &mut sum[..width];
        for c in powers {
            let c = &c[..width];
            for l in 0..width {
                sum[l] = c[l] + x * sum[l];
            }
        }
        Flow { q: sum[..n].into(), v: sum[n..2 * n].into(), lost: sum[2 * n] }
    }

    /// Coefficients of `sign` times (`bound` minus coordinate `i`).
    pub fn gap(&self, i: usize, bound: f64, sign: f64) -> Polynomial {
        let mut gap: Polynomial = self.powers().map(|c| -sign * c[i]).collect();
        gap[0] = sign * (bound - self.coefficients[i]);
        gap
    }

    /// Coefficients of a linear function of the state with these slopes along the coordinates and the speeds. Its value at x = 0 is
    /// `value`.
    pub fn from(&self, value: f64, [on_q, on_speed]: [&Vector; 2]) -> Polynomial {
        let n = self.n;
        let mut from: Polynomial = self.powers().map(|c| on_q.dot(&c[..n]) + on_speed.dot(&c[n..2 * n])).collect();
        from[0] = value;
        from
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(x: f64) -> Flow {
        Flow { q: [x].into(), v: [-x].into(), lost: 2.0 * x }
    }

    /// Both forms against their formulas, with numbers that are exact in f64.
    #[test]
    fn both_forms_match_their_formulas() {
        let dense = Dense::new(&[flow(1.0), flow(2.0), flow(-3.0)]);
        assert_eq!(dense.at(0.5), flow(1.25));
        assert_eq!(dense.gap(0, 4.0, 1.0)[..], [3.0, -2.0, 3.0]);
        assert_eq!(dense.from(4.0, [&[2.0].into(), &[0.5].into()])[..], [4.0, 3.0, -4.5]);
        let parts = [2.0, 3.0, 5.0, 7.0].map(|x| [x, -x, 2.0 * x]);
        let nested = Dense::nested(&flow(1.0), parts.as_flattened());
        let x = 0.25;
        assert_eq!(nested.at(x), flow(1.0 + x * (2.0 + (1.0 - x) * (3.0 + x * (5.0 + (1.0 - x) * 7.0)))));
    }
}
