//! Reads a scene from a file or a text, with overrides.

use std::path::Path;

use super::template::Template;
use super::{Scene, SceneMistakes};
use crate::model::Model;

impl Scene {
    /// Reads the scene in a file. Its name is the file's stem. See [`Scene::parse`] for the errors.
    pub fn load_with(path: &Path, overrides: &[String], models: &[&'static Model]) -> Result<Scene, SceneMistakes> {
        Template::load(path, overrides)?.scene(&[], models)
    }

    /// Reads a scene of one of `models` from its text, with `overrides` (`run.t_end="1 s"`) applied.
    ///
    /// # Errors
    ///
    /// All mistakes in the text and the overrides. They quote the text under the name `source_name`.
    pub fn parse(
        name: &str,
        source_name: &str,
        text: &str,
        overrides: &[String],
        models: &[&'static Model],
    ) -> Result<Scene, SceneMistakes> {
        Template::parse(name, source_name, text, overrides)?.scene(&[], models)
    }

    /// Value \[SI\] of the parameter with this name; `None` if the model does not have it.
    pub fn parameter(&self, name: &str) -> Option<f64> {
        let index = self.model.parameters.iter().position(|parameter| parameter.name == name)?;
        self.parameters.get(index).copied()
    }
}
