//! Row 3: a phase between two steps that reflect it, free or damped; bounces on one step, down to very short ones.

use gearsim::run::{Entry, Outcome};
use gearsim::trajectory::Moment;
use gearsim_tests::oh2005::{GearPair, Kind, State};
use gearsim_tests::precise::{self, first_crossing};

use crate::case::{Case, largest};
use crate::linear::{Linear, first_from};
use crate::models::{self, pressed::Pressed};
use crate::pair;

pub const CASES: &[Case] = &[
    Case {
        row: "3",
        name: "trapped between two steps, 999 reflections",
        proves: "the period stays 2 width/v, the closed form",
        tolerance: 2.0,
        unit: "eps t",
        reason: "one rounding error of width/v and one of the sum of times; the speed keeps its bits",
        measure: |_| trapped(0.0),
    },
    Case {
        row: "3",
        name: "trapped and damped, 40 reflections",
        proves: "reflections at t = -log(1 - c way/v)/c, and rest after the way v/c",
        tolerance: 16.0,
        unit: "eps growth of t",
        reason: "one rounding error of speed or way per reflection, which grows as the speed falls",
        measure: |_| trapped(0.0123),
    },
    Case {
        row: "3",
        name: "return to a boundary that was left at 1e-1 to 1e-12 of the speed of the modes",
        proves: "the error of the return time is relative to that time, not to the motion of the modes",
        tolerance: 4.0,
        unit: "eps t",
        reason: "rounding errors of the acceleration, of the quotient and of t",
        measure: |_| returns(),
    },
    Case {
        row: "3",
        name: "gear pair bouncing on a step, w0 t = 1e-1 to 1e-5 per bounce",
        proves: "the same bounces as in 50 digits, at the same times",
        tolerance: 16.0,
        unit: "eps t per bounce",
        reason: "the acceleration is a difference of torques, whose rounding errors count in every bounce; infinite if an event differs",
        measure: bounces,
    },
];

const PRESSED: Entry = Entry::new::<Pressed>();

/// Times of the reflections [s].
fn reflections(outcome: &Outcome) -> Vec<f64> {
    let t = &outcome.trajectory;
    (0..t.len()).filter(|&i| t.moment[i] == Moment::Before).map(|i| t.t[i]).collect()
}

/// A rotor starts in the middle of a soft cell of 0.4 rad, at 1 rad/s, with damping `c`.
fn trapped(c: f64) -> f64 {
    let (t_end, expected) = if c == 0.0 { (0.4 * 999.0, 999) } else { (50.0 / c, (1.0f64 / c / 0.4 + 0.5) as usize) };
    let outcome = models::run(
        &PRESSED,
        &format!(
            r#"
            model = "pressed"
            effects = ["stiffness_step"]
            parameters = {{ T = "0 N*m", load = "10 N*m", c = "{c:?} N*m*s" }}
            laws.k.steps = [{{ value = "5 N*m", width = "0.4 rad" }}, {{ value = "50 N*m" }}]
            start.alpha = "0.2 rad"
            start.alpha_dot = "1 rad/s"
            run.t_end = "{t_end:?} s"
            "#
        ),
    );
    let times = reflections(&outcome);
    if times.len() != expected || outcome.counts.cell_changes > 0 {
        println!("{} reflections, not {expected}; {:?}", times.len(), outcome.counts);
        return f64::INFINITY;
    }
    largest(times.iter().enumerate().map(|(n, t)| {
        let way = 0.2 + 0.4 * n as f64;
        let (exact, growth) = if c == 0.0 { (way, 1.0) } else { (-(-c * way).ln_1p() / c, 1.0 / (1.0 - c * way)) };
        (t - exact).abs() / (f64::EPSILON * exact * growth)
    }))
}

/// s = -(1 + r) t + sin t + 1 - cos t, about t²/2 - r t: the modes have speeds of 1, s only a speed of r.
fn returns() -> f64 {
    largest((4..=40).flat_map(|k| [1.0, 1.37].map(|factor| factor * 2f64.powi(-k))).flat_map(|r| {
        let system = Linear::modal([(0.0, 0.0), (0.0, 1.0)], [0.0, 1.0]);
        let v = [-(1.0 + r), 1.0];
        let mode = |omega2, force, v| precise::Mode { sigma: 0.0, omega2, force, x: 0.0, v, weight: 1.0 };
        let root = first_crossing(&[mode(0.0, 0.0, v[0]), mode(1.0, 1.0, v[1])], 0.0, 1.0).expect("s returns to 0");
        // The motion and its mirror image.
        [1.0, -1.0].map(|sign| {
            let mirrored = Linear { normal: [sign; 2], ..system };
            let gaps = if sign > 0.0 { [10.0, 0.0] } else { [0.0, 10.0] };
            let met = first_from(&mirrored, v, gaps, 1.0);
            let error = ((met.t - root.t.0) - root.t.1).abs() / (f64::EPSILON * root.t.0);
            if met.side.is_some() { error } else { f64::INFINITY }
        })
    }))
}

/// Below theta = 0 the mesh is stiffer. phi starts at three times its static deflection and accelerates theta downwards by a = 2 M1 T0.
fn bounces(note: &mut String) -> f64 {
    let pair = GearPair::paper(0.0, 10.0);
    let pull = (pair.n1.powi(2) / pair.i1 - pair.n2.powi(2) / pair.i2) * pair.t0;
    let mut total = 0;
    let worst = largest([1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5].map(|bounce| {
        let t = bounce / pair.w0();
        let start = State { theta: 0.0, theta_dot: 0.5 * pull * t, phi: 3.0 * pair.t0 / pair.k1, phi_dot: 0.0 };
        let exact = precise::scene(&pair, &start, 7.5 * t, 50);
        let found = pair::run(&pair, &start, 7.5 * t);
        total += exact.events.len();
        if exact.events.len() != found.events.len() || exact.reflections < 6 {
            println!("{bounce:e}: {} events, {} in 50 digits", found.events.len(), exact.events.len());
            return f64::INFINITY;
        }
        largest(exact.events.iter().zip(&found.events).enumerate().map(|(i, (event, other))| {
            let late = ((other.t - event.t.0) - event.t.1).abs() / (f64::EPSILON * event.t.0 * (1 + i) as f64);
            if other.kind == Kind::Reflect { late } else { f64::INFINITY }
        }))
    }));
    *note = format!("{total} bounces");
    worst
}
