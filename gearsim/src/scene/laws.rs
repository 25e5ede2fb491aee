//! `[laws]`: mesh stiffnesses, transmission errors and friction laws over one or several pitches.

use super::document::{KeyEntry, Node, Value};
use super::keys::{Key, Kind, Named, REQUIRED, each, key};
use super::mistake::{Home, Report};
use super::smooth::{self, SmoothLaw};
use super::teeth::{self, TeethReader};
use super::{Effects, damage, field, friction, keys, mesh_phase, transmission_error, unknown_law};
use crate::gear::Gears;
use crate::model::{Law, Model, Role};
use crate::profile::{Profile, Step};
use crate::tolerance::scene::WIDTHS;

/// Kind of a value of a law.
pub(super) const VALUE: Kind = Kind::ValueIn("unit of the law");
/// Kind of a place or a length within the pitch.
pub(super) const PHASE: Kind = Kind::ValueIn("unit of the mesh phase");

/// Laws that a scene may have.
pub(super) const NAMED: &[Named] = &[
    each("STIFFNESS", Kind::Table(STIFFNESS), REQUIRED, "a mesh stiffness over one or more pitches"),
    each("ERROR", Kind::Table(ERROR), "required with its effect", "a transmission error over one or more pitches"),
    each(
        "FRICTION",
        Kind::Table(FRICTION),
        "required with its effect",
        "side or arm of sliding friction over one or more pitches",
    ),
];

/// Keys of a stiffness, a transmission error, and a side or arm of friction.
pub(super) const STIFFNESS: &[&[Key]] =
    &[KEYS, smooth::KEYS, teeth::GEARS, teeth::SHARED, teeth::STIFFNESS, damage::KEYS];
pub(super) const ERROR: &[&[Key]] = &[KEYS, smooth::KEYS, transmission_error::KEYS];
pub(super) const FRICTION: &[&[Key]] = &[KEYS, smooth::KEYS, teeth::GEARS, teeth::SHARED, friction::KEYS];

/// Keys of all laws.
const KEYS: &[Key] = &[
    key("steps", Kind::List(&Kind::Table(&[STEP])), "none", "levels over one pitch; a single level is a constant"),
    key(
        "pitches",
        Kind::Number,
        "1",
        "number of pitches that steps, harmonics or table cover; teeth have one law a pitch",
    ),
    key(
        "phase",
        mesh_phase::KIND,
        "0",
        "shift within the pitch, k(s) = k0(s + phase): in pitches, as an angle, or of a planet",
    ),
];
/// Keys of a level.
const STEP: &[Key] = &[
    key("value", VALUE, REQUIRED, "the value"),
    key("width", PHASE, "the rest of the pitch, last level only", "the part of the pitch that the level covers"),
];

/// Reads `[laws]`, in the order of the model. If the table is missing, the lines to add go to `absent`. A law whose effect is not
/// among `effects` may be left out.
pub(super) fn read(
    entries: &[KeyEntry],
    model: &Model,
    effects: Option<&Effects>,
    absent: &mut Vec<(&str, String)>,
    report: &mut Report,
) -> Option<Vec<Profile>> {
    let idle = |law: &Law| law.with.is_some_and(|effect| !effects.is_some_and(|effects| effects.has(effect, model)));
    let readers = model.laws.iter().map(|law| LawReader::new(law, model));
    let Some(node) = keys::get(entries, "laws") else {
        let needed = readers.filter(|reader| !idle(reader.law));
        let home = |reader: &LawReader<'_>| report.stated.home(&format!("laws.{}", reader.law.name)).cloned();
        let (of_parts, others): (Vec<_>, Vec<_>) =
            needed.map(|reader| (home(&reader), reader)).partition(|(home, _)| home.is_some());
        let of_parts = of_parts.into_iter().filter_map(|(home, reader)| Some((home?, reader.law)));
        missing_in_parts(of_parts.collect(), report);
        let examples: Vec<_> = others.iter().map(|(_, reader)| reader.table(model)).collect();
        if !examples.is_empty() {
            absent.push(("[laws]", examples.join("\n")));
        }
        return Some(Vec::new());
    };
    let entries = field::table("laws", node, report)?;
    unknown_law::refuse(entries, model, report);
    let (mut lacking, mut homes) = (Vec::new(), Vec::new());
    let mut laws = Vec::new();
    for reader in readers {
        match keys::get(entries, reader.law.name) {
            Some(node) => laws.push(reader.law(node, entries, report)),
            None if idle(reader.law) => {
                laws.push(Some(Profile::stepping(vec![Step { value: 0.0, width: reader.law.period }])));
            }
            None => match report.stated.home(&format!("laws.{}", reader.law.name)) {
                Some(home) => homes.push((home.clone(), reader.law)),
                None => lacking.push((reader.law.name, reader.table(model))),
            },
        }
    }
    missing_in_parts(homes, report);
    keys::missing(&lacking, "[laws]", &node.place, report);
    laws.into_iter().collect()
}

/// Reports the missing laws of the parts of a train. Missing friction laws have a message of their own: they are computed from the teeth that a
/// stiffness states.
fn missing_in_parts(lacking: Vec<(Home, &Law)>, report: &mut Report) {
    let (friction, others): (Vec<_>, Vec<_>) = lacking.into_iter().partition(|(_, law)| law.role.is_friction());
    friction::without_teeth(friction, report);
    let line =
        |key: &str, unit| format!("{key} = \"... {unit}\"  # or a law: {{ steps = [...] }}, {{ teeth = [...] }}");
    let others = others.into_iter().map(|(home, law)| (home.clone(), line(home.key, law.unit)));
    keys::missing_in_parts(others.collect(), report);
}

/// The gears of each law of the model that has keys of teeth. Mistakes in them are reported as the laws are read.
pub(super) fn gears(entries: &[KeyEntry], model: &Model) -> Vec<Option<Gears>> {
    let of = |law: &Law| {
        let Value::Table(all) = &keys::get(entries, "laws")?.value else { return None };
        let node = keys::get(all, law.name)?;
        let Value::Table(entries) = &node.value else { return None };
        let teeth = TeethReader { law, entries, place: &node.place };
        teeth.given().then(|| teeth.gears(&mut Report::new())).flatten()
    };
    model.laws.iter().map(of).collect()
}

/// Reads one law.
struct LawReader<'a> {
    law: &'a Law,
    /// Unit of the phase and of the widths.
    phase_unit: &'static str,
    /// Key path of the steps, e.g. `laws.k.steps`.
    path: String,
}

impl<'a> LawReader<'a> {
    fn new(law: &'a Law, model: &Model) -> LawReader<'a> {
        let phase = model.coordinates.iter().find(|coordinate| coordinate.name == law.phase);
        let path = format!("laws.{}.steps", law.name);
        LawReader { law, phase_unit: phase.map_or("rad", |coordinate| coordinate.unit), path }
    }

    /// The table to add if the law is missing.
    fn table(&self, model: &Model) -> String {
        let line = match self.law.role.is_friction() {
            true => friction::example(self.law, model),
            false => format!("steps = {}", self.steps()),
        };
        format!("[laws.{}]  # {}\n{line}", self.law.name, self.law.doc)
    }

    fn steps(&self) -> String {
        let (value, width) = (self.law.unit, self.phase_unit);
        format!("[{{ value = \"... {value}\", width = \"... {width}\" }}, {{ value = \"... {value}\" }}]")
    }

    /// Reads the law; `all` are the tables of all laws.
    fn law(&self, node: &Node, all: &[KeyEntry], report: &mut Report) -> Option<Profile> {
        if let Some(read) = friction::from_teeth_of(self.law, self.phase_unit, node, all, report) {
            return read;
        }
        let table = format!("laws.{}", self.law.name);
        let entries = field::table(&table, node, report)?;
        let allowed = match self.law.role {
            Role::Stiffness => STIFFNESS,
            Role::Error => ERROR,
            Role::Side | Role::Arm => FRICTION,
        };
        keys::known(entries, &format!("[{table}]"), allowed, report);
        // After a mistake in the number of pitches, reading goes on with 1, so that other mistakes are found too.
        let stated = transmission_error::pitches(self.law, entries, report);
        let unshifted = self.unshifted(entries, node, stated.unwrap_or(1), report);
        // The period of a law with damaged teeth is several pitches.
        let pitches = unshifted.as_ref().map_or(1, |law| law.pitches) * stated.unwrap_or(1);
        let phase = match keys::get(entries, "phase") {
            None => Some(0.0),
            Some(node) if mesh_phase::wrong_type(&format!("{table}.phase"), node, report) => None,
            Some(node) => mesh_phase::read(self.law, self.phase_unit, pitches, node, report),
        };
        stated?;
        let law = unshifted?.with_pitches(pitches);
        let begins = law.origin - phase?;
        Some(law.with_origin(begins))
    }

    /// Reads the law without its `phase`, over a number of pitches.
    fn unshifted(&self, entries: &[KeyEntry], node: &Node, pitches: u32, report: &mut Report) -> Option<Profile> {
        let table = format!("laws.{}", self.law.name);
        let length = self.law.period * f64::from(pitches);
        let smooth = SmoothLaw { law: self.law, phase_unit: self.phase_unit, length, entries, place: &node.place };
        let damage = keys::get(entries, damage::DAMAGE).filter(|_| self.law.role == Role::Stiffness);
        if let (Some(node), true) = (damage, pitches > 1) {
            return damage::refuse_pitches(self.law, node, report);
        }
        if let Some(read) = smooth.instead_of_steps(report) {
            return match damage {
                Some(node) => damage::refuse_curve(self.law, node, report),
                None => read,
            };
        }
        if let Some(node) = keys::get(entries, transmission_error::OF_TEETH) {
            return smooth.ramped(transmission_error::of_teeth(self.law, node, report)?, report);
        }
        let teeth = TeethReader { law: self.law, entries, place: &node.place };
        if let (true, Some(node)) = (teeth.given(), keys::get(entries, "pitches")) {
            let message = format!("`{table}` has both pitches and teeth");
            let help = "leave out pitches: a law from teeth is the same in each pitch; see damage and pitch_errors";
            report.add(&node.place, message, "one too many", help);
            return None;
        }
        if teeth.given() {
            let read = match (self.law.role, damage) {
                (Role::Stiffness, Some(node)) => self.damaged_teeth(&teeth, node, report),
                (Role::Stiffness, None) => teeth.read(report),
                (Role::Error, _) => None, // an error has no keys of teeth; `known` has reported them
                (Role::Side | Role::Arm, _) => {
                    let law = teeth.friction_law(report)?;
                    law.map_err(|e| teeth.refused(teeth.at(), e, report)).ok()
                }
            };
            return smooth.ramped(read?, report);
        }
        let Some(steps) = keys::get(entries, "steps") else {
            let line = format!("steps = {}", self.steps());
            keys::missing(&[("steps", line)], &format!("[{table}]"), &node.place, report);
            return None;
        };
        let stepping = self.stepping(steps, length, report)?;
        let law = match damage {
            // Steps do not state how many pairs are in contact: one pair at the low level and two at the high level are assumed.
            Some(node) => damage::read(self.law, node, stepping, 1, report)?,
            None => stepping,
        };
        smooth.ramped(law, report)
    }

    /// The stiffness of teeth of which some are damaged. Along the face of helical gears a damaged tooth meets each transverse section at its own
    /// phase. Therefore the damage is applied to the law of a section, which is then averaged.
    fn damaged_teeth(&self, teeth: &TeethReader<'_>, node: &Node, report: &mut Report) -> Option<Profile> {
        let (section, window) = teeth.of_section(report)?;
        let contact = teeth.gears(&mut Report::new()).and_then(|gears| gears.contact().ok());
        let pairs = contact.map_or(1, |contact| contact.pairs().0);
        Some(damage::read(self.law, node, section, pairs, report)?.averaged(window))
    }

    fn stepping(&self, steps: &Node, length: f64, report: &mut Report) -> Option<Profile> {
        let items = field::array(&self.path, steps, &self.steps(), report)?;
        let Some((last, before)) = items.split_last() else {
            let help = format!("write for example {}", self.steps());
            report.add(&steps.place, format!("`{}` is empty", self.path), "no step", help);
            return None;
        };
        let mut levels: Vec<_> =
            (before.iter().enumerate()).map(|(i, step)| self.step(i, step, false, report)).collect();
        levels.push(self.step(before.len(), last, true, report));
        let levels: Vec<_> = levels.into_iter().collect::<Option<_>>()?;
        self.fill(&levels, length, last, report)
    }

    /// Reads a level and its width. Only the last step may leave out the width.
    fn step(&self, i: usize, node: &Node, last: bool, report: &mut Report) -> Option<(f64, Option<f64>)> {
        let path = format!("{}.{i}", self.path);
        let entries = field::table(&path, node, report)?;
        keys::known(entries, &format!("`{path}`"), &[STEP], report);
        let (value, width) = (keys::get(entries, "value"), keys::get(entries, "width"));
        let mut lacking = Vec::new();
        if value.is_none() {
            lacking.push(("value", format!("value = \"... {}\"", self.law.unit)));
        }
        if width.is_none() && !last {
            let why = "only the last step may leave it out";
            lacking.push(("width", format!("width = \"... {}\"  # {why}", self.phase_unit)));
        }
        keys::missing(&lacking, &format!("`{path}`"), &node.place, report);

        let value = value.and_then(|node| {
            let path = format!("{path}.value");
            let x = field::quantity(&path, node, self.law.unit, report)?;
            if x < 0.0 && !self.law.role.has_sign() {
                field::out_of_range(&path, node, "must not be negative", why_not_negative(self.law), report);
            }
            Some(x)
        });
        let width = match width {
            None => Some(None),
            Some(node) => {
                let path = format!("{path}.width");
                let x = field::quantity(&path, node, self.phase_unit, report);
                if x.is_some_and(|x| x <= 0.0) {
                    let what = "it is the part of the pitch that the step covers";
                    field::out_of_range(&path, node, "must be positive", what, report);
                }
                x.map(Some)
            }
        };
        Some((value?, width?))
    }

    /// Gives the last level the rest of the pitch if it has no width; otherwise checks that the widths add up to the pitch.
    fn fill(&self, levels: &[(f64, Option<f64>)], pitch: f64, last: &Node, report: &mut Report) -> Option<Profile> {
        let one = if pitch == self.law.period { "one pitch is" } else { "the pitches are" };
        let given: f64 = levels.iter().filter_map(|(_, width)| *width).sum();
        let rest = pitch - given;
        let open = levels.iter().any(|(_, width)| width.is_none());
        let sum = format!("add up to {} {unit}, {one} {} {unit}", short(given), short(pitch), unit = self.phase_unit);
        if open && rest <= 0.0 {
            let message = format!("`{}` leaves nothing of the pitch for its last step", self.path);
            let help = format!("the widths before it {sum}\nmake them narrower");
            report.add(&last.place, message, "no room for this", help);
            return None;
        }
        if !open && (rest / pitch).abs() > WIDTHS {
            let message = format!("the widths of `{}` do not add up to one pitch", self.path);
            let help = format!("they {sum}\nleave out the last width: it is then the rest");
            let label = if rest > 0.0 { "too narrow together" } else { "too wide together" };
            let width = match &last.value {
                Value::Table(entries) => keys::get(entries, "width"),
                _ => None,
            };
            report.add(&width.unwrap_or(last).place, message, label, help);
            return None;
        }
        let step = |&(value, width): &(f64, Option<f64>)| Step { value, width: width.unwrap_or(rest) };
        Some(Profile::stepping(levels.iter().map(step).collect()))
    }
}

/// Why a law of this role cannot be negative.
pub(super) fn why_not_negative(law: &Law) -> &'static str {
    match law.role {
        Role::Arm => "it is a mean distance from the pitch point",
        _ => "a mesh stiffness is positive or 0",
    }
}

/// The number rounded to twelve significant digits. This hides the rounding errors of sums in messages.
fn short(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}
