//! Smooth laws: ramps instead of steps, a Fourier series, or a spline through a table.

use super::document::{KeyEntry, Node, Place};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::{field, keys, laws, transmission_error};
use crate::model::{Law, Role};
use crate::profile::{Curve, Profile};
use crate::tolerance::scene::{HARMONIC_ORDER, TABLE_POINTS};

/// Keys of smooth laws.
pub(super) const KEYS: &[Key] = &[
    key("ramp", laws::PHASE, "none: steps", "replaces each step by a straight ramp of this width, centred on the step"),
    key("mean", laws::VALUE, "required by a stiffness with harmonics, else 0", "mean of a Fourier series"),
    key("harmonics", Kind::List(&Kind::Table(&[HARMONIC])), "none", "a Fourier series over the period of the law"),
    key("table", Kind::List(&Kind::Table(&[POINT])), "none", "a periodic cubic spline through at least 3 points"),
];
/// Keys of a harmonic: amplitude cos(order 2 pi s/period + phase).
const HARMONIC: &[Key] = &[
    key("order", Kind::Number, REQUIRED, "number of waves in one period of the law"),
    key("amplitude", laws::VALUE, REQUIRED, "amplitude"),
    key("phase", Kind::Quantity("rad"), "0 rad", "phase of the cosine"),
];
/// Keys of a point of a table.
const POINT: &[Key] = &[
    key("at", laws::PHASE, REQUIRED, "where in the period; points ascend from 0"),
    key("value", laws::VALUE, REQUIRED, "the value there"),
];

/// Reads the keys of a smooth law.
pub(super) struct SmoothLaw<'a> {
    pub(super) law: &'a Law,
    /// Unit of the phase.
    pub(super) phase_unit: &'static str,
    /// Period of the law: one or more pitches [unit of the phase].
    pub(super) length: f64,
    /// The table of the law.
    pub(super) entries: &'a [KeyEntry],
    pub(super) place: &'a Place,
}

impl SmoothLaw<'_> {
    /// Reads a law given by a series or a table. `None` if it has neither, `Some(None)` if a mistake was found.
    pub(super) fn instead_of_steps(&self, report: &mut Report) -> Option<Option<Profile>> {
        let get = |key| keys::get(self.entries, key);
        let series = get("harmonics").or(get("mean"));
        let (steps, table) = (get("steps"), get("table"));
        let (teeth, pitch_errors) = (get("teeth"), get(transmission_error::OF_TEETH));
        let forms = [
            ("steps", steps),
            ("harmonics", series),
            ("table", table),
            ("teeth", teeth),
            (transmission_error::OF_TEETH, pitch_errors),
        ];
        let mut given = forms.iter().filter_map(|(name, node)| Some((*name, (*node)?)));
        let (first, second) = (given.next(), given.next());
        if let (Some((a, _)), Some((b, node))) = (first, second) {
            let message = format!("`laws.{}` has both {a} and {b}", self.law.name);
            let teeth = if self.law.role == Role::Error { transmission_error::OF_TEETH } else { "teeth" };
            let help = format!("a law is one of steps, a series, a table, or {teeth}");
            report.add(&node.place, message, "one too many", help);
            return Some(None);
        }
        let curved = series.is_some() || table.is_some();
        if let Some(node) = get("ramp").filter(|_| curved) {
            let message = format!("`laws.{}.ramp` has no steps to join", self.law.name);
            report.add(&node.place, message, "out of place", "leave it out, or give steps");
            return Some(None);
        }
        let read = match (series, table) {
            (Some(_), _) => self.series(report),
            (_, Some(node)) => self.table(node, report),
            _ => return None,
        };
        Some(read.and_then(|stiffness| self.refuse_negative(stiffness, report)))
    }

    /// Replaces the steps of a piecewise constant law by ramps if the scene gives `ramp`.
    pub(super) fn ramped(&self, stepping: Profile, report: &mut Report) -> Option<Profile> {
        let Some(node) = keys::get(self.entries, "ramp") else { return Some(stepping) };
        let path = format!("laws.{}.ramp", self.law.name);
        if !stepping.steps_only() {
            report.add(
                &node.place,
                format!("`{path}` joins levels, and this law has none"),
                "out of place",
                "leave it out: only steps can be joined by ramps",
            );
            return None;
        }
        let width = field::quantity(&path, node, self.phase_unit, report)?;
        if width <= 0.0 {
            field::out_of_range(&path, node, "must be positive", "leave it out for steps", report);
            return None;
        }
        let ramped = stepping.ramped(width, 0.5);
        if ramped.is_none() {
            let narrowest = stepping.steps.iter().map(|step| step.width).fold(f64::INFINITY, f64::min);
            let must = format!(
                "must be narrower than every level, the narrowest of which has {narrowest:.6} {}",
                self.phase_unit
            );
            field::out_of_range(&path, node, &must, "a ramp is centred on its step", report);
        }
        ramped
    }

    fn series(&self, report: &mut Report) -> Option<Profile> {
        let name = self.law.name;
        let unit = self.law.unit;
        let (mean, harmonics) = (keys::get(self.entries, "mean"), keys::get(self.entries, "harmonics"));
        let example = format!("[{{ order = 1, amplitude = \"... {unit}\", phase = \"0 rad\" }}]");
        let lines = [
            // The mean may be left out where it is usually 0: for a transmission error and for a side.
            ("mean", mean.is_none() && !self.law.role.has_sign(), format!("mean = \"... {unit}\"")),
            ("harmonics", harmonics.is_none(), format!("harmonics = {example}")),
        ];
        let lacking: Vec<_> = lines.into_iter().filter(|line| line.1).map(|(key, _, line)| (key, line)).collect();
        keys::missing(&lacking, &format!("[laws.{name}]"), self.place, report);
        let mean = match mean {
            Some(node) => field::quantity(&format!("laws.{name}.mean"), node, unit, report),
            None => self.law.role.has_sign().then_some(0.0),
        };
        let path = format!("laws.{name}.harmonics");
        let items = field::array(&path, harmonics?, &example, report)?;
        let each = items.iter().enumerate().map(|(i, node)| self.harmonic(&format!("{path}.{i}"), node, report));
        let harmonics: Vec<_> = each.collect::<Vec<_>>().into_iter().collect::<Option<_>>()?;
        let period = self.length;
        Some(Profile::curved(vec![(Curve::Fourier { mean: mean?, harmonics, period }, period)]))
    }

    fn harmonic(&self, path: &str, node: &Node, report: &mut Report) -> Option<(f64, f64, f64)> {
        let entries = field::table(path, node, report)?;
        keys::known(entries, &format!("`{path}`"), &[HARMONIC], report);
        let get = |key| keys::get(entries, key);
        let lines =
            [("order", "order = 1".to_string()), ("amplitude", format!("amplitude = \"... {}\"", self.law.unit))];
        let lacking: Vec<_> = lines.into_iter().filter(|(key, _)| get(key).is_none()).collect();
        keys::missing(&lacking, &format!("`{path}`"), &node.place, report);
        let order = get("order").and_then(|node| {
            let path = format!("{path}.order");
            let order = field::quantity(&path, node, "1", report)?;
            if order.fract() != 0.0 || !(1.0..=HARMONIC_ORDER).contains(&order) {
                let must = format!("must be a whole number from 1 to {HARMONIC_ORDER}");
                field::out_of_range(&path, node, &must, "it counts the waves in one period of the law", report);
                return None;
            }
            Some(order)
        });
        let of = |key: &str, unit: &str, report: &mut Report| {
            let node = keys::get(entries, key)?;
            field::quantity(&format!("{path}.{key}"), node, unit, report)
        };
        let amplitude = of("amplitude", self.law.unit, report);
        let phase = if get("phase").is_some() { of("phase", "rad", report) } else { Some(0.0) };
        Some((order?, amplitude?, phase?))
    }

    fn table(&self, node: &Node, report: &mut Report) -> Option<Profile> {
        let path = format!("laws.{}.table", self.law.name);
        let (unit, phase) = (self.law.unit, self.phase_unit);
        let example = format!("[{{ at = \"0 {phase}\", value = \"... {unit}\" }}, ...]");
        let items = field::array(&path, node, &example, report)?;
        if !(3..=TABLE_POINTS).contains(&items.len()) {
            let message = format!("`{path}` has {} points", items.len());
            let help = format!("a spline takes from 3 to {TABLE_POINTS}: {example}");
            report.add(&node.place, message, "too few or too many", help);
            return None;
        }
        let mut points: Vec<(f64, f64)> = vec![];
        let mut wrong = false;
        for (i, item) in items.iter().enumerate() {
            let Some(point) = self.point(&format!("{path}.{i}"), item, report) else {
                wrong = true;
                continue;
            };
            let inside = (0.0..self.length).contains(&point.0);
            if !inside || points.last().is_some_and(|last| last.0 >= point.0) {
                let message = format!("`{path}.{i}` is out of order");
                let help =
                    format!("points must ascend from 0 to less than the period of the law, {:.6} {phase}", self.length);
                report.add(&item.place, message, "misplaced", help);
                wrong = true;
            }
            points.push(point);
        }
        if wrong { None } else { Profile::spline(&points, self.length) }
    }

    fn point(&self, path: &str, node: &Node, report: &mut Report) -> Option<(f64, f64)> {
        let entries = field::table(path, node, report)?;
        keys::known(entries, &format!("`{path}`"), &[POINT], report);
        let units = [("at", self.phase_unit), ("value", self.law.unit)];
        let lacking = units.iter().filter(|(key, _)| keys::get(entries, key).is_none());
        let lacking: Vec<_> = lacking.map(|(key, unit)| (*key, format!("{key} = \"... {unit}\""))).collect();
        keys::missing(&lacking, &format!("`{path}`"), &node.place, report);
        let [at, value] = units.map(|(key, unit)| {
            keys::get(entries, key).and_then(|node| field::quantity(&format!("{path}.{key}"), node, unit, report))
        });
        Some((at?, value?))
    }

    /// Reports a law that is negative somewhere although it must not be.
    fn refuse_negative(&self, stiffness: Profile, report: &mut Report) -> Option<Profile> {
        let least = stiffness.extremes().0;
        if least >= 0.0 || self.law.role.has_sign() {
            return Some(stiffness);
        }
        let message = format!("`laws.{}` falls to {least:.4e} {}", self.law.name, self.law.unit);
        let help = "raise the mean, reduce the amplitudes, or give more points";
        let help = format!("{}: {help}", laws::why_not_negative(self.law));
        report.add(self.place, message, "negative in a part of the pitch", help);
        None
    }
}
