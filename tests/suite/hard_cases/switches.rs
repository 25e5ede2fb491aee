//! Row 20: dry friction with sticking, and an overrunning clutch, against closed forms.

use std::f64::consts::PI;

use gearsim::run::Outcome;

use crate::case::{Case, WRONG, count, largest};
use crate::common;
use crate::noise::Noise;

pub const CASES: &[Case] = &[
    Case {
        row: "20",
        name: "free vibration with dry friction ends at rest (Den Hartog 1931)",
        proves: "each turning point, the place where it sticks and the energy lost, in closed form; at rest from then on",
        tolerance: 1e-14,
        unit: "of the start",
        reason: "rounding errors of thirteen half cycles",
        measure: |note| decay(note, EXACT),
    },
    Case {
        row: "20",
        name: "free vibration with dry friction, by methods by steps",
        proves: "the same closed forms by dop853 and radau",
        tolerance: 1e-10,
        unit: "of the start",
        reason: "a relative tolerance of 1e-12 of a step, over the steps of the run",
        measure: |note| largest([DOP853, RADAU].map(|method| decay(note, method))),
    },
    Case {
        row: "20",
        name: "a torque that rises breaks a rotor loose",
        proves: "the instant of release, T = (1 + rise) Tc, and the cubic motion after it",
        tolerance: 1e-8,
        unit: "of the motion",
        reason: "the release is late by 1e-9 of the forces, and the motion grows with the cube of the time since then",
        measure: |_| breakaway(EXACT),
    },
    Case {
        row: "20",
        name: "stick-slip under a harmonic torque: exact cells and steps",
        proves: "the same sticks and the same motion in 60 random scenes",
        tolerance: 1e-8,
        unit: "of the motion",
        reason: "the tolerance of the steps, 1e-12, and the late release, 1e-9",
        measure: stick_slip,
    },
    Case {
        row: "20",
        name: "an overrunning clutch drives, is overtaken and locks again",
        proves: "the speeds of both rotors in closed form, through every mode of the clutch",
        tolerance: 1e-13,
        unit: "of the largest speed",
        reason: "rounding errors of four pieces, sampled 1,600 times",
        measure: |_| clutch(EXACT),
    },
    Case {
        row: "20",
        name: "an overrunning clutch, by methods by steps",
        proves: "the same by dop853 and radau",
        tolerance: 1e-11,
        unit: "of the largest speed",
        reason: "a relative tolerance of 1e-12 of a step",
        measure: |_| largest([DOP853, RADAU].map(clutch)),
    },
    Case {
        row: "20",
        name: "an overloaded clutch slips",
        proves: "capacity and slip in closed form, and the energy that the slip takes",
        tolerance: 1e-14,
        unit: "of the largest speed",
        reason: "rounding errors",
        measure: |_| overload(),
    },
    Case {
        row: "20",
        name: "two frictions in a row: locked clutch and stuck rotor",
        proves: "at rest while the torque is below the breakaway torque, both moving above it, whatever the order",
        tolerance: 0.0,
        unit: WRONG,
        reason: "a decision is right or wrong",
        measure: |_| both(),
    },
    Case {
        row: "20",
        name: "a train that friction and clutch hold wholly, by exact cells, dop853 and radau",
        proves: "no rounding error moves it in 40 random scenes, and its energy stays zero",
        tolerance: 0.0,
        unit: WRONG,
        reason: "no motion is left that a force could cause",
        measure: |_| held(),
    },
    Case {
        row: "20",
        name: "dry friction and clutch: the energy account closes",
        proves: "T + V - W plus what was lost is constant in 60 random scenes",
        tolerance: 1e-12,
        unit: "of the energy",
        reason: "rounding errors of the sums of energy over some 4,000 windows of the power series",
        measure: accounts,
    },
];

type Method = &'static [&'static str];
const EXACT: Method = &[];
const DOP853: Method = &["run.method=dop853", "run.tolerance=1e-12"];
const RADAU: Method = &["run.method=radau", "run.tolerance=1e-12"];

fn run(scene: &str, method: Method, others: &[String]) -> Outcome {
    let all: Vec<String> = method.iter().map(|s| s.to_string()).chain(others.iter().cloned()).collect();
    common::run(&common::scene(scene, &all))
}

fn end(outcome: &Outcome) -> (Vec<f64>, Vec<f64>) {
    let last = |columns: &[Vec<f64>]| columns.iter().map(|c| *c.last().expect("a row")).collect();
    (last(&outcome.trajectory.q), last(&outcome.trajectory.q_dot))
}

/// phi_n = (-1)^n (phi_0 - 2 n a) with a = Tc/k at the time n pi/w, until k |phi_n| <= (1 + rise) Tc.
fn decay(note: &mut String, method: Method) -> f64 {
    let (k, inertia, coulomb, rise, start) = (400.0f64, 1.0, 4.0, 0.2, 0.105 * 2.7);
    let a = coulomb / k;
    let half = PI / (k / inertia).sqrt();
    let mut worst = 0.0f64;
    let mut n = 0;
    let turning = |n: i32| (-1f64).powi(n) * (start - 2.0 * f64::from(n) * a);
    while k * turning(n).abs() > (1.0 + rise) * coulomb {
        n += 1;
    }
    for (half_cycles, rests) in (0..=n + 2).map(|i| (i, i >= n)) {
        let t_end = f64::from(half_cycles.max(1)) * half * (1.0 + if rests { 0.01 } else { 0.0 });
        let outcome =
            run("friction_oscillator", method, &[format!("start.phi={start:?} rad"), format!("run.t_end={t_end:?} s")]);
        let (q, v) = end(&outcome);
        let reached = half_cycles.max(1).min(n);
        worst = largest([worst, (q[0] - turning(reached)).abs() / start, residual(&outcome) / (k * start * start)]);
        if rests {
            worst = largest([worst, v[0].abs(), if outcome.counts.sticks == 1 { 0.0 } else { f64::INFINITY }]);
        }
    }
    *note = format!("{n} half cycles");
    worst
}

/// A torque r t breaks the rotor loose at r t = (1 + rise) Tc. With s the time since then, I theta'' = rise Tc + r s.
fn breakaway(method: Method) -> f64 {
    let (inertia, coulomb, rise, slope, t_end) = (0.4, 1.5, 0.3, 10.0, 0.6);
    let outcome = run(
        "freewheel",
        method,
        &[
            r#"effects=["dry_friction", "torques"]"#.into(),
            "parameters.T_motor=0 N*m".into(),
            r#"parameters.T_load={ ramp = { to = "-20 N*m", duration = "2 s" } }"#.into(),
            format!("run.t_end={t_end} s"),
        ],
    );
    let (q, v) = end(&outcome);
    let s = t_end - (1.0 + rise) * coulomb / slope;
    let speed = (rise * coulomb * s + slope * s * s / 2.0) / inertia;
    let angle = (rise * coulomb * s * s / 2.0 + slope * s * s * s / 6.0) / inertia;
    let moved_before =
        outcome.trajectory.t.iter().zip(&outcome.trajectory.q[1]).any(|(t, q)| *t < 0.19499 && *q != 0.0);
    largest([(q[1] - angle).abs() / angle, (v[1] - speed).abs() / speed, if moved_before { f64::NAN } else { 0.0 }])
}

fn stick_slip(note: &mut String) -> f64 {
    let mut noise = Noise::new(2001);
    let mut sticks = 0;
    let worst = (0..60).map(|_| {
        let others = [
            format!("parameters.rise={:?}", between(&mut noise, 0.0, 0.5)),
            format!(
                r#"parameters.T_motor={{ harmonics = [{{ amplitude = "{:?} N*m", frequency = "{:?} Hz" }}] }}"#,
                between(&mut noise, 4.0, 20.0),
                between(&mut noise, 0.5, 8.0)
            ),
            r#"effects=["dry_friction", "torques"]"#.into(),
        ];
        let [exact, steps] = [EXACT, DOP853].map(|method| run("friction_oscillator", method, &others));
        sticks += exact.counts.sticks;
        if exact.counts.sticks != steps.counts.sticks {
            return f64::INFINITY;
        }
        let size = largest(exact.trajectory.q[0].iter().map(|x| x.abs()));
        let apart = end(&exact).0[0] - end(&steps).0[0];
        apart.abs() / size
    });
    let worst = largest(worst.collect::<Vec<_>>());
    *note = format!("60 scenes, {sticks} sticks");
    worst
}

/// Driven, overtaken and driven again: w1 and w2 are piecewise linear.
fn clutch(method: Method) -> f64 {
    let (i1, i2, drag) = (0.05, 0.4, 0.05);
    let outcome = run("freewheel", method, &[
        r#"effects=["overrunning_clutch", "torques"]"#.into(),
        r#"parameters.T_motor={ steps = [{ value = "12 N*m", until = "2 s" }, { value = "-3 N*m", until = "4 s" }, { value = "12 N*m" }] }"#
            .into(),
        "run.t_end=8 s".into(),
    ]);
    let together = 12.0 / (i1 + i2);
    let (first, second) = (2.0 * together, 2.0 * together);
    let (w1, w2) = (first + 2.0 * (-3.0 + drag) / i1, second - 2.0 * drag / i2);
    let s = (w2 - w1) / ((12.0 + drag) / i1 + drag / i2);
    let locked = w2 - s * drag / i2;
    let last = locked + (4.0 - s) * together;
    let (_, v) = end(&outcome);
    let counted = if outcome.counts.sticks == 1 { 0.0 } else { f64::INFINITY };
    largest([
        (v[0] - last).abs() / last,
        (v[1] - last).abs() / last,
        residual(&outcome) / outcome.trajectory.largest_energy(),
        counted,
    ])
}

/// Under 60 N m the clutch slips at its capacity of 40 N m. When the motor is off, both rotors come to the same speed.
fn overload() -> f64 {
    let outcome = run(
        "freewheel",
        EXACT,
        &[
            r#"effects=["overrunning_clutch", "torques"]"#.into(),
            r#"parameters.T_motor={ steps = [{ value = "60 N*m", until = "1 s" }, { value = "0 N*m" }] }"#.into(),
            "run.t_end=2 s".into(),
        ],
    );
    let (_, v) = end(&outcome);
    let last = 100.0 + 100.0 / 3.0;
    let lost = outcome.trajectory.dissipated.last().expect("a row");
    let counted = if outcome.counts.sticks == 1 { 0.0 } else { f64::INFINITY };
    largest([(v[0] - last).abs() / last, (v[1] - last).abs() / last, (lost - 8000.0).abs() / 8000.0, counted])
}

/// Torques of motor and load [N m], and the accelerations of motor and rotor [rad/s²] that follow.
const AT_REST: [(f64, f64, [f64; 2]); 7] = [
    (1.9, 0.0, [0.0, 0.0]),
    (2.0, 0.0, [0.5 / 0.45, 0.5 / 0.45]),
    (-0.04, 0.0, [0.0, 0.0]),
    (-0.06, 0.0, [-0.01 / 0.05, 0.0]),
    (0.0, 1.0, [0.0, 0.0]),
    (0.0, 3.0, [-1.5 / 0.45, -1.5 / 0.45]),
    (1.0, 3.0, [-0.5 / 0.45, -0.5 / 0.45]),
];

fn both() -> f64 {
    count(AT_REST.map(|(motor, load, [a1, a2]): (f64, f64, [f64; 2])| {
        let outcome = run(
            "freewheel",
            EXACT,
            &[
                r#"effects=["overrunning_clutch", "dry_friction", "torques"]"#.into(),
                format!("parameters.T_motor={motor:?} N*m"),
                format!("parameters.T_load={load:?} N*m"),
                "run.t_end=1 s".into(),
            ],
        );
        let (_, v) = end(&outcome);
        // The balance of torques at rest, with the tolerance 1e-9 of a release, decides what moves. The run lasts 1 s, so that the speeds
        // at its end are the accelerations.
        [(v[0], a1), (v[1], a2)].iter().any(|(v, a)| (v - a).abs() > 1e-12 * a.abs())
    }))
}

/// The torques are below the breakaway torque.
fn held() -> f64 {
    let mut noise = Noise::new(2187);
    let scenes = [(); 40].map(|()| {
        [
            r#"effects=["overrunning_clutch", "dry_friction", "torques"]"#.to_string(),
            format!("parameters.I1={:?} kg*m^2", noise.power(-4.0, 1.0)),
            format!("parameters.I2={:?} kg*m^2", noise.power(-4.0, 1.0)),
            format!("parameters.T_motor={:?} N*m", between(&mut noise, 0.0, 1.0)),
            format!("parameters.T_load={:?} N*m", between(&mut noise, -0.07, 0.07)),
            "start.theta1=0.3 rad".into(),
            "start.theta2=0.1 rad".into(),
            "run.t_end=1 ms".into(),
        ]
    });
    count([EXACT, DOP853, RADAU].iter().flat_map(|method| scenes.iter().map(|set| run("freewheel", method, set))).map(
        |outcome| {
            let (q, v) = end(&outcome);
            q != [0.3, 0.1] || v != [0.0, 0.0] || residual(&outcome) != 0.0
        },
    ))
}

fn accounts(note: &mut String) -> f64 {
    let mut noise = Noise::new(2002);
    let mut sticks = 0;
    let worst: Vec<f64> = (0..60)
        .map(|_| {
            let outcome = run("freewheel", EXACT, &[
                format!(
                    r#"parameters.T_motor={{ mean = "{:?} N*m", harmonics = [{{ amplitude = "{:?} N*m", frequency = "{:?} Hz" }}] }}"#,
                    between(&mut noise, 0.0, 3.0),
                    between(&mut noise, 2.0, 30.0),
                    between(&mut noise, 0.2, 5.0)
                ),
                format!("parameters.T_load={:?} N*m", between(&mut noise, -1.0, 1.0)),
                "run.t_end=10 s".into(),
            ]);
            sticks += outcome.counts.sticks;
            residual(&outcome) / outcome.trajectory.largest_energy()
        })
        .collect();
    *note = format!("60 scenes, {sticks} sticks");
    largest(worst)
}

/// The largest residual of the energy account [J].
fn residual(outcome: &Outcome) -> f64 {
    largest(outcome.trajectory.residual.iter().map(|r| r.abs()))
}

fn between(noise: &mut Noise, low: f64, high: f64) -> f64 {
    low + (high - low) * noise.unit()
}
