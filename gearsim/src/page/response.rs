//! The page of `gearsim response`: the curves upward and downward, and the table of the points.

use super::Page;
use super::shared::{self, Made, figure, table};
use crate::output::{OutputError, Table};
use crate::plot::Figure;

/// The page of a response; `facts` are names and words of its results, `points` its table. Errors: none.
pub fn page(
    made: &Made<'_>,
    facts: &[(String, String)],
    drawn: Option<&Figure>,
    points: &Table,
) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("result", "Result", |html| {
        html.pairs(facts.iter().map(|(name, says)| (name, says)));
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
