//! Numbers side by side. Plain loops over arrays: compiled for the processor at hand, each is one or two instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number for each of L lanes. With one lane, numbers that follow each other in memory are apart by the alignment: else the
/// compiler makes pairs of the coordinates' numbers, and a single motion waits for the shuffles between them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(16))]
pub struct Pack<const L: usize>(pub [f64; L]);

/// A yes or no for each lane: all bits, or none, as processors have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mask<const L: usize>([u64; L]);

impl<const L: usize> Mask<L> {
    /// From a yes or no for each lane.
    #[inline(always)]
    pub fn of(lanes: impl Fn(usize) -> bool) -> Self {
        let mut result = [0; L];
        for i in 0..L {
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
    pub fn and(self, other: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] & other.0[i];
        }
        Mask(result)
    }

    /// Lanes for which one or both hold.
    #[inline(always)]
    pub fn with(self, other: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] | other.0[i];
        }
        Mask(result)
    }

    /// Lanes of these that are not among the `others`.
    #[inline(always)]
    pub fn without(self, others: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] & !others.0[i];
        }
        Mask(result)
    }

    /// Whether every lane says yes.
    #[inline(always)]
    pub fn everywhere(self) -> bool {
        let mut all = u64::MAX;
        for i in 0..L {
            all &= self.0[i];
        }
        all == u64::MAX
    }

    /// Whether some lane is one of both.
    #[inline(always)]
    pub fn meets(self, other: Self) -> bool {
        let mut common = 0;
        for i in 0..L {
            common |= self.0[i] & other.0[i];
        }
        common != 0
    }

    /// Whether every lane of `other` is one of these.
    #[inline(always)]
    pub fn covers(self, other: Self) -> bool {
        let mut lacking = 0;
        for i in 0..L {
            lacking |= other.without(self).0[i];
        }
        lacking == 0
    }
}

impl<const L: usize> Pack<L> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn all(x: f64) -> Self {
        Pack([x; L])
    }

    /// `f` of every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.zip(self, |x, _| f(x))
    }

    /// `f` of every lane of two packs.
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut result = [0.0; L];
        for i in 0..L {
            result[i] = f(self.0[i], other.0[i]);
        }
        Pack(result)
    }

    /// Square roots.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    /// Magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// Whether `test` holds, lane by lane.
    #[inline(always)]
    pub fn compare(self, other: Self, test: impl Fn(f64, f64) -> bool) -> Mask<L> {
        Mask::of(|i| test(self.0[i], other.0[i]))
    }

    /// The same as [`Pack::or`] for a mask that is nearly always the same in every lane: the processor predicts the branch, so
    /// that what follows does not wait for the mask.
    #[inline(always)]
    pub fn mostly(self, mask: Mask<L>, other: Self) -> Self {
        if mask.everywhere() { self } else { self.or(mask, other) }
    }

    /// This where `mask` says so, the other elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask<L>, other: Self) -> Self {
        let mut result = [0.0; L];
        for i in 0..L {
            let bits = (self.0[i].to_bits() & mask.0[i]) | (other.0[i].to_bits() & !mask.0[i]);
            result[i] = f64::from_bits(bits);
        }
        Pack(result)
    }
}

macro_rules! operator {
    ($name:ident, $function:ident, $operator:tt) => {
        impl<const L: usize> $name for Pack<L> {
            type Output = Pack<L>;
            #[inline(always)]
            fn $function(self, other: Pack<L>) -> Pack<L> {
                self.zip(other, |a, b| a $operator b)
            }
        }
        impl<const L: usize> $name<f64> for Pack<L> {
            type Output = Pack<L>;
            #[inline(always)]
            fn $function(self, other: f64) -> Pack<L> {
                self.map(|a| a $operator other)
            }
        }
        impl<const L: usize> $name<Pack<L>> for f64 {
            type Output = Pack<L>;
            #[inline(always)]
            fn $function(self, other: Pack<L>) -> Pack<L> {
                other.map(|b| self $operator b)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<const L: usize> Neg for Pack<L> {
    type Output = Pack<L>;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}
