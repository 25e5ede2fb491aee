//! Numbers side by side. The operations are plain loops over arrays, which the compiler turns into one or two vector
//! instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// One number for each of L lanes. With one lane, the alignment keeps numbers that follow each other in memory apart. Otherwise
/// the compiler would combine the numbers of two coordinates into one vector, and a single simulation would wait for the
/// shuffles.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(16))]
pub struct Pack<const L: usize>(pub [f64; L]);

/// A boolean for each lane: all bits set or none, as processors represent it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mask<const L: usize>([u64; L]);

impl<const L: usize> Mask<L> {
    /// The mask with the given boolean for each lane.
    #[inline(always)]
    pub fn of(lanes: impl Fn(usize) -> bool) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = 0_u64.wrapping_sub(u64::from(lanes(i)));
        }
        Mask(result)
    }

    /// Whether a lane is set.
    #[inline(always)]
    pub fn is_set(self, lane: usize) -> bool {
        self.0[lane] != 0
    }

    /// The lanes that are set in both.
    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] & other.0[i];
        }
        Mask(result)
    }

    /// The lanes that are set in at least one.
    #[inline(always)]
    pub fn with(self, other: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] | other.0[i];
        }
        Mask(result)
    }

    /// The lanes that are set here but not in `others`.
    #[inline(always)]
    pub fn without(self, others: Self) -> Self {
        let mut result = [0; L];
        for i in 0..L {
            result[i] = self.0[i] & !others.0[i];
        }
        Mask(result)
    }

    /// Whether all lanes are set.
    #[inline(always)]
    pub fn is_all(self) -> bool {
        let mut all = u64::MAX;
        for i in 0..L {
            all &= self.0[i];
        }
        all == u64::MAX
    }

    /// Whether a lane is set in both.
    #[inline(always)]
    pub fn intersects(self, other: Self) -> bool {
        let mut common = 0;
        for i in 0..L {
            common |= self.0[i] & other.0[i];
        }
        common != 0
    }

    /// Whether all lanes of `other` are set here.
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

    /// `f` of the number in every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.zip(self, |x, _| f(x))
    }

    /// `f` of the numbers of two packs in every lane.
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

    /// Absolute values.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// The lanes in which `test` holds.
    #[inline(always)]
    pub fn compare(self, other: Self, test: impl Fn(f64, f64) -> bool) -> Mask<L> {
        Mask::of(|i| test(self.0[i], other.0[i]))
    }

    /// The same as [`Pack::or`], for a mask that nearly always has the same value in every lane. The processor predicts the
    /// branch, so that the following operations do not wait for the mask.
    #[inline(always)]
    pub fn or_uniform(self, mask: Mask<L>, other: Self) -> Self {
        if mask.is_all() { self } else { self.or(mask, other) }
    }

    /// Selects the lanes of `mask` from `self`, the others from `other`.
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

/// The sum a + b and its rounding error (Knuth).
#[inline(always)]
pub fn two_sum<const L: usize>(a: Pack<L>, b: Pack<L>) -> [Pack<L>; 2] {
    let sum = a + b;
    let part = sum - a;
    [sum, (a - (sum - part)) + (b - part)]
}
