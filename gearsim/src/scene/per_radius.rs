//! Inertias and torsional stiffnesses as papers on planetaries print them: I/r² [kg], k/r² [N/m], c/r² [N s/m], with u = r theta as
//! coordinate (Kahraman 1994; Lin & Parker 1999).
//!
//! The unit of a value decides: `I_s = "0.39 kg"` is I_s/r², `I_s = "5.8e-4 kg*m^2"` is I_s. The radius is the base radius of the gear, and
//! for a carrier the radius of the circle of the planets' centres, r_s (Z_r + Z_s)/(2 Z_s cos alpha). Where there is no such radius, or
//! another one is meant, the value names it: `I_c = { value = "6.29 kg", radius = "88.4 mm" }`, or the name of a parameter.

use super::document::{Node, Value};
use super::keys::{self, Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::quantity::Quantity;
use super::unit::Unit;
use super::{field, gear_data};
use crate::model::{GearData, Model, Parameter};

/// Keys of a value with its radius.
pub(super) const KEYS: &[Key] = &[
    key(
        "value",
        Kind::ValueIn("unit of the parameter over m^2"),
        REQUIRED,
        "an inertia I/r^2, a stiffness k/r^2, a damping c/r^2",
    ),
    key(
        "radius",
        Kind::Either(&[Kind::Quantity("m"), Kind::Name("a parameter that is a radius")]),
        "base radius of the gear, circle of the planets' centres of a carrier",
        "the radius r",
    ),
];

/// Units of parameters that may be given per squared radius, and their units then.
const UNITS: [(&str, &str); 3] = [("kg*m^2", "kg"), ("N*m/rad", "N/m"), ("N*m*s/rad", "N*s/m")];

/// The radii of the parameters of a scene.
pub(super) trait Radii {
    /// The radius to which values of this parameter refer [m], or a text that says what is missing. `value` gives the value of another
    /// parameter.
    fn radius(&self, parameter: &Parameter, value: &dyn Fn(&str) -> Option<f64>) -> Result<f64, String>;
}

/// The radii of a derived model, by the names of its parameters: `I_s` is of the gear with the base radius `r_s`.
pub(super) struct OfModel<'a>(pub &'a Model);

impl Radii for OfModel<'_> {
    fn radius(&self, parameter: &Parameter, value: &dyn Fn(&str) -> Option<f64>) -> Result<f64, String> {
        let of_body = parameter.unit == UNITS[0].0 || parameter.gear_data == Some(GearData::Support);
        let gear = parameter.name.trim_start_matches(|c: char| c.is_alphabetic());
        let found = of_body.then(|| gear_data::radius(self.0, gear, value)).flatten();
        found.ok_or_else(|| format!("no gear with a base radius belongs to `{}`", parameter.name))
    }
}

/// A value per squared radius, as written.
pub(super) struct PerRadius<'a> {
    parameter: &'a Parameter,
    /// The value [SI].
    value: f64,
    /// Its unit.
    unit: &'static str,
    radius: Option<&'a Node>,
    node: &'a Node,
}

impl<'a> PerRadius<'a> {
    /// The value of `parameter` if it is one per squared radius; `Some(None)` if it has a mistake.
    pub(super) fn read(parameter: &'a Parameter, node: &'a Node, report: &mut Report) -> Option<Option<PerRadius<'a>>> {
        let (_, unit) = UNITS.iter().find(|(full, _)| *full == parameter.unit)?;
        let path = format!("parameters.{}", parameter.name);
        let Value::Table(entries) = &node.value else {
            return fits(node, unit).then(|| {
                let value = field::quantity(&path, node, unit, report)?;
                Some(PerRadius { parameter, value, unit, radius: None, node })
            });
        };
        let given = keys::get(entries, "value")?;
        keys::known(entries, &format!("`{path}`"), &[KEYS], report);
        let radius = keys::get(entries, "radius");
        if radius.is_some() && fits(given, parameter.unit) {
            let message = format!("`{path}.value` is in {}, and has a radius", parameter.unit);
            let help = format!("leave out the radius, or give the value over its square, in {unit}");
            report.add(&given.place, message, "not per squared radius", help);
            return Some(None);
        }
        let value = field::quantity(&format!("{path}.value"), given, unit, report);
        Some(value.map(|value| PerRadius { parameter, value, unit, radius, node: given }))
    }

    /// The value of the parameter [SI], and a sentence that states it. `value` has those of the other parameters.
    pub(super) fn convert(
        &self,
        model: &Model,
        radii: &dyn Radii,
        value: &dyn Fn(&str) -> Option<f64>,
        report: &mut Report,
    ) -> Option<(f64, String)> {
        let name = self.parameter.name;
        let radius = match self.radius {
            Some(node) => self.named(node, model, value, report)?,
            None => radii
                .radius(self.parameter, value)
                .map_err(|lacks| {
                    let message = format!("`parameters.{name}` is given in {}, but {lacks}", self.unit);
                    let key = match report.stated.key(&format!("parameters.{name}")) {
                        Some(key) if key.starts_with("rotors.") => "inertia",
                        Some(key) => key.rsplit('.').next().unwrap_or(key),
                        None => "value",
                    };
                    let help = format!(
                        "name the radius: {{ {key} = \"{} {}\", radius = \"... mm\" }}; or give it in {}",
                        self.value, self.unit, self.parameter.unit
                    );
                    report.add(&self.node.place, message, "of which radius?", help);
                })
                .ok()?,
        };
        let x = self.value * radius * radius;
        let says = format!(
            "`{name}` = {} {} ({} m)^2 = {} {}",
            short(self.value),
            self.unit,
            short(radius),
            short(x),
            self.parameter.unit
        );
        Some((x, says))
    }

    /// The place of the value.
    pub(super) fn node(&self) -> &Node {
        self.node
    }

    /// The radius that the value names [m].
    fn named(
        &self,
        node: &Node,
        model: &Model,
        value: &dyn Fn(&str) -> Option<f64>,
        report: &mut Report,
    ) -> Option<f64> {
        let path = format!("parameters.{}.radius", self.parameter.name);
        if let Value::Text(text) = &node.value
            && let Some(p) = model.parameters.iter().find(|p| p.name == text && p.unit == "m")
        {
            return value(p.name);
        }
        let x = field::quantity(&path, node, "m", report)?;
        if x <= 0.0 {
            field::out_of_range(&path, node, "must be positive", "it is the radius to which the value refers", report);
            return None;
        }
        Some(x)
    }
}

/// Whether a value has the dimension of `unit`.
fn fits(node: &Node, unit: &str) -> bool {
    let Value::Text(text) = &node.value else { return false };
    let dimensions = Quantity::parse(text).ok().zip(Unit::parse(unit).ok());
    dimensions.is_some_and(|(quantity, unit)| quantity.dimension.fits(unit.dimension))
}

/// The number rounded to seven significant digits.
fn short(x: f64) -> f64 {
    format!("{x:.6e}").parse().unwrap_or(x)
}
