//! Pitch errors of teeth: one step of e per pitch.

use gearsim::run::Outcome;
use gearsim::trajectory::Moment;

use crate::by_hand::Pair;
use crate::{common, mobilities, run, unaccounted};

const ERRORS: [f64; 3] = [0.0, 1.5e-3, -1e-3];
const OF_TEETH: &str = r#"laws.e={pitch_errors=["0 rad", "1.5e-3 rad", "-1e-3 rad"]}"#;

fn end(outcome: &Outcome) -> [f64; 4] {
    let t = &outcome.trajectory;
    let last = t.len() - 1;
    [t.q[0][last], t.q[1][last], t.q_dot[0][last], t.q_dot[1][last]]
}

/// Runs in both directions, some slow enough for reflections, over more pitches than there are errors; k and e step together. Events and
/// end are those of the computation by hand.
#[test]
fn pitch_errors_give_the_motion_by_hand() {
    let pair = Pair { k: [1430.0, 2780.0], width: 1.73, errors: &ERRORS, t0: 10.0 };
    let mut total = [0, 0];
    let cases = [
        (300.0, 0.3, 0, 0.06),
        (-200.0, 2.5, 1, 0.06),
        (20.0, 1.0, 0, 0.1),
        (15.0, 1.2, 0, 0.1),
        (-20.0, 3.0, 1, 0.1),
        (25.0, 1.4, 0, 0.1),
    ];
    for (rpm, start, cell, t_end) in cases {
        let set = [
            format!("start={{theta=\"{start:?} rad\", phi=\"0.004 rad\", speed=\"{rpm:?} rpm\"}}"),
            format!("run.t_end=\"{t_end:?} s\""),
            "output.rate=\"1 kHz\"".into(),
        ];
        let outcome = run(&[&[OF_TEETH], &set.each_ref().map(String::as_str)[..]].concat());
        let theta_dot = rpm / 30.0 * std::f64::consts::PI * 24.0;
        let (expected, [passed, refused]) = pair.run([start, 0.004, theta_dot, 0.0], cell, t_end);
        let found = end(&outcome);
        println!("{rpm} rpm: {passed} transmitted, {refused} reflected; {found:?}, by hand {expected:?}");
        assert_eq!((outcome.counts.cell_changes, outcome.counts.reflections), (passed, refused), "{rpm} rpm");
        (total[0], total[1]) = (total[0] + passed, total[1] + refused);
        // The times by bisection have errors of 1e-16 s, which grow from event to event.
        let sizes = [1.0, 1e-2, theta_dot, 100.0];
        for ((found, expected), size) in found.iter().zip(expected).zip(sizes) {
            assert!((found - expected).abs() < 1e-8 * f64::abs(size), "{rpm} rpm: {found} for {expected}");
        }
        assert!(unaccounted(&outcome) < 1e-13, "{rpm} rpm: {:e}", unaccounted(&outcome));
    }
    assert!(total[0] > 20 && total[1] > 2, "{total:?}");
}

/// At every event v+² = v² - M2 dV, where dV is the step of V by k and e together, and T loses what V gains.
#[test]
fn every_step_of_stiffness_and_error_keeps_the_energy() {
    let (m1, m2) = mobilities();
    // In the second law the steps of e are not at those of k.
    let apart = r#"laws.e={pitches=3, steps=[{value="1e-3 rad", width="4 rad"}, {value="-1e-3 rad", width="9 rad"}, {value=0}]}"#;
    for law in [OF_TEETH, apart] {
        let outcome = run(&[law, "start.speed=\"50 rpm\"", "run.t_end=\"0.4 s\""]);
        let t = &outcome.trajectory;
        let (mut passed, mut refused) = (0, 0);
        for i in (0..t.len()).filter(|&i| t.moment[i] == Moment::Before) {
            let (v, after) = (t.q_dot[0][i], t.q_dot[0][i + 1]);
            let (dv, dt) = (t.strain[i + 1] - t.strain[i], t.kinetic[i + 1] - t.kinetic[i]);
            let scale = t.kinetic[i] + t.strain[i];
            assert!((dv + dt).abs() < 1e-14 * scale, "{dv} {dt} of {scale}");
            assert!((after * after - v * v + m2 * dv).abs() < 1e-12 * v * v, "{v} {after}");
            let other = t.q_dot[1][i + 1] - t.q_dot[1][i];
            assert!((other - m1 / m2 * (after - v)).abs() < 1e-12 * v.abs());
            if dv == 0.0 && after == -v { refused += 1 } else { passed += 1 }
        }
        println!("{passed} transmitted, {refused} reflected, {:.1e} unaccounted for", unaccounted(&outcome));
        assert_eq!((passed, refused), (outcome.counts.cell_changes, outcome.counts.reflections));
        assert!(passed > 10 && unaccounted(&outcome) < 1e-13);
    }
}

/// Exact cells compared with steps by dop853. The two share only the treatment of events and jumps.
#[test]
fn exact_cells_agree_with_dop853() {
    let cases: [(&str, &[&str]); 2] =
        [("pitch_errors", &["run.t_end=\"0.1 s\""]), ("oh2005/energy_300rpm", &[OF_TEETH, "run.t_end=\"0.05 s\""])];
    for (name, set) in cases {
        let scene = |more: &[&str]| {
            let mut all: Vec<String> = set.iter().chain(more).map(|s| s.to_string()).collect();
            if name != "pitch_errors" {
                all.push(r#"effects=["stiffness_step", "transmission_error", "damping", "torques"]"#.into());
            }
            common::run(&common::scene(name, &all))
        };
        let (exact, steps) = (scene(&[]), scene(&["run.method=dop853", "run.tolerance=1e-13"]));
        assert_eq!((exact.solver.method, steps.solver.method), ("exact", "dop853"));
        assert_eq!(exact.counts.cell_changes, steps.counts.cell_changes);
        let column = |outcome: &Outcome, i: usize| outcome.trajectory.q[i].clone();
        for i in 0..exact.trajectory.q.len() {
            let (a, b) = (column(&exact, i), column(&steps, i));
            let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let apart = a.iter().zip(&b).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            println!("{name}, coordinate {i}: {:.1e} of its size", apart / size);
            assert!(a.len() == b.len() && apart < 1e-8 * size, "{name}, coordinate {i}: {apart} of {size}");
        }
    }
}

/// A constant error shifts phi by its value and changes nothing else. Equal errors of all teeth are a constant error.
#[test]
fn a_constant_error_is_an_offset_of_phi() {
    let of = |law: &str| run(&[law, "start.speed=\"200 rpm\"", "run.t_end=\"50 ms\"", "output.events=false"]);
    let none = of(r#"laws.e={steps=[{value=0}]}"#);
    for law in
        [r#"laws.e={steps=[{value="2e-3 rad"}]}"#, r#"laws.e={pitch_errors=["2e-3 rad", "2e-3 rad", "2e-3 rad"]}"#]
    {
        let moved = of(law);
        let (a, b) = (&none.trajectory, &moved.trajectory);
        assert_eq!(a.len(), b.len());
        for i in 0..a.len() {
            assert!((b.q[1][i] - a.q[1][i] - 2e-3).abs() < 1e-11, "{law}: {} {}", a.q[1][i], b.q[1][i]);
            assert!((b.q_dot[0][i] - a.q_dot[0][i]).abs() < 1e-9 * a.q_dot[0][0], "{law}");
        }
    }
}
