//! Response curves: a measure of each output over the varied value, upward and downward.

use super::figure::MARKED;
use super::outputs;
use super::{Axis, Figure, Marker, Panel, Series};
use crate::sweep::response::{Measure, ResponseCurve, ResponsePoint, measure};
use crate::sweep::row::Status;

/// The figure of a response; `measured` is the measure that is drawn, for the outputs that have it.
pub fn figure(scene: &str, response: &ResponseCurve, measured: Measure) -> Figure {
    let (unit, scale) = response.shown_unit();
    let is_sparse = response.points.len() <= MARKED;
    let curve = |i: usize, measure: Measure, upward: bool| {
        let points = response.points.iter().filter(|point| point.upward == upward && point.status == Status::Done);
        let place = |point: &ResponsePoint| (scale * point.value, (measure.value)(point, i));
        let mut points: Vec<(f64, f64)> = points.map(place).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.into_iter().unzip()
    };
    let outputs = response.outputs.iter().enumerate().filter(|(_, output)| (measured.is_of)(response.model, output));
    let panels = outputs.map(|(i, output)| {
        let way = |n: usize, label: &str, upward: bool| {
            let (x, y) = curve(i, measured, upward);
            let mut series = Series::new(n, label, x, y);
            if is_sparse {
                series.style.marker = [Marker::Dot, Marker::Square][n];
            }
            series
        };
        let both = response.points.iter().any(|point| !point.upward);
        let series = [("upward", true), ("downward", false)].into_iter().filter(|(_, upward)| *upward || both);
        let mut series = series.enumerate().map(|(n, (label, upward))| way(n, label, upward)).collect::<Vec<_>>();
        let beside = measured.beside.and_then(|(name, words)| Some((measure(name)?, words)));
        let beside = beside.map(|(beside, words)| (curve(i, beside, true), words));
        if let Some(((x, y), words)) = beside.filter(|((_, y), _): &((_, Vec<f64>), _)| y.iter().any(|y| y.is_finite()))
        {
            series.push(Series::new(2, words, x, y));
        }
        let shown = outputs::scale(&mut series, measured.unit(output));
        let words = measured.name.replace('_', " ");
        Panel { y: Axis::linear(format!("{} {words}", output.name), shown), series }
    });
    Figure {
        title: "Response".into(),
        subtitle: Some(format!("{scene}; each point from the settled state before it")),
        panels: panels.collect(),
        x: Axis::linear(response.words.clone(), unit),
    }
}
