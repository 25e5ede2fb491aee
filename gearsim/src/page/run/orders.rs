//! Order spectra of signals and deflections ([`crate::analysis::orders`]), a plot for each unit, and a table of the mesh orders.

use super::Report;
use super::columns::{ColumnGroup, ColumnKind};
use super::spectrum::beginning;
use crate::analysis::orders::{self, Listed, Mesh, PROMINENCE, Turning, meshes, reference_shaft};
use crate::analysis::spectrum::SpectrumError;
use crate::page::data::Counts;
use crate::page::html::{Html, TableCell};
use crate::page::plot::{Axis, Line, PageCurve, Plot};
use crate::plot::marks::MOST;
use crate::plot::orders::{CONTENT, DECADES};
use crate::plot::spectrum::reach;

/// Caption of the table.
const LINES: &str = "Mesh orders and their sidebands";

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let (run, asked) = (&report.run.outcome.trajectory, &report.run.scene.output.spectrum);
    let Some(shaft) = reference_shaft(run, asked.shaft) else {
        return html.paragraph("There are no orders: the run recorded no speed of a rotor.");
    };
    let turning = match Turning::of(run, shaft.name, asked.from) {
        Ok(turning) => turning,
        Err(error) => return html.paragraph(&format!("There are no orders of {}: {error}.", shaft.name)),
    };
    html.paragraph(&format!(
        "Peak amplitudes over orders of the shaft with the speed {} ({}): {} whole revolutions, interpolated at equal angles, \
         Hann window. {}The mean is left out. Sidebands are listed where their amplitude is above {PROMINENCE} times the median of those \
         about them. Those of gears of planet sets are multiples of their speed relative to the carrier.",
        shaft.name,
        shaft.doc,
        turning.revolutions(),
        beginning(asked.from),
    ));
    let meshes = meshes(run, asked.from);
    for group in report.groups.iter().filter(|group| matches!(group.kind, ColumnKind::Signal | ColumnKind::Deflection))
    {
        if let Err(error) = plot(report, html, group, (shaft.name, &turning), &meshes) {
            html.note(&format!("There are no orders of {}: {error}.", group.title().to_lowercase()));
        }
    }
    table(report, html, &turning, &meshes);
}

/// Adds the plot of a group. Only the curves that the report shows have values.
fn plot(
    report: &Report<'_>,
    html: &mut Html,
    group: &ColumnGroup<'_>,
    (shaft, turning): (&str, &Turning),
    meshes: &[Mesh],
) -> Result<(), SpectrumError> {
    let title = format!("{}: amplitudes of orders", group.title());
    let orders = turning.axis()?;
    let x = html.embed(&orders, Counts::Long);
    let (mut curves, mut peak, mut content) = (vec![], 0.0_f64, vec![]);
    for (i, column) in group.columns.iter().enumerate() {
        let found = match report.plotted().has(&title, &column.name) {
            true => Some(turning.orders(&column.values)?),
            false => None,
        };
        if group.shown(i) {
            content.extend(found.as_ref().map(|found| found.highest(CONTENT)));
        }
        let amplitude = found.map_or(vec![], |found| found.amplitude);
        if group.shown(i) {
            peak = amplitude.iter().skip(1).fold(peak, |m, x| m.max(*x));
        }
        let logarithms: Vec<f64> = amplitude.iter().map(|x| x.log10()).collect();
        let y = html.embed(&logarithms, Counts::Short);
        curves.push(PageCurve::new(&*column.name, &column.doc, x.clone(), y, group.shown(i)));
    }
    let longest = orders.last().copied().unwrap_or(0.0);
    let highest = meshes.iter().map(|mesh| mesh.frequency / turning.frequency()).fold(0.0, f64::max);
    let end = reach(content.into_iter(), highest, longest);
    html.plot(&Plot {
        title,
        x: Axis { range: (end > 0.0).then_some((0.0, end)), ..Axis::linear(format!("order of {shaft}"), "") },
        y: Axis {
            log: true,
            range: (peak > 0.0).then_some((DECADES * peak, 2.0 * peak)),
            // As over time: speeds of rotors in revolutions a minute.
            usual: (group.kind == ColumnKind::Signal && group.unit == "rad/s").then_some("rpm"),
            ..Axis::linear("", &*group.unit)
        },
        curves,
        group: Some("order".into()),
        events: None,
        lines: marks(meshes, turning, end),
        shaded_from: None,
        square: false,
    });
    Ok(())
}

/// Vertical lines at the multiples of the orders of steady meshes that the axis shows, up to `end`. Meshes of the same order have one line.
fn marks(meshes: &[Mesh], turning: &Turning, end: f64) -> Vec<Line> {
    let mut marks: Vec<Line> = vec![];
    for mesh in meshes.iter().filter(|mesh| mesh.steady) {
        let order = mesh.frequency / turning.frequency();
        if marks.iter().any(|mark| (mark.x - order).abs() < 1e-6 * order) {
            continue;
        }
        let name = |n: usize| if n == 1 { mesh.name.to_owned() } else { format!("{n} x {}", mesh.name) };
        marks.extend((1..=MOST).map(|n| Line { x: n as f64 * order, name: name(n) }).take_while(|mark| mark.x <= end));
    }
    marks
}

/// The table of the lines of steady meshes, with the amplitudes of the curves that are drawn at first.
fn table(report: &Report<'_>, html: &mut Html, turning: &Turning, meshes: &[Mesh]) {
    let steady: Vec<Mesh> = meshes.iter().filter(|mesh| mesh.steady).cloned().collect();
    let lines = orders::lines(turning, &steady);
    if !lines.is_empty() && !report.plotted().has_table(LINES) {
        return html.later(LINES);
    }
    let groups = report.groups.iter().filter(|group| matches!(group.kind, ColumnKind::Signal | ColumnKind::Deflection));
    let shown = groups.flat_map(|group| {
        let unit = group.shown_unit();
        let columns = group.columns.iter().enumerate().filter(|(i, _)| group.shown(*i));
        columns.map(move |(_, column)| (unit, column))
    });
    let shown: Vec<_> = shown.collect();
    let columns: Vec<&[f64]> = shown.iter().map(|(_, column)| &*column.values).collect();
    let mut rows = vec![];
    for (((unit, factor), column), listed) in shown.iter().zip(turning.listed(&columns, &lines)) {
        for Listed { line, with, amplitude } in listed {
            let numbers = [line.harmonic as f64, f64::from(line.sideband)].map(TableCell::Number);
            let rest = [line.order, line.frequency, factor * amplitude].map(TableCell::Number);
            let mut row = vec![TableCell::text(&*column.name), TableCell::text(line.mesh)];
            row.extend(numbers);
            row.push(TableCell::text(line.rotor.unwrap_or("-")));
            row.extend(rest);
            row.push(TableCell::text(*unit));
            row.push(TableCell::text(with.iter().map(orders::Line::words).collect::<Vec<_>>().join(", ")));
            rows.push(row);
        }
    }
    let head = [
        "column",
        "mesh",
        "multiple",
        "sideband",
        "of rotor",
        "order",
        "frequency [Hz]",
        "amplitude",
        "unit",
        "not separated from",
    ];
    html.table(LINES, &head, &rows);
}
