//! A scene that is parsed but not yet checked. Each point of a sweep applies its values to it.

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::document::{self, Node, Origin, Place, Value};
use super::mistake::Report;
use super::overrides::{AXES, CODE, SET, Setting, VARY};
use super::{Scene, SceneMistakes, check, keys, overrides, train};
use crate::model::Model;
use crate::tolerance::scene::SCENE_BYTES;

/// The text of a scene as a tree with overrides applied, and the mistakes found so far.
#[derive(Debug, Clone)]
pub struct Template {
    name: String,
    root: Node,
    /// Place where a missing table would be added.
    end: Place,
    report: Report,
    hash: Sha256,
    text: Arc<str>,
    /// What messages call the text.
    source: Arc<str>,
    overrides: Vec<String>,
    /// Where the values of axes come from.
    axes: Setting,
}

impl Template {
    /// Reads the file of a scene, or the standard input if the path is `-`. See [`Template::parse`].
    pub fn load(path: &Path, overrides: &[String]) -> Result<Template, SceneMistakes> {
        if path == Path::new("-") {
            let mut text = String::new();
            let read = std::io::stdin().lock().take(SCENE_BYTES + 1).read_to_string(&mut text);
            let wrong = match read {
                Ok(length) if length as u64 <= SCENE_BYTES => None,
                Ok(_) => Some(format!("the standard input is longer than a scene, {} MB", SCENE_BYTES >> 20)),
                Err(error) => Some(format!("cannot read the standard input: {error}")),
            };
            return match wrong {
                Some(message) => Err(SceneMistakes::unreadable("stdin", message, "give a scene, in TOML")),
                None => Template::parse("stdin", "standard input", &text, overrides),
            };
        }
        let shown = path.display().to_string();
        let name = path.file_stem().map_or_else(|| shown.clone(), |stem| stem.to_string_lossy().into_owned());
        let unreadable = |message| SceneMistakes::unreadable(&name, message, "give the path of a scene, a TOML file");
        // Reading a pipe or a device might never end.
        let kind = std::fs::metadata(path).map_err(|error| unreadable(format!("cannot read {shown}: {error}")))?;
        if !kind.is_file() {
            let what = if kind.is_dir() { "a folder" } else { "a pipe or a device" };
            return Err(unreadable(format!("cannot read {shown}: it is {what}, not a file")));
        }
        if kind.len() > SCENE_BYTES {
            let most = SCENE_BYTES >> 20;
            return Err(unreadable(format!("{shown} has {} bytes; a scene has at most {most} MB", kind.len())));
        }
        let bytes = std::fs::read(path).map_err(|error| unreadable(format!("cannot read {shown}: {error}")))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            unreadable(format!("{shown} is not text: byte {} is not UTF-8", error.utf8_error().valid_up_to()))
        })?;
        Template::parse(&name, &shown, &text, overrides)
    }

    /// Reads the text of a scene and applies the `overrides`.
    ///
    /// # Errors
    ///
    /// If the text is not TOML. All other mistakes are reported by [`Template::scene`].
    pub fn parse(name: &str, source_name: &str, text: &str, overrides: &[String]) -> Result<Template, SceneMistakes> {
        let mut template = Template::read(name, source_name, text)?;
        template.set(SET, overrides);
        Ok(template)
    }

    /// The scene as it was read, with `overrides` in place of those that it had.
    ///
    /// # Errors
    /// As [`Template::parse`].
    pub fn again(scene: &Scene, overrides: &[String]) -> Result<Template, SceneMistakes> {
        Ok(Template::read(&scene.name, &scene.source, &scene.text)?.edited(overrides))
    }

    /// The template with `values` that a program sets, each as `KEY=VALUE`.
    pub fn edited(mut self, values: &[String]) -> Template {
        self.set(CODE, values);
        self.axes = AXES;
        self
    }

    /// Whether `text` has the values of this template with its overrides. In a train the order of the parts counts too.
    pub fn is_same(&self, text: &str, is_train: bool) -> bool {
        let same = |other: Template| {
            let in_order = !is_train || self.root.in_order() == other.root.in_order();
            in_order && self.root.is_same(&other.root)
        };
        Template::read(&self.name, &self.source, text).is_ok_and(same)
    }

    fn read(name: &str, source_name: &str, text: &str) -> Result<Template, SceneMistakes> {
        let mut report = Report::new();
        let origin = Origin { source: report.source(source_name, text), offset: 0 };
        let Some(root) = document::read(text, origin, &mut report) else {
            return Err(report.into_mistakes(name));
        };
        let end = text.trim_end().len();
        let hash = Sha256::new_with_prefix(text);
        let (name, end, text) = (name.to_string(), origin.place(end..end), text.into());
        Ok(Template { name, root, end, report, hash, text, source: source_name.into(), overrides: vec![], axes: VARY })
    }

    /// Checks the scene with `values` (`run.t_end=1 s`, from options `--vary`) applied. Its model must be one of `models`.
    ///
    /// # Errors
    ///
    /// All mistakes in the scene, its overrides and the values.
    pub fn scene(&self, values: &[String], models: &[&'static Model]) -> Result<Scene, SceneMistakes> {
        let mut all = self.clone();
        all.set(all.axes, values);
        let Template { name, root, end, mut report, hash, text, source, overrides, .. } = all;
        match check::scene(&root, &end, models, &mut report) {
            Some(scene) if report.is_empty() => {
                let (hash, warnings) = (hexadecimal(hash), report.into_warnings());
                Ok(Scene { name, hash, text, source, overrides, warnings, ..scene })
            }
            _ => Err(report.into_mistakes(&name)),
        }
    }

    /// Name: the file's stem.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its text, without overrides.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// SHA-256 of the text and of the overrides, each after a zero byte. Without overrides it is the hash of the file.
    pub fn hash(&self) -> String {
        hexadecimal(self.hash.clone())
    }

    /// The model that the scene names; `None` if it is not one of `models`.
    pub fn model(&self, models: &[&'static Model]) -> Option<&'static Model> {
        let Value::Table(entries) = &self.root.value else { return None };
        match &keys::get(entries, "model")?.value {
            Value::Text(name) => {
                let model = models.iter().copied().find(|model| model.name == name)?;
                match model.elements.is_empty() {
                    true => Some(model),
                    // Mistakes are reported where the scene is read.
                    false => Some(
                        train::read(model, &mut entries.clone(), [&self.root.place, &self.end], &mut self.report())?
                            .model,
                    ),
                }
            }
            _ => None,
        }
    }

    /// Where the values of axes come from, as messages show them.
    pub(crate) fn axes(&self) -> Setting {
        self.axes
    }

    /// The mistakes found so far, for the caller to add more.
    pub(crate) fn report(&self) -> Report {
        self.report.clone()
    }

    fn set(&mut self, from: Setting, texts: &[String]) {
        for text in texts {
            overrides::apply(&mut self.root, from, text, &mut self.report);
            self.hash.update([0]);
            self.hash.update(text);
        }
        self.overrides.extend_from_slice(texts);
    }
}

fn hexadecimal(hash: Sha256) -> String {
    format!("{:x}", hash.finalize())
}
