//! Cascades: spectra of successive parts of a run, each drawn at the speed of its part; at constant speed, at its time.

use super::outputs::{engineering, of_unit};
use super::{Axis, Marker, Panel, PlotError, Run, Series, Style};
use crate::analysis::orders::{Mesh, SHAFT, meshes, reference_shaft};
use crate::model::Output;
use crate::output::number::short;

/// Number of points of a curve. Each is the largest of several lines.
const POINTS: usize = 500;
/// Height of the highest line, in parts of the axis.
const HEIGHT: f64 = 0.2;
/// The speed counts as varying if its range is more than this share of its largest value.
const VARIES: f64 = 0.05;
/// Amplitudes below this share of the largest do not extend the axis of frequencies or orders.
const CONTENT: f64 = 0.02;

/// A part of a run.
pub(super) struct RunPart {
    /// Mean speed of the shaft \[rad/s\].
    pub speed: f64,
    /// Time of its middle \[s\].
    pub time: f64,
    /// Frequencies \[Hz\], or orders.
    pub place: Vec<f64>,
    /// Peak amplitudes [unit of the signal].
    pub amplitude: Vec<f64>,
}

/// Multiples of a mesh order that have a line.
const HARMONICS: usize = 3;

/// The subject of a cascade: a signal over the speed of a shaft, with the orders of the meshes.
pub(super) struct Subject {
    /// The shaft to which orders refer.
    pub shaft: &'static Output,
    /// Name of the signal, and its SI unit.
    pub signal: (&'static str, &'static str),
    /// The meshes, each with its frequency \[Hz\].
    pub meshes: Vec<Mesh>,
}

impl Subject {
    /// The subject of the plot `plot` of a run. The signal is the first one for which the scene asks spectra. If it asks for none, it is
    /// the force of a mesh, or else another output.
    pub fn of(plot: &'static str, run: &Run<'_>) -> Result<Subject, PlotError> {
        let nothing = |why: &str| PlotError::Nothing { plot, why: why.into() };
        let (asked, run) = (&run.asked.spectrum, run.trajectory);
        let shaft = reference_shaft(run, asked.shaft).ok_or_else(|| nothing("the run recorded no speed of a rotor"))?;
        let meshes = meshes(run, asked.from);
        let chosen = asked.of.iter().copied().chain(meshes.iter().filter_map(|mesh| mesh.force));
        let known = chosen.filter_map(|name| run.signal(name).map(|(unit, _)| (name, unit))).next();
        let other = || {
            let of = |unit: &&str| of_unit(run, unit).first().map(|output| (output.name, output.unit));
            ["N", "m", "rad", "N*m"].iter().find_map(of)
        };
        let signal = known.or_else(other).ok_or_else(|| nothing("the run recorded no force or error"))?;
        Ok(Subject { shaft, signal, meshes })
    }
}

/// The highest frequency or order at which a part has an amplitude above `CONTENT` times `peak`, the highest line of the parts.
pub(super) fn content(parts: &[RunPart], peak: f64) -> f64 {
    let last = |part: &RunPart| part.amplitude.iter().rposition(|a| *a > CONTENT * peak).map_or(0.0, |i| part.place[i]);
    parts.iter().map(last).fold(0.0, f64::max)
}

/// Lines of the mesh `orders` and their multiples over the speeds from the lowest to the highest \[rpm\]. `place` gives the abscissa of an
/// order at a speed \[rpm\].
pub(super) fn lines(orders: &[(&str, f64)], range: (f64, f64), place: fn(f64, f64) -> f64) -> Vec<Series> {
    let of_mesh = |(m, (mesh, order)): (usize, &(&str, f64))| {
        let each = |harmonic: usize| {
            let label = if harmonic == 1 { format!("1 to {HARMONICS} × {mesh}") } else { String::new() };
            let order = harmonic as f64 * order;
            line(m, label, vec![place(order, range.0), place(order, range.1)], range)
        };
        (1..=HARMONICS).map(each).collect::<Vec<_>>()
    };
    orders.iter().enumerate().flat_map(of_mesh).collect()
}

/// A line behind the curves.
fn line(n: usize, label: String, x: Vec<f64>, (low, high): (f64, f64)) -> Series {
    let mut line = Series::new(n, label, x, vec![low, high]);
    line.style = Style { colour: "#999999", dashes: &[5.0, 3.0], width: 0.9, marker: Marker::None };
    line
}

/// The cascade of the `parts` of a run up to the place `end`; the highest line has the amplitude `peak` \[`unit`\]. Where the speed varies,
/// `marks` gives the lines behind the curves from the lowest to the highest speed \[rpm\].
pub(super) fn panel(
    parts: &[RunPart],
    (label, named): (&str, bool),
    (end, peak, unit): (f64, f64, &str),
    marks: &dyn Fn((f64, f64)) -> Vec<Series>,
) -> Panel {
    let (_, rpm) = engineering(SHAFT);
    let extreme = |of: fn(f64, f64) -> f64, start: f64| parts.iter().map(|part| part.speed).fold(start, of);
    let (low, high) = (extreme(f64::min, f64::INFINITY), extreme(f64::max, 0.0));
    let over_speed = high - low > VARIES * high;
    let place = |part: &RunPart| if over_speed { rpm * part.speed } else { part.time };
    let places: Vec<f64> = parts.iter().map(place).collect();
    let (low, high) = places.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), x| (l.min(*x), h.max(*x)));
    let largest = parts.iter().flat_map(|part| &part.amplitude).copied().fold(f64::MIN_POSITIVE, f64::max);
    let scale = HEIGHT * (high - low).max(f64::MIN_POSITIVE) / largest;
    let mut series = if over_speed { marks((low, high)) } else { vec![] };
    for (i, (part, at)) in parts.iter().zip(&places).enumerate() {
        let shown = part.place.partition_point(|f| *f <= end);
        let each = shown.div_ceil(POINTS).max(1);
        let x = part.place[..shown].chunks(each).map(|f| f[f.len() / 2]).collect();
        let highest = |a: &[f64]| at + scale * a.iter().copied().fold(0.0, f64::max);
        let y = part.amplitude[..shown].chunks(each).map(highest).collect();
        let label = match (i, named) {
            (0, true) => label.to_owned(),
            (0, false) => format!("the highest line is {} {unit}", short(peak)),
            _ => String::new(),
        };
        let style = Style { colour: "#0072b2", dashes: &[], width: 0.9, marker: Marker::None };
        series.push(Series { style, ..Series::new(0, label, x, y) });
    }
    let y = if over_speed { Axis::linear("speed", "rpm") } else { Axis::linear("time t", "s") };
    Panel { y, series }
}
