//! The page of a run. Each section has one file and one entry in [`SECTIONS`].

mod columns;
mod counts;
mod energy;
mod further;
mod gears;
mod losses;
mod method;
mod motion;
mod numbers;
mod orders;
mod spectrum;
mod view;

use super::html::Html;
use super::shared::rows::{MOST, Rows};
use super::{Page, Parts, shared};
use crate::output::{OutputError, Summary};
use crate::run::Outcome;
use crate::scene::Scene;
use columns::ColumnGroup;
use view::Source;
pub use view::View;

/// The sections, from top to bottom.
const SECTIONS: &[Section] = &[
    Section { id: "method", title: "Result", fill: method::fill },
    Section { id: "motion", title: "Motion", fill: motion::fill },
    Section { id: "orders", title: "Orders", fill: orders::fill },
    Section { id: "further", title: "Run-ups and loads", fill: further::fill },
    Section { id: "gears", title: "Gears", fill: gears::fill },
    Section { id: "energy", title: "Energy", fill: energy::fill },
    Section { id: "spectra", title: "Spectra", fill: spectrum::fill },
    Section { id: "numbers", title: "Numbers", fill: numbers::fill },
    Section { id: "counts", title: "Counts", fill: counts::fill },
    Section { id: "scene", title: "Scene", fill: |report, html| shared::scene::fill(report.run.scene, html) },
    Section { id: "model", title: "Model", fill: |report, html| shared::model::fill(report.run.scene, html) },
    Section { id: "provenance", title: "Provenance", fill: provenance },
];

/// The sections with plots over time. They can show the beginning of a run.
pub const OVER_TIME: [&str; 2] = ["motion", "energy"];

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

/// The data of the sections: the run, its columns, and the rows that the page contains.
struct Report<'a> {
    run: &'a Run<'a>,
    groups: Vec<ColumnGroup<'a>>,
    all: Source<'a>,
    /// The visible curves and rows, which the plots have instead of `all`.
    seen: Option<Source<'a>>,
}

impl<'a> Report<'a> {
    /// The curves that the plots have, and the rows of the curves over time.
    fn plotted(&self) -> &Source<'a> {
        self.seen.as_ref().unwrap_or(&self.all)
    }
}

/// The page of a run. Errors: [`OutputError::Ragged`] if its columns differ in length.
pub fn page(run: &Run<'_>) -> Result<Page, OutputError> {
    filled(run, shared::begin(run.scene), SECTIONS.iter(), None)
}

/// The wanted sections of the page of `gearsim explore`; `None` if `goes_on` ended it. The identifiers of their arrays begin with `name`.
/// If there is a `view`, plots have only its content. The first section is left out, because that page shows the result beside the plots.
/// Errors: those of [`page`].
pub fn live(
    run: &Run<'_>,
    name: String,
    is_wanted: &dyn Fn(&str) -> bool,
    view: Option<&View>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Option<Parts>, OutputError> {
    let wanted = || SECTIONS[1..].iter().filter(|section| is_wanted(section.id));
    let mut whole = true;
    let sections = wanted().take_while(|_| {
        whole = goes_on();
        whole
    });
    let page = filled(run, Page::new(run.scene.name.clone(), "").named(name), sections, view)?;
    let ids = |sections: &mut dyn Iterator<Item = &Section>| sections.map(|section| section.id).collect();
    Ok(whole.then(|| page.parts(ids(&mut SECTIONS.iter()), ids(&mut wanted()))))
}

fn filled<'a>(
    run: &Run<'_>,
    mut page: Page,
    sections: impl Iterator<Item = &'a Section>,
    view: Option<&View>,
) -> Result<Page, OutputError> {
    let trajectory = &run.outcome.trajectory;
    let groups = columns::groups(trajectory)?;
    let all = Source::of(Rows::at_most(MOST, trajectory.len(), trajectory.columns().count()));
    let seen = view.map(|view| Source::seen(view, &trajectory.t));
    let report = Report { run, groups, all, seen };
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
