//! The types of numbers in which derived equations can be evaluated: f64, and double-double numbers.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use xprec::Df64;

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
    fn powi(self, n: i32) -> Self;
    fn powf(self, x: Self) -> Self;
    fn atan2(self, x: Self) -> Self;
    fn sqrt(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn tan(self) -> Self;
    fn recip(self) -> Self;
}

macro_rules! real {
    ($number:ty) => {
        impl Real for $number {
            fn powi(self, n: i32) -> Self {
                <$number>::powi(self, n)
            }
            fn powf(self, x: Self) -> Self {
                <$number>::powf(self, x)
            }
            fn atan2(self, x: Self) -> Self {
                <$number>::atan2(self, x)
            }
            real!($number: sqrt exp ln sin cos tan recip);
        }
    };
    ($number:ty: $($function:ident)*) => {
        $(fn $function(self) -> Self {
            <$number>::$function(self)
        })*
    };
}

real!(f64);
real!(Df64);
