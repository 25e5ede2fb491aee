//! A table of a result as a table of a page.

use crate::output::Table;
use crate::output::table::{Column, Values};
use crate::output::unit::readable;
use crate::page::html::{Html, TableCell};

/// Most rows of a table in a page: more are slow to sort and to scroll.
const MOST: usize = 5000;

/// The unit in which people read a column, and the factor to it. Speeds of coordinates are not those of rotors, and stay in rad/s.
fn shown_unit(column: &Column) -> (&str, f64) {
    let Values::Number(values) = &column.values else { return (&column.unit, 1.0) };
    if column.unit == "rad/s" && !["rotor_speed", "start.", "mean_speed"].iter().any(|of| column.name.starts_with(of)) {
        return (&column.unit, 1.0);
    }
    let largest = values.iter().filter(|x| x.is_finite()).fold(0.0, |most: f64, x| most.max(x.abs()));
    readable(&column.unit, largest)
}

#[test]
fn columns_are_in_the_units_of_the_plots() {
    let mut table = Table::default();
    for (name, unit, value) in [("mean_speed", "rad/s", 10.0), ("phi_dot_max", "rad/s", 10.0), ("dte_rms", "m", 2e-6)] {
        table.push(name, unit, Values::Number(vec![value, f64::NAN])).unwrap();
    }
    let mut html = Html::default();
    fill(&mut html, "Points", &table, "points.csv");
    for shown in ["mean_speed [rpm]", ">95.49<", "phi_dot_max [rad/s]", "dte_rms [um]", ">2<"] {
        assert!(html.text().contains(shown), "{shown}: {}", html.text());
    }
}

/// Writes the first rows of `table`; `file` has all of them, in SI units.
pub fn fill(html: &mut Html, caption: &str, table: &Table, file: &str) {
    let rows = table.rows();
    if rows > MOST {
        html.note(&format!("{caption}: the first {MOST} of {rows} rows. All rows are in {file}."));
    }
    let units: Vec<(&str, f64)> = table.columns().iter().map(shown_unit).collect();
    let head = table.columns().iter().zip(&units).map(|(column, (unit, _))| match *unit {
        "" | "1" => column.name.clone(),
        unit => format!("{} [{unit}]", column.name),
    });
    let head: Vec<String> = head.collect();
    let cell = |values: &Values, factor: f64, row: usize| match values {
        Values::Number(values) => TableCell::Number(factor * values[row]),
        Values::Text(values) => TableCell::text(&*values[row]),
    };
    let cells = |row| table.columns().iter().zip(&units).map(move |(column, unit)| cell(&column.values, unit.1, row));
    let row = |row| cells(row).collect();
    let rows: Vec<Vec<TableCell>> = (0..rows.min(MOST)).map(row).collect();
    html.table(caption, &head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
}
