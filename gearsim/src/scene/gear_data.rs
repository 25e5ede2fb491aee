//! The data of gears in a scene, checked against one another: parameters that are numbers of teeth, base radii and pressure angles, and
//! the teeth from which laws are computed.
//!
//! The description of a parameter states what it is. The name of a law states its mesh: `k12` of gears 1 and 2, `k_s1` of sun and planet,
//! `k_r1` of planet and ring, `k` of a model with two gears. Impossible values are refused, and rare ones give a warning.

use super::document::{Entry, Node, Value};
use super::mistake::Report;
use super::teeth::TeethReader;
use super::{Scene, field, keys};
use crate::gear::Gears;
use crate::model::{Model, Parameter};
use crate::tolerance::scene::{
    BASE_RADIUS, MODULES, PRESSURE_ANGLES, TEETH, USUAL_ANGLES, USUAL_MODULES, WORKING_ANGLE,
};

/// Checks the gears of `scene`, which was read from `entries`.
pub(super) fn check(scene: &Scene, entries: &[Entry], report: &mut Report) {
    let checker = Checker { scene, parameters: table(entries, "parameters"), laws: table(entries, "laws") };
    for (parameter, x) in scene.model.parameters.iter().zip(&scene.parameters) {
        if parameter.doc.starts_with("number of teeth") {
            checker.number_of_teeth(parameter, *x, report);
        } else if parameter.doc.starts_with("base radius") {
            checker.base_radius(parameter, *x, report);
        } else if is_angle(parameter) {
            checker.pressure_angle(parameter, *x, report);
        }
    }
    for law in scene.model.laws {
        if let Some(Entry { node, .. }) = checker.laws.iter().find(|entry| entry.key == law.name)
            && let Value::Table(of_law) = &node.value
        {
            let reader = TeethReader { law, entries: of_law, place: &node.place };
            // Mistakes in the teeth themselves were reported when the law was read.
            if let (true, Some(gears)) = (reader.given(), reader.gears(&mut Report::new())) {
                checker.teeth_of_law(&reader, &gears, report);
            }
        }
    }
}

fn table<'a>(entries: &'a [Entry], name: &str) -> &'a [Entry] {
    match keys::get(entries, name).map(|node| &node.value) {
        Some(Value::Table(entries)) => entries,
        _ => &[],
    }
}

fn is_angle(parameter: &Parameter) -> bool {
    parameter.unit == "rad" && parameter.doc.contains("pressure angle")
}

struct Checker<'a> {
    scene: &'a Scene,
    parameters: &'a [Entry],
    laws: &'a [Entry],
}

impl Checker<'_> {
    /// The place of a parameter in the scene; `None` if it has its default.
    fn node(&self, parameter: &Parameter) -> Option<&Node> {
        keys::get(self.parameters, parameter.name)
    }

    fn refuse(&self, parameter: &Parameter, must: &str, report: &mut Report) {
        if let Some(node) = self.node(parameter) {
            let what = format!("`{}` is the {}", parameter.name, parameter.doc);
            field::out_of_range(&format!("parameters.{}", parameter.name), node, must, &what, report);
        }
    }

    fn number_of_teeth(&self, parameter: &Parameter, z: f64, report: &mut Report) {
        if z.fract() != 0.0 || !(1.0..=TEETH).contains(&z) {
            self.refuse(parameter, &format!("must be a whole number from 1 to {TEETH}"), report);
        }
    }

    /// The module that a base radius and a number of teeth imply at 20 deg.
    fn base_radius(&self, parameter: &Parameter, r: f64, report: &mut Report) {
        let gear = parameter.name.trim_start_matches('r');
        let Some(z) = ["N", "Z"].iter().find_map(|letter| self.scene.parameter(&format!("{letter}{gear}"))) else {
            return;
        };
        let module = 2.0 * r / (z * 20f64.to_radians().cos());
        let (low, high) = (1e3 * MODULES.start(), 1e3 * MODULES.end());
        if !MODULES.contains(&module) {
            let must = format!(
                "must belong to a module from {low} to {high} mm; with {z} teeth its module is {:.4} mm",
                1e3 * module
            );
            self.refuse(parameter, &must, report);
        } else if !USUAL_MODULES.contains(&module) && self.node(parameter).is_some() {
            let name = parameter.name;
            report.warn(format!(
                "`parameters.{name}`: with {z} teeth its module is {:.4} mm, which is rare",
                1e3 * module
            ));
        }
    }

    fn pressure_angle(&self, parameter: &Parameter, alpha: f64, report: &mut Report) {
        let degrees = alpha.to_degrees();
        if !alpha.is_nan() && !PRESSURE_ANGLES.contains(&degrees) {
            let must = format!("must lie between {} and {} deg", PRESSURE_ANGLES.start(), PRESSURE_ANGLES.end());
            self.refuse(parameter, &must, report);
        } else if !alpha.is_nan() && !USUAL_ANGLES.contains(&degrees) {
            report.warn(format!(
                "`parameters.{}` is {degrees:.1} deg, which is rare for a pressure angle",
                parameter.name
            ));
        }
    }

    /// Compares the teeth of a law with the parameters of its gears.
    fn teeth_of_law(&self, reader: &TeethReader<'_>, gears: &Gears, report: &mut Report) {
        let model = self.scene.model;
        let name = reader.law.name;
        if !USUAL_MODULES.contains(&gears.module) {
            report.warn(format!("`laws.{name}.module` is {:.4} mm, which is rare", 1e3 * gears.module));
        }
        for (i, gear) in of_mesh(name).into_iter().enumerate() {
            let Some((z, said)) = self.scene.teeth_of(&gear) else { continue };
            if z != gears.teeth[i] {
                let what = format!("`laws.{name}.teeth` has {} teeth for a gear with {said}", gears.teeth[i]);
                let help = "give the teeth of the gears of this mesh, the driving gear first";
                return report.add(reader.at(), what, "other gears", help);
            }
            let radius =
                model.parameters.iter().find(|p| p.doc.starts_with("base radius") && p.name == format!("r{gear}"));
            let Some((parameter, r)) = radius.and_then(|p| Some((p, self.scene.parameter(p.name)?))) else { continue };
            let base = z * gears.base_radius_per_tooth();
            if (r / base - 1.0).abs() > BASE_RADIUS {
                let place = self.node(parameter).map_or(reader.at(), |node| &node.place);
                let what = format!(
                    "`parameters.{}` is {r} m, but the base radius of the teeth of `laws.{name}` is {base:.6} m",
                    parameter.name
                );
                let help = "the base radius is module x teeth/2 x cos(pressure angle), both in the transverse plane if the gears are helical";
                return report.add(place, what, "another gear", help);
            }
        }
        self.working_angle(reader, gears, report);
    }

    fn working_angle(&self, reader: &TeethReader<'_>, gears: &Gears, report: &mut Report) {
        let parameters = self.scene.model.parameters.iter().zip(&self.scene.parameters);
        let active = self.scene.effects.names(self.scene.model);
        // A mesh may have an angle of its own; else it has that of the model.
        let own = format!("alpha{}", part_of(reader.law.name));
        let has_own = self.scene.model.parameters.iter().any(|p| p.name == own);
        let mut angles = parameters.filter(|(p, _)| {
            is_angle(p) && p.with.is_none_or(|effect| active.contains(&effect)) && (!has_own || p.name == own)
        });
        let (Some((parameter, alpha)), Ok(contact)) = (angles.next(), gears.contact()) else { return };
        let (given, working) = (alpha.to_degrees(), contact.angle.to_degrees());
        let (name, law) = (parameter.name, reader.law.name);
        if (given - working).abs() > WORKING_ANGLE[1] {
            let what = format!(
                "`parameters.{name}` is {given:.2} deg, but the teeth of `laws.{law}` work at {working:.2} deg"
            );
            let place = self.node(parameter).map_or(reader.at(), |node| &node.place);
            report.add(place, what, "another angle", format!("set {name} = \"{working:.4} deg\", or change the teeth"));
        } else if (given - working).abs() > WORKING_ANGLE[0] {
            report.warn(format!(
                "`parameters.{name}` is {given:.2} deg, but the teeth of `laws.{law}` work at {working:.2} deg"
            ));
        }
    }
}

impl Scene {
    /// Number of teeth of a gear by its suffix, and where it comes from; `_p` is a planet.
    pub(crate) fn teeth_of(&self, gear: &str) -> Option<(f64, String)> {
        teeth(gear, &|name| self.parameter(name))
    }

    /// The first of its pressure angles that is given \[rad\].
    #[cfg(feature = "html")]
    pub(crate) fn pressure_angle(&self) -> Option<f64> {
        let mut all = self.model.parameters.iter().zip(&self.parameters);
        all.find(|(parameter, x)| is_angle(parameter) && x.is_finite()).map(|(_, x)| *x)
    }
}

/// Number of teeth of a gear by its suffix, and where it comes from; `_p` is a planet. `value` has the values of the parameters.
fn teeth(gear: &str, value: &dyn Fn(&str) -> Option<f64>) -> Option<(f64, String)> {
    let of = |name: &str| value(name).filter(|x| x.is_finite());
    if gear == "_p" {
        let (sun, ring) = (of("Z_s")?, of("Z_r")?);
        return Some(((ring - sun) / 2.0, format!("(Z_r - Z_s)/2 = {}", (ring - sun) / 2.0)));
    }
    ["N", "Z"].iter().find_map(|letter| {
        let name = format!("{letter}{gear}");
        of(&name).map(|z| (z, format!("{name} = {z}")))
    })
}

/// The base radius of a gear of a model by its suffix [m]: its parameter, or that of a gear with which it meshes, in the ratio of their
/// teeth. The radius of a carrier, `_c`, is that of the circle of the planets' centres. `value` has the values of the parameters.
pub(super) fn radius(model: &Model, gear: &str, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let teeth = |gear: &str| teeth(gear, value).map(|(z, _)| z);
    let given = |gear: &str| value(&format!("r{gear}"));
    if gear == "_c" {
        let (sun, ring, alpha) = (teeth("_s")?, teeth("_r")?, value("alpha")?);
        return Some(given("_s")? / sun * (sun + ring) / 2.0 / alpha.cos());
    }
    let module = |[a, b]: [&String; 2]| {
        let other = if a == gear { b } else { a };
        // The ring of a stage meshes with its planets, whose base radius is no parameter: the gear after them is the sun.
        let other = if other == "_p" { "_s" } else { other };
        Some(given(other)? / teeth(other)?)
    };
    given(gear).or_else(|| {
        let meshes = model.laws.iter().map(|law| of_mesh(law.name)).filter(|pair| pair.iter().any(|of| of == gear));
        Some(meshes.into_iter().find_map(|[a, b]| module([&a, &b]))? * teeth(gear)?)
    })
}

/// The suffix of the mesh of a law: `12` of `k12`, `_s1` of `k_s1`.
fn part_of(law: &str) -> &str {
    law.trim_start_matches(|c: char| c.is_alphabetic())
}

/// The suffixes of the two gears of the mesh of a law, the driving gear first.
pub(crate) fn of_mesh(law: &str) -> [String; 2] {
    let part = part_of(law);
    match part.as_bytes() {
        [a, b] if a.is_ascii_digit() && b.is_ascii_digit() => [part[..1].into(), part[1..].into()],
        [b'_', b's', ..] => ["_s".into(), "_p".into()],
        [b'_', b'r', ..] => ["_p".into(), "_r".into()],
        _ => ["1".into(), "2".into()],
    }
}
