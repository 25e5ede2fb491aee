//! Helical gears on thrust bearings: the axial force against Newton's laws, frequencies against matrices written by hand, the account.

use std::f64::consts::TAU;

use gearsim::Scene;
use nalgebra::{Matrix4, SymmetricEigen};

const PAIR: &str = r#"
model = "train"
effects = ["stiffness_step", "torques"]
[rotors]
a = "0.02 kg*m^2"
b = "0.3 kg*m^2"
[supports.a]
rotor = "a"
stiffness = "30 kN*m/rad"
[supports.b]
rotor = "b"
stiffness = "900 kN*m/rad"
[meshes.ab]
between = ["a", "b"]
teeth = [20, 60]
module = "4 mm"
helix_angle = "25 deg"
stiffness = "400 MN/m"
[thrust_bearings.za]
rotor = "a"
mass = "5 kg"
stiffness = "90 MN/m"
[thrust_bearings.zb]
rotor = "b"
mass = "40 kg"
stiffness = "200 MN/m"
[drives.m]
rotor = "a"
torque = "300 N*m"
[loads.l]
rotor = "b"
torque = "900 N*m"
[run]
t_end = "5 ms"
"#;

fn scene(text: &str) -> Scene {
    Scene::from_toml("axial", text).unwrap_or_else(|e| panic!("{e}"))
}

/// Base radii of the gears, and the tangent of the base helix angle.
fn geometry() -> ([f64; 2], f64) {
    let (beta, alpha) = (25f64.to_radians(), 20f64.to_radians());
    let transverse = (alpha.tan() / beta.cos()).atan();
    ([20.0, 60.0].map(|z| 4e-3 / beta.cos() * z * transverse.cos() / 2.0), beta.tan() * transverse.cos())
}

/// M = diag(I_a, I_b, m_a, m_b), K = diag(supports, thrust bearings) + k g gᵀ with delta = r_a theta_a - r_b theta_b - t z_a + t z_b, in
/// the sign convention of the train.
#[test]
fn natural_frequencies_with_axial_motion_equal_those_by_hand() {
    let ([ra, rb], t) = geometry();
    let g = nalgebra::Vector4::new(ra, -rb, -t, t);
    let m = [0.02, 0.3, 5.0, 40.0];
    let k = Matrix4::from_diagonal(&nalgebra::Vector4::new(30e3, 900e3, 90e6, 200e6)) + g * g.transpose() * 400e6;
    let root = Matrix4::from_diagonal(&nalgebra::Vector4::from(m.map(|m: f64| 1.0 / m.sqrt())));
    let mut expected: Vec<f64> =
        SymmetricEigen::new(root * k * root).eigenvalues.iter().map(|w| w.sqrt() / TAU).collect();
    expected.sort_by(f64::total_cmp);
    for text in [PAIR.to_string(), PAIR.replace("helix_angle", "hand = \"left\"\nhelix_angle")] {
        let found: Vec<f64> = scene(&text).modes().unwrap().modes.iter().map(|mode| mode.natural).collect();
        assert_eq!(found.len(), 4);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found / expected - 1.0).abs() < 1e-10, "{found}, not {expected}");
        }
    }
    // Without axial motion the frequencies differ.
    let rigid = PAIR.split("[thrust_bearings.za]").next().unwrap().to_string() + "[run]\nt_end = \"5 ms\"\n";
    let two = scene(&rigid.replace("\"stiffness_step\", \"torques\"", "\"stiffness_step\"")).modes().unwrap().modes;
    assert!((two[0].natural / expected[0] - 1.0).abs() > 1e-3, "{} {}", two[0].natural, expected[0]);
}

/// Free gears under balanced torques, at rest: F_t = T/r with the reference radius r, F_a = F_t tan(beta). The bearing of the right-handed
/// driver is pushed along its rotation vector, that of the driven gear against it. With a left-handed driver both directions are reversed.
#[test]
fn thrust_against_newton() {
    let text =
        PAIR.replace("stiffness = \"30 kN*m/rad\"", "stiffness = \"0 N*m/rad\"").replace("900 kN*m/rad", "0 N*m/rad");
    let (beta, torque) = (25f64.to_radians(), 300.0);
    let tangential = torque / (4e-3 / beta.cos() * 20.0 / 2.0);
    let axial = tangential * beta.tan();
    for (text, sign) in [(text.clone(), 1.0), (text.replace("helix_angle", "hand = \"left\"\nhelix_angle"), -1.0)] {
        let run = scene(&text).run().unwrap();
        for (name, expected) in [
            ("axial_force_ab", axial),
            ("thrust_force_za", sign * axial),
            ("thrust_force_zb", -sign * axial),
            ("mesh_force_ab", torque / geometry().0[0]),
        ] {
            let column = run.column(name).unwrap();
            let worst = column.iter().fold(0.0f64, |worst, x| worst.max((x / expected - 1.0).abs()));
            assert!(worst < 1e-8, "{name}: {} to {}, not {expected}", column[0], column[column.len() - 1]);
        }
    }
}

/// On a middle shaft with two gears of the same hand the axial forces oppose each other. The axial force of a gear is F_t tan(beta) at its
/// radius.
#[test]
fn two_gears_on_one_shaft() {
    let text = r#"
model = "train"
effects = ["torques"]
[rotors]
1 = "0.01 kg*m^2"
2 = "0.1 kg*m^2"
3 = "0.5 kg*m^2"
[meshes.12]
between = ["1", "2"]
teeth = [20, 60]
module = "3 mm"
helix_angle = "20 deg"
stiffness = "300 MN/m"
[meshes.23]
between = ["2", "3"]
teeth = [25, 75]
module = "4 mm"
helix_angle = "12 deg"
hand = "left"
stiffness = "400 MN/m"
[thrust_bearings.t]
rotor = "2"
mass = "9 kg"
stiffness = "100 MN/m"
[drives.m]
rotor = "1"
torque = "100 N*m"
[loads.l]
rotor = "3"
torque = "900 N*m"
[run]
t_end = "1 ms"
"#;
    let force =
        |torque: f64, teeth: f64, module: f64, beta: f64| torque * 2.0 * beta.cos() / (module * teeth) * beta.tan();
    let (b12, b23) = (20f64.to_radians(), 12f64.to_radians());
    let (f12, f23) = (force(100.0, 20.0, 3e-3, b12), force(300.0, 25.0, 4e-3, b23));
    let column = |text: &str, name: &str| scene(text).run().unwrap().column(name).unwrap()[0];
    assert!((column(text, "axial_force_12") / f12 - 1.0).abs() < 1e-9);
    assert!((column(text, "axial_force_23") / f23 - 1.0).abs() < 1e-9);
    // Gear 1 is right-handed and drives: its thrust is along +z, that on gear 2 along -z. The pinion of mesh 23 is left-handed as gear 2 is,
    // and drives with its rotation along -z: its thrust is along +z.
    let thrust = column(text, "thrust_force_t");
    assert!((thrust / (f23 - f12) - 1.0).abs() < 1e-7, "{thrust}, not {f23} - {f12}");
    let other = column(&text.replace("hand = \"left\"", "hand = \"right\""), "thrust_force_t");
    assert!((other / (-f23 - f12) - 1.0).abs() < 1e-7, "{other}, not -{f23} - {f12}");
}

/// With stepping stiffness and dampers the energy account closes, the exact method is used, and a numerical method agrees.
#[test]
fn the_account_closes_and_two_methods_agree() {
    let supports = &PAIR[PAIR.find("[supports.a]").unwrap()..PAIR.find("[meshes.ab]").unwrap()];
    let text = PAIR
        .replace(supports, "")
        .replace("\"torques\"]", "\"torques\", \"damping\", \"viscous_friction\"]")
        .replace("stiffness = \"400 MN/m\"", "stiffness = { steps = [{ value = \"300 MN/m\", width = \"2.5 rad\" }, { value = \"450 MN/m\" }] }\ndamping = \"900 N*s/m\"")
        .replace("mass = \"5 kg\"", "mass = \"5 kg\"\ndamping = \"4 kN*s/m\"")
        .replace("mass = \"40 kg\"", "mass = \"40 kg\"\ndamping = \"9 kN*s/m\"")
        .replace("[run]", "[parameters]\nbeta_K = \"1 us\"\nalpha_M = \"3 1/s\"\n[start]\nspeed = \"900 rpm\"\n[run]");
    let exact = scene(&text).run().unwrap();
    let summary = exact.summary();
    assert!(summary.refuted.is_none() && summary.method.name == "exact" && summary.cell_changes > 2, "{summary:?}");
    let steps = scene(&text)
        .with_all([("run.method", "dop853".into()), ("run.tolerance", 1e-11.into())])
        .unwrap()
        .run()
        .unwrap();
    for name in ["z_a", "z_b", "s_ab", "thrust_force_za", "mesh_force_ab"] {
        let (a, b) = (exact.column(name).unwrap(), steps.column(name).unwrap());
        let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let (last_a, last_b) = (a[a.len() - 1], b[b.len() - 1]);
        assert!((last_a - last_b).abs() < 1e-7 * size, "{name}: {last_a} {last_b}");
    }
    let floquet = scene(&text).floquet().unwrap();
    assert!(floquet.multipliers.iter().all(|m| m.norm() < 1.0 + 1e-9), "{:?}", floquet.multipliers);
}

#[test]
fn bearings_without_helical_gears_are_refused() {
    for (text, said) in [
        (PAIR.replace("helix_angle = \"25 deg\"\n", ""), "has a thrust bearing, but no helical gear"),
        (PAIR.replace("rotor = \"b\"\nmass", "rotor = \"a\"\nmass"), "has two thrust bearings"),
        (PAIR.replace("helix_angle = \"25 deg\"", "hand = \"left\""), "has a hand, but no helix angle"),
        (PAIR.replace("mass = \"5 kg\"", ""), "[thrust_bearings.za] lacks `mass`"),
    ] {
        let message = Scene::from_toml("axial", &text).expect_err(said).to_string();
        assert!(message.contains(said), "{message}\nwithout {said:?}");
    }
}
