//! Reads a parameter that varies in time, a table instead of a quantity: `T_motor = { ramp = { to = "240 N*m", duration = "1 s" } }`.

use super::{Harmonic, LinearPiece, TimeHistory};
use crate::model::{Model, Parameter};
use crate::scene::document::{KeyEntry, Node, Value};
use crate::scene::keys::{Key, Kind, REQUIRED, key};
use crate::scene::mistake::{Report, list};
use crate::scene::{field, keys};
use crate::tolerance::scene::HISTORY_ENTRIES;

/// Kind of a value of the parameter.
const VALUE: Kind = Kind::ValueIn("unit of the parameter");

/// Keys of the table.
pub(in crate::scene) const KEYS: &[Key] = &[
    key("steps", Kind::List(&Kind::Table(&[STEP])), "none", "levels, one after the other"),
    key("ramp", Kind::Table(&[RAMP]), "none", "a linear change; constant before and after"),
    key("table", Kind::List(&Kind::Table(&[POINT])), "none", "linear interpolation; constant before and after"),
    key("mean", VALUE, "0", "a constant"),
    key("harmonics", Kind::List(&Kind::Table(&[HARMONIC])), "none", "added to any of these"),
];
/// The values of a parameter over time.
pub(in crate::scene) const HISTORY: Kind = Kind::Table(&[KEYS]);
const STEP: &[Key; 2] = &[
    key("value", VALUE, REQUIRED, "the level"),
    key("until", Kind::Quantity("s"), "without end, last level only", "when it ends"),
];
const RAMP: &[Key; 4] = &[
    key("from", VALUE, "0", "value before the ramp"),
    key("to", VALUE, REQUIRED, "value after it"),
    key("start", Kind::Quantity("s"), "0 s", "when it begins"),
    key("duration", Kind::Quantity("s"), REQUIRED, "how long it takes"),
];
const POINT: &[Key; 2] = &[
    key("at", Kind::Quantity("s"), REQUIRED, "a time; times ascend"),
    key("value", VALUE, REQUIRED, "the value then"),
];
/// Keys of a harmonic: amplitude cos(2 pi frequency t + phase).
const HARMONIC: &[Key; 3] = &[
    key("amplitude", VALUE, REQUIRED, "amplitude"),
    key("frequency", Kind::Quantity("Hz"), REQUIRED, "frequency"),
    key("phase", Kind::Quantity("rad"), "0 rad", "phase of the cosine"),
];

/// Reads `parameter` as a function of time.
pub(in crate::scene) fn read(
    parameter: &Parameter,
    node: &Node,
    model: &Model,
    report: &mut Report,
) -> Option<TimeHistory> {
    let path = format!("parameters.{}", parameter.name);
    if !parameter.varies.may() {
        let can: Vec<_> = model.parameters.iter().filter(|p| p.varies.may()).map(|p| p.name).collect();
        let help = match can[..] {
            [] => "give a number: no parameter of this model can vary in time".to_string(),
            _ => format!("give a number; parameters of this model that can vary in time: {}", list(&can)),
        };
        report.add(&node.place, format!("`{path}` must be a quantity: it cannot vary in time"), "a table", help);
        return None;
    }
    let entries = field::table(&path, node, report)?;
    let reader = HistoryReader { unit: parameter.unit, path, entries, node };
    keys::known(entries, &format!("[{}]", reader.path), &[KEYS], report);
    let history = reader.history(report)?;
    reader.finite(history, report)
}

/// Reads one parameter as a function of time.
struct HistoryReader<'a> {
    unit: &'static str,
    /// Key path of the parameter, e.g. `parameters.T_motor`.
    path: String,
    entries: &'a [KeyEntry],
    node: &'a Node,
}

impl HistoryReader<'_> {
    fn history(&self, report: &mut Report) -> Option<TimeHistory> {
        let get = |key| keys::get(self.entries, key);
        let harmonics = match get("harmonics") {
            Some(node) => self.harmonics(node, report),
            None => Some(vec![]),
        };
        let forms = ["steps", "ramp", "table", "mean"].map(|key| (key, get(key)));
        let mut given = forms.into_iter().filter_map(|(key, node)| Some((key, node?)));
        let (first, second) = (given.next(), given.next());
        if let (Some((a, _)), Some((b, node))) = (first, second) {
            let message = format!("`{}` has both {a} and {b}", self.path);
            let help = "give only one of steps, ramp, table and mean; harmonics may be added to each of them";
            report.add(&node.place, message, "one too many", help);
            return None;
        }
        let history = match first {
            Some(("steps", node)) => self.steps(node, report),
            Some(("ramp", node)) => self.ramp(node, report),
            Some(("table", node)) => self.table(node, report),
            Some((_, node)) => {
                self.quantity("mean", node, self.unit, report).map(|mean| TimeHistory::steps(&[(mean, None)]))
            }
            None if get("harmonics").is_some() => Some(TimeHistory::steps(&[(0.0, None)])),
            None => {
                let unit = self.unit;
                let help = format!(
                    "write one of\nsteps = [{{ value = \"... {unit}\", until = \"... s\" }}, {{ value = \"... {unit}\" }}]\n\
                     ramp = {{ from = \"... {unit}\", to = \"... {unit}\", start = \"... s\", duration = \"... s\" }}\n\
                     table = [{{ at = \"... s\", value = \"... {unit}\" }}, ...]\n\
                     mean = \"... {unit}\"\nand, to add oscillations,\n\
                     harmonics = [{{ amplitude = \"... {unit}\", frequency = \"... Hz\", phase = \"... rad\" }}]"
                );
                report.add(&self.node.place, format!("`{}` has no values", self.path), "no values", help);
                None
            }
        };
        Some(history?.with(harmonics?))
    }

    fn quantity(&self, key: &str, node: &Node, unit: &str, report: &mut Report) -> Option<f64> {
        field::quantity(&format!("{}.{key}", self.path), node, unit, report)
    }

    fn items<'a>(&self, key: &str, node: &'a Node, example: &str, report: &mut Report) -> Option<&'a [Node]> {
        let path = format!("{}.{key}", self.path);
        let items = field::array(&path, node, example, report)?;
        if !(1..=HISTORY_ENTRIES).contains(&items.len()) {
            let message = format!("`{path}` has {} entries", items.len());
            let help = format!("give from 1 to {HISTORY_ENTRIES}, for example {example}");
            report.add(&node.place, message, "too few or too many", help);
            return None;
        }
        Some(items)
    }

    /// Reads the quantities of a table with the keys `all`. The required keys and those in `needed` must be there. A key that is not given
    /// is `None`.
    fn quantities<const K: usize>(
        &self,
        of: &str,
        node: &Node,
        all: &[Key; K],
        needed: &[&str],
        report: &mut Report,
    ) -> Option<[Option<f64>; K]> {
        let path = format!("{}.{of}", self.path);
        let entries = field::table(&path, node, report)?;
        keys::known(entries, &format!("`{path}`"), &[all], report);
        let unit = |key: &Key| if let Kind::Quantity(unit) = key.kind { unit } else { self.unit };
        let needed = |key: &&Key| key.default == REQUIRED || needed.contains(&key.name);
        let lacking = all.iter().filter(needed).filter(|key| keys::get(entries, key.name).is_none());
        let lacking: Vec<_> = lacking.map(|key| (key.name, format!("{} = \"... {}\"", key.name, unit(key)))).collect();
        keys::missing(&lacking, &format!("`{path}`"), &node.place, report);
        let read = all.map(|key| match keys::get(entries, key.name) {
            Some(node) => field::quantity(&format!("{path}.{}", key.name), node, unit(&key), report).map(Some),
            None => Some(None),
        });
        let whole = lacking.is_empty() && read.iter().all(Option::is_some);
        whole.then(|| read.map(Option::flatten))
    }

    /// Reports the entry `what` if its time does not ascend (`rises` is false).
    fn ordered(&self, what: &str, node: &Node, rises: bool, report: &mut Report) -> Option<()> {
        if !rises {
            let message = format!("`{}.{what}` is out of order", self.path);
            report.add(&node.place, message, "misplaced", "times must ascend, and the run starts at 0 s");
        }
        rises.then_some(())
    }

    fn steps(&self, node: &Node, report: &mut Report) -> Option<TimeHistory> {
        let unit = self.unit;
        let example = format!("[{{ value = \"... {unit}\", until = \"... s\" }}, {{ value = \"... {unit}\" }}]");
        let items = self.items("steps", node, &example, report)?;
        let (mut levels, mut last, mut sound) = (vec![], 0.0, true);
        for (i, item) in items.iter().enumerate() {
            let (of, ends) = (format!("steps.{i}"), i + 1 < items.len());
            let read = self.quantities(&of, item, STEP, if ends { &["until"] } else { &[] }, report);
            let Some([Some(value), until]) = read else {
                sound = false;
                continue;
            };
            if let Some(until) = until.filter(|_| !ends) {
                let message = format!("`{}.{of}` ends at {until} s, and nothing follows", self.path);
                report.add(&item.place, message, "the last", "the last step has no end: leave out its `until`");
                sound = false;
            } else if let Some(until) = until {
                sound &= self.ordered(&of, item, until > last, report).is_some();
                last = until;
            }
            levels.push((value, until));
        }
        sound.then(|| TimeHistory::steps(&levels))
    }

    fn ramp(&self, node: &Node, report: &mut Report) -> Option<TimeHistory> {
        let [from, to, start, duration] = self.quantities("ramp", node, RAMP, &[], report)?;
        let (from, start) = (from.unwrap_or(0.0), start.unwrap_or(0.0));
        let (to, duration) = (to?, duration?);
        let path = format!("{}.ramp", self.path);
        let negative = |key: &str, must: &str, what: &str, report: &mut Report| {
            if let Value::Table(entries) = &node.value
                && let Some(node) = keys::get(entries, key)
            {
                field::out_of_range(&format!("{path}.{key}"), node, must, what, report);
            }
            None
        };
        if start < 0.0 {
            return negative("start", "must not be negative", "the run starts at 0 s", report);
        }
        if duration <= 0.0 {
            return negative("duration", "must be positive", "for a jump, use `steps`", report);
        }
        Some(TimeHistory::table(&[(start, from), (start + duration, to)]))
    }

    fn table(&self, node: &Node, report: &mut Report) -> Option<TimeHistory> {
        let example = format!("[{{ at = \"0 s\", value = \"... {}\" }}, ...]", self.unit);
        let items = self.items("table", node, &example, report)?;
        let (mut points, mut sound): (Vec<(f64, f64)>, bool) = (vec![], true);
        for (i, item) in items.iter().enumerate() {
            let of = format!("table.{i}");
            let read = self.quantities(&of, item, POINT, &[], report);
            let Some([Some(at), Some(value)]) = read else {
                sound = false;
                continue;
            };
            let rises = at >= 0.0 && points.last().is_none_or(|last| at > last.0);
            sound &= self.ordered(&of, item, rises, report).is_some();
            points.push((at, value));
        }
        sound.then(|| TimeHistory::table(&points))
    }

    fn harmonics(&self, node: &Node, report: &mut Report) -> Option<Vec<Harmonic>> {
        let unit = self.unit;
        let example = format!("[{{ amplitude = \"... {unit}\", frequency = \"... Hz\", phase = \"0 rad\" }}]");
        let items = self.items("harmonics", node, &example, report)?;
        let each = items.iter().enumerate().map(|(i, item)| {
            let read = self.quantities(&format!("harmonics.{i}"), item, HARMONIC, &[], report);
            let [amplitude, frequency, phase] = read?;
            if frequency? <= 0.0 {
                let message = format!("the frequency of `{}.harmonics.{i}` must be positive", self.path);
                report.add(&item.place, message, "not an oscillation", "a constant part belongs to `mean`");
                return None;
            }
            Some(Harmonic::new(amplitude?, frequency?, phase.unwrap_or(0.0)))
        });
        each.collect::<Vec<_>>().into_iter().collect()
    }

    /// Returns `history` if its slopes, times and squared angular frequencies are finite.
    fn finite(&self, history: TimeHistory, report: &mut Report) -> Option<TimeHistory> {
        let straight = |p: &LinearPiece| p.slope.is_finite() && p.begin.is_finite();
        if history.pieces.iter().all(straight) && history.harmonics.iter().all(|h| (h.omega * h.omega).is_finite()) {
            return Some(history);
        }
        let message = format!("a slope or frequency of `{}` is too large for a floating-point number", self.path);
        report.add(&self.node.place, message, "overflow", "give times that are further apart, or a lower frequency");
        None
    }
}
