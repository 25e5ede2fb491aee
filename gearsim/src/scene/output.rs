//! `[run]` and `[output]`: the end time of a run, and what is recorded.

use super::document::{Entry, Node};
use super::mistake::Report;
use super::{Output, PLOTS, Solver, field, keys, solver};
use crate::model::Model;
use crate::tolerance::scene::{MOST_ROW_MEMORY, ROW_MEMORY, SHORTEST_RUN};
use crate::trajectory::Trajectory;

/// Keys of `[output]`.
pub(super) const KEYS: [&str; 5] = ["rate", "events", "plots", "csv", "most_rows"];

/// Number of samples of a run if the scene states no rate.
const DEFAULT_SAMPLES: f64 = 1e4;

/// Reads the end time of the run [s] and the solver. If `[run]` is missing, the lines to add go to `absent`.
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
    let t_end = read_end(given, run, report);
    (t_end, solver::read(given, run, t_end, report))
}

fn read_end(given: &[Entry], run: &Node, report: &mut Report) -> Option<f64> {
    let Some(node) = keys::get(given, "t_end") else {
        let line = "t_end = \"... s\"".to_string();
        keys::missing(&[("t_end", line)], "[run]", &run.place, report);
        return None;
    };
    let t_end = field::quantity("run.t_end", node, "s", report)?;
    if t_end >= SHORTEST_RUN {
        return Some(t_end);
    }
    let must = match t_end > 0.0 {
        true => format!("must be at least {SHORTEST_RUN:e} s"),
        false => "must be positive".to_string(),
    };
    field::out_of_range("run.t_end", node, &must, "the run starts at 0 s", report);
    None
}

/// Reads `[output]`. The table and all its keys may be left out.
pub(super) fn read(
    entries: &[Entry],
    model: Option<&Model>,
    t_end: Option<f64>,
    report: &mut Report,
) -> Option<Output> {
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
    let most_rows = match keys::get(given, "most_rows") {
        Some(node) => read_most_rows(node, model, report),
        None => model.map(|model| ROW_MEMORY / Trajectory::bytes_of_row(model) as f64),
    };
    let rate = match keys::get(given, "rate") {
        Some(node) => read_rate(node, t_end, most_rows, report),
        None => t_end.map(|t_end| DEFAULT_SAMPLES / t_end),
    };
    let plots = plots?.into_iter().map(|i| PLOTS[i].to_string()).collect();
    Some(Output { rate: rate?, events: events?, plots, csv: csv?, most_rows: most_rows? as u64 })
}

fn read_most_rows(node: &Node, model: Option<&Model>, report: &mut Report) -> Option<f64> {
    let rows = field::quantity("output.most_rows", node, "1", report)?;
    if rows < 2.0 || rows.fract() != 0.0 {
        let what = "give the largest number of rows to record, e.g. 1e7";
        field::out_of_range("output.most_rows", node, "must be a whole number of at least 2", what, report);
        return None;
    }
    let bytes = Trajectory::bytes_of_row(model?) as f64;
    if rows * bytes > MOST_ROW_MEMORY {
        let must = format!("must be at most {:.1e}", MOST_ROW_MEMORY / bytes);
        let what = format!("a row takes {bytes} bytes, and rows may take {} GB", MOST_ROW_MEMORY / 1e9);
        field::out_of_range("output.most_rows", node, &must, &what, report);
        return None;
    }
    Some(rows)
}

fn read_rate(node: &Node, t_end: Option<f64>, most_rows: Option<f64>, report: &mut Report) -> Option<f64> {
    let rate = field::quantity("output.rate", node, "Hz", report)?;
    if rate <= 0.0 {
        let what = "give the samples per second, e.g. \"20 kHz\"";
        field::out_of_range("output.rate", node, "must be positive", what, report);
        return None;
    }
    let (t_end, most_rows) = (t_end?, most_rows?);
    let samples = rate * t_end;
    if samples > most_rows {
        let message = format!("`output.rate` asks for {samples:.1e} samples");
        let most = most_rows / t_end;
        let help = format!(
            "at most {most_rows:.1e} rows are kept, which allows {most:.1e} Hz up to {t_end} s: lower the rate, end the run earlier, or \
             raise output.most_rows"
        );
        report.add(&node.place, message, "too many samples", help);
        return None;
    }
    Some(rate)
}
