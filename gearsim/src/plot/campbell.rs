//! Campbell diagram: natural frequencies and harmonics of the mesh frequencies over the speed.

use std::collections::BTreeSet;

use super::{Axis, Figure, Marker, Note, NotePlace, Panel, PlotError, Series, Style};
use crate::analysis::modes::{CellModes, Meeting, meetings};
use crate::analysis::steady::SteadyLaw;
use crate::output::number::short;
use crate::scene::Scene;
use crate::tolerance::analysis::NEAR_RESONANCE;

/// Number of harmonics of each mesh frequency that are always drawn. Higher harmonics are drawn if they are near a mode at the scene's
/// speed.
const HARMONICS: usize = 4;
/// Two lines of frequencies closer than this are one [relative].
const SAME: f64 = 1e-6;
/// Natural frequencies closer than this share of the height of the diagram have one name.
const CLOSE: f64 = 0.031;
/// Width and height of the diagram, relative to the largest abscissa and ordinate of its lines. The numbers of orders stand beyond the ends
/// of the lines.
const NOTES: (f64, f64) = (1.1, 1.08);
/// Maximum number of orders that all have a number. If there are more, only the first order of each mesh has one.
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
    let meetings = meetings(courses, cell);
    let harmonics = |frequency: f64| {
        let of_mesh = |meeting: &&Meeting| is_same(courses[meeting.law].mesh_frequency(), frequency);
        let listed = meetings.iter().filter(of_mesh).map(|meeting| meeting.harmonic);
        (1..=HARMONICS).chain(listed).collect::<BTreeSet<usize>>()
    };
    let meshes: Vec<(String, f64, BTreeSet<usize>)> =
        meshes.into_iter().map(|(name, frequency)| (name, frequency, harmonics(frequency))).collect();
    let Some((first, ..)) = meshes.first() else { return Err(nothing("no mesh of the scene turns and steps")) };
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
    // The diagram contains every mode, and each first mesh order up to the lowest mode, but at most four times the speed.
    let reach = meshes.iter().map(|(_, f, _)| lowest / f).fold(0.0, f64::max).min(4.0);
    let longest = now * reach.max(1.5);
    let top = 1.06 * highest.max(meshes.iter().map(|(_, f, _)| *f).fold(0.0, f64::max));
    let mut series = modes_drawn(&modes, longest, top);
    let notes = meshes.iter().map(|(.., harmonics)| harmonics.len()).sum::<usize>() <= MOST_NOTES;
    for (n, (name, frequency, harmonics)) in meshes.iter().enumerate() {
        for &harmonic in harmonics {
            let slope = harmonic as f64 * frequency / now;
            let order = slope * if unit == "rpm" { 60.0 } else { 1.0 };
            let drawn = |(_, other, harmonics): &(String, f64, BTreeSet<usize>)| {
                harmonics.iter().any(|h| is_same(*h as f64 * other / now, slope))
            };
            if meshes[..n].iter().any(drawn) {
                continue;
            }
            let x: Vec<f64> = (0..=POINTS).map(|i| longest.min(top / slope) * i as f64 / POINTS as f64).collect();
            let y = x.iter().map(|x| slope * x).collect();
            let label = if harmonic == 1 {
                format!("orders of {name}: {} × {}", words(harmonics), short(order))
            } else {
                String::new()
            };
            let mut line = Series::new(n, label, x, y);
            // Only natural frequencies are black.
            line.style.colour = COLOURS[n % COLOURS.len()];
            line.style = Style { dashes: &[], width: if harmonic == 1 { 1.5 } else { 0.9 }, ..line.style };
            let place = if top / slope < longest { NotePlace::Above } else { NotePlace::After };
            if harmonic == 1 || notes {
                line.note = Note { text: short(order), place };
            }
            series.push(line);
        }
    }
    let style = Style { colour: "#777777", dashes: &[7.0, 3.0], width: 1.3, marker: Marker::None };
    series.push(Series { style, ..Series::new(0, "speed of the scene", vec![now, now], vec![0.0, top]) });
    series.extend(crossings(&meetings, cell, now));
    Ok(Figure {
        title: "Natural frequencies and mesh orders".into(),
        subtitle: Some(scene.name.clone()),
        x: Axis::linear(label, unit).between(0.0, NOTES.0 * longest),
        panels: vec![Panel { y: Axis::linear("frequency", "Hz").between(0.0, NOTES.1 * top), series }],
    })
}

/// Harmonics in words: `1 to 4, 7`.
fn words(harmonics: &BTreeSet<usize>) -> String {
    let higher = harmonics.iter().filter(|harmonic| **harmonic > HARMONICS).map(|harmonic| format!(", {harmonic}"));
    format!("1 to {HARMONICS}{}", higher.collect::<String>())
}

/// Marks for `meetings`, the harmonics near a mode at the scene's speed `now`: each at the speed at which the harmonic has the frequency of
/// the mode.
fn crossings(meetings: &[Meeting], cell: &CellModes, now: f64) -> Option<Series> {
    let mut places: Vec<(f64, f64)> = meetings.iter().map(|m| (now / m.ratio, cell.modes[m.mode].damped)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (x, y): (Vec<f64>, Vec<f64>) = places.into_iter().unzip();
    let label = format!("modes within {:.0} % of a harmonic at this speed", 100.0 * NEAR_RESONANCE);
    let style = Style { colour: "#d55e00", dashes: &[], width: 0.0, marker: Marker::Dot };
    (!x.is_empty()).then(|| Series { style, ..Series::new(0, label, x, y) })
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

/// Each listed harmonic has its line, and its crossing has a mark. Some of the harmonics of `wind_turbine` are higher than the fourth.
#[test]
fn the_harmonics_that_are_listed_are_drawn_and_their_crossings_marked() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/wind_turbine.toml");
    let scene = Scene::load(&path).unwrap();
    let entry = crate::known::of(&scene).unwrap();
    let system = entry.about_steady_motion(&scene).unwrap();
    let courses = crate::analysis::steady::courses(&scene, &system).unwrap();
    let parts = crate::analysis::modes::Parts::of(&scene, entry, &system, &|| {}).unwrap();
    let cell = crate::analysis::modes::of(&system, &scene.mid_stiffnesses(), &parts, &|| {}).unwrap();
    let meetings = meetings(&courses, &cell);
    assert!(meetings.iter().any(|meeting| meeting.harmonic > HARMONICS), "{meetings:?}");
    let figure = draw(&scene, &courses, &cell).unwrap();
    let series = &figure.panels[0].series;
    let now = series.iter().find(|s| s.label == "speed of the scene").unwrap().x[0];
    let marks = series.iter().find(|s| s.style.marker == Marker::Dot).unwrap();
    assert_eq!(marks.x.len(), meetings.len());
    for meeting in &meetings {
        let slope = meeting.harmonic as f64 * courses[meeting.law].mesh_frequency() / now;
        let line = |s: &Series| s.x.len() == POINTS + 1 && is_same(s.y[POINTS] / s.x[POINTS], slope);
        assert!(series.iter().any(line), "{meeting:?}");
        let y = cell.modes[meeting.mode].damped;
        assert!(marks.x.iter().zip(&marks.y).any(|(x, at)| *at == y && (slope * x / y - 1.0).abs() < 1e-9));
    }
}
