//! The page of `gearsim floquet`: the multipliers, and the stability chart with its table.

use super::Page;
use super::data::Counts;
use super::html::{Html, TableCell};
use super::plot::{Axis, Colour, PageCurve, Plot, Style};
use super::shared::{self, Made, figure, heat, table};
use crate::analysis::floquet::{Chart, Floquet};
use crate::output::{OutputError, Table};
use crate::plot;

/// Points of each half of the unit circle.
const HALF: usize = 200;

/// Draws the multipliers in the complex plane, with the unit circle: beyond it a disturbance grows.
fn plane(html: &mut Html, floquet: &Floquet) {
    if floquet.multipliers.is_empty() {
        return;
    }
    let mut points: Vec<(f64, f64)> = floquet.multipliers.iter().map(|z| (z.re, z.im)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let reach = 1.15 * floquet.multipliers.iter().map(|z| z.norm()).fold(1.0, f64::max);
    let half = |sign: f64| -> Vec<(f64, f64)> {
        let at = |i: usize| std::f64::consts::PI * (1.0 - i as f64 / HALF as f64);
        (0..=HALF).map(at).map(|angle| (angle.cos(), sign * angle.sin())).collect()
    };
    let circle = Style { colour: Colour::Curve(2), dash: "solid".into(), width: 1.0, marker: None };
    let dots = Style { colour: Colour::Curve(0), dash: "solid".into(), width: 0.0, marker: Some("circle") };
    let mut curve = |name: &str, doc: &str, points: &[(f64, f64)], style: &Style, with| {
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        let (x, y) = (html.embed(&x, Counts::Short), html.embed(&y, Counts::Short));
        PageCurve { style: Some(style.clone()), with, ..PageCurve::new(name, doc, x, y, true) }
    };
    let curves = vec![
        curve("unit circle", "a disturbance whose multiplier is beyond it grows", &half(1.0), &circle, None),
        curve("", "", &half(-1.0), &circle, Some(0)),
        curve("multipliers", "one or two a vibration", &points, &dots, None),
    ];
    let axis = |label: &str| Axis { range: Some((-reach, reach)), ..Axis::linear(label, "") };
    html.plot(&Plot {
        title: "Floquet multipliers in the complex plane".into(),
        x: axis("real part"),
        y: axis("imaginary part"),
        curves,
        group: Some("multipliers".into()),
        events: None,
        lines: vec![],
        shaded_from: None,
        square: true,
    });
}

/// The page of the stability of a scene; `words` are its results in words, `chart` is its chart with the table of the chart's points.
/// Errors: none.
pub fn page(
    made: &Made<'_>,
    words: &str,
    floquet: &Floquet,
    chart: Option<(&Chart, &Table)>,
) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("result", "Result", |html| {
        let left_out = made.scene.left_out_if_linear();
        if !left_out.is_empty() {
            html.note(&format!("Left out, because the analysis is linear: {}.", left_out.join(", ")));
        }
        html.lines(words);
        let row = |z: &nalgebra::Complex<f64>| [z.re, z.im, z.norm(), z.arg()].map(TableCell::Number).to_vec();
        let rows: Vec<Vec<TableCell>> = floquet.multipliers.iter().map(row).collect();
        plane(html, floquet);
        html.table("Floquet multipliers", &["real", "imaginary", "absolute value", "angle [rad]"], &rows);
    });
    if let Some((chart, points)) = chart {
        let chart = chart.clone().by_ratio();
        page.section("chart", "Chart", |html| match plot::floquet::heat(&chart) {
            Some(map) => heat::fill(html, &map),
            None => {
                if let Ok(drawn) = plot::floquet::draw(&chart) {
                    figure::fill(html, "stability", &drawn);
                }
            }
        });
        page.section("points", "Points", |html| table::fill(html, "Points of the chart", points, "stability.csv"));
    }
    shared::end(&mut page, made);
    Ok(page)
}
