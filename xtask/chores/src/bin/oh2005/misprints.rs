//! Misprints and gaps of the paper: a row each, with evidence computed from the paper's own numbers.

use crate::energy::Balance;
use crate::long::{APART, Long, SPAN, Undamped, cost_of_a_pitch};
use crate::paper::{self, T0};
use crate::printed;
use crate::spectra::mesh;
use crate::text::{Part, number, table};

/// Results of other tables.
pub struct Known<'a> {
    /// Energy balance of Fig. 3 with the exact equations.
    pub exact: &'a Balance,
    /// Long runs at 600 rpm.
    pub long: &'a [Long],
    /// The undamped run.
    pub undamped: &'a Undamped,
}

/// Contact ratio of an involute pair with full-depth teeth: pitch radii r1, r2 [mm], module [mm], pressure angle [rad].
fn contact_ratio(r1: f64, r2: f64, module: f64, angle: f64) -> f64 {
    let beyond = |r: f64| ((r + module).powi(2) - (r * angle.cos()).powi(2)).sqrt();
    (beyond(r1) + beyond(r2) - (r1 + r2) * angle.sin()) / (std::f64::consts::PI * module * angle.cos())
}

/// The table.
pub fn misprints(known: &Known<'_>) -> Part {
    let row = |printed: &str, holds: &str, evidence: String| vec![printed.into(), holds.into(), evidence];
    let p = paper::pair(0.05, T0);
    let (m2, lever) = (p.m2(), (0.0762 / p.n1).powi(2));
    let module = 2.0 * 76.2 / p.n1;
    let ratio = contact_ratio(76.2, 304.8, module, 20f64.to_radians());
    let one_pair = |contact_ratio: f64| std::f64::consts::TAU * (2.0 - contact_ratio);
    let damped = printed::run(&paper::pair(0.1, T0), 300.0, 0.1, 1e6);
    let at = |t0| known.long.iter().find(|run| run.t0 == t0);
    let slow = at(T0).map_or(f64::NAN, |run| 100.0 * (1.0 - run.mean));
    let momentary = at(T0).map_or(f64::NAN, |run| run.momentary);
    let stalled = known.long.iter().find_map(|run| run.stall.map(|(first, last)| (run.t0, first, last)));
    let stall = stalled.unwrap_or((f64::NAN, f64::NAN, f64::NAN));
    let second = |t: Option<f64>| t.map_or("never".into(), |t| format!("after {} s", number(t, 2)));
    // Largest ratio of exact to classical amplitudes in the tails at 3.2 wd, at the largest phi with which a step is passed.
    let tail = 3.2 * p.wd() * p.m1() / (2.0 * m2) / (m2 * (p.k2 - p.k1)).sqrt();
    let rows = vec![
        row(
            "I1 = 2.89 kg mm^2, I2 = 740.2 kg mm^2",
            "10^3 times that",
            format!(
                "N1 Omega1/wd is then {} at 600 rpm and {} at 4500 rpm; with the printed inertias {} and {}",
                number(mesh(600), 4),
                number(mesh(4500), 4),
                number(mesh(600) / 1000f64.sqrt(), 2),
                number(mesh(4500) / 1000f64.sqrt(), 2)
            ),
        ),
        row(
            "module 6.25 mm",
            "6.35 mm",
            format!("2 r1/N1 = 2 × 76.2 mm/24 = {} mm; 6.25 mm would give r1 = 75 mm", number(module, 3)),
        ),
        row(
            "contact ratio 1.75 beside 1.73 rad of one tooth pair",
            "1.725",
            format!(
                "contact ratio of the geometry: {}, hence one pair over {} rad; 1.75 would be {} rad",
                number(ratio, 4),
                number(one_pair(ratio), 4),
                number(one_pair(1.75), 4)
            ),
        ),
        row(
            "1.73 + 4.56 rad",
            "a pitch is 2 pi",
            format!("the sum is 6.29; two pairs have the rest, {} rad", number(p.width2(), 5)),
        ),
        row(
            "a damping term in (2), none in (3)",
            "in (3) too, with M1 for M2",
            format!(
                "300 rpm, zeta 0.1, T0 = {T0} N m, 0.1 s: with the printed term the rises of U within the cells add up to \
                 {} J, with U = {} J at the start; with Rayleigh damping no rise is larger than 1e-12 J",
                number(damped.rises, 3),
                number(known.exact.start, 3)
            ),
        ),
        row(
            "zeta = (c/2) sqrt(1/(k0 M2)) for a term c (r1/N1)^2 M2 phi'",
            "zeta = (c/2) (r1/N1)^2 sqrt(M2/k0)",
            format!(
                "the printed zeta has the unit of c/sqrt(k0 M2), kg. The two differ by the factor (r1/N1)^2 M2 = {} 1/kg, \
                 which happens to be near 1 in SI units, so that the paper's numbers do not show the misprint",
                number(lever * m2, 4)
            ),
        ),
        row(
            "T0 is not given",
            "the results depend on it",
            "each claim above is given with the T0 at which it holds; the scenes have 10 N m".into(),
        ),
        row(
            "steps 3 and 6 assume that theta'-^2 > M2 dk phi^2",
            "else the gear is turned back",
            format!(
                "600 rpm, zeta 0.05, after {SPAN} s: at T0 = {T0} N m the mean speed has fallen by {} % (theta' itself, \
                 which vibrates, is {} of its start); at {} N m the gear is turned back at a step for the first time after {} s, \
                 and passes none after {} s. A pitch costs {} J at {T0} N m, in the limit of slow rotation",
                number(slow, 3),
                number(momentary, 4),
                stall.0,
                number(stall.1, 3),
                number(stall.2, 3),
                number(cost_of_a_pitch(T0), 3)
            ),
        ),
        row(
            "(the same, undamped)",
            "turned back too",
            format!(
                "600 rpm, {T0} N m, zeta 0: turned back for the first time {}. Two runs whose phi' differs by {APART:e} \
                 rad/s at the start are a thousandth of a pitch apart {}, and several pitches soon after: the motion \
                 is chaotic, so no later results of such runs are given",
                second(known.undamped.reflected),
                second(known.undamped.parted)
            ),
        ),
        row(
            "a peak near 3.2 wd, 400 times the classical amplitude",
            "not found",
            format!(
                "at 3.2 wd the tail due to jumps that the gear can pass has at most {} times the amplitude of the classical one, by the \
                 estimate below; the scan below has no peak",
                number(tail, 3)
            ),
        ),
    ];
    ("misprints", table(&["the paper", "what holds", "evidence"], &rows))
}
