//! `modes` and `floquet` where the inertia depends on the coordinates: about an equilibrium, and about the motion that repeats after a turn.

use std::f64::consts::{PI, TAU};

use gearsim::__private::{Inside, LinearisedAbout, linear};
use gearsim::analysis::floquet::{Floquet, Verdict};
use gearsim::analysis::modes::CellModes;
use gearsim::model::Start;
use gearsim::run::Entry;
use gearsim::scene::Scene;
use nalgebra::{Complex, DMatrix};

use super::{common, double_pendulum, linkage, pendulum, scene};

const PENDULUM: Entry = Entry::new::<pendulum::Pendulum>();
const DOUBLE: Entry = Entry::new::<double_pendulum::DoublePendulum>();
const LINKAGE: Entry = Entry::new::<linkage::Linkage>();

const G: f64 = 9.81;

fn cell(entry: &Entry, scene: &Scene) -> (CellModes, LinearisedAbout) {
    let system = entry.about_steady_motion(scene).unwrap();
    let levels = scene.mid_stiffnesses();
    (
        linear::modes(&system, &levels, &linear::Parts::default()).unwrap(),
        system.steady().expect("M depends on q").motion,
    )
}

/// omega² = g/l, from a start at which the pendulum hangs, and from one at which it does not.
#[test]
fn a_pendulum_has_the_frequency_of_its_equilibrium() {
    let (l, m) = (0.7, 2.0);
    for x in ["0 m", "0.3 m"] {
        let text = format!(
            "model = \"pendulum\"\neffects = []\n[parameters]\nm = \"{m} kg\"\nl = \"{l} m\"\ng = \"{G} m/s^2\"\n[start]\n\
             x = \"{x}\"\n[run]\nt_end = \"1 s\"\n"
        );
        let (cell, motion) = cell(&PENDULUM, &scene(&PENDULUM, &text, &[]));
        let expected = (G / l).sqrt() / TAU;
        println!("from {x}: {} Hz, {expected} by the closed form", cell.modes[0].natural);
        assert_eq!(motion, LinearisedAbout::Equilibrium, "from {x}");
        assert!((cell.modes[0].natural / expected - 1.0).abs() < 1e-12, "from {x}: {}", cell.modes[0].natural);
    }
}

fn double(start: &str) -> Scene {
    let text = format!(
        "model = \"double_pendulum\"\neffects = []\n[parameters]\nm1 = \"1 kg\"\nm2 = \"0.6 kg\"\nl1 = \"0.5 m\"\nl2 = \"0.4 m\"\n\
         g = \"{G} m/s^2\"\n[start]\n{start}\n[run]\nt_end = \"1 s\"\n"
    );
    scene(&DOUBLE, &text, &[])
}

/// lambda² of M lambda² + K, M = ((m1 + m2) l1², s m2 l1 l2; ., m2 l2²), K = g diag((m1 + m2) l1 s1, m2 l2 s2), where s1, s2 = 1 for a
/// hanging pendulum and -1 for an inverted one, s = s1 s2.
fn squares([m1, m2, l1, l2]: [f64; 4], [s1, s2]: [f64; 2]) -> [f64; 2] {
    let (a, b, c) = ((m1 + m2) * l1 * l1, s1 * s2 * m2 * l1 * l2, m2 * l2 * l2);
    let (k1, k2) = (G * (m1 + m2) * l1 * s1, G * m2 * l2 * s2);
    let (p, q, r) = (a * c - b * b, a * k2 + c * k1, k1 * k2);
    let root = (q * q - 4.0 * p * r).sqrt();
    let mut squares = [(-q + root) / (2.0 * p), (-q - root) / (2.0 * p)];
    squares.sort_by(|a, b| b.total_cmp(a));
    squares
}

/// If both pendulums hang, there are two natural frequencies. If the lower one or both are upright, the motion grows at the rate of the
/// closed form.
#[test]
fn a_double_pendulum_has_the_eigenvalues_of_the_closed_form() {
    let p = [1.0, 0.6, 0.5, 0.4];
    for (start, stands) in [
        ("a1 = \"0.2 rad\"", [1.0, 1.0]),
        (&*format!("a2 = \"{PI:?} rad\""), [1.0, -1.0]),
        (&*format!("a1 = \"{PI:?} rad\"\na2 = \"{PI:?} rad\""), [-1.0, -1.0]),
    ] {
        let (cell, motion) = cell(&DOUBLE, &double(start));
        assert_eq!(motion, LinearisedAbout::Equilibrium, "{start}");
        let expected = squares(p, stands);
        let mut found: Vec<f64> = cell
            .modes
            .iter()
            .map(|mode| if mode.growth > 0.0 { mode.growth.powi(2) } else { -(TAU * mode.natural).powi(2) })
            .collect();
        found.sort_by(|a, b| b.total_cmp(a));
        println!("{start:?}: lambda² = {found:?}, by the closed form {expected:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-10, "{start:?}: {found} is not {expected}");
        }
    }
}

/// A flywheel that turns a crank, with a wheel on a spring that nothing else moves: its multipliers are exp(+-i omega T).
#[test]
fn a_vibration_that_the_crank_does_not_reach_keeps_its_multipliers() {
    let text = "model = \"linkage\"\neffects = [\"crank\"]\n[parameters]\nI_f = \"0.2 kg*m^2\"\nI_w = \"0.1 kg*m^2\"\nr_p = \"60 mm\"\n\
                l_p = \"200 mm\"\nm_p = \"4 kg\"\n[laws.k]\nsteps = [{ value = \"40 N*m/rad\", width = \"0.5 rad\" }, { value = \"40 N*m/rad\" }]\n\
                [start]\nspeed = \"50 rad/s\"\n[run]\nt_end = \"1 s\"\n";
    let scene = scene(&LINKAGE, text, &[]);
    let floquet = linear::floquet(&scene, &LINKAGE.about_steady_motion(&scene).unwrap()).unwrap();
    let orbit = floquet.orbit.as_ref().expect("the inertia changes");
    let omega = (40.0f64 / 0.1).sqrt();
    let expected = Complex::new(0.0, omega * floquet.period).exp();
    println!("{:?}, expected {expected}, speed {}, drift {:.1e}", floquet.multipliers, orbit.speed, orbit.drift);
    assert!((orbit.turn - TAU).abs() < 1e-12 && orbit.drift.abs() < 1e-9);
    assert!((orbit.speed - 1.0).norm() < 1e-6, "energy is conserved: {}", orbit.speed);
    assert!(floquet.multipliers.len() == 2 && floquet.verdict == Verdict::Neutral, "{floquet:?}");
    for z in &floquet.multipliers {
        assert!(
            (Complex::new(z.re, z.im.abs()) - Complex::new(expected.re, expected.im.abs())).norm() < 1e-8,
            "{z} is not {expected}"
        );
    }
}

/// The derivative of a flow by its start (2n x 2n), by central differences with the steps `units`.
fn differences(start: &[f64], units: &[f64], flow: impl Fn(&[f64]) -> Vec<f64>) -> DMatrix<f64> {
    let n = start.len();
    let mut phi = DMatrix::zeros(n, n);
    for j in 0..n {
        let at = |sign: f64| {
            let mut moved = start.to_vec();
            moved[j] += sign * units[j];
            flow(&moved)
        };
        let (up, down) = (at(1.0), at(-1.0));
        for i in 0..n {
            phi[(i, j)] = (up[i] - down[i]) / (2.0 * units[j]);
        }
    }
    phi
}

/// Trace and determinant of the map from turn to turn, on the section of the first coordinate.
fn invariants(phi: &DMatrix<f64>, rate: &[f64]) -> [f64; 2] {
    let n = phi.nrows();
    let map = DMatrix::from_fn(n - 1, n - 1, |r, c| phi[(r + 1, c + 1)] - rate[r + 1] * phi[(0, c + 1)] / rate[0]);
    [map.trace(), map.determinant()]
}

/// Trace and determinant of this map from its Floquet multipliers.
fn of_multipliers(floquet: &Floquet) -> [f64; 2] {
    let all = || floquet.multipliers.iter().chain(floquet.orbit.iter().map(|orbit| &orbit.speed));
    [all().sum::<Complex<f64>>().re, all().product::<Complex<f64>>().re]
}

/// The end of a run of `scene` from (q, q') after the time `t`, and its accelerations there.
fn flow(entry: &Entry, scene: &Scene, y: &[f64], t: f64) -> [Vec<f64>; 2] {
    let (mut scene, n) = (scene.clone(), y.len() / 2);
    scene.t_end = t;
    for i in 0..n {
        (scene.start.q[i], scene.start.q_dot[i]) = (Start::At(y[i]), Some(y[n + i]));
    }
    let equations = entry.equations(&scene).unwrap();
    let mut simulation = entry.simulation(&scene, &*equations).unwrap();
    simulation.run(None, &mut |_| {}).unwrap();
    let state = &simulation.now.state;
    let q = state.unwrapped(&simulation.turn_lengths());
    let a = &simulation.now.mobility() * &simulation.now.force();
    [q.iter().chain(state.q_dot.iter()).copied().collect(), state.q_dot.iter().chain(a.iter()).copied().collect()]
}

/// The multipliers against differences of the flow of dop853, with steps of the stiffness, whose impulses depend on the place.
#[test]
fn multipliers_are_those_of_the_flow_of_dop853() {
    let steps = ["run.method=dop853", "run.tolerance=1e-13"];
    let scenes: [(&str, &[&str]); 3] = [
        (
            "cardan_drive",
            &["parameters.beta=30 deg", "parameters.beta_K=0.1 us", "parameters.N2=24", "start.speed=3000 rpm"],
        ),
        (
            "crank_drive",
            &[
                "parameters.beta_K=1 us",
                "parameters.N2=24",
                "parameters.I2=20000 kg*mm^2",
                "parameters.m_p=2 kg",
                "start.speed=3000 rpm",
            ],
        ),
        (
            "crank_drive",
            &[
                "effects=[\"stiffness_step\", \"rigid_kinematics\", \"torques\", \"damping\"]",
                "parameters.N2=24",
                "parameters.I2=20000 kg*mm^2",
                "parameters.m_p=2 kg",
                "parameters.beta_K=1 us",
                "start.speed=3000 rpm",
            ],
        ),
    ];
    for (name, set) in scenes {
        let all: Vec<String> = set.iter().chain(&steps).map(|s| s.to_string()).collect();
        let scene = common::scene(name, &all);
        let entry = common::model(name);
        let floquet = linear::floquet(&scene, &entry.about_steady_motion(&scene).unwrap()).unwrap();
        let orbit = floquet.orbit.as_ref().expect("the inertia changes");
        let start: Vec<f64> = orbit.start.concat();
        let [end, rate] = flow(entry, &scene, &start, floquet.period);
        assert!(
            (end[0] - start[0] - orbit.turn).abs() < 1e-7 && (end[1] - start[1]).abs() < 1e-6 * start[1].abs(),
            "{name} does not close"
        );
        let units = [1e-6, 1e-9, 1e-5, 1e-5];
        let phi = differences(&start, &units, |y| flow(entry, &scene, y, floquet.period)[0].clone());
        let (found, expected) = (of_multipliers(&floquet), invariants(&phi, &rate));
        println!(
            "{name}: {:?}, speed {}, drift {:.2e}, gap {:.1e}: {found:?}, by differences {expected:?}",
            floquet.multipliers, orbit.speed, orbit.drift, orbit.gap
        );
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-5), "{name}: {found:?} is not {expected:?}");
    }
}

/// A gear pair with constant stiffness and a load behind a joint, in the rotations of its gears, by hand:
/// I1 a1'' = -r1 k d, J a2'' + J'/2 a2'² = r2 k d with d = r1 a1 - r2 a2, J = I2 + I_o (cos b/(1 - sin² b cos² a2))².
struct ByHand {
    inertia: [f64; 2],
    behind: f64,
    angle: f64,
    radii: [f64; 2],
    stiffness: f64,
}

impl ByHand {
    fn rate(&self, [a1, a2, v1, v2]: [f64; 4]) -> [f64; 4] {
        let (sin, cos) = a2.sin_cos();
        let square = self.angle.sin().powi(2);
        let below = 1.0 - square * cos * cos;
        let ratio = self.angle.cos() / below;
        let slope = -2.0 * self.angle.cos() * square * sin * cos / (below * below);
        let inertia = self.inertia[1] + self.behind * ratio * ratio;
        let force = self.stiffness * (self.radii[0] * a1 - self.radii[1] * a2);
        let second = (self.radii[1] * force - self.behind * ratio * slope * v2 * v2) / inertia;
        [v1, v2, -self.radii[0] * force / self.inertia[0], second]
    }

    fn flow(&self, mut y: [f64; 4], t: f64, steps: usize) -> [f64; 4] {
        let h = t / steps as f64;
        let plus = |y: [f64; 4], h: f64, k: [f64; 4]| std::array::from_fn(|i| y[i] + h * k[i]);
        for _ in 0..steps {
            let k1 = self.rate(y);
            let k2 = self.rate(plus(y, 0.5 * h, k1));
            let k3 = self.rate(plus(y, 0.5 * h, k2));
            let k4 = self.rate(plus(y, h, k3));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        y
    }
}

/// A shaft behind a joint excites the mesh according to Hill's equation: it is unstable at one speed and stable at another. Every
/// multiplier is that of the equations by hand.
#[test]
fn multipliers_behind_a_joint_are_those_of_hand_written_equations() {
    let (n1, n2, r1) = (24.0, 96.0, 0.0716);
    let by_hand = ByHand { inertia: [0.05, 0.04], behind: 0.4, angle: 0.6, radii: [r1, r1 * n2 / n1], stiffness: 3e4 };
    let mut verdicts = vec![];
    for speed in [372.0, 500.0] {
        let all = [
            "effects=[]".to_string(),
            "parameters.I1=0.05 kg*m^2".into(),
            "parameters.I2=0.04 kg*m^2".into(),
            "parameters.beta=0.6 rad".into(),
            "laws.k12.steps=[{value=\"30000 N/m\"}]".into(),
            format!("start.speed={speed} rad/s"),
        ];
        let scene = common::scene("cardan_drive", &all);
        let entry = common::model("cardan_drive");
        let floquet = linear::floquet(&scene, &entry.about_steady_motion(&scene).unwrap()).unwrap();
        let orbit = floquet.orbit.as_ref().expect("the inertia changes");
        let h = r1 / n1;
        let rotations = |q: &[f64]| [(q[0] + q[1] / (2.0 * h)) / n1, (q[0] - q[1] / (2.0 * h)) / n2];
        let ([a1, a2], [v1, v2]) = (rotations(&orbit.start[0]), rotations(&orbit.start[1]));
        let start = [a1, a2, v1, v2];
        let flow = |y: &[f64]| by_hand.flow([y[0], y[1], y[2], y[3]], floquet.period, 40_000);
        let end = flow(&start);
        let rate = by_hand.rate(end);
        assert!((end[1] - a2 - PI).abs() < 1e-6 && (end[3] / v2 - 1.0).abs() < 1e-6, "{start:?} comes to {end:?}");
        let phi = differences(&start, &[1e-6, 1e-6, 1e-4, 1e-4], |y| flow(y).to_vec());
        // The section theta = const, in the rotations: n1 da1 + n2 da2 = 0. `to` leads to the coordinates (theta, a2, v1, v2), theta first.
        let to = DMatrix::from_row_slice(
            4,
            4,
            &[n1 / 2.0, n2 / 2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        );
        let seen = &to * &phi * to.clone().try_inverse().unwrap();
        let rate: Vec<f64> = (&to * nalgebra::DVector::from_row_slice(&rate)).iter().copied().collect();
        let (found, expected) = (of_multipliers(&floquet), invariants(&seen, &rate));
        println!("{speed} rad/s: {:?}, speed {}: {found:?}, by hand {expected:?}", floquet.multipliers, orbit.speed);
        assert!(
            found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5),
            "{speed}: {found:?} is not {expected:?}"
        );
        verdicts.push(floquet.verdict.is_unstable());
    }
    assert_eq!(verdicts, [true, false], "unstable beside the first speed only");
}
