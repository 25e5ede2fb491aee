//! The outputs of models against Newton's laws, against the energy account and against closed forms.

mod common;
#[path = "outputs/powers.rs"]
mod powers;

use std::f64::consts::TAU;
use std::path::Path;

use common::{model, relative, root, run, scene};
use gearsim::__private::Inside;
use gearsim::__private::equations::{Equations, Known};
use gearsim::analysis::dynamic_factor;
use gearsim::analysis::orders::{Turning, force, lines, meshes, reference_shaft};
use gearsim::model::Role;
use gearsim::scene::Scene;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// The names of all committed scenes of models.
fn scenes() -> Vec<String> {
    let folder = root().join("models/scenes");
    let stem = |path: &Path| path.file_stem().unwrap().to_str().unwrap().to_owned();
    let toml = |path: &Path| path.extension().is_some_and(|e| e == "toml");
    let mut names = vec![];
    for (prefix, folder) in [("", folder.clone()), ("drives/", folder.join("drives"))] {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        names.extend(entries.filter(|path| toml(path)).map(|path| format!("{prefix}{}", stem(&path))));
    }
    names.sort();
    names
}

/// Law values of a scene with the random factors `x` of the laws' sizes, and each switch in a random mode.
fn law_values(scene: &Scene, equations: &dyn Equations, x: &[f64]) -> Vec<f64> {
    let sized = |mid: f64, x: f64| if mid == 0.0 { 1e-6 * x } else { mid * (1.0 + 0.5 * x) };
    let laws = scene.laws.iter().zip(x.iter().cycle()).map(|(law, x)| sized(law.mid(), *x));
    let mut k = scene.model.in_contact(laws);
    let mut at = scene.model.laws.len();
    for (i, switch) in scene.model.switches.iter().enumerate() {
        let mode = ((x[i % x.len()] + 1.0) * 0.5 * switch.modes.len() as f64) as usize % switch.modes.len();
        if let Some(values) = equations.mode(i, mode) {
            k[at..at + values.len()].copy_from_slice(&values);
        }
        at += switch.neutral.len();
    }
    k
}

/// The power that dampers and switches dissipate, from the dissipation function and the lost forces.
fn taken(scene: &Scene, equations: &dyn Equations, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
    let mut power = 2.0 * equations.dissipation(q, q_dot, k);
    for i in (0..scene.model.switches.len()).filter(|&i| equations.mode(i, 0).is_some()) {
        let [a, b] = equations.lost(i, k);
        let x = equations.deflection(equations.switched(i), q, k);
        power += (a + b * x.value(q, k)) * x.normal.dot(q_dot);
    }
    power
}

#[test]
fn the_losses_by_cause_sum_to_the_loss_of_the_account() {
    let mut seen = 0;
    // The planets of the committed scenes have no play.
    let with_play = |scene: &str| {
        let meshes = ["s1", "r1", "s2", "r2", "s3", "r3"].map(|mesh| format!("parameters.b_{mesh}=40 um"));
        let effects = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\"]".to_string();
        let others = if scene == "wind_turbine" { vec!["parameters.b12=40 um".to_string()] } else { vec![] };
        (scene.to_string(), [&meshes[..], &others, &[effects, "parameters.beta_K=2 us".into()]].concat())
    };
    let planets = ["planetary_3", "planar_planetary_3", "wind_turbine"].map(with_play);
    for (name, sets) in scenes().into_iter().map(|name| (name, vec![])).chain(planets) {
        let scene = scene(&name, &sets);
        let equations = model(scene.model.name).equations(&scene).unwrap();
        let n = equations.coordinates();
        let is_present = |with: Option<&str>| with.is_none_or(|effect| scene.effects.has(effect, scene.model));
        let outputs = || scene.model.outputs.iter().enumerate().filter(|(_, output)| is_present(output.with));
        let losses = || outputs().filter(|(_, output)| output.is_loss()).map(|(i, _)| i);
        let numbers = proptest::collection::vec(-1.0..1.0_f64, 3 * n + 16);
        let check = |x: Vec<f64>| {
            let q: Vec<f64> = x[..n].iter().map(|x| 1e-3 * x).collect();
            let (q_dot, k) = (&x[n..2 * n], law_values(&scene, &*equations, &x[2 * n..]));
            let each: Vec<f64> = losses().map(|i| equations.output(i, &q, q_dot, &k, &Known::default())).collect();
            let all = taken(&scene, &*equations, &q, q_dot, &k);
            let scale = each.iter().map(|loss| loss.abs()).sum::<f64>();
            prop_assert!((each.iter().sum::<f64>() - all).abs() <= 1e-12 * scale, "{name}: {each:?} sum to {all}");
            Ok(())
        };
        TestRunner::new(Config { cases: 64, ..Config::default() }).run(&numbers, check).unwrap();
        seen += usize::from(losses().count() > 0);
    }
    assert!(seen > 10, "{seen}");
}

/// Place of the symbol `flank12` among those of the switch of `gear_pair_bearings`.
const FLANK: usize = 4;

#[test]
fn forces_accelerate_bodies_by_newtons_law() {
    let sets: [String; 1] = ["effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\"]".into()];
    let sets = [&sets[..], &["parameters.b12=80 um".into(), "parameters.beta_K=20 us".into()]].concat();
    let scene = scene("gear_pair_bearings", &sets);
    let equations = model("gear_pair_bearings").equations(&scene).unwrap();
    let number = |name: &str| scene.parameter(name).unwrap();
    let place = |name: &str| scene.model.coordinates.iter().position(|c| c.name == name).unwrap();
    let output = |name: &str| scene.model.outputs.iter().position(|o| o.name == name).unwrap();
    let check = |x: Vec<f64>| {
        let n = equations.coordinates();
        let q: Vec<f64> = x[..n].iter().map(|x| 1e-4 * x).collect();
        let (q_dot, k) = (&x[n..2 * n], law_values(&scene, &*equations, &x[2 * n..]));
        let a = equations.acceleration(&q, q_dot, &k, &vec![0.0; scene.model.laws.len()]);
        let at = |name: &str| equations.output(output(name), &q, q_dot, &k, &Known::default());
        let (mesh, alpha) = (at("mesh_force_12"), number("alpha"));
        // The mesh pushes gear 1 along -(flank sin(alpha), cos(alpha)). `flank` is 1 if the drive flanks are in contact and -1 if the coast
        // flanks are.
        let flank = k[scene.model.laws.len() + FLANK];
        let push = [-flank * mesh * alpha.sin(), -mesh * alpha.cos()];
        for (gear, sign) in [("1", 1.0), ("2", -1.0)] {
            for (axis, push) in ["x", "y"].into_iter().zip(push) {
                let bearing = -at(&format!("bearing_force_{gear}_{axis}"));
                let inertia = number(&format!("m{gear}")) * a[place(&format!("{axis}{gear}"))];
                let scale = push.abs() + bearing.abs() + inertia.abs();
                let error = (bearing + sign * push - inertia).abs();
                prop_assert!(error < 1e-11 * scale, "gear {gear}, {axis}: {bearing} + {push} is not {inertia}");
            }
        }
        // The rotations: theta1 = (theta + s/(2 h))/N1 with h = r1/N1.
        let (n1, n2, r1) = (number("N1"), number("N2"), number("r1"));
        let (mean, half) = (a[place("theta")], a[place("s")] * n1 / (2.0 * r1));
        for (inertia, acceleration, torque) in [
            (number("I1"), (mean + half) / n1, number("T_motor") - mesh * r1),
            (number("I2"), (mean - half) / n2, mesh * r1 * n2 / n1 - number("T_load")),
        ] {
            let error = (inertia * acceleration - torque).abs();
            prop_assert!(error < 1e-10 * (torque.abs() + mesh.abs() * r1), "{error}");
        }
        Ok(())
    };
    // Only beta_K damps, because damping in proportion to inertia is no force between bodies.
    assert_eq!(number("alpha_M"), 0.0);
    let numbers = proptest::collection::vec(-1.0..1.0_f64, 40);
    TestRunner::new(Config { cases: 200, ..Config::default() }).run(&numbers, check).unwrap();
}

#[test]
fn a_train_in_equilibrium_has_the_static_forces() {
    let sets = ["effects=[\"torques\"]", "run.t_end=1 ms", "start.speed=0 rpm"].map(String::from);
    let outcome = run(&scene("two_stage", &sets));
    let scene = scene("two_stage", &sets);
    let number = |name: &str| scene.parameter(name).unwrap();
    let run = &outcome.trajectory;
    let torque = number("T_motor");
    let ratio = number("N2") / number("N1");
    for (name, expected) in [
        ("shaft_torque_m", torque),
        ("mesh_force_12", torque / number("r1")),
        ("shaft_torque_c", torque * ratio),
        ("mesh_force_34", torque * ratio / number("r3")),
    ] {
        let found = run.output(name).unwrap()[0];
        assert!(relative(found, expected, 0.0) < 1e-9, "{name}: {found}, not {expected}");
    }
}

/// One mass on a mesh of constant stiffness with the error e = E cos(w t) and no damping: with r = w/w0 the dynamic transmission
/// error has the amplitude E/(1 - r²), the deflection of the mesh E r²/(1 - r²).
#[test]
fn a_harmonic_transmission_error_gives_the_amplitudes_of_the_closed_form() {
    const E: f64 = 1e-7;
    for r in [0.25, 0.6, 1.7] {
        let mut sets: Vec<String> = [
            "effects=[\"stiffness_step\",\"transmission_error\",\"torques\"]".into(),
            "parameters.zeta=0".into(),
            // A small torque, because a static deflection couples the error to the rotation in proportion to the deflection.
            "parameters.T0=1e-4 N*m".into(),
            "laws.k={steps=[{value=\"2 kN*m\"}]}".into(),
            format!("laws.e={{harmonics=[{{order=1, amplitude=\"{E} rad\"}}]}}"),
            "run.method=dop853".into(),
            "run.tolerance=1e-11".into(),
        ]
        .into();
        let still = scene("oh2005/energy_300rpm", &sets);
        let equations = model("gear_pair").equations(&still).unwrap();
        let mobility = equations.mobility(&[0.0; 2]);
        let w0 = (2.0 * 2e3 * mobility[(1, 1)]).sqrt();
        let speed = r * w0;
        // The run starts on the periodic solution. theta vibrates too, because inertia couples it to phi.
        let amplitude = E / (1.0 - r * r);
        let t0 = still.parameter("T0").unwrap();
        let phi = t0 / 2e3 + amplitude;
        sets.push(format!(
            "start={{theta=0, phi=\"{phi:e} rad\", phi_dot=\"0 rad/s\", theta_dot=\"{speed:e} rad/s\"}}"
        ));
        let turns = 4.0;
        let n1 = still.parameter("N1").unwrap();
        let t_end = TAU * n1 / speed * (turns + 0.01);
        sets.push(format!("run.t_end=\"{t_end:e} s\""));
        sets.push(format!("output.rate=\"{:e} Hz\"", 20_000.0 / t_end));
        sets.push("output.events=false".into());
        let run = run(&scene("oh2005/energy_300rpm", &sets)).trajectory;
        let turning = Turning::of(&run, "rotor_speed_1", 0.0).unwrap();
        assert_eq!(turning.revolutions(), turns as usize);
        let meshes = meshes(&run, 0.0);
        assert!(relative(meshes[0].frequency / turning.frequency(), n1, 0.0) < 1e-6);
        let lines = lines(&turning, &meshes);
        let line = lines.iter().find(|line| (line.harmonic, line.sideband) == (1, 0)).unwrap();
        let found = turning.amplitudes(&[run.output("dte").unwrap()], &[*line])[0][0];
        let expected = 2.0 * amplitude.abs() / n1;
        assert!(relative(found, expected, 0.0) < 1e-4, "r = {r}: {found} rad, not {expected}");
        // The torque of the mesh is N1 k (phi - e): its line is that of the deflection.
        let torque = turning.orders(run.output("mesh_torque").unwrap()).unwrap().at(n1).unwrap();
        let expected = n1 * 2e3 * (E * r * r / (1.0 - r * r)).abs();
        assert!(relative(torque, expected, 0.0) < 1e-4, "r = {r}: {torque} N*m, not {expected}");
    }
}

#[test]
fn every_model_declares_outputs() {
    // A train has those of the parts that a scene lists.
    for model in common::models().into_iter().filter(|model| model.elements.is_empty()) {
        assert!(model.outputs.iter().any(|output| output.unit == "rad/s"), "{} has no speed of a rotor", model.name);
    }
}

/// The force of a mesh stiffness is found by its name. A new component must follow this rule for names.
#[test]
fn every_mesh_stiffness_has_its_force() {
    for model in common::models() {
        for law in model.laws.iter().filter(|law| law.role == Role::Stiffness) {
            assert!(force(model, law.name).is_some(), "{}: {} has no force", model.name, law.name);
        }
    }
}

/// Without vibration the mesh of a stage carries the force T/r.
#[test]
fn the_force_at_rest_is_the_torque_over_the_base_radius() {
    let scene = scene("two_stage", &["run.t_end=5 ms".into()]);
    let found = dynamic_factor::of(&scene, model("two_stage"), &run(&scene).trajectory, scene.output.from);
    // 95 N m on 24.7 mm; the second stage has it times 63/21, on 37.6 mm.
    for (mesh, force) in found.iter().zip([95.0 / 24.7e-3, 285.0 / 37.6e-3]) {
        assert!(relative(*mesh.at_rest.as_ref().unwrap(), force, 0.0) < 1e-9, "{mesh:?}");
        assert!(
            relative(*mesh.factor.as_ref().unwrap(), mesh.largest / force, 0.0) < 1e-9 && mesh.largest > force,
            "{mesh:?}"
        );
        assert!(mesh.iso6336.as_ref().is_err_and(|why| why.contains("without teeth")), "{mesh:?}");
    }
}

/// Without a load a motor speeds up both gears. The mesh then carries what the driven gear needs for its part of the acceleration, from the
/// start on: nothing vibrates.
#[test]
fn gears_that_speed_up_steadily_start_without_vibration() {
    let text = "model = \"train\"\neffects = [\"torques\", \"damping\"]\nrotors = { 1 = \"0.1 kg*m^2\", 2 = \"0.01 kg*m^2\" }\n\
                meshes.12 = { between = [\"1\", \"2\"], teeth = [20, 40], base_radius = \"28.19 mm\", stiffness = \"300 MN/m\" }\n\
                drives.m = { rotor = \"1\", torque = \"50 N*m\" }\nloads.l = { rotor = \"2\", torque = \"0 N*m\" }\n\
                parameters.beta_K = \"20 us\"\nstart.speed = \"100 rpm\"\nrun.t_end = \"0.2 s\"\n";
    let scene = Scene::from_toml("speeding_up", text).unwrap();
    let trajectory = run(&scene).trajectory;
    // The inertia of the driven gear as seen by the driving gear.
    let seen = 0.01 / 4.0;
    let force = 50.0 * seen / (0.1 + seen) / 28.19e-3;
    let found = &dynamic_factor::of(&scene, model("train"), &trajectory, scene.output.from)[0];
    assert!(relative(*found.at_rest.as_ref().unwrap(), force, 0.0) < 1e-9, "{found:?}, not {force}");
    assert!(relative(*found.factor.as_ref().unwrap(), 1.0, 0.0) < 1e-9, "{found:?}");
    for x in trajectory.output("mesh_force_12").unwrap() {
        assert!(relative(*x, force, 0.0) < 1e-9, "{x}, not {force}");
    }
}

/// On bearings the centres of the gears move too, but the standard's resonance does not depend on the masses of the gears. So the same
/// gears on shafts have the same K_v.
#[test]
fn bearings_do_not_change_the_factor_of_the_standard() {
    let text = |model: &str, more: &str, torque: f64, speed: f64| {
        format!(
            "model = \"{model}\"\neffects = [\"stiffness_step\", \"torques\", \"damping\"]\n[parameters]\nN1 = 24\nN2 = 96\n\
             r1 = \"71.60357 mm\"\nI1 = \"2890 kg*mm^2\"\nI2 = \"740200 kg*mm^2\"\nbeta_K = \"4 us\"\n{more}\n\
             T_motor = \"{torque} N*m\"\nT_load = \"{} N*m\"\n[laws.k12]\nteeth = [24, 96]\nmodule = \"6.35 mm\"\nface_width = \"30 mm\"\n\
             [start]\nspeed = \"{speed} rpm\"\n[run]\nt_end = \"2 ms\"\n[output]\nrate = \"20 kHz\"\n",
            4.0 * torque
        )
    };
    let shafts = "I_m = \"0.02 kg*m^2\"\nI_l = \"1.5 kg*m^2\"\nk_m = \"20 kN*m/rad\"\nk_l = \"200 kN*m/rad\"";
    let bearings = "m1 = \"1 kg\"\nm2 = \"16 kg\"\nkb1 = \"100 MN/m\"\nkb2 = \"200 MN/m\"";
    // Below, near and above the resonance. The last column is by the formulas of the standard.
    for (torque, speed, expected) in [(200.0, 3000.0, 1.0499), (200.0, 18500.0, 1.2980), (200.0, 25000.0, 0.7799)] {
        for (name, more) in [("gear_pair_shafts", shafts), ("gear_pair_bearings", bearings)] {
            let scene = Scene::from_toml(name, &text(name, more, torque, speed)).unwrap();
            let kv = dynamic_factor::of(&scene, model(name), &run(&scene).trajectory, scene.output.from)[0]
                .iso6336
                .clone()
                .unwrap();
            // The speed varies by a few ten-thousandths over the short run.
            assert!((kv - expected).abs() < 1e-3, "{name} at {speed} rpm: {kv}, not {expected}");
        }
    }
}

/// K_v of the standard, compared with the number by hand: 1 + 0.23 N, N = 24 f/f_E with f_E = sqrt(c/m_red)/2 pi.
#[test]
fn gears_by_their_teeth_have_the_factor_of_the_standard() {
    let sets = ["laws.k.method=iso6336", "run.t_end=50 ms"].map(String::from);
    let scene = scene("gear_pair_teeth", &sets);
    let found = dynamic_factor::of(&scene, model("gear_pair"), &run(&scene).trajectory, scene.output.from);
    let kv = *found[0].iso6336.as_ref().unwrap();
    // V = k phi² = c delta²/2 with delta = 2 r_b1 phi/N1: c = k N1²/(2 r_b1²). m_red = m1 m2/(m1 + m2), m = I/r_b².
    let (r1, r2) = (24.0 * 6.35e-3 / 2.0 * 20f64.to_radians().cos(), 96.0 * 6.35e-3 / 2.0 * 20f64.to_radians().cos());
    let (m1, m2) = (2890e-6 / (r1 * r1), 740_200e-6 / (r2 * r2));
    let mean = {
        let law = &scene.laws[0];
        law.steps.iter().map(|step| step.value * step.width).sum::<f64>() / TAU
    };
    let c = mean * 24.0 * 24.0 / (2.0 * r1 * r1);
    let resonance = (c * (m1 + m2) / (m1 * m2)).sqrt() / TAU;
    let ratio = 24.0 * 10.0 / resonance;
    // Below the resonance, without deviations and tip relief: 1 + 0.23 N.
    assert!(ratio < 0.5 && relative(kv, 1.0 + 0.23 * ratio, 0.0) < 1e-3, "{kv}, not {}", 1.0 + 0.23 * ratio);
}

/// Transforms and means use the samples: no two samples have the same time, and they are evenly spaced except at the end of the run.
#[test]
fn samples_never_repeat_a_time() {
    for name in ["two_stage", "backlash", "rattle", "electric_axle", "oh2005/stall_300rpm"] {
        let run = run(&scene(name, &["run.t_end=20 ms".into(), "output.rate=50 kHz".into()])).trajectory;
        let t: Vec<f64> = run.samples().map(|row| run.t[row]).collect();
        assert!(t.len() > 900 && t.windows(2).all(|pair| pair[1] > pair[0]), "{name}");
        let even = t.windows(2).filter(|pair| ((pair[1] - pair[0]) * 50e3 - 1.0).abs() < 1e-6).count();
        assert!(even + 2 >= t.len(), "{name}: {even} of {}", t.len());
        // The other rows are pairs about the events.
        assert_eq!(run.len() - t.len(), 2 * run.events().count(), "{name}");
    }
}

#[test]
fn an_output_that_is_not_asked_for_is_not_recorded() {
    let none = run(&scene("two_stage", &["output.record=[]".into(), "run.t_end=5 ms".into()]));
    assert!(none.trajectory.outputs.is_empty());
    let two = ["output.record=[\"dte_34\",\"mesh_force_12\"]".into(), "run.t_end=5 ms".into()];
    let names: Vec<_> = run(&scene("two_stage", &two)).trajectory.outputs.iter().map(|(o, _)| o.name).collect();
    assert_eq!(names, ["dte_34", "mesh_force_12"]);
}

#[test]
fn the_time_in_each_mode_adds_up_to_the_run() {
    let outcome = run(&scene("rattle", &[]));
    let (switch, times) = &outcome.modes[0];
    assert_eq!(*switch, "over");
    let whole: f64 = times.iter().map(|(_, time)| time).sum();
    assert!(relative(whole, 0.15, 0.0) < 1e-12, "{whole}");
    // Contact is lost where the torque of the mesh is zero: counted in samples, which are 7 us apart.
    let run = &outcome.trajectory;
    let torque = run.output("mesh_torque").unwrap();
    let samples: Vec<usize> = run.samples().collect();
    let free = samples.iter().filter(|&&row| torque[row] == 0.0).count() as f64 / samples.len() as f64;
    let exact = times.iter().find(|(mode, _)| *mode == "free").unwrap().1 / whole;
    assert!((free - exact).abs() < 0.01, "{free} of the samples, {exact} of the time");
}

/// The mean of `contact_loss` over the samples is the share of time in the modes of the play without a force, which the engine adds up.
#[test]
fn the_mean_of_contact_loss_is_the_share_of_time_without_force() {
    for (name, part) in [("backlash", ""), ("rattle", ""), ("backlash_oscillator", ""), ("response", "_12")] {
        let outcome = run(&scene(name, &["output.rate=200 kHz".into(), "output.events=false".into()]));
        let loss = outcome.trajectory.output(&format!("contact_loss{part}")).unwrap_or_else(|| panic!("{name}"));
        let play = &outcome.modes.iter().find(|(switch, _)| switch.starts_with("over")).unwrap().1;
        let time =
            |of: &dyn Fn(&str) -> bool| play.iter().filter(|(mode, _)| of(mode)).map(|(_, time)| time).sum::<f64>();
        let share = time(&|mode| mode == "free" || mode.ends_with("_loose")) / time(&|_| true);
        let mean = loss.iter().sum::<f64>() / loss.len() as f64;
        // Each loss of contact is counted to a sample at both ends.
        let crossings = loss.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let allowed = (crossings + 1) as f64 / loss.len() as f64;
        assert!((mean - share).abs() <= allowed, "{name}: {mean}, not {share} within {allowed}");
        assert!(loss.iter().all(|x| *x == 0.0 || *x == 1.0), "{name}");
        println!("{name}: {share:.4} of the time without force, {mean:.4} of the samples");
    }
}

/// Orders refer to the shaft that a scene names: the mesh of the second stage has as many orders as its pinion has teeth.
#[test]
fn orders_refer_to_the_shaft_that_a_scene_names() {
    let of = |overrides: &[String]| {
        let scene = scene("two_stage", overrides);
        let run = run(&scene).trajectory;
        let shaft = reference_shaft(&run, scene.output.spectrum.shaft).unwrap();
        let turning = Turning::of(&run, shaft.name, 0.0).unwrap();
        let mesh = meshes(&run, 0.0).into_iter().find(|mesh| mesh.name == "k34").unwrap();
        (shaft.name, mesh.frequency / turning.frequency())
    };
    let (first, _) = of(&[]);
    assert_eq!(first, "rotor_speed_m");
    let (named, order) = of(&["output.spectrum={shaft=\"rotor_speed_3\"}".into()]);
    assert!(named == "rotor_speed_3" && (order / order.round() - 1.0).abs() < 1e-3, "{named}: {order}");
    let (named, order) = of(&["output.spectrum={shaft=\"rotor_speed_4\"}".into()]);
    assert!(named == "rotor_speed_4" && (order / order.round() - 1.0).abs() < 1e-3, "{named}: {order}");
}
