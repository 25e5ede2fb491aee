//! The sign of a polynomial from its coefficients in the Bernstein basis.
//!
//! p(t) = sum b_i C(n, i) u^i (1 - u)^(n-i) with u = t/T. The basis functions are positive within (0, T). Therefore p is positive
//! there if all b_i are, and p decreases if the b_i do. De Casteljau's bisection gives the coefficients on each half. They are
//! mean values, so no digits are lost.

use crate::tolerance::events::BERNSTEIN_ROUNDING;

/// Coefficients on an interval of length 1, from its beginning to its end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bernstein<const K: usize>([f64; K]);

/// Result of a root search. Times are fractions of the interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum First {
    /// No root after the beginning.
    None,
    /// No root before the first time. Exactly one between the two times, where p decreases.
    Single(f64, f64),
    /// No root before this time; after it, the result is undecided.
    Open(f64),
}

impl<const K: usize> Bernstein<K> {
    /// The coefficients of sum c_k t^k on [0, `until`], lowered by their rounding errors.
    pub fn of(c: [f64; K], until: f64) -> Self {
        let mut scaled = c;
        let mut power = 1.0;
        for c in &mut scaled {
            *c = (*c - BERNSTEIN_ROUNDING * c.abs()) * power;
            power *= until;
        }
        // b_i = sum over k <= i of C(i, k)/C(n, k) c_k
        let b = std::array::from_fn(|i| {
            let (mut weight, mut sum) = (1.0, 0.0);
            for (k, c) in scaled.iter().enumerate().take(i + 1) {
                sum += weight * c;
                weight *= (i - k) as f64 / (K - 1).saturating_sub(k).max(1) as f64;
            }
            sum
        });
        Bernstein(b)
    }

    /// The first root, with at most `halvings` nested bisections.
    pub fn first(self, halvings: u32) -> First {
        self.first_in(0.0, 1.0, halvings)
    }

    fn first_in(self, from: f64, length: f64, halvings: u32) -> First {
        if self.is_positive() {
            return First::None;
        }
        if self.falls() {
            return First::Single(from, from + length);
        }
        if halvings == 0 {
            return First::Open(from);
        }
        let (early, late) = self.halves();
        let half = 0.5 * length;
        match early.first_in(from, half, halvings - 1) {
            First::None => late.first_in(from + half, half, halvings - 1),
            found => found,
        }
    }

    /// Whether p is positive on the interval, except perhaps at its beginning.
    fn is_positive(&self) -> bool {
        self.0.iter().all(|b| *b >= 0.0) && self.0.iter().any(|b| *b > 0.0)
    }

    /// Whether p decreases from a value >= 0 to a negative value.
    fn falls(&self) -> bool {
        self.0[0] >= 0.0 && self.0[K - 1] < 0.0 && self.0.windows(2).all(|b| b[1] < b[0])
    }

    fn halves(mut self) -> (Self, Self) {
        let mut early = self.0;
        for (i, early) in early.iter_mut().enumerate().skip(1) {
            for k in 0..K - i {
                self.0[k] = 0.5 * (self.0[k] + self.0[k + 1]);
            }
            *early = self.0[0];
        }
        (Bernstein(early), self)
    }
}

#[cfg(test)]
mod tests {
    use super::{Bernstein, First};

    /// Coefficients of the product of the factors 1 - t/root.
    fn with_roots<const K: usize>(roots: [f64; K]) -> [f64; 5] {
        roots.into_iter().fold([1.0, 0.0, 0.0, 0.0, 0.0], |c, root| {
            std::array::from_fn(|k| c[k] - if k > 0 { c[k - 1] / root } else { 0.0 })
        })
    }

    #[test]
    fn the_first_root_is_not_missed() {
        for roots in [[0.3, 0.7, 2.0, 3.0], [0.999, 1.5, 2.0, 3.0], [-1.0, 0.01, 0.02, 5.0], [0.5, 0.5001, -2.0, -3.0]]
        {
            let first = roots.into_iter().filter(|r| *r > 0.0).fold(f64::INFINITY, f64::min);
            for until in [0.5, 1.0, 8.0, 1e6] {
                match Bernstein::of(with_roots(roots), until).first(60) {
                    First::None => assert!(until < first, "{roots:?} within {until}"),
                    First::Single(from, to) => {
                        assert!(from * until <= first && first <= to * until * (1.0 + 1e-12), "{roots:?}: {from} {to}");
                    }
                    First::Open(from) => assert!((from * until - first).abs() < 1e-6, "{roots:?}: {from}"),
                }
            }
        }
    }

    /// (1 - 2 t)² touches zero. Lowered by its rounding error, it is negative there.
    #[test]
    fn a_double_root_is_not_missed() {
        let (from, to) = match Bernstein::of([1.0, -4.0, 4.0], 1.0).first(30) {
            First::None => panic!("a touch was passed"),
            First::Single(from, to) => (from, to),
            First::Open(from) => (from, 1.0),
        };
        assert!(from <= 0.5 && to >= 0.5, "{from} {to}");
        assert_eq!(Bernstein::of([1.0 + 1e-9, -4.0, 4.0], 1.0).first(30), First::None);
    }

    #[test]
    fn a_root_at_the_start_is_not_reported() {
        assert_eq!(Bernstein::of([0.0, 1.0, -0.5], 1.0).first(30), First::None);
        assert_eq!(Bernstein::of([0.0, 0.0, 1.0], 1.0).first(30), First::None);
    }
}
