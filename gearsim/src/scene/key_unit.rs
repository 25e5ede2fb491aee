//! The SI unit of each key of a scene.

use super::keys::{Key, Kind};
use super::train;
use crate::model::Model;

/// SI unit of the quantity at `key` (`parameters.T0`, `laws.k.steps.0.value`, `shafts.ab.stiffness`) in a scene of `model`, e.g. `N*m`;
/// `1` for a plain number, `None` if the key does not take a quantity.
pub fn unit_of(key: &str, model: &Model) -> Option<String> {
    let path: Vec<&str> = key.split('.').collect();
    let coordinate = |name: &str| model.coordinates.iter().find(|c| c.name == name).map(|c| c.unit);
    let parameter = |name: &str| model.parameters.iter().find(|p| p.name == name);
    let law = |name: &str| model.laws.iter().find(|law| law.name == name);
    let unit = match path[..] {
        ["parameters", _, "radius"] => "m",
        ["parameters", name, ref rest @ ..] => over_time(parameter(name)?.unit, rest)?,
        ["laws", name, ref rest @ ..] => {
            let phase = || coordinate(law(name)?.phase);
            of_law(law(name).map(|law| law.unit), phase(), rest)?
        }
        ["start", name] => match name.strip_suffix("_dot").and_then(coordinate) {
            Some(unit) => return Some(format!("{unit}/s")),
            None => coordinate(name).or_else(|| model.motions.iter().find(|m| m.name == name).map(|m| m.unit))?,
        },
        ["run", "t_end"] => "s",
        ["output", "rate"] => "Hz",
        _ if !model.elements.is_empty() => of_part(&path)?,
        _ => return None,
    };
    Some(unit.to_owned())
}

/// The unit of the key `rest` inside a value in `unit` that may vary in time.
fn over_time(unit: &'static str, rest: &[&str]) -> Option<&'static str> {
    Some(match rest {
        [] | ["value" | "mean"] | ["ramp", "from" | "to"] => unit,
        ["steps" | "table", _, "value"] | ["harmonics", _, "amplitude"] => unit,
        ["harmonics", _, "frequency"] => "Hz",
        ["harmonics", _, "phase"] => "rad",
        ["ramp", "start" | "duration"] | ["steps", _, "until"] | ["table", _, "at"] => "s",
        _ => return None,
    })
}

/// The unit of the key `rest` inside a law in `unit`. Its widths are in the unit of its `phase`.
fn of_law(unit: Option<&'static str>, phase: Option<&'static str>, rest: &[&str]) -> Option<&'static str> {
    Some(match rest {
        ["steps", _, "value"] | ["mean"] | ["harmonics", _, "amplitude"] | ["pitch_errors", _] => unit?,
        ["steps", _, "width"] => phase?,
        ["module" | "face_width" | "centre_distance" | "bore"] => "m",
        ["pressure_angle"] => "rad",
        ["young"] => "Pa",
        ["line_load"] => "N/m",
        ["teeth" | "addendum" | "dedendum" | "profile_shift" | "poisson", _] => "1",
        ["addendum" | "dedendum" | "fillet" | "profile_shift" | "poisson" | "phase"] => "1",
        _ => return None,
    })
}

/// The unit at a key of a table of a train.
fn of_part(path: &[&str]) -> Option<&'static str> {
    let law = |unit, rest: &[&str]| if rest.is_empty() { Some(unit) } else { of_law(Some(unit), Some("rad"), rest) };
    match path {
        ["meshes", _, "stiffness", rest @ ..] => law("N/m", rest),
        ["planets", _, "sun_stiffness" | "ring_stiffness", rest @ ..] => law("N/m", rest),
        ["meshes", _, "error", rest @ ..] | ["planets", _, "sun_error" | "ring_error", rest @ ..] => law("m", rest),
        [table, rest @ ..] => of_kind(of_key(&[train::KEYS], table)?, rest),
        [] => None,
    }
}

fn of_key(lists: &[&[Key]], name: &str) -> Option<Kind> {
    lists.iter().flat_map(|keys| keys.iter()).find(|key| key.name == name).map(|key| key.kind)
}

/// The unit of the key `rest` inside a value of this kind. If a value may have several kinds, a plain number is of the first one.
fn of_kind(kind: Kind, rest: &[&str]) -> Option<&'static str> {
    match (kind, rest) {
        (Kind::Number, []) => Some("1"),
        (Kind::Quantity(unit), []) => Some(unit),
        (Kind::List(kind), [_, rest @ ..]) => of_kind(*kind, rest),
        (Kind::Table(lists), [name, rest @ ..]) => of_kind(of_key(lists, name)?, rest),
        (Kind::Named(named), [_, rest @ ..]) => named.iter().find_map(|named| of_kind(named.kind, rest)),
        (Kind::Either(kinds), rest) => {
            let value = kinds.first().and_then(|kind| over_time(of_kind(*kind, &[])?, rest));
            value.or_else(|| kinds.iter().find_map(|kind| of_kind(*kind, rest)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::unit_of;
    use crate::known::MODELS;

    #[test]
    fn values_in_the_tables_of_a_train_have_units() {
        let train = MODELS.iter().find(|entry| entry.model.name == "train").unwrap().model;
        for (key, unit) in [
            ("rotors.motor", Some("kg*m^2")),
            ("rotors.motor.inertia", Some("kg*m^2")),
            ("rotors.motor.radius", Some("m")),
            ("shafts.ab.stiffness", Some("N*m/rad")),
            ("shafts.ab.between", None),
            ("meshes.m.teeth.0", Some("1")),
            ("meshes.m.stiffness", Some("N/m")),
            ("meshes.m.stiffness.steps.1.width", Some("rad")),
            ("meshes.m.stiffness.steps.1.value", Some("N/m")),
            ("meshes.m.error.harmonics.0.amplitude", Some("m")),
            ("meshes.m.friction", Some("1")),
            ("planets.p.at.2", Some("rad")),
            ("planets.p.ring_stiffness.module", Some("m")),
            ("drives.d.torque", Some("N*m")),
            ("drives.d.torque.steps.0.until", Some("s")),
            ("drives.d.governor.set_point", Some("rad/s")),
            ("drives.d.governor.set_point.ramp.to", Some("rad/s")),
            ("drives.d.governor", None),
            ("loads.l.fan.coefficient", Some("N*m*s^2/rad^2")),
            ("start.speed", None),
        ] {
            assert_eq!(unit_of(key, train).as_deref(), unit, "{key}");
        }
    }
}
