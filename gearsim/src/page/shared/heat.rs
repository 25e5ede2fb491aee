//! A heat map as an interactive map.

use super::figure::axis;
use crate::page::data::Counts;
use crate::page::html::Html;
use crate::page::plot::Map;
use crate::plot::heat::{HeatMap, Marks};
use crate::plot::{Axis, Scale};

/// Writes the map of `heat`.
pub fn fill(html: &mut Html, heat: &HeatMap) {
    let (Marks::Cells { x, y, values } | Marks::Dots { x, y, values }) = &heat.marks;
    let mut embed = |values: &[f64], axis: &Axis, counts| {
        let on = |x: &f64| if axis.scale == Scale::Log10 { x.log10() } else { *x };
        html.embed(&values.iter().map(on).collect::<Vec<_>>(), counts)
    };
    let across = embed(x, &heat.x, Counts::Long);
    let up = embed(y, &heat.y, Counts::Long);
    let embedded = embed(values, &heat.colour, Counts::Short);
    html.heading(&heat.title);
    html.paragraph(&heat.subtitle);
    html.map(&Map {
        title: heat.colour.label.clone(),
        x: axis(&heat.x, heat.x.label.clone()),
        y: axis(&heat.y, heat.y.label.clone()),
        colour: axis(&heat.colour, heat.colour.label.clone()),
        cells: matches!(heat.marks, Marks::Cells { .. }),
        across,
        up,
        values: embedded,
    });
}
