//! Long runs: a start after 1e9 revolutions or 3e8 seconds loses no digits.
//!
//! An angle is a count of pitches and a remainder; a time is the sum of two numbers. So the motion before a run must not change
//! the result of the run.

mod common;

use std::f64::consts::TAU;

use gearsim::__private::equations::DerivedModel;
use gearsim::__private::models::GearPair;
use gearsim::__private::{Clock, Simulation, State};
use gearsim::scene::Scene;

/// 2^35 pitches are 1.4e9 revolutions of the gear with 24 teeth. The product of a power of two and 2 pi has no rounding error.
const PITCHES: i64 = 1 << 35;
/// Ten years of model time [s].
const YEARS: f64 = 3e8;

/// Scene and speed: every effect that changes how a stiffness switches, in both directions.
const SCENES: [(&str, &str); 5] = [
    ("spectrum_600rpm_exact", "600 rpm"),
    ("spectrum_600rpm_exact", "-600 rpm"),
    ("spectrum_4500rpm_rigid", "4500 rpm"),
    ("spectrum_600rpm_classical", "600 rpm"),
    ("spectrum_600rpm_classical", "-600 rpm"),
];

fn scene(name: &str, speed: &str, theta: f64, span: f64) -> Scene {
    let overrides = [
        format!("start.speed={speed}"),
        format!("start.theta={theta:?} rad"),
        format!("run.t_end={span:?} s"),
        format!("output.rate={:?} Hz", 10.0 / span),
    ];
    common::scene(&format!("oh2005/{name}"), &overrides)
}

/// Runs a scene whose clock starts at `now` [s] and whose pitch count is raised by `more`. Returns the state at its end and the times
/// of its events.
fn run(scene: &Scene, now: f64, more: i64) -> (State, Vec<f64>) {
    let equations = DerivedModel::of::<GearPair>().equations(scene).unwrap();
    let mut simulation = Simulation::new(&*equations, scene).unwrap();
    simulation.now.clock.set(now);
    simulation.now.state.turns[0] += more;
    let mut times = vec![];
    while !simulation.step(&mut None).unwrap() {
        times.push(simulation.now.clock.now());
    }
    (simulation.now.state, times)
}

#[test]
fn a_start_after_a_billion_revolutions_gives_the_same_bits() {
    for (name, speed) in SCENES {
        // These angles are sums of few powers of two, so adding 2^35 pitches to them causes no rounding.
        for theta in [0.0, 0.5, 3.25] {
            let far = PITCHES as f64 * TAU + theta;
            assert_eq!(far - PITCHES as f64 * TAU, theta);
            let (a, times_a) = run(&scene(name, speed, theta, 0.25), 0.0, 0);
            let (b, times_b) = run(&scene(name, speed, far, 0.25), 0.0, 0);
            let (c, times_c) = run(&scene(name, speed, theta, 0.25), 0.0, 24_000_000_000);
            assert!(times_a.len() > 100 && times_a == times_b && times_a == times_c, "{name} {speed} {theta}");
            assert_eq!((&a.q, &a.q_dot), (&b.q, &b.q_dot), "{name} {speed} {theta}");
            assert_eq!((&a.q, &a.q_dot), (&c.q, &c.q_dot), "{name} {speed} {theta}");
            assert_eq!((b.turns[0] - a.turns[0], c.turns[0] - a.turns[0]), (PITCHES, 24_000_000_000));
        }
    }
}

#[test]
fn a_start_after_ten_years_loses_no_digits() {
    // Each flight has its own zero of time; the clock decides only when the last flight ends. A clock in one f64 would be wrong
    // by 6e-8 s there, and theta by 1e-4 rad.
    const SPAN: f64 = 0.25;
    for (name, speed) in &SCENES[..3] {
        let (near, times) = run(&scene(name, speed, 0.5, SPAN), 0.0, 0);
        let mut late = scene(name, speed, 0.5, SPAN);
        late.t_end = YEARS + SPAN;
        let (far, times_far) = run(&late, YEARS, 0);
        assert_eq!(times.len(), times_far.len());
        assert_eq!(near.turns, far.turns);
        let error = (&near.q - &far.q).amax().max((&near.q_dot - &far.q_dot).amax() / near.q_dot.amax());
        println!("{name} {speed}: {} events, error {error:.1e}", times.len());
        // The two numbers of the clock hold the sum of the flights with an error far below a rounding error of the last flight.
        assert!(error < 1e-13, "{name} {speed}: {error:e}");
    }
}

#[test]
fn the_clock_keeps_the_spacing_of_events() {
    let (_, times) = run(&scene("spectrum_600rpm_exact", "600 rpm", 0.5, 0.5), 0.0, 0);
    let mut clock = Clock::default();
    clock.set(YEARS);
    for dt in times.windows(2).map(|t| t[1] - t[0]) {
        let before = clock;
        clock.advance(dt);
        let spacing = before.until(before.now()) - clock.until(before.now());
        assert!((spacing - dt).abs() <= f64::EPSILON * dt, "{spacing:e}, not {dt:e}");
    }
    // The error of the sum of very many advances is below the rounding error of one advance.
    let mut clock = Clock::default();
    for _ in 0..100_000_000 {
        clock.advance(0.003);
    }
    // 1e8 times the double nearest to 0.003 is 300000 + 6.245...e-12.
    let error = clock.until(300_000.0) + 6.245_004_513_516_505_5e-12;
    println!("clock after 1e8 advances: {error:e} s off");
    assert!(error.abs() < 1e-18);
}

/// Without damping the energy stays constant over a hundred thousand events of a fast rotation.
#[test]
fn energy_does_not_drift_over_many_events() {
    let overrides = ["parameters.zeta=0", "run.t_end=28 s", "output.rate=10 Hz"].map(String::from);
    let mut scene = common::scene("oh2005/spectrum_4500rpm_exact", &overrides);
    scene.output.events = false;
    let outcome = common::run(&scene);
    assert!(outcome.counts.cell_changes > 100_000, "{}", outcome.counts.cell_changes);
    let largest = outcome.trajectory.residual.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let drift = largest / outcome.energy_at_start;
    println!("after {} events {drift:.1e} of the energy", outcome.counts.cell_changes);
    assert!(drift < 1e-13, "{drift:e}");
}
