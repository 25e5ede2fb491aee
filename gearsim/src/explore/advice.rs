//! Which effects matter to the scene of the page.

use serde::Serialize;

use super::Explorer;
use super::choice::Choice;
use crate::analysis::advise::{Apart, LIMITS};
use crate::library::advise::{Estimate, Verdict};
use crate::library::interrupt::interruptible;

/// The advice as a table.
#[derive(Serialize)]
pub(super) struct Advised {
    /// Names of the deviations.
    names: [&'static str; 6],
    /// Deviations up to which an effect may be left out.
    limits: [String; 6],
    rows: Vec<Row>,
    /// Why there is no advice.
    why_not: Option<String>,
}

/// One candidate.
#[derive(Serialize)]
struct Row {
    /// The effect whose check box it belongs to.
    effect: String,
    /// What is left out.
    without: String,
    /// Whether the effect, or the terms, may be left out: by the estimate, and by full runs.
    estimate: Option<bool>,
    truth: Option<bool>,
    /// The deviations by the full runs, or by the estimate.
    deviations: Option<[String; 6]>,
    /// A further remark.
    note: String,
    /// Change of the processor time without the effect: -30 %.
    time: String,
}

impl Explorer {
    /// Advice on the scene with a choice; `None` if `go_on` ended it, or if the choice has mistakes.
    pub(super) fn advise(&self, choice: &Choice, go_on: &dyn Fn() -> bool) -> Option<Advised> {
        let scene = self.read(&self.edited(choice).to_string()).ok()?;
        let advice = interruptible(go_on, |watch| scene.advise_watched(watch))?;
        let (rows, why_not) = match advice {
            Ok(advice) => (advice.verdicts.iter().map(row).collect(), advice.wrong()),
            Err(error) => (vec![], Some(error.to_string())),
        };
        Some(Advised { names: Apart::NAMES, limits: LIMITS.in_words(), rows, why_not })
    }
}

fn row(verdict: &Verdict) -> Row {
    let (estimate, truth) = verdict.negligible();
    let note = match (&verdict.truth, &verdict.estimate) {
        (Err(why), _) => format!("cannot be run: {why}"),
        (_, Estimate::TurnedBack) => "steps reflect the motion".into(),
        (_, Estimate::None(why)) => format!("no estimate: {why}"),
        _ => String::new(),
    };
    let candidate = &verdict.candidate;
    // "add `rigid_kinematics`", "leave out `damping`, `torques`": the first name in it is that of the check box.
    let effect = candidate.how.split('`').nth(1).unwrap_or_default().to_owned();
    Row {
        effect,
        without: candidate.without.clone(),
        estimate,
        truth,
        deviations: verdict.truth.as_ref().ok().or(verdict.estimate.deviation()).map(Apart::in_words),
        note,
        time: verdict.time_in_words(),
    }
}
