//! Cost and error of a choice: its time relative to exact cells, its error at the end, the digits left.

use serde::Serialize;

use super::Explorer;
use super::choice::Choice;
use crate::analysis::digits;
use crate::analysis::work_precision::error;
use crate::analysis::work_precision::reference::{self, By, Reference};
use crate::engine::Refusal;
use crate::library::advise::timed;
use crate::library::interrupt::interruptible;
use crate::library::{Error, Results};
use crate::output::number::{short, time};
use crate::run::Outcome;
use crate::scene::solver::{Method, Solver};
use crate::scene::{Precision, Scene};
use crate::trajectory::Moment;

/// The judgement, in words.
#[derive(Serialize)]
pub(super) struct Judgement {
    /// Processor time. For short runs it is the smallest of three.
    time: String,
    /// This time over the time of exact cells.
    ratio: String,
    /// Largest error of a coordinate or speed at the end, in units of its size.
    error: String,
    /// The reference of the error, and its accuracy.
    against: String,
    /// Digits left.
    digits: String,
    /// Time \[s\] from which on no digit is left.
    none_from: Option<f64>,
}

impl Explorer {
    /// Judges a choice; `None` if `go_on` ended it, or if there is nothing to judge because of a mistake.
    pub(super) fn judge(&self, choice: &Choice, go_on: &dyn Fn() -> bool) -> Option<Judgement> {
        let text = self.edited(choice).to_string();
        let scene = self.read(&text).ok()?;
        let results = self.ran(&text, scene, None, go_on)?.ok()?;
        interruptible(go_on, |watch| of(&results, watch))?.ok()
    }
}

fn of(results: &Results, watch: &dyn Fn(f64)) -> Result<Judgement, Error> {
    let Results { scene, outcome } = results;
    let entry = scene.entry()?;
    let run = |scene: &Scene| entry.run(scene, &mut |t| watch(t));
    let (_, seconds) = timed(scene, watch)?;
    let digits = digits::noted(scene, outcome.clone(), &run).digits;
    let (error, against) = match reference::of(scene, &run) {
        Ok(reference) => (difference(outcome, &reference), against(&reference)),
        Err(why) => ("-".into(), format!("there is no reference: {why}")),
    };
    Ok(Judgement {
        time: time(seconds),
        ratio: ratio(scene, outcome, seconds, watch)?,
        error,
        against,
        digits: match digits {
            Some(digits) => format!("{:.0}", digits.at_end.floor()),
            None => "-".into(),
        },
        none_from: digits.and_then(|digits| digits.none_from),
    })
}

/// The time of a run over that of exact cells, in words.
fn ratio(scene: &Scene, outcome: &Outcome, seconds: f64, watch: &dyn Fn(f64)) -> Result<String, Error> {
    let plain = scene.solver.precision == Precision::Plain;
    if outcome.solver.method == Method::Exact.name() && plain {
        return Ok("exact cells".into());
    }
    let solver = Solver { method: Some(Method::Exact), ..Solver::default() };
    match timed(&Scene { solver, ..scene.clone() }, watch) {
        Ok((_, exact)) => Ok(format!("{} x exact cells", short(seconds / exact))),
        Err(Error::Refused { refusal: Refusal::Nonlinear { .. }, .. }) => Ok("there are no exact cells".into()),
        Err(Error::Refused { refusal, .. }) => Ok(format!("exact cells cannot run: {refusal}")),
        Err(other) => Err(other),
    }
}

/// The error at the end, in units of the size of each coordinate and speed.
fn difference(outcome: &Outcome, reference: &Reference) -> String {
    let (a, b) = (&outcome.trajectory, &reference.outcome.trajectory);
    let last = |moments: &[Moment]| moments.iter().rposition(|moment| *moment == Moment::Sample);
    match (last(&a.moment), last(&b.moment)) {
        (Some(i), Some(j)) if a.t[i] == b.t[j] => short(error::difference((a, i), (b, j), &error::sizes(b))),
        _ => "-".into(),
    }
}

fn against(reference: &Reference) -> String {
    let what = match &reference.by {
        By::Compensated => "exact cells in twice the digits",
        By::Steps(_) => "dop853 at the tightest tolerance; there are no exact cells",
    };
    format!("against {what}, known to {}", short(reference.error))
}
