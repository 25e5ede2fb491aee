//! The page of `gearsim sweep` and `gearsim merge`: the plots, what the sweep answers, and the table of its points.

use super::Page;
use super::html::Html;
use super::shared::{figure, heat, provenance, table};
use crate::model::Model;
use crate::output::summary::Provenance;
use crate::output::{OutputError, Table};
use crate::plot::Drawn;
use crate::sweep::Manifest;

/// A finished sweep.
pub struct Sweep<'a> {
    /// Its definition.
    pub manifest: &'a Manifest,
    /// The model of its scene.
    pub model: &'a Model,
    /// The text of the scene, if known.
    pub text: Option<&'a str>,
    /// Its plots.
    pub drawn: &'a [Drawn],
    /// Its answers in words.
    pub words: &'a str,
    /// The tables of its answers, by the names of their files.
    pub answers: &'a [(&'static str, Table)],
    /// What a reader of its numbers must know.
    pub remarks: &'a [String],
    /// One row per point.
    pub points: &'a Table,
    /// Names of the other files.
    pub files: &'a [String],
}

/// The page of a sweep. Errors: none.
pub fn page(sweep: &Sweep<'_>) -> Result<Page, OutputError> {
    let manifest = sweep.manifest;
    let varied = format!("{} points over {}", manifest.points, manifest.vary.join(", "));
    let mut page = Page::new(&manifest.scene, varied);
    page.section("result", "Result", |html| {
        sweep.remarks.iter().for_each(|remark| html.note(remark));
        html.pairs(definition(manifest));
        for (i, drawn) in sweep.drawn.iter().enumerate() {
            match drawn {
                Drawn::Curves(drawn) => figure::fill(html, &format!("figure-{i}"), drawn),
                Drawn::Map(map) => heat::fill(html, map),
            }
        }
    });
    page.section("answers", "Answers", |html| {
        if !sweep.words.is_empty() {
            html.code("In words", sweep.words.trim_end(), true);
        }
        for (file, answer) in sweep.answers {
            table::fill(html, file.strip_suffix(".csv").unwrap_or(file), answer, file);
        }
    });
    page.section("points", "Points", |html| table::fill(html, "Points", sweep.points, "sweep.parquet"));
    page.section("scene", "Scene", |html| scene(html, sweep));
    page.section("provenance", "Provenance", |html| provenance::fill(&made_by(manifest), sweep.files, html));
    Ok(page)
}

fn definition(manifest: &Manifest) -> Vec<(&'static str, String)> {
    let mut pairs = vec![("varied", manifest.vary.join("\n")), ("points", manifest.points.to_string())];
    if let Some(samples) = manifest.samples {
        let design = manifest.design.name();
        pairs.push(("samples", format!("{samples} for each point of the grid, {design}, seed {}", manifest.seed)));
    }
    pairs.push(("recorded", manifest.record.join(", ")));
    pairs.push(("extremes and spectra from", format!("{} s", manifest.from.0)));
    pairs
}

fn scene(html: &mut Html, sweep: &Sweep<'_>) {
    let (manifest, model) = (sweep.manifest, sweep.model);
    match sweep.text {
        Some(text) => html.code(&format!("{}.toml, as read", manifest.scene), text, true),
        None => html.paragraph("The folder of the sweep does not have the text of the scene."),
    }
    let at_all = |set: &&String| !crate::sweep::is_varied(&manifest.vary, set);
    let at_all: Vec<&str> = manifest.overrides.iter().filter(at_all).map(String::as_str).collect();
    if !at_all.is_empty() {
        html.code("Values set at all points", &at_all.join("\n"), true);
    }
    html.pairs([("model", model.name), ("title", model.title), ("source", model.source)]);
}

fn made_by(manifest: &Manifest) -> Provenance {
    Provenance {
        program: manifest.program.clone(),
        version: manifest.program_version.clone(),
        commit: manifest.commit.clone(),
        scene_sha256: manifest.scene_sha256.clone(),
        solver: "that of each point".into(),
        overrides: manifest.overrides.clone(),
    }
}
