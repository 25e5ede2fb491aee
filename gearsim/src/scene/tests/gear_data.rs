//! Data of gears that contradict one another, or that no gear has.

use std::path::Path;

use crate::known::MODELS;
use crate::scene::Scene;

fn load(name: &str, set: &[&str]) -> Result<Scene, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{name}.toml"));
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let set: Vec<_> = set.iter().map(ToString::to_string).collect();
    Scene::load_with(&path, &set, &models).map_err(|mistakes| mistakes.render(200, false))
}

#[test]
fn contradictions_and_impossible_values_are_refused() {
    let cases = [
        ("oh2005/energy_300rpm", "parameters.N1=2.5", "must be a whole number from 1 to 10000"),
        ("oh2005/energy_300rpm", "parameters.N1=1e9", "must be a whole number"),
        ("planar_planetary_3_phases", "laws.k_s1.teeth=[20, 41]", "has 20 teeth for a gear with Z_s = 28"),
        ("planar_planetary_3_phases", "laws.k_s1.teeth=[35, 28]", "has 35 teeth for a gear with Z_s = 28"),
        ("gear_pair_teeth", "parameters.N1=21", "has 24 teeth for a gear with N1 = 21"),
        ("gear_pair_teeth", "parameters.N2=40", "has 96 teeth for a gear with N2 = 40"),
        ("gear_pair_teeth", "laws.k.module=2.5 m", "must lie between 0.01 and 100 mm"),
        ("gear_pair_teeth", "laws.k.face_width=70 m", "must lie between 0.01 mm and 10 m"),
        ("gear_pair_teeth", "laws.k.young=206 Pa", "must lie between 1 MPa and 2000 GPa"),
        ("gear_pair_bearings", "parameters.r1=5 m", "with 24 teeth its module is 443.4"),
        ("gear_pair_bearings", "parameters.alpha=200 deg", "must lie between 5 and 45 deg"),
        ("idler", "parameters.r2=41.1 m", "must belong to a module"),
        ("sliding_friction", "parameters.r1=76.2 mm", "the base radius of the teeth of `laws.k12` is 0.071605 m"),
        ("sliding_friction", "parameters.alpha=30 deg", "work at 20.00 deg"),
        ("planar_planetary_3_phases", "parameters.Z_r=100", "has 35 teeth for a gear with (Z_r - Z_s)/2 = 36"),
        ("planar_planetary_3_phases", "laws.k_r2.teeth=[35, 97]", "has 97 teeth for a gear with Z_r = 98"),
        ("planar_planetary_3_phases", "parameters.r_s=42 mm", "base radius of the teeth"),
        ("planar_planetary_3_phases", "laws.k_r1.internal=false", "the mesh of `k_r1` is of a ring gear"),
        ("planar_planetary_3_phases", "laws.k_s1.internal=true", "the mesh of `k_s1` is external"),
        ("damaged_tooth", "laws.k.damage.0.of=25", "the gears of this mesh have 24 and 96 teeth"),
    ];
    for (scene, change, said) in cases {
        let shown = load(scene, &[change]).expect_err(change);
        let words = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(said), "{change}: {shown}");
    }
}

#[test]
fn odd_values_give_a_warning() {
    let cases = [
        ("gear_pair_bearings", "parameters.r1=0.7 m", "its module is 62.0770 mm, which is rare"),
        ("planar_planetary_3", "parameters.Z_r=98", "planet 2 of the stage at 120.0000 deg does not fit"),
        ("planetary_3", "parameters.Z_r=98", "planet 2 of the stage at 120.0000 deg does not fit"),
        ("planar_planetary_3", "parameters.psi2=40 deg", "the planets collide unless they lie in different planes"),
        ("planar_planetary_3", "parameters.psi2=0 deg", "the stage has two planets in one place"),
        ("gear_pair_bearings", "parameters.alpha=12 deg", "rare for a pressure angle"),
        ("sliding_friction", "parameters.alpha=21 deg", "work at 20.00 deg"),
    ];
    for (scene, change, said) in cases {
        let warnings = load(scene, &[change]).unwrap().warnings.join("; ");
        assert!(warnings.contains(said), "{change}: {warnings}");
    }
}

/// No scene of the project has a warning.
#[test]
fn the_scenes_have_no_warnings() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let mut checked = 0;
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        if let Some(name) = entry.file_name().to_str().and_then(|name| name.strip_suffix(".toml")) {
            assert_eq!(load(name, &[]).unwrap().warnings, Vec::<String>::new(), "{name}");
            checked += 1;
        }
    }
    assert!(checked > 15, "{checked}");
}

/// The conversion that `backlash.toml` states: b = bt N1/(2 rb1), with the backlash bt along the line of action.
#[test]
fn the_backlash_of_the_scene_is_a_tenth_of_a_millimetre() {
    let scene = load("backlash", &[]).unwrap();
    let (b, n1) = (scene.parameter("b").unwrap(), scene.parameter("N1").unwrap());
    let rb1 = 6.35e-3 * n1 / 2.0 * 20f64.to_radians().cos();
    let bt = 2.0 * b * rb1 / n1;
    assert!((bt / 0.1e-3 - 1.0).abs() < 1e-3, "{bt} m");
}

/// The conversions in the descriptions of `gear_pair`, from quantities along the line of action to those in phi. The relative motion of
/// the flanks there is delta = rb1 theta1 - rb2 theta2, with N1 theta1 = theta + phi and N2 theta2 = theta - phi.
#[test]
fn the_conversions_that_gear_pair_states_hold() {
    let model = MODELS.iter().map(|entry| entry.model).find(|model| model.name == "gear_pair").unwrap();
    let of_law = |name: &str| model.laws.iter().find(|law| law.name == name).unwrap().doc;
    let of_parameter = |name: &str| model.parameters.iter().find(|p| p.name == name).unwrap().doc;
    let (n1, n2, m) = (24.0, 96.0, 6.35e-3);
    let [rb1, rb2] = [n1, n2].map(|z| m * z / 2.0 * 20f64.to_radians().cos());
    let delta = |theta: f64, phi: f64| rb1 * (theta + phi) / n1 - rb2 * (theta - phi) / n2;
    // A transmission error, and a backlash, of the length x is N1 x/(2 rb1) in phi, at any theta.
    assert!(of_law("e").contains("et N1/(2 rb1)") && of_parameter("b").contains("bt N1/(2 rb1)"));
    for (theta, x) in [(0.0, 1e-4), (7.0, -3e-5)] {
        assert!((delta(theta, n1 * x / (2.0 * rb1)) / x - 1.0).abs() < 1e-9, "{theta} {x}");
    }
    // The same energy, k phi² = kt delta²/2, with k = 2 kt (rb1/N1)².
    assert!(of_law("k").contains("2 kt (rb1/N1)^2"));
    let (kt, phi) = (3e8, 2e-3);
    let k = 2.0 * kt * (rb1 / n1).powi(2);
    assert!((k * phi * phi / (0.5 * kt * delta(0.0, phi).powi(2)) - 1.0).abs() < 1e-12);
    // The torque on a gear is T0 times its number of teeth, since theta + phi = N1 theta1.
    assert!(of_parameter("T0").contains("torque per tooth: T0 N1 drives"));
}
