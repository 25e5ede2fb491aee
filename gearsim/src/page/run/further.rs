//! The plots of the scene that have no section of their own: order cuts, waterfalls, run-ups, load spectra.

use super::Report;
use crate::page::html::Html;
use crate::page::shared::figure;
use crate::plot;

/// Plots whose content other sections show.
const SHOWN: [&str; 5] = ["outputs", "motion", "orders", "energy", "spectrum"];

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let (scene, outcome) = (report.run.scene, report.run.outcome);
    let run = plot::Run::of(scene, outcome);
    for name in scene.output.plots.iter().filter(|name| !SHOWN.contains(&name.as_ref())) {
        match plot::find(name).and_then(|plot| (plot.draw)(&[run])) {
            Ok(drawn) => figure::fill(html, name, &drawn),
            Err(error) => html.note(&format!("There is no plot {name}: {error}.")),
        }
    }
}
