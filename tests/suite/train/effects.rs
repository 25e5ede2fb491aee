//! Parts that no derived model has in this combination: the energy account closes, and two methods agree.

use gearsim::scene::Scene;

use crate::common;

/// A drive through a planet set with a grounded ring and two parallel stages, with a clutch, bearings and a brake.
const SCENE: &str = r#"
model = "train"
effects = ["stiffness_step", "torques", "damping", "viscous_friction", "dry_friction", "backlash_34"]
[rotors]
blades = "40 kg*m^2"
carrier = "1.5 kg*m^2"
sun = "0.02 kg*m^2"
counter = "0.1 kg*m^2"
4 = "0.02 kg*m^2"
generator = "0.4 kg*m^2"
[shafts.low]
between = ["blades", "carrier"]
stiffness = "2 MN*m/rad"
damping = "200 N*m*s/rad"
[shafts.middle]
between = ["sun", "1"]
stiffness = "200 kN*m/rad"
[shafts.high]
between = ["4", "generator"]
stiffness = "20 kN*m/rad"
[rotors.1]
inertia = "0.8 kg*m^2"
[planets.p]
sun = "sun"
ring = "ground"
carrier = "carrier"
teeth = [27, 99]
module = "4 mm"
count = 3
mass = "2 kg"
inertia = "0.01 kg*m^2"
sun_stiffness = { steps = [{ value = "350 MN/m", width = "2.6 rad" }, { value = "600 MN/m" }] }
ring_stiffness = "500 MN/m"
[meshes.12]
between = ["1", "counter"]
teeth = [80, 23]
module = "3 mm"
stiffness = { steps = [{ value = "250 MN/m", width = "2.2 rad" }, { value = "400 MN/m" }] }
[meshes.34]
between = ["counter", "4"]
teeth = [70, 21]
module = "2 mm"
stiffness = { steps = [{ value = "200 MN/m", width = "2.2 rad" }, { value = "300 MN/m" }] }
backlash = "60 um"
[bearings.g]
rotor = "generator"
viscous = "0.02 N*m*s/rad"
friction = "0.5 N*m"
[drives.wind]
rotor = "blades"
torque = "8 kN*m"
[loads.grid]
rotor = "generator"
torque = "150 N*m"
[parameters]
beta_K = "3 us"
[start]
speed = "20 rpm"
[run]
t_end = "30 ms"
[output]
rate = "5 kHz"
"#;

fn run(overrides: &[&str]) -> gearsim::run::Outcome {
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    let scene = Scene::parse("train", "train.toml", SCENE, &overrides, &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)));
    common::run(&scene)
}

#[test]
fn exact_cells_and_steps_agree() {
    let exact = run(&[]);
    assert_eq!(exact.solver.method, "exact");
    assert!(exact.refuted.is_none(), "{:?}", exact.refuted);
    let steps = run(&["run.method=\"dop853\"", "run.tolerance=1e-11"]);
    assert_eq!(exact.counts.cell_changes, steps.counts.cell_changes);
    for ((output, a), (_, b)) in exact.trajectory.outputs.iter().zip(&steps.trajectory.outputs) {
        let size = a.iter().fold(1e-12, |most: f64, x| most.max(x.abs()));
        let (a, b) = (a.last().expect("rows"), b.last().expect("rows"));
        assert!((a - b).abs() < 1e-4 * size, "{}: {a} and {b}", output.name);
    }
}

/// The losses of all parts sum to the loss of the energy account.
#[test]
fn losses_sum_to_the_account() {
    let run = run(&["output.rate=\"400 kHz\"", "run.t_end=\"10 ms\""]);
    let t = &run.trajectory.t;
    let losses: Vec<_> = run.trajectory.outputs.iter().filter(|(output, _)| output.name.contains("loss")).collect();
    let names = ["shaft_loss_low", "viscous_loss_low", "viscous_loss_g", "friction_loss_g", "mesh_loss_34", "mesh_loss_p_s2"];
    assert!(names.iter().all(|name| losses.iter().any(|(output, _)| output.name == *name)), "a loss is missing");
    let mut sum = 0.0;
    for (_, power) in losses {
        sum += (1..t.len()).map(|i| (t[i] - t[i - 1]) * (power[i] + power[i - 1]) / 2.0).sum::<f64>();
    }
    let account = run.trajectory.dissipated.last().copied().expect("rows");
    assert!((sum - account).abs() < 1e-3 * account, "losses {sum} J, account {account} J");
}
