//! What a new author of a model does: write a small model, derive it, generate its file, run it, compare it with its solution.
//!
//! `newcomer/model.rs` is what the author writes; `newcomer/spring_rotor.rs` is the file that the derivation generates. The tests
//! of the derivation check that this file is current. Here it is expanded and run like any model of the program.

#[rustfmt::skip]
#[path = "newcomer/cracked_rotor.rs"]
mod cracked_rotor;
#[rustfmt::skip]
#[path = "newcomer/double_well.rs"]
mod double_well;
#[rustfmt::skip]
#[path = "newcomer/spring_rotor.rs"]
mod spring_rotor;

use gearsim::__private::Matrix;
use gearsim::__private::equations::Derived;
use gearsim::run::Entry;
use gearsim::scene::Scene;

const ENTRY: Entry = Entry::new::<spring_rotor::SpringRotor>();
const CRACKED: Entry = Entry::new::<cracked_rotor::CrackedRotor>();
const WELL: Entry = Entry::new::<double_well::DoubleWell>();

const SCENE: &str = r#"
about = "A sprung rotor starts with a push; its spring stiffens and softens as the other rotor turns"
model = "spring_rotor"
effects = ["stiffness_step"]

[parameters]
J2 = "0.5 kg*m^2"

[laws.k]
steps = [{ value = "2 N*m", width = "0.4 rad" }, { value = "50 N*m" }]

[start]
speed = "1.5 rad/s"
beta_dot = "0.8 rad/s"

[run]
t_end = "15 s"
"#;

const J1: f64 = 1.0;
const J2: f64 = 0.5;
const LEVELS: [(f64, f64); 2] = [(2.0, 0.4), (50.0, 0.6)];

/// Angles [rad] and speeds [rad/s] of the two rotors, and the numbers of steps transmitted and reflected.
#[derive(Debug)]
struct End {
    alpha: f64,
    alpha_dot: f64,
    beta: f64,
    beta_dot: f64,
    passed: u64,
    reflected: u64,
}

/// The solution by hand, without the torque. In each cell alpha turns uniformly and beta swings harmonically. At the end of a cell the
/// energy of the spring's step is taken from alpha's motion alone; if that does not suffice, alpha is reflected.
fn by_hand(levels: &[(f64, f64)], t_end: f64) -> End {
    let cells = levels.len() as i64;
    let level = |cell: i64| levels[cell.rem_euclid(cells) as usize];
    let (mut cell, mut local, mut left) = (0i64, 0.0, t_end);
    let (mut alpha_dot, mut beta, mut beta_dot) = (1.5f64, 0.0, 0.8);
    let (mut passed, mut reflected) = (0, 0);
    loop {
        let (k, width) = level(cell);
        let way = if alpha_dot > 0.0 { width - local } else { -local };
        let t = (way / alpha_dot).min(left);
        let w = (k / J2).sqrt();
        let (sin, cos) = (w * t).sin_cos();
        (beta, beta_dot) = (beta * cos + beta_dot / w * sin, beta_dot * cos - beta * w * sin);
        left -= t;
        if left <= 0.0 {
            let whole = |cells: &[(f64, f64)]| cells.iter().map(|(_, width)| width).sum::<f64>();
            let lower =
                cell.div_euclid(cells) as f64 * whole(levels) + whole(&levels[..cell.rem_euclid(cells) as usize]);
            return End { alpha: lower + local + alpha_dot * t, alpha_dot, beta, beta_dot, passed, reflected };
        }
        let next = cell + alpha_dot.signum() as i64;
        let dk = level(next).0 - k;
        let square = alpha_dot * alpha_dot - dk * beta * beta / J1;
        if square < 0.0 {
            local = if alpha_dot > 0.0 { width } else { 0.0 };
            alpha_dot = -alpha_dot;
            reflected += 1;
        } else {
            local = if alpha_dot > 0.0 { 0.0 } else { level(next).1 };
            alpha_dot = square.sqrt().copysign(alpha_dot);
            cell = next;
            passed += 1;
        }
    }
}

fn run(overrides: &[&str]) -> gearsim::run::Outcome {
    run_of(&ENTRY, SCENE, overrides)
}

fn scene_of(entry: &Entry, scene: &str, overrides: &[&str]) -> Scene {
    let overrides: Vec<String> = overrides.iter().map(|s| s.to_string()).collect();
    Scene::parse("newcomer", "newcomer.toml", scene, &overrides, &[entry.model])
        .unwrap_or_else(|errors| panic!("{}", errors.render(100, false)))
}

fn run_of(entry: &Entry, scene: &str, overrides: &[&str]) -> gearsim::run::Outcome {
    let scene = scene_of(entry, scene, overrides);
    let outcome = entry.run(&scene, &mut |_| {}).expect("a scene that can be simulated");
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

#[test]
fn a_newcomers_model_moves_as_solved_by_hand() {
    assert_as_by_hand(&run(&[]), &by_hand(&LEVELS, 15.0), 2e-12);
}

/// Three laws of one phase with the periods 3, 1 and 3/4, not sorted by length. Their common period is three pitches; the levels
/// over it go into the same solution by hand. The energy account closes, and a start many turns later gives the same motion.
#[test]
fn laws_of_different_periods_share_a_phase() {
    let laws: [(&str, &[(f64, f64)]); 3] =
        [("c", &[(1.5, 1.2), (0.0, 1.8)]), ("k", &LEVELS), ("g", &[(4.0, 0.35), (12.0, 0.4)])];
    let mut text = SCENE.replace("spring_rotor", "cracked_rotor");
    text.truncate(text.find("[laws.k]").expect("a law"));
    for (name, steps) in laws {
        let [(a, width), (b, _)] = steps else { panic!("two levels") };
        text += &format!(
            "[laws.{name}]\nsteps = [{{ value = \"{a} N*m\", width = \"{width} rad\" }}, {{ value = \"{b} N*m\" }}]\n"
        );
    }
    text += &SCENE[SCENE.find("[start]").expect("a start")..];
    // All boundaries within three pitches, and the stiffness k - c + g between them.
    let value = |steps: &[(f64, f64)], x: f64| {
        let period = steps[0].1 + steps[1].1;
        if x.rem_euclid(period) < steps[0].1 { steps[0].0 } else { steps[1].0 }
    };
    let boundaries = laws.iter().flat_map(|(_, steps)| {
        let (first, period) = (steps[0].1, steps[0].1 + steps[1].1);
        (0..(3.0 / period).round() as i64).flat_map(move |i| [i as f64 * period, i as f64 * period + first])
    });
    let mut boundaries: Vec<f64> = boundaries.chain([3.0]).collect();
    boundaries.sort_by(f64::total_cmp);
    boundaries.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let cells = boundaries.windows(2).map(|ends| {
        let middle = 0.5 * (ends[0] + ends[1]);
        let [c, k, g] = laws.map(|(_, steps)| value(steps, middle));
        (k - c + g, ends[1] - ends[0])
    });
    let cells: Vec<(f64, f64)> = cells.collect();
    let far = run_of(&CRACKED, &text, &["start.alpha=3e6 rad", "run.t_end=4 s"]);
    let near = run_of(&CRACKED, &text, &["run.t_end=4 s"]);
    assert_as_by_hand(&near, &by_hand(&cells, 4.0), 2e-12);
    let end = |outcome: &gearsim::run::Outcome| outcome.trajectory.q[1].last().copied();
    assert_eq!((end(&far), far.counts.events()), (end(&near), near.counts.events()), "whole turns change nothing");
    let worst = near.trajectory.residual.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(worst < 1e-13 * near.energy_at_start, "{worst:e} J unaccounted for");
    let stepped = run_of(&CRACKED, &text, &["run.t_end=4 s", "run.method=dop853", "run.tolerance=1e-13"]);
    assert_as_by_hand(&stepped, &by_hand(&cells, 4.0), 1e-9);
}

fn assert_as_by_hand(outcome: &gearsim::run::Outcome, by_hand: &End, tolerance: f64) {
    let counts = (outcome.counts.cell_changes, outcome.counts.reflections);
    assert_eq!(counts, (by_hand.passed, by_hand.reflected));
    assert!(by_hand.passed > 1 && by_hand.reflected > 1, "the run must have both kinds of event: {by_hand:?}");
    let t = &outcome.trajectory;
    let last = t.len() - 1;
    for (what, found, expected) in [
        ("alpha", t.q[0][last], by_hand.alpha),
        ("alpha_dot", t.q_dot[0][last], by_hand.alpha_dot),
        ("beta", t.q[1][last], by_hand.beta),
        ("beta_dot", t.q_dot[1][last], by_hand.beta_dot),
    ] {
        let error = (found - expected).abs();
        println!("{what} = {found}, error {error:.1e}; {counts:?} events");
        // All four are of size one. Events increase the distance of neighbouring motions, by a factor of 1500 in total: 1e-16 in
        // the speed at the start is 1.5e-13 in alpha at the end. In a run of 20 s it would be 7e-10.
        assert!(error < tolerance, "{what} = {found}, by hand {expected}");
    }
}

#[test]
fn the_energy_of_a_newcomers_model_is_constant() {
    let t = run(&[]).trajectory;
    let start = t.kinetic[0] + t.strain[0];
    for i in 0..t.len() {
        // T by the model's own formula; V as recorded, with the stiffness level of the engine.
        let kinetic = (J1 * t.q_dot[0][i].powi(2) + J2 * t.q_dot[1][i].powi(2)) / 2.0;
        assert!((t.kinetic[i] - kinetic).abs() < 1e-14 * start, "row {i}");
        assert!((kinetic + t.strain[i] - start).abs() < 1e-13 * start, "row {i}: {}", kinetic + t.strain[i]);
    }
}

#[test]
fn the_mobility_of_a_newcomers_model_is_in_closed_form() {
    let none = gearsim::scene::Effects::none(&spring_rotor::SpringRotor::MODEL);
    let equations =
        spring_rotor::SpringRotor::equations(&none, &[J1, J2, 0.0], &[26.0]).expect("no effects, so none contradict");
    assert_eq!(equations.mobility(&[0.0; 2]), Matrix::from_row_slice(2, 2, &[1.0 / J1, 0.0, 0.0, 1.0 / J2]));
}

/// Without steps the spring has its mid stiffness and the rotors are independent, so each has a closed form.
#[test]
fn the_scene_chooses_the_effects_of_a_newcomers_model() {
    let t = run(&[r#"effects=["torque"]"#, "parameters.T1=0.3 N*m"]).trajectory;
    let last = t.len() - 1;
    let (time, w) = (t.t[last], (26.0 / J2).sqrt());
    let expected = [1.5 * time + 0.3 / J1 * time * time / 2.0, 0.8 / w * (w * time).sin()];
    for (q, expected) in t.q.iter().zip(expected) {
        let error = (q[last] - expected).abs();
        assert!(error < 1e-13 * (1.0 + expected.abs()), "{} is not {expected}", q[last]);
    }
    assert!((t.work[last] - 0.3 * (expected[0] - t.q[0][0])).abs() < 1e-12, "{}", t.work[last]);
}

/// A static start takes the equilibrium in whose valley the stated value lies. Without a stated value it starts from zero and takes a
/// stable equilibrium if there is one. The remarks name the other equilibria. By hand: x (x^2 - a^2) = 2 a^2 F/k.
#[test]
fn of_several_equilibria_the_one_near_the_stated_value_is_taken() {
    gearsim::add_models(&[WELL]);
    let text = "model = \"double_well\"\neffects = []\n[parameters]\n[run]\nt_end = \"0.1 s\"\n";
    let start = |overrides: &[&str]| {
        let scene = scene_of(&WELL, text, overrides);
        let outcome = scene.run().expect("a scene that can be simulated").outcome;
        assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
        let (x, rest) = (outcome.trajectory.q[0][0], outcome.trajectory.q[0].last().copied());
        assert!((rest.expect("rows") - x).abs() < 1e-9, "a static start stays at rest: {x}, {rest:?}");
        (x, outcome.remarks.join(" "))
    };
    for (near, expected) in [("0.05 m", 0.1), ("0.2 m", 0.1), ("-0.07 m", -0.1), ("1 um", 0.1)] {
        let (x, says) = start(&[&format!("start.x=static near {near}")]);
        assert!((x - expected).abs() < 1e-12, "{near}: {x}, not {expected}");
        assert!(says.contains("one of several equilibria"), "{says}");
    }
    let (x, says) = start(&[]);
    assert!((x.abs() - 0.1).abs() < 1e-12, "not a stable equilibrium: {x}");
    assert!(says.contains("(unstable)") && says.contains("static near"), "{says}");
    // With a large force only one well remains.
    let (x, says) = start(&["parameters.F=100 N"]);
    assert!((x * (x * x - 0.01) - 2.0 * 0.01 * 100.0 / 1000.0).abs() < 1e-12, "{x}");
    assert_eq!(says, "");
}

/// The whole command line, in a crate outside gearsim with a model of its own.
#[test]
fn the_command_line_runs_models_of_another_crate() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, out) = (folder.path().join("own.toml"), folder.path().join("out"));
    std::fs::write(&scene, SCENE).unwrap();
    let arguments = ["gearsim", "run", scene.to_str().unwrap(), "--quiet", "--out", out.to_str().unwrap()];
    let _ = gearsim::cli::run_with(&[ENTRY], arguments);
    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    let hand = by_hand(&LEVELS, 15.0);
    assert_eq!(summary["model"], "spring_rotor");
    assert_eq!(summary["cell_changes"], hand.passed);
    assert!((summary["state"]["beta"].as_f64().unwrap() - hand.beta).abs() < 1e-9);
}
