//! The types of numbers in which derived equations can be evaluated: f64, and double-double numbers.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use nalgebra::DVector;
pub use xprec::Df64;

use crate::vector::Vector;

mod double;
pub use double::Double;

/// A real number with the operations that occur in derived equations.
#[allow(missing_docs)] // those of f64
pub trait Real:
    nalgebra::Scalar
    + Copy
    + From<f64>
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A vector of such numbers.
    type Row: Clone + Debug + PartialEq + AsRef<[Self]>;

    /// The vector of the given numbers.
    fn row(numbers: &[Self]) -> Self::Row;
    /// Adds `by` times `other` to a vector.
    fn add_times(row: &mut Self::Row, by: Self, other: &Self::Row);

    fn powi(self, n: i32) -> Self;
    fn powf(self, x: Self) -> Self;
    fn atan2(self, x: Self) -> Self;
    fn sqrt(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn tan(self) -> Self;
    fn atan(self) -> Self;
    fn recip(self) -> Self;
}

macro_rules! real {
    ($number:ty: $row:ty, |$numbers:ident| $of:expr, |$sum:ident, $by:ident, $other:ident| $add:expr) => {
        impl Real for $number {
            type Row = $row;

            #[inline]
            fn row($numbers: &[Self]) -> $row {
                $of
            }
            #[inline]
            fn add_times($sum: &mut $row, $by: Self, $other: &$row) {
                $add;
            }
            #[inline]
            fn powi(self, n: i32) -> Self {
                <$number>::powi(self, n)
            }
            #[inline]
            fn powf(self, x: Self) -> Self {
                <$number>::powf(self, x)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                <$number>::atan2(self, x)
            }
            real!(of $number: sqrt exp ln sin cos tan atan recip);
        }
    };
    (of $number:ty: $($function:ident)*) => {
        $(#[inline]
        fn $function(self) -> Self {
            <$number>::$function(self)
        })*
    };
}

real!(f64: Vector, |numbers| Vector::from(numbers), |row, by, other| row.add_times(by, other));
real!(Df64: DVector<Df64>, |numbers| DVector::from_column_slice(numbers), |row, by, other| *row += other * by);
real!(Double: DVector<Double>, |numbers| DVector::from_column_slice(numbers), |row, by, other| {
    row.iter_mut().zip(other).for_each(|(x, y)| *x += by * *y)
});

/// Numbers whose size can be compared, after rounding to f64.
pub trait Sized64: Real {
    /// The number rounded to f64.
    fn rounded(self) -> f64;
}

impl Sized64 for f64 {
    #[inline]
    fn rounded(self) -> f64 {
        self
    }
}

impl Sized64 for Df64 {
    #[inline]
    fn rounded(self) -> f64 {
        self.hi()
    }
}
