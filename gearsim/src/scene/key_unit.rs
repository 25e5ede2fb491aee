//! The SI unit of each key of a scene.

use crate::model::Model;

/// SI unit of the quantity at `key` (`parameters.T0`, `laws.k.steps.0.value`) in a scene of `model`, e.g. `N*m`; `1` for a plain
/// number, `None` if the key does not take a quantity.
pub fn unit_of(key: &str, model: &Model) -> Option<String> {
    let path: Vec<&str> = key.split('.').collect();
    let coordinate = |name: &str| model.coordinates.iter().find(|c| c.name == name).map(|c| c.unit);
    let parameter = |name: &str| model.parameters.iter().find(|p| p.name == name);
    let law = |name: &str| model.laws.iter().find(|law| law.name == name);
    let unit = match path[..] {
        ["parameters", name] => parameter(name)?.unit,
        ["parameters", name, "value"] => parameter(name)?.unit,
        ["parameters", _, "radius"] => "m",
        ["parameters", name, "mean"] | ["parameters", name, "ramp", "from" | "to"] => parameter(name)?.unit,
        ["parameters", name, "steps" | "table", _, "value"] => parameter(name)?.unit,
        ["parameters", name, "harmonics", _, "amplitude"] => parameter(name)?.unit,
        ["parameters", _, "harmonics", _, "frequency"] => "Hz",
        ["parameters", _, "harmonics", _, "phase"] => "rad",
        ["parameters", _, "ramp", "start" | "duration"] => "s",
        ["parameters", _, "steps", _, "until"] | ["parameters", _, "table", _, "at"] => "s",
        ["laws", name, "steps", _, "value"] => law(name)?.unit,
        ["laws", name, "mean"] | ["laws", name, "harmonics", _, "amplitude"] => law(name)?.unit,
        ["laws", name, "pitch_errors", _] => law(name)?.unit,
        ["laws", name, "steps", _, "width"] => coordinate(law(name)?.phase)?,
        ["laws", _, "module" | "face_width" | "centre_distance" | "bore"] => "m",
        ["laws", _, "pressure_angle"] => "rad",
        ["laws", _, "young"] => "Pa",
        ["laws", _, "line_load"] => "N/m",
        ["laws", _, "teeth" | "addendum" | "dedendum" | "profile_shift" | "poisson", _] => "1",
        ["laws", _, "addendum" | "dedendum" | "fillet" | "profile_shift" | "poisson" | "phase"] => "1",
        ["start", name] => match name.strip_suffix("_dot").and_then(coordinate) {
            Some(unit) => return Some(format!("{unit}/s")),
            None => coordinate(name).or_else(|| model.motions.iter().find(|m| m.name == name).map(|m| m.unit))?,
        },
        ["run", "t_end"] => "s",
        ["output", "rate"] => "Hz",
        _ => return None,
    };
    Some(unit.to_owned())
}
