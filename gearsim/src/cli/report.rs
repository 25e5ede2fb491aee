//! The outcome of a run as text for the terminal.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use serde::Serialize;

use super::{number, terminal};
use crate::analysis::from_teeth;
use crate::engine::system::{LinearisedAbout, Steady};
use crate::output::summary::{Digits, Number, Observed, Summary};
use crate::output::unit::{coordinate_in_words, in_words, readable};
use crate::plot::outputs::is_first;
use crate::scene::Scene;

/// Width of the names at the beginning of lines [columns].
const INDENT: usize = 18;

/// The scene: its name, description, model and effects.
pub(super) fn scene(scene: &Scene, width: usize) -> String {
    let effects = match &scene.effects.names(scene.model)[..] {
        [] => "none".to_owned(),
        names => names.join(", "),
    };
    let mut text = line("scene", &scene.name, width);
    if !scene.about.is_empty() {
        text += &line("about", &scene.about, width);
    }
    text += &line("model", &format!("{}, {}", scene.model.name, scene.model.title), width);
    text += &line("effects", &effects, width);
    let from_teeth = from_teeth::of(scene);
    text.extend(from_teeth.iter().map(|law| line(law.law.name, &law.words(|x| number::short(x).to_string()), width)));
    text.extend(scene.conversions.iter().map(|says| line("converted", says, width)));
    text + &torques(scene, width)
}

/// The torques on bodies that are products of parameters, such as a torque per tooth times a number of teeth.
fn torques(scene: &Scene, width: usize) -> String {
    if !scene.effects.names(scene.model).contains(&"torques") {
        return String::new();
    }
    let at_start = if scene.varying().is_some() { " at t = 0" } else { "" };
    let torque = |doc: &str| {
        let (product, body) = doc.strip_prefix("torque ")?.split_once(" on the ")?;
        let (sign, names) = product.strip_prefix('-').map_or((1.0, product), |names| (-1.0, names));
        let factors = names.split(' ').map(|name| scene.parameter(name)).collect::<Option<Vec<_>>>()?;
        let value = sign * factors.iter().product::<f64>();
        (factors.len() > 1).then(|| format!("{} on the {body}{at_start} ({product})", in_words(value, "N*m")))
    };
    let torques: Vec<_> = scene.model.torques.iter().filter_map(|t| torque(t.doc)).collect();
    if torques.is_empty() { String::new() } else { line("torques", &torques.join(", "), width) }
}

/// The outcome of a run that recorded `rows` rows.
pub(super) fn run(scene: &Scene, summary: &Summary, rows: usize, width: usize) -> String {
    let energy = &summary.energy;
    let reached = match summary.completed {
        true => format!("{} s", number::short(summary.t_end.0)),
        false => format!("{} s of {} s: stopped early", number::short(summary.t_end.0), number::short(scene.t_end)),
    };
    let lost = format!("{} of {} at the start", in_words(energy.dissipated.0, "J"), in_words(energy.at_start.0, "J"));
    let method = format!("{}: {}", summary.method.name, summary.method.why);
    let lines = [
        ("method", method),
        ("simulated", reached),
        ("end state", summary.state_in_words(scene.model)),
        ("digits left", digits(summary)),
        ("cell changes", summary.cell_changes.to_string()),
        ("reflections", summary.reflections.to_string()),
        ("lost to damping", lost),
        ("unaccounted for", unaccounted(summary)),
        ("time taken", time(summary, rows)),
    ];
    let mut text: String = lines.iter().map(|(name, text)| line(name, text, width)).collect();
    if summary.refuted.is_some() {
        text += &line("wrong result", "the energy account does not close: none of these numbers can be trusted", width);
    }
    text + &outputs(summary, width) + &rare_lines(scene, summary, width)
}

/// Most outputs that are listed.
const MOST_OUTPUTS: usize = 12;

/// The range and the mean of the recorded outputs, and the share of time in each mode of a switch.
fn outputs(summary: &Summary, width: usize) -> String {
    let short = number::short;
    let mut text = String::new();
    // An output that is zero throughout belongs to an effect that the scene does not have.
    let mut moving: Vec<_> = summary.outputs.iter().filter(|(_, o)| o.min.0 != 0.0 || o.max.0 != 0.0).collect();
    moving.sort_by_key(|(name, o)| (o.unit == "W", !is_first(name)));
    for (name, Observed { unit, min, max, mean, .. }) in moving.iter().take(MOST_OUTPUTS) {
        let (unit, scale) = readable(unit, min.0.abs().max(max.0.abs()));
        let [mean, min, max] = [mean, min, max].map(|value| short(scale * value.0));
        let says = format!("{mean} {unit} in the mean, from {min} to {max}");
        text += &line(name, &says, width);
    }
    if let Some(more) = moving.len().checked_sub(MOST_OUTPUTS).filter(|more| *more > 0) {
        text += &line("further outputs", &format!("{more}, in summary.json"), width);
    }
    for (switch, shares) in &summary.modes {
        let share = |(mode, share): (&String, &Number)| format!("{mode} {} %", short(100.0 * share.0));
        let spent: Vec<_> = shares.0.iter().filter(|(_, share)| share.0 > 0.0).map(share).collect();
        text += &line(&format!("time in {switch}"), &spent.join(", "), width);
    }
    text
}

/// What a linear analysis leaves out of a scene; empty if it leaves out nothing.
pub(super) fn left_out(scene: &Scene, width: usize) -> String {
    match &scene.left_out_if_linear()[..] {
        [] => String::new(),
        what => {
            let what = what.join(", ");
            let says = format!("linear: without {what}. Play is closed here, a clutch open, dry friction absent");
            line("note", &says, width) + "\n"
        }
    }
}

/// The steady motion about which the forces of a linear analysis are linearised.
#[derive(Serialize)]
pub(super) struct Linearised<'a> {
    /// The terms that are not linear.
    terms: &'a str,
    /// What they are linearised about, in words.
    about: &'static str,
    /// Coordinates, the elastic ones in static equilibrium [SI].
    coordinates: BTreeMap<&'static str, f64>,
    /// Speeds of the start [SI].
    speeds: BTreeMap<&'static str, f64>,
    /// Forces, torques and powers of the model's outputs there [SI].
    forces: BTreeMap<&'static str, f64>,
    /// Why the motion meets both flanks of a mesh, although the linearised friction is that of one flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    both_flanks: Option<&'a str>,
}

impl<'a> Linearised<'a> {
    pub(super) fn of(scene: &Scene, steady: Option<&'a Steady>) -> Option<Self> {
        let Steady { motion, q, q_dot, terms, outputs, both_flanks, .. } = steady?;
        let named = |x: &[f64]| scene.model.coordinates.iter().map(|c| c.name).zip(x.iter().copied()).collect();
        let forces = outputs.iter().map(|(name, _, value)| (*name, *value)).collect();
        let (about, both_flanks) = (about(*motion), both_flanks.as_deref());
        Some(Linearised { terms, about, coordinates: named(q), speeds: named(q_dot), forces, both_flanks })
    }
}

/// What equations are linearised about, in words.
fn about(motion: LinearisedAbout) -> &'static str {
    match motion {
        LinearisedAbout::Equilibrium => "the equilibrium",
        LinearisedAbout::Steady => "the steady motion",
        LinearisedAbout::Place => "the place of the start, from which the matrices change along the motion,",
    }
}

/// The linearised terms and their steady motion in words; empty if all terms are linear.
pub(super) fn linearised(scene: &Scene, steady: Option<&Steady>, width: usize) -> String {
    let Some(Steady { motion, q, q_dot, terms, outputs, both_flanks, .. }) = steady else { return String::new() };
    let places = scene.model.coordinates.iter().zip(q.iter()).filter(|_| *motion != LinearisedAbout::Steady);
    let places = places.map(|(c, x)| format!("{} = {}", c.name, coordinate_in_words(*x, c.unit)));
    let speeds = scene.model.coordinates.iter().zip(q_dot.iter()).filter(|(_, v)| **v != 0.0);
    let speeds = speeds.map(|(c, v)| format!("{}' = {} {}/s", c.name, number::short(*v), c.unit));
    let forces =
        outputs.iter().filter(|(.., x)| *x != 0.0).map(|(name, unit, x)| format!("{name} = {}", in_words(*x, unit)));
    let values = places.chain(speeds).chain(forces).collect::<Vec<_>>().join(", ");
    let mut text = line("linearised", &format!("{terms}, about {} {values}", about(*motion)), width) + "\n";
    if let Some(why) = both_flanks {
        let says = format!(
            "the motion meets both flanks: {why}. Friction has the other sign on the other flank; linearised, it is that \
             of one flank alone. `gearsim run` has both"
        );
        text += &(line("note", &says, width) + "\n");
    }
    text
}

/// Lines that most runs do not have.
fn rare_lines(scene: &Scene, summary: &Summary, width: usize) -> String {
    let counts = &summary.counts;
    let mut text = String::new();
    for remark in summary.remarks.iter().filter(|remark| !scene.conversions.contains(remark)) {
        text += &line("note", remark, width);
    }
    if counts.holds > 0 {
        let ignored = number::short(counts.ignored.0);
        let says = format!("{} times; the bounces that were ignored had {ignored} J", counts.holds);
        text += &line("held at a step", &says, width);
    }
    for (kind, impacts) in summary.impacts.iter().filter(|(_, impacts)| **impacts > 0) {
        text += &line(kind, &format!("{impacts} times after being apart"), width);
    }
    if counts.sticks > 0 {
        text += &line("came to rest", &format!("{} times, held by friction or a clutch", counts.sticks), width);
    }
    if counts.grazes > 0 {
        let says = format!("{} times a phase touched a step without passing it, within rounding errors", counts.grazes);
        text += &line("grazes", &says, width);
    }
    if counts.ambiguous > 0 {
        let says = format!(
            "{} times two meshes met steps at the same instant, and the result depends on their order: it is one of \
             several. Shift the start slightly in both directions to see the others",
            counts.ambiguous
        );
        text += &line("not unique", &says, width);
    }
    text
}

/// The files written.
pub(super) fn files(folder: &Path, files: &[String], width: usize) -> String {
    line("written to", &format!("{}: {}", folder.display(), files.join(", ")), width)
}

/// The number of digits left of the end state, or the time from which on none is left.
fn digits(summary: &Summary) -> String {
    match summary.digits {
        None => "not estimated".into(),
        Some(Digits { none_from: Some(t), .. }) => {
            let account = if summary.refuted.is_none() { "; the energy account still holds" } else { "" };
            format!(
                "none from t = {} s on: a rounding error, or the error of a time step, has grown as large as the motion. The state, \
                 counts and extremes after that time are one of many possible outcomes{account}",
                number::short(t.0)
            )
        }
        Some(Digits { at_end, .. }) => {
            let digits = at_end.0.floor();
            format!("{digits:.0} of the end state, from a second run whose start differs by rounding errors")
        }
    }
}

/// The energy residual [J], and its ratio to the largest part of the account.
fn unaccounted(summary: &Summary) -> String {
    let (residual, largest) = (summary.energy.residual.0, summary.energy.largest.0);
    let mut text = format!("{} J", number::short(residual));
    if largest != 0.0 {
        let _ =
            write!(text, ", {} of the largest part of the energy account", number::short((residual / largest).abs()));
    }
    text
}

/// The processor time and the number of steps.
fn time(summary: &Summary, rows: usize) -> String {
    let each = per_event(summary).map_or(String::new(), |each| format!(", {each} per event"));
    let steps = match (summary.method.steps, summary.method.rejected) {
        (0, _) => String::new(),
        (steps, 0) => format!(", {steps} steps"),
        (steps, rejected) => format!(", {steps} steps and {rejected} rejected"),
    };
    format!("{}{each}{steps} (including the recording of {rows} rows)", number::time(summary.cpu_seconds.0))
}

/// The processor time per cell change or reflection; `None` if there was none.
pub(super) fn per_event(summary: &Summary) -> Option<String> {
    let events = summary.cell_changes + summary.reflections;
    (events > 0).then(|| number::time(summary.cpu_seconds.0 / events as f64))
}

/// A name and the text `content` beside it, broken at blanks.
pub(super) fn line(name: &str, content: &str, width: usize) -> String {
    let broken = terminal::wrap(content, width.saturating_sub(INDENT).max(1));
    let mut text = String::new();
    for (i, part) in broken.lines().enumerate() {
        let name = if i == 0 { name } else { "" };
        let _ = writeln!(text, "{name:width$} {part}", width = INDENT - 1);
    }
    text
}
