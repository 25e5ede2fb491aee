//! A recorded quantity over the varied ones: a curve over one, a heat map over two.

use super::figure::{Axis, Figure, MARKED, Panel, Scale, Series, Style, extremes};
use super::heat::{HeatMap, Marks, edges};
use super::{Drawn, Marker, PlotError, SweepPlot, SweepResults, symbol};
use crate::model::Model;
use crate::sweep::axis;

/// A plot of `gearsim sweep`.
pub const PLOT: SweepPlot = SweepPlot { name: "map", draw };

/// The colour scale is logarithmic if all values are positive and the largest exceeds the smallest by this factor.
const DECADES: f64 = 1e3;

fn draw(results: &SweepResults<'_>) -> Result<Drawn, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    let layout = results.layout;
    let column = layout.columns.iter().position(|(name, _)| name == results.quantity);
    let column = column.ok_or_else(|| nothing(format!("no `{}` was recorded", results.quantity)))?;
    let unit = &layout.columns[column].1;
    let values: Vec<f64> = results.rows.values().map(|row| row.numbers[column]).collect();
    if !values.iter().any(|v| v.is_finite()) {
        return Err(nothing(format!("no point has a `{}`", results.quantity)));
    }
    let label = label(results.quantity, layout.model);
    let title = first_upper(&label);
    let subtitle = subtitle(results);
    let along: Vec<Vec<f64>> = (0..layout.plan.axes.len()).map(|i| places(results, i)).collect();
    match &along[..] {
        [x] => {
            let mut points: Vec<(f64, f64)> = x.iter().copied().zip(values).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (x, y) = points.into_iter().unzip();
            let mut series = Series { style: Style::PLAIN, ..Series::new(0, "", x, y) };
            if series.x.len() <= MARKED {
                series.style.marker = Marker::Dot;
            }
            let panel = Panel { y: Axis::linear(label, unit), series: vec![series] };
            let x = varied(results, 0);
            Ok(Drawn::Curves(Figure { title, subtitle: Some(subtitle), x, panels: vec![panel] }))
        }
        [x, y] => {
            let (x_axis, y_axis) = (varied(results, 0), varied(results, 1));
            let (least, greatest) = extremes(values.iter().copied());
            let colour = match least > 0.0 && greatest > DECADES * least {
                true => Axis::log10(label, unit),
                false => Axis::linear(label, unit),
            };
            let marks = match layout.plan.is_random() {
                false => cells(x, y, &values, (x_axis.scale, y_axis.scale)),
                true => Marks::Dots { x: x.clone(), y: y.clone(), values },
            };
            Ok(Drawn::Map(Box::new(HeatMap { title, subtitle, x: x_axis, y: y_axis, colour, marks })))
        }
        _ => Err(nothing(format!("{} quantities were varied; a map needs one or two", along.len()))),
    }
}

/// The cells of a grid. Its points are at (`x`, `y`) with `values`, in any order; `along` and `up` are the scales of the two axes.
fn cells(x: &[f64], y: &[f64], values: &[f64], (along, up): (Scale, Scale)) -> Marks {
    let distinct = |v: &[f64]| {
        let mut v = v.to_vec();
        v.sort_by(f64::total_cmp);
        v.dedup();
        v
    };
    let (xs, ys) = (distinct(x), distinct(y));
    let mut grid = vec![f64::NAN; xs.len() * ys.len()];
    let find = |all: &[f64], v: f64| all.partition_point(|other| *other < v);
    for ((x, y), value) in x.iter().zip(y).zip(values) {
        grid[find(&ys, *y) * xs.len() + find(&xs, *x)] = *value;
    }
    Marks::Cells { x: edges(&xs, along), y: edges(&ys, up), values: grid }
}

/// The axis of the varied quantity `i`, in the unit in which it was varied.
pub(super) fn varied(results: &SweepResults<'_>, i: usize) -> Axis {
    let axis = &results.layout.plan.axes[i];
    let (low, high) = extremes(places(results, i).into_iter());
    let name = axis.key.rsplit('.').next().unwrap_or(&axis.key);
    let label = match axis.key.split_once('.') {
        Some(("parameters", name)) => symbol(name),
        Some(("start", name)) => format!("{} at the start", symbol(name)),
        _ if name.parse::<f64>().is_err() && axis.key.matches('.').count() < 2 => name.replace('_', " "),
        _ => axis.key.clone(),
    };
    let unit = if axis.unit.is_empty() { &results.layout.units[i] } else { &axis.unit };
    // Ticks of a logarithmic axis are whole decades: an axis of one decade or less would have too few.
    match axis.is_logarithmic() && high > 10.0 * low {
        true => Axis::log10(label, unit),
        false => Axis::linear(label, unit),
    }
}

/// The value of the varied quantity `i` in each row, in the unit in which it was varied.
pub(super) fn places(results: &SweepResults<'_>, i: usize) -> Vec<f64> {
    let plan = &results.layout.plan;
    let listed = plan.axes[i].unit.is_empty();
    // Values of a list may have different units: convert them to SI.
    let read = if listed { axis::si } else { axis::number };
    results.rows.keys().map(|&point| read(&plan.values(point)[i])).collect()
}

/// The line below the title.
pub(super) fn subtitle(results: &SweepResults<'_>) -> String {
    format!("{}: {} points", results.scene, results.rows.len())
}

/// The name of a recorded column in words.
fn label(column: &str, model: &Model) -> String {
    for coordinate in model.coordinates {
        let Some(rest) = column.strip_prefix(coordinate.name) else { continue };
        let (what, rest) = match rest.strip_prefix("_dot") {
            Some(rest) => (format!("d{}/dt", symbol(coordinate.name)), rest),
            None => (symbol(coordinate.name), rest),
        };
        let words = match rest {
            "" => format!("{what} at the end"),
            "_min" => format!("minimum of {what}"),
            "_max" => format!("maximum of {what}"),
            "_mean" => format!("mean of {what}"),
            "_rms" => format!("rms of {what} about its mean"),
            "_peak_frequency" => format!("frequency of the highest line of {what}"),
            "_peak_density" => format!("density of the highest line of {what}"),
            _ => continue,
        };
        return words;
    }
    for (end, words) in [("_dynamic_factor", "dynamic factor"), ("_kv_iso6336", "K_{v}, ISO 6336-1, method B,")] {
        if let Some(law) = column.strip_suffix(end) {
            return format!("{words} of {law}");
        }
    }
    match column {
        "first_reflection" => "time of the first reflection".into(),
        "t_end" => "time reached".into(),
        "residual" => "energy unaccounted for".into(),
        "dissipated" => "energy lost to damping".into(),
        other => other.replace('_', " "),
    }
}

/// `words` with a capital first letter, unless they begin with a formula (a word with `/`).
fn first_upper(words: &str) -> String {
    let mut letters = words.chars();
    if words.split(' ').next().is_some_and(|first| first.contains('/')) {
        return words.to_owned();
    }
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
