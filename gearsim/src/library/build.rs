//! Scenes from files, from text, and from values set in code.

use std::path::Path;

use super::{Error, Value};
use crate::known;
use crate::scene::text::Text;
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

    /// As [`Scene::from_toml`], with values set on top of the text, each as `KEY=VALUE`. A scene is sent to another process as its name,
    /// text and overrides.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn from_toml_with(name: &str, text: &str, overrides: &[String]) -> Result<Scene, Error> {
        Ok(Template::parse(name, name, text, &[])?.edited(overrides).scene(&[], &known::descriptions())?)
    }

    /// The text of the scene in TOML, with the values that were set on top of it. Comments and layout stay. [`Scene::from_toml`]
    /// reads this text; the run of that scene has the same numbers, bit for bit. Values that a program wrote into the fields of the scene
    /// are not in the text.
    ///
    /// ```
    /// use gearsim::Scene;
    ///
    /// let text = "model = \"chain_2\"\neffects = []\n\n[parameters]\nI1 = \"0.5 kg*m^2\" # of the motor\nI2 = \"0.25 kg*m^2\"\nk1 = \"10 kN*m/rad\"\n";
    /// let scene = Scene::from_toml("pair", text)?.with("parameters.I1", "600 kg*cm^2")?;
    /// assert_eq!(scene.to_toml()?, text.replace("0.5 kg*m^2", "600 kg*cm^2"));
    /// # Ok::<(), gearsim::Error>(())
    /// ```
    ///
    /// # Errors
    /// If a value was set within an array of arrays, or a part of a train before others, which have no place in the text.
    pub fn to_toml(&self) -> Result<String, Error> {
        let cannot = || {
            let what = format!("the text of scene {} cannot be edited: {}", self.name, self.overrides.join(", "));
            Error::impossible(what, "set the whole arrays or tables that contain these values")
        };
        let mut text = Text::parse(&self.text).ok_or_else(cannot)?;
        self.overrides.iter().for_each(|setting| text.set_as_option(setting));
        let text = text.to_string();
        if Template::again(self, &self.overrides)?.is_same(&text, self.train.is_some()) {
            Ok(text)
        } else {
            Err(cannot())
        }
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
        let (values, models) = (values.into_iter().collect::<Vec<_>>(), known::descriptions());
        let with = |model| {
            let values = values.iter().map(|(key, value)| value.set(key, Some(model)));
            Template::again(self, &self.overrides.iter().cloned().chain(values).collect::<Vec<_>>())
        };
        // Parts that are added to a train have parameters of their own.
        let is_new = self.train.is_some() && values.iter().any(|(key, value)| value.is_strange(key, self.model));
        let whole = if is_new { with(self.model)?.model(&models) } else { None };
        Ok(with(whole.unwrap_or(self.model))?.scene(&[], &models)?)
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
        let empty = Template::parse(&name, "the scene", &text, &[])?;
        let written = |model| values.iter().map(|(key, value)| value.set(key, model)).collect::<Vec<_>>();
        let bare = models.iter().copied().find(|known| known.name == model);
        // The parameters of a train, and their units, follow from its tables.
        let is_train = bare.is_some_and(|model| !model.elements.is_empty());
        let whole = is_train.then(|| empty.clone().edited(&written(bare)).model(&models)).flatten();
        Ok(empty.edited(&written(whole.or(bare))).scene(&[], &models)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The columns of a run, bit for bit.
    fn bits(scene: &Scene) -> Vec<Vec<u64>> {
        let run = scene.run().unwrap();
        let run = run.trajectory();
        run.q.iter().chain(&run.q_dot).map(|column| column.iter().map(|x| x.to_bits()).collect()).collect()
    }

    /// A scene that was changed, and its text read again, are the same: values, kinds of tables, entries of arrays, new tables.
    fn assert_same(scene: &Scene) -> String {
        let text = scene.to_toml().unwrap();
        let again = Scene::from_toml(&scene.name, &text).unwrap_or_else(|error| panic!("{text}\n{error}"));
        assert_eq!(bits(scene), bits(&again), "{text}");
        assert_eq!(again.to_toml().unwrap(), text);
        text
    }

    #[test]
    fn the_text_of_a_changed_scene_is_that_scene() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/");
        let scene = Scene::load(format!("{folder}two_stage.toml")).unwrap().with("run.t_end", "2 ms").unwrap();
        assert!(assert_same(&scene).contains("# "), "the comments are gone");
        let scene = scene.with("parameters.T_motor", 1.0 / 3.0).unwrap().with("output.events", false).unwrap();
        let law = scene.model.laws[0].name;
        let scene = scene.with(&format!("laws.{law}.steps.0.width"), "1.7 rad").unwrap();
        let scene = scene.with("effects", &["stiffness_step", "torques"][..]).unwrap();
        let text = assert_same(&scene);
        assert!(text.contains("\"1.7 rad\"") && text.contains("0.3333333333333333"), "{text}");
        let train = Scene::load(format!("{folder}train_branches.toml")).unwrap().with("run.t_end", "1 ms").unwrap();
        assert_same(&train.with("shafts.m.stiffness", "11 kN*m/rad").unwrap().with("rotors.1", "3e-5 kg*m^2").unwrap());
    }

    #[test]
    fn a_scene_built_in_code_has_a_text() {
        let scene = Scene::of_model("chain_2").set("parameters.I1", 0.5).set("parameters.I2", 0.25);
        let scene = scene.set("parameters.k1", 1e4).set("start.theta1_dot", 2.0).set("run", "{ t_end = \"10 ms\" }");
        assert_same(&scene.build().unwrap());
    }

    /// Setting a value in a part of a train does not change the order of the parts, on which the coordinates depend.
    #[test]
    fn parts_of_a_train_keep_their_order() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/train_branches.toml");
        let scene = Scene::load(path).unwrap();
        let names = |scene: &Scene| scene.model.coordinates.iter().map(|c| c.name).collect::<Vec<_>>();
        let changed = scene.with("rotors.1", "3e-5 kg*m^2").unwrap();
        assert_eq!(names(&changed), names(&scene));
    }

    /// Rotors by their inertias and by tables, in any order, and shafts.
    #[test]
    fn a_train_built_in_code_has_a_text() {
        let train = Scene::of_model("train").set("rotors.a", "1 kg*m^2").set("rotors.c.inertia", "2 kg*m^2");
        let train = train.set("rotors.b", "3 kg*m^2").set("shafts.ab.between", "[\"a\", \"b\"]");
        let train = train.set("shafts.ab.stiffness", "1 MN*m/rad").set("shafts.cb.stiffness", "2 MN*m/rad");
        let train =
            train.set("shafts.cb.between", "[\"c\", \"b\"]").set("start.speed", "1 rad/s").set("run.t_end", "1 ms");
        assert_same(&train.build().unwrap());
    }

    /// Numbers without units, in tables, in lists and in tables of lists.
    #[test]
    fn numbers_in_the_tables_of_a_train_are_in_si_units() {
        let step = |value: f64| Value::Table(vec![("value".into(), value.into()), ("width".into(), 3.0.into())]);
        let last = Value::Table(vec![("value".into(), 3e8.into())]);
        let train = |stiffness: Value| {
            let train = Scene::of_model("train").effects(&["stiffness_step", "torques"]);
            let train = train.set("rotors.a", 0.5).set("rotors.b.inertia", 2.0).set("drives.d.rotor", "a");
            let train = train.set("meshes.m.between", Value::List(vec!["a".into(), "b".into()]));
            let train = train.set("meshes.m.teeth", Value::List(vec![20.into(), 40.into()]));
            let train = train.set("meshes.m.module", 2e-3).set("meshes.m.stiffness", stiffness);
            train.set("start.speed", 10.0).set("run.t_end", 1e-3).set("drives.d.torque", 5.0).build()
        };
        let scene = train(Value::List(vec![])).unwrap_err();
        assert!(scene.to_string().contains("mistake"), "{scene}");
        let steps = Value::Table(vec![("steps".into(), Value::List(vec![step(2e8), last]))]);
        let scene = train(steps).unwrap();
        assert_eq!(["I_a", "I_b", "T_d"].map(|name| scene.parameter(name).unwrap()), [0.5, 2.0, 5.0]);
        assert_eq!(scene.laws[0].steps.iter().map(|step| step.value).collect::<Vec<_>>(), [2e8, 3e8]);
        assert_same(&scene);
        let scene = train(1e8.into()).unwrap().with("rotors.a", 0.25).unwrap();
        assert_eq!((scene.parameter("I_a"), scene.mid_stiffnesses()), (Some(0.25), vec![1e8]));
        let nan = scene.with("rotors.a", f64::NAN).unwrap_err().to_string();
        assert!(nan.contains("`rotors.a` is not a finite number"), "{nan}");
        let more = [("loads.l.rotor", "b".into()), ("parameters.T_l", 2.0.into())];
        assert_eq!(scene.with_all(more).unwrap().parameter("T_l"), Some(2.0));
    }

    /// New keys are set in arrays of tables and in inline tables.
    #[test]
    fn keys_are_added_within_arrays_of_tables() {
        let text = "model = \"gear_pair\"\n\n[[laws.k.steps]]\nvalue = 1\n\n[[laws.k.steps]]\nvalue = 2\n\n[laws]\ne = { steps = [{ value = 1 }] }\n";
        let mut edited = Text::parse(text).unwrap();
        let settings =
            ["laws.k.steps.0.width=1.7 rad", "laws.e.steps.0.width=2", "laws.e.pitches=3"].map(str::to_owned);
        settings.iter().for_each(|setting| edited.set_as_option(setting));
        let template = Template::parse("scene", "scene", text, &settings).unwrap();
        assert!(template.is_same(&edited.to_string(), true), "{edited}");
    }
}
