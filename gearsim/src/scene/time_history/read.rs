//! Reads a parameter that varies in time, a table instead of a quantity: `T_motor = { ramp = { to = "240 N*m", duration = "1 s" } }`.
//!
//! | key | meaning |
//! | --- | --- |
//! | `steps` | levels; each holds `until` a time, the last one without end |
//! | `ramp` | linear change `from` a value (default 0) `to` a value, beginning at `start` (default 0 s), of length `duration` |
//! | `table` | linear interpolation between points, each `at` a time; constant before the first and after the last |
//! | `mean` | a constant (default 0) |
//! | `harmonics` | added to any of these: a list of `amplitude`, `frequency` and `phase` (default 0) |

use super::{Harmonic, Piece, TimeHistory};
use crate::model::{Model, Parameter};
use crate::scene::document::{Entry, Node, Value};
use crate::scene::mistake::{Report, list};
use crate::scene::{field, keys};
use crate::tolerance::scene::HISTORY_ENTRIES;

/// Keys of the table.
const KEYS: [&str; 5] = ["steps", "ramp", "table", "mean", "harmonics"];

/// Reads `parameter` as a function of time.
pub(in crate::scene) fn read(
    parameter: &Parameter,
    node: &Node,
    model: &Model,
    report: &mut Report,
) -> Option<TimeHistory> {
    let path = format!("parameters.{}", parameter.name);
    if !parameter.varies {
        let can: Vec<_> = model.parameters.iter().filter(|p| p.varies).map(|p| p.name).collect();
        let help = match can[..] {
            [] => "give a number: no parameter of this model can vary in time".to_string(),
            _ => format!("give a number; parameters of this model that can vary in time: {}", list(&can)),
        };
        report.add(&node.place, format!("`{path}` must be a quantity: it cannot vary in time"), "a table", help);
        return None;
    }
    let entries = field::table(&path, node, report)?;
    let reader = HistoryReader { unit: parameter.unit, path, entries, node };
    keys::known(entries, &format!("[{}]", reader.path), &KEYS, report);
    let history = reader.history(report)?;
    reader.finite(history, report)
}

/// Reads one parameter as a function of time.
struct HistoryReader<'a> {
    unit: &'static str,
    /// Key path of the parameter, e.g. `parameters.T_motor`.
    path: String,
    entries: &'a [Entry],
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

    /// Reads quantities of a table, each wanted as (key, unit, required). A quantity that is not given is `None`.
    fn quantities<const K: usize>(
        &self,
        of: &str,
        node: &Node,
        wanted: [(&str, &str, bool); K],
        report: &mut Report,
    ) -> Option<[Option<f64>; K]> {
        let path = format!("{}.{of}", self.path);
        let entries = field::table(&path, node, report)?;
        keys::known(entries, &format!("`{path}`"), &wanted.map(|w| w.0), report);
        let lacking = wanted.iter().filter(|(key, _, needed)| *needed && keys::get(entries, key).is_none());
        let lacking: Vec<_> = lacking.map(|(key, unit, _)| (*key, format!("{key} = \"... {unit}\""))).collect();
        keys::missing(&lacking, &format!("`{path}`"), &node.place, report);
        let read = wanted.map(|(key, unit, _)| match keys::get(entries, key) {
            Some(node) => field::quantity(&format!("{path}.{key}"), node, unit, report).map(Some),
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
            let read = self.quantities(&of, item, [("value", unit, true), ("until", "s", ends)], report);
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
        let wanted =
            [("from", self.unit, false), ("to", self.unit, true), ("start", "s", false), ("duration", "s", true)];
        let [from, to, start, duration] = self.quantities("ramp", node, wanted, report)?;
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
            let read = self.quantities(&of, item, [("at", "s", true), ("value", self.unit, true)], report);
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
            let wanted = [("amplitude", unit, true), ("frequency", "Hz", true), ("phase", "rad", false)];
            let [amplitude, frequency, phase] = self.quantities(&format!("harmonics.{i}"), item, wanted, report)?;
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
        let straight = |p: &Piece| p.slope.is_finite() && p.begin.is_finite();
        if history.pieces.iter().all(straight) && history.harmonics.iter().all(|h| (h.omega * h.omega).is_finite()) {
            return Some(history);
        }
        let message = format!("a slope or frequency of `{}` is too large for a floating-point number", self.path);
        report.add(&self.node.place, message, "overflow", "give times that are further apart, or a lower frequency");
        None
    }
}
