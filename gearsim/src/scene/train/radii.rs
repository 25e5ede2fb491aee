//! The radii to which values of a train refer that are given per squared radius: the base radius of the gear on the rotor, and the
//! radius of the circle of the planets' centres of a carrier.

use std::collections::HashMap;

use super::draft::{Draft, DraftPart, GearGroup, named};
use crate::model::Parameter;
use crate::scene::per_radius::Radii;
use crate::tolerance::scene::SAME_RADIUS;

/// The radius to which values of each parameter refer [m], or a text that says what is missing.
#[derive(Default)]
pub(in crate::scene) struct OfTrain(HashMap<String, Result<f64, String>>);

impl Radii for OfTrain {
    fn radius(&self, parameter: &Parameter, _: &dyn Fn(&str) -> Option<f64>) -> Result<f64, String> {
        let none = || Err(format!("`{}` belongs to no single gear", parameter.name));
        self.0.get(parameter.name).cloned().unwrap_or_else(none)
    }
}

/// The radii of the parts; `value` has the values of the parameters.
pub(super) fn of(draft: &Draft, value: &dyn Fn(&str) -> Option<f64>) -> OfTrain {
    let rotor_of = |part: &DraftPart| part.rows[0].first().map(|term| term.rotor);
    let mut radii = HashMap::new();
    for part in &draft.parts {
        let quantities: &[&str] = match part.element {
            "element_rotor" => &["I"],
            "element_shaft" | "element_support" => &["k", "c"],
            "element_viscous" => &["c"],
            _ => continue,
        };
        let Some(rotor) = rotor_of(part) else { continue };
        let found = match part.rows[0].len() {
            1 => of_rotor(draft, rotor, value),
            _ => Err("it has two ends".into()),
        };
        for quantity in quantities {
            let renamed = part.renamed.iter().find(|(of, _)| of.strip_suffix("_x") == Some(*quantity));
            let name = renamed.map_or_else(|| named(quantity, &part.name), |(_, name)| name.clone());
            radii.insert(name, found.clone());
        }
    }
    OfTrain(radii)
}

/// The radius of the one gear or circle of planets on a rotor [m].
fn of_rotor(draft: &Draft, rotor: usize, value: &dyn Fn(&str) -> Option<f64>) -> Result<f64, String> {
    let gears = draft.groups.iter().flat_map(|group| {
        let on = group.gears.iter().enumerate().filter(|(_, gear)| gear.rotor == Some(rotor));
        on.filter_map(|(i, _)| base_radius(group, i, value)).collect::<Vec<_>>()
    });
    let sets = draft.parts.iter().filter(|part| part.element == "element_planets" && part.rows[0][0].rotor == rotor);
    let circles = sets.filter_map(|part| circle(part, value));
    let mut all: Vec<f64> = gears.chain(circles).filter(|r| r.is_finite() && *r > 0.0).collect();
    all.dedup_by(|a, b| (*a / *b - 1.0).abs() <= SAME_RADIUS);
    let name = &draft.rotors[rotor].name;
    match all[..] {
        [] => Err(format!("rotor {name} has no gear with a base radius")),
        [only] => Ok(only),
        _ => Err(format!("rotor {name} has gears with different base radii")),
    }
}

/// The base radius of gear `i` of a group [m].
fn base_radius(group: &GearGroup, i: usize, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    Some(value(&group.radius)? * value(&group.gears[i].teeth)? / value(&group.gears[0].teeth)?)
}

/// The radius of the circle of the centres of the planets of a set [m].
fn circle(part: &DraftPart, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
    let of = |end: &str| value(&part.renamed.iter().find(|r| r.0 == end)?.1);
    let alpha = value(&named("alpha", &part.name)).unwrap_or(20f64.to_radians());
    let [sun, ring, radius] = [of("Zs_x")?, of("Zr_x")?, of("rs_x")?];
    Some(radius / sun * (sun + ring) / 2.0 / alpha.cos())
}
