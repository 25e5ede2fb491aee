//! A figure as interactive plots, one per panel, with common limits of x and a common cursor.

use super::rows::{MOST, Rows};
use crate::page::data::Counts;
use crate::page::html::Html;
use crate::page::plot::{Axis, Colour, PageCurve, Plot, Style};
use crate::plot::{self, Figure, Marker, Scale};

/// Number of colours of curves, in figures and in pages.
const COLOURS: usize = 7;

/// Writes the plots of `figure`; `group` is a name that no other figure of the page has.
pub fn fill(html: &mut Html, group: &str, figure: &Figure) {
    html.heading(&figure.title);
    html.paragraph(figure.subtitle.as_deref().unwrap_or(""));
    let series = || figure.panels.iter().flat_map(|panel| &panel.series);
    let longest = series().map(|series| series.x.len()).max().unwrap_or(0);
    let rows = Rows::at_most(MOST, longest, 2 * series().count());
    if rows.every > 1 {
        html.note(&format!("The plots have the extremes over every {} rows.", rows.every));
    }
    for panel in &figure.panels {
        if !panel.series.iter().any(has_points) {
            continue;
        }
        let curves = curves(html, figure, panel, &rows);
        html.plot(&Plot {
            title: panel.y.label.clone(),
            x: axis(&figure.x, figure.x.label.clone()),
            y: axis(&panel.y, String::new()),
            curves,
            group: Some(group.to_owned()),
            events: None,
            lines: vec![],
            shaded_from: figure.x.shaded_from,
            square: false,
        });
    }
}

/// The curves of a panel. A panel without a legend has that of the first panel.
fn curves(html: &mut Html, figure: &Figure, panel: &plot::Panel, rows: &Rows) -> Vec<PageCurve> {
    let mut curves: Vec<PageCurve> = vec![];
    let legend = if panel.series.iter().all(|series| series.label.is_empty()) { &figure.panels[0] } else { panel };
    for (i, series) in panel.series.iter().enumerate() {
        let style = style(series.style);
        let name = legend.series.get(i).map_or("", |series| &series.label);
        // A curve without a name belongs to the named curve of the same colour.
        let of_its_colour = |curve: &PageCurve| curve.style.as_ref().is_some_and(|other| other.colour == style.colour);
        let with = curves.iter().rposition(|curve| !curve.name.is_empty() && of_its_colour(curve));
        let (x, y) = points(series, &figure.x, &panel.y);
        let x = html.embed(&rows.times(&x), Counts::Long);
        let y = html.embed(&rows.values(&y), Counts::Short);
        let mut curve = PageCurve::new(name, "", x, y, true);
        curve.with = with.filter(|_| name.is_empty());
        curve.style = Some(style);
        curve.note = Some(series.note.clone()).filter(|note| !note.text.is_empty());
        curves.push(curve);
    }
    curves
}

fn has_points(series: &plot::Series) -> bool {
    series.x.iter().zip(&series.y).any(|(x, y)| x.is_finite() && y.is_finite())
}

/// The points of a curve in rising order of x, as logarithms where an axis is logarithmic. A point whose x is not finite makes a gap after
/// the point before it.
fn points(series: &plot::Series, x: &plot::Axis, y: &plot::Axis) -> (Vec<f64>, Vec<f64>) {
    let on = |axis: &plot::Axis, value: f64| if axis.scale == Scale::Log10 { value.log10() } else { value };
    let mut points: Vec<(f64, f64)> = vec![];
    for (&a, &b) in series.x.iter().zip(&series.y) {
        let (a, b) = (on(x, a), on(y, b));
        match points.last() {
            _ if a.is_finite() => points.push((a, b)),
            Some(&(before, _)) => points.push((before, f64::NAN)),
            None => {}
        }
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.into_iter().unzip()
}

/// The axis of a page for an axis of a figure, with another `label`.
pub(super) fn axis(axis: &plot::Axis, label: String) -> Axis {
    Axis {
        log: axis.scale == Scale::Log10,
        range: axis.range,
        names: axis.names.clone(),
        ..Axis::linear(label, axis.unit.clone())
    }
}

fn style(style: plot::Style) -> Style {
    let known = (0..COLOURS).find(|&i| plot::Style::nth(i).colour == style.colour);
    let dashes: Vec<_> = style.dashes.iter().map(|length| format!("{length}px")).collect();
    Style {
        colour: known.map_or(Colour::Fixed(style.colour), Colour::Curve),
        dash: if dashes.is_empty() { "solid".into() } else { dashes.join(",") },
        width: style.width,
        marker: match style.marker {
            Marker::None => None,
            Marker::Dot => Some("circle"),
            Marker::Square => Some("square"),
            Marker::Diamond => Some("diamond"),
            Marker::Triangle => Some("triangle-up"),
            Marker::Cross => Some("x-thin-open"),
        },
    }
}
