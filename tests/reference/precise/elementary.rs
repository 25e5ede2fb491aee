//! e^x, sin x and cos x: argument reduction, then Taylor series in integers, then squarings.
//!
//! All steps use `GUARD` additional bits; each squaring loses one of them.

use std::sync::LazyLock;

use dashu_base::BitTest;
use dashu_int::IBig;

use super::number::Real;

const GUARD: i64 = 48;

/// Binary places of the stored constants. With 384 bits, arguments up to 2^500 are reduced without loss.
const PLACES: i64 = 1024;

/// atan(1/n) or, with `alternating` false, artanh(1/n), as a multiple of 2^-PLACES.
fn arc_tangent(n: u32, alternating: bool) -> IBig {
    let mut power = (IBig::ONE << (PLACES + GUARD) as usize) / n;
    let (mut sum, mut index) = (IBig::ZERO, 1u32);
    while !power.is_zero() {
        let term = &power / index;
        if alternating && index % 4 == 3 {
            sum -= term
        } else {
            sum += term
        }
        power /= n * n;
        index += 2;
    }
    sum >> GUARD as usize
}

/// pi/2, by Machin's formula
static QUARTER_TURN: LazyLock<IBig> =
    LazyLock::new(|| (arc_tangent(5, true) * IBig::from(4) - arc_tangent(239, true)) << 1);

/// ln 2 = 2 artanh(1/3)
static LOG_TWO: LazyLock<IBig> = LazyLock::new(|| arc_tangent(3, false) << 1);

/// n and rest of x = n `unit` + rest with 0 <= rest < unit; rest has `places` binary places.
fn reduce<const BITS: usize>(x: &Real<BITS>, unit: &IBig, places: i64) -> (IBig, IBig) {
    // the quotient needs this many places of the unit
    let more = places + x.magnitude().max(0) + 2;
    assert!(more <= PLACES, "argument too large to be reduced");
    let unit = unit >> (PLACES - more) as usize;
    let x = x.fixed(more);
    let mut n = &x / &unit;
    let mut rest = x - &n * &unit;
    if rest < IBig::ZERO {
        n -= IBig::ONE;
        rest += unit;
    }
    (n, rest >> (more - places) as usize)
}

/// e^x; zero for x <= -2^40.
pub fn exp<const BITS: usize>(x: &Real<BITS>) -> Real<BITS> {
    if x.is_negative() && x.magnitude() > 40 {
        return Real::from_fixed(IBig::ZERO, 0);
    }
    const HALVINGS: usize = 8;
    let places = BITS as i64 + GUARD;
    let (n, rest) = reduce(x, &LOG_TWO, places);
    let rest = rest >> HALVINGS;
    let one = IBig::ONE << places as usize;
    let (mut sum, mut term, mut index) = (&one + &rest, rest.clone(), 2u32);
    loop {
        term = ((term * &rest) >> places as usize) / index;
        if term.is_zero() {
            break;
        }
        sum += &term;
        index += 1;
    }
    for _ in 0..HALVINGS {
        sum = sum.sqr_shifted(places);
    }
    let n = i64::try_from(n).expect("the magnitude is bounded");
    Real::from_fixed(sum, places - n)
}

/// (sin x, cos x)
pub fn sin_cos<const BITS: usize>(x: &Real<BITS>) -> (Real<BITS>, Real<BITS>) {
    const HALVINGS: usize = 6;
    // additional places, so that a small argument keeps its relative precision
    let places = BITS as i64 + GUARD + (-x.magnitude()).clamp(0, BITS as i64);
    let (n, rest) = reduce(x, &QUARTER_TURN, places);
    let rest = rest >> HALVINGS;
    let square = rest.sqr_shifted(places);
    let one = IBig::ONE << places as usize;
    let (mut sin, mut cos) = (rest.clone(), one.clone());
    let (mut odd, mut even, mut index) = (rest, one, 1u32);
    loop {
        even = -((even * &square) >> places as usize) / (index * (index + 1));
        odd = -((odd * &square) >> places as usize) / ((index + 1) * (index + 2));
        if even.bit_len() <= 1 {
            break;
        }
        cos += &even;
        sin += &odd;
        index += 2;
    }
    for _ in 0..HALVINGS {
        // cos first, from the old sin: cos 2a = 1 - 2 sin^2 a
        let double = (&sin * &cos) >> (places - 1) as usize;
        cos = (IBig::ONE << places as usize) - (sin.sqr_shifted(places) << 1);
        sin = double;
    }
    let [s, c] = [sin, cos].map(|m| Real::from_fixed(m, places));
    let quadrant = i64::try_from(n & IBig::from(3)).expect("two digits");
    match quadrant {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

trait Square {
    fn sqr_shifted(&self, places: i64) -> IBig;
}

impl Square for IBig {
    fn sqr_shifted(&self, places: i64) -> IBig {
        IBig::from(self.sqr()) >> places as usize
    }
}
