//! Statistics of a recorded quantity. Its range is over samples and both sides of events. Mean and root mean square are integrals over the
//! time, by the trapezoidal rule between all rows: a force that steps has no error from the steps, whatever the sampling rate. Percentiles
//! are over the samples, which are evenly spaced.

use crate::trajectory::{Moment, value_at};

/// Statistics of one column [unit of the column].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
    /// The mean over the time.
    pub mean: f64,
    /// The root mean square about the mean, over the time.
    pub rms: f64,
    /// The value that 1 % of the samples do not exceed.
    pub p01: f64,
    /// The value that 99 % of the samples do not exceed.
    pub p99: f64,
}

impl Statistics {
    /// Their names, in the order of [`Statistics::values`].
    pub const NAMES: [&str; 6] = ["min", "max", "mean", "rms", "p01", "p99"];

    /// The statistics of a column `x` at the times `t` \[s\] with the kinds of its rows; `None` if there is no sample.
    pub fn of(t: &[f64], x: &[f64], moments: &[Moment]) -> Option<Statistics> {
        Statistics::after(None, t, x, moments)
    }

    /// The same from the time `begin` \[s\] on, which need not be that of a row. For a periodic column over whole periods, mean and root
    /// mean square are exact if the samples resolve it. `None` if fewer than two rows are later.
    pub fn between(t: &[f64], x: &[f64], moments: &[Moment], begin: f64) -> Option<Statistics> {
        let first = t.partition_point(|&t| t <= begin);
        if first + 1 >= t.len() {
            return None;
        }
        // At an event the measured time begins on its later side.
        let at_event = first > 0 && t[first - 1] == begin;
        let at_begin = if at_event { x[first - 1] } else { value_at(t, x, begin) };
        Statistics::after(Some((begin.min(t[first]), at_begin)), &t[first..], &x[first..], &moments[first..])
    }

    /// The statistics of rows, and of the point `head` (t, x) before them. The percentiles are those of the rows alone.
    fn after(head: Option<(f64, f64)>, t: &[f64], x: &[f64], moments: &[Moment]) -> Option<Statistics> {
        let rows = x.iter().zip(moments);
        let mut samples: Vec<f64> = rows.filter(|(_, m)| **m == Moment::Sample).map(|(x, _)| *x).collect();
        if samples.is_empty() {
            return None;
        }
        let points = head.into_iter().chain(t.iter().copied().zip(x.iter().copied()));
        let (mean, rms) = over_time(points.clone());
        let mut percentile = |share| percentile(&mut samples, share);
        let (p01, p99) = (percentile(0.01), percentile(0.99));
        let min = points.clone().fold(f64::INFINITY, |min, (_, x)| min.min(x));
        let max = points.fold(f64::NEG_INFINITY, |max, (_, x)| max.max(x));
        Some(Statistics { min, max, mean, rms, p01, p99 })
    }

    /// All values.
    pub fn values(&self) -> [f64; 6] {
        [self.min, self.max, self.mean, self.rms, self.p01, self.p99]
    }
}

/// The mean of points (t, x) over the time, and the root mean square about it. Points at one time have their plain mean.
fn over_time(points: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64) {
    let mean_of = |of: &dyn Fn(f64) -> f64| {
        let pairs = points.clone().zip(points.clone().skip(1));
        let (integral, time) = pairs.fold((0.0, 0.0), |(integral, time), ((t0, x0), (t1, x1))| {
            (integral + 0.5 * (of(x0) + of(x1)) * (t1 - t0), time + (t1 - t0))
        });
        if time > 0.0 {
            return integral / time;
        }
        let (sum, count) = points.clone().fold((0.0, 0.0), |(sum, count), (_, x)| (sum + of(x), count + 1.0));
        sum / count
    };
    let mean = mean_of(&|x| x);
    (mean, mean_of(&|x| (x - mean) * (x - mean)).sqrt())
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
        let t: Vec<f64> = (0..=n).map(f64::from).collect();
        let x: Vec<f64> = t.iter().map(|t| 3.0 + 2.0 * (std::f64::consts::TAU * t / f64::from(n)).sin()).collect();
        let s = Statistics::of(&t, &x, &vec![Moment::Sample; x.len()]).unwrap();
        // The tolerance allows for the rounding of a sum of 1000 terms.
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(s.min, 1.0) && near(s.max, 5.0) && near(s.mean, 3.0) && near(s.rms, 2.0_f64.sqrt()));
    }

    /// A force that steps between 1 for a quarter of the time and 5, with events at the steps: ten samples, at any phase, or a last sample
    /// closer than the others.
    #[test]
    fn a_step_between_samples_has_its_share_of_the_time() {
        for (offset, end) in [(0.0, 10.0), (0.3, 10.0), (0.0, 9.1)] {
            let steps = [2.0 + offset, 4.5 + offset];
            let value = |t: f64| if (steps[0]..steps[1]).contains(&t) { 1.0 } else { 5.0 };
            let mut rows: Vec<(f64, f64, Moment)> = vec![];
            let samples = (0..=9).map(f64::from).filter(|t| *t < end).chain([end]);
            samples.for_each(|t| rows.push((t, value(t), Moment::Sample)));
            for (t, [before, after]) in steps.iter().zip([[5.0, 1.0], [1.0, 5.0]]) {
                rows.extend([(*t, before, Moment::Before), (*t, after, Moment::After)]);
            }
            let kind = |m: &Moment| [Moment::Before, Moment::Sample, Moment::After].iter().position(|k| k == m);
            rows.sort_by(|a, b| a.0.total_cmp(&b.0).then(kind(&a.2).cmp(&kind(&b.2))));
            let [t, x] = [0, 1].map(|i| rows.iter().map(|row| [row.0, row.1][i]).collect::<Vec<f64>>());
            let moments: Vec<_> = rows.iter().map(|row| row.2).collect();
            let s = Statistics::of(&t, &x, &moments).unwrap();
            let share = 2.5 / end;
            let (mean, rms) = (5.0 - 4.0 * share, 4.0 * (share * (1.0 - share)).sqrt());
            assert!((s.mean - mean).abs() <= 1e-14 && (s.rms - rms).abs() <= 1e-14, "{offset}, {end}: {s:?}");
            let last = Statistics::between(&t, &x, &moments, steps[1]).unwrap();
            assert_eq!((last.mean, last.rms), (5.0, 0.0), "the later side of the step");
        }
    }

    #[test]
    fn over_a_whole_period_between_samples_the_statistics_of_a_sine_are_exact() {
        // 7.3 samples a period: the measured time begins between two of them, two periods before the end.
        let t: Vec<f64> = (0..=146).map(|i| f64::from(i) / 7.3).collect();
        let x: Vec<f64> = t.iter().map(|t| 3.0 + 2.0 * (std::f64::consts::TAU * t + 0.4).sin()).collect();
        for (begin, allowed) in [(18.0, 3e-2), (10.0, 6e-3)] {
            let s = Statistics::between(&t, &x, &vec![Moment::Sample; t.len()], begin).unwrap();
            assert!((s.mean - 3.0).abs() < allowed && (s.rms - 2.0_f64.sqrt()).abs() < allowed, "{s:?}");
        }
        assert!(Statistics::between(&t, &x, &vec![Moment::Sample; t.len()], 20.0).is_none());
    }

    #[test]
    fn percentiles_are_interpolated_and_take_samples_only() {
        let x: Vec<f64> = (0..=100).rev().map(f64::from).chain([1000.0]).collect();
        let mut moments = vec![Moment::Sample; 101];
        moments.push(Moment::After);
        let t: Vec<f64> = (0..x.len()).map(|i| i as f64).collect();
        let s = Statistics::of(&t, &x, &moments).unwrap();
        assert_eq!((s.p01, s.p99, s.max), (1.0, 99.0, 1000.0));
        let halves = Statistics::of(&[0.0, 1.0], &[0.0, 1.0], &[Moment::Sample; 2]).unwrap();
        assert!((halves.p01 - 0.01).abs() < 1e-15 && (halves.p99 - 0.99).abs() < 1e-15);
        assert!(Statistics::of(&[0.0], &[1.0], &[Moment::Before]).is_none());
    }
}
