//! Double-double numbers whose operations are calls.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use xprec::Df64;

/// A double-double number for derived equations. The compiler inlines each operation of [`Df64`] as some twenty instructions. The equations
/// of a model contain thousands of operations and are evaluated once a cell, so here each operation is a call. This saves a quarter of the
/// machine code of gearsim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Double(Df64);

impl From<f64> for Double {
    #[inline]
    fn from(x: f64) -> Self {
        Double(x.into())
    }
}

impl From<Df64> for Double {
    #[inline]
    fn from(x: Df64) -> Self {
        Double(x)
    }
}

impl From<Double> for Df64 {
    #[inline]
    fn from(x: Double) -> Self {
        x.0
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident),*) => {
        $(impl $operator for Double {
            type Output = Double;

            #[inline(never)]
            fn $function(self, other: Double) -> Double {
                Double(self.0.$function(other.0))
            }
        })*
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl AddAssign for Double {
    #[inline]
    fn add_assign(&mut self, other: Double) {
        *self = *self + other;
    }
}

impl Neg for Double {
    type Output = Double;

    #[inline]
    fn neg(self) -> Double {
        Double(-self.0)
    }
}

macro_rules! functions {
    ($($function:ident)*) => {
        $(#[inline(never)]
        pub(super) fn $function(self) -> Double {
            Double(self.0.$function())
        })*
    };
}

impl Double {
    functions!(sqrt exp ln sin cos tan atan recip);

    #[inline(never)]
    pub(super) fn powi(self, n: i32) -> Double {
        Double(self.0.powi(n))
    }

    #[inline(never)]
    pub(super) fn powf(self, x: Double) -> Double {
        Double(self.0.powf(x.0))
    }

    #[inline(never)]
    pub(super) fn atan2(self, x: Double) -> Double {
        Double(self.0.atan2(x.0))
    }
}
