//! Messages about the parts of trains: they name the keys of tables, each mistake once, and what is allowed.

use super::trains::{parse, planets};
use crate::scene::train::keys_of;

fn rendered(text: &str, set: &[&str]) -> String {
    parse(text, set).expect_err(text)
}

/// Two rotors with a shaft. The text `more` follows the keys of the shaft.
fn shafts(effects: &str, more: &str) -> String {
    format!(
        "model = \"train\"\neffects = {effects}\n[rotors]\na = \"1 kg*m^2\"\nb = \"2 kg*m^2\"\n[shafts.s]\nbetween = [\"a\", \"b\"]\n{more}\n\
         [run]\nt_end = \"1 ms\"\n"
    )
}

const STIFF: &str = "stiffness = \"1 kN*m/rad\"\n";

/// The values of a planet set are used for each of its planets. A mistake in such a value is still reported once.
#[test]
fn a_mistake_in_a_planet_set_is_reported_once() {
    let set = planets("count = 3", "\"400 MN/m\"", "\"400 MN/m\"");
    let law = "{ steps = [{ value = \"300 MN/m\", width = \"2 rad\" }, { value = \"-5 MN/m\" }] }";
    for (setting, said) in [
        ("backlash=-1 um", "`planets.p.backlash` must be positive"),
        ("friction=-1", "`planets.p.friction` must not be negative"),
        ("damping=3", "`planets.p.damping` is a linear damping: give a unit"),
        ("sun_stiffness=400 kg", "`planets.p.sun_stiffness` is a linear stiffness, but"),
        (&format!("ring_stiffness={law}"), "`planets.p.ring_stiffness.steps.1.value` must not be negative"),
        ("sun_stiffness={ teeth = [27, 36], module = \"2 mm\" }", "[planets.p.sun_stiffness] lacks `face_width`"),
        ("sun_stiffness={ step = 1 }", "[planets.p.sun_stiffness] has no `step`"),
    ] {
        let shown = rendered(&set, &[&format!("planets.p.{setting}")]);
        assert_eq!(shown.matches(said.split(':').next().unwrap()).count(), 1, "{setting}: {said}\n{shown}");
        assert!(!shown.contains("_p_s2") && !shown.contains("_p_r2"), "{shown}");
    }
    let effect = "effects=[\"damping\", \"sliding_friction\"]";
    let shown = rendered(&set, &["planets.p.friction=0.1", effect]);
    assert_eq!(shown.matches("effect `sliding_friction` needs `stiffness_step`").count(), 1, "{shown}");
}

#[test]
fn what_a_table_lacks_is_added_to_it() {
    let set = planets("count = 3", "\"400 MN/m\"", "\"400 MN/m\"");
    let shown = rendered(&set, &["effects=[\"stiffness_step\", \"damping\", \"backlash\"]"]);
    assert_eq!(shown.matches("lacks").count(), 1, "{shown}");
    assert!(shown.contains("[planets.p] lacks `backlash`") && shown.contains("backlash = \"... m\""), "{shown}");
    let shown = rendered(&set.replace("sun_stiffness = \"400 MN/m\"\n", ""), &[]);
    assert_eq!(shown.matches("[planets.p] lacks `sun_stiffness`").count(), 1, "{shown}");
    let friction = ["planets.p.friction=0.1", "effects=[\"stiffness_step\", \"sliding_friction\"]"];
    let shown = rendered(&set, &friction);
    assert_eq!(
        shown.matches("[planets.p] has friction, but no teeth in `sun_stiffness` and `ring_stiffness`").count(),
        1,
        "{shown}"
    );
    let mesh = "model = \"train\"\neffects = []\n[rotors]\na = \"1 kg*m^2\"\nb = \"1 kg*m^2\"\n[meshes.m]\nbetween = [\"a\", \"b\"]\n";
    let shown = rendered(mesh, &[]);
    assert!(shown.contains("[meshes.m] lacks `teeth` and `base_radius`"), "{shown}");
    let drive = "[drives.m]\nrotor = \"a\"\ndc = { stall_torque = \"1 N*m\" }\n";
    let shown = rendered(&shafts("[\"dc\"]", drive), &[]);
    assert!(shown.contains("[shafts.s] lacks `stiffness`") && shown.contains("lacks `no_load_speed`"), "{shown}");
}

/// A value that a program or the command line sets by the name of its parameter keeps this name.
#[test]
fn messages_name_the_key_that_was_written() {
    let text = shafts("[]", STIFF);
    assert!(rendered(&text, &["shafts.s.stiffness=-1 N*m/rad"]).contains("`shafts.s.stiffness` must"));
    assert!(rendered(&text, &["parameters.k_s=-1 N*m/rad"]).contains("`parameters.k_s` must"));
    let radius =
        |inertia: &str| rendered(&text, &[&format!("rotors.a={{ inertia = \"{inertia}\", radius = \"-1 m\" }}")]);
    assert!(radius("1 kg").contains("`rotors.a.radius` must be positive"));
    assert!(radius("1 kg*m^2").contains("`rotors.a.inertia` is in kg*m^2, and has a radius"));
    assert!(rendered(&text, &["rotors.a=1 kg"]).contains("{ inertia = \"1 kg\", radius ="));
    assert!(rendered(&text, &["parameters.k=1"]).contains("allowed: `I_a`"));
    assert!(rendered(&text, &["effects=[1]"]).contains("`effects.0` must be text"));
    assert!(rendered(&text, &["shaft.s=1"]).contains("did you mean `shafts`?"));
    assert!(!rendered(&text, &["rotors=[1]"]).contains("there is no rotor"));
    assert!(rendered(&text, &["rotors.a=1"]).contains("`rotors.a` is a moment of inertia: give a unit"));
    assert!(rendered(&text, &["shafts.s.stiffness=1"]).contains("write for example \"1 N*m/rad\""));
}

#[test]
fn rigid_shafts_are_refused_with_what_is_allowed() {
    for how in ["rigid = true", "stiffness = \"rigid\"", "stiffness = inf", "stiffness = \"inf N*m/rad\""] {
        let shown = rendered(&shafts("[]", how), &[]);
        assert_eq!(shown.matches('×').count(), 1, "{shown}");
        assert!(shown.contains("[shafts.s] is stated to be rigid") && shown.contains("train.toml:8"), "{shown}");
    }
    let support = "[supports.g]\nrotor = \"b\"\nstiffness = \"rigid\"";
    insta::assert_snapshot!(rendered(&shafts("[]", &format!("stiffness = \"rigid\"\n{support}")), &[]));
    let listed =
        "model = \"train\"\neffects = []\nshafts = [{ between = [\"a\", \"b\"] }]\n[rotors]\na = \"1 kg*m^2\"\n";
    assert!(rendered(listed, &[]).contains("under its name: [shafts.NAME]"));
}

/// 40 rotors in a row, with 39 shafts, and backlash at 12 meshes between pairs of them.
fn large(effects: &str) -> String {
    let mut text = format!("model = \"train\"\neffects = {effects}\n[rotors]\n");
    (0..40).for_each(|i| text += &format!("r{i} = \"1 kg*m^2\"\n"));
    for i in 0..39 {
        text += &match i % 3 {
            0 if i < 36 => format!(
                "[meshes.m{i}]\nbetween = [\"r{i}\", \"r{}\"]\nteeth = [20, 40]\nbase_radius = \"1 cm\"\nstiffness = \"1 MN/m\"\n",
                i + 1
            ),
            _ => format!("[shafts.s{i}]\nbetween = [\"r{i}\", \"r{}\"]\n{STIFF}", i + 1),
        };
    }
    text
}

#[test]
fn an_unknown_effect_of_a_large_train_is_answered_in_few_lines() {
    insta::assert_snapshot!(rendered(&large("[\"baklash\"]"), &[]));
    let shown = rendered(&large("[\"viscous_friction\"]"), &[]);
    assert!(shown.contains("no part of this train has it: state `shafts.NAME.damping` or"), "{shown}");
    let shown = rendered(&large("[\"\"]"), &[]);
    assert!(shown.contains("allowed: `damping`"), "{shown}");
    let shown = rendered(&large("[]").replace("\"r1\", \"r2\"", "\"r1\", \"x\""), &[]);
    assert!(shown.contains("there is no rotor `x`") && shown.len() < 1500, "{shown}");
}

/// A part without its effect would be absent without any message.
#[test]
fn torques_without_their_effect_are_named_in_a_warning() {
    let warned = |effects: &str, more: &str| parse(&shafts(effects, &format!("{STIFF}{more}")), &[]).unwrap().warnings;
    let motor = "[drives.m]\nrotor = \"a\"\ndc = { stall_torque = \"1 N*m\", no_load_speed = \"100 rpm\" }\n";
    let said = "`drives.m.dc.stall_torque` and `drives.m.dc.no_load_speed` do nothing without the effect `dc`: add it to \
                `effects`, or leave them out";
    assert_eq!(warned("[]", motor), [said]);
    let clutch = "[clutches.c]\nbetween = [\"a\", \"b\"]\n";
    assert_eq!(
        warned("[]", clutch),
        ["[clutches.c] does nothing without the effect `overrunning_clutch`: add it to `effects`, or leave it out"]
    );
    assert_eq!(warned("[\"dc\"]", motor), [""; 0]);
    let loads = "[loads.f]\nrotor = \"b\"\nfan = { coefficient = \"1 N*m*s^2/rad^2\" }\n[loads.t]\nrotor = \"b\"\ntorque = \"1 N*m\"\n\
                 [bearings.q]\nrotor = \"a\"\nfriction = \"1 N*m\"\n";
    let shown = warned("[]", loads).join("\n");
    for said in ["`loads.f.fan.coefficient` does nothing without the effect `fan`", "`torques`", "`dry_friction`"] {
        assert!(shown.contains(said), "{shown}");
    }
    assert_eq!(warned("[\"fan\", \"torques\", \"dry_friction\"]", loads), [""; 0]);
    let rising = "[loads.t]\nrotor = \"b\"\ntorque = { ramp = { to = \"1 N*m\", duration = \"1 s\" } }\n";
    assert_eq!(warned("[]", rising).len(), 1);
    // One of the two kinds of friction is active.
    let both = "[bearings.q]\nrotor = \"a\"\nfriction = \"1 N*m\"\nviscous = \"1 N*m*s/rad\"\n";
    let said = warned("[\"viscous_friction\"]", both);
    assert!(said.len() == 1 && said[0].starts_with("`bearings.q.friction` does nothing"), "{said:?}");
    // A torque of 0 states that there is none.
    assert_eq!(warned("[]", "[loads.t]\nrotor = \"b\"\ntorque = 0\n"), [""; 0]);
}

/// Values of a mesh that no effect uses are named, also the laws.
#[test]
fn values_of_a_mesh_without_their_effect_are_named_in_a_warning() {
    let more =
        "backlash = \"60 um\"\nerror = { harmonics = [{ order = 1, amplitude = \"5 um\" }] }\ndamping = \"6 N*s/m\"";
    let text = |effects: &str, more: &str| {
        format!(
            "model = \"train\"\neffects = [{effects}]\n[rotors]\n1 = \"3e-3 kg*m^2\"\n2 = \"2e-2 kg*m^2\"\n[meshes.12]\n\
             between = [\"1\", \"2\"]\nteeth = [24, 96]\nmodule = \"3 mm\"\n{more}\nstiffness = \"200 MN/m\"\n"
        )
    };
    let without = |key: &str, effect: &str| {
        format!("`meshes.12.{key}` does nothing without the effect `{effect}`: add it to `effects`, or leave it out")
    };
    let warnings = parse(&text("", more), &[]).unwrap().warnings;
    let said = [("damping", "viscous_friction"), ("backlash", "backlash"), ("error", "transmission_error")];
    assert_eq!(warnings, said.map(|(key, effect)| without(key, effect)));
    let all = "\"stiffness_step\", \"backlash\", \"viscous_friction\", \"transmission_error\"";
    assert_eq!(parse(&text(all, more), &[]).unwrap().warnings, [""; 0]);
    assert_eq!(parse(&text("", "error = { steps = [{ value = \"0 um\" }] }"), &[]).unwrap().warnings, [""; 0]);
}

/// A law for a value that is constant is refused, whether the constant value is stated too or not.
#[test]
fn a_law_of_a_shaft_is_refused_with_its_constant_stiffness() {
    let law = "[laws.k_s]\nsteps = [{ value = \"1 kN*m/rad\" }]";
    for stiffness in [STIFF, ""] {
        let shown = rendered(&shafts("[]", &format!("{stiffness}{law}")), &[]);
        let said = "`k_s` (torsional stiffness of the shaft s) is constant: state `shafts.s.stiffness` alone, and leave out [laws.k_s]";
        assert!(shown.contains("[laws] has no `k_s`") && shown.contains(said), "{shown}");
    }
    let shown = rendered(&shafts("[]", &format!("{STIFF}{}", law.replace("k_s", "k_t"))), &[]);
    assert!(shown.contains("no part of this scene has a law: leave out [laws]"), "{shown}");
}

/// A name with a dot is not one key but two, in the text of a scene and in an override.
#[test]
fn a_name_with_a_dot_is_refused() {
    for (others, set) in [("[rotors.c.d]\ninertia = \"1 kg*m^2\"", vec![]), ("", vec!["rotors.c.d=1 kg*m^2"])] {
        let shown = rendered(&shafts("[]", &format!("{STIFF}{others}")), &set);
        assert!(shown.contains("[rotors.c] has no `d`"), "{shown}");
        assert!(shown.contains("a name has no dots: `c.d` is the key `d` of `c`"), "{shown}");
    }
    let shown = rendered(&shafts("[]", STIFF), &["shafts.s.stifness=1 kN*m/rad"]);
    assert!(shown.contains("did you mean `stiffness`?") && !shown.contains("a name has no dots"), "{shown}");
}

/// The keys that do nothing without an effect. The help for an unknown effect of a train names them.
#[test]
fn keys_know_their_effects() {
    let of = |effect: &str| keys_of(effect).join(" ");
    let dampers =
        ["shafts", "supports", "meshes", "planets", "thrust_bearings"].map(|table| format!("{table}.NAME.damping"));
    assert_eq!(of("viscous_friction"), format!("{} bearings.NAME.viscous", dampers.join(" ")));
    assert_eq!(of("transmission_error"), "meshes.NAME.error planets.NAME.sun_error");
    assert_eq!(of("backlash"), "meshes.NAME.backlash planets.NAME.backlash");
    assert_eq!(of("sliding_friction"), "meshes.NAME.friction planets.NAME.friction");
    assert_eq!(of("dry_friction"), "bearings.NAME.friction");
    let stops = ["upper", "lower", "stiffness"].map(|key| format!("end_stops.NAME.{key}"));
    assert_eq!(of("end_stop"), stops.join(" "));
    assert_eq!(of("overrunning_clutch"), "clutches.NAME.capacity");
    assert_eq!(of("torques"), "drives.NAME.torque loads.NAME.torque");
    let motors = ["dc", "induction", "traction"];
    motors.iter().for_each(|motor| assert_eq!(of(motor), format!("drives.NAME.{motor}")));
    assert_eq!(of("governor") + " " + &of("fan"), "drives.NAME.governor loads.NAME.fan");
    assert_eq!(of("friction"), "");
}
