//! The answer to a choice: the controls, and either the run with its plots or the mistakes.

use std::sync::Arc;
use std::time::Duration;

use serde::Serialize;

use super::choice::Choice;
use super::controls::{self, Control, EffectBox, SolverFields};
use super::text::key_at;
use super::{Explorer, SOURCE};
use crate::library::interrupt::interruptible;
use crate::library::{Error, Results};
use crate::output::number::{short, time};
use crate::page;
use crate::run::Stop;
use crate::scene::text::Text;
use crate::scene::{Scene, SceneMistakes};

/// A run that takes longer than this is stopped, and its beginning is shown. Drawing takes some 30 ms more.
const BEGINNING: Duration = Duration::from_millis(55);

/// Most rows of a run. A page that redraws them takes some 10 ms for each 100,000.
const MOST_ROWS: u64 = 300_000;

/// The answer.
#[derive(Serialize)]
pub(super) struct Answer {
    controls: Vec<Control>,
    effects: Vec<EffectBox>,
    solver: SolverFields,
    /// Mistakes; if there are any, there is no run.
    mistakes: Vec<Wrong>,
    run: Option<Box<Shown>>,
    /// Instead of a run that takes longer: its beginning.
    beginning: Option<Beginning>,
}

/// The beginning of a run, with the visible sections that have plots over time.
#[derive(Serialize)]
struct Beginning {
    /// Time to be simulated, and time simulated so far \[s\].
    length: f64,
    reached: f64,
    page: page::Parts,
}

/// What an answer shows of a run.
enum AnswerPart {
    Whole(Box<Shown>),
    Beginning(Beginning),
}

/// A mistake.
#[derive(Debug, Serialize)]
pub(super) struct Wrong {
    /// Key of the value that is wrong; empty if the mistake does not belong to a single value.
    key: String,
    message: String,
    help: String,
}

/// A run.
#[derive(Serialize)]
struct Shown {
    title: String,
    subtitle: String,
    method: String,
    why: String,
    /// Processor time, in words.
    time: String,
    /// Processor time [s].
    seconds: f64,
    /// Energy unaccounted for at the end, in words, and its share of the largest part of the account.
    unaccounted: String,
    share: String,
    /// Remarks on the run.
    remarks: Vec<String>,
    /// Time simulated [s].
    length: f64,
    /// Name, unit, value at the end [SI] and the same in words.
    state: Vec<(String, String, f64, String)>,
    page: page::Parts,
}

/// The second answer to a choice: what is not visible, and what takes time to compute.
#[derive(Serialize)]
pub(super) struct Rest {
    /// The sections of the page that the first answer did not contain, or not completely.
    #[serde(flatten)]
    page: page::Parts,
    /// A description of the static equilibria other than the one at which the run starts.
    others: Option<String>,
}

impl Explorer {
    /// Runs the scene with a choice; `None` if `go_on` ended it.
    pub(super) fn run(&self, choice: &Choice, go_on: &dyn Fn() -> bool) -> Option<Answer> {
        let edited = self.edited(choice);
        let text = edited.to_string();
        // Plots over frequencies and tables of a beginning would not be those of the run.
        let grows = choice.seen.iter().any(|id| page::run::OVER_TIME.contains(&&**id));
        let most_time = (grows && !choice.whole).then_some(BEGINNING);
        let (mistakes, part) = match self.read(&text) {
            Err(mistakes) => (wrong(&mistakes, &text), None),
            Ok(scene) => {
                match self.ran(&text, scene, most_time, go_on)?.and_then(|results| part(&results, choice, go_on)) {
                    Ok(None) => return None,
                    Ok(part) => (vec![], part),
                    Err(error) => (vec![Wrong::general(&error)], None),
                }
            }
        };
        Some(self.answer(&edited, mistakes, part))
    }

    /// The part of the run with a choice that the first answer did not contain. `None` if `go_on` ended it, or if there is no such run.
    pub(super) fn rest(&self, choice: &Choice, go_on: &dyn Fn() -> bool) -> Option<Rest> {
        let text = self.edited(choice).to_string();
        let results = self.ran(&text, self.read(&text).ok()?, None, go_on)?.ok()?;
        let is_wanted = |id: &str| choice.view.is_some() || !choice.seen.iter().any(|seen| seen == id);
        let page = parts(&results, format!("rest{}-", choice.number), &is_wanted, None, go_on).ok()??;
        Some(Rest { page, others: results.scene.other_equilibria() })
    }

    /// The answer without a run: it took longer than the page waits.
    pub(super) fn too_long(&self, choice: &Choice, limit: u64) -> Answer {
        let wrong = Wrong {
            key: String::new(),
            message: format!("the run was ended after {limit} s"),
            help: "shorten it (run.t_end), or save the scene and run it with `gearsim run`, which has no limit".into(),
        };
        self.answer(&self.edited(choice), vec![wrong], None)
    }

    /// The answer with the controls of a text.
    fn answer(&self, text: &Text, mistakes: Vec<Wrong>, part: Option<AnswerPart>) -> Answer {
        let (run, beginning) = match part {
            Some(AnswerPart::Whole(run)) => (Some(run), None),
            Some(AnswerPart::Beginning(beginning)) => (None, Some(beginning)),
            None => (None, None),
        };
        Answer {
            controls: controls::controls(&self.scene, text, &self.first),
            effects: controls::effects(&self.scene, text),
            solver: controls::solver(text),
            mistakes,
            run,
            beginning,
        }
    }

    /// The text of the scene with a choice, as saved. Errors: its mistakes.
    pub(super) fn saved(&self, choice: &Choice) -> Result<String, Vec<Wrong>> {
        let text = self.edited(choice).to_string();
        match self.read(&text) {
            Ok(_) => Ok(text),
            Err(mistakes) => Err(wrong(&mistakes, &text)),
        }
    }

    /// Runs `scene`; `text` is the text of this scene. If the last run had the same text, its result is returned. A new run is stopped when
    /// it has taken `most_time`.
    pub(super) fn ran(
        &self,
        text: &str,
        scene: Scene,
        most_time: Option<Duration>,
        go_on: &dyn Fn() -> bool,
    ) -> Option<Result<Arc<Results>, Error>> {
        let last = || self.last.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some((_, results)) = last().as_ref().filter(|(known, _)| known == text) {
            return Some(Ok(results.clone()));
        }
        let mut bounded = scene;
        bounded.output.most_rows = bounded.output.most_rows.min(MOST_ROWS);
        bounded.output.most_time = most_time;
        let run = interruptible(go_on, |watch| bounded.run_alone(&mut |t| watch(t)))?;
        Some(run.map(|results| {
            let results = Arc::new(results);
            if !is_beginning(&results) {
                *last() = Some((text.to_owned(), results.clone()));
            }
            results
        }))
    }
}

impl Wrong {
    /// An error that belongs to no single value.
    fn general(error: &Error) -> Wrong {
        let (message, help) = match error {
            Error::Impossible { what, help } => (what.clone(), help.clone()),
            Error::Refused { refusal, .. } => (refusal.to_string(), String::new()),
            other => (other.to_string(), String::new()),
        };
        Wrong { key: String::new(), message, help }
    }
}

/// The mistakes of a text, each with the key of the value that is wrong.
fn wrong(mistakes: &SceneMistakes, text: &str) -> Vec<Wrong> {
    let of = |mistake: &crate::scene::Mistake| {
        let key = mistake.offset_in(text).and_then(|offset| key_at(text, offset)).unwrap_or_default();
        Wrong { key, message: mistake.message().replace(SOURCE, "the scene"), help: mistake.help().into() }
    };
    mistakes.mistakes().iter().map(of).collect()
}

/// Whether a run was stopped because it reached `most_time`.
fn is_beginning(results: &Results) -> bool {
    matches!(results.outcome.stopped_by, Some(Stop::Time { .. }))
}

/// The first part of a run's page, of a whole run or of its beginning. `None` if `go_on` cancelled the run.
fn part(results: &Results, choice: &Choice, go_on: &dyn Fn() -> bool) -> Result<Option<AnswerPart>, Error> {
    if !is_beginning(results) {
        return Ok(shown(results, choice, go_on)?.map(|shown| AnswerPart::Whole(Box::new(shown))));
    }
    let seen = |id: &str| choice.seen.iter().any(|seen| seen == id);
    let is_wanted = |id: &str| page::run::OVER_TIME.contains(&id) && seen(id);
    let name = format!("beginning{}-", choice.number);
    let page = parts(results, name, &is_wanted, choice.view.as_ref(), go_on)?;
    let reached = results.trajectory().t.last().copied().unwrap_or(0.0);
    Ok(page.map(|page| AnswerPart::Beginning(Beginning { length: results.scene.t_end, reached, page })))
}

/// The visible sections (`seen`), or all sections if `seen` is empty, with what is in `view`. `None` if `go_on` cancelled the run.
fn shown(results: &Results, choice: &Choice, go_on: &dyn Fn() -> bool) -> Result<Option<Shown>, Error> {
    let seen = &choice.seen;
    let is_wanted = |id: &str| seen.is_empty() || seen.iter().any(|seen| seen == id);
    let name = format!("run{}-", choice.number);
    let Some(page) = parts(results, name, &is_wanted, choice.view.as_ref(), go_on)? else { return Ok(None) };
    let Results { scene, outcome } = results;
    let summary = results.brief();
    let (residual, largest) = (summary.energy.residual.0, summary.energy.largest.0);
    let stopped = summary.stopped_by.iter().map(|why| format!("The run stopped early: {why}"));
    let refuted = summary.refuted.iter().map(|why| format!("The result is wrong: {why}"));
    let units = scene.model.coordinates.iter().flat_map(|c| [c.unit.to_owned(), format!("{}/s", c.unit)]);
    let state = summary.state.0.iter().zip(units);
    Ok(Some(Shown {
        title: scene.name.clone(),
        subtitle: if scene.about.is_empty() { scene.model.title.into() } else { scene.about.clone() },
        method: summary.method.name.clone(),
        why: summary.method.why.clone(),
        time: time(outcome.cpu_seconds),
        seconds: outcome.cpu_seconds,
        unaccounted: format!("{} J", short(residual)),
        share: if largest > 0.0 { short((residual / largest).abs()) } else { String::new() },
        remarks: stopped.chain(refuted).chain(summary.remarks.iter().cloned()).collect(),
        length: scene.t_end,
        state: state.map(|((name, x), unit)| (name.clone(), unit, x.0, short(x.0))).collect(),
        page,
    }))
}

/// The wanted sections of the page of a run; `name` begins the identifiers of their arrays.
fn parts(
    results: &Results,
    name: String,
    is_wanted: &dyn Fn(&str) -> bool,
    view: Option<&page::run::View>,
    go_on: &dyn Fn() -> bool,
) -> Result<Option<page::Parts>, Error> {
    let Results { scene, outcome } = results;
    let summary = results.brief();
    let run = page::run::Run { scene, outcome, summary: &summary };
    Ok(page::run::live(&run, name, is_wanted, view, go_on)?)
}
