//! A published response curve with contact loss: the spur gear pair of Kahraman & Singh (1990), J. Sound Vib. 142(1), 49-75.
//!
//! Their equation for the deflection q of the mesh in halves of the backlash, over the time in natural periods:
//!
//! ```text
//! q'' + 2 zeta q' + f(q) = Fm + Fah W² cos(W t),    f(q) = q - 1 for q > 1, 0 between, q + 1 for q < -1
//! ```
//!
//! Their solution by harmonic balance, q = 1 + u + a cos(W t + phi), with the describing functions of Comparin & Singh (1989), J. Sound Vib.
//! 134(2), 259-290. Where the teeth part and the other flanks are not reached, with c = u/a:
//!
//! ```text
//! a (c + g(c))/2 = Fm,      g(c) = 2/pi (c asin c + sqrt(1 - c²))
//! N = (1 + h(c))/2,         h(c) = 2/pi (asin c + c sqrt(1 - c²))
//! (N - W²)² + (2 zeta W)² = (F/a)²,   F = Fah W²
//! ```
//!
//! Each c gives an amplitude and at most two frequencies, so that the curve is known in closed form. The motion jumps where the curve turns
//! back in frequency.
//!
//! In the scene the damper acts on the rotation x = q + e of the gears against each other, not on q: gearsim has no dampers on the rate of
//! an error. This adds -2 zeta e' to the right side, so that F = Fah W² sqrt(1 + (2 zeta/W)²), 0.5 % more at W = 1. The formula is evaluated
//! with it. The transmission error x has the amplitude N a/sqrt(W⁴ + (2 zeta W)²).
//!
//! A third column is the same equation integrated here by Runge and Kutta's method, through the same sequence of speeds. It separates the
//! error of the harmonic balance, which neglects all harmonics but the first, from an error of gearsim.

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

use gearsim::Scene;

const FM: f64 = 0.1;
const FAH: f64 = 0.05;
const ZETA: f64 = 0.05;
/// Speed of the gears at W = 1 \[rad/s\], and half of the backlash \[m\].
const SCALES: (f64, f64) = (600.0, 50e-6);
/// Length of each point of the scene, and of its part that is measured \[s\].
const TIMES: (f64, f64) = (0.04, 0.03);
/// An amplitude that changes by this factor from one frequency to the next has jumped.
const JUMP: f64 = 1.2;

/// A value of the curve, found in three ways.
pub struct Row {
    pub what: String,
    /// By the published formula.
    pub published: f64,
    /// By integration here.
    pub integrated: f64,
    /// By the command `response`.
    pub ours: f64,
    /// Allowed relative differences of ours from the formula and from the integration.
    pub allowed: [f64; 2],
}

/// A point of a sweep: whether it is on the way up, frequency W, amplitude of x, and whether contact is lost.
type Point = (bool, f64, f64, bool);

/// The frequencies of the sweep, closer together at the beginning and the end of contact loss, and at the jumps.
fn frequencies() -> Vec<f64> {
    let grid = |from: i32, to: i32, step: usize| (from..to).step_by(step).map(|w| f64::from(w) / 1000.0);
    let coarse = [grid(500, 690, 50), grid(720, 810, 10), grid(840, 1390, 50)];
    let fine = [grid(690, 720, 2), grid(810, 840, 1), grid(1390, 1430, 2)];
    let mut all: Vec<f64> = coarse.into_iter().chain(fine).flatten().collect();
    all.push(1.5);
    all.sort_by(f64::total_cmp);
    all
}

/// By the command `response`.
fn ours() -> Result<Vec<Point>, String> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/train_kahraman_singh.toml");
    let scene = Scene::load(path).map_err(|e| e.to_string())?;
    let scene = scene.with("output.record", &["dte_12", "mesh_force_12"][..]).map_err(|e| e.to_string())?;
    let speeds: Vec<String> = frequencies().iter().map(|w| format!("{} rad/s", SCALES.0 * w)).collect();
    let axis = format!("start.speed={}", speeds.join(","));
    let response = scene.vary(&axis).from(TIMES.1).response().map_err(|e| e.to_string())?;
    let point = |point: &gearsim::sweep::response::ResponsePoint| {
        let (dte, force) = (point.observed[0]?, point.observed[1]?);
        Some((point.upward, point.speed / SCALES.0, SQRT_2 * dte.rms / SCALES.1, force.min <= 0.0))
    };
    let all: Option<Vec<Point>> = response.points.iter().map(point).collect();
    all.ok_or_else(|| format!("a point has no result: {:?}", response.points.iter().find(|p| !p.reason.is_empty())))
}

/// The curve by the Runge-Kutta method of order 4 with 200 steps a period, over the same number of periods as the scene.
fn integrated() -> Vec<Point> {
    const STEPS: usize = 200;
    let natural = 40.0 * SCALES.0;
    let up = frequencies();
    let (mut x, mut v) = (1.0 + FM, 0.0);
    let ways = up.iter().map(|w| (true, *w)).chain(up.iter().rev().map(|w| (false, *w)));
    let mut points = vec![];
    for (upward, w) in ways {
        let periods = |t: f64| (t * natural * w / TAU).round() as usize;
        let (last, settled, h) = (periods(TIMES.0), periods(TIMES.1), TAU / w / STEPS as f64);
        let error = |t: f64| FAH * (w * t).cos();
        let touches = |q: f64| if q > 1.0 { q - 1.0 } else { (q + 1.0).min(0.0) };
        let rate = |t: f64, x: f64, v: f64| FM - 2.0 * ZETA * v - touches(x - error(t));
        let (mut sum, mut square, mut least) = (0.0, 0.0, f64::INFINITY);
        for step in 0..last * STEPS {
            let t = (step % STEPS) as f64 * h;
            let (a1, v1) = (rate(t, x, v), v);
            let (a2, v2) = (rate(t + h / 2.0, x + h / 2.0 * v1, v + h / 2.0 * a1), v + h / 2.0 * a1);
            let (a3, v3) = (rate(t + h / 2.0, x + h / 2.0 * v2, v + h / 2.0 * a2), v + h / 2.0 * a2);
            let (a4, v4) = (rate(t + h, x + h * v3, v + h * a3), v + h * a3);
            x += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
            v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            if step >= settled * STEPS {
                sum += x;
                square += x * x;
                least = f64::min(least, x - error(t + h));
            }
        }
        let n = ((last - settled) * STEPS) as f64;
        let rms = (square / n - (sum / n).powi(2)).sqrt();
        points.push((upward, w, SQRT_2 * rms, least <= 1.0));
    }
    points
}

/// Points of the harmonic balance with contact loss: frequency and amplitude of the transmission error. They follow the curve from the
/// onset at the lower frequency to that at the higher one.
fn balance() -> Vec<(f64, f64)> {
    const POINTS: i32 = 20_000;
    let root = |c: f64, sign: f64| {
        let s = (1.0 - c * c).sqrt();
        let (g, h) = (FRAC_PI_2.recip() * (c * c.asin() + s), FRAC_PI_2.recip() * (c.asin() + c * s));
        let (a, n) = (2.0 * FM / (c + g), (1.0 + h) / 2.0);
        let (p, d) = ((FAH / a).powi(2), 4.0 * ZETA * ZETA);
        // (N - w)² + d w = p (w² + d w) for w = W².
        let (square, linear) = (1.0 - p, d - 2.0 * n - p * d);
        let inside = linear * linear - 4.0 * square * n * n;
        let w = 2.0 * n * n / (-linear - sign * inside.sqrt());
        (inside >= 0.0 && w > 0.0).then(|| (w.sqrt(), n * a / (w * w + d * w).sqrt()))
    };
    let at = |i: i32| (PI * f64::from(i) / f64::from(POINTS)).cos();
    let lower = (0..POINTS).map_while(|i| root(at(i), -1.0));
    let upper: Vec<_> = (0..POINTS).map_while(|i| root(at(i), 1.0)).collect();
    lower.chain(upper.into_iter().rev()).collect()
}

/// The largest amplitude of the balance at a frequency: that of the motion on the way down.
fn largest(curve: &[(f64, f64)], w: f64) -> f64 {
    let crossing = |pair: &[(f64, f64)]| {
        let [(w0, a0), (w1, a1)] = [pair[0], pair[1]];
        ((w0 - w) * (w1 - w) <= 0.0 && w0 != w1).then(|| a0 + (a1 - a0) * (w - w0) / (w1 - w0))
    };
    curve.windows(2).filter_map(crossing).fold(0.0, f64::max)
}

/// The amplitude while contact is not lost.
fn linear(w: f64) -> f64 {
    FAH / ((1.0 - w * w).powi(2) + (2.0 * ZETA * w).powi(2)).sqrt()
}

/// The frequency at which the amplitude first jumps on the way up or down: half-way between two points.
fn jump(points: &[Point], upward: bool) -> f64 {
    let way: Vec<_> = points.iter().filter(|point| point.0 == upward).collect();
    let jumps = |pair: &&[&Point]| {
        let ratio = pair[1].2 / pair[0].2;
        if upward { ratio > JUMP } else { ratio < 1.0 / JUMP }
    };
    way.windows(2).find(jumps).map_or(f64::NAN, |pair| 0.5 * (pair[0].1 + pair[1].1))
}

/// The frequencies at which contact loss begins and ends on the way up, each half-way between two points.
fn lost(points: &[Point]) -> [f64; 2] {
    let way: Vec<_> = points.iter().filter(|point| point.0).collect();
    let changes = |pair: &[&Point]| (pair[0].3 != pair[1].3).then(|| 0.5 * (pair[0].1 + pair[1].1));
    let all: Vec<f64> = way.windows(2).filter_map(changes).collect();
    [all.first().copied().unwrap_or(f64::NAN), all.last().copied().unwrap_or(f64::NAN)]
}

fn amplitude(points: &[Point], upward: bool, w: f64) -> f64 {
    let near =
        points.iter().filter(|point| point.0 == upward).min_by(|a, b| (a.1 - w).abs().total_cmp(&(b.1 - w).abs()));
    near.map_or(f64::NAN, |point| point.2)
}

/// All rows, if the differences of each are at most the allowed ones.
///
/// # Errors
/// The first row with a larger difference, or the reason why the command `response` has no result.
pub fn rows() -> Result<Vec<Row>, String> {
    let (ours, integrated, curve) = (ours()?, integrated(), balance());
    let turn = |better: fn(f64, f64) -> bool, range: &[(f64, f64)]| {
        range.iter().map(|point| point.0).reduce(|a, b| if better(a, b) { a } else { b }).unwrap_or(f64::NAN)
    };
    // From the onset the frequency rises to the upward jump, falls to the downward one, and rises again.
    let lowest = (0..curve.len()).min_by(|&i, &j| curve[i].0.total_cmp(&curve[j].0)).unwrap_or(0);
    let (up, down) = (turn(|a, b| a > b, &curve[..lowest]), turn(|a, b| a < b, &curve));
    let onsets = [curve[0].0, curve[curve.len() - 1].0];
    let (lost_by_us, lost_here) = (lost(&ours), lost(&integrated));
    let mut rows = vec![];
    let mut row = |what: &str, published: f64, integrated: f64, ours: f64, allowed: [f64; 2]| {
        rows.push(Row { what: what.into(), published, integrated, ours, allowed });
    };
    row("contact is lost from W =", onsets[0], lost_here[0], lost_by_us[0], [2e-3, 2e-3]);
    row("jump on the way up, W =", up, jump(&integrated, true), jump(&ours, true), [1e-2, 2e-3]);
    row("jump on the way down, W =", down, jump(&integrated, false), jump(&ours, false), [5e-2, 4e-3]);
    row("contact is lost until W =", onsets[1], lost_here[1], lost_by_us[1], [2e-3, 2e-3]);
    for (upward, w) in
        [(true, 0.75), (false, 0.75), (true, 0.8), (false, 0.8), (true, 0.89), (true, 0.99), (true, 1.19)]
    {
        let published = if upward && w < onsets[0] { linear(w) } else { largest(&curve, w) };
        let what = format!("amplitude {} at W = {w}", if upward { "on the way up" } else { "on the way down" });
        let all = [&integrated, &ours].map(|points| amplitude(points, upward, w));
        row(&what, published, all[0], all[1], [8e-2, 2e-3]);
    }
    for Row { what, published, integrated, ours, allowed } in &rows {
        println!("{what} {ours:.5}; by the formula {published:.5}, integrated {integrated:.5}");
        let off = [(ours / published - 1.0).abs(), (ours / integrated - 1.0).abs()];
        if !(off[0] <= allowed[0] && off[1] <= allowed[1]) {
            return Err(format!("{what} {ours}, {off:?} from {published} and {integrated}; allowed {allowed:?}"));
        }
    }
    Ok(rows)
}
