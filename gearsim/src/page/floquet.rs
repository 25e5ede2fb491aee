//! The page of `gearsim floquet`: the multipliers, and the stability chart with its table.

use super::Page;
use super::html::Cell;
use super::shared::{self, Made, figure, heat, table};
use crate::analysis::floquet::{Chart, Floquet};
use crate::output::{OutputError, Table};
use crate::plot;

/// The page of the stability of a scene; `words` are its results in words, `chart` its chart and the table of that. Errors: none.
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
        let row = |z: &nalgebra::Complex<f64>| [z.re, z.im, z.norm(), z.arg()].map(Cell::Number).to_vec();
        let rows: Vec<Vec<Cell>> = floquet.multipliers.iter().map(row).collect();
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
