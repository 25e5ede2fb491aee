//! `cargo xtask soak`: the energy error of a very long run without damping.

use crate::chore;

/// Run an undamped gear pair with an aperiodic motion for very many events, and measure its energy error.
#[derive(clap::Args)]
pub struct Soak {
    /// Number of events (cell changes and reflections), e.g. 1e8.
    #[arg(long, default_value = "1e8")]
    events: String,
    /// Arithmetic that carries the state: compensated or plain.
    #[arg(long, default_value = "compensated")]
    precision: String,
}

impl Soak {
    /// Starts the program that runs it.
    pub fn run(&self) -> anyhow::Result<()> {
        chore::run("soak", &["--events", &self.events, "--precision", &self.precision])
    }
}
