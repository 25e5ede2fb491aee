//! The page of a run. Each section has one file and one entry in [`SECTIONS`].

mod columns;
mod counts;
mod energy;
mod gears;
mod losses;
mod method;
mod motion;
mod numbers;
mod orders;
mod spectrum;

use std::cell::OnceCell;

use super::html::Html;
use super::shared::rows::Rows;
use super::{Page, Parts, shared};
use crate::output::{OutputError, Summary, Table};
use crate::run::Outcome;
use crate::scene::Scene;
use columns::Group;

/// The sections, from top to bottom.
const SECTIONS: &[Section] = &[
    Section { id: "method", title: "Result", fill: method::fill },
    Section { id: "motion", title: "Motion", fill: motion::fill },
    Section { id: "gears", title: "Gears", fill: gears::fill },
    Section { id: "energy", title: "Energy", fill: energy::fill },
    Section { id: "spectra", title: "Spectra", fill: spectrum::fill },
    Section { id: "orders", title: "Orders", fill: orders::fill },
    Section { id: "numbers", title: "Numbers", fill: numbers::fill },
    Section { id: "counts", title: "Counts", fill: counts::fill },
    Section { id: "scene", title: "Scene", fill: |report, html| shared::scene::fill(report.run.scene, html) },
    Section { id: "model", title: "Model", fill: |report, html| shared::model::fill(report.run.scene, html) },
    Section { id: "provenance", title: "Provenance", fill: provenance },
];

/// A section of the page of a run.
struct Section {
    id: &'static str,
    title: &'static str,
    /// Writes it; a section in which it writes nothing is left out.
    fill: fn(&Report<'_>, &mut Html),
}

/// What the page of a run shows.
pub struct Run<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The outcome.
    pub outcome: &'a Outcome,
    /// Its summary.
    pub summary: &'a Summary,
}

/// What sections are made of: the run, the columns of its table, and the rows that the page has of them.
struct Report<'a> {
    run: &'a Run<'a>,
    groups: Vec<Group<'a>>,
    rows: Rows,
    /// The times of the rows and of the events, once a plot has them.
    times: OnceCell<motion::Times>,
}

/// The page of a run. Errors: [`OutputError::Ragged`] if its columns differ in length.
pub fn page(run: &Run<'_>) -> Result<Page, OutputError> {
    filled(run, shared::begin(run.scene), SECTIONS.iter())
}

/// The wanted sections of a page that shows run after run, whose arrays have identifiers that begin with `name`; `None` if `goes_on` ended
/// it. Without the first section: `gearsim explore` shows the result beside the plots. Errors: as of [`page`].
pub fn live(
    run: &Run<'_>,
    name: String,
    is_wanted: &dyn Fn(&str) -> bool,
    goes_on: &dyn Fn() -> bool,
) -> Result<Option<Parts>, OutputError> {
    let wanted = || SECTIONS[1..].iter().filter(|section| is_wanted(section.id));
    let mut whole = true;
    let sections = wanted().take_while(|_| {
        whole = goes_on();
        whole
    });
    let page = filled(run, Page::new(run.scene.name.clone(), "").named(name), sections)?;
    let ids = |sections: &mut dyn Iterator<Item = &Section>| sections.map(|section| section.id).collect();
    Ok(whole.then(|| page.parts(ids(&mut SECTIONS.iter()), ids(&mut wanted()))))
}

fn filled<'a>(run: &Run<'_>, mut page: Page, sections: impl Iterator<Item = &'a Section>) -> Result<Page, OutputError> {
    let table = Table::of_trajectory(&run.outcome.trajectory)?;
    let rows = Rows::of(&table);
    let groups = columns::groups(&run.outcome.trajectory, &table);
    let report = Report { run, groups, rows, times: OnceCell::new() };
    for section in sections {
        page.section(section.id, section.title, |html| (section.fill)(&report, html));
    }
    Ok(page)
}

/// Writes the section of the provenance.
fn provenance(report: &Report<'_>, html: &mut Html) {
    let summary = report.run.summary;
    shared::provenance::fill(&summary.provenance, &summary.files, html);
}
