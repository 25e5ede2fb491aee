//! A pendulum in a coordinate in which its inertia varies, and a double pendulum.

use std::f64::consts::PI;

use super::{double_pendulum, largest, pendulum, run};
use gearsim::run::Entry;

const PENDULUM: Entry = Entry::new::<pendulum::Pendulum>();
const DOUBLE: Entry = Entry::new::<double_pendulum::DoublePendulum>();

const G: f64 = 9.81;

/// The period of a pendulum of length `l` with the amplitude `phi`: 4 (l/g)^(1/2) K(sin(phi/2)), by the arithmetic-geometric mean.
fn period(l: f64, phi: f64) -> f64 {
    let (mut a, mut b) = (1.0f64, (0.5 * phi).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    2.0 * PI / a * (l / G).sqrt()
}

/// In x = l sin phi the inertia is m l²/(l² - x²). After any number of periods the pendulum is where it began.
#[test]
fn a_pendulum_has_the_period_of_the_elliptic_integral() {
    for amplitude in [0.2f64, 0.9, 1.4] {
        let (l, periods) = (0.7, 3.0);
        let (x, t_end) = (l * amplitude.sin(), periods * period(l, amplitude));
        let text = format!(
            "model = \"pendulum\"\neffects = []\n[parameters]\nm = \"2 kg\"\nl = \"{l} m\"\ng = \"{G} m/s^2\"\n[start]\n\
             x = \"{x:?} m\"\n[run]\nt_end = \"{t_end:?} s\"\ntolerance = 1e-13\n"
        );
        for method in ["dop853", "radau"] {
            let outcome = run(&PENDULUM, &text, &[&format!("run.method={method}")]);
            let t = &outcome.trajectory;
            let last = t.len() - 1;
            // At the end of a period the speed passes zero: a wrong period shows in it first.
            let (apart, speed) = ((t.q[0][last] - x).abs() / x, t.q_dot[0][last].abs() / (x * (G / l).sqrt()));
            println!("{method}, {amplitude} rad: {apart:.1e}, {speed:.1e}, unaccounted {:.1e}", largest(&t.residual));
            assert!(apart < 1e-9 && speed < 1e-9, "{method}, {amplitude} rad: {apart:e}, {speed:e}");
            assert!(largest(&t.residual) < 1e-10 * outcome.energy_at_start, "{method}: energy is not conserved");
        }
    }
}

/// The accelerations of the double pendulum as textbooks have them, solved for the angles.
fn accelerations([m1, m2, l1, l2]: [f64; 4], [a1, a2]: [f64; 2], [w1, w2]: [f64; 2]) -> [f64; 2] {
    let d = a1 - a2;
    let common = 2.0 * m1 + m2 - m2 * (2.0 * d).cos();
    let first = -G * (2.0 * m1 + m2) * a1.sin()
        - m2 * G * (a1 - 2.0 * a2).sin()
        - 2.0 * d.sin() * m2 * (w2 * w2 * l2 + w1 * w1 * l1 * d.cos());
    let second = 2.0 * d.sin() * (w1 * w1 * l1 * (m1 + m2) + G * (m1 + m2) * a1.cos() + w2 * w2 * l2 * m2 * d.cos());
    [first / (l1 * common), second / (l2 * common)]
}

/// The motion by the classical method of Runge and Kutta in `steps` steps.
fn by_hand(p: [f64; 4], mut y: [f64; 4], t_end: f64, steps: usize) -> [f64; 4] {
    let rate = |y: [f64; 4]| {
        let [b1, b2] = accelerations(p, [y[0], y[1]], [y[2], y[3]]);
        [y[2], y[3], b1, b2]
    };
    let plus = |y: [f64; 4], h: f64, k: [f64; 4]| std::array::from_fn(|i| y[i] + h * k[i]);
    let h = t_end / steps as f64;
    for _ in 0..steps {
        let k1 = rate(y);
        let k2 = rate(plus(y, 0.5 * h, k1));
        let k3 = rate(plus(y, 0.5 * h, k2));
        let k4 = rate(plus(y, h, k3));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    y
}

#[test]
fn a_double_pendulum_moves_as_by_the_equations_of_textbooks() {
    let (p, start, t_end) = ([1.0, 0.6, 0.5, 0.4], [1.1, -0.4, 0.3, 2.0], 2.0);
    let text = format!(
        "model = \"double_pendulum\"\neffects = []\n[parameters]\nm1 = \"1 kg\"\nm2 = \"0.6 kg\"\nl1 = \"0.5 m\"\nl2 = \"0.4 m\"\n\
         g = \"{G} m/s^2\"\n[start]\na1 = \"1.1 rad\"\na2 = \"-0.4 rad\"\na1_dot = \"0.3 rad/s\"\na2_dot = \"2 rad/s\"\n[run]\n\
         t_end = \"{t_end} s\"\ntolerance = 1e-13\n"
    );
    let expected = by_hand(p, start, t_end, 80_000);
    let coarse = by_hand(p, start, t_end, 40_000);
    for method in ["dop853", "radau"] {
        let outcome = run(&DOUBLE, &text, &[&format!("run.method={method}")]);
        let t = &outcome.trajectory;
        let last = t.len() - 1;
        let found = [t.q[0][last], t.q[1][last], t.q_dot[0][last], t.q_dot[1][last]];
        for i in 0..4 {
            let (error, of_hand) = ((found[i] - expected[i]).abs(), (coarse[i] - expected[i]).abs());
            println!(
                "{method}, component {i}: {error:.1e}; error of the solution by hand about {:.1e}",
                of_hand / 15.0
            );
            assert!(error < 1e-8, "{method}, component {i}: {} is not {}", found[i], expected[i]);
        }
        assert!(largest(&t.residual) < 1e-10 * largest(&t.kinetic), "{method}: energy is not conserved");
    }
}
