//! Row 20: end stops, against closed forms.

use std::f64::consts::PI;

use gearsim::run::Outcome;

use crate::case::{Case, largest};
use crate::common;

pub const CASES: &[Case] = &[
    Case {
        row: "20",
        name: "a free rotor bounces between two elastic stops",
        proves: "flights and half periods pi sqrt(I/ks) on the stops, at every sample of ten periods, in plain and compensated precision",
        tolerance: 1e-12,
        unit: "of the way between the stops",
        reason: "rounding errors of forty changes of the mode",
        measure: |_| largest([EXACT, COMPENSATED].map(bounces)),
    },
    Case {
        row: "20",
        name: "a free rotor bounces between two elastic stops, by methods by steps",
        proves: "the same by dop853 and radau",
        tolerance: 1e-9,
        unit: "of the way between the stops",
        reason: "a relative tolerance of 1e-12 of a step, over the steps of ten periods",
        measure: |_| largest([DOP853, RADAU].map(bounces)),
    },
    Case {
        row: "20",
        name: "an impact on a stop with a damper that is clipped at both ends",
        proves: "the instants at which the damper is clipped, the speed and place after the impact and the energy lost, in closed form",
        tolerance: 1e-12,
        unit: "of the motion",
        reason: "rounding errors",
        measure: |_| largest([EXACT, COMPENSATED].map(impact)),
    },
    Case {
        row: "20",
        name: "a spring with one stop at its middle (Shaw & Holmes 1983)",
        proves: "the period pi/w1 + pi/w2 of half a cycle on each side, and rest at a stop under load",
        tolerance: 1e-12,
        unit: "of the start",
        reason: "rounding errors of ten changes of the mode",
        measure: |_| largest([EXACT, COMPENSATED].map(one_sided)),
    },
];

type Method = &'static [&'static str];
const EXACT: Method = &[];
const COMPENSATED: Method = &["run.precision=compensated"];
const DOP853: Method = &["run.method=dop853", "run.tolerance=1e-12"];
const RADAU: Method = &["run.method=radau", "run.tolerance=1e-12"];

/// A run of a rotor with I = 1 kg m^2 without dry friction.
fn run(method: Method, effects: &str, others: &[(&str, f64, &str)]) -> Outcome {
    let others = others.iter().map(|(key, value, unit)| format!("{key}={value:?} {unit}"));
    let own = [format!("effects={effects}"), "output.rate=1 kHz".into()];
    let all: Vec<String> = method.iter().map(|s| s.to_string()).chain(own).chain(others).collect();
    common::run(&common::scene("friction_oscillator", &all))
}

/// Upwards from the middle, with the speed v.
fn bounces(method: Method) -> f64 {
    let (v, hi, lo, w) = (2.0, 0.1, -0.05, 30.0f64);
    let (way, half) = (hi - lo, PI / w);
    let period = 2.0 * (way / v + half);
    let outcome = run(
        method,
        r#"["end_stop"]"#,
        &[
            ("parameters.k", 0.0, "N*m/rad"),
            ("parameters.ks", w * w, "N*m/rad"),
            ("parameters.hi", hi, "rad"),
            ("parameters.lo", lo, "rad"),
            ("start.phi", 0.0, "rad"),
            ("start.speed", v, "rad/s"),
            ("run.t_end", 10.0 * period, "s"),
        ],
    );
    let place = |t: f64| {
        let mut s = t % period;
        for (from, to, stop) in [(0.0, hi, hi), (hi, lo, lo)] {
            let side = (to - from).signum();
            let flight = (to - from).abs() / v;
            if s <= flight {
                return from + side * v * s;
            }
            s -= flight;
            if s <= half {
                return stop + side * v / w * (w * s).sin();
            }
            s -= half;
        }
        lo + v * s
    };
    let t = &outcome.trajectory;
    let met = if outcome.counts.impacts == 20 { 0.0 } else { f64::NAN };
    largest(t.t.iter().zip(&t.q[0]).map(|(t, q)| (q - place(*t)).abs() / way).chain([met]))
}

/// The contact with the stop has three parts. First the damper is clipped, so that the force is twice that of the spring. Then the damper
/// is not clipped. Last the force is zero until the stop is left.
fn impact(method: Method) -> f64 {
    let (v, hi, k, c, t_end) = (2.0f64, 0.1, 900.0f64, 12.0, 0.5);
    let clipped = (2.0 * k).sqrt();
    let t1 = (clipped * c / k).atan() / clipped;
    let (x1, v1) = (v / clipped * (clipped * t1).sin(), v * (clipped * t1).cos());
    let (decay, w) = (c / 2.0, (k - c * c / 4.0).sqrt());
    let (a, b) = (x1, (v1 + decay * x1) / w);
    // The force is exp(-decay s) (p cos(w s) + q sin(w s)).
    let (p, q) = (k * a + c * (w * b - decay * a), k * b - c * (decay * b + w * a));
    let t2 = p.atan2(-q) / w;
    let fallen = (-decay * t2).exp();
    let x2 = fallen * (a * (w * t2).cos() + b * (w * t2).sin());
    let v2 = fallen * ((w * b - decay * a) * (w * t2).cos() - (w * a + decay * b) * (w * t2).sin());
    let end = hi + x2 + v2 * (t_end - hi / v - t1 - t2);
    let outcome = run(
        method,
        r#"["end_stop"]"#,
        &[
            ("parameters.k", 0.0, "N*m/rad"),
            ("parameters.ks", k, "N*m/rad"),
            ("parameters.cs", c, "N*m*s/rad"),
            ("parameters.hi", hi, "rad"),
            ("parameters.lo", -5.0, "rad"),
            ("start.phi", 0.0, "rad"),
            ("start.speed", v, "rad/s"),
            ("run.t_end", t_end, "s"),
        ],
    );
    let t = &outcome.trajectory;
    let last = |column: &[f64]| *column.last().expect("a row");
    let lost = (v * v - v2 * v2) / 2.0;
    largest([
        (last(&t.q[0]) - end).abs() / end.abs(),
        (last(&t.q_dot[0]) - v2).abs() / v,
        (last(&t.dissipated) - lost).abs() / lost,
    ])
}

fn one_sided(method: Method) -> f64 {
    let (start, k, ks) = (-0.1, 400.0f64, 1200.0);
    let period = PI / k.sqrt() + PI / (k + ks).sqrt();
    let stops = [
        ("parameters.k", k, "N*m/rad"),
        ("parameters.ks", ks, "N*m/rad"),
        ("parameters.hi", 0.0, "rad"),
        ("parameters.lo", -1.0, "rad"),
    ];
    let free = [("start.phi", start, "rad"), ("run.t_end", 5.0 * period, "s")];
    let swings = run(method, r#"["end_stop"]"#, &[&stops[..], &free].concat());
    let t = &swings.trajectory;
    let back = [(t.q[0][t.len() - 1] - start).abs(), t.q_dot[0][t.len() - 1].abs() / k.sqrt()];
    // Pressed against the stop: (k + ks) phi = T.
    let load = [("parameters.T_motor", 32.0, "N*m"), ("start.phi", 0.02, "rad"), ("run.t_end", 0.1, "s")];
    let rests = run(method, r#"["end_stop", "torques"]"#, &[&stops[..], &load].concat());
    let off = rests.trajectory.q[0].iter().map(|q| (q - 0.02).abs());
    largest(off.chain(back)) / start.abs()
}
