//! Waterfall: the power spectral density of a coordinate, as colour, over the varied quantity and the frequency.

use super::figure::{Axis, Scale, extremes};
use super::heat::{HeatMap, Marks, edges};
use super::map::{places, subtitle, varied};
use super::{Drawn, PlotError, SweepPlot, SweepResults, symbol};
use crate::sweep::spectra::NamedSpectrum;

/// A plot of `gearsim sweep`.
pub const PLOT: SweepPlot = SweepPlot { name: "waterfall", draw };

/// Densities below this fraction of the highest density get the lowest colour.
const FLOOR: f64 = 1e-7;
/// The frequency axis ends at the last line that exceeds this fraction of the highest density.
const SHOWN: f64 = 1e-5;
/// Number of cells along the frequency axis, 2 SVG units each: more would not be visible.
const ROWS: usize = 215;

fn draw(results: &SweepResults<'_>) -> Result<Drawn, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    if results.layout.plan.axes.len() != 1 {
        return Err(nothing("it needs exactly one varied quantity".into()));
    }
    let place = |spectra: &'_ [NamedSpectrum]| spectra.iter().position(|s| s.coordinate == results.quantity);
    let spectra: Vec<Option<&NamedSpectrum>> =
        results.rows.values().map(|row| place(&row.spectra).map(|i| &row.spectra[i])).collect();
    let found = || spectra.iter().flatten();
    let (_, peak) = extremes(found().flat_map(|spectrum| spectrum.density.iter().copied().skip(1)));
    if !(peak > 0.0 && peak.is_finite()) {
        return Err(nothing(format!("no point has a spectrum of `{}`", results.quantity)));
    }
    let floor = FLOOR * peak;
    let highest =
        |s: &&NamedSpectrum| s.density.iter().rposition(|p| *p > SHOWN * peak).map_or(0.0, |i| s.frequency[i]);
    let top = found().map(highest).fold(0.0, f64::max);

    let mut order: Vec<(f64, Option<&NamedSpectrum>)> =
        places(results, 0).into_iter().zip(spectra.iter().copied()).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    order.dedup_by(|a, b| a.0 == b.0);
    let x: Vec<f64> = order.iter().map(|(x, _)| *x).collect();
    let y: Vec<f64> = (0..=ROWS).map(|i| top * i as f64 / ROWS as f64).collect();
    let mut values = vec![];
    for row in y.windows(2) {
        values.extend(
            order
                .iter()
                .map(|(_, spectrum)| spectrum.map_or(f64::NAN, |s| highest_between(s, row[0], row[1]).max(floor))),
        );
    }

    let axis = varied(results, 0);
    let scale = axis.scale;
    let x = edges(&x, if x.first().is_some_and(|x| *x > 0.0) { scale } else { Scale::Linear });
    let unit = results.layout.model.coordinates.iter().find(|c| c.name == results.quantity).map_or("1", |c| c.unit);
    let colour =
        Axis::log10(format!("PSD of {}", symbol(results.quantity)), format!("{unit}^2/Hz")).between(floor, peak);
    Ok(Drawn::Map(Box::new(HeatMap {
        title: format!("Spectra of {}", symbol(results.quantity)),
        subtitle: format!("{}; Welch, Hann window", subtitle(results)),
        x: axis,
        y: Axis::linear("frequency f", "Hz"),
        colour,
        marks: Marks::Cells { x, y, values },
    })))
}

/// The highest density of a spectrum between two frequencies. If it has no line between them, the next line above, or the last one.
fn highest_between(spectrum: &NamedSpectrum, low: f64, high: f64) -> f64 {
    let begin = spectrum.frequency.partition_point(|f| *f < low);
    let end = spectrum.frequency.partition_point(|f| *f < high);
    match spectrum.density.get(begin..end) {
        Some(found @ [_, ..]) => found.iter().copied().fold(0.0, f64::max),
        _ => spectrum.density.get(begin.min(spectrum.density.len().saturating_sub(1))).copied().unwrap_or(f64::NAN),
    }
}
