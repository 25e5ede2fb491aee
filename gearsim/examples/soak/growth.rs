//! How an error grows: by chance, as the square root of the number of events, or all in one direction.
//!
//! The error e(n) of n events is a walk. Over m events it changes by S(m), the root mean square of e(n + m) - e(n), so
//! that S ~ m^h with h = 1/2 for independent rounding errors and h = 1 for a bias; h = 0 where only the rounding of the
//! energies themselves shows. One path's end says little of a walk; all its stretches do.

use serde_json::{Value, json};

use crate::walk::Walk;

/// Stretches of a lag that a mean is taken over, at least.
const STRETCHES: usize = 16;
/// What the error may come to, over the energy at the start.
pub const LIMIT: f64 = 1e-12;
/// Of a walk without bias, one in two million ends farther out than this many deviations.
pub const DEVIATIONS: f64 = 5.0;

/// What the growth of an error looks like.
pub struct Growth {
    /// Largest error.
    pub largest: f64,
    /// Exponent h of S(m) ~ m^h.
    pub exponent: f64,
    /// Standard deviation of the change an event, were all independent.
    pub step: f64,
    /// Mean change an event: what a bias would be.
    pub bias: f64,
    /// The error at the end in units of what independent steps give, `step` sqrt(n).
    pub deviations: f64,
}

impl Growth {
    /// Of a walk, whose samples are evenly spaced but for the beginning.
    pub fn of(walk: &Walk) -> Growth {
        let end = *walk.events.last().unwrap_or(&0) as f64;
        let last = *walk.error.last().unwrap_or(&0.0);
        let largest = walk.error.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        // The dense beginning would count more often than the rest.
        let even = walk.events.partition_point(|n| (*n as f64) < end / 8.0);
        let (events, error) = (&walk.events[even..], &walk.error[even..]);
        let (mut points, mut step) = (vec![], f64::NAN);
        let mut lag = 1;
        while lag * STRETCHES <= error.len() {
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

    /// What is wrong with it; empty if nothing is.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = vec![];
        // Not below the limit or not, rather than above it: NaN is a fault.
        if !matches!(self.largest.partial_cmp(&LIMIT), Some(std::cmp::Ordering::Less)) {
            faults.push(format!("the error reaches {:.1e}, not below {LIMIT:e}", self.largest));
        }
        if !matches!(self.deviations.partial_cmp(&DEVIATIONS), Some(std::cmp::Ordering::Less)) {
            faults.push(format!(
                "it grows faster than rounding explains: {:.1} standard deviations from no bias, S ~ events^{:.2}",
                self.deviations, self.exponent
            ));
        }
        faults
    }

    /// As JSON.
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

/// Slope of log y over log x by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs = || points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let (mx, my) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (top, bottom) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + (x - mx) * (y - my), b + (x - mx).powi(2)));
    top / bottom
}
