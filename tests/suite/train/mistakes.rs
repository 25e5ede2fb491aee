//! Mistakes in the tables of a train are refused, each with its place and what to do.

use gearsim::scene::Scene;

use crate::common;

const HEAD: &str = "model = \"train\"\neffects = []\n[run]\nt_end = \"1 ms\"\n";
const ROTORS: &str = "[rotors]\na = \"1 kg*m^2\"\nb = \"2 kg*m^2\"\nc = \"2 kg*m^2\"\n";

/// The message for a scene with these tables.
fn refused(tables: &str) -> String {
    let text = format!("{HEAD}{tables}");
    let mistakes = Scene::parse("train", "train.toml", &text, &[], &common::models()).expect_err(tables);
    mistakes.render(200, false)
}

#[test]
fn each_mistake_is_reported_with_its_place() {
    let shaft = "[shafts.s]\nbetween = [\"a\", \"b\"]\nstiffness = \"1 kN*m/rad\"\n";
    for (tables, said) in [
        ("".to_string(), "lacks `[rotors]`"),
        (format!("{ROTORS}[shafts.s]\nbetween = [\"a\", \"x\"]\n"), "there is no rotor `x`"),
        (format!("{ROTORS}[shafts.s]\nbetween = [\"a\", \"a\"]\n"), "joins a rotor with itself"),
        (format!("{ROTORS}[shafts.s]\nbetween = [\"a\"]\n"), "must have two names, not 1"),
        (format!("{ROTORS}[shafts.s]\nbetween = [\"a\", \"b\"]\n"), "[shafts.s] lacks `stiffness`"),
        (format!("{ROTORS}{shaft}stifness = 1\n"), "did you mean `stiffness`?"),
        (
            format!("{ROTORS}{shaft}[supports.s]\nrotor = \"c\"\nstiffness = \"1 N*m/rad\"\n"),
            "`parameters.k_s` is stated twice",
        ),
        (format!("{ROTORS}{shaft}[supports.s]\nrotor = \"c\"\n"), "would both have the parameter `k_s`"),
        ("[rotors]\na = \"-1 kg*m^2\"\n".into(), "must be positive"),
        ("[rotors]\na = \"1 kg\"\n".into(), "kg*m^2"),
        ("[rotors]\n\"a b\" = \"1 kg*m^2\"\n".into(), "cannot be a name"),
        ("[rotors]\nground = \"1 kg*m^2\"\n".into(), "cannot be a name"),
        ("[rotors]\n".into(), "at least one rotor"),
        (format!("{ROTORS}{shaft}"), "rotor `c` is joined to nothing"),
        (format!("{ROTORS}[bearings.x]\nrotor = \"a\"\n"), "has no friction"),
        (format!("{ROTORS}[parameters]\nI_a = \"1 kg*m^2\"\n"), "is stated twice"),
        (
            format!(
                "{ROTORS}{shaft}[meshes.m]\nbetween = [\"a\", \"b\"]\nteeth = [20, 40]\nmodule = \"2 mm\"\nstiffness = \"1e8 N/m\"\n"
            ),
            "block one another",
        ),
        (
            format!(
                "{ROTORS}[meshes.m]\nbetween = [\"a\", \"b\"]\nteeth = [20, 40]\nstiffness = \"rigid\"\n\
                     [meshes.n]\nbetween = [\"a\", \"b\"]\nteeth = [20, 40]\nstiffness = \"rigid\"\n"
            ),
            "closes a loop of rigid gears",
        ),
        (
            format!("{ROTORS}[planets.p]\nsun = \"a\"\nring = \"b\"\ncarrier = \"c\"\ncount = 99\nteeth = [27, 99]\n"),
            "a set has 1 to 24 planets",
        ),
        (
            format!(
                "{ROTORS}[planets.p]\nsun = \"a\"\nring = \"b\"\ncarrier = \"c\"\nteeth = [27, 99]\n\
                 at = [\"0 deg\", \"360 deg\", \"120 deg\"]\n"
            ),
            "has two planets in one place",
        ),
        (
            format!(
                "{ROTORS}[planets.p]\nsun = \"a\"\nring = \"b\"\ncarrier = \"c\"\ncount = 3\nteeth = [27, 99]\n\
                 module = \"2 mm\"\nbase_radius = \"25 mm\"\n"
            ),
            "[planets.p] has `base_radius` and `module`",
        ),
        (
            format!("{ROTORS}[planets.p]\nsun = \"a\"\nring = \"b\"\ncarrier = \"c\"\ncount = 3\nteeth = [99, 27]\n"),
            "a ring of 27 teeth round a sun of 99",
        ),
        (format!("{ROTORS}[meshes.m]\nbetween = [\"a\", \"b\"]\nteeth = [20]\n"), "must have two numbers, not 1"),
        (format!("{ROTORS}[gears]\nx = 1\n"), "has no `gears`"),
        (
            format!(
                "{ROTORS}[meshes.m]\nbetween = [\"a\", \"b\"]\nteeth = [20, 40]\nmodule = \"2 mm\"\nstiffness = \"1 MN/m\"\n\
                 internal = true\n[shafts.s]\nbetween = [\"a\", \"b\"]\nstiffness = \"1 kN*m/rad\"\n\
                 [shafts.t]\nbetween = [\"b\", \"c\"]\nstiffness = \"1 kN*m/rad\"\n[start]\nspeed = \"100 rpm\"\n"
            ),
            "nothing in the model turns freely",
        ),
    ] {
        let message = refused(&tables);
        assert!(message.contains(said), "{tables}\nsays\n{message}\nwithout {said:?}");
        assert!(message.contains("train.toml:"), "no place: {message}");
    }
}
