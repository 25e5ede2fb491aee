//! Numbers with `BITS` bits: m 2^e with an integer m of dashu.
//!
//! Results are truncated, not rounded: an operation may have an error of one unit in the last place. The accuracy of a result is
//! checked by a repetition with more bits. dashu's own floats have the same operations at ten times the cost.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_base::{BitTest, Sign, SquareRoot};
use dashu_int::IBig;

use super::elementary;

/// The operations that the closed form of a cell needs. `f64` is used to explore, [`Real`] to decide.
pub trait Scalar:
    Clone
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Relative size below which a term of a series is negligible.
    const NEGLIGIBLE: f64;
    /// The number itself, exactly.
    fn exact(x: f64) -> Self;
    /// The nearest `f64`, to one unit in its last place.
    fn approx(&self) -> f64;
    /// Divided by a small integer.
    fn over(&self, n: u32) -> Self;
    /// Times 2^n.
    fn scaled(&self, n: i32) -> Self;
    /// Square root of a number that is not negative.
    fn root(&self) -> Self;
    /// e^x
    fn exponential(&self) -> Self;
    /// (sin x, cos x)
    fn sine_cosine(&self) -> (Self, Self);
}

impl Scalar for f64 {
    const NEGLIGIBLE: f64 = 1e-18;
    fn exact(x: f64) -> Self {
        x
    }
    fn approx(&self) -> f64 {
        *self
    }
    fn over(&self, n: u32) -> Self {
        self / f64::from(n)
    }
    fn scaled(&self, n: i32) -> Self {
        self * f64::powi(2.0, n)
    }
    fn root(&self) -> Self {
        self.sqrt()
    }
    fn exponential(&self) -> Self {
        self.exp()
    }
    fn sine_cosine(&self) -> (Self, Self) {
        self.sin_cos()
    }
}

/// m 2^e, where m has at most `BITS` bits.
#[derive(Debug, Clone)]
pub struct Real<const BITS: usize> {
    m: IBig,
    e: i64,
}

impl<const BITS: usize> Real<BITS> {
    fn new(m: IBig, e: i64) -> Self {
        let excess = m.bit_len().saturating_sub(BITS);
        if excess == 0 { Self { m, e } } else { Self { m: m >> excess, e: e + excess as i64 } }
    }

    /// x as a multiple of 2^-`places`, truncated.
    pub(super) fn fixed(&self, places: i64) -> IBig {
        let shift = self.e + places;
        if shift >= 0 { &self.m << shift as usize } else { &self.m >> (-shift) as usize }
    }

    /// m 2^-`places`
    pub(super) fn from_fixed(m: IBig, places: i64) -> Self {
        Self::new(m, -places)
    }

    /// Position of the leading binary digit: |x| < 2^magnitude.
    pub(super) fn magnitude(&self) -> i64 {
        if self.m.is_zero() { i64::MIN / 4 } else { self.e + self.m.bit_len() as i64 }
    }

    /// Whether the number is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.m.is_zero()
    }

    /// Whether the number is below zero.
    pub fn is_negative(&self) -> bool {
        self.m.sign() == Sign::Negative && !self.m.is_zero()
    }

    /// |x|
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self.clone() } else { self.clone() }
    }

    /// The number as a sum of two `f64`, with 32 digits.
    pub fn pair(&self) -> (f64, f64) {
        let high = self.approx();
        (high, (self.clone() - Self::exact(high)).approx())
    }
}

/// 2^n, zero or infinite beyond the range.
fn power_of_two(n: i64) -> f64 {
    let n = n.clamp(-1200, 1200) as i32;
    2f64.powi(n / 2) * 2f64.powi(n - n / 2)
}

impl<const BITS: usize> Scalar for Real<BITS> {
    // 2^-(BITS + 8)
    const NEGLIGIBLE: f64 = f64::from_bits((1023 - 8 - BITS as u64) << 52);

    fn exact(x: f64) -> Self {
        assert!(x.is_finite(), "not a finite number: {x}");
        if x == 0.0 {
            return Self { m: IBig::ZERO, e: 0 };
        }
        let (bits, exponent) = (x.to_bits(), (x.to_bits() >> 52 & 0x7ff) as i64);
        let fraction = bits & ((1 << 52) - 1);
        let (m, e) = if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
        let m = IBig::from(m);
        Self { m: if x < 0.0 { -m } else { m }, e }
    }

    fn approx(&self) -> f64 {
        // the leading 64 bits, which the conversion then rounds
        let excess = self.m.bit_len().saturating_sub(64);
        let (sign, words) = self.m.as_sign_words();
        let top = |i: usize| words.get(i).copied().unwrap_or(0);
        let (word, bit) = (excess / 64, excess % 64);
        let low = top(word) >> bit;
        let m = if bit == 0 { low } else { low | top(word + 1) << (64 - bit) };
        let e = self.e + excess as i64;
        let x = m as f64 * power_of_two(e / 2) * power_of_two(e - e / 2);
        if sign == Sign::Negative { -x } else { x }
    }

    fn over(&self, n: u32) -> Self {
        let spare = (BITS + 32).saturating_sub(self.m.bit_len());
        Self::new((&self.m << spare) / n, self.e - spare as i64)
    }

    fn scaled(&self, n: i32) -> Self {
        Self { m: self.m.clone(), e: self.e + i64::from(n) }
    }

    fn root(&self) -> Self {
        assert!(!self.is_negative(), "square root of a negative number");
        let mut spare = (2 * BITS + 2).saturating_sub(self.m.bit_len()) as i64;
        // makes the exponent even
        spare += (self.e - spare) & 1;
        let m = (&self.m << spare as usize).sqrt();
        Self::new(m.into(), (self.e - spare) / 2)
    }

    fn exponential(&self) -> Self {
        elementary::exp(self)
    }

    fn sine_cosine(&self) -> (Self, Self) {
        elementary::sin_cos(self)
    }
}

impl<const BITS: usize> Add for Real<BITS> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = if self.magnitude() >= other.magnitude() { (self, other) } else { (other, self) };
        if low.is_zero() || high.magnitude() - low.magnitude() > BITS as i64 + 2 {
            return high;
        }
        let by = high.e - low.e;
        match by >= 0 {
            true => Self::new((high.m << by as usize) + low.m, low.e),
            false => Self::new(high.m + (low.m << (-by) as usize), high.e),
        }
    }
}

impl<const BITS: usize> Neg for Real<BITS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { m: -self.m, e: self.e }
    }
}

impl<const BITS: usize> Sub for Real<BITS> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const BITS: usize> Mul for Real<BITS> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.m * other.m, self.e + other.e)
    }
}

impl<const BITS: usize> Div for Real<BITS> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let spare = (BITS + 2 + other.m.bit_len()).saturating_sub(self.m.bit_len());
        Self::new((self.m << spare) / other.m, self.e - other.e - spare as i64)
    }
}

impl<const BITS: usize> PartialEq for Real<BITS> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const BITS: usize> PartialOrd for Real<BITS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let apart = self.m.sign() != other.m.sign() || (self.magnitude() - other.magnitude()).abs() > 1;
        if apart && !self.is_zero() && !other.is_zero() {
            let larger = self.m.sign() != other.m.sign() || self.magnitude() > other.magnitude();
            return Some(if larger != self.is_negative() { Ordering::Greater } else { Ordering::Less });
        }
        let difference = self.clone() - other.clone();
        Some(match (difference.is_zero(), difference.is_negative()) {
            (true, _) => Ordering::Equal,
            (_, true) => Ordering::Less,
            _ => Ordering::Greater,
        })
    }
}
