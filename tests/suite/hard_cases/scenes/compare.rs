//! Compares one gear pair in the engine and in 50 digits: the same events, and times and an end as accurate as the conditioning allows.
//!
//! A tooth pressed against a step bounces ever faster until the engine holds it. The reference never holds it, so the comparison ends
//! before.
//!
//! The conditioning is measured in the reference by disturbances of 1e-10 in the start and in the stiffnesses. The unit of an error is
//! what a disturbance of eps would have grown to, plus eps of the number itself, per event. Events are compared as long as the
//! disturbances stay below 1e-6 of an oscillation.

use gearsim_tests::oh2005::{self, GearPair, Kind, PITCH, State};
use gearsim_tests::precise::scene::{Event, Run, scene};

use crate::case::largest;
use crate::pair;

/// Relative size of the disturbances.
const DISTURBANCE: f64 = 1e-10;
/// The part of an oscillation up to which disturbances may grow.
const CALM: f64 = 1e-6;

/// Bounces shorter than this part of an oscillation are those of a pressed tooth that is about to be held.
const PRESSED: f64 = 1e-5;
/// Bounces shorter than `FAST` of an oscillation are fast. After `MOST` of them the comparison ends, because the reference is slow.
const FAST: f64 = 1e-2;
const MOST: usize = 80;

/// The result of a comparison.
#[derive(Debug, Default)]
pub struct Compared {
    /// Number of events compared, and of the reflections among them.
    pub events: u64,
    pub reflections: u64,
    /// Largest error of an event time or of the end, in its unit.
    pub error: f64,
    /// Whether all events and the end were compared. If not, disturbances grew too much.
    pub whole: bool,
    /// The first event that differs.
    pub wrong: Option<String>,
}

/// Runs a gear pair in the engine and in 50 digits.
pub fn compare(pair: &GearPair, start: &State, t_end: f64) -> Compared {
    let w0 = pair.w0();
    let t_end = until_pressed(&pair::run(pair, start, t_end).events, w0).unwrap_or(t_end);
    let exact = scene(pair, start, t_end, 50);
    let disturbed = [1.0, -1.0].map(|sign| disturb(pair, start, t_end, sign));
    let found = pair::run(pair, start, t_end);
    let (mut compared, mut growth) = (Compared::default(), 0f64);
    for (i, event) in exact.events.iter().enumerate() {
        let moved = disturbed.iter().map(|run| match run.events.get(i) {
            Some(other) if same(event, other) => (other.t.0 - event.t.0).abs(),
            _ => f64::INFINITY,
        });
        growth = growth.max(largest(moved));
        if growth * w0 > CALM {
            return compared;
        }
        let Some(other) = found.events.get(i) else {
            return wrong(compared, i, event, format!("no event, {:?}", found.outcome.stopped_by));
        };
        if (event.kind, event.cell_from, event.cell_to) != (other.kind, other.cell_from, other.cell_to) {
            return wrong(compared, i, event, format!("{other:?}"));
        }
        let late = ((other.t - event.t.0) - event.t.1).abs();
        let unit = f64::EPSILON * (growth / DISTURBANCE + event.t.0) * (1 + i) as f64;
        compared.error = largest([compared.error, late / unit]);
        compared.events += 1;
        compared.reflections += u64::from(event.kind == Kind::Reflect);
    }
    let n = exact.events.len();
    if disturbed.iter().any(|run| run.events.len() != n) {
        return compared;
    }
    if let Some(more) = found.events.get(n) {
        compared.wrong = Some(format!("event {n}: {more:?}, but there is none in 50 digits"));
        return compared;
    }
    compared.whole = true;
    compared.error = largest([compared.error, end(&exact, &disturbed, &found.end, start, w0)]);
    compared
}

/// The time half-way between two events just before a tooth is pressed or has bounced fast for long; `None` if neither happens.
pub fn until_pressed(events: &[oh2005::Event], w0: f64) -> Option<f64> {
    let mut fast = 0;
    let pressed = events.windows(2).position(|pair| {
        let apart = (pair[1].t - pair[0].t) * w0;
        fast += usize::from(apart < FAST);
        apart < PRESSED || fast > MOST
    })?;
    let before = if pressed > 0 { events[pressed - 1].t } else { 0.0 };
    Some(0.5 * (before + events[pressed].t))
}

fn wrong(compared: Compared, i: usize, event: &Event, found: String) -> Compared {
    Compared { wrong: Some(format!("event {i}: {found}, but in 50 digits {event:?}")), ..compared }
}

fn same(a: &Event, b: &Event) -> bool {
    (a.kind, a.cell_from, a.cell_to) == (b.kind, b.cell_from, b.cell_to)
}

fn disturb(pair: &GearPair, start: &State, t_end: f64, sign: f64) -> Run {
    let by = |x: f64, sign: f64| x * (1.0 + sign * DISTURBANCE);
    let softer = GearPair { k1: by(pair.k1, 1.0), k2: by(pair.k2, -sign), ..*pair };
    let phi_dot = start.phi_dot + sign * DISTURBANCE * start.phi * pair.w0();
    // Angles have the rounding error of a pitch.
    let theta = start.theta + sign * DISTURBANCE * PITCH;
    let other = State { theta, theta_dot: by(start.theta_dot, sign), phi: by(start.phi, 1.0), phi_dot };
    scene(&softer, &other, t_end, 50)
}

/// The error of the end state in its unit.
fn end(exact: &Run, disturbed: &[Run], found: &State, start: &State, w0: f64) -> f64 {
    let parts = |run: &Run| [run.end.theta, run.end.theta_dot, run.end.phi, run.end.phi_dot];
    let found = [found.theta, found.theta_dot, found.phi, found.phi_dot];
    // Speeds pass through zero and die away, so their errors are relative to the largest speed.
    let speeds = [exact.end.theta_dot.0, exact.end.phi_dot.0, start.theta_dot, start.phi_dot];
    let speed = largest(speeds.map(f64::abs));
    let phi = exact.end.phi.0.abs().max(start.phi.abs()).max(speed / w0);
    let sizes = [exact.end.theta.0.abs().max(phi), speed, phi, speed];
    largest((0..4).map(|i| {
        let want = parts(exact)[i];
        let grown =
            largest(disturbed.iter().map(|run| ((parts(run)[i].0 - want.0) + (parts(run)[i].1 - want.1)).abs()));
        ((found[i] - want.0) - want.1).abs()
            / (f64::EPSILON * (grown / DISTURBANCE + sizes[i]) * (1 + exact.events.len()) as f64)
    }))
}
