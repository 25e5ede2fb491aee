//! Powers through the parts of trains.

use gearsim::trajectory::Trajectory;

use crate::common::{run, scene};

/// The samples of a column.
fn samples(run: &Trajectory, name: &str) -> Vec<f64> {
    let column = run.column(name).unwrap_or_else(|| panic!("no column `{name}`"));
    run.samples().map(|row| column[row]).collect()
}

/// The largest magnitude.
fn size(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, x| f64::max(m, x.abs()))
}

/// A train forms the powers through its parts from the speeds of its rotors. Sums over a body less what it stores are zero; here the powers
/// themselves are compared with force times speed.
#[test]
fn a_train_has_the_powers_of_its_parts() {
    let scene = scene("train_turbine", &["run.t_end=5 ms".into()]);
    let number = |name: &str| scene.parameter(name).unwrap_or_else(|| panic!("no parameter {name}"));
    let run = run(&scene).trajectory;
    let of = |name: &str| samples(&run, name);
    let shafts = [("low", "blades"), ("middle", "sun"), ("high", "4")];
    let torques =
        shafts.map(|(shaft, rotor)| (format!("shaft_power_{shaft}"), format!("shaft_torque_{shaft}"), rotor, 1.0));
    // The second pair has the base pitch of its own first gear, which is on the countershaft.
    let radii = [number("r1"), number("r34")];
    let meshes = [("12", "1", radii[0]), ("34", "counter", radii[1])];
    let forces =
        meshes.map(|(mesh, rotor, radius)| (format!("mesh_power_{mesh}"), format!("mesh_force_{mesh}"), rotor, radius));
    for (power, force, rotor, arm) in torques.into_iter().chain(forces) {
        let (power, force, speed) = (of(&power), of(&force), of(&format!("rotor_speed_{rotor}")));
        assert!(size(&power) > 0.0);
        for row in 0..power.len() {
            let expected = force[row] * arm * speed[row];
            assert!((power[row] - expected).abs() < 1e-9 * size(&power), "{rotor}: {} {expected}", power[row]);
        }
    }
    // The sun drives the middle shaft: what it gives to its meshes is what it takes from the shaft, but for its acceleration.
    let given: f64 = ["p_s1", "p_s2", "p_s3"].map(|mesh| of(&format!("mesh_power_{mesh}"))[0]).iter().sum();
    assert!(given < 0.0 && of("shaft_power_middle")[0] > 0.0, "{given}");
}
