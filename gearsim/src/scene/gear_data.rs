//! The data of gears in a scene, checked against one another: parameters that are numbers of teeth, base radii and pressure angles, and
//! the teeth from which laws are computed.
//!
//! The model states what a parameter is ([`GearData`]). A law is compared with its mesh ([`super::meshes`]). Impossible values are refused,
//! and rare ones give a warning.

use super::document::{KeyEntry, Node, Value};
use super::meshes::{self, Mesh};
use super::mistake::Report;
use super::teeth::TeethReader;
use super::train::Meshes;
use super::{Scene, damage, field, friction, keys};
use crate::gear::Gears;
use crate::model::{GearData, Law, Model, Parameter, Role};
use crate::tolerance::scene::{
    BASE_RADIUS, MODULES, PRESSURE_ANGLES, TEETH, USUAL_ANGLES, USUAL_MODULES, USUAL_PLAY, WORKING_ANGLE,
};

/// The modules of the meshes of the laws of `scene` [m]. `train` has the meshes of a train.
pub(super) fn modules(scene: &Scene, train: Option<&Meshes>) -> Vec<Option<f64>> {
    let of_radius = |law: &Law| {
        let mesh = meshes::of_law(law.name, scene.model, train, &|name| scene.parameter(name))?;
        let mut gears = mesh.gears.iter();
        let (z, r) = gears.find_map(|gear| Some((gear.teeth.as_ref()?.0, gear.radius.as_ref()?.1)))?;
        Some(module(z, r)).filter(|module| module.is_finite())
    };
    let laws = scene.model.laws.iter().zip(&scene.gears);
    laws.map(|(law, gears)| gears.as_ref().map(|gears| gears.module).or_else(|| of_radius(law))).collect()
}

/// The module of a gear with `z` teeth and the base radius `r` [m] at 20 deg [m].
fn module(z: f64, r: f64) -> f64 {
    2.0 * r / (z * 20f64.to_radians().cos())
}

/// Checks the gears of `scene`, which was read from `entries`. `train` has the meshes of a train.
pub(super) fn check(scene: &Scene, entries: &[KeyEntry], train: Option<&Meshes>, report: &mut Report) {
    let checker = Checker { scene, parameters: table(entries, "parameters"), laws: table(entries, "laws") };
    for (parameter, x) in scene.model.parameters.iter().zip(&scene.parameters) {
        match parameter.gear_data {
            Some(GearData::Teeth) => checker.number_of_teeth(parameter, *x, report),
            Some(GearData::BaseRadius) => checker.base_radius(parameter, *x, report),
            Some(GearData::PressureAngle) => checker.pressure_angle(parameter, *x, report),
            Some(GearData::Support) | None => {}
        }
    }
    for (law, module) in scene.model.laws.iter().zip(&scene.modules).filter(|(law, _)| law.role == Role::Stiffness) {
        checker.play(law, *module, report);
    }
    for law in scene.model.laws {
        if let Some(KeyEntry { node, .. }) = checker.laws.iter().find(|entry| entry.key == law.name)
            && let Value::Table(of_law) = &node.value
        {
            let reader = TeethReader { law, entries: of_law, place: &node.place };
            let mesh = meshes::of_law(law.name, scene.model, train, &|name| scene.parameter(name));
            // Mistakes in the teeth themselves were reported when the law was read.
            let gears = reader.given().then(|| reader.gears(&mut Report::new())).flatten();
            if let (Some(gears), Some(mesh)) = (&gears, &mesh) {
                checker.teeth_of_law(&reader, gears, mesh, report);
            }
            if law.role.is_friction() && mesh.as_ref().is_some_and(|mesh| mesh.internal.is_none()) {
                checker.friction_in_a_ring(law.name, of_law, gears.as_ref(), report);
            }
            let of_mesh = || mesh.and_then(|mesh| mesh.teeth());
            if let Some(teeth) = gears.map(|gears| gears.teeth).or_else(of_mesh) {
                damage::check(law, of_law, teeth, report);
            }
        }
    }
}

fn table<'a>(entries: &'a [KeyEntry], name: &str) -> &'a [KeyEntry] {
    match keys::get(entries, name).map(|node| &node.value) {
        Some(Value::Table(entries)) => entries,
        _ => &[],
    }
}

fn is_angle(parameter: &Parameter) -> bool {
    parameter.gear_data == Some(GearData::PressureAngle)
}

struct Checker<'a> {
    scene: &'a Scene,
    parameters: &'a [KeyEntry],
    laws: &'a [KeyEntry],
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

    /// Checks the module that follows from a base radius and a number of teeth at 20 deg.
    fn base_radius(&self, parameter: &Parameter, r: f64, report: &mut Report) {
        let gear = parameter.name.trim_start_matches('r');
        let Some(z) = ["N", "Z"].iter().find_map(|letter| self.scene.parameter(&format!("{letter}{gear}"))) else {
            return;
        };
        let module = module(z, r);
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

    /// Warns of a play with which the gears of a stiffness would not mesh.
    fn play(&self, law: &Law, module: Option<f64>, report: &mut Report) {
        let name = format!("b{}", &law.name[1..]);
        let Some((parameter, play)) =
            self.scene.model.parameters.iter().zip(&self.scene.parameters).find(|(p, _)| p.name == name)
        else {
            return;
        };
        // A play in rad is one of the deflection of `gear_pair`, whose radian is a module and a little more.
        let module = if parameter.unit == "rad" { Some(1.0) } else { module };
        let modules = module.map_or(0.0, |module| play / module);
        if modules > USUAL_PLAY {
            report.warn(format!("`parameters.{name}` is a play of {modules:.1} modules: the teeth would not mesh"));
        }
    }

    /// Compares the teeth of a law with its mesh.
    fn teeth_of_law(&self, reader: &TeethReader<'_>, gears: &Gears, mesh: &Mesh, report: &mut Report) {
        let name = reader.law.name;
        if !USUAL_MODULES.contains(&gears.module) {
            report.warn(format!("`laws.{name}.module` is {:.4} mm, which is rare", 1e3 * gears.module));
        }
        if mesh.internal.is_some_and(|internal| internal != gears.internal) {
            let of = mesh.title.as_ref().map_or(format!("`{name}`"), |title| format!("{title}, `{name}`,"));
            let [said, is] = if gears.internal { ["true", "external"] } else { ["false", "of a ring gear"] };
            let what = format!("`laws.{name}` has internal = {said}, but the mesh of {of} is {is}");
            let help = "leave out `internal` in the law; in a train, `internal = true` in [meshes.NAME] makes its second gear a ring";
            return report.add(reader.internal_at(), what, "another kind of mesh", help);
        }
        for (i, gear) in mesh.gears.iter().enumerate() {
            let Some((z, said)) = &gear.teeth else { continue };
            if *z != gears.teeth[i] {
                let what = format!("`laws.{name}.teeth` has {} teeth for a gear with {said}", gears.teeth[i]);
                let help = "give the teeth of the gears of this mesh, the driving gear first";
                return report.add(reader.at(), what, "other gears", help);
            }
            let Some((parameter, r)) = &gear.radius else { continue };
            let base = z * gears.base_radius_per_tooth();
            if (r / base - 1.0).abs() > BASE_RADIUS {
                let place = keys::get(self.parameters, parameter).map_or(reader.at(), |node| &node.place);
                let stated = self.scene.parameter(parameter) == Some(*r);
                let of = if stated {
                    format!("`parameters.{parameter}`")
                } else {
                    format!("by `parameters.{parameter}` the base radius of the gear with {said}")
                };
                let what = format!("{of} is {r} m, but the base radius of the teeth of `laws.{name}` is {base:.6} m");
                let help = "the base radius is module x teeth/2 x cos(pressure angle), both in the transverse plane if the gears are helical";
                return report.add(place, what, "another gear", help);
            }
        }
        let helix = gears.base_helix_angle();
        if let Some(tangent) = mesh.tangent.filter(|tangent| (tangent - helix.tan()).abs() > BASE_RADIUS) {
            let [of_mesh, of_law] = [tangent.atan(), helix].map(f64::to_degrees);
            let what = format!(
                "the teeth of `laws.{name}` have a base helix angle of {of_law:.2} deg, but those of {} one of {of_mesh:.2} deg",
                mesh.title.as_deref().unwrap_or("the mesh")
            );
            return report.add(reader.at(), what, "another helix", "give both the same helix_angle");
        }
        self.working_angle(reader, gears, mesh, report);
    }

    /// Refuses friction from the teeth of a ring in a model that does not say which of its gears is a ring: flanks roll on each other with the
    /// sum of the speeds of external gears, and with the difference within a ring.
    fn friction_in_a_ring(&self, name: &str, of_law: &[KeyEntry], gears: Option<&Gears>, report: &mut Report) {
        let text = |node: &Node| if let Value::Text(text) = &node.value { Some(text.clone()) } else { None };
        let lender = keys::get(of_law, friction::OF).and_then(|node| Some((node, table(self.laws, &text(node)?))));
        let is_ring =
            |law: &[KeyEntry]| matches!(keys::get(law, "internal"), Some(Node { value: Value::Flag(true), .. }));
        let place = match (gears, lender) {
            (Some(gears), _) if gears.internal => keys::get(of_law, "teeth").map(|node| &node.place),
            (None, Some((node, law))) if is_ring(law) => Some(&node.place),
            _ => None,
        };
        if let Some(place) = place {
            let what =
                format!("the second gear of the teeth of `laws.{name}` is a ring, and no gear of this model is one");
            let help = "use a train with `internal = true` in [meshes.NAME], or a model with planets; or give steps";
            report.add(place, what, "a ring", help);
        }
    }

    fn working_angle(&self, reader: &TeethReader<'_>, gears: &Gears, mesh: &Mesh, report: &mut Report) {
        let parameters = self.scene.model.parameters.iter().zip(&self.scene.parameters);
        let active = self.scene.effects.names(self.scene.model);
        let is_own = |p: &Parameter| mesh.angle.as_ref().is_none_or(|own| p.name == own);
        // An angle that the scene states is checked even if no effect uses it.
        let used = |p: &Parameter| p.with.is_none_or(|effect| active.contains(&effect)) || self.node(p).is_some();
        let mut angles = parameters.filter(|(p, _)| is_angle(p) && used(p) && is_own(p));
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
    #[cfg(feature = "html")]
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
pub(super) fn teeth(gear: &str, value: &dyn Fn(&str) -> Option<f64>) -> Option<(f64, String)> {
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
pub(super) fn part_of(law: &str) -> &str {
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
