//! Parses axes such as `start.speed=100 rpm:6000 rpm:200`. Every mistake is reported with its position in the option.

use std::ops::Range;

use crate::model::Model;
use crate::scene::mistake::{Report, list};
use crate::scene::quantity::{self, Quantity};
use crate::scene::unit_of;

use super::axis::{Axis, Spacing, Values};
use crate::scene::document::Origin;
use crate::tolerance::scene::SWEEP_POINTS;

/// Text put before an axis when a message quotes it.
const OPTION: &str = "--vary ";
/// Help text: the forms of an axis.
const FORMS: &str = "write KEY=A:B:N or KEY=log:A:B:N for N values from A to B, KEY=V1,V2,V3 for a list, \
                     KEY=uniform:A:B or KEY=log-uniform:A:B for random ones";

/// Parses the values `texts` of the options `--vary`, for a scene of `model`. Mistakes go to `report`.
pub(super) fn axes(texts: &[String], model: &Model, report: &mut Report) -> Vec<Axis> {
    let mut axes: Vec<Axis> = vec![];
    for text in texts {
        let source = report.source("command line", &format!("{OPTION}{text}"));
        let origin = Origin { source, offset: OPTION.len() };
        let mut reader = Reader { text, origin, model, report };
        let Some(axis) = reader.axis() else { continue };
        if axes.iter().any(|other| other.key == axis.key) {
            let message = format!("`{}` is varied twice", axis.key);
            reader.add(0..axis.key.len(), message, "again", "write all its values in one --vary");
        }
        axes.push(axis);
    }
    axes
}

/// The parser of one axis.
struct Reader<'a> {
    text: &'a str,
    origin: Origin,
    model: &'a Model,
    report: &'a mut Report,
}

impl Reader<'_> {
    fn axis(&mut self) -> Option<Axis> {
        let Some(equals) = self.text.find('=') else {
            self.add(0..self.text.len(), "an axis without values", "no `=` here", FORMS);
            return None;
        };
        let key = self.text[..equals].trim().to_owned();
        if key.is_empty() || key == "model" {
            let help = "write the key of a value as in the scene file, with its tables: parameters.T0, start.speed";
            self.add(0..equals.max(1), "an axis without a valid key", "cannot be varied", help);
            return None;
        }
        let unit = unit_of(&key, self.model).filter(|unit| unit != "1").unwrap_or_default();
        let all = equals + 1..self.text.len();
        let listed = self.text[all.clone()].trim_start().starts_with(['[', '"', '\'', '{']);
        let fields = split(self.text, all.clone(), ':');
        if !listed && fields.len() > 1 {
            return self.range(key, unit, &fields);
        }
        let values = split(self.text, all, ',').into_iter().map(|item| self.item(item, &unit));
        // Parse all items before the first failure is returned, so that every mistake is reported.
        let values: Vec<_> = values.collect();
        Some(Axis { key, unit: String::new(), values: Values::List(values.into_iter().collect::<Option<_>>()?) })
    }

    /// One value of a list. A number without a unit gets the unit of the key.
    fn item(&mut self, at: Range<usize>, unit: &str) -> Option<String> {
        let text = &self.text[at.clone()];
        if text.is_empty() {
            self.add(at, "a value of a list is missing", "nothing here", FORMS);
            return None;
        }
        let bare = Quantity::parse(text).is_ok_and(|quantity| quantity.bare);
        Some(if bare && !unit.is_empty() { format!("{text} {unit}") } else { text.to_owned() })
    }

    fn range(&mut self, key: String, unit: String, fields: &[Range<usize>]) -> Option<Axis> {
        let word = &self.text[fields[0].clone()];
        let (spacing, random, ends) = match word {
            "log" => (Spacing::Logarithmic, false, &fields[1..]),
            "uniform" => (Spacing::Linear, true, &fields[1..]),
            "log-uniform" => (Spacing::Logarithmic, true, &fields[1..]),
            _ => (Spacing::Linear, false, fields),
        };
        if ends.len() != if random { 2 } else { 3 } {
            let whole = fields[0].start..fields[fields.len() - 1].end;
            let message = format!("not a range of values: {} fields between colons", fields.len());
            self.add(whole, message, "not understood", FORMS);
            return None;
        }
        let (low, high) = (self.end(&ends[0]), self.end(&ends[1]));
        let count = match ends.get(2) {
            Some(at) => Some(self.count(at)?),
            None => None,
        };
        let (low, high) = (low?, high?);
        let whole = ends[0].start..ends[1].end;
        let (low, high, unit) = self.in_one_unit(low, high, unit, whole.clone())?;
        if spacing == Spacing::Logarithmic && !(low > 0.0 && high > 0.0) {
            let help = "both ends must be positive: equal ratios never reach 0";
            self.add(whole, "a logarithmic axis with an end that is not positive", "no logarithm", help);
            return None;
        }
        Some(Axis { key, unit, values: Values::Range { low, high, spacing, count } })
    }

    /// An end of a range: its number and its unit.
    fn end(&mut self, at: &Range<usize>) -> Option<(f64, String)> {
        let text = self.text;
        match quantity::split(&text[at.clone()]) {
            Ok((number, unit)) if number.is_finite() => Some((number, unit.to_owned())),
            Ok(_) => {
                self.add(at.clone(), "an end of the axis is not a finite number", "not finite", "give a finite value");
                None
            }
            Err(error) => {
                let place = at.start + error.span.start..(at.start + error.span.end).max(at.start + 1);
                let message = format!("an end of the axis cannot be read: {}", error.message);
                self.add(place, message, "not understood", error.help);
                None
            }
        }
    }

    fn count(&mut self, at: &Range<usize>) -> Option<usize> {
        let found = self.text[at.clone()].parse::<usize>().ok().filter(|n| (2..=SWEEP_POINTS).contains(n));
        if found.is_none() {
            let message = format!("`{}` is not a valid number of values", &self.text[at.clone()]);
            let help = format!("write a whole number from 2 to {SWEEP_POINTS}; for a single value, write KEY=VALUE");
            self.add(at.clone(), message, "how many?", help);
        }
        found
    }

    /// The ends in one common unit: their own unit if both have the same, SI if the units differ, the unit of the key if neither has one.
    fn in_one_unit(
        &mut self,
        low: (f64, String),
        high: (f64, String),
        unit: String,
        at: Range<usize>,
    ) -> Option<(f64, f64, String)> {
        if low.1 == high.1 {
            return Some((low.0, high.0, if low.1.is_empty() { unit } else { low.1 }));
        }
        // A zero needs no unit: it takes that of the other end.
        match (&low, &high) {
            ((x, none), (_, unit)) | ((_, unit), (x, none)) if *x == 0.0 && none.is_empty() => {
                return Some((low.0, high.0, unit.clone()));
            }
            _ => {}
        }
        let parse = |end: &(f64, String)| Quantity::parse(&format!("{:?} {}", end.0, end.1)).ok();
        let (a, b) = (parse(&low)?, parse(&high)?);
        if a.dimension == b.dimension && !a.bare && !b.bare {
            return Some((a.value, b.value, a.dimension.to_string()));
        }
        let (message, help) = match a.bare || b.bare {
            true => ("one end of the axis has a unit, the other has none", "write the unit of both".to_owned()),
            false => {
                let both = [low.1.as_str(), high.1.as_str()];
                ("the ends of the axis have different dimensions", format!("{} have different dimensions", list(&both)))
            }
        };
        self.add(at, message, "different units", help);
        None
    }

    fn add(&mut self, at: Range<usize>, message: impl Into<String>, label: &str, help: impl Into<String>) {
        self.report.add(&self.origin.place(at), message, label, help);
    }
}

/// Splits `text[within]` at every `separator` outside brackets and quotes. Returns the pieces without surrounding blanks.
fn split(text: &str, within: Range<usize>, separator: char) -> Vec<Range<usize>> {
    let (mut pieces, mut begin, mut depth, mut quote) = (vec![], within.start, 0_usize, None);
    let trimmed = |begin: usize, end: usize| {
        let piece = &text[begin..end];
        let start = begin + piece.len() - piece.trim_start().len();
        start..start + piece.trim().len()
    };
    for (i, c) in text[within.clone()].char_indices() {
        match (quote, c) {
            (Some(q), _) => quote = (c != q).then_some(q),
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            (None, _) if c == separator && depth == 0 => {
                pieces.push(trimmed(begin, within.start + i));
                begin = within.start + i + c.len_utf8();
            }
            _ => {}
        }
    }
    pieces.push(trimmed(begin, within.end));
    pieces
}
