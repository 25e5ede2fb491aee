//! Dense output: the motion within a step as a polynomial in x = (t - t_0)/h.

use smallvec::SmallVec;

use super::flow::Flow;
use crate::engine::vector::Vector;

/// Coefficients of a polynomial, beginning with that of x^0; DOP853 has eight.
pub type Polynomial = SmallVec<[f64; 8]>;

/// y(x) = sum c_j x^j for 0 <= x <= 1.
#[derive(Debug, Clone)]
pub struct Dense {
    coefficients: Vec<Flow>,
}

impl Dense {
    /// The polynomial with these coefficients, beginning with that of x^0.
    pub fn new(coefficients: Vec<Flow>) -> Self {
        Dense { coefficients }
    }

    /// y_0 + x (F_0 + (1 - x) (F_1 + x (F_2 + (1 - x) (F_3 + ...)))), the form used by Hairer, Norsett & Wanner.
    pub fn nested(start: &Flow, f: &[Flow]) -> Self {
        // The polynomial is c[low] to c[high]. The coefficients beyond it are zero.
        let mut c = vec![Flow::zero(start.q.len()); f.len() + 1];
        let mut low = f.len().div_ceil(2);
        let mut high = low;
        for (i, f) in f.iter().enumerate().rev() {
            c[low].add(1.0, f);
            if i % 2 == 0 {
                // Multiply by x.
                low -= 1;
            } else {
                // Multiply by 1 - x.
                high += 1;
                for j in (low + 1..=high).rev() {
                    let (below, c) = c.split_at_mut(j);
                    c[0].add(-1.0, &below[j - 1]);
                }
            }
        }
        c[0].add(1.0, start);
        Dense { coefficients: c }
    }

    /// The motion at the fraction `x` of the step.
    #[inline]
    pub fn at(&self, x: f64) -> Flow {
        let mut terms = self.coefficients.iter().rev();
        let mut sum = terms.next().expect("a polynomial has coefficients").clone();
        terms.for_each(|c| sum.times_plus(x, c));
        sum
    }

    /// Coefficients of `sign` times (`bound` minus coordinate `i`).
    pub fn gap(&self, i: usize, bound: f64, sign: f64) -> Polynomial {
        let mut gap: Polynomial = self.coefficients.iter().map(|c| -sign * c.q[i]).collect();
        gap[0] = sign * (bound - self.coefficients[0].q[i]);
        gap
    }

    /// Coefficients of a linear function of the state, with slopes along coordinates and speeds, that begins with `value`.
    pub fn from(&self, value: f64, [on_q, on_speed]: [&Vector; 2]) -> Polynomial {
        let mut from: Polynomial = self.coefficients.iter().map(|c| on_q.dot(&c.q) + on_speed.dot(&c.v)).collect();
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
        let dense = Dense::new(vec![flow(1.0), flow(2.0), flow(-3.0)]);
        assert_eq!(dense.at(0.5), flow(1.25));
        assert_eq!(dense.gap(0, 4.0, 1.0)[..], [3.0, -2.0, 3.0]);
        assert_eq!(dense.from(4.0, [&[2.0].into(), &[0.5].into()])[..], [4.0, 3.0, -4.5]);
        let nested = Dense::nested(&flow(1.0), &[flow(2.0), flow(3.0), flow(5.0), flow(7.0)]);
        let x = 0.25;
        assert_eq!(nested.at(x), flow(1.0 + x * (2.0 + (1.0 - x) * (3.0 + x * (5.0 + (1.0 - x) * 7.0)))));
    }
}
