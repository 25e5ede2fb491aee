//! Row 3: a phase that is pressed against a step, held there and released.

use gearsim::run::{Entry, Outcome};

use crate::case::{Case, largest};
use crate::common;
use crate::models::{self, end, pressed::Pressed, residual, shifted::Shifted};

pub const CASES: &[Case] = &[
    Case {
        row: "3",
        name: "a damped rotor pressed against a step by a net torque: its position of rest",
        proves: "the rotor is held at the step to the bit; the sprung rotor is where its spring balances its load",
        tolerance: 1e-12,
        unit: "rad, rad/s",
        reason: "the hold ignores 1e-12 of the energy, none of it of the sprung rotor",
        measure: |_| rest(&pressed()),
    },
    Case {
        row: "3",
        name: "number of bounces before the hold",
        proves: "a bounce lasts 2 v/T and loses the speed 2 c v²/(3 T): 3 T/(2 c v) bounces down to the least speed v that is followed",
        tolerance: 1e-3,
        unit: "of their number",
        reason: "the first few bounces are long and lose more than this formula says",
        measure: |note| {
            let outcome = pressed();
            *note = format!("{} bounces", outcome.counts.reflections);
            (outcome.counts.reflections as f64 * least() / (1.5 * 0.5) - 1.0).abs()
        },
    },
    Case {
        row: "3",
        name: "energy ignored by a hold",
        proves: "v²/(2 G) at the hold is in the account, and below 1e-12 of T + V",
        tolerance: 1.0,
        unit: "1e-12 of the energy",
        reason: "the stated threshold",
        measure: |_| pressed().ignored / (1e-12 * ENERGY),
    },
    Case {
        row: "3",
        name: "energy account of the bounces, the hold and the rest after it",
        proves: "T + V - W + D + the ignored energy is constant",
        tolerance: 1e-13,
        unit: "of the energy at the start",
        reason: "one rounding error of the loss per bounce, of small parts of the energy",
        measure: |_| residual(&pressed()),
    },
    Case {
        row: "3",
        name: "a hold ends when the reaction pulls",
        proves: "held until phi = T0/k1, then free: both in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "rounding errors; the release is late, at a pull of 1e-9 of the forces, and this delay counts squared",
        measure: |_| release(EXACT),
    },
    Case {
        row: "3",
        name: "a held phase passes a step that vanishes",
        proves: "dV = 0 when phi passes zero: theta passes the step without loss, in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "rounding errors of four closed forms and of the frequencies",
        measure: |_| slip(EXACT),
    },
    Case {
        row: "3",
        name: "a hold and its release by methods by steps",
        proves: "the same closed forms as with exact cells, by dop853 and radau",
        tolerance: 1e-9,
        unit: "of the motion's sizes",
        reason: "a relative tolerance of 1e-12 of a step, over the steps of the run",
        measure: |_| largest([release(DOP853), release(RADAU)]),
    },
    Case {
        row: "3",
        name: "a held phase passes a step that vanishes, by methods by steps",
        proves: "the same closed forms as with exact cells, by dop853 and radau",
        tolerance: 1e-9,
        unit: "of the motion's sizes",
        reason: "a relative tolerance of 1e-12 of a step, over the steps of the run",
        measure: |_| largest([slip(DOP853), slip(RADAU)]),
    },
    Case {
        row: "3",
        name: "a phase held at a step of one law, then of two laws, in the same cell",
        proves: "the exact method has the same holds as dop853 with a tolerance of 1e-12: the functions that end a hold are those of its place",
        tolerance: 1e-9,
        unit: "rad, rad/s, of 0.5",
        reason: "the error of dop853",
        measure: |note| shifted(note),
    },
];

/// Settings of a run, and the allowed residual of its energy account, relative to the energy.
type Method = (&'static [&'static str], f64);
const EXACT: Method = (&[], 1e-14);
const DOP853: Method = (&["run.method=dop853", "run.tolerance=1e-12"], 1e-10);
const RADAU: Method = (&["run.method=radau", "run.tolerance=1e-12"], 1e-10);

const PRESSED: Entry = Entry::new::<Pressed>();
const SHIFTED: Entry = Entry::new::<Shifted>();
/// T + V of the pressed rotor at rest: load²/(2 k) [J].
const ENERGY: f64 = 10.0;

/// Under a torque and damping the bounces become ever shorter and end in a hold that lasts.
fn pressed() -> Outcome {
    models::run(
        &PRESSED,
        r#"
        model = "pressed"
        effects = ["stiffness_step"]
        parameters = { T = "0.5 N*m", load = "10 N*m", c = "1 N*m*s" }
        laws.k.steps = [{ value = "5 N*m", width = "0.4 rad" }, { value = "50 N*m" }]
        run.t_end = "1000 s"
        "#,
    )
}

/// The least speed at which bounces are followed: v²/2 = 1e-12 of T + V.
fn least() -> f64 {
    (2e-12 * ENERGY).sqrt()
}

fn rest(outcome: &Outcome) -> f64 {
    let (q, v) = end(outcome);
    let held = (outcome.counts.holds, outcome.counts.cell_changes) == (1, 0) && q[0] == 0.4 && v[0] == 0.0;
    if held { largest([(q[1] - 2.0).abs(), v[1].abs()]) } else { f64::INFINITY }
}

/// Runs the gear pair from rest at the boundary theta = 0, below which the mesh is stiffer, with phi at `phi` times T0/k1.
fn at_rest(t0: f64, phi: f64, t_end: f64, method: &[&str]) -> Outcome {
    pair_at_rest(t0, phi * t0 / K, t_end, &[&[r#"effects=["stiffness_step", "torques"]"#], method].concat())
}

/// Runs the gear pair from rest at the boundary theta = 0 under the torque `t0` [N m], with `phi` [rad], for the time `t_end` [s].
pub fn pair_at_rest(t0: f64, phi: f64, t_end: f64, others: &[&str]) -> Outcome {
    let own = [
        format!("parameters.T0={t0:?} N*m"),
        "start.speed=0 rpm".into(),
        format!("start.phi={phi:?} rad"),
        format!("run.t_end={t_end:?} s"),
    ];
    let overrides: Vec<_> = own.into_iter().chain(others.iter().map(|other| other.to_string())).collect();
    common::run(&common::scene("oh2005/energy_300rpm", &overrides))
}

/// The angular frequency [rad/s] of phi with theta free, sqrt(M2 k), and with theta held, sqrt(2 k/(a + b)), and M1/M2.
pub fn frequencies(k: f64) -> (f64, f64, f64) {
    let (a, b) = (0.00289 / 24f64.powi(2), 0.7402 / 96f64.powi(2));
    let (m1, m2) = ((1.0 / a - 1.0 / b) / 2.0, (1.0 / a + 1.0 / b) / 2.0);
    ((m2 * k).sqrt(), (2.0 * k / (a + b)).sqrt(), m1 / m2)
}

/// The softer stiffness of the mesh [N m].
pub const K: f64 = 1430.0;
/// The static deflection phi in this mesh under 10 N m [rad].
pub const REST: f64 = 10.0 / K;

/// The motion after the release of theta: phi starts at `phi` with `speed` and swings about `rest` in a mesh of stiffness `k`, for the
/// time `after`.
pub struct Freed {
    pub phi: f64,
    pub speed: f64,
    pub k: f64,
    pub rest: f64,
    pub after: f64,
}

impl Freed {
    /// The largest error of theta, phi and their speeds at the end, in units of REST and of the speed. Infinite if the numbers of holds
    /// and cell changes differ from `events`, or if the residual of the account is more than `lack` of the energy.
    pub fn off(&self, outcome: &Outcome, events: (u64, u64), lack: f64) -> f64 {
        if (outcome.counts.holds, outcome.counts.cell_changes) != events || residual(outcome) > lack {
            return f64::INFINITY;
        }
        let Freed { phi, speed, rest, after, .. } = *self;
        let (w, _, ratio) = frequencies(self.k);
        let (s, c) = (w * after).sin_cos();
        let (x, v) = (rest + (phi - rest) * c + speed / w * s, -(phi - rest) * w * s + speed * c);
        let expected = [ratio * (x - phi - speed * after), x, ratio * (v - speed), v];
        let (q, q_dot) = end(outcome);
        let sizes = [REST, REST, speed.abs(), speed.abs()];
        let ends = q.iter().chain(&q_dot).zip(expected).zip(sizes);
        largest(ends.map(|((x, expected), size)| (x - expected).abs() / size))
    }
}

/// phi = 3 T0/k1 accelerates theta downwards, against a step up of the stiffness. theta is held until phi = T0/k1, where the reaction
/// begins to pull.
fn release((method, lack): Method) -> f64 {
    let (free, held, _) = frequencies(K);
    let after = 0.3 / free;
    let outcome = at_rest(10.0, 3.0, std::f64::consts::FRAC_PI_2 / held + after, method);
    Freed { phi: REST, speed: -2.0 * REST * held, k: K, rest: REST, after }.off(&outcome, (1, 0), lack)
}

/// phi swings from 2 |T0|/k1 through zero towards its negative rest. At zero the step vanishes and theta passes it.
fn slip((method, lack): Method) -> f64 {
    let (_, held, _) = frequencies(K);
    let (free, ..) = frequencies(2780.0);
    let after = 0.2 / free;
    let outcome = at_rest(-10.0, -2.0, (1.0f64 / 3.0).acos() / held + after, method);
    let speed = -3.0 * REST * held * (1.0f64 - 1.0 / 9.0).sqrt();
    Freed { phi: 0.0, speed, k: 2780.0, rest: -10.0 / 2780.0, after }.off(&outcome, (1, 1), lack)
}

/// The rotor creeps against the step at 0.4 rad, where the spring stiffens, and passes it when the spring has no deflection. At 1.4 rad, in the
/// same cell of both laws, the zero of the spring steps too. The step of V then has two zeros instead of one.
fn shifted(note: &mut String) -> f64 {
    let run = |method: &str| {
        models::run(
            &SHIFTED,
            &format!(
                r#"
                model = "shifted"
                effects = ["stiffness_step", "uneven"]
                parameters = {{ T = "1 N*m", c = "100 N*m*s" }}
                laws.k.steps = [{{ value = "5 N*m", width = "0.4 rad" }}, {{ value = "50 N*m" }}]
                laws.e.steps = [{{ value = "0 rad", width = "1.4 rad" }}, {{ value = "0.1 rad" }}]
                run = {{ t_end = "160 s", {method} }}
                "#
            ),
        )
    };
    let [exact, steps] = ["", "method = \"dop853\", tolerance = 1e-12"].map(run);
    *note = format!("{} holds, {} cell changes", exact.counts.holds, exact.counts.cell_changes);
    let counted = |outcome: &Outcome| (outcome.counts.holds, outcome.counts.cell_changes);
    if counted(&exact) != (2, 3) || counted(&steps) != (2, 3) {
        return f64::INFINITY;
    }
    let [(q, v), (q_steps, v_steps)] = [&exact, &steps].map(end);
    largest(q.iter().zip(&q_steps).chain(v.iter().zip(&v_steps)).map(|(a, b)| (a - b).abs() / 0.5))
}
