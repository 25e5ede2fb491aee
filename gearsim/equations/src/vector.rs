//! Vectors of a run: coordinates, speeds and modal coordinates. Their length is known when the scene has been read.
//!
//! Vectors of nalgebra with a dynamic length are on the heap. A run creates several vectors at every event. So the vectors of this module
//! are on the stack if they have at most ten numbers.
//!
//! Their operations are loops over an index. A zip of iterators contains functions of the standard library that the compiler does not
//! inline across its units of code: a step of dop853 takes up to a fifth more instructions with them.

use std::ops::{Add, AddAssign, Deref, DerefMut, Mul, Neg, Sub, SubAssign};

use nalgebra::{DMatrix, DVector};
use smallvec::SmallVec;

/// A matrix whose size is known when the scene has been read.
pub type Matrix = DMatrix<f64>;

/// Largest length on the stack. It is sufficient for most drivetrains.
const INLINE: usize = 10;

/// A vector of n numbers.
#[derive(Debug, PartialEq, Default)]
pub struct Vector(SmallVec<[f64; INLINE]>);

impl Vector {
    /// A vector of n zeros.
    #[inline]
    pub fn zeros(n: usize) -> Self {
        match n {
            0..=INLINE => Vector(SmallVec::from_buf_and_len([0.0; INLINE], n)),
            _ => Vector(SmallVec::from_elem(0.0, n)),
        }
    }

    /// The vector of the n numbers f(i).
    #[inline]
    pub fn from_fn(n: usize, mut f: impl FnMut(usize) -> f64) -> Self {
        let mut vector = Vector::zeros(n);
        for (i, x) in vector.iter_mut().enumerate() {
            *x = f(i);
        }
        vector
    }

    /// The scalar product with a vector of the same length.
    #[inline]
    pub fn dot(&self, other: &[f64]) -> f64 {
        dot(self, other)
    }

    /// The vector of the values of `f` for each element.
    #[inline]
    pub fn map(&self, mut f: impl FnMut(f64) -> f64) -> Vector {
        Vector::from_fn(self.len(), |i| f(self[i]))
    }

    /// The vector of the values of `f` for each pair of elements of this vector and `other` with the same index.
    #[inline]
    pub fn zip_map(&self, other: &[f64], mut f: impl FnMut(f64, f64) -> f64) -> Vector {
        let (a, b) = (&self[..], &other[..self.len()]);
        Vector::from_fn(a.len(), |i| f(a[i], b[i]))
    }

    /// The products of the elements of this vector and `other` with the same index.
    #[inline]
    pub fn component_mul(&self, other: &[f64]) -> Vector {
        self.zip_map(other, |a, b| a * b)
    }

    /// The absolute values of its elements.
    #[inline]
    pub fn abs(&self) -> Vector {
        self.map(f64::abs)
    }

    /// The sum of its elements.
    #[inline]
    pub fn sum(&self) -> f64 {
        self.iter().sum()
    }

    /// The largest absolute value of its elements.
    #[inline]
    pub fn amax(&self) -> f64 {
        self.iter().fold(0.0, |most, x| most.max(x.abs()))
    }

    /// Adds `by` times another vector.
    #[inline]
    pub fn add_times(&mut self, by: f64, other: &[f64]) {
        self.combine(other, |a, b| a + by * b);
    }

    /// Replaces this vector by `by` times itself plus another vector.
    #[inline]
    pub fn times_plus(&mut self, by: f64, other: &[f64]) {
        self.combine(other, |a, b| b + by * a);
    }

    /// Replaces each element by `f` of this element and the element of `other` with the same index.
    #[inline]
    fn combine(&mut self, other: &[f64], f: impl Fn(f64, f64) -> f64) {
        let a = &mut self[..];
        let b = &other[..a.len()];
        for i in 0..a.len() {
            a[i] = f(a[i], b[i]);
        }
    }
}

impl Clone for Vector {
    // `SmallVec::clone` adds the numbers one by one.
    #[inline]
    fn clone(&self) -> Self {
        self[..].into()
    }
}

impl Deref for Vector {
    type Target = [f64];

    #[inline]
    fn deref(&self) -> &[f64] {
        &self.0
    }
}

impl DerefMut for Vector {
    #[inline]
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl AsRef<[f64]> for Vector {
    #[inline]
    fn as_ref(&self) -> &[f64] {
        &self.0
    }
}

impl From<&[f64]> for Vector {
    #[inline]
    fn from(numbers: &[f64]) -> Self {
        Vector(SmallVec::from_slice(numbers))
    }
}

impl<const N: usize> From<[f64; N]> for Vector {
    fn from(numbers: [f64; N]) -> Self {
        Vector(SmallVec::from_slice(&numbers))
    }
}

impl<const N: usize> PartialEq<[f64; N]> for Vector {
    fn eq(&self, other: &[f64; N]) -> bool {
        self[..] == other[..]
    }
}

impl From<&DVector<f64>> for Vector {
    #[inline]
    fn from(vector: &DVector<f64>) -> Self {
        vector.as_slice().into()
    }
}

impl From<&Vector> for DVector<f64> {
    #[inline]
    fn from(vector: &Vector) -> Self {
        DVector::from_column_slice(vector)
    }
}

impl Add<&Vector> for Vector {
    type Output = Vector;

    #[inline]
    fn add(mut self, other: &Vector) -> Vector {
        self += other;
        self
    }
}

impl Sub<&Vector> for Vector {
    type Output = Vector;

    #[inline]
    fn sub(mut self, other: &Vector) -> Vector {
        self -= other;
        self
    }
}

impl Add for &Vector {
    type Output = Vector;

    #[inline]
    fn add(self, other: &Vector) -> Vector {
        self.zip_map(other, |a, b| a + b)
    }
}

impl Sub for &Vector {
    type Output = Vector;

    #[inline]
    fn sub(self, other: &Vector) -> Vector {
        self.zip_map(other, |a, b| a - b)
    }
}

impl Mul<f64> for &Vector {
    type Output = Vector;

    #[inline]
    fn mul(self, by: f64) -> Vector {
        self.map(|x| x * by)
    }
}

impl Mul<f64> for Vector {
    type Output = Vector;

    #[inline]
    fn mul(mut self, by: f64) -> Vector {
        for x in self.iter_mut() {
            *x *= by;
        }
        self
    }
}

impl Neg for Vector {
    type Output = Vector;

    #[inline]
    fn neg(self) -> Vector {
        self * -1.0
    }
}

impl AddAssign<&Vector> for Vector {
    #[inline]
    fn add_assign(&mut self, other: &Vector) {
        self.combine(other, |a, b| a + b);
    }
}

impl SubAssign<&Vector> for Vector {
    #[inline]
    fn sub_assign(&mut self, other: &Vector) {
        self.combine(other, |a, b| a - b);
    }
}

impl Mul<&Vector> for &Matrix {
    type Output = Vector;

    /// Computed column by column, so that the compiler can use vector instructions.
    #[inline]
    fn mul(self, x: &Vector) -> Vector {
        let (n, a) = (self.nrows(), self.as_slice());
        let mut y = Vector::zeros(n);
        for j in 0..self.ncols() {
            y.add_times(x[j], &a[j * n..][..n]);
        }
        y
    }
}

/// The product of the transpose of `a` and the vector `x`.
#[inline]
pub fn transposed(a: &Matrix, x: &[f64]) -> Vector {
    let (n, numbers) = (a.nrows(), a.as_slice());
    Vector::from_fn(a.ncols(), |j| dot(&numbers[j * n..][..n], x))
}

/// The scalar product of two vectors of the same length.
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let b = &b[..a.len()];
    let mut sum = 0.0;
    for i in 0..a.len() {
        sum += a[i] * b[i];
    }
    sum
}
