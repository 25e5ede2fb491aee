//! Waterfall: the spectra of a coordinate over the one quantity that was varied, in colours.

use super::figure::{Axis, Scale, extremes};
use super::heat::{Heat, Marks, edges};
use super::map::{places, subtitle, varied};
use super::{Picture, PlotError, Study, SweepPlot, symbol};
use crate::sweep::spectra::Line;

/// Its entry in the registry.
pub const PLOT: SweepPlot =
    SweepPlot { name: "waterfall", doc: "spectra of a coordinate over the one quantity that was varied", draw };

/// Densities below this part of the highest are not told apart.
const FLOOR: f64 = 1e-7;
/// Frequencies are shown up to the last line that is more than this part of the highest.
const SHOWN: f64 = 1e-5;
/// Cells over the frequencies; more than can be seen are not drawn.
const ROWS: usize = 215;

fn draw(study: &Study<'_>) -> Result<Picture, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    if study.layout.plan.axes.len() != 1 {
        return Err(nothing("it is over one varied quantity".into()));
    }
    let line = |spectra: &'_ [Line]| spectra.iter().position(|line| line.coordinate == study.quantity);
    let lines: Vec<Option<&Line>> =
        study.rows.values().map(|row| line(&row.spectra).map(|i| &row.spectra[i])).collect();
    let there = || lines.iter().flatten();
    let (_, peak) = extremes(there().flat_map(|line| line.density.iter().copied().skip(1)));
    if !(peak > 0.0 && peak.is_finite()) {
        return Err(nothing(format!("no point has a spectrum of `{}`", study.quantity)));
    }
    let floor = FLOOR * peak;
    let highest =
        |line: &&Line| line.density.iter().rposition(|p| *p > SHOWN * peak).map_or(0.0, |i| line.frequency[i]);
    let top = there().map(highest).fold(0.0, f64::max);

    let mut order: Vec<(f64, Option<&Line>)> = places(study, 0).into_iter().zip(lines.iter().copied()).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    order.dedup_by(|a, b| a.0 == b.0);
    let x: Vec<f64> = order.iter().map(|(x, _)| *x).collect();
    let y: Vec<f64> = (0..=ROWS).map(|i| top * i as f64 / ROWS as f64).collect();
    let mut values = vec![];
    for row in y.windows(2) {
        values.extend(
            order.iter().map(|(_, line)| line.map_or(f64::NAN, |line| within(line, row[0], row[1]).max(floor))),
        );
    }

    let axis = varied(study, 0);
    let scale = axis.scale;
    let x = edges(&x, if x.first().is_some_and(|x| *x > 0.0) { scale } else { Scale::Linear });
    let unit = study.layout.model.coordinates.iter().find(|c| c.name == study.quantity).map_or("1", |c| c.unit);
    let colour = Axis::log10(format!("PSD of {}", symbol(study.quantity)), format!("{unit}^2/Hz")).between(floor, peak);
    Ok(Heat {
        title: format!("Spectra of {}", symbol(study.quantity)),
        subtitle: format!("{}; Welch, Hann window", subtitle(study)),
        x: axis,
        y: Axis::linear("frequency f", "Hz"),
        colour,
        marks: Marks::Cells { x, y, values },
    }
    .picture())
}

/// The highest density of a line between two frequencies; where it has none there, the nearest.
fn within(line: &Line, low: f64, high: f64) -> f64 {
    let begin = line.frequency.partition_point(|f| *f < low);
    let end = line.frequency.partition_point(|f| *f < high);
    match line.density.get(begin..end) {
        Some(found @ [_, ..]) => found.iter().copied().fold(0.0, f64::max),
        _ => line.density.get(begin.min(line.density.len().saturating_sub(1))).copied().unwrap_or(f64::NAN),
    }
}
