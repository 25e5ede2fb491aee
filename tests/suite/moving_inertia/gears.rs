//! The jump rule with G(q) = n.M(q)⁻¹n, and held contact, in gear pairs that turn a slider-crank.

use gearsim::run::Outcome;
use gearsim::trajectory::Moment;

use super::common;
use super::largest;

/// M of the scene `crank_drive` in theta and s with a light driven gear, by hand.
fn mass(q: [f64; 2]) -> [[f64; 2]; 2] {
    let (n1, n2, r1, r, l) = (24.0, 96.0, 0.0716, 0.06, 0.2f64);
    let h = r1 / n1;
    let theta = (q[0] - q[1] / (2.0 * h)) / n2;
    let b = (r / l * theta.sin()).asin();
    let ratio = r * (theta + b).sin() / b.cos();
    let (i1, i2) = (2890e-6, 20000e-6 + 40.0 * ratio * ratio);
    let [a, c] = [[1.0 / n1, 1.0 / (2.0 * h * n1)], [1.0 / n2, -1.0 / (2.0 * h * n2)]];
    std::array::from_fn(|i| std::array::from_fn(|j| i1 * a[i] * a[j] + i2 * c[i] * c[j]))
}

fn kinetic(m: [[f64; 2]; 2], v: [f64; 2]) -> f64 {
    0.5 * (m[0][0] * v[0] * v[0] + 2.0 * m[0][1] * v[0] * v[1] + m[1][1] * v[1] * v[1])
}

fn row(outcome: &Outcome, i: usize) -> ([f64; 2], [f64; 2]) {
    let t = &outcome.trajectory;
    ([t.q[0][i], t.q[1][i]], [t.q_dot[0][i], t.q_dot[1][i]])
}

/// At every step the speeds change by a multiple of M(q)⁻¹n, so that the momentum of s is the same, and T + V is unchanged.
#[test]
fn a_step_changes_the_speeds_by_the_inertia_at_its_place() {
    let outcome = common::run(&common::scene("crank_drive", &["parameters.I2=20000 kg*mm^2".to_string()]));
    let t = &outcome.trajectory;
    let start = outcome.energy_at_start;
    let (mut steps, mut varied) = (0, [f64::INFINITY, 0.0f64]);
    for i in 1..t.len() {
        if (t.moment[i - 1], t.moment[i]) != (Moment::Before, Moment::After) {
            continue;
        }
        let ((q, before), (_, after)) = (row(&outcome, i - 1), row(&outcome, i));
        let m = mass(q);
        assert!(
            (kinetic(m, before) - t.kinetic[i - 1]).abs() < 1e-13 * start,
            "row {i}: T is not that of M(q) by hand"
        );
        let gained = kinetic(m, after) - kinetic(m, before) + t.strain[i] - t.strain[i - 1];
        assert!(gained.abs() < 1e-14 * start, "row {i}: {gained:e} J gained");
        let change = [after[0] - before[0], after[1] - before[1]];
        let momentum = [0, 1].map(|k| m[k][0] * change[0] + m[k][1] * change[1]);
        let rounding = 1e-15 * (m[1][0] * before[0]).abs();
        assert!(momentum[1].abs() < 1e-9 * (m[1][1] * change[1]).abs() + rounding, "row {i}: {momentum:?}");
        let inverse = m[1][1] / (m[0][0] * m[1][1] - m[0][1] * m[0][1]);
        varied = [varied[0].min(inverse), varied[1].max(inverse)];
        steps += 1;
    }
    println!(
        "{steps} steps, G from {:.3e} to {:.3e}, unaccounted {:.1e} of T + V",
        varied[0],
        varied[1],
        largest(&t.residual) / start
    );
    assert!(steps > 100 && varied[1] > 1.3 * varied[0], "{steps} steps, G from {} to {}", varied[0], varied[1]);
    assert!(largest(&t.residual) < 1e-12 * start, "energy is not conserved: {:e} J", largest(&t.residual));
}

/// A slow pair that a torque presses against a step is reflected, and finally held; the account closes.
#[test]
fn a_pair_pressed_against_a_step_is_held() {
    let overrides = [
        "start.theta=1.7 rad",
        "start.speed=2 rpm",
        "run.t_end=0.6 s",
        "parameters.T_motor=400 N*m",
        "parameters.T_load=1599 N*m",
        "parameters.alpha_M=20 1/s",
        "parameters.beta_K=40 us",
    ];
    let outcome = common::run(&common::scene("crank_drive", &overrides.map(String::from)));
    let t = &outcome.trajectory;
    println!("{:?}, unaccounted {:.1e} J of {:.1e}", outcome.counts, largest(&t.residual), largest(&t.strain));
    assert!(outcome.counts.reflections > 0 && outcome.counts.holds > 0, "{:?}", outcome.counts);
    assert!(largest(&t.residual) < 1e-9 * largest(&t.strain), "{:e}", largest(&t.residual));
}

/// A connecting rod that is not longer than the crank has no place for the piston: the scene is refused, at a point of a sweep too.
#[test]
fn a_rod_must_be_longer_than_its_crank() {
    let scene = common::scene("crank_drive", &[]);
    let refused = |length: &str| scene.with("parameters.l_p", length).expect_err("too short").to_string();
    for length in ["60 mm", "50 mm"] {
        let message = refused(length);
        assert!(message.contains("must exceed `r_p`, which is 0.06 m"), "{message}");
    }
    assert!(scene.with("parameters.l_p", "61 mm").is_ok());
    assert!(
        scene.with("parameters.r_p", "0.3 m").expect_err("a longer crank").to_string().contains("must exceed `r_p`")
    );
}
