//! Scenes from files, from text, and from values set in code.

use std::path::Path;

use super::{Error, Value};
use crate::known;
use crate::scene::{Scene, Template};

impl Scene {
    /// Reads the scene in a file. Its model is one of gearsim's, or of those added by [`add_models`](crate::add_models).
    ///
    /// # Errors
    /// All mistakes in the scene, each with its line.
    pub fn load(path: impl AsRef<Path>) -> Result<Scene, Error> {
        Ok(Scene::load_with(path.as_ref(), &[], &known::descriptions())?)
    }

    /// Reads a scene from its text in TOML. `name` is the name that results carry.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn from_toml(name: &str, text: &str) -> Result<Scene, Error> {
        Ok(Scene::parse(name, name, text, &[], &known::descriptions())?)
    }

    /// The same with values set on top of the text, each as `KEY=VALUE`. A scene travels to another process as its name, text and
    /// overrides.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn from_toml_with(name: &str, text: &str, overrides: &[String]) -> Result<Scene, Error> {
        Ok(Template::parse(name, name, text, &[])?.edited(overrides).scene(&[], &known::descriptions())?)
    }

    /// Begins a scene of a model without a file. Its values are set one by one; all that a scene file may state can be set.
    ///
    /// ```
    /// use gearsim::Scene;
    ///
    /// let scene = Scene::of_model("chain_2")
    ///     .set("parameters.I1", "0.5 kg*m^2")
    ///     .set("parameters.I2", 0.25)
    ///     .set("parameters.k1", "10 kN*m/rad")
    ///     .set("start.theta1_dot", "1 rad/s")
    ///     .set("run.t_end", "0.1 s")
    ///     .build()?;
    /// assert_eq!(scene.parameter("k1"), Some(1e4));
    /// # Ok::<(), gearsim::Error>(())
    /// ```
    pub fn of_model(model: &str) -> SceneBuilder {
        SceneBuilder { model: model.into(), name: model.into(), values: vec![] }
    }

    /// The same scene with another value, as by the option `--set` of the command line. `key` is a key with its tables,
    /// `parameters.T0` or `laws.k.steps.0.value`. `value` is a number \[SI\], a text with a unit, or anything else in TOML ([`Value`]).
    ///
    /// # Errors
    /// If there is no such key, or the value is not valid for it.
    pub fn with(&self, key: &str, value: impl Into<Value>) -> Result<Scene, Error> {
        self.with_all([(key, value.into())])
    }

    /// The same scene with several other values; it is checked once, with all of them.
    ///
    /// # Errors
    /// As [`Scene::with`].
    pub fn with_all<'a>(&self, values: impl IntoIterator<Item = (&'a str, Value)>) -> Result<Scene, Error> {
        let mut overrides = self.overrides.clone();
        overrides.extend(values.into_iter().map(|(key, value)| value.set(key, Some(self.model))));
        Ok(Template::again(self, &overrides)?.scene(&[], &known::descriptions())?)
    }
}

/// A scene that is being built in code. See [`Scene::of_model`].
#[derive(Debug, Clone)]
#[must_use = "a scene is built by `build`"]
pub struct SceneBuilder {
    model: String,
    name: String,
    values: Vec<(String, Value)>,
}

impl SceneBuilder {
    /// The name that results carry; without it, that of the model.
    pub fn name(mut self, name: &str) -> Self {
        self.name = name.into();
        self
    }

    /// The active effects; without them, none.
    pub fn effects(self, effects: &[&str]) -> Self {
        self.set("effects", effects)
    }

    /// Sets a value. `key` and `value` are as in [`Scene::with`].
    pub fn set(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.values.push((key.into(), value.into()));
        self
    }

    /// The scene.
    ///
    /// # Errors
    /// All mistakes, and the values that are required but not set.
    pub fn build(self) -> Result<Scene, Error> {
        let SceneBuilder { model, name, values } = self;
        // A scene always says which effects it has.
        let text = format!("model = {model:?}\neffects = []\n");
        let models = known::descriptions();
        let its_model = models.iter().copied().find(|known| known.name == model);
        let values: Vec<_> = values.iter().map(|(key, value)| value.set(key, its_model)).collect();
        let empty = Template::parse(&name, "the scene", &text, &[])?;
        Ok(empty.edited(&values).scene(&[], &models)?)
    }
}
