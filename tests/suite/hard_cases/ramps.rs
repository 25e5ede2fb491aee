//! Row 14: with ramps of width eps instead of steps, the motion differs from that of the jump rule by O(eps).
//!
//! The reference integrates Eqs. (2), (3) through smooth ramps; the difference of the end states is C eps + O(eps²).

use gearsim_tests::oh2005::{GearPair, Ramp, State};

use crate::case::{Case, largest};
use crate::pair::{self, distance};

pub const CASES: &[Case] = &[
    Case {
        row: "14",
        name: "ramps of 4e-5 to 2.5e-6 rad, transmitted up and down, in both directions",
        proves: "slope of log difference over log eps is 1",
        tolerance: 0.04,
        unit: "of slope",
        reason: "the next order adds a percent at the widest ramp",
        measure: |note| slopes(note, &[(1.0, 60.0), (6.0, 30.0), (0.5, -60.0), (1.9, -20.0)], 0),
    },
    Case {
        row: "14",
        name: "ramps of 4e-5 to 2.5e-6 rad, reflected, then transmitted",
        proves: "slope of log difference over log eps is 1",
        tolerance: 0.04,
        unit: "of slope",
        reason: "the next order adds a percent at the widest ramp",
        measure: |note| slopes(note, &[(1.0, 20.0)], 1),
    },
];

/// The largest deviation of a slope from 1. A start is theta \[rad\] and the speed of the driving gear \[rpm\]. NaN if a run has another
/// number of `reflections`.
fn slopes(note: &mut String, starts: &[(f64, f64)], reflections: u64) -> f64 {
    let pair = GearPair::paper(0.05, 10.0);
    let slopes = starts.iter().map(|&(theta, rpm)| {
        let standard = pair.start(rpm);
        let start = State { theta, phi: pair.t0 / pair.k(pair.locate(theta).0), ..standard };
        let t_end = 1.2 / start.theta_dot.abs();
        let run = pair::run(&pair, &start, t_end);
        if run.outcome.counts.reflections != reflections {
            return f64::NAN;
        }
        let apart = [4e-5, 2.5e-6].map(|eps| {
            let ramp = pair.solve_ramp(Ramp::Smooth, eps, start, t_end, 8.0);
            distance(&ramp, &run.end, &pair, start.theta_dot)
        });
        (apart[0] / apart[1]).log2() / 4.0
    });
    let slopes: Vec<f64> = slopes.collect();
    *note = format!("slopes {slopes:.3?}");
    largest(slopes.iter().map(|slope| (slope - 1.0).abs()))
}
