//! Reading a scene: from a file or a text, with overrides.

use std::path::Path;

use sha2::{Digest, Sha256};

use super::document::{self, Origin};
use super::error::Report;
use super::{Scene, SceneErrors, check, overrides};
use crate::model::Model;

impl Scene {
    /// Reads the scene in a file; its name is the file's stem. See [`Scene::parse`].
    pub fn load(path: &Path, overrides: &[String], models: &[&'static Model]) -> Result<Scene, SceneErrors> {
        let shown = path.display().to_string();
        let name = path.file_stem().map_or_else(|| shown.clone(), |stem| stem.to_string_lossy().into_owned());
        let unreadable = |message| SceneErrors::unreadable(&name, message, "give the path of a scene, a TOML file");
        let bytes = std::fs::read(path).map_err(|error| unreadable(format!("cannot read {shown}: {error}")))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            unreadable(format!("{shown} is not text: byte {} is not UTF-8", error.utf8_error().valid_up_to()))
        })?;
        Scene::parse(&name, &shown, &text, overrides, models)
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
        let mut report = Report::new();
        let origin = Origin { source: report.source(source_name, text), offset: 0 };
        let root = document::read(text, origin, &mut report);
        let Some(mut root) = root else {
            return Err(report.into_errors(name));
        };
        for text in overrides {
            overrides::apply(&mut root, text, &mut report);
        }
        let end = text.trim_end().len();
        let scene = check::scene(&root, &origin.place(end..end), models, &mut report);
        match scene {
            Some(scene) if report.is_empty() => {
                Ok(Scene { name: name.to_string(), hash: hash(text, overrides), ..scene })
            }
            _ => Err(report.into_errors(name)),
        }
    }

    /// Value [SI] of a parameter; `None` if the model has none of this name.
    pub fn parameter(&self, name: &str) -> Option<f64> {
        let index = self.model.parameters.iter().position(|parameter| parameter.name == name)?;
        self.parameters.get(index).copied()
    }
}

/// SHA-256 of the text and, after a zero byte each, the overrides: without any, that of the file.
fn hash(text: &str, overrides: &[String]) -> String {
    let mut hash = Sha256::new();
    hash.update(text);
    for text in overrides {
        hash.update([0]);
        hash.update(text);
    }
    format!("{:x}", hash.finalize())
}
