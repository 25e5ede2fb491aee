//! `gearsim models`: lists and describes the models.

pub(super) mod detail;
mod json;

use clap::Parser;

use super::failure::Failure;
use super::terminal;
use super::{Verb, known};
use crate::model::Model;
use crate::scene::{Effects, Scene, did_you_mean, in_place_of, list};

/// List the models, or describe one in full
#[derive(Parser)]
#[command(
    name = "models",
    after_help = "\
Examples:
  gearsim models
  gearsim models gear_pair
  gearsim models gear_pair --latex
  gearsim models models/scenes/train_branches.toml    the train that a scene lists"
)]
pub(super) struct Models {
    /// The model to describe, or a scene whose model is described
    name: Option<String>,
    /// Print only its equations, in LaTeX
    #[arg(long, requires = "name", conflicts_with = "json")]
    latex: bool,
    /// Print names, units, defaults and allowed values as JSON
    #[arg(long)]
    json: bool,
}

impl Verb for Models {
    fn run(self) -> Result<(), Failure> {
        match &self.name {
            None if self.json => {
                let models: Vec<&Model> = known::models().iter().map(|entry| entry.model).collect();
                terminal::print_out(&json::json(&models)?);
            }
            None => terminal::print_out(&all()),
            Some(name) => {
                let model = if name.ends_with(".toml") { of_scene(name)? } else { find(name)? };
                if self.latex && model.latex.is_empty() {
                    let what =
                        format!("the equations of `{}` are put together from tables, and are not in LaTeX", model.name);
                    let help = "leave out --latex, or name an element: gearsim_models::ELEMENTS are in gearsim/generated/src/latex".into();
                    return Err(Failure::Impossible { what, help });
                }
                terminal::print_out(&match (self.latex, self.json) {
                    (true, _) => format!("{}\n", model.latex.trim_end()),
                    (_, true) => json::json(&[model])?,
                    _ => detail::of(model, terminal::width()),
                });
            }
        }
        Ok(())
    }
}

/// The model of the scene in a file: that of a train with its parts.
fn of_scene(path: &str) -> Result<&'static Model, Failure> {
    let scene = Scene::load_with(path.as_ref(), &[], &known::descriptions());
    Ok(scene.map_err(|mistakes| Failure::Scene(Box::new(mistakes)))?.model)
}

/// The model called `name`.
pub(super) fn find(name: &str) -> Result<&'static Model, Failure> {
    let names: Vec<_> = known::models().iter().map(|entry| entry.model.name).collect();
    let unknown = || {
        let meant = || Some(format!("did you mean `{}`? ", did_you_mean(name, names.iter().copied())?));
        let meant = in_place_of(name).map(|help| help + "; ").or_else(meant);
        let help = format!("{}the models are {}", meant.unwrap_or_default(), list(&names));
        Failure::Impossible { what: format!("there is no model `{name}`"), help }
    };
    known::models().iter().map(|entry| entry.model).find(|model| model.name == name).ok_or_else(unknown)
}

/// All models with their coordinates and effects.
pub(super) fn all() -> String {
    let mut text = String::new();
    for model in known::models().iter().map(|entry| entry.model) {
        let names = |names: Vec<&str>| if names.is_empty() { "none".into() } else { names.join(", ") };
        text += &format!("{}  {}\n", model.name, model.title);
        if !model.elements.is_empty() {
            text += "  coordinates and effects follow from the parts that a scene lists\n\n";
            continue;
        }
        text += &format!("  coordinates  {}\n", names(model.coordinates.iter().map(|c| c.name).collect()));
        text += &format!("  effects      {}\n\n", names(Effects::all(model).names(model)));
    }
    text + "`gearsim models NAME` shows what a scene of a model can set, and its equations.\n"
}
