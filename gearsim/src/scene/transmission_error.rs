//! The period of a law in pitches, and the scene key of transmission errors alone: the pitch errors of the teeth.

use super::document::{KeyEntry, Node, Value};
use super::keys::{Key, Kind, key};
use super::mistake::Report;
use super::{field, keys};
use crate::model::{Law, Role};
use crate::profile::{Profile, Step};
use crate::tolerance::scene::LAW_PITCHES;

/// Key of the pitch errors of the teeth: one level a pitch.
pub(super) const OF_TEETH: &str = "pitch_errors";
/// Keys that only transmission errors have.
pub(super) const KEYS: &[Key] = &[key(
    OF_TEETH,
    Kind::List(&Kind::ValueIn("unit of the law")),
    "none",
    "one level a pitch: the errors of the teeth",
)];

/// Number of pitches in one period of the law: the value of `pitches`, or the number of pitch errors, or 1.
pub(super) fn pitches(law: &Law, entries: &[KeyEntry], report: &mut Report) -> Option<u32> {
    let of_teeth = keys::get(entries, OF_TEETH).filter(|_| law.role == Role::Error);
    match (keys::get(entries, "pitches"), of_teeth) {
        (Some(node), Some(_)) => {
            let message = format!("`laws.{0}` has both pitches and {OF_TEETH}", law.name);
            report.add(&node.place, message, "one too many", format!("leave it out: {OF_TEETH} has one error a pitch"));
            None
        }
        (Some(node), None) => {
            let path = format!("laws.{}.pitches", law.name);
            let count = field::quantity(&path, node, "1", report)?;
            if count.fract() != 0.0 || !(1.0..=LAW_PITCHES).contains(&count) {
                let must = format!("must be a whole number from 1 to {LAW_PITCHES}");
                let what = "the law repeats after this number of pitches, e.g. the number of teeth of a gear";
                field::out_of_range(&path, node, &must, what, report);
                return None;
            }
            Some(count as u32)
        }
        (None, Some(Node { value: Value::Array(errors), .. })) => {
            Some(errors.len().clamp(1, LAW_PITCHES as usize) as u32)
        }
        (None, _) => Some(1),
    }
}

/// The law of `pitch_errors`: one level a pitch.
pub(super) fn of_teeth(law: &Law, node: &Node, report: &mut Report) -> Option<Profile> {
    let path = format!("laws.{}.{OF_TEETH}", law.name);
    let example = format!("[\"0 {0}\", \"... {0}\"]", law.unit);
    let items = field::array(&path, node, &example, report)?;
    if items.is_empty() || items.len() > LAW_PITCHES as usize {
        let help = format!("write one error a tooth, up to {LAW_PITCHES}, for example {example}");
        report.add(&node.place, format!("`{path}` has {} errors", items.len()), "too few or too many", help);
        return None;
    }
    let error = |(i, node)| field::quantity(&format!("{path}.{i}"), node, law.unit, report);
    let levels: Vec<_> = items.iter().enumerate().map(error).collect();
    let levels: Vec<_> = levels.into_iter().collect::<Option<_>>()?;
    Some(Profile::stepping(levels.into_iter().map(|value| Step { value, width: law.period }).collect()))
}
