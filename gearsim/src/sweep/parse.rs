//! Parses axes such as `start.speed=100 rpm:6000 rpm:200`. Every mistake is reported with its position in the option.

use std::ops::Range;

use crate::model::Model;
use crate::scene::mistake::{Report, list};
use crate::scene::overrides::Setting;
use crate::scene::quantity::{self, Quantity};
use crate::scene::unit_of;

use super::axis::{Axis, Spacing, Values};
use super::distribution::Distribution;
use crate::scene::document::Origin;
use crate::tolerance::scene::SWEEP_POINTS;

/// Help text: the forms of an axis.
const FORMS: &str = "write KEY=A:B:N or KEY=log:A:B:N for N values from A to B, KEY=V1,V2,V3 for a list, \
                     KEY=uniform:A:B, KEY=log-uniform:A:B, KEY=normal:MEAN:DEVIATION or \
                     KEY=normal:MEAN:DEVIATION:A:B for random ones";

/// Parses the axes `texts`, which come `from` options or a program, for a scene of `model`. Mistakes go to `report`.
pub(super) fn axes(texts: &[String], from: Setting, model: &Model, report: &mut Report) -> Vec<Axis> {
    let mut axes: Vec<Axis> = vec![];
    for text in texts {
        let source = report.source(from.source, &format!("{}{text}", from.option));
        let origin = Origin { source, offset: from.option.len() };
        let mut reader = Reader { text, origin, model, report };
        let Some(axis) = reader.axis() else { continue };
        if axes.iter().any(|other| other.key == axis.key) {
            let message = format!("`{}` is varied twice", axis.key);
            reader.add(0..axis.key.len(), message, "again", "write all its values in one axis");
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

    /// One value of a list.
    fn item(&mut self, at: Range<usize>, unit: &str) -> Option<String> {
        let text = &self.text[at.clone()];
        if text.is_empty() {
            self.add(at, "a value of a list is missing", "nothing here", FORMS);
            return None;
        }
        let bare = Quantity::parse(text).is_ok_and(|quantity| quantity.bare && quantity.value != 0.0);
        if bare && !unit.is_empty() {
            self.unitless(at, unit);
            return None;
        }
        Some(text.to_owned())
    }

    fn range(&mut self, key: String, unit: String, fields: &[Range<usize>]) -> Option<Axis> {
        let word = &self.text[fields[0].clone()];
        let (word, numbers) = match word {
            "log" | "uniform" | "log-uniform" | "normal" => (word, &fields[1..]),
            _ => ("", fields),
        };
        let fits = match word {
            "" | "log" => numbers.len() == 3,
            "normal" => matches!(numbers.len(), 2 | 4),
            _ => numbers.len() == 2,
        };
        if !fits {
            let whole = fields[0].start..fields[fields.len() - 1].end;
            let message = format!("not a range of values: {} fields between colons", fields.len());
            self.add(whole, message, "not understood", FORMS);
            return None;
        }
        let (ends, count) = match word {
            "" | "log" => (&numbers[..2], Some(self.count(&numbers[2]))),
            _ => (numbers, None),
        };
        let read: Vec<_> = ends.iter().map(|at| self.end(at)).collect();
        let read: Vec<(f64, String)> = read.into_iter().collect::<Option<_>>()?;
        let whole = ends[0].start..ends[ends.len() - 1].end;
        let (values, unit) = self.in_one_unit(&read, unit, whole.clone())?;
        let spacing = if word.starts_with("log") { Spacing::Logarithmic } else { Spacing::Linear };
        if spacing == Spacing::Logarithmic && !values.iter().all(|&value| value > 0.0) {
            let help = "both ends must be positive: equal ratios never reach 0";
            self.add(whole, "a logarithmic axis with an end that is not positive", "no logarithm", help);
            return None;
        }
        let (low, high) = (values[0], values[1]);
        let values = match (word, count) {
            ("normal", _) => Values::Random(self.normal(&values, ends)?),
            (_, Some(count)) => Values::Range { low, high, spacing, count: count? },
            (_, None) => Values::Random(Distribution::Uniform { low, high, spacing }),
        };
        Some(Axis { key, unit, values })
    }

    /// A normal distribution: mean, standard deviation, and both ends if there are any.
    fn normal(&mut self, values: &[f64], at: &[Range<usize>]) -> Option<Distribution> {
        let (mean, deviation) = (values[0], values[1]);
        if deviation <= 0.0 {
            let help = "write KEY=normal:MEAN:DEVIATION with a positive standard deviation";
            self.add(at[1].clone(), "a standard deviation that is not positive", "not positive", help);
            return None;
        }
        let within = values.get(2).copied().zip(values.get(3).copied());
        if within.is_some_and(|(low, high)| low >= high) {
            let help = "write KEY=normal:MEAN:DEVIATION:A:B with A below B";
            self.add(at[2].start..at[3].end, "an interval whose ends are in the wrong order", "empty", help);
            return None;
        }
        Some(Distribution::Normal { mean, deviation, within })
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

    /// Numbers in one common unit: their own if all have the same, SI if their units differ. A zero needs no unit.
    fn in_one_unit(&mut self, read: &[(f64, String)], of_key: String, at: Range<usize>) -> Option<(Vec<f64>, String)> {
        let with_unit: Vec<&(f64, String)> = read.iter().filter(|(x, unit)| *x != 0.0 || !unit.is_empty()).collect();
        let Some((_, unit)) = with_unit.first() else {
            return Some((read.iter().map(|(x, _)| *x).collect(), of_key));
        };
        if with_unit.iter().all(|(_, other)| other == unit) {
            if unit.is_empty() && !of_key.is_empty() {
                self.unitless(at, &of_key);
                return None;
            }
            return Some((read.iter().map(|(x, _)| *x).collect(), unit.clone()));
        }
        if with_unit.iter().any(|(_, unit)| unit.is_empty()) {
            self.add(
                at,
                "some numbers of the axis have a unit, others have none",
                "different units",
                "write all units",
            );
            return None;
        }
        let parsed = read.iter().map(|(x, unit)| Quantity::parse(&format!("{x:?} {unit}")).ok());
        let parsed: Vec<Quantity> = parsed.collect::<Option<_>>()?;
        let dimension = parsed.iter().find(|quantity| !quantity.bare)?.dimension;
        if parsed.iter().any(|quantity| !quantity.bare && quantity.dimension != dimension) {
            let units: Vec<&str> = with_unit.iter().map(|(_, unit)| unit.as_str()).collect();
            let help = format!("{} have different dimensions", list(&units));
            self.add(at, "the numbers of the axis have different dimensions", "different units", help);
            return None;
        }
        Some((parsed.iter().map(|quantity| quantity.value).collect(), dimension.to_string()))
    }

    /// A number without the unit that its key has. As in a scene, it is refused: nobody can see in which unit it was meant.
    fn unitless(&mut self, at: Range<usize>, unit: &str) {
        let help = format!("write the unit with each number, e.g. \"{}\"", example(&self.text[at.clone()], unit));
        self.add(at, "a number without a unit", "no unit", help);
    }

    fn add(&mut self, at: Range<usize>, message: impl Into<String>, label: &str, help: impl Into<String>) {
        self.report.add(&self.origin.place(at), message, label, help);
    }
}

/// The numbers of `text`, separated by colons, with a unit.
fn example(text: &str, unit: &str) -> String {
    text.split(':').map(|number| format!("{} {unit}", number.trim())).collect::<Vec<_>>().join(":")
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
