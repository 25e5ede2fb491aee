//! `gearsim scene`: a scene to start from.

use clap::Parser;

use super::failure::Failure;
use super::{Verb, models, terminal};
use crate::library::starter;

/// Print a scene of a model to start from: all that it requires with values of usual size, all else as comments
#[derive(Parser)]
#[command(
    name = "scene",
    after_help = "\
Examples:
  gearsim scene gear_pair_shafts > my_scene.toml
  gearsim run my_scene.toml"
)]
pub(super) struct SceneCommand {
    /// The model
    model: String,
}

impl Verb for SceneCommand {
    fn run(self) -> Result<(), Failure> {
        terminal::print_out(&starter(models::find(&self.model)?));
        Ok(())
    }
}
