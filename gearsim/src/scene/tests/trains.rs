//! Laws of trains that contradict their meshes, and planets that cannot be assembled.

use crate::known::MODELS;
use crate::scene::Scene;

pub(super) fn parse(text: &str, set: &[&str]) -> Result<Scene, String> {
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let set: Vec<_> = set.iter().map(ToString::to_string).collect();
    Scene::parse("train", "train.toml", text, &set, &models).map_err(|mistakes| mistakes.render(240, false))
}

/// The message for a refused scene, on one line.
fn refused(text: &str, set: &[&str]) -> String {
    let shown = parse(text, set).expect_err(text);
    shown.split_whitespace().collect::<Vec<_>>().join(" ")
}

const END: &str = "[parameters]\nbeta_K = \"2 us\"\n[start]\nspeed = \"1500 rpm\"\n[run]\nt_end = \"10 ms\"\n";

/// A mesh of two rotors, its numbers of teeth, other keys, and the keys of its law.
fn pair(mesh: &str, [a, b]: [&str; 2], teeth: [u32; 2], keys: &str, law: &str) -> String {
    format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"damping\"]\n[rotors]\n{a} = \"3e-3 kg*m^2\"\n{b} = \"2e-2 kg*m^2\"\n\
         [meshes.{mesh}]\nbetween = [\"{a}\", \"{b}\"]\nteeth = {teeth:?}\n{keys}\nstiffness = {{ {law} }}\n{END}"
    )
}

const MODULE: &str = "module = \"3 mm\"";
const LAW: &str = "teeth = [24, 96], module = \"3 mm\", face_width = \"25 mm\"";

/// The law of a mesh is compared with the table of the mesh, whatever mesh and rotors are called.
#[test]
fn a_law_has_the_gears_of_its_mesh() {
    for (mesh, rotors) in [("12", ["1", "2"]), ("g", ["pinion", "wheel"]), ("910", ["9", "10"]), ("21", ["1", "2"])] {
        let with = |keys: &str, law: &str| pair(mesh, rotors, [24, 96], keys, law);
        parse(&with(MODULE, LAW), &[]).unwrap();
        for (law, said) in [
            (LAW.replace("96", "90"), "has 90 teeth for a gear with N"),
            (LAW.replace("3 mm", "4 mm"), "the base radius of the teeth of `meshes."),
            (format!("{LAW}, helix_angle = \"20 deg\""), "the base radius of the teeth of `meshes."),
        ] {
            let shown = refused(&with(MODULE, &law), &[]);
            assert!(shown.contains(said), "{mesh} {law}: {shown}");
        }
        let helical = format!("{MODULE}\nhelix_angle = \"20 deg\"");
        assert!(refused(&with(&helical, LAW), &[]).contains("the base radius of the teeth"), "{mesh}");
        parse(&with(&helical, &format!("{LAW}, helix_angle = \"20 deg\"")), &[]).unwrap();
        // A law with the right base radius may have another helix.
        let of_spur = "base_radius = \"33.829 mm\"\nhelix_angle = \"20 deg\"";
        assert!(refused(&with(of_spur, LAW), &[]).contains("base helix angle of 0.00 deg"), "{mesh}");
    }
    // The gears are those of the table, not those of the digits in its name.
    let turned =
        pair("12", ["2", "1"], [96, 24], MODULE, "teeth = [96, 24], module = \"3 mm\", face_width = \"25 mm\"");
    parse(&turned, &[]).unwrap();
}

#[test]
fn a_law_is_internal_if_its_mesh_is() {
    let internal = format!("{MODULE}\ninternal = true");
    let rings = |scene: &Scene| scene.gears.iter().flatten().map(|gears| gears.internal).collect::<Vec<_>>();
    let law = format!("{LAW}, addendum = [1, 0.8]");
    let scene = parse(&pair("g", ["a", "b"], [24, 96], &internal, &law), &[]).unwrap();
    assert_eq!(rings(&scene), [true]);
    for (keys, law, said) in [
        (
            MODULE,
            format!("{law}, internal = true"),
            "has internal = true, but the mesh of [meshes.g], `k_g`, is external",
        ),
        (&internal, format!("{law}, internal = false"), "is of a ring gear"),
    ] {
        let shown = refused(&pair("g", ["a", "b"], [24, 96], keys, &law), &[]);
        assert!(shown.contains(said), "{shown}");
    }
    let small = pair("g", ["a", "b"], [96, 24], &internal, "steps = [{ value = \"200 MN/m\" }]");
    assert!(refused(&small, &[]).contains("[meshes.g] has a ring of 24 teeth around a gear of 96"));
    let sun = "{ teeth = [27, 36], module = \"2 mm\", face_width = \"25 mm\"";
    let ring = "{ teeth = [36, 99], module = \"2 mm\", face_width = \"25 mm\", addendum = [1, 0.8]";
    let set = |sun: &str, ring: &str| planets("count = 3", &format!("{sun} }}"), &format!("{ring} }}"));
    assert_eq!(rings(&parse(&set(sun, ring), &[]).unwrap()), [false, true, false, true, false, true]);
    assert!(refused(&set(&format!("{sun}, internal = true"), ring), &[]).contains("is external"));
    assert!(refused(&set(sun, &format!("{ring}, internal = false")), &[]).contains("is of a ring gear"));
}

/// A planet set with 27 and 99 teeth, with its places and its laws.
pub(super) fn planets(places: &str, sun: &str, ring: &str) -> String {
    format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"damping\"]\n[rotors]\ns = \"2e-3 kg*m^2\"\nc = \"5e-2 kg*m^2\"\n\
         [planets.p]\nsun = \"s\"\nring = \"ground\"\ncarrier = \"c\"\nteeth = [27, 99]\nmodule = \"2 mm\"\n{places}\n\
         mass = \"0.7 kg\"\ninertia = \"1.6e-3 kg*m^2\"\nsun_stiffness = {sun}\nring_stiffness = {ring}\n{END}"
    )
}

#[test]
fn rigid_planets_are_refused_once_with_what_is_allowed() {
    let shown = refused(&planets("count = 3", "\"rigid\"", "\"400 MN/m\""), &[]);
    assert_eq!(shown.matches("×").count(), 1, "{shown}");
    assert!(shown.contains("`sun_stiffness` of [planets.p] is \"rigid\"") && shown.contains("\"500 MN/m\""), "{shown}");
}

/// 27 + 99 teeth: planets fit at multiples of 360/126 deg.
#[test]
fn planets_that_cannot_be_assembled_are_refused_where_phases_follow_from_their_places() {
    let steps = "{ steps = [{ value = \"300 MN/m\", width = \"2 rad\" }, { value = \"500 MN/m\" }] }";
    let constant = "\"400 MN/m\"";
    let uneven = "at = [\"0 deg\", \"118 deg\", \"240 deg\"]";
    for (places, said) in [
        ("count = 4", "planet 2 of [planets.p] at 90.0000 deg does not fit between 27 and 99 teeth"),
        (uneven, "the nearest are 117.1429 and 120.0000 deg"),
        ("at = [\"10 deg\", \"130 deg\", \"250 deg\"]", "counted from a planet at 0 deg"),
    ] {
        let shown = refused(&planets(places, steps, constant), &[]);
        assert!(shown.contains(said), "{places}: {shown}");
    }
    for places in ["count = 3", "at = [\"0 deg\", \"117.14 deg\", \"240 deg\"]"] {
        assert_eq!(parse(&planets(places, steps, steps), &[]).unwrap().warnings, [""; 0], "{places}");
    }
    // Constant stiffnesses have no phase.
    let warnings = parse(&planets("count = 4", constant, constant), &[]).unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("does not fit"), "{warnings:?}");
    let turned = planets("at = [\"10 deg\", \"130 deg\", \"250 deg\"]", constant, constant);
    assert_eq!(parse(&turned, &[]).unwrap().warnings, [""; 0]);
}

/// Sun and ring differ by an odd number: no whole number of planet teeth follows. Stated ones count for the room that the planets have, and
/// must mesh with both at one centre distance.
#[test]
fn planet_teeth_are_whole_fit_and_have_room() {
    let set = |teeth: [u32; 2], more: &str| {
        let [sun, ring] = teeth;
        planets(&format!("count = 5\n{more}"), "\"400 MN/m\"", "\"500 MN/m\"")
            .replace("teeth = [27, 99]", &format!("teeth = [{sun}, {ring}]"))
    };
    let shown = refused(&set([24, 91], ""), &[]);
    assert!(
        shown.contains("[planets.p] lacks `planet_teeth`: half the difference of 91 and 24 teeth is 33.5"),
        "{shown}"
    );
    assert!(shown.contains("planet_teeth = 33 or 34") && shown.matches("×").count() == 1, "{shown}");
    // Centres are 2 (25 + 90)/4 sin 36 deg = 33.8 modules apart, tip diameters 33 or 34.5 modules.
    assert_eq!(parse(&set([25, 90], "planet_teeth = 31"), &[]).unwrap().warnings, [""; 0]);
    let warnings = parse(&set([25, 91], "planet_teeth = 33"), &[]).unwrap().warnings;
    assert!(
        warnings.iter().any(|said| said.contains("two planets with 33 teeth are 34.1 modules apart")),
        "{warnings:?}"
    );
    for teeth in [1, 20, 50, 98] {
        let shown = refused(&set([27, 98], &format!("planet_teeth = {teeth}")), &[]);
        let said = format!("`planets.p.planet_teeth` is {teeth}, but planets of {teeth} teeth do not mesh");
        assert!(shown.contains(&said) && shown.contains("35.5 teeth, half the difference"), "{shown}");
    }
}

/// Teeth with profile shift work at another angle than that of their rack: each mesh has its own. By the involute equations of DIN 3960,
/// inv(alpha_w) = inv(20 deg) + 2 (x_1 + x_2)/(z_1 + z_2) tan(20 deg).
#[test]
fn each_mesh_works_at_the_angle_of_its_teeth() {
    let involute = |angle: f64| angle.tan() - angle;
    let working = |teeth: f64, shifts: f64| {
        let rack = 20f64.to_radians();
        let wanted = involute(rack) + 2.0 * shifts / teeth * rack.tan();
        // Newton's method; the derivative of the involute is tan^2.
        (0..50).fold(0.4f64, |angle, _| angle - (involute(angle) - wanted) / angle.tan().powi(2))
    };
    let stage = |name: &str, ends: [&str; 2], teeth: [u32; 2], shift: &str| {
        let ([a, b], [z, y]) = (ends, teeth);
        format!(
            "[meshes.{name}]\nbetween = [\"{a}\", \"{b}\"]\nteeth = [{z}, {y}]\nmodule = \"3 mm\"\n\
             stiffness = {{ teeth = [{z}, {y}], module = \"3 mm\", face_width = \"20 mm\"{shift} }}\n"
        )
    };
    let rotors = "model = \"train\"\neffects = [\"stiffness_step\", \"damping\"]\n[rotors]\n1 = \"1e-4 kg*m^2\"\n2 = \"1e-3 kg*m^2\"\n3 = \"1e-3 kg*m^2\"\n\
                  4 = \"1e-2 kg*m^2\"\n[shafts.m]\nbetween = [\"2\", \"3\"]\nstiffness = \"50 kN*m/rad\"\n";
    let shifted = stage("a", ["1", "2"], [12, 24], ", profile_shift = [0.6, 0.36]");
    let scene = parse(&format!("{rotors}{shifted}{}{END}", stage("b", ["3", "4"], [19, 57], "")), &[]).unwrap();
    assert_eq!(scene.warnings, [""; 0]);
    for (name, angle) in [("alpha_a", working(36.0, 0.96)), ("alpha_b", 20f64.to_radians())] {
        let found = scene.parameter(name).unwrap();
        assert!((found - angle).abs() < 1e-9, "{name}: {} {}", found.to_degrees(), angle.to_degrees());
    }

    // Sun 27, planets 35, ring 98 at a centre distance of 62.5 mm: cos(alpha_w) = (z_1 + z_2) cos(20 deg) m/(2 a).
    let teeth = |teeth: [u32; 2], more: &str| {
        format!(
            "{{ teeth = {teeth:?}, module = \"2 mm\", face_width = \"20 mm\", centre_distance = \"62.5 mm\"{more} }}"
        )
    };
    let sun = teeth([27, 35], ", profile_shift = [0.13, 0.128]");
    let ring = teeth([35, 98], ", internal = true, profile_shift = [0.128, -0.115]");
    let set = planets("count = 5\nplanet_teeth = 35\npressure_angle = \"20 deg\"", &sun, &ring);
    let scene = parse(&set.replace("teeth = [27, 99]", "teeth = [27, 98]"), &[]).unwrap();
    let at = |teeth: f64| (teeth * 20f64.to_radians().cos() * 2.0 / 125.0).acos();
    for (name, angle) in [("alpha_p_s", at(62.0)), ("alpha_p_r", at(63.0)), ("alpha_p", at(62.5))] {
        let found = scene.parameter(name).unwrap();
        assert!((found - angle).abs() < 1e-9, "{name}: {} {}", found.to_degrees(), angle.to_degrees());
    }
    assert!(scene.warnings.len() == 1 && scene.warnings[0].contains("with 35 teeth"), "{:?}", scene.warnings);
}

/// Some values are computed from keys of tables, not from parameters: the base radius from the module and the teeth, the phases of planets
/// from their teeth. Therefore these values cannot be set as parameters.
#[test]
fn parameters_from_which_others_follow_are_set_in_their_tables() {
    let constant = "steps = [{ value = \"200 MN/m\" }]";
    let helical = format!("{MODULE}\nhelix_angle = \"20 deg\"\npressure_angle = \"20 deg\"");
    let scene = pair("12", ["1", "2"], [24, 96], &helical, constant);
    for (set, key) in [
        ("parameters.N1=30", "set `meshes.12.teeth.0` instead"),
        ("parameters.alpha12=25 deg", "set `meshes.12.pressure_angle` instead"),
        ("parameters.tanb12=0.2", "set `meshes.12.helix_angle` instead"),
    ] {
        let shown = refused(&scene, &[set]);
        assert!(shown.contains(key), "{set}: {shown}");
    }
    let set = planets("count = 3", "\"400 MN/m\"", "\"500 MN/m\"");
    for (parameter, key) in [
        ("parameters.Zs_p=30", "planets.p.teeth.0"),
        ("parameters.Zr_p=102", "planets.p.teeth.1"),
        ("parameters.Zp_p=35", "planets.p.planet_teeth"),
        ("parameters.np_p=4", "planets.p.count"),
    ] {
        let shown = refused(&set, &[parameter]);
        assert!(shown.contains(&format!("set `{key}` instead")), "{parameter}: {shown}");
    }
    // By its own key the base radius follows: module x teeth/2 x cos(20 deg).
    let scene = parse(&pair("12", ["1", "2"], [24, 96], MODULE, constant), &["meshes.12.teeth.0=30"]).unwrap();
    let radius = 3e-3 * 30.0 / 2.0 * 20f64.to_radians().cos();
    assert!((scene.parameter("r1").unwrap() / radius - 1.0).abs() < 1e-12);
    // Nothing follows from the teeth of a mesh with a base radius, nor from those of the second gear.
    let scene = pair("12", ["1", "2"], [24, 96], "base_radius = \"33.83 mm\"", constant);
    let scene = parse(&scene, &["parameters.N1=30", "parameters.N2=90", "parameters.r1=40 mm"]).unwrap();
    assert_eq!(["N1", "N2", "r1"].map(|name| scene.parameter(name).unwrap()), [30.0, 90.0, 0.04]);
}

/// A key of a table that is set replaces a value of the text in `[parameters]`.
#[test]
fn a_table_that_is_set_replaces_the_text() {
    let scene = pair("12", ["1", "2"], [24, 96], "base_radius = \"30 mm\"", "steps = [{ value = \"200 MN/m\" }]");
    let scene = scene.replace("teeth = [24, 96]\n", "").replace("beta_K", "N1 = 24\nN2 = 96\nbeta_K");
    assert_eq!(parse(&scene, &[]).unwrap().parameter("N1"), Some(24.0));
    assert_eq!(parse(&scene, &["meshes.12.teeth=[30, 96]"]).unwrap().parameter("N1"), Some(30.0));
}

/// A damaged tooth belongs to a gear of its mesh. Shares of three pairs and of two, from entry to exit: with a contact ratio of 2.3 the pair
/// is one of three for 0.3 pitches, one of two for 0.7, and so on.
#[test]
fn a_damaged_tooth_loses_the_share_of_its_pair() {
    let high = "addendum = 1.4, dedendum = 1.7, fillet = 0.2";
    let law = |damage: &str| pair("g", ["a", "b"], [24, 96], MODULE, &format!("{LAW}, {high}{damage}"));
    let levels = |damage: &str| -> Vec<f64> {
        parse(&law(damage), &[]).unwrap().laws[0].steps.iter().map(|step| step.value / 1e6).collect()
    };
    let healthy = levels("");
    let [two, three] = healthy[..] else { panic!("{healthy:?}") };
    let damaged = levels(", damage = [{ tooth = 1, of = 24, loss = 1 }]");
    let want = [two, three * 2.0 / 3.0, two / 2.0, three * 2.0 / 3.0, two / 2.0, three * 2.0 / 3.0, two, three];
    for (k, want) in damaged.iter().zip(want) {
        assert!((k / want - 1.0).abs() < 1e-12, "{damaged:?}");
    }
    let shown = refused(&law(", damage = [{ tooth = 1, of = 30, loss = 1 }]"), &[]);
    assert!(shown.contains("is 30, but the gears of this mesh have 24 and 96 teeth"), "{shown}");
    let steps = "steps = [{ value = \"2 MN/m\", width = \"2 rad\" }, { value = \"3 MN/m\" }]";
    let shown = refused(
        &pair("g", ["a", "b"], [24, 96], MODULE, &format!("{steps}, damage = [{{ tooth = 1, of = 25, loss = 0.3 }}]")),
        &[],
    );
    assert!(shown.contains("have 24 and 96 teeth"), "{shown}");
}
