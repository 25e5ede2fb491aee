//! Parts that no derived model has in this combination: the energy account closes, and two methods agree.

use crate::common;

const SHORT: [&str; 2] = ["run.t_end=\"30 ms\"", "output.rate=\"5 kHz\""];

fn run(overrides: &[&str]) -> gearsim::run::Outcome {
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    common::run(&common::scene("train_turbine", &overrides))
}

#[test]
fn exact_cells_and_steps_agree() {
    let exact = run(&SHORT);
    assert_eq!(exact.solver.method, "exact");
    assert!(exact.refuted.is_none(), "{:?}", exact.refuted);
    let steps = run(&["run.t_end=\"30 ms\"", "output.rate=\"5 kHz\"", "run.method=\"dop853\"", "run.tolerance=1e-11"]);
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
    let effects = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"viscous_friction\",\"dry_friction\"]";
    let run = run(&["output.rate=\"400 kHz\"", "run.t_end=\"10 ms\"", effects]);
    let t = &run.trajectory.t;
    let losses: Vec<_> = run.trajectory.outputs.iter().filter(|(output, _)| output.name.contains("loss")).collect();
    let names =
        ["shaft_loss_low", "viscous_loss_low", "viscous_loss_g", "friction_loss_g", "mesh_loss_34", "mesh_loss_p_s2"];
    assert!(names.iter().all(|name| losses.iter().any(|(output, _)| output.name == *name)), "a loss is missing");
    let mut sum = 0.0;
    for (_, power) in losses {
        sum += (1..t.len()).map(|i| (t[i] - t[i - 1]) * (power[i] + power[i - 1]) / 2.0).sum::<f64>();
    }
    let account = run.trajectory.dissipated.last().copied().expect("rows");
    assert!((sum - account).abs() < 1e-3 * account, "losses {sum} J, account {account} J");
}

/// A set of effects has 64 bits: with more parts, they share the effects of the train.
#[test]
fn seventy_bearings_share_their_effect() {
    let mut text = String::from("model = \"train\"\neffects = [\"viscous_friction\"]\n[start]\nspeed = \"100 rpm\"\n");
    // Not twisted: in the static start of rotors that turn, the shafts carry the friction of the bearings.
    (0..70).for_each(|i| text += &format!("theta_r{i} = 0\n"));
    text += "[run]\nt_end = \"10 ms\"\n[rotors]\n";
    (0..70).for_each(|i| text += &format!("r{i} = \"0.1 kg*m^2\"\n"));
    (0..70).for_each(|i| text += &format!("[bearings.b{i}]\nrotor = \"r{i}\"\nviscous = \"0.5 N*m*s/rad\"\n"));
    (1..70).for_each(|i| {
        text += &format!("[shafts.s{i}]\nbetween = [\"r{}\", \"r{i}\"]\nstiffness = \"1 kN*m/rad\"\n", i - 1);
    });
    let scene = gearsim::scene::Scene::parse("train", "train.toml", &text, &[], &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)));
    assert!(scene.model.effects.len() < 64 && scene.model.coordinates.len() == 70);
    let run = common::run(&scene);
    // Without a load all rotors slow down alike: omega = omega_0 exp(-c t/I).
    let speed = run.trajectory.output("rotor_speed_r69").expect("a speed").last().copied().expect("rows");
    let expected = 100.0 * std::f64::consts::TAU / 60.0 * (-0.5f64 * 0.01 / 0.1).exp();
    assert!((speed - expected).abs() < 1e-12 * expected, "{speed}, not {expected}");
}
