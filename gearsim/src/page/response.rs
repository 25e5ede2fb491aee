//! The page of `gearsim response`: the curves upward and downward, and the table of the points.

use super::Page;
use super::shared::{self, Made, figure, table};
use crate::output::{OutputError, Table};
use crate::plot::Figure;

/// The page of a response; `words` are its results in words, `points` its table. Errors: none.
pub fn page(made: &Made<'_>, words: &str, drawn: Option<&Figure>, points: &Table) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("result", "Result", |html| {
        html.lines(words);
        if let Some(drawn) = drawn {
            figure::fill(html, "response", drawn);
        }
    });
    page.section("points", "Points", |html| {
        table::fill(html, "Points in the order in which they were run", points, "response.csv");
        html.paragraph("The scene and its parameters below are those of the first point.");
    });
    shared::end(&mut page, made);
    Ok(page)
}
