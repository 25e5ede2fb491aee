//! Distributions of random axes.

use std::f64::consts::SQRT_2;

use statrs::function::erf::{erfc, erfc_inv};

use super::axis::Spacing;

/// The distribution of the values of a random axis [unit of the axis].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Uniformly distributed between two ends.
    Uniform {
        /// Least value.
        low: f64,
        /// Greatest value.
        high: f64,
        /// Whether the value or its logarithm is uniformly distributed.
        spacing: Spacing,
    },
    /// Normally distributed; truncated to the interval `within` if there is one.
    Normal {
        /// Mean before truncation.
        mean: f64,
        /// Standard deviation before truncation, positive.
        deviation: f64,
        /// Least and greatest value.
        within: Option<(f64, f64)>,
    },
}

impl Distribution {
    /// The value that a share `p`, 0 to 1, of all values do not exceed.
    pub fn quantile(&self, p: f64) -> f64 {
        match *self {
            Distribution::Uniform { low, high, spacing } => spacing.between(low, high, p),
            Distribution::Normal { mean, deviation, within: None } => {
                // A random number is 0 once in 2^53 times. It stands for an interval of that width; use the middle of the interval.
                let p = p.max(0.25 * f64::EPSILON);
                Spacing::rounded(mean + deviation * standard(p, (f64::NEG_INFINITY, f64::INFINITY)))
            }
            Distribution::Normal { mean, deviation, within: Some((low, high)) } => {
                let ends = ((low - mean) / deviation, (high - mean) / deviation);
                Spacing::rounded(mean + deviation * standard(p, ends)).clamp(low, high)
            }
        }
    }

    /// Values to try before any point runs: the ends of an interval. The values of a distribution without ends are tried at its mean
    /// and at three standard deviations from it; a value further out that the scene does not admit gives a row with the reason.
    pub fn trials(&self) -> Vec<f64> {
        match *self {
            Distribution::Uniform { low, high, .. } | Distribution::Normal { within: Some((low, high)), .. } => {
                vec![low, high]
            }
            Distribution::Normal { mean, deviation, within: None } => {
                vec![mean, Spacing::rounded(mean - 3.0 * deviation), Spacing::rounded(mean + 3.0 * deviation)]
            }
        }
    }
}

/// The quantile of the standard normal distribution between two ends. An interval that is mostly above the mean is mirrored, because 1 - p
/// has few digits for a share p near 1.
fn standard(p: f64, (low, high): (f64, f64)) -> f64 {
    if low + high > 0.0 {
        return -standard(1.0 - p, (-high, -low));
    }
    let (below, above) = (lower(low), lower(-high));
    let within = lower(high) - below;
    if within < f64::MIN_POSITIVE / f64::EPSILON {
        return far(p, (low, high));
    }
    let (p, q) = (below + p * within, above + (1.0 - p) * within);
    if p < 0.5 { inverse(p) } else { -inverse(q) }
}

/// The same so far below the mean that the distribution function has no digits left. There it is exp(-z²/2)/(-z sqrt(2 pi)) (1 + O(z⁻²)), and
/// falls from the upper end in proportion to exp(-z²/2)/-z.
fn far(p: f64, (low, high): (f64, f64)) -> f64 {
    let log = |z: f64| -0.5 * z * z - (-z).ln();
    // ln of the share of the values below the upper end that lie below z, by the share p between the ends.
    let below = (log(low) - log(high)).exp();
    let sought = (below + p * (1.0 - below)).ln() + log(high);
    let mut z = high;
    for _ in 0..NEWTON {
        z = (z - (log(z) - sought) / (-z - 1.0 / z)).clamp(low, high);
    }
    z
}

/// Steps of Newton's method for a smooth function that is almost a parabola: four are enough.
const NEWTON: usize = 8;

/// The distribution function of the standard normal distribution: the probability that a random number is below `z`.
fn lower(z: f64) -> f64 {
    0.5 * erfc(-z / SQRT_2)
}

/// The quantile of the standard normal distribution: a random number is below it with probability `p`.
fn inverse(p: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal(within: Option<(f64, f64)>) -> Distribution {
        Distribution::Normal { mean: 10.0, deviation: 2.0, within }
    }

    /// Published tables give 1.959964 for p = 0.975, 2.326348 for 0.99, and 3.090232 for 0.999.
    #[test]
    fn quantiles_of_the_normal_distribution_are_those_of_tables() {
        for (p, z) in
            [(0.5, 0.0), (0.975, 1.959_963_984_540_054), (0.01, -2.326_347_874_040_841), (0.999, 3.090_232_306_167_813)]
        {
            let x = normal(None).quantile(p);
            assert!((x - (10.0 + 2.0 * z)).abs() < 1e-12, "{p}: {x}");
        }
        // The ends of the random numbers: about 8 standard deviations.
        for (p, beyond) in [(0.0, -8.0), (1.0 - 0.5 * f64::EPSILON, 8.0)] {
            let z = (normal(None).quantile(p) - 10.0) / 2.0;
            assert!(z / beyond > 1.0 && z.is_finite() && z.abs() < 9.0, "{z}");
        }
    }

    /// The quantiles of a truncated distribution: F(x) = (Phi(z) - Phi(a)) / (Phi(b) - Phi(a)).
    #[test]
    fn a_truncated_distribution_stays_within_its_ends() {
        let (low, high) = (9.0, 16.0);
        let cut = normal(Some((low, high)));
        assert_eq!((cut.quantile(0.0), cut.quantile(1.0)), (low, high));
        let share = |x: f64| {
            let phi = |x: f64| lower((x - 10.0) / 2.0);
            (phi(x) - phi(low)) / (phi(high) - phi(low))
        };
        for p in [0.001, 0.3, 0.5, 0.9, 0.9999] {
            // The inverse of the error function is right to some 1e-11.
            assert!((share(cut.quantile(p)) - p).abs() < 1e-10, "{p}");
        }
    }

    /// Ends where the distribution function is zero in double precision. Beyond 50 deviations the excess is exponentially distributed with the
    /// rate 50, up to terms of 1/50²: the median is at ln 2/50.
    #[test]
    fn quantiles_beyond_the_range_of_the_distribution_function_are_at_the_near_end() {
        for sign in [1.0, -1.0] {
            let ends = [sign * 50.0, sign * 60.0];
            let within = Some((f64::min(ends[0], ends[1]), f64::max(ends[0], ends[1])));
            let cut = Distribution::Normal { mean: 0.0, deviation: 1.0, within };
            let excess = cut.quantile(0.5).abs() - 50.0;
            assert!((excess * 50.0 / std::f64::consts::LN_2 - 1.0).abs() < 1e-3, "{excess}");
            assert!(cut.quantile(0.01).abs() < 50.1 && cut.quantile(0.99).abs() < 50.1);
        }
    }

    /// Ends far out in one tail, where 1 - Phi has no digits left in double precision.
    #[test]
    fn quantiles_far_in_a_tail_are_accurate() {
        let cut = Distribution::Normal { mean: 0.0, deviation: 1.0, within: Some((9.0, 10.0)) };
        let median = cut.quantile(0.5);
        let tail = |z: f64| lower(-z);
        assert!(((tail(median) - tail(10.0)) / (tail(9.0) - tail(10.0)) - 0.5).abs() < 1e-9, "{median}");
    }
}
