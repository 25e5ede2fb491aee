//! Response curves: a measure of each output over the varied value, upward and downward.

use super::outputs;
use super::{Axis, Figure, Marker, Panel, Series};
use crate::sweep::response::{MEASURES, Response};
use crate::sweep::row::Status;

/// Most points that have a marker each: those of more would touch.
const MARKED: usize = 250;

/// The figure of a response; `measure` is the name of one of [`MEASURES`].
pub fn figure(scene: &str, response: &Response, measure: &str) -> Figure {
    let value = MEASURES.iter().find(|(name, _)| *name == measure).map_or(MEASURES[1].1, |(_, value)| *value);
    let (unit, scale) = response.shown_unit();
    let is_sparse = response.points.len() <= MARKED;
    let panels = response.outputs.iter().enumerate().map(|(i, output)| {
        let way = |n: usize, label: &str, upward: bool| {
            let points = response.points.iter().filter(|point| point.upward == upward && point.status == Status::Done);
            let mut points: Vec<(f64, f64)> =
                points.map(|point| (scale * point.value, point.observed[i].as_ref().map_or(f64::NAN, value))).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (x, y) = points.into_iter().unzip();
            let mut series = Series::new(n, label, x, y);
            if is_sparse {
                series.style.marker = [Marker::Dot, Marker::Square][n];
            }
            series
        };
        let both = response.points.iter().any(|point| !point.upward);
        let series = [("upward", true), ("downward", false)].into_iter().filter(|(_, upward)| *upward || both);
        let mut series = series.enumerate().map(|(n, (label, upward))| way(n, label, upward)).collect::<Vec<_>>();
        let shown = outputs::scale(&mut series, output.unit);
        let words = measure.replace('_', " ");
        Panel { y: Axis::linear(format!("{} {words}", output.name), shown), series }
    });
    Figure {
        title: "Response".into(),
        subtitle: Some(format!("{scene}; each point from the settled state before it")),
        panels: panels.collect(),
        x: Axis::linear(response.words.clone(), unit),
    }
}
