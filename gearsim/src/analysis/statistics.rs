//! Statistics of a recorded quantity. Its range is over samples and both sides of events; means and percentiles are over the
//! samples, which are evenly spaced.

use crate::trajectory::{Moment, value_at};

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

    /// The statistics of a column `x` with the kinds of its rows; `None` if there is no sample.
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

    /// The statistics of a column `x` of samples at the times `t` \[s\] from the time `begin` on, which need not be that of a sample. Mean
    /// and root mean square are integrals over the time, by the trapezoidal rule. For a periodic column over whole periods they are exact,
    /// if the samples resolve it. `None` if less than two samples are later.
    pub fn between(t: &[f64], x: &[f64], begin: f64) -> Option<Statistics> {
        let first = t.partition_point(|&t| t <= begin);
        if first + 1 >= t.len() {
            return None;
        }
        let all = Statistics::of(&x[first..], &vec![Moment::Sample; t.len() - first])?;
        let at_begin = value_at(t, x, begin);
        let head = (begin.min(t[first]), at_begin);
        let points = || std::iter::once(head).chain(t[first..].iter().copied().zip(x[first..].iter().copied()));
        let integral = |of: &dyn Fn(f64) -> f64| {
            let pairs = points().zip(points().skip(1));
            pairs.map(|((t0, x0), (t1, x1))| 0.5 * (of(x0) + of(x1)) * (t1 - t0)).sum::<f64>()
        };
        let time = t[t.len() - 1] - head.0;
        let mean = integral(&|x| x) / time;
        let rms = (integral(&|x| (x - mean) * (x - mean)) / time).sqrt();
        Some(Statistics { mean, rms, min: all.min.min(at_begin), max: all.max.max(at_begin), ..all })
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
    fn over_a_whole_period_between_samples_the_statistics_of_a_sine_are_exact() {
        // 7.3 samples a period: the measured time begins between two of them, two periods before the end.
        let t: Vec<f64> = (0..=146).map(|i| f64::from(i) / 7.3).collect();
        let x: Vec<f64> = t.iter().map(|t| 3.0 + 2.0 * (std::f64::consts::TAU * t + 0.4).sin()).collect();
        for (begin, allowed) in [(18.0, 3e-2), (10.0, 6e-3)] {
            let s = Statistics::between(&t, &x, begin).unwrap();
            assert!((s.mean - 3.0).abs() < allowed && (s.rms - 2.0_f64.sqrt()).abs() < allowed, "{s:?}");
        }
        assert!(Statistics::between(&t, &x, 20.0).is_none());
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
