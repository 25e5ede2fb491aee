//! What pages of several commands have in common.

pub mod figure;
pub mod heat;
pub mod model;
pub mod provenance;
pub mod rows;
pub mod scene;
pub mod table;

use super::Page;
use crate::output::summary::Provenance;
use crate::scene::Scene;

/// What every page says of the result that it shows.
pub struct Made<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What made the result.
    pub provenance: Provenance,
    /// Names of the other files of the result.
    pub files: &'a [String],
}

/// A page of `scene` without sections.
pub fn begin(scene: &Scene) -> Page {
    let subtitle = if scene.about.is_empty() { scene.model.title } else { &scene.about };
    Page::new(&scene.name, subtitle)
}

/// Adds the sections with which every page ends: scene, model, provenance.
pub fn end(page: &mut Page, made: &Made<'_>) {
    page.section("scene", "Scene", |html| scene::fill(made.scene, html));
    page.section("model", "Model", |html| model::fill(made.scene, html));
    page.section("provenance", "Provenance", |html| provenance::fill(&made.provenance, made.files, html));
}
