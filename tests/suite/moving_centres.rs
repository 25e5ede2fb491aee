//! Gears whose centres move (effect `moving_centres`), compared with the geometry of involutes and forces as vectors, with the closed form
//! of the opening play, and with the linear model in the limit of small motions. The energy account closes.
mod common;

use std::f64::consts::TAU;

use gearsim::model::Start;
use gearsim::run::Outcome;
use gearsim::scene::Scene;
use gearsim::trajectory::Moment;

const N1: f64 = 24.0;
const N2: f64 = 96.0;
const R1: f64 = 0.0716;
const R2: f64 = R1 * N2 / N1;
const ALPHA: f64 = 20.0 * TAU / 360.0;

fn scene(effects: &[&str], set: &[&str]) -> Scene {
    let effects = format!("effects={effects:?}");
    let all: Vec<String> = [effects].into_iter().chain(set.iter().map(|s| s.to_string())).collect();
    common::scene("gear_pair_bearings", &all)
}

fn run(scene: &Scene) -> Outcome {
    let outcome = common::model("gear_pair_bearings").run(scene, &mut |_| {}).expect("a scene that can be run");
    assert!(
        outcome.stopped_by.is_none() && outcome.refuted.is_none(),
        "{:?} {:?}",
        outcome.stopped_by,
        outcome.refuted
    );
    outcome
}

/// The contact of two involute gears, described by a string from the base circle of the first gear to that of the second, crossed between
/// the circles.
struct Cord {
    /// Penetration of the drive flanks [m].
    depth: f64,
    /// Direction of the string, from the first gear to the second.
    along: [f64; 2],
}

/// The string between the base circles. a1 and a2 are the rotations of the gears \[rad\], each in its own direction; the centres are
/// displaced \[m\]. Without rotations and displacements the string is at the pressure angle, and the depth is zero. The string touches the
/// first circle at the angle b: the free lengths of the flanks' involutes are r1 (a1 - b) and -r2 (a2 + b), up to a constant. The flanks
/// overlap by the excess of these lengths over the distance of the points where the string touches the circles.
fn string([a1, a2]: [f64; 2], [x1, y1, x2, y2]: [f64; 4]) -> Cord {
    let free = |[x1, y1, x2, y2]: [f64; 4]| {
        let distance = (R1 + R2) / ALPHA.cos();
        let (dx, dy) = (distance + x2 - x1, y2 - y1);
        let between = dx.hypot(dy);
        let b = dy.atan2(dx) - ((R1 + R2) / between).acos();
        let [p, q] = [[x1 + R1 * b.cos(), y1 + R1 * b.sin()], [distance + x2 - R2 * b.cos(), y2 - R2 * b.sin()]];
        (b, (q[0] - p[0]).hypot(q[1] - p[1]))
    };
    let ((b, length), (b0, length0)) = (free([x1, y1, x2, y2]), free([0.0; 4]));
    let depth = R1 * a1 - R2 * a2 - (R1 + R2) * (b - b0) - (length - length0);
    Cord { depth, along: [-b.sin(), b.cos()] }
}

/// theta and s of rotations of the gears.
fn coordinates([a1, a2]: [f64; 2]) -> [f64; 2] {
    [0.5 * (N1 * a1 + N2 * a2), R1 * a1 - R2 * a2]
}

/// At any position, the accelerations are those of the force k d + c d' along the common tangent. d is the depth, and its rate d' is a
/// difference quotient.
#[test]
fn forces_act_along_the_common_tangent_of_the_base_circles() {
    let scene = scene(&["moving_centres", "damping", "stiffness_step"], &["parameters.beta_K=2 us"]);
    let value = |name: &str| scene.parameters[scene.model.parameters.iter().position(|p| p.name == name).unwrap()];
    let [i1, i2, m1, m2, kb1, kb2] = ["I1", "I2", "m1", "m2", "kb1", "kb2"].map(value);
    let (k, mid, beta) = (1.2e8, 0.5 * (80.3e6 + 156e6), 2e-6);
    let mut random = 0.37f64;
    let mut next = |size: f64| {
        random = (random * 997.0 + 0.1234567).fract();
        size * (2.0 * random - 1.0)
    };
    for size in [1e-6, 1e-4, 3e-3] {
        for _ in 0..20 {
            let a = [next(1.0), 0.0];
            let a = [a[0], a[0] * R1 / R2 + next(size / R2)];
            let w = [next(100.0), next(25.0)];
            let c: [f64; 4] = std::array::from_fn(|_| next(size));
            let v: [f64; 4] = std::array::from_fn(|_| next(1.0));
            let moved =
                |h: f64| string([a[0] + h * w[0], a[1] + h * w[1]], std::array::from_fn(|i| c[i] + h * v[i])).depth;
            let Cord { depth, along } = string(a, c);
            let h = 1e-6;
            let rate = (moved(h) - moved(-h)) / (2.0 * h);
            let force = k * depth + beta * mid * rate;
            let expected = {
                let second = [-R1 * force / i1, R2 * force / i2];
                let [theta, s] = coordinates(second);
                let at = |i: usize, sign: f64, kb: f64, m: f64| {
                    (sign * force * along[i % 2] - kb * c[i] - beta * kb * v[i]) / m
                };
                [theta, s, at(0, -1.0, kb1, m1), at(1, -1.0, kb1, m1), at(2, 1.0, kb2, m2), at(3, 1.0, kb2, m2)]
            };
            let ([theta, s], [theta_dot, s_dot]) = (coordinates(a), coordinates(w));
            let q = [theta, s, c[0], c[1], c[2], c[3]];
            let q_dot = [theta_dot, s_dot, v[0], v[1], v[2], v[3]];
            let found = scene.acceleration(&q, &q_dot, &[k]).unwrap();
            // Each acceleration has the rounding errors of the depth, and of the difference for its rate.
            for i in 0..6 {
                let error = (found[i] - expected[i]).abs();
                let scale = expected[i].abs()
                    + (force.abs() + beta * mid)
                        * [N1 * R1 / i1, R1 * R1 / i1, 1.0 / m1, 1.0 / m1, 1.0 / m2, 1.0 / m2][i];
                assert!(
                    error < 2e-7 * scale,
                    "size {size}, {i}: {} is not {}, {error:e} of {scale:e}",
                    found[i],
                    expected[i]
                );
            }
        }
    }
}

/// In the limit of small motions `moving_centres` is the linear model: the difference falls with the square of the motion.
#[test]
fn small_motions_are_those_of_the_linear_model() {
    let accelerations = |effects: &[&str], size: f64| {
        let q = [0.0, 0.3 * size, size, -0.4 * size, 0.2 * size, 0.7 * size];
        scene(effects, &[]).acceleration(&q, &[0.0; 6], &[1e8]).unwrap()
    };
    let apart = |size: f64| {
        let (bent, straight) =
            (accelerations(&["moving_centres", "stiffness_step"], size), accelerations(&["stiffness_step"], size));
        let difference = bent.iter().zip(&straight).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        difference / straight.iter().map(|a| a.abs()).fold(0.0, f64::max)
    };
    for size in [1e-3, 1e-4, 1e-5] {
        let ratio = apart(size) / apart(0.5 * size);
        println!("{size} m: {:.2e} of the linear accelerations, {ratio:.3} times that of half the size", apart(size));
        assert!((ratio - 2.0).abs() < 0.02 && apart(size) > size, "{size}: {ratio}");
    }
}

/// Gears without bearings, the second one displaced: x and y of its centre \[m\], the play b \[m\], the speed v \[m/s\] through it from s = 0.
struct Floating {
    x: f64,
    y: f64,
    b: f64,
    v: f64,
}

fn floating(effects: &[&str], Floating { x, y, b, v }: Floating, more: &[&str]) -> Scene {
    let set = [
        "parameters.kb1=0 N/m",
        "parameters.kb2=0 N/m",
        &format!("parameters.b12={b} m"),
        &format!("start.x2={x} m"),
        &format!("start.y2={y} m"),
        "start.x1=0 m",
        "start.y1=0 m",
        "start.s=0 m",
        &format!("start.s_dot={v} m/s"),
        "start.theta_dot=0 rad/s",
        "run.t_end=1 ms",
        "output.record=[\"play_opening_12\"]",
    ];
    scene(effects, &[&set[..], more].concat())
}

/// A gear moves freely through its play while the centres are further apart than at rest. From the middle it meets the drive flank after
/// the distance b/2 + R (phi + inv a' - inv a), and the coast flank after b/2 - R phi + R (inv a' - inv a). R is the sum of the base radii,
/// phi the angle by which the line of centres is turned, a the pressure angle, and a' that of the displaced centres.
#[test]
fn the_play_opens_as_the_centres_move_apart() {
    let (x, y, b) = (0.4e-3, 0.1e-3, 100e-6);
    let involute = |a: f64| a.tan() - a;
    let distance = (R1 + R2) / ALPHA.cos();
    let between = (distance + x).hypot(y);
    let opening = (R1 + R2) * (involute(((R1 + R2) / between).acos()) - involute(ALPHA));
    let turn = (R1 + R2) * y.atan2(distance + x);
    for (v, way) in [(1.0, 0.5 * b + turn + opening), (-1.0, 0.5 * b - turn + opening)] {
        let scene = floating(
            &["moving_centres", "backlash"],
            Floating { x, y, b, v },
            &["run.tolerance=1e-12", "run.method=dop853"],
        );
        let outcome = run(&scene);
        let t = &outcome.trajectory;
        let met = t.moment.iter().position(|m| *m == Moment::Before).expect("the flanks meet");
        let (found, play) = (t.q[1][met].abs(), t.outputs[0].1[0]);
        println!("v = {v} m/s: contact after {found:e} m, {way:e} by the closed form; opening {play:e}, {opening:e}");
        assert!((found - way).abs() < 1e-12 && (play - opening).abs() < 1e-15, "{found} {way} {play} {opening}");
        assert!(opening > 0.1 * b && (way - 0.5 * b).abs() > 0.1 * b);
    }
}

/// In the linear model the play opens in proportion to the distance of the centres, and the motion to either flank is exact.
#[test]
fn the_linear_play_opens_by_the_first_order() {
    let (x, y, b) = (0.4e-3, 0.1e-3, 100e-6);
    let (across, opening) = (y * ALPHA.cos(), x * ALPHA.sin());
    for (v, way) in [(1.0, 0.5 * b + across + opening), (-1.0, 0.5 * b - across + opening)] {
        let scene = floating(&["backlash"], Floating { x, y, b, v }, &[]);
        let outcome = run(&scene);
        let t = &outcome.trajectory;
        let met = t.moment.iter().position(|m| *m == Moment::Before).expect("the flanks meet");
        let (found, play) = (t.q[1][met].abs(), t.outputs[0].1[0]);
        assert!((found - way).abs() < 1e-15 && (play - opening).abs() < 1e-18, "{found} {way} {play} {opening}");
    }
}

/// If the centres are so close that no play is left, the flank that is pressed deeper bears the load. Then V = k (|s| + w)²/2, where w is the
/// depth of both flanks at s = 0. The time between two passages of s = 0 is 2/omega atan(v/(omega w)), twice the time in which the speed v falls to
/// zero.
#[test]
fn closed_play_keeps_the_energy() {
    let (x, b, v) = (-0.4e-3, 100e-6, 0.5);
    let heavy = ["parameters.m1=1e13 kg", "parameters.m2=1e13 kg"];
    let scene = floating(&["backlash"], Floating { x, y: 0.0, b, v }, &heavy);
    let outcome = run(&scene);
    let t = &outcome.trajectory;
    let value = |name: &str| scene.parameter(name).unwrap();
    let mobility = R1 * R1 / value("I1") + R2 * R2 / value("I2");
    let w = -0.5 * b - x * ALPHA.sin();
    assert!(w > 0.0 && t.outputs[0].1[0] < -0.5 * b);
    let omega = (scene.laws[0].mid() * mobility).sqrt();
    let between = 2.0 / omega * (v / (omega * w)).atan();
    let passed: Vec<f64> = t.moment.iter().zip(&t.t).filter(|(m, _)| **m == Moment::Before).map(|(_, t)| *t).collect();
    println!("w = {w:e} m, passages at {passed:?}, every {between:e} s");
    assert!(passed.len() > 2, "{passed:?}");
    for (i, time) in passed.iter().enumerate() {
        let expected = between * (i + 1) as f64;
        assert!((time - expected).abs() < 1e-9 * between, "{time} is not {expected}");
    }
    let worst = t.residual.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(worst < 1e-12 * t.kinetic[0], "{worst:e} J");
}

/// A mirror on the line of centres exchanges the flanks. In it all rotations and y have the opposite sign, and x has the same sign. So the
/// coast flanks push the centres apart, as the drive flanks do.
#[test]
fn a_mirror_exchanges_the_flanks() {
    let law = |first: (&str, f64), second: &str, mirrored: bool| match (first, mirrored) {
        ((value, width), false) => format!("{{steps=[{{value={value},width=\"{width} rad\"}},{{value={second}}}]}}"),
        ((value, width), true) => {
            format!("{{steps=[{{value={second},width=\"{} rad\"}},{{value={value}}}]}}", TAU - width)
        }
    };
    for more in [&[][..], &["sliding_friction"], &["moving_centres"]] {
        let effects: Vec<&str> =
            ["backlash", "stiffness_step", "torques", "damping"].iter().chain(more).copied().collect();
        let [drives, coasts] = [false, true].map(|mirrored| {
            let sign = if mirrored { -1.0 } else { 1.0 };
            let side = if mirrored { ("1", "-1") } else { ("-1", "1") };
            let set = [
                "parameters.b12=60 um".to_string(),
                "parameters.kb1=5 MN/m".into(),
                "parameters.kb2=8 MN/m".into(),
                "parameters.beta_K=2 us".into(),
                "parameters.mu12=0.1".into(),
                format!("parameters.T_motor={} N*m", 24.0 * sign),
                format!("parameters.T_load={} N*m", 96.0 * sign),
                format!("start.speed={} rpm", 1500.0 * sign),
                format!("start.s={} um", -60.0 * sign),
                "run.t_end=4 ms".into(),
                "run.tolerance=1e-12".into(),
                format!("laws.k12={}", law(("\"156 MN/m\"", 2.0), "\"80.3 MN/m\"", mirrored)),
                format!("laws.side12={}", law((side.0, 3.0), side.1, mirrored)),
                format!("laws.arm12={}", law(("\"2 mm\"", 3.0), "\"3 mm\"", mirrored)),
            ];
            let used = |line: &&String| {
                more.contains(&"sliding_friction")
                    || !line.contains("mu12") && !line.contains("laws.side") && !line.contains("laws.arm")
            };
            run(&scene(&effects, &set.iter().filter(used).map(String::as_str).collect::<Vec<_>>()))
        });
        let (a, b) = (&drives.trajectory, &coasts.trajectory);
        assert!(drives.counts.impacts > 1 && drives.counts.cell_changes > 4, "{:?}", drives.counts);
        assert_eq!((a.len(), drives.counts.impacts), (b.len(), coasts.counts.impacts), "{more:?}");
        for (i, sign) in [-1.0, -1.0, 1.0, -1.0, 1.0, -1.0].into_iter().enumerate() {
            let size = a.q[i].iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let apart = a.q[i].iter().zip(&b.q[i]).map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max);
            println!("{more:?}, coordinate {i}: {apart:.1e} of {size:.1e}");
            assert!(apart < 1e-8 * size, "{more:?}, coordinate {i}: {apart:e} of {size:e}");
        }
    }
}

/// With steps of the stiffness, play that is crossed, damping and torques the account closes, and two methods agree.
#[test]
fn the_energy_account_closes_and_methods_agree() {
    let ends = ["dop853", "radau"].map(|method| {
        let scene = scene(
            &["moving_centres", "backlash", "stiffness_step", "damping", "torques"],
            &[
                "parameters.b12=60 um",
                "parameters.kb1=5 MN/m",
                "parameters.kb2=8 MN/m",
                "parameters.T_motor=24 N*m",
                "parameters.T_load=96 N*m",
                "parameters.beta_K=2 us",
                "start.speed=1500 rpm",
                "start.s=-60 um",
                "run.t_end=12 ms",
                "run.tolerance=1e-11",
                &format!("run.method={method}"),
            ],
        );
        let outcome = run(&scene);
        let t = &outcome.trajectory;
        let worst = t.residual.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let size = t.strain.iter().fold(0.0f64, |m, x| m.max(*x));
        println!("{method}: {:?}, {worst:e} J of {size} J of strain unaccounted for", outcome.counts);
        assert!(outcome.counts.impacts > 2 && outcome.counts.cell_changes > 10, "{:?}", outcome.counts);
        assert!(worst < 1e-6 * size, "{worst:e} J of {size} J");
        let last = t.len() - 1;
        [1, 2, 3, 4, 5].map(|i| t.q[i][last])
    });
    let size = ends[0].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    for (a, b) in ends[0].iter().zip(ends[1]) {
        assert!((a - b).abs() < 1e-5 * size, "{ends:?}");
    }
}

/// The exact method refuses the effect by name; without a method the scene runs by steps.
#[test]
fn the_exact_method_refuses_moving_centres_by_name() {
    let scene = scene(&["moving_centres", "stiffness_step", "torques"], &["run.method=exact"]);
    let refusal = common::model("gear_pair_bearings").run(&scene, &mut |_| {}).expect_err("not linear").to_string();
    assert!(refusal.contains("over12 bends") && refusal.contains("run.method"), "{refusal}");
    let mut free = scene.clone();
    (free.solver.method, free.t_end) = (None, 1e-3);
    assert!(run(&free).solver.why.contains("over12 bends"));
    assert!(matches!(free.model.coordinates[1].start, Start::Static));
}
