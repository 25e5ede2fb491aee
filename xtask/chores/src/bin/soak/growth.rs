//! How an error grows with the number of events: as a random walk, with its square root, or as a bias, in proportion to it.
//!
//! Let e(n) be the error after n events, and S(m) the root mean square of e(n + m) - e(n) over all n. Then S ~ m^h with h = 1/2
//! for independent rounding errors, h = 1 for a bias, and h = 0 if the rounding of the recorded energies dominates. The value
//! of a random walk at its end says little; S uses all parts of the walk.

use serde_json::{Value, json};

use crate::walk::Walk;

/// The largest lag is this fraction of the number of samples, so that each mean has enough of them.
const PARTS: usize = 16;
/// Limit of the error, relative to the energy at the start.
pub const LIMIT: f64 = 1e-12;
/// Limit of the error at the end, in standard deviations: one in two million walks without bias exceeds it.
pub const DEVIATIONS: f64 = 5.0;

/// Statistics of the growth of an error.
pub struct Growth {
    /// Largest absolute value of the error.
    pub largest: f64,
    /// Exponent h of S(m) ~ m^h.
    pub exponent: f64,
    /// Standard deviation of the change per event, if the changes are independent.
    pub step: f64,
    /// Mean change per event.
    pub bias: f64,
    /// The error at the end over its standard deviation `step` sqrt(n) for independent changes.
    pub deviations: f64,
}

impl Growth {
    /// The statistics of a walk.
    pub fn of(walk: &Walk) -> Growth {
        let end = *walk.events.last().unwrap_or(&0) as f64;
        let last = *walk.error.last().unwrap_or(&0.0);
        let largest = walk.error.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        // The first eighth has denser samples than the rest; it would count too often.
        let even = walk.events.partition_point(|n| (*n as f64) < end / 8.0);
        let (events, error) = (&walk.events[even..], &walk.error[even..]);
        let (mut points, mut step) = (vec![], f64::NAN);
        let mut lag = 1;
        while lag * PARTS <= error.len() {
            let pairs = || (lag..error.len()).map(|i| (i - lag, i));
            let mean = |f: &dyn Fn((usize, usize)) -> f64| pairs().map(f).sum::<f64>() / pairs().count() as f64;
            let change = mean(&|(a, b)| error[b] - error[a]);
            let square = mean(&|(a, b)| (error[b] - error[a]).powi(2));
            let n = mean(&|(a, b)| (events[b] - events[a]) as f64);
            if lag == 1 {
                step = ((square - change * change).max(0.0) / n).sqrt();
            }
            points.push((n, square.sqrt()));
            lag *= 2;
        }
        let deviations = last.abs() / (step * end.sqrt());
        Growth { largest, exponent: slope(&points), step, bias: last / end, deviations }
    }

    /// What is wrong, one sentence each; empty if nothing is.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = vec![];
        // The comparison is written so that NaN is a fault too.
        if !matches!(self.largest.partial_cmp(&LIMIT), Some(std::cmp::Ordering::Less)) {
            faults.push(format!("the error reaches {:.1e}, not below {LIMIT:e}", self.largest));
        }
        if !matches!(self.deviations.partial_cmp(&DEVIATIONS), Some(std::cmp::Ordering::Less)) {
            faults.push(format!(
                "it grows faster than independent rounding errors: {:.1} standard deviations from zero, S ~ events^{:.2}",
                self.deviations, self.exponent
            ));
        }
        faults
    }

    /// The statistics as JSON.
    pub fn json(&self) -> Value {
        json!({
            "largest": self.largest,
            "exponent": self.exponent,
            "standard_deviation_per_event": self.step,
            "bias_per_event": self.bias,
            "deviations_from_no_bias": self.deviations,
        })
    }
}

/// Slope of log y over log x, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs = || points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let (mx, my) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (top, bottom) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + (x - mx) * (y - my), b + (x - mx).powi(2)));
    top / bottom
}
