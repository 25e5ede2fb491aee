//! Counter-based random numbers: the n-th number of a seed depends on the seed and n alone, so numbers can be drawn in any order.
//!
//! SplitMix64: z = seed + (n + 1) g, then its bits are mixed; g = 2^64 / golden ratio, odd. Source: G. L. Steele, D. Lea, C. H. Flood,
//! "Fast splittable pseudorandom number generators", OOPSLA 2014, doi:10.1145/2660193.2660195.

/// Random number `n` (from 0) of `seed`, 64 bits.
pub fn bits(seed: u64, n: u64) -> u64 {
    let z = seed.wrapping_add(n.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

/// Random number `n` of `seed`, uniformly distributed in [0, 1).
pub fn fraction(seed: u64, n: u64) -> f64 {
    unit(bits(seed, n))
}

/// The number in [0, 1) whose first binary digits are the upper 53 of `bits`, as many as an f64 has.
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 * (0.5 * f64::EPSILON)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of the authors' generator for the seed 1234567, as published on Rosetta Code.
    #[test]
    fn numbers_equal_those_of_the_published_generator() {
        let published =
            [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431, 16408922859458223821];
        assert_eq!((0..5).map(|n| bits(1234567, n)).collect::<Vec<_>>(), published);
    }

    #[test]
    fn fractions_are_uniformly_distributed() {
        let n = 100_000;
        let (mut mean, mut counts) = (0.0, [0; 10]);
        for x in (0..n).map(|i| fraction(7, i)) {
            assert!((0.0..1.0).contains(&x));
            mean += x / n as f64;
            counts[(10.0 * x) as usize] += 1;
        }
        // Bounds of six standard deviations: sqrt(1/(12 n)) of the mean, sqrt(0.09 n) of a count.
        assert!((mean - 0.5).abs() < 6.0 / (12.0 * n as f64).sqrt(), "{mean}");
        let most = 6.0 * (0.09 * n as f64).sqrt();
        assert!(counts.iter().all(|&count| (f64::from(count) - n as f64 / 10.0).abs() < most), "{counts:?}");
    }
}
