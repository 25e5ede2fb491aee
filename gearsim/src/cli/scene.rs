//! `gearsim scene`: a scene to start from, and what a scene may state.

use clap::Parser;

use super::failure::Failure;
use super::{Verb, known, models, terminal};
use crate::library::starter;
use crate::scene;

/// Print a scene of a model to start from: all that it requires with values of usual size, all else as comments
///
/// With --keys, the reference of all keys of scenes instead; with --schema, a JSON schema by which editors complete and check scenes.
#[derive(Parser)]
#[command(
    name = "scene",
    after_help = "\
Examples:
  gearsim scene gear_pair_shafts > my_scene.toml
  gearsim run my_scene.toml
  gearsim scene --keys
  gearsim scene --schema > scene.schema.json

The extension Even Better TOML of several editors takes the schema by a first line in the scene:
  #:schema ./scene.schema.json"
)]
pub(super) struct SceneCommand {
    /// The model
    #[arg(required_unless_present_any = ["keys", "schema"])]
    model: Option<String>,
    /// Print the reference of all keys, in Markdown
    #[arg(long, conflicts_with_all = ["schema", "model"])]
    keys: bool,
    /// Print the JSON schema of scenes: of this model, or of all models
    #[arg(long)]
    schema: bool,
}

impl Verb for SceneCommand {
    fn run(self) -> Result<(), Failure> {
        let model = self.model.as_deref().map(models::find).transpose()?;
        let text = match model {
            _ if self.keys => scene::reference(),
            None => json(&scene::schema(&known::descriptions())),
            Some(model) if self.schema => json(&scene::schema(&[model])),
            Some(model) => starter(model),
        };
        terminal::print_out(&text);
        Ok(())
    }
}

fn json(schema: &serde_json::Value) -> String {
    format!("{schema:#}\n")
}
