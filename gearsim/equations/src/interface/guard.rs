//! Deflections, and the guards of the modes of switches. A guard is linear in coordinates, speeds and reactions.

use smallvec::SmallVec;

use crate::real::Real;

/// A named deflection, x = constant + sum(unit k\[law\]) + normal.q, in numbers of type R.
#[derive(Debug, Clone, PartialEq)]
pub struct Deflection<R: Real = f64> {
    /// Its gradient (n).
    pub normal: R::Row,
    /// Its value where the coordinates and the transmission errors are zero.
    pub constant: R,
    /// The transmission errors that shift it, each with the index of its law and the shift per unit of the law.
    pub errors: Vec<(usize, R)>,
}

impl Deflection {
    /// Its value at the coordinates `q` and the law values `k`.
    #[inline]
    pub fn value(&self, q: &[f64], k: &[f64]) -> f64 {
        self.constant + shift(&self.errors, k) + self.normal.dot(q)
    }
}

/// The shift of a deflection by transmission errors.
fn shift<R: Real>(errors: &[(usize, R)], k: &[R]) -> R {
    errors.iter().fold(R::from(0.0), |sum, &(law, unit)| sum + unit * k[law])
}

/// What ends a mode of a switch, in numbers of type R.
#[derive(Debug, Clone, PartialEq)]
pub struct Exit<R: Real = f64> {
    /// The mode that follows.
    pub beyond: usize,
    /// Whether only a sudden change of the state can violate the guard: in every motion another exit comes first.
    pub sudden: bool,
    /// The mode lasts while this is >= 0.
    pub guard: Affine<R>,
}

/// A linear function of the state: constant + sum(unit k\[law\]) + on_q.q + on_speed.q' + on_reaction R.
#[derive(Debug, Clone, PartialEq)]
pub struct Affine<R: Real = f64> {
    /// Its value at the state zero.
    pub constant: R,
    /// The sum of the absolute values of the constants that `constant` consists of. The constants may cancel, but their rounding errors do
    /// not.
    pub size: R,
    /// The transmission errors in it, each with the index of its law and its factor.
    pub errors: SmallVec<[(usize, R); 1]>,
    /// Its slopes along the coordinates (n).
    pub on_q: R::Row,
    /// Its slopes along the speeds (n).
    pub on_speed: R::Row,
    /// Its slope along the reaction of a held deflection.
    pub on_reaction: R,
}

impl<R: Real> Affine<R> {
    /// Zero, for `n` coordinates.
    pub fn zero(n: usize) -> Self {
        let zero = R::from(0.0);
        let none: SmallVec<[R; 16]> = SmallVec::from_elem(zero, n);
        let (on_q, on_speed) = (R::row(&none), R::row(&none));
        Affine { constant: zero, size: zero, errors: SmallVec::new(), on_q, on_speed, on_reaction: zero }
    }

    /// Adds a constant.
    pub fn add_constant(&mut self, constant: R) {
        self.constant += constant;
        self.size += (constant * constant).sqrt();
    }

    /// Adds a multiple of a deflection.
    pub fn add(&mut self, factor: R, x: &Deflection<R>) {
        self.add_constant(factor * x.constant);
        self.errors.extend(x.errors.iter().map(|(law, unit)| (*law, factor * *unit)));
        R::add_times(&mut self.on_q, factor, &x.normal);
    }

    /// Adds a multiple of the rate of a deflection.
    pub fn add_rate(&mut self, factor: R, x: &Deflection<R>) {
        R::add_times(&mut self.on_speed, factor, &x.normal);
    }

    /// Its value at the state zero and the law values `k`.
    pub fn constant_at(&self, k: &[R]) -> R {
        self.constant + shift(&self.errors, k)
    }
}

impl Affine {
    /// Its value without the term of the reaction, at the coordinates `q`, the speeds `q_dot` and the law values `k`.
    #[inline]
    pub fn value(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.constant_at(k) + self.on_q.dot(q) + self.on_speed.dot(q_dot)
    }

    /// The sum of the absolute values of its terms that do not depend on the state, at the law values `k`.
    #[inline]
    pub fn size_at(&self, k: &[f64]) -> f64 {
        self.size + shift(&self.errors, k).abs()
    }
}
