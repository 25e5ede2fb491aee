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
    let dampers = ["shafts.low.damping=\"200 N*m*s/rad\"", "bearings.g.viscous=\"0.02 N*m*s/rad\""];
    let run = run(&["output.rate=\"400 kHz\"", "run.t_end=\"10 ms\"", effects, dampers[0], dampers[1]]);
    let t = &run.trajectory.t;
    let losses: Vec<_> = run.trajectory.outputs.iter().filter(|(output, _)| output.name.contains("loss")).collect();
    let names = ["shaft_loss_low", "viscous_loss_g", "friction_loss_g", "mesh_loss_34", "mesh_loss_p_s2"];
    assert!(names.iter().all(|name| losses.iter().any(|(output, _)| output.name == *name)), "a loss is missing");
    let mut sum = 0.0;
    for (_, power) in losses {
        sum += (1..t.len()).map(|i| (t[i] - t[i - 1]) * (power[i] + power[i - 1]) / 2.0).sum::<f64>();
    }
    let account = run.trajectory.dissipated.last().copied().expect("rows");
    assert!((sum - account).abs() < 1e-3 * account, "losses {sum} J, account {account} J");
}

/// Torque and force of elastic parts contain their dampers: k x + c x' at each row.
#[test]
fn dampers_are_in_the_torque_of_a_shaft_and_the_force_of_a_mesh() {
    let text = "model = \"train\"\neffects = [\"viscous_friction\", \"torques\", \"backlash\"]\n\
                [rotors]\na = \"0.01 kg*m^2\"\nb = \"0.02 kg*m^2\"\nc = \"0.03 kg*m^2\"\n\
                [shafts.ab]\nbetween = [\"a\", \"b\"]\nstiffness = \"50 kN*m/rad\"\ndamping = \"7 N*m*s/rad\"\n\
                [meshes.bc]\nbetween = [\"b\", \"c\"]\nteeth = [20, 40]\nmodule = \"3 mm\"\nstiffness = \"200 MN/m\"\n\
                backlash = \"40 um\"\ndamping = \"900 N*s/m\"\n\
                [drives.m]\nrotor = \"a\"\ntorque = \"80 N*m\"\n[loads.l]\nrotor = \"c\"\ntorque = \"100 N*m\"\n\
                [start]\nspeed = \"600 rpm\"\ns_bc = \"-30 um\"\n[run]\nt_end = \"4 ms\"\n[output]\nrate = \"200 kHz\"";
    let run = gearsim::Scene::from_toml("dampers", text).unwrap_or_else(|e| panic!("{e}")).run().expect("it runs");
    assert!(run.summary().refuted.is_none());
    let column = |name: &str| run.column(name).unwrap_or_else(|e| panic!("{e}")).to_vec();
    let [a, b, c] = ["a", "b", "c"].map(|rotor| column(&format!("rotor_speed_{rotor}")));
    let [twist, torque] = ["shaft_twist_ab", "shaft_torque_ab"].map(column);
    let [s, force, lost] = ["mesh_deflection_bc", "mesh_force_bc", "contact_loss_bc"].map(column);
    let r = [20.0, 40.0].map(|teeth| teeth * 3e-3 / 2.0 * 20f64.to_radians().cos());
    for i in 0..twist.len() {
        let expected = 50e3 * twist[i] + 7.0 * (a[i] - b[i]);
        assert!((torque[i] - expected).abs() < 1e-9 * 80.0, "row {i}: {} N m, not {expected}", torque[i]);
        let contact = if lost[i] == 1.0 { 0.0 } else { s[i] - 20e-6f64.copysign(s[i]) };
        let expected = 200e6 * contact + 900.0 * (r[0] * b[i] - r[1] * c[i]);
        assert!((force[i] - expected).abs() < 1e-7 * 3e3, "row {i}: {} N, not {expected}", force[i]);
    }
    assert!(lost.contains(&1.0) && lost.contains(&0.0), "the scene must lose contact and regain it");
}

/// The number of effects has no bound: each of seventy bearings has one of its own.
#[test]
fn seventy_bearings_have_an_effect_each() {
    let mut text = String::from("model = \"train\"\neffects = [\"viscous_friction\"]\n[start]\nspeed = \"100 rpm\"\n");
    // The start is stated without twist. In a static start of rotors that turn, the shafts would carry the friction of the bearings.
    (0..70).for_each(|i| text += &format!("theta_r{i} = 0\n"));
    text += "[run]\nt_end = \"10 ms\"\n[rotors]\n";
    (0..70).for_each(|i| text += &format!("r{i} = \"0.1 kg*m^2\"\n"));
    (0..70).for_each(|i| text += &format!("[bearings.b{i}]\nrotor = \"r{i}\"\nviscous = \"0.5 N*m*s/rad\"\n"));
    (1..70).for_each(|i| {
        text += &format!("[shafts.s{i}]\nbetween = [\"r{}\", \"r{i}\"]\nstiffness = \"1 kN*m/rad\"\n", i - 1);
    });
    let scene = gearsim::scene::Scene::parse("train", "train.toml", &text, &[], &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)));
    assert!(scene.model.effects.len() > 64 && scene.model.coordinates.len() == 70);
    let run = common::run(&scene);
    // Without a load all rotors slow down alike: omega = omega_0 exp(-c t/I).
    let speed = run.trajectory.output("rotor_speed_r69").expect("a speed").last().copied().expect("rows");
    let expected = 100.0 * std::f64::consts::TAU / 60.0 * (-0.5f64 * 0.01 / 0.1).exp();
    assert!((speed - expected).abs() < 1e-12 * expected, "{speed}, not {expected}");

    // Friction at the last bearing alone: the sum of the angular momenta falls by that bearing's torque.
    let named = text.replace("effects = [\"viscous_friction\"]", "effects = [\"viscous_friction_b69\"]");
    let run = gearsim::Scene::from_toml("train", &named).unwrap_or_else(|e| panic!("{e}")).run().expect("it runs");
    let speed = |i: usize| run.column(&format!("rotor_speed_r{i}")).unwrap_or_else(|e| panic!("{e}"));
    let sum = |row: usize| (0..70).map(|i| 0.1 * speed(i)[row]).sum::<f64>();
    let (angle, last) = (run.column("theta_r69").unwrap_or_else(|e| panic!("{e}")), speed(69).len() - 1);
    let lost = 0.5 * (angle[last] - angle[0]);
    assert!(lost > 0.0 && (sum(0) - sum(last) - lost).abs() < 1e-9 * lost, "{} and {lost}", sum(0) - sum(last));
}
