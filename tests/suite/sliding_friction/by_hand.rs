//! The gear pair, computed tooth pair by tooth pair: each pair has a contact point, a normal force, and a friction force with a lever
//! arm on each gear. Classical Runge-Kutta steps end where a pair enters, leaves or passes the pitch point. Where the stiffness
//! steps, the jump rule applies.

use std::f64::consts::{PI, TAU};

use crate::{Teeth, common, run, state, unaccounted};

const INERTIA: [f64; 2] = [2890e-6, 740200e-6];
const TORQUE: f64 = 10.0;
const MU: f64 = 0.1;
const MIXED: f64 = 0.1;
/// Length of a step [s].
const STEP: f64 = 2e-7;

/// Rotations of the two gears [rad], each positive in its direction of drive, and their speeds [rad/s].
type State = [f64; 4];

struct Hand {
    teeth: Teeth,
    /// Stiffness along the line of action [N/m] with one pair in contact, and with two.
    kt: [f64; 2],
}

impl Hand {
    fn phase(&self, y: &State) -> f64 {
        (self.teeth.z[0] * y[0] + self.teeth.z[1] * y[1]) / 2.0
    }

    /// The phase [rad] at which a cell begins. Each pitch has three cells. The cells of all pitches are numbered one after the other.
    fn boundary(&self, cell: i64) -> f64 {
        let (p, [before, after]) = (self.teeth.base_pitch(), self.teeth.paths());
        let mut ends = [0.0, (after / p).fract() * TAU, (-before / p).rem_euclid(1.0) * TAU];
        ends.sort_by(f64::total_cmp);
        TAU * cell.div_euclid(3) as f64 + ends[cell.rem_euclid(3) as usize]
    }

    fn middle(&self, cell: i64) -> f64 {
        0.5 * (self.boundary(cell) + self.boundary(cell + 1))
    }

    fn stiffness(&self, cell: i64) -> f64 {
        self.kt[self.teeth.pairs(self.middle(cell)).len() - 1]
    }

    fn rate(&self, cell: i64, y: &State) -> State {
        let (teeth, [r1, r2], tan) = (&self.teeth, self.teeth.base(), self.teeth.alpha().tan());
        let force = self.stiffness(cell) * (r1 * y[0] - r2 * y[1]);
        let pairs = teeth.pairs(self.middle(cell));
        let rolling = y[2] + y[3];
        let mut torques = [TORQUE * teeth.z[0] - r1 * force, -TORQUE * teeth.z[1] + r2 * force];
        for ahead in &pairs {
            let xi = (self.phase(y) / TAU + ahead) * teeth.base_pitch();
            let recess = (self.middle(cell) / TAU + ahead).signum();
            let friction = MU * force.abs() / pairs.len() as f64 * recess * rolling / rolling.hypot(MIXED);
            // The coast flanks touch on the mirrored line of action.
            let tan = tan * force.signum();
            torques[0] -= friction * (r1 * tan + xi);
            torques[1] += friction * (r2 * tan - xi);
        }
        [y[2], y[3], torques[0] / INERTIA[0], torques[1] / INERTIA[1]]
    }

    fn step(&self, cell: i64, y: &State, h: f64) -> State {
        let plus = |f: State, h: f64| -> State { std::array::from_fn(|i| y[i] + h * f[i]) };
        let a = self.rate(cell, y);
        let b = self.rate(cell, &plus(a, h / 2.0));
        let c = self.rate(cell, &plus(b, h / 2.0));
        let d = self.rate(cell, &plus(c, h));
        std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
    }

    /// Applies the jump rule to the speeds, from cell `from` to cell `to`.
    fn jump(&self, y: &mut State, from: i64, to: i64) {
        let ([r1, r2], z) = (self.teeth.base(), self.teeth.z);
        let n = [z[0] / 2.0 / INERTIA[0], z[1] / 2.0 / INERTIA[1]];
        let g = (z[0] * n[0] + z[1] * n[1]) / 2.0;
        let v = (z[0] * y[2] + z[1] * y[3]) / 2.0;
        let dv = (self.stiffness(to) - self.stiffness(from)) * (r1 * y[0] - r2 * y[1]).powi(2) / 2.0;
        let after = (v * v - 2.0 * g * dv).sqrt() * v.signum();
        assert!(after.is_finite(), "no step reflects this motion");
        (y[2], y[3]) = (y[2] + n[0] / g * (after - v), y[3] + n[1] / g * (after - v));
    }

    fn run(&self, mut y: State, t_end: f64) -> State {
        let forwards = y[2] + y[3] > 0.0;
        let mut cell = (-3..6).find(|c| (self.boundary(*c)..self.boundary(c + 1)).contains(&self.phase(&y))).unwrap();
        let mut t = 0.0;
        while t < t_end {
            let mut h = STEP.min(t_end - t);
            let beyond = |y: &State| match forwards {
                true => self.phase(y) > self.boundary(cell + 1),
                false => self.phase(y) < self.boundary(cell),
            };
            let mut next = self.step(cell, &y, h);
            if beyond(&next) {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..60 {
                    h = 0.5 * (low + high);
                    *(if beyond(&self.step(cell, &y, h)) { &mut high } else { &mut low }) = h;
                }
                next = self.step(cell, &y, high);
                h = high;
                let to = if forwards { cell + 1 } else { cell - 1 };
                self.jump(&mut next, cell, to);
                cell = to;
            }
            (y, t) = (next, t + h);
        }
        y
    }
}

/// Forwards and backwards, by an explicit method and by an implicit one.
#[test]
fn runs_agree_with_the_computation_by_tooth_pairs() {
    let h = Teeth::SCENE.base()[0] / Teeth::SCENE.z[0];
    for (rpm, method) in [(600, "dop853"), (-600, "dop853"), (900, "radau")] {
        let outcome = run(&[
            r#"laws.k={teeth=[24, 96], module="6.35 mm", face_width="7 mm"}"#,
            &format!("start={{speed=\"{rpm} rpm\", theta=\"0.3 rad\"}}"),
            &format!("run={{t_end=\"20 ms\", method={method:?}, tolerance=1e-12}}"),
        ]);
        let levels = common::scene(
            "gear_pair_teeth",
            &[r#"laws.k={teeth=[24, 96], module="6.35 mm", face_width="7 mm"}"#.into()],
        );
        let kt = [0, 1].map(|i| levels.laws[0].steps[i].value / (2.0 * h * h));
        let [theta, phi, ..] = state(&outcome, 0);
        let speed = f64::from(rpm) * PI / 30.0;
        let (hand, z) = (Hand { teeth: Teeth::SCENE, kt }, Teeth::SCENE.z);
        let start = [(theta + phi) / z[0], (theta - phi) / z[1], speed, speed * z[0] / z[1]];
        let end = hand.run(start, 0.02);
        let (q1, q2, w1, w2) = (z[0] * end[0], z[1] * end[1], z[0] * end[2], z[1] * end[3]);
        let expected = [(q1 + q2) / 2.0, (q1 - q2) / 2.0, (w1 + w2) / 2.0, (w1 - w2) / 2.0];
        let found = state(&outcome, outcome.trajectory.len() - 1);
        println!("{rpm} rpm, {method}: {found:?}, by hand {expected:?}");
        for ((found, expected), size) in found.iter().zip(expected).zip([1.0, 1e-2, 100.0, 100.0]) {
            assert!((found - expected).abs() < 1e-7 * size, "{rpm} rpm, {method}: {found} for {expected}");
        }
        assert!(unaccounted(&outcome) < 1e-9, "{method}: {:e}", unaccounted(&outcome));
        // Per pitch one pair enters, one leaves and one passes the pitch point: three events, although three laws step there.
        let pitches = (found[0] - theta).abs() / TAU;
        let events = outcome.counts.cell_changes as f64;
        assert!((events - 3.0 * pitches).abs() < 3.0, "{events} in {pitches} pitches");
    }
}
