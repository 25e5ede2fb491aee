//! Compares the engine's result for a cell with that of the reference.
//!
//! The rounding error of the phase at t is taken as eps times the sum over the modes of |c| a (1 + omega min(t, 1/sigma)). c is the weight
//! of the mode, a bounds its distance, and the last factor is the effect of a rounding error of its frequency until the mode has
//! died away.

use gearsim::__private::Vector;
use gearsim_tests::precise;
use gearsim_tests::precise::cell::{Law, Motion};
use gearsim_tests::precise::crossing::first_crossing_with;
use gearsim_tests::precise::number::{Real, Scalar};

use super::draw::Drawn;
use super::phase::bound;
use crate::linear::first;

/// Allowed difference between the engine and the reference, in units of the rounding error and touch tolerance.
pub const MULTIPLE: f64 = 4.0;

/// The result for a cell.
pub enum Verdict {
    /// Both found the same crossing; the engine has this error, in its unit.
    Crossed(f64),
    /// Both found no crossing.
    Passed,
    /// Only one of them found a crossing, but its depth is below the rounding error.
    Shallow,
    /// One of them missed a crossing that the other found.
    Wrong(String),
}

type Digits = Real<192>;

/// A cell for the reference, with exactly the engine's modes.
struct Reference {
    modes: Vec<precise::Mode>,
    level: f64,
    /// Depth up to which the engine counts a touch as a graze.
    tolerance: f64,
}

impl Reference {
    /// The phase minus the level, and its first two derivatives, at `t`, computed in multiple precision and then rounded.
    fn at(&self, t: f64) -> [f64; 3] {
        let mut sum = [-Digits::exact(self.level), Digits::exact(0.0), Digits::exact(0.0)];
        for m in &self.modes {
            let law = Law::new(Digits::exact(m.sigma), Digits::exact(m.omega2));
            let [force, x, v, c] = [m.force, m.x, m.v, m.weight].map(Digits::exact);
            let motion = Motion::new(law, force, x, v, c.clone());
            for (sum, x) in sum.iter_mut().zip(motion.at(&Digits::exact(t))) {
                *sum = sum.clone() + c.clone() * x;
            }
        }
        sum.map(|x| x.approx())
    }

    /// The rounding error of the phase at `t` plus the tolerance of a touch.
    fn rounding(&self, t: f64) -> f64 {
        let each = |m: &precise::Mode| {
            let turns = m.omega2.sqrt() * t.min(1.0 / m.sigma);
            m.weight.abs() * bound(m, t) * (1.0 + turns)
        };
        self.tolerance + f64::EPSILON * self.modes.iter().map(each).sum::<f64>()
    }

    /// Distance that the phase moves beyond the level after a crossing at `t` before it turns back. An estimate that is right only where
    /// it turns soon.
    fn depth(&self, t: f64) -> f64 {
        let [_, rate, bend] = self.at(t);
        0.5 * rate * rate / bend.abs()
    }
}

/// Runs the engine and the reference.
pub fn judge<const N: usize>(drawn: &Drawn<N>) -> Verdict {
    let Drawn { system, v, level, far, horizon, upper, .. } = drawn;
    let cell = system.cell();
    let flight = cell.flight(&Vector::zeros(N), &Vector::from(*v));
    let participation = cell.participation(&Vector::from(system.normal));
    let gaps = if *upper { [*far, *level] } else { [*level, *far] };
    let met = match first(&flight, &participation, gaps, *horizon) {
        Ok(met) => met,
        Err(lost) => return Verdict::Wrong(lost.to_string()),
    };
    let modes = (0..N).map(|i| {
        // Each mode shape is one coordinate, with either sign.
        let j = cell.shapes.column(i).iamax();
        let sign = cell.shapes[(j, i)];
        let weight = if *upper { participation[i] } else { -participation[i] };
        let (sigma, omega2) = (cell.modes[i].sigma, cell.modes[i].omega2);
        precise::Mode { sigma, omega2, force: sign * system.load[j], x: 0.0, v: sign * v[j], weight }
    });
    let tolerance = 4.0 * f64::EPSILON * (level + far);
    let reference = Reference { modes: modes.collect(), level: *level, tolerance };
    let root = first_crossing_with::<192>(&reference.modes, *level, *horizon).root;
    let root = root.map(|root| (root.t.pair(), root.tangency));
    compare(&reference, met.side.map(|_| met.t), root)
}

fn compare(reference: &Reference, met: Option<f64>, root: Option<((f64, f64), bool)>) -> Verdict {
    let is_false = |t: f64| reference.at(t)[0].abs() > MULTIPLE * reference.rounding(t);
    match (met, root) {
        (None, None) => Verdict::Passed,
        (Some(t), None) if is_false(t) => Verdict::Wrong(format!("a false crossing at {t:e}")),
        (Some(_), None) => Verdict::Shallow,
        (None, Some(((t, _), tangency))) => missed(reference, t, tangency, None),
        (Some(met), Some(((t, rest), tangency))) => {
            let late = (met - t) - rest;
            let unit = reference.rounding(t) / reference.at(t)[1].abs() + f64::EPSILON * t;
            match late.abs() / unit {
                error if error <= MULTIPLE => Verdict::Crossed(error),
                _ if late > 0.0 => missed(reference, t, tangency, Some(met)),
                _ if is_false(met) => Verdict::Wrong(format!("a false crossing at {met:e}, before {t:e}")),
                // An earlier crest reaches the level within the rounding error.
                _ => Verdict::Shallow,
            }
        }
    }
}

fn missed(reference: &Reference, t: f64, tangency: bool, met: Option<f64>) -> Verdict {
    let (depth, rounding) = (reference.depth(t), reference.rounding(t));
    match tangency || depth <= MULTIPLE * rounding {
        true => Verdict::Shallow,
        false => Verdict::Wrong(format!(
            "missed at {t:e}, with a depth of {:.1e} rounding errors (found: {met:?})",
            depth / rounding
        )),
    }
}
