//! Scenes whose parameters are written as papers print them: I/r^2 in kg, torsional supports in N/m.

use gearsim::Scene;

/// Table 1 of Lin & Parker (1999) as it is printed. The radii follow from the teeth and from the base diameter of the sun.
const TABLE_1: &str = r#"
effects = []

[parameters]
Z_s = 27
Z_r = 99
r_s = "38.7 mm"
alpha = "24.6 deg"
m_s = "0.4 kg"
m_r = "2.35 kg"
m_c = "5.43 kg"
m_p = "0.66 kg"
I_s = "0.39 kg"
I_r = "3.00 kg"
I_c = "6.29 kg"
I_p = "0.61 kg"
kb_s = "1e8 N/m"
kb_r = "1e8 N/m"
kb_c = "1e8 N/m"
kb_p = "1e8 N/m"
k_r = "1e9 N/m"

[laws]
"#;

/// Natural frequencies of the planar planetary with `n` planets [Hz], rising.
pub fn lin_parker(n: usize) -> Vec<f64> {
    let meshes = (1..=n).flat_map(|i| [format!("k_s{i}"), format!("k_r{i}")]);
    let laws: String = meshes.map(|k| format!("{k} = {{ steps = [{{ value = \"5e8 N/m\" }}] }}\n")).collect();
    frequencies(&format!("model = \"planar_planetary_{n}\"{TABLE_1}{laws}"))
}

/// Torsional supports of sun and carrier in N/m, as the paper writes them (k_su, k_cu). In the translational modes, which come in pairs,
/// and in the planet modes no central member rotates, so these modes keep their printed frequencies. The frequencies of the rotational
/// modes rise, and the rigid rotation becomes a vibration. The paper's matrices with all supports are in `by_hand`.
fn supports_of_sun_and_carrier() {
    type Printed = &'static [f64];
    let printed: [(usize, Printed, Printed, Printed); 2] = [
        (3, &[743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9], &[], &[0.0, 1475.7, 1930.3, 2658.3, 7462.8, 11775.3]),
        (
            4,
            &[727.27, 1091.16, 1892.8, 2342.5, 7189.9, 10437.6],
            &[1808.2, 5963.8, 6981.7],
            &[0.0, 1536.6, 1970.6, 2625.7, 7773.6, 13071.1],
        ),
    ];
    for (n, pairs, planets, rotations) in printed {
        let meshes = (1..=n).flat_map(|i| [format!("k_s{i}"), format!("k_r{i}")]);
        let laws: String = meshes.map(|k| format!("{k} = {{ steps = [{{ value = \"5e8 N/m\" }}] }}\n")).collect();
        let held = |effects: &str, supports: &str| {
            let table = TABLE_1.replace("effects = []", effects).replace("[laws]", &format!("{supports}\n[laws]"));
            frequencies(&format!("model = \"planar_planetary_{n}\"{table}{laws}"))
        };
        let both = held("effects = [\"torsional_support\"]", "k_s = \"2e8 N/m\"\nk_c = \"5e8 N/m\"");
        let sun = held("effects = [\"torsional_support_s\"]", "k_s = \"2e8 N/m\"");
        for found in [&both, &sun] {
            let near = |f: f64| found.iter().filter(|found| (**found / f - 1.0).abs() < 1e-4).count();
            pairs.iter().for_each(|f| assert_eq!(near(*f), 2, "{n} planets, {f} Hz: {found:?}"));
            planets.iter().for_each(|f| assert_eq!(near(*f), 1, "{n} planets, {f} Hz: {found:?}"));
        }
        let rotating = |found: &[f64]| -> Vec<f64> {
            let known = |f: &f64| pairs.iter().chain(planets).any(|printed| (f / printed - 1.0).abs() < 1e-4);
            found.iter().copied().filter(|f| !known(f)).collect()
        };
        // By the min-max theorem (Courant and Fischer), no frequency decreases when a spring is added.
        let (free, sun, both) = (rotations, rotating(&sun), rotating(&both));
        assert!(sun.len() == 6 && both.len() == 6 && sun[0] > 100.0, "{sun:?} {both:?}");
        for i in 0..6 {
            assert!(free[i] < sun[i] * (1.0 + 1e-4) && sun[i] < both[i] * (1.0 + 1e-9), "{free:?} {sun:?} {both:?}");
        }
    }
}

fn frequencies(text: &str) -> Vec<f64> {
    let scene = Scene::from_toml("printed", text).unwrap_or_else(|e| panic!("{e}"));
    scene.modes().expect("a linear cell").modes.iter().map(|mode| mode.natural).collect()
}

pub const TESTS: &[(&str, fn())] = &[
    ("gears_in_kg", gears_in_kg),
    ("supports_of_sun_and_carrier", supports_of_sun_and_carrier),
    ("supports_of_a_train", supports_of_a_train),
    ("the_radius_is_named", the_radius_is_named),
    ("bearing_dampers", bearing_dampers),
    ("modes_need_no_run", modes_need_no_run),
    ("contact_ratio_and_levels_follow_from_teeth", contact_ratio_and_levels_follow_from_teeth),
];

const PAIR: &str = r#"
model = "train"
effects = ["viscous_friction"]
[rotors]
a = "2 kg"
b = "3 kg"
[supports.a]
rotor = "a"
stiffness = "1e7 N/m"
[meshes.ab]
between = ["a", "b"]
teeth = [20, 60]
module = "3 mm"
stiffness = "1e8 N/m"
damping = "600 N*s/m"
"#;

/// Two gears of 2 and 3 kg and a mesh: omega^2 = k (1/2 + 1/3), for any radii. The damping c of the mesh in N s/m gives
/// zeta = c/2 sqrt((1/2 + 1/3)/k).
fn gears_in_kg() {
    let free = PAIR.replace("stiffness = \"1e7 N/m\"", "stiffness = \"0 N/m\"");
    let scene = Scene::from_toml("pair", &free).unwrap_or_else(|e| panic!("{e}"));
    let modes = scene.modes().unwrap().modes;
    let (k, per_mass) = (1e8f64, 1.0 / 2.0 + 1.0 / 3.0);
    let (f, zeta) = ((k * per_mass).sqrt() / std::f64::consts::TAU, 600.0 / 2.0 * (per_mass / k).sqrt());
    assert!(modes[0].natural < 1e-6 * f && (modes[1].natural / f - 1.0).abs() < 1e-12, "{modes:?}");
    assert!((modes[1].zeta.unwrap() / zeta - 1.0).abs() < 1e-10, "{:?}, not {zeta}", modes[1].zeta);
    let said = scene.conversions.join("\n");
    let radius = 20.0 * 3e-3 * 20f64.to_radians().cos() / 2.0;
    assert!(
        said.contains("`I_a` = 2 kg (0.02819078 m)^2")
            && (scene.parameter("I_a").unwrap() / (2.0 * radius * radius) - 1.0).abs() < 1e-12
    );
}

/// A support of 1e7 N/m at the first gear: M = diag(2, 3), K = ((k + s, -k), (-k, k)), by the quadratic formula.
fn supports_of_a_train() {
    let (k, s, a, b) = (1e8f64, 1e7, 2.0, 3.0);
    let (p, q) = ((k + s) / a + k / b, s * k / (a * b));
    let root = (p * p / 4.0 - q).sqrt();
    let expected = [p / 2.0 - root, p / 2.0 + root].map(|w2: f64| w2.sqrt() / std::f64::consts::TAU);
    for (found, expected) in frequencies(&PAIR.replace("\"viscous_friction\"", "")).iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-11, "{found}, not {expected}");
    }
}

/// Where no gear gives the radius, the value states it, as a length or as the name of a parameter. Without a radius the scene is refused.
fn the_radius_is_named() {
    let shaft = "model = \"chain_2\"\neffects = []\n[parameters]\nI1 = { value = \"2 kg\", radius = \"0.5 m\" }\n\
                 I2 = { value = \"3 kg\", radius = \"0.5 m\" }\nk1 = { value = \"1e6 N/m\", radius = \"0.5 m\" }\n";
    let expected = (1e6f64 * (1.0 / 2.0 + 1.0 / 3.0)).sqrt() / std::f64::consts::TAU;
    assert!((frequencies(shaft)[1] / expected - 1.0).abs() < 1e-12);
    let refused = |text: &str| Scene::from_toml("chain", text).expect_err(text).to_string();
    let unknown = refused(&shaft.replace("{ value = \"2 kg\", radius = \"0.5 m\" }", "\"2 kg\""));
    assert!(unknown.contains("no gear with a base radius") && unknown.contains("radius = \"... mm\""), "{unknown}");
    let wrong = refused(&shaft.replace("\"2 kg\"", "\"2 kg*m^2\""));
    assert!(wrong.contains("is in kg*m^2, and has a radius"), "{wrong}");
    let negative = refused(&shaft.replacen("0.5 m", "-0.5 m", 1));
    assert!(negative.contains("must be positive"), "{negative}");
    let named = format!("model = \"planar_planetary_3\"{TABLE_1}")
        .replace("I_c = \"6.29 kg\"", "I_c = { value = \"6.29 kg\", radius = \"r_s\" }");
    let laws: String = (1..=3).map(|i| format!("k_s{i} = {{ steps = [{{ value = \"5e8 N/m\" }}] }}\nk_r{i} = {{ steps = [{{ value = \"5e8 N/m\" }}] }}\n")).collect();
    let scene = Scene::from_toml("named", &(named + &laws)).unwrap_or_else(|e| panic!("{e}"));
    assert!((scene.parameter("I_c").unwrap() / (6.29 * 0.0387 * 0.0387) - 1.0).abs() < 1e-12);
}

/// Dampers of bearings, each with its own coefficient. The mesh has no stiffness here, so the accelerations of the centres are
/// -(kb x + cb x')/m.
fn bearing_dampers() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/gear_pair_bearings.toml"))
            .unwrap();
    let scene = Scene::from_toml("bearings", &text).unwrap_or_else(|e| panic!("{e}"));
    let damped = scene
        .with_all([
            ("effects", (&["viscous_friction"][..]).into()),
            ("parameters.cb1", "300 N*s/m".into()),
            ("parameters.cb2", "500 N*s/m".into()),
        ])
        .unwrap_or_else(|e| panic!("{e}"));
    let n = damped.model.coordinates.len();
    let at = |name: &str| damped.model.coordinates.iter().position(|c| c.name == name).unwrap();
    let (mut q, mut v) = (vec![0.0; n], vec![0.0; n]);
    for (name, x, x_dot) in [("x1", 1e-5, 0.02), ("y1", -2e-5, 0.01), ("x2", 3e-6, -0.03), ("y2", 1e-6, 0.04)] {
        (q[at(name)], v[at(name)]) = (x, x_dot);
    }
    let found = damped.acceleration(&q, &v, &[0.0]).unwrap();
    for (gear, c) in [("1", 300.0), ("2", 500.0)] {
        let [k, m] = ["kb", "m"].map(|name| damped.parameter(&format!("{name}{gear}")).unwrap());
        for axis in ["x", "y"] {
            let i = at(&format!("{axis}{gear}"));
            let expected = -(k * q[i] + c * v[i]) / m;
            assert!((found[i] / expected - 1.0).abs() < 1e-12, "{axis}{gear}: {}, not {expected}", found[i]);
        }
    }
    // Their power is in the energy account. Without it the run would be refuted.
    let run = damped.with("run.t_end", "2 ms").unwrap().run().unwrap();
    assert!(run.summary().refuted.is_none());
}

/// Modes need no `[run]` and no torques. A run without `[run]` is refused. The missing table is also named along with other mistakes.
fn modes_need_no_run() {
    let scene = Scene::from_toml("pair", PAIR).unwrap_or_else(|e| panic!("{e}"));
    assert!(scene.t_end.is_infinite() && scene.modes().is_ok());
    let refused = scene.run().expect_err("it has no end").to_string();
    assert!(refused.contains("no [run]") && refused.contains("t_end = "), "{refused}");
    assert!(scene.with("run.t_end", "1 ms").unwrap().run().is_ok());
    let two = Scene::from_toml("pair", &PAIR.replace("viscous", "viscose")).expect_err("no such effect").to_string();
    assert!(two.contains("lacks `[run]`"), "{two}");
}

/// The gears of Oh, Grosh & Barber (2005) have the contact ratio 1.72491, with one pair in contact over 1.728 rad. For the helical gears of
/// ISO/TR 6336-30 the overlap ratio is tested. The standard prints c' = 12.37047 and c_gamma_alpha = 17.46485 N/(mm um), which are not
/// compared here.
fn contact_ratio_and_levels_follow_from_teeth() {
    let spur = PAIR.replace(
        "stiffness = \"1e8 N/m\"",
        "stiffness = { teeth = [20, 60], module = \"3 mm\", face_width = \"20 mm\" }",
    );
    let text = spur.replace("20, 60", "24, 96").replace("3 mm", "6.35 mm") + "[run]\nt_end = \"1 ms\"\n";
    let summary = Scene::from_toml("pair", &text).unwrap_or_else(|e| panic!("{e}")).run().unwrap().summary();
    let law = &summary.laws_from_teeth["k_ab"];
    let widths: Vec<f64> = law.levels.iter().map(|level| level.width.0).collect();
    assert!((law.contact_ratio.0 - 1.724_91).abs() < 5e-6 && law.overlap_ratio.0 == 0.0, "{law:?}");
    assert!((widths[0] - 1.728).abs() < 5e-4 && (widths[1] - 4.555).abs() < 5e-4, "{law:?}");
    let mean = law.levels.iter().map(|level| level.value.0 * level.width.0).sum::<f64>() / std::f64::consts::TAU;
    assert!((law.mean.0 / mean - 1.0).abs() < 1e-12 && law.min.0 == law.levels[0].value.0, "{law:?}");
    let helical =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/train_helical.toml")).unwrap();
    let summary =
        Scene::from_toml("helical", &helical).unwrap().with("run.t_end", "1 ms").unwrap().run().unwrap().summary();
    let law = &summary.laws_from_teeth["k12"];
    assert!((law.overlap_ratio.0 - 100.0 * 15.8f64.to_radians().sin() / (8.0 * std::f64::consts::PI)).abs() < 1e-12);
    assert!(law.min.0 < law.mean.0 && law.mean.0 < law.max.0 && law.levels.len() == 4, "{law:?}");
}
