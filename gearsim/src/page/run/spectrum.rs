//! Power spectral densities of speeds, signals and deflections ([`crate::analysis::spectrum`]), a plot for each unit.

use std::f64::consts::TAU;

use super::Report;
use super::columns::{ColumnGroup, ColumnKind, NamedColumn};
use crate::analysis::orders::{Mesh, meshes};
use crate::analysis::spectrum::{Spectrum, SpectrumError, frequencies, segment_length, uniform_samples_from, welch};
use crate::output::number::short;
use crate::page::data::Counts;
use crate::page::html::Html;
use crate::page::plot::{Axis, Line, PageCurve, Plot};
use crate::plot::spectrum::{CONTENT, reach};
use crate::trajectory::Trajectory;

/// The highest peak over the lowest density that is shown. Lower densities are rounding errors and leakage.
const DECADES: f64 = 1e12;

/// Number of marked multiples of a mesh frequency, from the frequency itself on.
const MULTIPLES: usize = 3;

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let (run, from) = (&report.run.outcome.trajectory, report.run.scene.output.spectrum.from);
    let (rows, rate) = match samples(run, from) {
        Ok(samples) => samples,
        Err(error) => return html.paragraph(&format!("There are no spectra: {error}.")),
    };
    let segment = segment_length(rows.len());
    let hertz = rate / segment as f64;
    html.paragraph(&format!(
        "Power spectral densities by Welch's method: {} samples a second in segments of {segment} with a Hann window, overlapping by \
         half; resolution {} Hz. {}The mean is left out.",
        short(rate),
        short(hertz),
        beginning(from),
    ));
    let kinds = [ColumnKind::Speed, ColumnKind::Signal, ColumnKind::Deflection];
    let mut found = vec![];
    for group in report.groups.iter().filter(|group| kinds.contains(&group.kind)) {
        match spectra(report, group, &rows, rate) {
            Ok(spectra) => found.push((group, spectra)),
            Err(error) => html.note(&format!("There is no spectrum of {}: {error}.", group.title().to_lowercase())),
        }
    }
    let meshes: Vec<Mesh> = meshes(run, from).into_iter().filter(|mesh| mesh.steady).collect();
    let highest = meshes.iter().map(|mesh| mesh.frequency).fold(0.0, f64::max);
    // A signal that is 0 or 1 has content at all frequencies.
    let shown = found.iter().filter(|(group, _)| group.unit != "1").flat_map(|(group, spectra)| {
        spectra.iter().enumerate().filter(|(i, _)| group.shown(*i)).filter_map(|(_, spectrum)| spectrum.as_ref())
    });
    let lines = lines(report, &meshes);
    let frequencies = frequencies(rate, segment);
    let longest = frequencies.last().copied().unwrap_or(0.0);
    let end = reach(shown.map(|spectrum| spectrum.highest(CONTENT)), highest, longest);
    for (group, spectra) in &found {
        plot(html, group, (&frequencies, spectra), end, lines.clone());
    }
}

/// The rows of the samples from the time `from` \[s\] on, and their rate \[Hz\].
fn samples(run: &Trajectory, from: f64) -> Result<(Vec<usize>, f64), SpectrumError> {
    let (rows, rate) = uniform_samples_from(run, from)?;
    match rows.len() {
        samples @ 0..4 => Err(SpectrumError::TooShort { samples }),
        _ => Ok((rows, rate)),
    }
}

/// A sentence that states from which time \[s\] on samples are used; empty if all are.
pub(super) fn beginning(from: f64) -> String {
    if from > 0.0 { format!("Samples before t = {} s are left out. ", short(from)) } else { String::new() }
}

/// The title of the plot of a group.
fn title(group: &ColumnGroup<'_>) -> String {
    format!("{}: power spectral density", group.title())
}

/// The spectra of the columns of a group that the report shows.
fn spectra(
    report: &Report<'_>,
    group: &ColumnGroup<'_>,
    rows: &[usize],
    rate: f64,
) -> Result<Vec<Option<Spectrum>>, SpectrumError> {
    let title = title(group);
    let spectrum = |column: &NamedColumn<'_>| {
        if !report.plotted().has(&title, &column.name) {
            return Ok(None);
        }
        let samples: Vec<f64> = rows.iter().map(|&row| column.values[row]).collect();
        welch(&samples, rate, segment_length(samples.len())).map(Some)
    };
    group.columns.iter().map(spectrum).collect()
}

/// Adds the plot of a group, at first up to the frequency `end`.
fn plot(
    html: &mut Html,
    group: &ColumnGroup<'_>,
    (frequencies, spectra): (&[f64], &[Option<Spectrum>]),
    end: f64,
    lines: Vec<Line>,
) {
    let (mut curves, mut peak, mut lowest) = (vec![], 0.0_f64, f64::INFINITY);
    let x = html.embed(frequencies, Counts::Long);
    for (i, (column, spectrum)) in group.columns.iter().zip(spectra).enumerate() {
        let density = spectrum.as_ref().map_or(&[][..], |spectrum| &spectrum.density);
        if group.shown(i) {
            peak = density.iter().fold(peak, |m, x| m.max(*x));
            lowest = density.iter().filter(|x| **x > 0.0).fold(lowest, |m, x| m.min(*x));
        }
        let logarithms: Vec<f64> = density.iter().map(|x| x.log10()).collect();
        let y = html.embed(&logarithms, Counts::Short);
        curves.push(PageCurve::new(&*column.name, &column.doc, x.clone(), y, group.shown(i)));
    }
    let range = (lowest < peak).then(|| (lowest.max(peak / DECADES), 3.0 * peak));
    html.plot(&Plot {
        title: title(group),
        x: Axis { range: (end > 0.0).then_some((0.0, end)), ..Axis::linear("frequency f", "Hz") },
        y: Axis { log: true, range, ..Axis::linear("", density_unit(&group.unit)) },
        curves,
        group: Some("frequency".into()),
        events: None,
        lines,
        shaded_from: None,
        square: false,
    });
}

/// The unit of the density of a quantity in `unit`.
fn density_unit(unit: &str) -> String {
    match unit {
        "1" => "1/Hz".into(),
        _ if unit.contains(['/', '*']) => format!("({unit})^2/Hz"),
        _ => format!("{unit}^2/Hz"),
    }
}

/// The damped natural frequency, and the frequencies of steady meshes.
fn lines(report: &Report<'_>, meshes: &[Mesh]) -> Vec<Line> {
    let natural = report.run.outcome.reference_frequency.map(|w| Line { x: w / TAU, name: "natural".into() });
    let mut lines: Vec<Line> = natural.into_iter().collect();
    for mesh in meshes {
        // If there are several meshes, each line has the name of its mesh.
        let of = if meshes.len() > 1 { mesh.name } else { "mesh" };
        let name = |n: usize| if n == 1 { of.to_owned() } else { format!("{n} x {of}") };
        lines.extend((1..=MULTIPLES).map(|n| Line { x: n as f64 * mesh.frequency, name: name(n) }));
    }
    lines
}
