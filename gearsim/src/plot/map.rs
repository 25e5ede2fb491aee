//! A recorded quantity over the one or two that were varied: a curve, or a map in colours.

use super::figure::{Axis, Figure, Panel, Scale, Series, Style, extremes};
use super::heat::{Heat, Marks, edges};
use super::{Picture, PlotError, Study, SweepPlot, symbol};
use crate::model::Model;
use crate::sweep::axis;

/// Its entry in the registry.
pub const PLOT: SweepPlot =
    SweepPlot { name: "map", doc: "a recorded quantity over the one or two that were varied", draw };

/// Greatest over least value from which colours show logarithms, if all values are positive.
const DECADES: f64 = 1e3;

fn draw(study: &Study<'_>) -> Result<Picture, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    let layout = study.layout;
    let column = layout.columns.iter().position(|(name, _)| name == study.quantity);
    let column = column.ok_or_else(|| nothing(format!("no `{}` was recorded", study.quantity)))?;
    let unit = &layout.columns[column].1;
    let values: Vec<f64> = study.rows.values().map(|row| row.numbers[column]).collect();
    if !values.iter().any(|v| v.is_finite()) {
        return Err(nothing(format!("no point has a `{}`", study.quantity)));
    }
    let label = label(study.quantity, layout.model);
    let title = first_upper(&label);
    let subtitle = subtitle(study);
    let along: Vec<Vec<f64>> = (0..layout.plan.axes.len()).map(|i| places(study, i)).collect();
    match &along[..] {
        [x] => {
            let mut points: Vec<(f64, f64)> = x.iter().copied().zip(values).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (x, y) = points.into_iter().unzip();
            let series = Series { style: Style::PLAIN, ..Series::new(0, "", x, y) };
            let panel = Panel { y: Axis::linear(label, unit), series: vec![series] };
            let figure = Figure { title, subtitle: Some(subtitle), x: varied(study, 0), panels: vec![panel] };
            figure.picture()
        }
        [x, y] => {
            let (x_axis, y_axis) = (varied(study, 0), varied(study, 1));
            let (least, greatest) = extremes(values.iter().copied());
            let colour = match least > 0.0 && greatest > DECADES * least {
                true => Axis::log10(label, unit),
                false => Axis::linear(label, unit),
            };
            let marks = match layout.plan.is_random() {
                false => cells(x, y, &values, (x_axis.scale, y_axis.scale)),
                true => Marks::Dots { x: x.clone(), y: y.clone(), values },
            };
            Ok(Heat { title, subtitle, x: x_axis, y: y_axis, colour, marks }.picture())
        }
        _ => Err(nothing(format!("{} quantities were varied; it is over one or two", along.len()))),
    }
}

/// The values of a grid whose points lie at `x` and `y`, in ascending order of both.
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
pub(super) fn varied(study: &Study<'_>, i: usize) -> Axis {
    let axis = &study.layout.plan.axes[i];
    let (low, high) = extremes(places(study, i).into_iter());
    let name = axis.key.rsplit('.').next().unwrap_or(&axis.key);
    let label = match axis.key.split_once('.') {
        Some(("parameters", name)) => symbol(name),
        Some(("start", name)) => format!("{} at the start", symbol(name)),
        _ if name.parse::<f64>().is_err() && axis.key.matches('.').count() < 2 => name.replace('_', " "),
        _ => axis.key.clone(),
    };
    let unit = if axis.unit.is_empty() { &study.layout.units[i] } else { &axis.unit };
    // Within a decade there are no numbers to put on a logarithmic axis.
    match axis.is_logarithmic() && high > 10.0 * low {
        true => Axis::log10(label, unit),
        false => Axis::linear(label, unit),
    }
}

/// The varied quantity `i` at each row, in the unit in which it was varied.
pub(super) fn places(study: &Study<'_>, i: usize) -> Vec<f64> {
    let plan = &study.layout.plan;
    let listed = plan.axes[i].unit.is_empty();
    // A list may have a unit each; SI holds for all.
    let read = if listed { axis::si } else { axis::number };
    study.rows.keys().map(|&point| read(&plan.values(point)[i])).collect()
}

/// What stands below the title.
pub(super) fn subtitle(study: &Study<'_>) -> String {
    format!("{}: {} points", study.scene, study.rows.len())
}

/// A recorded column in words.
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
    match column {
        "first_reflection" => "time of the first reflection".into(),
        "t_end" => "time reached".into(),
        "residual" => "energy unaccounted for".into(),
        "dissipated" => "energy lost to damping".into(),
        other => other.replace('_', " "),
    }
}

/// With a capital letter, unless it begins with a formula.
fn first_upper(words: &str) -> String {
    let mut letters = words.chars();
    if words.split(' ').next().is_some_and(|first| first.contains('/')) {
        return words.to_owned();
    }
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
