//! Longer runs from 600 rpm: loss of speed, stall, and chaos without damping.

use gearsim::run::Outcome;
use gearsim::trajectory::Moment;

use crate::paper::{self, Set};
use crate::spectra::ZETA;
use crate::text::{Part, fixed, number, table};

/// T0 of the table [N m].
const TORQUES: [f64; 7] = [1.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0];
/// Length of the runs [s].
pub const SPAN: f64 = 4.0;

/// A long run with the exact equations; speeds at its end are relative to the start.
pub struct Long {
    /// [N m]
    pub t0: f64,
    /// Mean speed.
    pub mean: f64,
    /// Momentary speed theta', vibration included.
    pub momentary: f64,
    /// Times of the first reflection and of the last step passed [s], if the gear is reflected.
    pub stall: Option<(f64, f64)>,
    /// Estimate of the speed: every pitch takes the energy that it takes if vibrations decay fully within each cell.
    pub estimate: f64,
}

/// Energy lost per pitch if vibrations decay fully within each cell [J]: the losses to damping after a tooth pair enters and
/// after it leaves, (k1 + k2) (T0/k1 - T0/k2)^2.
pub fn cost_of_a_pitch(t0: f64) -> f64 {
    let p = paper::pair(0.0, t0);
    (p.k1 + p.k2) * (t0 / p.k1 - t0 / p.k2).powi(2)
}

/// Runs all cases.
pub fn run() -> anyhow::Result<Vec<Long>> {
    TORQUES.into_iter().map(one).collect()
}

fn one(t0: f64) -> anyhow::Result<Long> {
    let outcome = paper::spectrum(Set::Exact, 600, ZETA, t0, SPAN)?;
    let pair = paper::pair(ZETA, t0);
    let start = pair.start(600.0).theta_dot;
    let theta_dot = &outcome.trajectory.q_dot[0];
    // A constant loss per pitch acts as a constant torque, so the speed falls linearly in time; T = inertia theta'^2/2.
    let inertia = pair.i1 / pair.n1.powi(2) + pair.i2 / pair.n2.powi(2);
    let deceleration = cost_of_a_pitch(t0) / (std::f64::consts::TAU * inertia);
    let stall = match outcome.counts.reflections {
        0 => None,
        _ => {
            let run = with_events(&[format!("parameters.T0={t0} N*m"), format!("run.t_end={SPAN} s")])?;
            first_reflection(&run).zip(steps(&run, false).last())
        }
    };
    Ok(Long {
        t0,
        mean: paper::mean_speed(&outcome) / start,
        momentary: theta_dot[theta_dot.len() - 1] / start,
        stall,
        estimate: (1.0 - deceleration * SPAN / start).max(0.0),
    })
}

/// Runs the exact scene at 600 rpm; records the events, and few samples.
fn with_events(overrides: &[String]) -> anyhow::Result<Outcome> {
    let few = "output.rate=1 kHz".to_owned();
    paper::run("spectrum_600rpm_exact", &[overrides, &[few]].concat())
}

/// Time of the first reflection [s].
fn first_reflection(outcome: &Outcome) -> Option<f64> {
    steps(outcome, true).next()
}

/// Times of the steps at which the phase was reflected, if `turned`, or else of those that it passed [s].
fn steps(outcome: &Outcome, turned: bool) -> impl Iterator<Item = f64> {
    let run = &outcome.trajectory;
    let back = |i: usize| run.q_dot[0][i] * run.q_dot[0][i - 1] < 0.0;
    (1..run.len()).filter(move |i| run.moment[*i] == Moment::After && back(*i) == turned).map(|i| run.t[i])
}

/// The table.
pub fn long_table(runs: &[Long]) -> Part {
    let head = [
        "T0 [N m]",
        "mean speed after 4 s / at the start",
        "estimate",
        "theta' itself / at the start",
        "first turned back at a step [s]",
        "last step passed [s]",
    ];
    let rows = runs.iter().map(|run| {
        let moving = |x: f64| if run.stall.is_some() { "stalled".into() } else { fixed(x, 4) };
        vec![
            run.t0.to_string(),
            moving(run.mean),
            fixed(run.estimate, 3),
            moving(run.momentary),
            run.stall.map_or("-".into(), |(first, _)| number(first, 3)),
            run.stall.map_or("-".into(), |(_, last)| number(last, 3)),
        ]
    });
    ("long", table(&head, &rows.collect::<Vec<_>>()))
}

/// The case without damping, 600 rpm and 10 N m: the divergence of two runs with nearly equal starts.
pub struct Undamped {
    /// First reflection [s].
    pub reflected: Option<f64>,
    /// Time at which two runs whose starts differ by `APART` in phi' differ by a thousandth of a pitch [s].
    pub parted: Option<f64>,
}

/// Difference of phi' at the start of the two runs [rad/s].
pub const APART: f64 = 1e-9;

/// Runs both.
pub fn undamped() -> anyhow::Result<Undamped> {
    let run = |phi_dot: f64| {
        with_events(&["parameters.zeta=0".into(), format!("start.phi_dot={phi_dot:e} rad/s"), "run.t_end=1 s".into()])
    };
    let (a, b) = (run(0.0)?, run(APART)?);
    let samples = |o: &Outcome| {
        let t = &o.trajectory;
        t.samples().map(|i| (t.t[i], t.q[0][i])).collect::<Vec<_>>()
    };
    let (x, y) = (samples(&a), samples(&b));
    let far = 1e-3 * std::f64::consts::TAU;
    let parted = x.iter().zip(&y).find(|(x, y)| (x.1 - y.1).abs() > far).map(|(x, _)| x.0);
    Ok(Undamped { reflected: first_reflection(&a), parted })
}
