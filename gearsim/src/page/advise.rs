//! The page of `gearsim advise`: the conclusions, how far each candidate deviates, and the table of the deviations.

use super::Page;
use super::shared::{self, Made, figure, table};
use crate::output::{OutputError, Table};
use crate::plot::Figure;

/// The results of an advice.
pub struct Advice<'a> {
    /// The conclusions: names and texts.
    pub conclusions: &'a [(String, String)],
    /// The deviation of each candidate; `None` if no candidate has one.
    pub drawn: Option<&'a Figure>,
    /// The deviations of each candidate, estimated and from runs.
    pub deviations: &'a Table,
}

/// The page of an advice. Errors: none.
pub fn page(made: &Made<'_>, advice: &Advice<'_>) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("result", "Result", |html| {
        html.pairs(advice.conclusions.iter().map(|(name, text)| (name, text)));
        if let Some(drawn) = advice.drawn {
            figure::fill(html, "deviations", drawn);
        }
    });
    page.section("deviations", "Deviations", |html| {
        table::fill(html, "Deviations without an effect", advice.deviations, "advise.json");
    });
    shared::end(&mut page, made);
    Ok(page)
}
