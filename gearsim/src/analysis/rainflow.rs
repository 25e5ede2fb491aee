//! Load spectra: rainflow counts and the load duration distribution of a recorded column.
//!
//! Rainflow counting by the three-point rule of ASTM E1049-85 (2017), section 5.4.4. The reversals of the column are read one after the
//! other. X is the range of the last two reversals, Y the range before it. While X >= Y, Y is counted as a cycle and its two points are
//! removed. If Y contains the first remaining point, it is counted as half a cycle, and only this point is removed. In the end each
//! remaining range is counted as half a cycle. The reversals are those of all rows, samples and both sides of events, so that a peak at an
//! event is not missed.

use crate::trajectory::Trajectory;

/// A counted range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Range, the maximum minus the minimum [unit of the column].
    pub range: f64,
    /// Mean of the maximum and the minimum [unit of the column].
    pub mean: f64,
    /// 1, or 0.5 for half a cycle.
    pub count: f64,
}

/// The cycles of a column, in the order in which they are counted. Values that are not finite are left out.
pub fn count(column: &[f64]) -> Vec<Cycle> {
    let (mut cycles, mut left): (Vec<Cycle>, Vec<f64>) = (vec![], vec![]);
    let cycle = |a: f64, b: f64, count: f64| Cycle { range: (a - b).abs(), mean: 0.5 * (a + b), count };
    for point in reversals(column) {
        left.push(point);
        while let [.., a, b, c] = left[..] {
            if (c - b).abs() < (b - a).abs() {
                break;
            }
            if left.len() == 3 {
                cycles.push(cycle(a, b, 0.5));
                left.remove(0);
            } else {
                cycles.push(cycle(a, b, 1.0));
                left.drain(left.len() - 3..left.len() - 1);
            }
        }
    }
    cycles.extend(left.windows(2).map(|pair| cycle(pair[0], pair[1], 0.5)));
    cycles
}

/// The first and last value, and the values between at which the column turns.
fn reversals(column: &[f64]) -> Vec<f64> {
    let mut points: Vec<f64> = vec![];
    for &x in column.iter().filter(|x| x.is_finite()) {
        match points[..] {
            [.., last] if x == last => {}
            [.., before, last] if (last - before) * (x - last) > 0.0 => {
                // The column goes on in the same direction.
                let end = points.len() - 1;
                points[end] = x;
            }
            _ => points.push(x),
        }
    }
    points
}

/// The time in which a column lay in a class of loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duration {
    /// Lower limit of the class [unit of the column]; the class includes it.
    pub low: f64,
    /// Upper limit; the last class includes it.
    pub high: f64,
    /// Time \[s\].
    pub time: f64,
}

/// The time of a column in `classes` of equal width between its smallest and largest sample. Samples are evenly spaced, so that each counts
/// for the same time. Empty if there are no finite samples.
pub fn durations(run: &Trajectory, from: f64, column: &[f64], classes: usize) -> Vec<Duration> {
    let begin = run.row_from(from);
    let samples: Vec<f64> =
        run.samples().filter(|row| *row >= begin).map(|row| column[row]).filter(|x| x.is_finite()).collect();
    let (low, high) = samples.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
    let (Some(first), Some(last)) = (run.t.get(begin), run.t.last()) else { return vec![] };
    if samples.is_empty() {
        return vec![];
    }
    let each = (last - first) / samples.len() as f64;
    let classes = if high > low { classes } else { 1 };
    let width = (high - low) / classes as f64;
    let edge = |i: usize| if i == classes { high } else { low + i as f64 * width };
    let mut all: Vec<Duration> =
        (0..classes).map(|i| Duration { low: edge(i), high: edge(i + 1), time: 0.0 }).collect();
    for x in samples {
        let class = if width > 0.0 { ((x - low) / width) as usize } else { 0 };
        all[class.min(classes - 1)].time += each;
    }
    all
}

/// Counted cycles in a class of ranges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Class {
    /// Lower limit [unit of the column]; the class does not include it.
    pub low: f64,
    /// Upper limit; the class includes it.
    pub high: f64,
    /// Cycles.
    pub count: f64,
    /// Mean of the means of its cycles, weighted by their counts; NaN without cycles.
    pub mean: f64,
    /// Cycles with a range above the lower limit.
    pub exceeded: f64,
}

/// `cycles` in `classes` of equal width from 0 to the largest range.
pub fn classes(cycles: &[Cycle], classes: usize) -> Vec<Class> {
    let largest = cycles.iter().map(|cycle| cycle.range).fold(0.0, f64::max);
    if largest == 0.0 {
        return vec![];
    }
    let edge = |i: usize| largest * i as f64 / classes as f64;
    let (mut counts, mut means) = (vec![0.0; classes], vec![0.0; classes]);
    for cycle in cycles.iter().filter(|cycle| cycle.range > 0.0) {
        let class = ((cycle.range / largest * classes as f64).ceil() as usize).clamp(1, classes) - 1;
        counts[class] += cycle.count;
        means[class] += cycle.count * cycle.mean;
    }
    let mut exceeded = 0.0;
    let mut all: Vec<Class> = (0..classes)
        .rev()
        .map(|i| {
            exceeded += counts[i];
            Class { low: edge(i), high: edge(i + 1), count: counts[i], mean: means[i] / counts[i], exceeded }
        })
        .collect();
    all.reverse();
    all
}

/// The range of constant amplitude that does the same damage in the same number of cycles, by the rule of Palmgren and Miner with an S-N
/// curve of the slope `exponent`: (sum n r^m/sum n)^(1/m) [unit of the ranges]. NaN without cycles.
pub fn equivalent(cycles: &[Cycle], exponent: f64) -> f64 {
    let largest = cycles.iter().map(|cycle| cycle.range).fold(0.0, f64::max);
    let damage: f64 = cycles.iter().map(|cycle| cycle.count * (cycle.range / largest).powf(exponent)).sum();
    let count: f64 = cycles.iter().map(|cycle| cycle.count).sum();
    largest * (damage / count).powf(1.0 / exponent)
}

#[cfg(test)]
mod tests;
