//! The motion of M q'' + C q' + K q = f by the matrix exponential with scaling and squaring, without modes or eigenvalues.

use super::number::{Real, Scalar};

/// A square matrix, stored row by row.
#[derive(Debug, Clone)]
struct Square<const BITS: usize> {
    n: usize,
    of: Vec<Real<BITS>>,
}

/// z' = A z, z = (q, q', 1).
#[derive(Debug, Clone)]
pub struct Exponential<const BITS: usize> {
    a: Square<BITS>,
}

/// z(t + h) = P z(t) for one h.
#[derive(Debug, Clone)]
pub struct Propagator<const BITS: usize>(Square<BITS>);

impl<const BITS: usize> Exponential<BITS> {
    /// The system with these matrices, given row by row.
    ///
    /// Panics if M cannot be inverted.
    pub fn new<const N: usize>(
        mass: &[[f64; N]; N],
        damping: &[[f64; N]; N],
        stiffness: &[[f64; N]; N],
        load: &[f64; N],
    ) -> Self {
        let n = N;
        let zero = || Real::<BITS>::exact(0.0);
        // Gauss-Jordan on [M | -K, -C, f].
        let mut rows: Vec<Vec<Real<BITS>>> = (0..n)
            .map(|i| {
                let negative = |x: &f64| Real::exact(-x);
                let right = stiffness[i].iter().map(negative).chain(damping[i].iter().map(negative));
                mass[i].iter().map(|x| Real::exact(*x)).chain(right).chain([Real::exact(load[i])]).collect()
            })
            .collect();
        for i in 0..n {
            let largest = |row: &Vec<Real<BITS>>| row[i].approx().abs();
            let pivot = (i..n).max_by(|&r, &s| largest(&rows[r]).total_cmp(&largest(&rows[s]))).expect("a row");
            rows.swap(i, pivot);
            assert!(!rows[i][i].is_zero(), "M has no inverse");
            let head = rows[i][i].clone();
            rows[i].iter_mut().for_each(|x| *x = x.clone() / head.clone());
            let of_pivot = rows[i].clone();
            for row in (0..n).filter(|&row| row != i) {
                let factor = rows[row][i].clone();
                for (x, p) in rows[row].iter_mut().zip(&of_pivot) {
                    *x = x.clone() - factor.clone() * p.clone();
                }
            }
        }
        let size = 2 * n + 1;
        let mut of = vec![zero(); size * size];
        for i in 0..n {
            of[i * size + n + i] = Real::exact(1.0);
            for j in 0..=2 * n {
                of[(n + i) * size + j] = rows[i][n + j].clone();
            }
        }
        Exponential { a: Square { n: size, of } }
    }

    /// The propagator over the time `h` \[s\].
    pub fn over(&self, h: &Real<BITS>) -> Propagator<BITS> {
        let size = self.a.n;
        let norm = |a: &Square<BITS>| {
            let row = |i: usize| a.of[i * size..(i + 1) * size].iter().map(|x| x.approx().abs()).sum::<f64>();
            (0..size).map(row).fold(0.0, f64::max)
        };
        let mut scaled = self.a.map(|x| x.clone() * h.clone());
        let halvings = norm(&scaled).log2().ceil().max(0.0) as i32 + 4;
        scaled = scaled.map(|x| x.scaled(-halvings));
        let mut sum = Square::identity(size);
        let mut term = Square::identity(size);
        for k in 1.. {
            term = term.times(&scaled).map(|x| x.over(k));
            if norm(&term) <= 1e-3 * Real::<BITS>::NEGLIGIBLE {
                break;
            }
            sum = sum.plus(&term);
        }
        for _ in 0..halvings {
            sum = sum.times(&sum);
        }
        Propagator(sum)
    }
}

impl<const BITS: usize> Propagator<BITS> {
    /// (q, q') one step later.
    pub fn of(&self, q: &[Real<BITS>], v: &[Real<BITS>]) -> (Vec<Real<BITS>>, Vec<Real<BITS>>) {
        let n = q.len();
        let z: Vec<_> = q.iter().chain(v).cloned().chain([Real::exact(1.0)]).collect();
        let row = |i: usize| {
            let entries = self.0.of[i * self.0.n..(i + 1) * self.0.n].iter();
            entries.zip(&z).fold(Real::exact(0.0), |sum, (p, z)| sum + p.clone() * z.clone())
        };
        ((0..n).map(row).collect(), (n..2 * n).map(row).collect())
    }
}

impl<const BITS: usize> Square<BITS> {
    fn identity(n: usize) -> Self {
        let one = |i: usize| Real::exact(if i / n == i % n { 1.0 } else { 0.0 });
        Square { n, of: (0..n * n).map(one).collect() }
    }

    fn map(&self, f: impl Fn(&Real<BITS>) -> Real<BITS>) -> Self {
        Square { n: self.n, of: self.of.iter().map(f).collect() }
    }

    fn plus(&self, other: &Self) -> Self {
        let of = self.of.iter().zip(&other.of).map(|(a, b)| a.clone() + b.clone()).collect();
        Square { n: self.n, of }
    }

    fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let mut of = vec![Real::exact(0.0); n * n];
        for i in 0..n {
            for k in (0..n).filter(|&k| !self.of[i * n + k].is_zero()) {
                for j in (0..n).filter(|&j| !other.of[k * n + j].is_zero()) {
                    let product = self.of[i * n + k].clone() * other.of[k * n + j].clone();
                    of[i * n + j] = of[i * n + j].clone() + product;
                }
            }
        }
        Square { n, of }
    }
}

#[test]
fn the_matrix_exponential_equals_the_closed_form_of_one_mode() {
    use super::cell::{Law, Motion};
    for (sigma, omega2, t) in [(0.0, 4.0, 3.0), (0.5, 4.0, 3.0), (2.0, 4.0, 1.5), (30.0, 4.0, 7.0), (0.3, 0.0, 5.0)] {
        let system = Exponential::<192>::new(&[[2.0]], &[[4.0 * sigma]], &[[2.0 * omega2]], &[1.4]);
        let [q, v] = [0.3, -0.8].map(Real::<192>::exact);
        let (x, x_dot) = system.over(&Real::exact(t)).of(std::slice::from_ref(&q), std::slice::from_ref(&v));
        let law = Law::new(Real::exact(sigma), Real::exact(omega2));
        let force = Real::exact(1.4).scaled(-1);
        let (y, y_dot) = Motion::new(law, force, q, v, Real::exact(1.0)).state(&Real::exact(t));
        for (a, b) in [(&x[0], y), (&x_dot[0], y_dot)] {
            let error = (a.clone() - b).approx().abs();
            // 192 bits are 1.6e-58; about ten squarings enlarge the error.
            assert!(error < 1e-50, "{error:e} at sigma = {sigma}, omega² = {omega2}");
        }
    }
}
