//! `[output] spectrum`: which signals are transformed, from which time on, and the scale of their spectra.

use super::dimension::Dimension;
use super::document::{Node, Value};
use super::keys::{Key, Kind, key};
use super::mistake::Report;
use super::quantity::Quantity;
use super::unit::Unit;
use super::{field, keys, output};
use crate::model::Model;

/// What a signal is, in words.
pub(super) const SIGNAL: &str = "a recorded output or a coordinate";

/// Keys of the table.
pub(super) const KEYS: &[Key] = &[
    key("of", Kind::List(&Kind::Name(SIGNAL)), "chosen by the program", "signals to transform"),
    key("shaft", Kind::Name(SPEED), "the first that turns enough", "shaft to whose turns orders refer, by its speed"),
    key("kind", Kind::Choice(&KIND_NAMES), "psd", "power spectral density, peak amplitude, or rms of a sine"),
    key("scale", Kind::Choice(&SCALES), "log", "a logarithmic axis, or levels"),
    key("reference", Kind::Either(&[Kind::Text, Kind::List(&Kind::Text)]), REFERENCES, "what levels refer to, by unit"),
    key(
        "axis",
        Kind::Choice(&AXES),
        "Hz",
        "frequencies in Hz, or over the damped natural frequency at the mean stiffness",
    ),
    key("from", Kind::Quantity("s"), "output.from", "where the transformed part of the record begins"),
];

/// What the speed of a shaft is, in words.
const SPEED: &str = "a recorded speed of a rotor";
/// The usual references of levels, in words.
const REFERENCES: &str = "1 um, 1 urad, else 1 of the SI unit";
/// Scales of a spectrum.
const SCALES: [&str; 2] = ["log", "dB"];

/// Axes of frequencies.
const AXES: [&str; 2] = ["Hz", "natural"];

/// How spectra of a run are computed and drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Names of the signals: recorded outputs and coordinates. Empty: the program chooses.
    pub of: Vec<&'static str>,
    /// Name of the recorded output that is the speed of the reference shaft of orders. `None`: the program chooses the shaft.
    pub shaft: Option<&'static str>,
    /// What is drawn.
    pub kind: SpectrumKind,
    /// Whether values are levels in dB re a reference.
    pub decibels: bool,
    /// Whether frequencies are those over the damped natural frequency of the lowest elastic mode at the mean stiffness; else in Hz.
    pub natural: bool,
    /// The references that the scene states.
    pub references: Vec<Reference>,
    /// Time from which on the record is transformed \[s\].
    pub from: f64,
}

/// The quantity over frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpectrumKind {
    /// Power spectral density [unit^2/Hz].
    Psd,
    /// Peak amplitude of a sine [unit].
    Amplitude,
    /// Root mean square of a sine [unit].
    Rms,
}

/// The names of [`SpectrumKind`], in its order.
const KINDS: [(&str, SpectrumKind); 3] =
    [(KIND_NAMES[0], SpectrumKind::Psd), (KIND_NAMES[1], SpectrumKind::Amplitude), (KIND_NAMES[2], SpectrumKind::Rms)];
const KIND_NAMES: [&str; 3] = ["psd", "amplitude", "rms"];

/// A value to which levels refer.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// As written, e.g. `1 N`.
    pub text: String,
    /// Its value \[SI\].
    pub value: f64,
    /// Its dimension: it is the reference of signals of this dimension.
    pub(crate) dimension: Dimension,
}

/// Default references of signals, by unit. For other units the reference is 1 in the SI unit.
const USUAL: [(&str, &str, f64); 2] = [("m", "1 um", 1e-6), ("rad", "1 urad", 1e-6)];

impl Spectrum {
    /// Densities of the signals that the program chooses, over the whole run.
    pub const DEFAULT: Spectrum = Spectrum {
        of: vec![],
        shaft: None,
        kind: SpectrumKind::Psd,
        decibels: false,
        natural: false,
        references: vec![],
        from: 0.0,
    };

    /// The reference of levels of a signal with the SI unit `unit`: in words, and its value \[SI\].
    pub fn reference(&self, unit: &str) -> (String, f64) {
        let fits = |r: &&Reference| Unit::parse(unit).is_ok_and(|unit| r.dimension.fits(unit.dimension));
        if let Some(given) = self.references.iter().find(fits) {
            return (given.text.clone(), given.value);
        }
        let usual = USUAL.iter().find(|(known, ..)| *known == unit);
        usual.map_or_else(|| (format!("1 {unit}"), 1.0), |(_, text, value)| ((*text).to_owned(), *value))
    }
}

/// Reads the table. `record` has the numbers of the outputs that are recorded; `from` is `output.from` \[s\].
pub(super) fn read(
    node: &Node,
    (model, record): (Option<&'static Model>, Option<&[usize]>),
    (from, t_end): (f64, Option<f64>),
    report: &mut Report,
) -> Option<Spectrum> {
    let given = field::table("output.spectrum", node, report)?;
    keys::known(given, "[output.spectrum]", &[KEYS], report);
    let of = match keys::get(given, "of") {
        Some(node) => {
            let signals = signals(model?, record?);
            let chosen = field::names("output.spectrum.of", node, "recorded signal", &signals, report)?;
            chosen.into_iter().map(|i| signals[i]).collect()
        }
        None => vec![],
    };
    let shaft = match keys::get(given, "shaft") {
        Some(node) => {
            let model = model?;
            let recorded = record?.iter().map(|&i| &model.outputs[i]);
            let speeds: Vec<&'static str> = recorded.filter(|o| o.unit == "rad/s").map(|o| o.name).collect();
            Some(speeds[field::choice("output.spectrum.shaft", node, "recorded speed of a rotor", &speeds, report)?])
        }
        None => None,
    };
    let mut choice = |key: &str, noun: &str, allowed: &[&str]| match keys::get(given, key) {
        Some(node) => field::choice(&format!("output.spectrum.{key}"), node, noun, allowed, report),
        None => Some(0),
    };
    let kind = choice("kind", "kind of spectrum", &KIND_NAMES)?;
    let decibels = choice("scale", "scale", &SCALES)? == 1;
    let natural = choice("axis", "axis of frequencies", &AXES)? == 1;
    let references = match keys::get(given, "reference") {
        Some(node) if !decibels => {
            let help = "add scale = \"dB\", or remove the reference";
            report.add(&node.place, "`output.spectrum.reference` has no use without levels in dB", "not used", help);
            return None;
        }
        Some(node) => references(node, report)?,
        None => vec![],
    };
    let from = match keys::get(given, "from") {
        Some(node) => output::read_from("output.spectrum.from", node, t_end, report)?,
        None => from,
    };
    Some(Spectrum { of, shaft, kind: KINDS[kind].1, decibels, natural, references, from })
}

/// The signals of a run, one column each: recorded outputs, then coordinates.
pub(super) fn signals(model: &'static Model, record: &[usize]) -> Vec<&'static str> {
    let outputs = record.iter().map(|&i| model.outputs[i].name);
    outputs.chain(model.coordinates.iter().map(|c| c.name)).collect()
}

/// Reads one reference, or an array of references of different dimensions.
fn references(node: &Node, report: &mut Report) -> Option<Vec<Reference>> {
    let nodes = match &node.value {
        Value::Array(nodes) => nodes.as_slice(),
        _ => std::slice::from_ref(node),
    };
    nodes.iter().map(|node| reference(node, report)).collect()
}

fn reference(node: &Node, report: &mut Report) -> Option<Reference> {
    let text = field::text("output.spectrum.reference", node, report)?;
    match Quantity::parse(text) {
        Ok(read) if read.value > 0.0 && read.value.is_finite() && !read.bare => {
            Some(Reference { text: text.trim().to_owned(), value: read.value, dimension: read.dimension })
        }
        Ok(_) => {
            let message = format!("`output.spectrum.reference` is a positive quantity with a unit, not \"{text}\"");
            report.add(&node.place, message, "not a reference", "write for example \"1 N\" or \"1 um\"");
            None
        }
        Err(error) => {
            let message = format!("`output.spectrum.reference` cannot be read: {}", error.message);
            report.add(&node.place, message, "not understood", error.help);
            None
        }
    }
}
