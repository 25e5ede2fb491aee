//! A scene to start from: all that a model requires with values of usual size, all else as comments.

use std::fmt::Write;

use crate::model::{Law, Model, Parameter, Role};

/// Values of usual size, by the unit of the parameter.
const USUAL: &[(&str, &str)] = &[
    ("kg*m^2", "0.01 kg*m^2"),
    ("kg", "2 kg"),
    ("N*m/rad", "10 kN*m/rad"),
    ("N/m", "200 MN/m"),
    ("N*m", "20 N*m"),
    ("N", "50 N"),
    ("m", "50 mm"),
    ("rad", "5 deg"),
    ("rad/s", "1500 rpm"),
    ("N*m*s/rad", "0.05 N*m*s/rad"),
    ("N*m*s^2/rad^2", "1e-3 N*m*s^2/rad^2"),
    ("N*s/m", "100 N*s/m"),
    ("1/s", "10 1/s"),
    ("s", "1 us"),
    ("Hz", "50 Hz"),
    ("W", "5 kW"),
    ("1", "0.05"),
];

/// Unit of a parameter, words of its description, and a value of usual size. These entries come before those of [`USUAL`].
const BY_WORDS: &[(&str, &str, &str)] = &[
    // Three, four, five or six equally spaced planets fit between this sun and this ring.
    ("1", "number of teeth of the sun", "30"),
    ("1", "number of teeth of the ring", "90"),
    ("1", "number of teeth", "25"),
    ("1", "number of pole pairs", "2"),
    ("rad", "backlash", "1e-3 rad"),
    ("rad", "lower stop", "-5 deg"),
    ("m", "backlash", "80 um"),
    ("m", "length of the connecting rod", "200 mm"),
];

/// Effects with which a scene starts, if the model has them: they require little and contradict nothing.
const FIRST: &[&str] = &["stiffness_step", "damping", "torques"];

/// The text of a scene of `model` in TOML. It is complete: it can be run as it is.
pub fn starter(model: &Model) -> String {
    if !model.elements.is_empty() {
        return gearsim_generated::TRAIN_SCENE.into();
    }
    let has = |with: Option<&str>| with.is_none_or(|effect| FIRST.contains(&effect));
    let mut text = format!("about = \"{}\"\nmodel = \"{}\"\n\n", model.title.replace('"', "'"), model.name);
    text += "effects = [\n";
    for effect in model.effects.iter().filter(|effect| effect.of.is_none()) {
        let off = if FIRST.contains(&effect.name) { "" } else { "# " };
        let _ = writeln!(text, "    {off}\"{}\",  # {}", effect.name, effect.doc);
    }
    text += "]\n\n[parameters]\n";
    for parameter in model.parameters {
        let (value, note) = (usual_value(parameter), note(parameter));
        let off = if parameter.default.is_some() || !has(parameter.with) { "# " } else { "" };
        let _ = writeln!(text, "{off}{} = {value}  # {}{note}", parameter.name, parameter.doc);
    }
    for law in model.laws {
        let off = if has(law.with) { "" } else { "# " };
        let with = law.with.map_or(String::new(), |effect| format!("; with the effect {effect}"));
        let _ = write!(text, "\n{off}[laws.{}]  # {}{with}\n{off}{}\n", law.name, law.doc, usual_levels(law, model));
    }
    text += "\n[start]\n";
    for motion in model.motions {
        let value = if motion.unit == "rad/s" { "1500 rpm".into() } else { format!("1 {}", motion.unit) };
        let _ = writeln!(text, "{} = \"{value}\"  # {}", motion.name, motion.doc);
    }
    for coordinate in model.coordinates {
        let start = if coordinate.start.is_static() { "static" } else { "0" };
        let unit = if start == "0" { format!(" {}", coordinate.unit) } else { String::new() };
        let _ = writeln!(text, "# {} = \"{start}{unit}\"  # {}", coordinate.name, coordinate.doc);
    }
    text + "\n[run]\nt_end = \"0.1 s\"\n# method = \"dop853\"  # or exact, dopri5, radau, rk4; without it, the one that suits the scene\n\n\
            [output]\nrate = \"20 kHz\"\n# record = []  # names of outputs; without it, all\n# csv = true\n"
}

/// The value of a parameter in TOML: its default, or one of usual size.
pub fn usual_value(parameter: &Parameter) -> String {
    let quantity = |value: &str| match value.contains(' ') {
        true => format!("\"{value}\""),
        false => value.to_string(),
    };
    if let Some(default) = parameter.default {
        return match parameter.unit {
            "1" => format!("{default}"),
            unit => format!("\"{default} {unit}\""),
        };
    }
    let described = |(unit, words, _): &&(&str, &str, &str)| *unit == parameter.unit && parameter.doc.contains(words);
    let by_words = BY_WORDS.iter().find(described).map(|(.., value)| *value);
    let usual = || USUAL.iter().find(|(unit, _)| *unit == parameter.unit).map(|(_, value)| *value);
    by_words.or_else(usual).map_or_else(|| format!("\"1 {}\"", parameter.unit), quantity)
}

fn note(parameter: &Parameter) -> String {
    match (parameter.default, parameter.with) {
        (Some(_), None) => "; the default".into(),
        (Some(_), Some(effect)) => format!("; the default; with the effect {effect}"),
        (None, Some(effect)) if !FIRST.contains(&effect) => format!("; with the effect {effect}"),
        _ => String::new(),
    }
}

/// The levels of a law over one pitch in TOML, of usual size: `steps = [...]`.
pub fn usual_levels(law: &Law, model: &Model) -> String {
    let values = match (law.role, law.unit) {
        (Role::Stiffness, "N*m") => ["1 kN*m", "2 kN*m"],
        (Role::Stiffness, "N*m/rad") => ["10 kN*m/rad", "15 kN*m/rad"],
        (Role::Stiffness, _) => ["200 MN/m", "300 MN/m"],
        (Role::Error, "rad") => ["1e-4 rad", "-1e-4 rad"],
        (Role::Error, _) => ["1 um", "-1 um"],
        (Role::Side, _) => ["1", "-1"],
        (Role::Arm, "rad") => ["0.1 rad", "0.2 rad"],
        (Role::Arm, _) => ["1 mm", "2 mm"],
    };
    let unit = model.coordinates.iter().find(|c| c.name == law.phase).map_or("rad", |c| c.unit);
    let width = 0.6 * law.period;
    format!("steps = [{{ value = \"{}\", width = \"{width:.4} {unit}\" }}, {{ value = \"{}\" }}]", values[0], values[1])
}
