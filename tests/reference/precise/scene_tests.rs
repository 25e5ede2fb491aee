//! The gear pair in 50 digits, compared with the hand-written solver and with itself in 70 digits, and its energy.

use super::scene;
use super::scene::Event;
use super::tests::Noise;
use crate::oh2005::{GearPair, Kind, State};

fn distance(a: &State, b: &State) -> f64 {
    let each = |x: f64, y: f64, scale: f64| (x - y).abs() / scale;
    each(a.theta, b.theta, b.theta.abs())
        .max(each(a.theta_dot, b.theta_dot, b.theta_dot.abs()))
        .max(each(a.phi, b.phi, 1e-2))
        .max(each(a.phi_dot, b.phi_dot, 1e2))
}

#[test]
fn the_hand_written_solver_and_two_precisions_agree_on_the_scenes_of_the_paper() {
    for (rpm, zeta) in [(300.0, 0.1), (600.0, 0.05), (4500.0, 0.05)] {
        for t_end in [0.1, 0.5] {
            let pair = GearPair::paper(zeta, 10.0);
            let start = pair.start(rpm);
            let [few, many] = [50, 70].map(|digits| scene(&pair, &start, t_end, digits));
            let plain = pair.solve(start.theta, start.theta_dot, start.phi, start.phi_dot, t_end);
            let of = |e: &Event| (e.kind, e.cell_from, e.cell_to);
            assert_eq!(few.events.iter().map(of).collect::<Vec<_>>(), many.events.iter().map(of).collect::<Vec<_>>());
            let events = plain.events.iter().map(|e| (e.kind, e.cell_from, e.cell_to));
            assert_eq!(few.events.iter().map(of).collect::<Vec<_>>(), events.collect::<Vec<_>>());
            let end = &few.end;
            let apart = |a: (f64, f64), b: (f64, f64)| ((a.0 - b.0) + (a.1 - b.1)).abs() / b.0.abs();
            assert!(apart(end.theta, many.end.theta) < 1e-30 && apart(end.phi_dot, many.end.phi_dot) < 1e-29);
            let state = rounded(end);
            let error = distance(&plain.end, &state);
            println!("{rpm} rpm, {t_end} s: {} events, hand-written solver off by {error:.1e}", few.events.len());
            assert!(error < 1e-11, "{rpm} {t_end}: {error}");
        }
    }
}

#[test]
fn energy_is_kept_to_45_digits_without_damping() {
    for (rpm, t0) in [(600.0, 10.0), (60.0, 10.0), (20.0, 30.0)] {
        let pair = GearPair::paper(0.0, t0);
        let run = scene(&pair, &pair.start(rpm), 0.2, 50);
        println!("{rpm}: {} events, {} reflections, {:.1e}", run.events.len(), run.reflections, run.energy_change);
        assert!(run.energy_change.abs() < 1e-45, "{rpm}: {}", run.energy_change);
    }
}

/// Any speed in either direction, with and without damping, small and large torques. Events and their times are those of the hand-written
/// solver, which computes in `f64`, until a disturbance of 1e-13 has grown too much. Motions with reflections are chaotic; a
/// disturbed run shows how long each scene can be compared.
#[test]
fn random_scenes_agree_with_the_hand_written_solver() {
    let mut noise = Noise(5);
    let (mut events, mut reflections, mut beyond, mut safe, mut worst) = (0, 0, 0, 0, 0f64);
    for case in 0..120 {
        let zeta = if case % 3 == 0 { 0.0 } else { 0.7 * noise.next() };
        let pair = GearPair::paper(zeta, 10f64.powf(2.5 * noise.next()));
        let rpm = 10f64.powf(0.5 + 3.2 * noise.next()) * if case % 2 == 0 { 1.0 } else { -1.0 };
        let (theta, phi_dot) = (6.0 * noise.next(), 50.0 * noise.next());
        let start = State { theta, phi_dot, ..pair.start(rpm) };
        let t_end = 0.05;
        let precise = scene(&pair, &start, t_end, 50);
        let plain = |phi: f64| pair.solve(theta, start.theta_dot, phi, phi_dot, t_end);
        let (plain, disturbed) = (plain(start.phi), plain(start.phi * (1.0 + 1e-13)));
        let mut calm = true;
        for (i, (a, b)) in plain.events.iter().zip(&disturbed.events).enumerate() {
            let growth = (a.t - b.t).abs();
            if (a.kind, a.cell_to) != (b.kind, b.cell_to) || growth > 1e-7 {
                (beyond, calm) = (beyond + 1, false);
                break;
            }
            let c = &precise.events[i];
            assert_eq!((a.kind, a.cell_from, a.cell_to), (c.kind, c.cell_from, c.cell_to), "{case} {i}");
            let error = (a.t - c.t.0).abs();
            worst = worst.max(error / (growth + 1e-14));
            events += 1;
            reflections += u64::from(a.kind == Kind::Reflect);
        }
        if calm && plain.events.len() == disturbed.events.len() {
            let fast = pair.solve_fast(theta, start.theta_dot, start.phi, phi_dot, t_end);
            let growth = distance(&plain.end, &disturbed.end);
            let error = distance(&fast.end, &rounded(&precise.end));
            assert!(error <= growth + 1e-11, "{case}: {error} {growth}");
            safe += fast.safe;
        }
    }
    println!(
        "{events} events, {reflections} reflections, {safe} safe, {beyond} scenes chaotic, {worst:.1e} of the disturbance"
    );
    assert!(events > 1000 && reflections > 50 && worst < 1.0, "{events} {reflections} {worst}");
}

/// theta swings up to the end of its cell and just reaches it, or just fails to. The limiting start speed is found in 50 digits. On both
/// sides of it the two solvers agree whether there is an event.
#[test]
fn a_graze_of_the_end_of_a_cell_is_decided_correctly() {
    let pair = GearPair::paper(0.05, 10.0);
    let start = |theta_dot: f64| State { theta: 1.725, theta_dot, phi_dot: 100.0, ..pair.start(0.0) };
    let t_end = 3e-4;
    let (mut short, mut far) = (0.0, 150.0);
    while far - short > 2e-14 * far {
        let middle = 0.5 * (short + far);
        let reached = !scene(&pair, &start(middle), t_end, 50).events.is_empty();
        if reached { far = middle } else { short = middle }
    }
    for k in 1..=13 {
        for sign in [-1.0, 1.0] {
            let start = start(far * (1.0 + sign * 10f64.powi(-k)));
            let precise = scene(&pair, &start, t_end, 50);
            assert_eq!(precise.events.is_empty(), sign < 0.0, "{k} {sign}");
            let plain = pair.solve(start.theta, start.theta_dot, start.phi, start.phi_dot, t_end);
            assert_eq!(plain.events.len(), precise.events.len(), "{k} {sign}");
            // the event time is as ill-conditioned as a double root; the state after it is better conditioned
            let error = distance(&plain.end, &rounded(&precise.end));
            assert!(error < 1e-5, "{k} {sign}: {error}");
        }
    }
}

fn rounded(end: &super::scene::End) -> State {
    State { theta: end.theta.0, theta_dot: end.theta_dot.0, phi: end.phi.0, phi_dot: end.phi_dot.0 }
}

/// `cargo test -p gearsim-tests -- --ignored --nocapture cost_of`
#[test]
#[ignore = "measures the cost, tests nothing"]
fn cost_of_scenes() {
    for rpm in [300.0, 600.0, 4500.0] {
        let pair = GearPair::paper(0.05, 10.0);
        let clock = std::time::Instant::now();
        let run = scene(&pair, &pair.start(rpm), 0.5, 50);
        let each = clock.elapsed().as_secs_f64() * 1e6 / run.events.len() as f64;
        println!("{rpm} rpm: {} events, {each:.1} us each", run.events.len());
    }
}
