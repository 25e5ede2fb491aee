//! Reading a scene: from a file or a text, with overrides.

use std::path::Path;

use super::template::Template;
use super::{Scene, SceneErrors};
use crate::model::Model;

impl Scene {
    /// Reads the scene in a file; its name is the file's stem. See [`Scene::parse`].
    pub fn load(path: &Path, overrides: &[String], models: &[&'static Model]) -> Result<Scene, SceneErrors> {
        Template::load(path, overrides)?.scene(&[], models)
    }

    /// Reads a scene of one of `models` from its text, after writing the `overrides` (`run.t_end="1 s"`) over it.
    ///
    /// # Errors
    ///
    /// Everything that is wrong with the text and the overrides. `source_name` stands for the text in them.
    pub fn parse(
        name: &str,
        source_name: &str,
        text: &str,
        overrides: &[String],
        models: &[&'static Model],
    ) -> Result<Scene, SceneErrors> {
        Template::parse(name, source_name, text, overrides)?.scene(&[], models)
    }

    /// Value [SI] of a parameter; `None` if the model has none of this name.
    pub fn parameter(&self, name: &str) -> Option<f64> {
        let index = self.model.parameters.iter().position(|parameter| parameter.name == name)?;
        self.parameters.get(index).copied()
    }
}
