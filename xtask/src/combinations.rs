//! `cargo xtask combinations`: random scenes over models, effects, numbers, methods and precisions, with checks of what must hold for each.

use crate::suite;

/// Run random scenes with random sets of effects, and check what must hold of each.
#[derive(clap::Args)]
pub struct Combinations {
    /// Number of scenes
    #[arg(long, default_value_t = 100_000)]
    scenes: u64,
    /// Number of the first scene; each number is always the same scene
    #[arg(long, default_value_t = 0)]
    from: u64,
}

impl Combinations {
    /// Runs the test of that name.
    ///
    /// # Errors
    /// If something does not hold of a scene.
    pub fn run(&self) -> anyhow::Result<()> {
        let mut tests = suite::of("combinations")?;
        tests.args(["--", "--nocapture"]);
        tests.env("COMBINATIONS", self.scenes.to_string()).env("COMBINATIONS_FROM", self.from.to_string());
        suite::run(&mut tests, "something does not hold of a scene; the message is above")
    }
}
