//! Statistics of a recorded quantity. Its range is over samples and both sides of events; means and percentiles are over the
//! samples, which are evenly spaced.

use crate::trajectory::Moment;

/// Statistics of one column [unit of the column].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
    /// The mean.
    pub mean: f64,
    /// The root mean square about the mean.
    pub rms: f64,
    /// The value that 1 % of the samples do not exceed.
    pub p01: f64,
    /// The value that 99 % of the samples do not exceed.
    pub p99: f64,
}

impl Statistics {
    /// Their names, in the order of [`Statistics::values`].
    pub const NAMES: [&str; 6] = ["min", "max", "mean", "rms", "p01", "p99"];

    /// Those of a column `x` with the kinds of its rows; `None` if there is no sample.
    pub fn of(x: &[f64], moments: &[Moment]) -> Option<Statistics> {
        let rows = x.iter().zip(moments);
        let mut samples: Vec<f64> = rows.filter(|(_, m)| **m == Moment::Sample).map(|(x, _)| *x).collect();
        if samples.is_empty() {
            return None;
        }
        let n = samples.len() as f64;
        let mean = samples.iter().sum::<f64>() / n;
        let square = samples.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n;
        let mut percentile = |share| percentile(&mut samples, share);
        let (p01, p99) = (percentile(0.01), percentile(0.99));
        let min = x.iter().copied().fold(f64::INFINITY, f64::min);
        let max = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Some(Statistics { min, max, mean, rms: square.sqrt(), p01, p99 })
    }

    /// All values.
    pub fn values(&self) -> [f64; 6] {
        [self.min, self.max, self.mean, self.rms, self.p01, self.p99]
    }
}

/// The value that a `share` of the samples do not exceed, interpolated between the two samples about it (type 7 of Hyndman & Fan,
/// The American Statistician 50 (1996), 361-365).
pub(crate) fn percentile(samples: &mut [f64], share: f64) -> f64 {
    let place = share * (samples.len() - 1) as f64;
    let (below, rest) = (place.floor() as usize, place.fract());
    let (_, low, above) = samples.select_nth_unstable_by(below, f64::total_cmp);
    let low = *low;
    let high = above.iter().copied().min_by(f64::total_cmp).unwrap_or(low);
    low + rest * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_statistics_of_an_offset_sine_are_exact() {
        let n = 1000;
        let x: Vec<f64> = (0..n).map(|i| 3.0 + 2.0 * (std::f64::consts::TAU * i as f64 / n as f64).sin()).collect();
        let s = Statistics::of(&x, &vec![Moment::Sample; n]).unwrap();
        // The tolerance allows for the rounding of a sum of 1000 terms.
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(s.min, 1.0) && near(s.max, 5.0) && near(s.mean, 3.0) && near(s.rms, 2.0_f64.sqrt()));
    }

    #[test]
    fn percentiles_are_interpolated_and_take_samples_only() {
        let x: Vec<f64> = (0..=100).rev().map(f64::from).chain([1000.0]).collect();
        let mut moments = vec![Moment::Sample; 101];
        moments.push(Moment::After);
        let s = Statistics::of(&x, &moments).unwrap();
        assert_eq!((s.p01, s.p99, s.max), (1.0, 99.0, 1000.0));
        let halves = Statistics::of(&[0.0, 1.0], &[Moment::Sample; 2]).unwrap();
        assert!((halves.p01 - 0.01).abs() < 1e-15 && (halves.p99 - 0.99).abs() < 1e-15);
        assert!(Statistics::of(&[1.0], &[Moment::Before]).is_none());
    }
}
