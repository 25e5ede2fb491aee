//! A table of a result as a table of a page.

use crate::output::Table;
use crate::output::table::Values;
use crate::page::html::{Cell, Html};

/// Most rows of a table in a page: more are slow to sort and to scroll.
const MOST: usize = 5000;

/// Writes the first rows of `table`; `file` has all of them.
pub fn fill(html: &mut Html, caption: &str, table: &Table, file: &str) {
    let rows = table.rows();
    if rows > MOST {
        html.note(&format!("{caption}: the first {MOST} of {rows} rows. All rows are in {file}."));
    }
    let head = table.columns().iter().map(|column| match &*column.unit {
        "" | "1" => column.name.clone(),
        unit => format!("{} [{unit}]", column.name),
    });
    let head: Vec<String> = head.collect();
    let cell = |values: &Values, row: usize| match values {
        Values::Number(values) => Cell::Number(values[row]),
        Values::Text(values) => Cell::text(&*values[row]),
    };
    let row = |row| table.columns().iter().map(|column| cell(&column.values, row)).collect();
    let rows: Vec<Vec<Cell>> = (0..rows.min(MOST)).map(row).collect();
    html.table(caption, &head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
}
