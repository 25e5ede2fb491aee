//! The result of the run, the method that solved it, and the notes that a reader must see.

use super::Report;
use crate::output::number::{short, time};
use crate::output::summary::{Mesh, Observed};
use crate::output::unit::readable;
use crate::page::html::{Html, TableCell};

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let (scene, summary) = (report.run.scene, report.run.summary);
    if let Some(why) = &summary.stopped_by {
        html.note(&format!("The run stopped early: {why}"));
    }
    for remark in &summary.remarks {
        html.note(remark);
    }
    let effects = match &summary.effects[..] {
        [] => "none".to_owned(),
        effects => effects.join(", "),
    };
    let method = format!("{}: {}", summary.method.name, summary.method.why);
    let loss = |(name, observed): (&String, &Observed)| {
        name.starts_with("contact_loss")
            .then(|| (name.clone(), format!("{} % of the time", short(100.0 * observed.mean.0))))
    };
    html.pairs([
        ("model", format!("{}, {}", scene.model.name, scene.model.title)),
        ("effects", effects),
        ("method", method),
        ("solver", summary.provenance.solver.clone()),
        ("simulated", format!("{} s of {} s", short(summary.t_end.0), short(scene.t_end))),
        ("end state", summary.state_in_words(scene.model)),
        ("digits left", digits(report)),
        ("processor time", time(summary.cpu_seconds.0)),
    ]);
    html.pairs(summary.outputs.iter().filter_map(loss));
    meshes(report, html);
}

/// Writes the loads of the meshes, which a gear engineer asks for first.
fn meshes(report: &Report<'_>, html: &mut Html) {
    let row = |(law, mesh): (&String, &Mesh)| {
        let (unit, factor) = readable(&mesh.unit, mesh.largest.0);
        let texts = [law, &mesh.force, unit].map(TableCell::text);
        let [largest, at_rest, mean, pull] =
            [mesh.largest, mesh.at_rest, mesh.mean, mesh.largest_pull].map(|x| factor * x.0);
        let factors = [mesh.dynamic_factor, mesh.kv_iso6336].map(|x| x.0);
        let numbers = [largest, at_rest].into_iter().chain(factors).chain([mean, 100.0 * mesh.pulling_share.0, pull]);
        let numbers = numbers.map(TableCell::Number);
        texts.into_iter().chain(numbers).collect::<Vec<_>>()
    };
    let rows: Vec<_> = report.run.summary.meshes.iter().map(row).collect();
    if !rows.is_empty() {
        let head = [
            "mesh",
            "force",
            "unit",
            "largest",
            "static",
            "dynamic factor",
            "K_v, ISO 6336-1 B",
            "mean",
            "pulls [%]",
            "largest pull",
        ];
        html.table("Loads of the meshes", &head, &rows);
        let reason = |law: &str, value: &str| report.run.summary.missing.get(&format!("meshes.{law}.{value}"));
        let mut reasons: Vec<(String, Vec<&str>)> = vec![];
        for law in report.run.summary.meshes.keys() {
            for (value, name) in [("dynamic_factor", "dynamic factor"), ("kv_iso6336", "K_v")] {
                let Some(why) = reason(law, value) else { continue };
                let says = format!("no {name}, because {why}");
                match reasons.iter_mut().find(|(known, _)| *known == says) {
                    Some((_, laws)) => laws.push(law),
                    None => reasons.push((says, vec![law])),
                }
            }
        }
        for (says, laws) in reasons {
            html.paragraph(&format!("{}: {says}.", laws.join(", ")));
        }
    }
}

/// The number of digits left of the end state, in words.
fn digits(report: &Report<'_>) -> String {
    match report.run.summary.digits {
        None => "not estimated".into(),
        Some(digits) => match digits.none_from {
            Some(t) => format!(
                "none from t = {} s on (shaded): a rounding error, or the error of a time step, has grown as large as the motion",
                short(t.0)
            ),
            None => format!("{:.0} of the end state", digits.at_end.0.floor()),
        },
    }
}
