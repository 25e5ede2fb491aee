//! `[run]` and `[output]`: the end time of a run, and what is recorded.

use super::document::{KeyEntry, Node};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::{Output, PLOTS, Solver, Spectrum, check, field, keys, solver, sound, spectrum};
use crate::model::{self, Model};
use crate::scene::Effects;
use crate::tolerance::scene::{MOST_ROW_MEMORY, ROW_MEMORY, SHORTEST_RUN};
use crate::trajectory::Trajectory;

/// Keys of `[run]` beside those of the solver.
pub(super) const END: &[Key] = &[key("t_end", Kind::Quantity("s"), REQUIRED, "end of the run, which starts at 0 s")];

/// Keys of `[output]`.
pub(super) const KEYS: &[Key] = &[
    key("rate", Kind::Quantity("Hz"), "10000 samples over the run", "samples per second"),
    key("events", Kind::Flag, "true", "record the state before and after each event"),
    key(
        "plots",
        Kind::List(&Kind::Choice(PLOTS)),
        "those with data, without order_cuts, order_waterfall and run_up; order_cuts for spectrum in run-ups",
        "plots to draw",
    ),
    key("record", Kind::List(&Kind::Name("an output of the model")), "all", "outputs to record"),
    key("from", Kind::Quantity("s"), "0 s", "from which time on statistics, load spectra and transforms take the run"),
    key("spectrum", Kind::Table(&[spectrum::KEYS]), "all defaults", "which spectra are drawn, and their scale"),
    key("rainflow", Kind::List(&Kind::Name(spectrum::SIGNAL)), "none", "signals whose load cycles are counted"),
    key("sound", Kind::Table(&[sound::KEYS]), "none", "signals to write as WAV files"),
    key("csv", Kind::Flag, "false", "write the trajectory as CSV too"),
    key("most_rows", Kind::Number, "as many as fit in 1 GB", "the run stops when this many rows are recorded"),
];

/// Number of samples of a run if the scene states no rate.
const DEFAULT_SAMPLES: f64 = 1e4;

/// The entry in `absent` for a scene without `[run]`.
pub(super) const RUN: &str = "[run]";

/// Reads the end time of the run [s] and the solver. If `[run]` is missing, the lines to add go to `absent`, and the end is infinite.
pub(super) fn read_run(
    entries: &[KeyEntry],
    absent: &mut Vec<(&str, String)>,
    report: &mut Report,
) -> (Option<f64>, Option<Solver>) {
    let Some(run) = keys::get(entries, "run") else {
        absent.push((RUN, "[run]\nt_end = \"... s\"".to_string()));
        return (Some(f64::INFINITY), Some(Solver::default()));
    };
    let Some(given) = field::table("run", run, report) else { return (None, None) };
    keys::known(given, "[run]", check::RUN, report);
    let t_end = read_end(given, run, report);
    (t_end, solver::read(given, run, t_end, report))
}

fn read_end(given: &[KeyEntry], run: &Node, report: &mut Report) -> Option<f64> {
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
    entries: &[KeyEntry],
    (model, effects): (Option<&'static Model>, Option<&Effects>),
    t_end: Option<f64>,
    report: &mut Report,
) -> Option<Output> {
    let node = keys::get(entries, "output");
    let given = node.map_or(Some(&[][..]), |node| field::table("output", node, report))?;
    keys::known(given, "[output]", &[KEYS], report);
    let mut flag = |key: &str, default| match keys::get(given, key) {
        Some(node) => field::flag(&format!("output.{key}"), node, report),
        None => Some(default),
    };
    let (events, csv) = (flag("events", true), flag("csv", false));
    let record = match keys::get(given, "record") {
        Some(node) => read_record(node, model, effects, report),
        None => model.map(|model| available(model, effects)),
    };
    let from = match keys::get(given, "from") {
        Some(node) => read_from("output.from", node, t_end, report),
        None => Some(0.0),
    };
    let spectrum = match keys::get(given, "spectrum") {
        Some(node) => spectrum::read(node, (model, record.as_deref()), (from.unwrap_or(0.0), t_end), report),
        None => from.map(|from| Spectrum { from, ..Spectrum::DEFAULT }),
    };
    let signals = || Some(spectrum::signals(model?, record.as_deref()?));
    let rainflow = match keys::get(given, "rainflow") {
        Some(node) => signals().and_then(|all| {
            let chosen = field::names("output.rainflow", node, "recorded signal", &all, report)?;
            Some(chosen.into_iter().map(|i| all[i]).collect::<Vec<_>>())
        }),
        None => Some(vec![]),
    };
    let sound = match keys::get(given, "sound") {
        Some(node) => signals().and_then(|all| sound::read(node, &all, report)).map(Some),
        None => Some(None),
    };
    let counted = rainflow.as_ref().is_some_and(|rainflow| !rainflow.is_empty());
    let plots = match keys::get(given, "plots") {
        Some(node) => field::names("output.plots", node, "plot", PLOTS, report),
        None => Some(default_plots(model, record.as_deref(), counted)),
    };
    let bytes = model.zip(record.as_ref()).map(|(model, record)| {
        let torques = effects.map_or(model.torques.len(), |effects| effects.torques(model).len());
        Trajectory::bytes_of_row(model, torques, record.len()) as f64
    });
    let most_rows = match keys::get(given, "most_rows") {
        Some(node) => read_most_rows(node, bytes, report),
        None => bytes.map(|bytes| ROW_MEMORY / bytes),
    };
    let rate = match keys::get(given, "rate") {
        Some(node) => read_rate(node, t_end, most_rows, report),
        None => t_end.map(|t_end| DEFAULT_SAMPLES / t_end),
    };
    let plots = plots?.into_iter().map(|i| PLOTS[i].to_string()).collect();
    let (rate, events, csv, most_rows) = (rate?, events?, csv?, most_rows? as u64);
    let (record, from, spectrum, rainflow, sound) = (record?, from?, spectrum?, rainflow?, sound?);
    let default_plots = keys::get(given, "plots").is_none();
    Some(Output {
        rate,
        events,
        plots,
        default_plots,
        record,
        from,
        spectrum,
        rainflow,
        sound,
        csv,
        most_rows,
        most_time: None,
    })
}

/// The default plots: the outputs, and their orders if the model has meshes; the motion if no outputs are recorded; load spectra if they
/// are `counted`.
fn default_plots(model: Option<&Model>, record: Option<&[usize]>, counted: bool) -> Vec<usize> {
    let recorded = record.is_some_and(|record| !record.is_empty());
    let meshes = model.is_some_and(|model| !model.laws.is_empty());
    let drawn = |plot: &str| match plot {
        "outputs" => recorded,
        "orders" => recorded && meshes,
        "motion" => !recorded,
        "order_cuts" | "order_waterfall" | "run_up" => false,
        "rainflow" | "load_duration" => counted,
        _ => true,
    };
    (0..PLOTS.len()).filter(|&i| drawn(PLOTS[i])).collect()
}

/// The outputs that scenes with these effects have, by their numbers.
fn available(model: &Model, effects: Option<&Effects>) -> Vec<usize> {
    let has = |output: &model::Output| effects.is_none_or(|effects| effects.activate(output.with, model));
    (0..model.outputs.len()).filter(|&i| has(&model.outputs[i])).collect()
}

/// Reads the names of the outputs to record. Those of effects that the scene does not have are left out, so that one list serves
/// scenes that are compared with and without an effect.
fn read_record(
    node: &Node,
    model: Option<&Model>,
    effects: Option<&Effects>,
    report: &mut Report,
) -> Option<Vec<usize>> {
    let model = model?;
    let names: Vec<&str> = model.outputs.iter().map(|output| output.name).collect();
    let chosen = field::names("output.record", node, "output", &names, report)?;
    let available = available(model, effects);
    Some(chosen.into_iter().filter(|i| available.contains(i)).collect())
}

/// Reads a time within the run \[s\].
pub(super) fn read_from(path: &str, node: &Node, t_end: Option<f64>, report: &mut Report) -> Option<f64> {
    let from = field::quantity(path, node, "s", report)?;
    let within = (0.0..t_end?).contains(&from);
    if !within {
        let help = "give the time at which the motion has settled, e.g. \"0.1 s\"";
        field::out_of_range(path, node, "must lie within the run", help, report);
    }
    within.then_some(from)
}

fn read_most_rows(node: &Node, bytes: Option<f64>, report: &mut Report) -> Option<f64> {
    let rows = field::quantity("output.most_rows", node, "1", report)?;
    if rows < 2.0 || rows.fract() != 0.0 {
        let what = "give the largest number of rows to record, e.g. 1e7";
        field::out_of_range("output.most_rows", node, "must be a whole number of at least 2", what, report);
        return None;
    }
    let bytes = bytes?;
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
    if t_end.is_infinite() {
        return Some(rate);
    }
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
