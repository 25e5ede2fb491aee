//! Tests of the hand-written gear pair: numbers printed in the paper, the equations, the energy, and its solvers against one another.

use super::{GearPair, Jump, Kind, Ramp, Run, State};

/// The paper's scenes: speed of the driving gear \[rpm\], damping, and the end time \[s\].
const SCENES: [(f64, f64, f64); 6] = [
    (300.0, 0.1, 0.1),
    (300.0, 0.1, 0.5),
    (600.0, 0.05, 0.1),
    (600.0, 0.05, 0.5),
    (4500.0, 0.05, 0.1),
    (4500.0, 0.05, 0.5),
];

fn run(pair: &GearPair, s: State, t_end: f64) -> Run {
    pair.solve(s.theta, s.theta_dot, s.phi, s.phi_dot, t_end)
}

fn distance(a: &State, b: &State) -> f64 {
    let each = |x: f64, y: f64, scale: f64| (x - y).abs() / scale;
    each(a.theta, b.theta, b.theta.abs().max(1.0))
        .max(each(a.theta_dot, b.theta_dot, b.theta_dot.abs()))
        .max(each(a.phi, b.phi, 1e-2))
        .max(each(a.phi_dot, b.phi_dot, 1e2))
}

#[test]
fn mesh_frequency_ratios_are_those_printed() {
    let pair = GearPair::paper(0.05, 10.0);
    assert!((pair.start(600.0).theta_dot / pair.wd() - 0.101).abs() < 5e-4);
    assert!((pair.start(4500.0).theta_dot / pair.wd() - 0.758).abs() < 1e-3);
}

#[test]
fn closed_form_satisfies_the_equations() {
    let pair = GearPair::paper(0.1, 10.0);
    let from = State { theta: 0.3, theta_dot: 700.0, phi: 2e-3, phi_dot: -40.0 };
    let (t, h) = (3.1e-4, 1e-8);
    let [before, now, after] = [t - h, t, t + h].map(|t| pair.closed_form(pair.k1, from, t));
    let (phi_ddot, theta_ddot) = pair.newtonian(pair.k1, now.phi, now.phi_dot);
    assert!(((after.phi_dot - before.phi_dot) / (2.0 * h) / phi_ddot - 1.0).abs() < 1e-6);
    assert!(((after.theta_dot - before.theta_dot) / (2.0 * h) / theta_ddot - 1.0).abs() < 1e-6);
    assert!(((after.theta - before.theta) / (2.0 * h) / now.theta_dot - 1.0).abs() < 1e-6);
}

#[test]
fn jump_keeps_the_energy() {
    let pair = GearPair::paper(0.0, 10.0);
    let before = State { theta: 0.0, theta_dot: 900.0, phi: 7e-3, phi_dot: 55.0 };
    for (dk, speed) in [(1350.0, 900.0), (1350.0, -900.0), (-1350.0, 900.0), (1350.0, 20.0), (1350.0, -20.0)] {
        let before = State { theta_dot: speed, ..before };
        let (after, k) = match pair.jump(dk, before.phi, speed, before.phi_dot) {
            Jump::Transmit { theta_dot, phi_dot } => (State { theta_dot, phi_dot, ..before }, 1430.0 + dk),
            Jump::Reflect { theta_dot, phi_dot } => (State { theta_dot, phi_dot, ..before }, 1430.0),
        };
        let (u, v) = (pair.energy(1430.0, &before, 0.0), pair.energy(k, &after, 0.0));
        assert!((u / v - 1.0).abs() < 1e-14, "{dk} {speed}: {u} {v}");
    }
}

#[test]
fn undamped_energy_is_kept_through_transmission_and_reflection() {
    let mut reflections = 0;
    for (rpm, t0) in [(600.0, 10.0), (300.0, 20.0), (60.0, 10.0), (20.0, 30.0)] {
        let pair = GearPair::paper(0.0, t0);
        let from = pair.start(rpm);
        let run = run(&pair, from, 0.5);
        let (first, last) =
            (pair.energy(pair.k1, &from, from.phi), pair.energy(pair.k(run.end_cell), &run.end, from.phi));
        assert!((last / first - 1.0).abs() < 1e-11, "{rpm}: {first} {last}");
        assert_eq!(run.events.len() as u64, run.cell_changes + run.reflections);
        reflections += run.reflections;
    }
    assert!(reflections > 0);
}

#[test]
fn fast_solver_agrees_with_the_recording_one() {
    for (rpm, zeta, t_end) in SCENES {
        let pair = GearPair::paper(zeta, 10.0);
        let s = pair.start(rpm);
        let safe = run(&pair, s, t_end);
        let fast = pair.solve_fast(s.theta, s.theta_dot, s.phi, s.phi_dot, t_end);
        assert_eq!(
            (safe.cell_changes, safe.reflections, safe.end_cell),
            (fast.cell_changes, fast.reflections, fast.end_cell)
        );
        assert!(distance(&fast.end, &safe.end) < 1e-11, "{rpm} {zeta}: {:?} {:?}", fast.end, safe.end);
    }
}

#[test]
fn reversed_velocities_lead_back() {
    let pair = GearPair::paper(0.0, 10.0);
    let s = pair.start(600.0);
    let there = run(&pair, s, 0.02).end;
    let back = run(&pair, State { theta_dot: -there.theta_dot, phi_dot: -there.phi_dot, ..there }, 0.02 - 1e-9).end;
    let back = State { theta_dot: -back.theta_dot, phi_dot: -back.phi_dot, ..back };
    let expected = pair.closed_form(pair.k1, s, 1e-9);
    assert!(distance(&back, &expected) < 1e-10, "{back:?} {expected:?}");
}

/// Where the speed does not suffice for the step, the ramp turns the gear back as the jump rule does.
#[test]
fn ramps_converge_to_the_jump() {
    let pair = GearPair::paper(0.05, 10.0);
    for (rpm, kind) in [(600.0, Kind::Transmit), (20.0, Kind::Reflect)] {
        let start = State { theta: 1.0, ..pair.start(rpm) };
        let t_end = 1.2 / start.theta_dot;
        let exact = run(&pair, start, t_end);
        assert_eq!(exact.events[0].kind, kind);
        for ramp in [Ramp::Linear, Ramp::Smooth] {
            let errors = [1e-2, 1e-3, 1e-4].map(|eps| {
                let end = pair.solve_ramp(ramp, eps, start, t_end, 1.0);
                distance(&end, &exact.end)
            });
            assert!(errors[1] < 0.2 * errors[0] && errors[2] < 0.2 * errors[1], "{rpm} {ramp:?}: {errors:?}");
        }
    }
}

/// `cargo test -p gearsim-tests --release -- --ignored --nocapture cost_per_cell`
#[test]
#[ignore = "measures, proves nothing"]
fn cost_per_cell_change() {
    for (rpm, zeta, t_end) in [(300.0, 0.1, 10.0), (600.0, 0.05, 10.0), (4500.0, 0.05, 10.0)] {
        let pair = GearPair::paper(zeta, 10.0);
        let s = pair.start(rpm);
        let clock = std::time::Instant::now();
        let safe = run(&pair, s, t_end);
        let each = clock.elapsed().as_nanos() as f64 / safe.events.len() as f64;
        let lean = || {
            let clock = std::time::Instant::now();
            let fast = pair.solve_fast(s.theta, s.theta_dot, s.phi, s.phi_dot, t_end);
            (clock.elapsed().as_nanos() as f64, fast)
        };
        let runs = [(); 9].map(|()| lean());
        let (least, fast) = runs.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).expect("nine runs");
        let events = fast.cell_changes + fast.reflections;
        let lean = least / events as f64;
        println!("{rpm} rpm: {each:.0} ns safe, {lean:.0} ns fast; {events} events, {} cells by the search", fast.safe);
    }
}
