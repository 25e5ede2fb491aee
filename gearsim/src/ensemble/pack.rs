//! Eight numbers side by side. Plain loops over arrays: compiled for the processor at hand, each is one or two
//! instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Lanes of a pack.
pub const LANES: usize = 8;

/// A number for each lane.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Pack(pub [f64; LANES]);

/// A yes or no for each lane: all bits, or none, as processors have it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Mask([u64; LANES]);

impl Mask {
    /// From a yes or no for each lane.
    #[inline(always)]
    pub fn of(lanes: impl Fn(usize) -> bool) -> Mask {
        let mut result = [0; LANES];
        for i in 0..LANES {
            result[i] = 0_u64.wrapping_sub(u64::from(lanes(i)));
        }
        Mask(result)
    }

    /// Whether a lane says yes.
    #[inline(always)]
    pub fn says(self, lane: usize) -> bool {
        self.0[lane] != 0
    }

    /// Lanes for which both hold.
    #[inline(always)]
    pub fn and(self, other: Mask) -> Mask {
        let mut result = [0; LANES];
        for i in 0..LANES {
            result[i] = self.0[i] & other.0[i];
        }
        Mask(result)
    }

    /// Lanes for which one or both hold.
    #[inline(always)]
    pub fn with(self, other: Mask) -> Mask {
        let mut result = [0; LANES];
        for i in 0..LANES {
            result[i] = self.0[i] | other.0[i];
        }
        Mask(result)
    }

    /// Lanes of these that are not among the `others`.
    #[inline(always)]
    pub fn without(self, others: Mask) -> Mask {
        let mut result = [0; LANES];
        for i in 0..LANES {
            result[i] = self.0[i] & !others.0[i];
        }
        Mask(result)
    }

    /// Whether every lane of `other` is one of these.
    #[inline(always)]
    pub fn covers(self, other: Mask) -> bool {
        let mut lacking = 0;
        for i in 0..LANES {
            lacking |= other.without(self).0[i];
        }
        lacking == 0
    }
}

impl Pack {
    /// The same number in every lane.
    #[inline(always)]
    pub fn all(x: f64) -> Pack {
        Pack([x; LANES])
    }

    /// `f` of every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Pack {
        self.zip(self, |x, _| f(x))
    }

    /// `f` of every lane of two packs.
    #[inline(always)]
    pub fn zip(self, other: Pack, f: impl Fn(f64, f64) -> f64) -> Pack {
        let mut result = [0.0; LANES];
        for i in 0..LANES {
            result[i] = f(self.0[i], other.0[i]);
        }
        Pack(result)
    }

    /// Square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Pack {
        self.map(f64::sqrt)
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Pack {
        self.map(f64::abs)
    }

    /// Whether `test` holds, lane by lane.
    #[inline(always)]
    pub fn compare(self, other: Pack, test: impl Fn(f64, f64) -> bool) -> Mask {
        Mask::of(|i| test(self.0[i], other.0[i]))
    }

    /// This where `mask` says so, the other elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask, other: Pack) -> Pack {
        let mut result = [0.0; LANES];
        for i in 0..LANES {
            let bits = (self.0[i].to_bits() & mask.0[i]) | (other.0[i].to_bits() & !mask.0[i]);
            result[i] = f64::from_bits(bits);
        }
        Pack(result)
    }
}

macro_rules! operator {
    ($name:ident, $function:ident, $operator:tt) => {
        impl $name for Pack {
            type Output = Pack;
            #[inline(always)]
            fn $function(self, other: Pack) -> Pack {
                self.zip(other, |a, b| a $operator b)
            }
        }
        impl $name<f64> for Pack {
            type Output = Pack;
            #[inline(always)]
            fn $function(self, other: f64) -> Pack {
                self.map(|a| a $operator other)
            }
        }
        impl $name<Pack> for f64 {
            type Output = Pack;
            #[inline(always)]
            fn $function(self, other: Pack) -> Pack {
                other.map(|b| self $operator b)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Neg for Pack {
    type Output = Pack;
    #[inline(always)]
    fn neg(self) -> Pack {
        self.map(|x| -x)
    }
}
