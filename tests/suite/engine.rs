//! The engine compared with two solvers that share no code with it: a hand-written one, and one in 50 digits.

mod common;

use common::{PAPER, gear_pair, relative, run, scene};
use gearsim::scene::Precision;
use gearsim_tests::oh2005::GearPair;
use gearsim_tests::precise;

/// Torques T0 of the runs that are compared with 50 digits [N m].
const TORQUES: [f64; 3] = [1.0, 10.0, 20.0];

#[test]
fn paper_scenes_agree_with_the_hand_written_six_steps() {
    for (name, zeta, rpm) in PAPER {
        let scene = scene(&format!("oh2005/{name}"), &[]);
        let pair = GearPair::paper(zeta, 10.0);
        let start = pair.start(rpm);
        let by_hand = pair.solve(start.theta, start.theta_dot, start.phi, start.phi_dot, scene.t_end);
        let outcome = run(&scene);
        assert_eq!(outcome.counts.cell_changes, by_hand.cell_changes as u64, "{name}");
        assert_eq!(outcome.counts.reflections, by_hand.reflections as u64, "{name}");
        let t = &outcome.trajectory;
        let end = |column: &[f64]| *column.last().unwrap();
        for (what, got, want, scale) in [
            ("theta", end(&t.q[0]), by_hand.end.theta, 1.0),
            ("theta_dot", end(&t.q_dot[0]), by_hand.end.theta_dot, 1.0),
            ("phi", end(&t.q[1]), by_hand.end.phi, start.phi),
            ("phi_dot", end(&t.q_dot[1]), by_hand.end.phi_dot, start.phi * pair.w0()),
        ] {
            let error = relative(got, want, scale);
            println!("{name}: {what} {got:e}, error {error:.1e}");
            assert!(error < 1e-11, "{name}: {what} = {got:e}, by hand {want:e}, error {error:.1e}");
        }
        // The rows recorded before and after events give the event times, which are those of the hand-written solver.
        let times: Vec<f64> = (0..t.len()).filter(|&i| t.moment[i].name() == "before").map(|i| t.t[i]).collect();
        assert_eq!(times.len(), by_hand.events.len());
        for (got, want) in times.iter().zip(&by_hand.events) {
            assert!((got - want.t).abs() < 1e-11 * want.t, "{name}: event at {got}, by hand {}", want.t);
        }
    }
}

#[test]
fn paper_scenes_agree_with_fifty_digits() {
    for (_, zeta, rpm) in PAPER {
        for t0 in TORQUES {
            let pair = GearPair::paper(zeta, t0);
            let start = pair.start(rpm);
            let t_end = 0.1;
            let precise = precise::scene(&pair, &start, t_end, 50);
            let outcome = run(&gear_pair(&pair, start.theta_dot, t_end));
            assert_eq!(outcome.counts.events(), precise.events.len() as u64);
            let t = &outcome.trajectory;
            let error = [
                relative(t.q[0][t.len() - 1], precise.end.theta.0, 1.0),
                relative(t.q_dot[0][t.len() - 1], precise.end.theta_dot.0, 1.0),
                relative(t.q[1][t.len() - 1], precise.end.phi.0, start.phi),
                relative(t.q_dot[1][t.len() - 1], precise.end.phi_dot.0, start.phi * pair.w0()),
            ];
            let error = error.into_iter().fold(0.0, f64::max);
            println!("{rpm} rpm, T0 = {t0}: {} events, error {error:.1e}", precise.events.len());
            assert!(error < 1e-11, "{rpm} rpm, T0 = {t0}: {error:.1e}");
        }
    }
}

/// In plain precision the motion magnifies rounding errors: those of the state at each event and those of the constants of a cell. In
/// compensated precision only the rounding error of the result itself remains.
#[test]
fn long_runs_agree_with_fifty_digits() {
    // zeta, speed [rpm], T0 [N m], t_end [s], allowed error in plain precision. The last motion is chaotic.
    let cases = [
        (0.05, 4500.0, 10.0, 1.0, 1e-11),
        (0.05, 4500.0, 10.0, 10.0, 1e-10),
        (0.05, 600.0, 10.0, 0.5, 1e-11),
        (0.0, 600.0, 20.0, 0.3, 1.0),
    ];
    for (zeta, rpm, t0, t_end, allowed) in cases {
        let pair = GearPair::paper(zeta, t0);
        let start = pair.start(rpm);
        let precise = precise::scene(&pair, &start, t_end, 50);
        let error = |precision| {
            let scene = {
                let mut scene = gear_pair(&pair, start.theta_dot, t_end);
                scene.solver.precision = precision;
                scene
            };
            let outcome = run(&scene);
            assert_eq!(outcome.counts.events(), precise.events.len() as u64);
            let t = &outcome.trajectory;
            let last = t.len() - 1;
            let times = (0..t.len()).filter(|&i| t.moment[i].name() == "before").map(|i| t.t[i]);
            times
                .zip(&precise.events)
                .map(|(got, want)| relative(got, want.t.0, 0.0))
                .chain([
                    relative(t.q[0][last], precise.end.theta.0, 1.0),
                    relative(t.q_dot[0][last], precise.end.theta_dot.0, 1.0),
                    relative(t.q[1][last], precise.end.phi.0, start.phi),
                    relative(t.q_dot[1][last], precise.end.phi_dot.0, start.phi * pair.w0()),
                ])
                .fold(0.0, f64::max)
        };
        let (plain, compensated) = (error(Precision::Plain), error(Precision::Compensated));
        println!(
            "{rpm} rpm, T0 = {t0}: {} events, plain {plain:.1e}, compensated {compensated:.1e}",
            precise.events.len()
        );
        assert!(plain < allowed, "{rpm} rpm, T0 = {t0}: {plain:.1e}");
        assert!(compensated < 1e-15, "{rpm} rpm, T0 = {t0}: {compensated:.1e}");
    }
}
