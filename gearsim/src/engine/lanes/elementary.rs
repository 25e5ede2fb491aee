//! e^x - 1, sine and cosine of several numbers at once, without branches, with an error of one or two units in the last place.
//!
//! The arguments are reduced with constants in two and three parts (Cody & Waite, Software Manual for the Elementary Functions,
//! 1980). On the reduced arguments the exponential is its Taylor polynomial; sine and cosine are the minimax polynomials of
//! fdlibm (Sun Microsystems, 1993).

use std::f64::consts::{FRAC_2_PI, LOG2_E};

use crate::engine::lanes::pack::Pack;

/// 1.5 * 2^52. Adding it rounds a number of moderate size to a whole number, which is then in the lowest bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts. The first has trailing zeros, so that its small multiples are exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// pi/2 in three parts.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Largest argument of the exponential, of both signs. At -700 the result is -1. Beyond, the exponent bits of 2^k would overflow into the
/// sign bit.
const LARGEST: f64 = 700.0;

/// e^x - 1; beyond 700 the value at 700, which is 1e304.
#[inline(always)]
pub fn exp_m1<const L: usize>(x: Pack<L>) -> Pack<L> {
    x.map(|x| {
        let x = x.clamp(-LARGEST, LARGEST);
        let rounded = x * LOG2_E + ROUND;
        let k = rounded - ROUND;
        let t = (x - k * LN_2[0]) - k * LN_2[1];
        // 2^k, written into the exponent bits.
        let power = f64::from_bits(rounded.to_bits().wrapping_add(1023) << 52);
        // Evaluate in pairs, which the processor computes in parallel. With one lane, all that follows waits for this result.
        let (t2, pair) = (t * t, |low: f64, high: f64| 1.0 / low + t * (1.0 / high));
        let t4 = t2 * t2;
        let low = pair(2.0, 6.0) + t2 * pair(24.0, 120.0);
        let middle = pair(720.0, 5_040.0) + t2 * pair(40_320.0, 362_880.0);
        let high = pair(3_628_800.0, 39_916_800.0) + t2 * pair(479_001_600.0, 6_227_020_800.0);
        (power - 1.0) + power * (t + t2 * (low + t4 * (middle + t4 * high)))
    })
}

/// Sine and cosine for |x| <= `tolerance::modes::KERNEL_ANGLE`.
#[inline(always)]
pub fn sin_cos<const L: usize>(x: Pack<L>) -> (Pack<L>, Pack<L>) {
    let (mut sine, mut cosine) = ([0.0; L], [0.0; L]);
    for i in 0..L {
        let rounded = x.0[i] * FRAC_2_PI + ROUND;
        let quadrant = rounded.to_bits();
        let k = rounded - ROUND;
        let y = ((x.0[i] - k * HALF_PI[0]) - k * HALF_PI[1]) - k * HALF_PI[2];
        let z = y * y;
        let (z2, pair) = (z * z, |low: f64, high: f64| low + z * high);
        let tail = pair(-0.000_198_412_698_298_579_5, 2.755_731_370_707_006_8e-6)
            + z2 * pair(-2.505_076_025_340_686_3e-8, 1.589_690_995_211_55e-10);
        let s = y + y * z * (pair(-0.166_666_666_666_666_32, 0.008_333_333_333_322_49) + z2 * tail);
        let tail = pair(2.480_158_728_947_673e-5, -2.755_731_435_139_066_3e-7)
            + z2 * pair(2.087_572_321_298_175e-9, -1.135_964_755_778_819_5e-11);
        let c = 1.0 - 0.5 * z + z2 * (pair(0.041_666_666_666_666_6, -0.001_388_888_888_887_411) + z2 * tail);
        let (a, b) = if quadrant & 1 == 0 { (s, c) } else { (c, s) };
        sine[i] = if quadrant & 2 == 0 { a } else { -a };
        cosine[i] = if quadrant.wrapping_add(1) & 2 == 0 { b } else { -b };
    }
    (Pack(sine), Pack(cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::modes::KERNEL_ANGLE;

    /// Largest difference from the function of the standard library [units in the last place, of 1 or of the value].
    fn worst(
        from: f64,
        to: f64,
        of: impl Fn(Pack<4>) -> Pack<4>,
        standard: impl Fn(f64) -> f64,
        relative: bool,
    ) -> f64 {
        let mut worst: f64 = 0.0;
        for n in 0..20_000 {
            let x = from + (to - from) * (f64::from(n) + 0.37) / 20_000.0;
            let (got, want) = (of(Pack::all(x)).0[n as usize % 4], standard(x));
            let unit = f64::EPSILON * if relative { want.abs() } else { 1.0 };
            worst = worst.max((got - want).abs() / unit);
        }
        worst
    }

    #[test]
    fn functions_match_the_standard_library_within_two_ulp() {
        assert!(worst(-600.0, 2.0, exp_m1, f64::exp_m1, true) <= 2.0);
        assert!(worst(-1e-3, 1e-3, exp_m1, f64::exp_m1, true) <= 2.0);
        // After hundreds or thousands of decay times nothing is left.
        assert_eq!(worst(-1e5, -600.0, exp_m1, f64::exp_m1, true), 0.0);
        assert_eq!(exp_m1(Pack([f64::NEG_INFINITY, -1434.0])), Pack([-1.0; 2]));
        for end in [1.0, 100.0, KERNEL_ANGLE] {
            assert!(worst(-end, end, |x| sin_cos(x).0, f64::sin, false) <= 1.0, "sine up to {end}");
            assert!(worst(-end, end, |x| sin_cos(x).1, f64::cos, false) <= 1.0, "cosine up to {end}");
        }
        // Small values have a small relative error.
        assert!(worst(-1e-3, 1e-3, |x| sin_cos(x).0, f64::sin, true) <= 1.0);
    }
}
