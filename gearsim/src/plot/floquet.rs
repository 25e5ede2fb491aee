//! Stability of steady rotation: growth per period as a curve over one varied quantity, or as a map over two.

use super::heat::{HeatMap, Marks, edges};
use super::{Axis, Figure, Marker, Panel, PlotError, Scale, Series, Style};
use crate::analysis::floquet::{Chart, Spot};

/// Height of the frame [SVG units], divided among the rows of a map.
const FRAME: f64 = 400.0;
/// Classes of growth per period ln|mu|: lower limit, upper limit, legend, colour. One hue, from light (weak) to dark (strong).
const CLASSES: [(f64, f64, &str, &str); 4] = [
    (0.0, 0.05, "unstable: ln|μ| per period below 0.05", "#a6cee3"),
    (0.05, 0.2, "0.05 to 0.2", "#4f9bcb"),
    (0.2, 0.5, "0.2 to 0.5", "#0072b2"),
    (0.5, f64::INFINITY, "above 0.5", "#003f6b"),
];

/// The figure of a stability chart.
///
/// # Errors
/// [`PlotError::Nothing`] if it has fewer than two points.
pub fn draw(chart: &Chart) -> Result<Figure, PlotError> {
    if chart.x.values.len() < 2 {
        return Err(PlotError::Nothing { plot: "stability", why: "fewer than two points".into() });
    }
    let panel = match &chart.y {
        None => curve(chart),
        Some(_) => map(chart),
    };
    let refused = chart.rows.iter().flatten().any(Option::is_none);
    let blank = if refused { ", blank: stable or refused" } else { "" };
    Ok(Figure {
        title: "Stability of steady rotation".into(),
        subtitle: Some(format!("{}; Floquet multipliers μ{blank}", chart.scene)),
        x: Axis::linear(chart.x.label(), chart.x.unit.clone()).between(chart.x.low(), chart.x.high()),
        panels: vec![panel],
    })
}

/// A chart over two quantities as a map of the growth where a disturbance grows; `None` for a chart over one.
#[cfg_attr(not(feature = "html"), expect(dead_code, reason = "only pages draw it"))]
pub fn heat(chart: &Chart) -> Option<HeatMap> {
    let y = chart.y.as_ref()?;
    let growth = |spot: &Option<Spot>| spot.filter(|s| s.unstable).map_or(f64::NAN, |s| s.growth);
    Some(HeatMap {
        title: "Stability of steady rotation".into(),
        subtitle: format!("{}; Floquet multipliers μ. Without a colour: stable or refused", chart.scene),
        x: Axis::linear(chart.x.label(), chart.x.unit.clone()),
        y: Axis::linear(y.label(), y.unit.clone()),
        colour: Axis::linear("growth per period ln|μ|", ""),
        marks: Marks::Cells {
            x: edges(&chart.x.values, Scale::Linear),
            y: edges(&y.values, Scale::Linear),
            values: chart.rows.iter().flatten().map(growth).collect(),
        },
    })
}

fn curve(chart: &Chart) -> Panel {
    let growth = chart.rows[0].iter().map(|spot| spot.map_or(f64::NAN, |s| s.growth)).collect();
    let zero = Style { colour: "#777777", dashes: &[], width: 1.0, marker: Marker::None };
    let ends = vec![chart.x.low(), chart.x.high()];
    let line = Series { style: zero, ..Series::new(0, "", ends, vec![0.0, 0.0]) };
    let grows = Series::new(0, "above 0: a disturbance grows", chart.x.values.clone(), growth);
    Panel { y: Axis::linear("growth per period ln|μ|", ""), series: vec![line, grows] }
}

fn map(chart: &Chart) -> Panel {
    let Some(y) = &chart.y else { return curve(chart) };
    let height = (y.high() - y.low()) / (y.values.len().max(2) - 1) as f64;
    let half = 0.5 * (chart.x.high() - chart.x.low()) / (chart.x.values.len() - 1) as f64;
    let width = FRAME / y.values.len() as f64 + 0.6;
    let mut series = vec![];
    for (low, high, label, colour) in CLASSES {
        let within = |spot: &Option<Spot>| spot.is_some_and(|s| s.unstable && s.growth >= low && s.growth < high);
        for (row, at) in chart.rows.iter().zip(&y.values) {
            if !row.iter().any(within) {
                continue;
            }
            let named = series.iter().all(|s: &Series| s.style.colour != colour);
            let style = Style { colour, dashes: &[], width, marker: Marker::None };
            let mut line = Series { style, ..Series::new(0, if named { label } else { "" }, vec![], vec![]) };
            for (x, spot) in chart.x.values.iter().zip(row) {
                let y = if within(spot) { *at } else { f64::NAN };
                line.x.extend([x - half, x + half]);
                line.y.extend([y, y]);
            }
            series.push(line);
        }
    }
    let range = (y.low() - 0.5 * height, y.high() + 0.5 * height);
    Panel { y: Axis::linear(y.label(), y.unit.clone()).between(range.0, range.1), series }
}
