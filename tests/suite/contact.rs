//! Phases held at steps they cannot climb, and steps met together: against closed forms.

mod common;
#[path = "contact/models.rs"]
mod models;

use gearsim::engine::{Entry, Outcome};
use gearsim::scene::Scene;
// Where the expansions of the models find the engine, as they do within gearsim.
use gearsim::{engine, model};

const PRESSED: Entry = Entry::new::<models::pressed::Pressed, 2>();
const TWICE: Entry = Entry::new::<models::twice::Twice, 2>();
const MESHES: Entry = Entry::new::<models::meshes::Meshes, 3>();

fn run(entry: &Entry, text: &str) -> Outcome {
    let scene = Scene::parse("case", "case.toml", text, &[], &[entry.model])
        .unwrap_or_else(|errors| panic!("{}", errors.render(100, false)));
    let outcome = (entry.run)(&scene, &mut |_| {}).expect("a scene that can be simulated");
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// q and q' at the end.
fn end(outcome: &Outcome) -> (Vec<f64>, Vec<f64>) {
    let last = |columns: &[Vec<f64>]| columns.iter().map(|c| *c.last().unwrap()).collect();
    (last(&outcome.trajectory.q), last(&outcome.trajectory.q_dot))
}

/// q and q' at the end are as expected, to within `tolerance` of the sizes of either.
fn assert_ends(outcome: &Outcome, q: [f64; 2], v: [f64; 2], sizes: [f64; 2], tolerance: f64) {
    let found = end(outcome);
    for (found, expected, size) in [(&found.0, q, sizes[0]), (&found.1, v, sizes[1])] {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < tolerance * size, "{found}, not {expected}");
        }
    }
}

fn residual(outcome: &Outcome) -> f64 {
    outcome.trajectory.residual.iter().fold(0.0f64, |m, r| m.max(r.abs()))
}

/// The gear pair at rest at the boundary theta = 0, below which the mesh is stiffer, with phi at `phi` times T0/k1.
fn gear_pair_at_rest(t0: f64, phi: f64, t_end: f64) -> Outcome {
    let overrides = [
        r#"effects=["stiffness_step", "torques"]"#.into(),
        format!("parameters.T0={t0:?} N*m"),
        "start.speed=0 rpm".into(),
        format!("start.phi={:?} rad", phi * t0 / 1430.0),
        format!("run.t_end={t_end:?} s"),
    ];
    common::run(&common::scene("oh2005/energy_300rpm", &overrides))
}

/// Angular frequencies of phi with theta free, sqrt(M2 k), and with theta held, sqrt(2 k/(a + b)); M1/M2.
fn gear_pair_frequencies(k: f64) -> (f64, f64, f64) {
    let (a, b) = (0.00289 / 24f64.powi(2), 0.7402 / 96f64.powi(2));
    let (m1, m2) = ((1.0 / a - 1.0 / b) / 2.0, (1.0 / a + 1.0 / b) / 2.0);
    ((m2 * k).sqrt(), (2.0 * k / (a + b)).sqrt(), m1 / m2)
}

/// phi = 3 T0/k1 accelerates theta down, against a step up: held, until phi has come to T0/k1 and the reaction pulls.
#[test]
fn a_reaction_that_pulls_lets_go() {
    let (free, held, ratio) = gear_pair_frequencies(1430.0);
    let rest = 10.0 / 1430.0;
    let quarter = std::f64::consts::FRAC_PI_2 / held;
    let after = 0.3 / free;
    let outcome = gear_pair_at_rest(10.0, 3.0, quarter + after);
    assert_eq!((outcome.counts.holds, outcome.counts.cell_changes), (1, 0));
    let speed = -2.0 * rest * held;
    let phi = rest + speed / free * (free * after).sin();
    let phi_dot = speed * (free * after).cos();
    let (theta, theta_dot) = (ratio * (phi - rest - speed * after), ratio * (phi_dot - speed));
    // The hold ends when the reaction pulls by 1e-9 of its forces: so late, and so far off, is what follows.
    assert_ends(&outcome, [theta, phi], [theta_dot, phi_dot], [rest, speed.abs()], 2e-9);
    assert!(residual(&outcome) < 1e-14 * outcome.energy_at_start);
}

/// phi swings from 2 |T0|/k1 through zero to negative rest: there the step vanishes, and theta slips through.
#[test]
fn a_step_that_vanishes_lets_through() {
    let (_, held, ratio) = gear_pair_frequencies(1430.0);
    let rest = 10.0 / 1430.0;
    let slip = (1.0f64 / 3.0).acos() / held;
    let speed = -3.0 * rest * held * (1.0f64 - 1.0 / 9.0).sqrt();
    let (free, ..) = gear_pair_frequencies(2780.0);
    let (after, beyond) = (0.2 / free, 10.0 / 2780.0);
    let outcome = gear_pair_at_rest(-10.0, -2.0, slip + after);
    assert_eq!((outcome.counts.holds, outcome.counts.cell_changes), (1, 1));
    let (c, s) = ((free * after).cos(), (free * after).sin());
    let (phi, phi_dot) = (-beyond + beyond * c + speed / free * s, -beyond * free * s + speed * c);
    let (theta, theta_dot) = (ratio * (phi - speed * after), ratio * (phi_dot - speed));
    assert_ends(&outcome, [theta, phi], [theta_dot, phi_dot], [rest, speed.abs()], 1e-13);
    assert!(residual(&outcome) < 1e-14 * outcome.energy_at_start);
}

/// Under a torque and damping the bounces come ever faster, and end in a hold that lasts.
#[test]
fn a_pressed_rotor_comes_to_rest_at_the_step() {
    let outcome = run(
        &PRESSED,
        r#"
        model = "pressed"
        effects = ["stiffness_step"]
        parameters = { T = "0.5 N*m", load = "10 N*m", c = "1 N*m*s" }
        laws.k.steps = [{ value = "5 N*m", width = "0.4 rad" }, { value = "50 N*m" }]
        run.t_end = "1000 s"
        "#,
    );
    let (q, v) = end(&outcome);
    assert_eq!((q[0], v[0]), (0.4, 0.0));
    println!("beta {} from rest, {} rad/s", q[1] - 2.0, v[1]);
    assert!((q[1] - 2.0).abs() < 1e-12 && v[1].abs() < 1e-12);
    assert_eq!((outcome.counts.holds, outcome.counts.cell_changes), (1, 0));
    // A bounce of normal speed v takes 2 v/T, and damping 2 c v²/(3 T) of its speed: down to the least v that is
    // followed, v²/2 = 1e-12 of T + V = 10 J, there are 3 T/(2 c v) of them, and the last few of the first ones.
    let least = (2e-12 * 10.0f64).sqrt();
    let bounces = outcome.counts.reflections as f64;
    assert!((bounces * least / (1.5 * 0.5) - 1.0).abs() < 1e-3, "{bounces} bounces");
    println!("{bounces} bounces, {:e} J ignored", outcome.ignored);
    assert!(outcome.ignored > 0.0 && outcome.ignored <= 1e-12 * 10.0);
    assert!(residual(&outcome) < 1e-13 * outcome.energy_at_start, "{:e}", residual(&outcome));
}

/// Two stiffnesses that step at one place are one stiffness, whether they step alike or against each other.
#[test]
fn steps_at_one_place_are_one_step() {
    let scene = |k: [f64; 2], l: [f64; 2], speed: f64| {
        format!(
            r#"
            model = "twice"
            effects = ["stiffness_step"]
            start.alpha_dot = "{speed:?} rad/s"
            start.beta_dot = "0.1 rad/s"
            laws.k.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
            laws.l.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
            run.t_end = "10 s"
            "#,
            k[0], k[1], l[0], l[1]
        )
    };
    for speed in [2.0, 0.5, -2.0] {
        for (k, l) in [([5.0, 8.0], [1.0, 4.0]), ([5.0, 8.0], [9.0, 7.0]), ([5.0, 8.0], [9.0, 2.0])] {
            let both = run(&TWICE, &scene(k, l, speed));
            let sum = run(&TWICE, &scene([k[0] + l[0], k[1] + l[1]], [0.0, 0.0], speed));
            assert_eq!(
                (both.counts.cell_changes, both.counts.reflections),
                (sum.counts.cell_changes, sum.counts.reflections)
            );
            assert!(both.counts.cell_changes + both.counts.reflections > 5);
            let ((q, v), (q_sum, v_sum)) = (end(&both), end(&sum));
            for (a, b) in q.iter().chain(&v).zip(q_sum.iter().chain(&v_sum)) {
                assert!((a - b).abs() < 1e-12, "{q:?} {v:?}, not {q_sum:?} {v_sum:?}");
            }
            assert!(residual(&both) < 1e-14 * both.energy_at_start.max(1.0));
        }
    }
}

/// Two phases that meet their steps together: where inertia couples them the order matters, and the run says so.
#[test]
fn an_order_that_matters_is_told() {
    for (mu, ambiguous) in [(0.0, 0), (0.5, 1)] {
        let text = format!(
            r#"
            model = "meshes"
            effects = ["stiffness_step"]
            parameters.mu = "{mu:?} kg*m^2"
            start.alpha_dot = "2 rad/s"
            start.gamma_dot = "2 rad/s"
            laws.k.steps = [{{ value = "5 N*m", width = "0.4 rad" }}, {{ value = "8 N*m" }}]
            laws.l.steps = [{{ value = "3 N*m", width = "0.4 rad" }}, {{ value = "6 N*m" }}]
            run.t_end = "0.3 s"
            "#
        );
        let outcome = run(&MESHES, &text);
        assert_eq!((outcome.counts.ambiguous, outcome.counts.cell_changes), (ambiguous, 2), "mu = {mu}");
        assert!(residual(&outcome) < 1e-14 * outcome.energy_at_start);
    }
}
