//! `gearsim models`: lists and describes the models.

pub(super) mod detail;

use clap::Parser;

use super::failure::Failure;
use super::terminal;
use super::{Verb, known};
use crate::model::Model;
use crate::scene::{Effects, did_you_mean, list};

/// List the models, or describe one in full
#[derive(Parser)]
#[command(
    name = "models",
    after_help = "\
Examples:
  gearsim models
  gearsim models gear_pair
  gearsim models gear_pair --latex"
)]
pub(super) struct Models {
    /// The model to describe
    name: Option<String>,
    /// Print only its equations, in LaTeX
    #[arg(long, requires = "name")]
    latex: bool,
}

impl Verb for Models {
    fn run(self) -> Result<(), Failure> {
        match &self.name {
            None => terminal::print_out(&all()),
            Some(name) => {
                let model = find(name)?;
                terminal::print_out(&if self.latex {
                    format!("{}\n", model.latex.trim_end())
                } else {
                    detail::of(model, terminal::width())
                });
            }
        }
        Ok(())
    }
}

/// The model called `name`.
pub(super) fn find(name: &str) -> Result<&'static Model, Failure> {
    let names: Vec<_> = known::models().iter().map(|entry| entry.model.name).collect();
    let unknown = || {
        let meant = did_you_mean(name, names.iter().copied()).map(|meant| format!("did you mean `{meant}`? "));
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
        text += &format!("  coordinates  {}\n", names(model.coordinates.iter().map(|c| c.name).collect()));
        text += &format!("  effects      {}\n\n", names(Effects(u64::MAX).names(model)));
    }
    text + "`gearsim models NAME` shows what a scene of a model can set, and its equations.\n"
}
