//! Campbell diagram: natural frequencies and harmonics of the mesh frequencies over the speed.

use super::{Axis, Figure, Marker, Note, Panel, Place, PlotError, Series, Style};
use crate::analysis::modes::CellModes;
use crate::analysis::steady::SteadyLaw;
use crate::output::number::short;
use crate::scene::Scene;

/// Number of harmonics drawn of each mesh frequency.
const HARMONICS: usize = 4;
/// Two lines of frequencies closer than this are one [relative].
const SAME: f64 = 1e-6;
/// Natural frequencies closer than this share of the height of the diagram have one name.
const CLOSE: f64 = 0.031;
/// Width and height of the diagram with the orders, which stand beyond the ends of their lines, relative to those without.
const NOTES: (f64, f64) = (1.1, 1.08);
/// Most orders with a number each; of more, only the first of each mesh has one.
const MOST_NOTES: usize = 24;
/// Place of the numbers of modes along the abscissa.
const NAMES: f64 = 0.05;
/// Colours of the orders of each mesh.
const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#57330f", "#200080"];
/// Points of a line.
const POINTS: usize = 200;

/// The Campbell diagram of a scene. `cell` has its natural frequencies, `courses` the periodic laws of its meshes.
///
/// # Errors
/// [`PlotError::Nothing`] if no mode vibrates, or if no mesh both turns and has a stiffness that steps.
pub fn draw(scene: &Scene, courses: &[SteadyLaw], cell: &CellModes) -> Result<Figure, PlotError> {
    let nothing = |why: &str| PlotError::Nothing { plot: "campbell", why: why.into() };
    let meshes = meshes(courses);
    let Some((first, _)) = meshes.first() else { return Err(nothing("no mesh of the scene turns and steps")) };
    let modes: Vec<(usize, f64)> = cell.modes.iter().map(|m| m.damped).enumerate().filter(|(_, f)| *f > 0.0).collect();
    let frequencies = || modes.iter().map(|(_, f)| *f);
    let highest = frequencies().fold(0.0, f64::max);
    let lowest = frequencies().fold(f64::INFINITY, f64::min);
    if modes.is_empty() {
        return Err(nothing("nothing vibrates"));
    }
    // The abscissa is the speed that the scene states, or a mesh frequency if it states each speed by itself.
    let motion =
        scene.model.motions.iter().zip(&scene.start.motions).find(|(m, speed)| m.unit == "rad/s" && **speed != 0.0);
    let (label, unit, now) = match motion {
        Some((motion, speed)) => (motion.doc.to_owned(), "rpm", speed.abs() * 30.0 / std::f64::consts::PI),
        None => (format!("mesh frequency of {first}"), "Hz", meshes[0].1),
    };
    // Every mode is in the diagram, and each line of a mesh up to the lowest one.
    let reach = meshes.iter().map(|(_, f)| lowest / f).fold(0.0, f64::max).min(4.0);
    let longest = now * reach.max(1.5);
    let top = 1.06 * highest.max(meshes.iter().map(|(_, f)| *f).fold(0.0, f64::max));
    let mut series = modes_drawn(&modes, longest, top);
    for (n, (name, frequency)) in meshes.iter().enumerate() {
        for harmonic in 1..=HARMONICS {
            let slope = harmonic as f64 * frequency / now;
            let order = slope * if unit == "rpm" { 60.0 } else { 1.0 };
            let same =
                meshes[..n].iter().any(|(_, other)| (1..=HARMONICS).any(|h| is_same(h as f64 * other / now, slope)));
            if same {
                continue;
            }
            let x: Vec<f64> = (0..=POINTS).map(|i| longest.min(top / slope) * i as f64 / POINTS as f64).collect();
            let y = x.iter().map(|x| slope * x).collect();
            let label = if harmonic == 1 {
                format!("orders of {name}: 1 to {HARMONICS} × {}", short(order))
            } else {
                String::new()
            };
            let mut line = Series::new(n, label, x, y);
            // Natural frequencies alone are black.
            line.style.colour = COLOURS[n % COLOURS.len()];
            line.style = Style { dashes: &[], width: if harmonic == 1 { 1.5 } else { 0.9 }, ..line.style };
            let place = if top / slope < longest { Place::Above } else { Place::After };
            if harmonic == 1 || meshes.len() * HARMONICS <= MOST_NOTES {
                line.note = Note { text: short(order), place };
            }
            series.push(line);
        }
    }
    let style = Style { colour: "#777777", dashes: &[7.0, 3.0], width: 1.3, marker: Marker::None };
    series.push(Series { style, ..Series::new(0, "speed of the scene", vec![now, now], vec![0.0, top]) });
    Ok(Figure {
        title: "Natural frequencies and mesh orders".into(),
        subtitle: Some(scene.name.clone()),
        x: Axis::linear(label, unit).between(0.0, NOTES.0 * longest),
        panels: vec![Panel { y: Axis::linear("frequency", "Hz").between(0.0, NOTES.1 * top), series }],
    })
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * b
}

/// The mesh frequencies at the speed of the scene \[Hz\], each once, with the names of its laws.
fn meshes(courses: &[SteadyLaw]) -> Vec<(String, f64)> {
    let mut meshes: Vec<(Vec<&str>, f64)> = vec![];
    for course in courses.iter().filter(|course| course.turns()) {
        match meshes.iter_mut().find(|(_, f)| is_same(*f, course.mesh_frequency())) {
            Some((names, _)) => names.push(course.name),
            None => meshes.push((vec![course.name], course.mesh_frequency())),
        }
    }
    let name = |names: Vec<&str>| match names.len() {
        1 => names[0].to_owned(),
        n => format!("{} to {} ({n})", names[0], names[n - 1]),
    };
    meshes.into_iter().map(|(names, f)| (name(names), f)).collect()
}

/// The natural frequencies, each once, with the numbers of their modes as in the table of modes.
fn modes_drawn(modes: &[(usize, f64)], longest: f64, top: f64) -> Vec<Series> {
    let mut lines: Vec<(Vec<usize>, f64)> = vec![];
    for &(i, f) in modes {
        match lines.iter_mut().find(|(_, known)| is_same(*known, f)) {
            Some((numbers, _)) => numbers.push(i),
            None => lines.push((vec![i], f)),
        }
    }
    lines.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (mut series, mut names): (Vec<Series>, Vec<Series>) = (vec![], vec![]);
    for (n, (numbers, f)) in lines.into_iter().enumerate() {
        let label = if n == 0 { "damped natural frequencies, with the numbers of modes" } else { "" };
        let style = Style { width: 1.7, ..Style::PLAIN };
        series.push(Series { style, ..Series::new(0, label, vec![0.0, longest], vec![f, f]) });
        let numbers = numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        // Names of lines close to each other would cover each other: the lowest line has them all.
        match names.last_mut().filter(|name| f - name.y[0] < CLOSE * top) {
            Some(name) => name.note.text += &format!(", {numbers}"),
            None => {
                let style = Style { width: 0.0, ..Style::PLAIN };
                let at = Series::new(0, "", vec![NAMES * longest], vec![f]);
                names.push(Series { style, note: Note { text: numbers, ..Note::default() }, ..at });
            }
        }
    }
    series.into_iter().chain(names).collect()
}
