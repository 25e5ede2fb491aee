//! The page of `gearsim compare`: the runs side by side, in numbers and in the scene's plots.

use super::Page;
use super::html::Cell;
use super::shared::{self, Made, figure};
use crate::model::Output;
use crate::output::summary::{Number, Observed};
use crate::output::{OutputError, Summary};
use crate::plot::outputs::{compared, engineering};
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
        }
        let head: Vec<&str> = ["quantity", "unit"].into_iter().chain(labels.iter().copied()).collect();
        html.table("The runs side by side", &head, &quantities(made, runs, summaries));
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

/// One row a quantity, one column a run.
fn quantities(made: &Made<'_>, runs: &[Run<'_>], summaries: &[Summary]) -> Vec<Vec<Cell>> {
    let mut rows = vec![];
    let mut add = |name: &str, unit: &str, value: &dyn Fn(&Summary) -> f64| {
        let numbers = summaries.iter().map(|summary| Cell::Number(value(summary)));
        rows.push([Cell::text(name), Cell::text(unit)].into_iter().chain(numbers).collect());
    };
    add("simulated", "s", &|s| s.t_end.0);
    add("cell changes", "", &|s| s.cell_changes as f64);
    add("reflections", "", &|s| s.reflections as f64);
    add("energy at the start", "J", &|s| s.energy.at_start.0);
    add("kinetic energy at the end", "J", &|s| s.energy.kinetic.0);
    add("strain energy at the end", "J", &|s| s.energy.strain.0);
    add("work", "J", &|s| s.energy.work.0);
    add("lost", "J", &|s| s.energy.dissipated.0);
    add("unaccounted for", "J", &|s| s.energy.residual.0);
    add("unaccounted for, over the energy at the start", "", &|s| (s.energy.residual.0 / s.energy.at_start.0).abs());
    let all: Vec<&Output> = runs.first().map_or(vec![], |run| run.trajectory.outputs.iter().map(|(o, _)| *o).collect());
    for output in compared::first(&all) {
        let (unit, scale) = engineering(output.unit);
        let of = |s: &Summary, value: fn(&Observed) -> Number| {
            s.outputs.get(output.name).map_or(f64::NAN, |observed| scale * value(observed).0)
        };
        add(&format!("{}, mean", output.name), unit, &|s| of(s, |observed| observed.mean));
        add(&format!("{}, root mean square about the mean", output.name), unit, &|s| of(s, |observed| observed.rms));
    }
    for coordinate in made.scene.model.coordinates {
        let speed = format!("{}_dot", coordinate.name);
        let at_end = |name: &str, s: &Summary| s.state.get(name).unwrap_or(f64::NAN);
        add(&format!("{} at the end", coordinate.name), coordinate.unit, &|s| at_end(coordinate.name, s));
        add(&format!("{speed} at the end"), &format!("{}/s", coordinate.unit), &|s| at_end(&speed, s));
    }
    add("processor time", "s", &|s| s.cpu_seconds.0);
    rows
}
