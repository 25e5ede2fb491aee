//! The page of `gearsim compare`: the runs side by side, in numbers and in the scene's plots.

use super::Page;
use super::html::TableCell;
use super::shared::{self, Made, figure};
use crate::output::{OutputError, Summary};
use crate::plot::outputs::quantities::{Quantity, quantities};
use crate::plot::{self, Run};

/// The page of runs of one scene under several sets of equations, with their summaries. Errors: none.
pub fn page(made: &Made<'_>, runs: &[Run<'_>], summaries: &[Summary]) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    let labels: Vec<&str> = runs.iter().map(|run| run.label).collect();
    page.section("result", "Result", |html| {
        for (label, summary) in labels.iter().zip(summaries) {
            if let Some(why) = &summary.stopped_by {
                html.note(&format!("The {label} run stopped early: {why}"));
            }
            if let Some(refuted) = &summary.refuted {
                html.note(&format!("The energy account of the {label} run does not close: {refuted}"));
            }
            for remark in &summary.remarks {
                html.note(&format!("The {label} run: {remark}"));
            }
        }
        let head: Vec<&str> = ["quantity", "unit"].into_iter().chain(labels.iter().copied()).collect();
        html.table("The runs side by side", &head, &rows(runs, summaries));
        let method = |(label, summary): (&&str, &Summary)| {
            let effects = format!("effects {}", summary.effects.join(", "));
            ((*label).to_owned(), format!("{}: {}; {effects}", summary.method.name, summary.method.why))
        };
        html.pairs(labels.iter().zip(summaries).map(method));
    });
    page.section("plots", "Plots", |html| {
        for name in &plot::compared(runs) {
            match plot::find(name).and_then(|plot| (plot.draw)(runs)) {
                Ok(drawn) => figure::fill(html, name, &drawn),
                Err(error) => html.note(&format!("There is no plot {name}: {error}.")),
            }
        }
    });
    shared::end(&mut page, made);
    Ok(page)
}

/// One row per quantity, one column per run.
fn rows(runs: &[Run<'_>], summaries: &[Summary]) -> Vec<Vec<TableCell>> {
    let mut rows = vec![];
    let mut add = |name: &str, unit: &str, values: Vec<f64>| {
        rows.push(
            [TableCell::text(name), TableCell::text(unit)]
                .into_iter()
                .chain(values.into_iter().map(TableCell::Number))
                .collect(),
        );
    };
    let of = |value: &dyn Fn(&Summary) -> f64| summaries.iter().map(value).collect::<Vec<_>>();
    add("simulated", "s", of(&|s| s.t_end.0));
    add("cell changes", "", of(&|s| s.cell_changes as f64));
    add("reflections", "", of(&|s| s.reflections as f64));
    add("energy at the start", "J", of(&|s| s.energy.at_start.0));
    add("kinetic energy at the end", "J", of(&|s| s.energy.kinetic.0));
    add("strain energy at the end", "J", of(&|s| s.energy.strain.0));
    add("work", "J", of(&|s| s.energy.work.0));
    add("lost", "J", of(&|s| s.energy.dissipated.0));
    add("unaccounted for", "J", of(&|s| s.energy.residual.0));
    let part = |s: &Summary| (s.energy.residual.0 / s.energy.at_start.0).abs();
    add("unaccounted for, over the energy at the start", "", of(&part));
    for Quantity { name, unit, values } in quantities(runs, summaries) {
        add(&name, &unit, values);
    }
    add("processor time", "s", of(&|s| s.cpu_seconds.0));
    rows
}
