//! `[run]` and `[output]`: how long a run takes, and what is kept of it.

use super::document::{Entry, Node};
use super::error::Report;
use super::{Output, PLOTS, Solver, field, keys, measure, solver};

/// Keys of `[output]`.
pub(super) const KEYS: [&str; 4] = ["rate", "events", "plots", "csv"];

/// Samples that a run may record: some gigabytes.
const MAX_SAMPLES: f64 = 1e8;

/// Samples of a run whose scene states no rate.
const DEFAULT_SAMPLES: f64 = 1e4;

/// Earliest end of a run [s]: earlier, its sampling rate would not be finite.
const MIN_END: f64 = 1e-300;

/// Reads the end of the run [s] and how it is solved; what to add goes to `absent` if there is no `[run]`.
pub(super) fn read_run(
    entries: &[Entry],
    absent: &mut Vec<(&str, String)>,
    report: &mut Report,
) -> (Option<f64>, Option<Solver>) {
    let Some(run) = keys::get(entries, "run") else {
        absent.push(("[run]", "[run]\nt_end = \"... s\"".to_string()));
        return (None, None);
    };
    let Some(given) = field::table("run", run, report) else { return (None, None) };
    let allowed: Vec<_> = ["t_end"].into_iter().chain(solver::KEYS).collect();
    keys::known(given, "[run]", &allowed, report);
    (read_end(given, run, report), solver::read(given, run, report))
}

fn read_end(given: &[Entry], run: &Node, report: &mut Report) -> Option<f64> {
    let Some(node) = keys::get(given, "t_end") else {
        let line = "t_end = \"... s\"".to_string();
        keys::missing(&[("t_end", line)], "[run]", &run.place, report);
        return None;
    };
    let t_end = measure::quantity("run.t_end", node, "s", report)?;
    if t_end >= MIN_END {
        return Some(t_end);
    }
    let must = match t_end > 0.0 {
        true => format!("must be at least {MIN_END:e} s"),
        false => "must be positive".to_string(),
    };
    measure::out_of_range("run.t_end", node, &must, "the run starts at 0 s", report);
    None
}

/// Reads `[output]`, all of which may be left out.
pub(super) fn read(entries: &[Entry], t_end: Option<f64>, report: &mut Report) -> Option<Output> {
    let node = keys::get(entries, "output");
    let given = node.map_or(Some(&[][..]), |node| field::table("output", node, report))?;
    keys::known(given, "[output]", &KEYS, report);
    let mut flag = |key: &str, default| match keys::get(given, key) {
        Some(node) => field::flag(&format!("output.{key}"), node, report),
        None => Some(default),
    };
    let (events, csv) = (flag("events", true), flag("csv", false));
    let plots = match keys::get(given, "plots") {
        Some(node) => field::names("output.plots", node, "plot", PLOTS, report),
        None => Some((0..PLOTS.len()).collect()),
    };
    let rate = match keys::get(given, "rate") {
        Some(node) => read_rate(node, t_end, report),
        None => t_end.map(|t_end| DEFAULT_SAMPLES / t_end),
    };
    let plots = plots?.into_iter().map(|i| PLOTS[i].to_string()).collect();
    Some(Output { rate: rate?, events: events?, plots, csv: csv? })
}

fn read_rate(node: &Node, t_end: Option<f64>, report: &mut Report) -> Option<f64> {
    let rate = measure::quantity("output.rate", node, "Hz", report)?;
    if rate <= 0.0 {
        let what = "give the samples a second, e.g. \"20 kHz\"";
        measure::out_of_range("output.rate", node, "must be positive", what, report);
        return None;
    }
    let t_end = t_end?;
    let samples = rate * t_end;
    if samples > MAX_SAMPLES {
        let message = format!("`output.rate` asks for {samples:.1e} samples");
        let most = MAX_SAMPLES / t_end;
        let help = format!(
            "at most {MAX_SAMPLES:e} are kept, {most:.1e} a second up to {t_end} s: lower the rate, or end the run earlier"
        );
        report.add(&node.place, message, "too many samples", help);
        return None;
    }
    Some(rate)
}
