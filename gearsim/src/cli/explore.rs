//! `gearsim explore`: a live page of one scene.

use std::path::PathBuf;

use clap::Parser;

use super::failure::Failure;
use super::printing::Quiet;
use super::{Verb, page};

/// Change the values of a scene in a browser, and see each run at once
#[derive(Parser)]
#[command(
    name = "explore",
    after_help = "\
Prints an address to open in a browser on this machine: sliders for the numbers of the scene, check
boxes for its effects, a menu for its method. Each change is run and drawn at once, with its
processor time, its error at the end, the energy unaccounted for and the digits left. \"Save as
scene\" writes a scene that `gearsim run` runs to the same bytes. Ends with Ctrl-C.

The page is served on 127.0.0.1 alone, to whoever knows the address. With -q the address alone is
printed.

Examples:
  gearsim explore models/scenes/oh2005/energy_300rpm.toml
  gearsim explore models/scenes/backlash.toml --port 8600"
)]
pub(super) struct Explore {
    /// The scene: a TOML file, or - for the standard input
    scene: PathBuf,
    /// Port of 127.0.0.1; without it, any that is free
    #[arg(long, value_parser = clap::value_parser!(u16).range(1024..))]
    port: Option<u16>,
    #[command(flatten)]
    quiet: Quiet,
}

impl Verb for Explore {
    #[cfg(not(feature = "html"))]
    fn run(self) -> Result<(), Failure> {
        page::asked(true).map(|_| ())
    }

    #[cfg(feature = "html")]
    fn run(self) -> Result<(), Failure> {
        use super::{known, terminal};
        use crate::explore::{Explorer, Service};
        use crate::scene::Scene;

        page::asked(true)?;
        let scene = Scene::load_with(&self.scene, &[], &known::descriptions());
        let scene = scene.map_err(|mistakes| Failure::Scene(Box::new(mistakes)))?;
        scene.warnings.iter().for_each(|warning| terminal::warn(warning));
        scene.check()?;
        let service = Service::new(Explorer::new(scene)?, self.port.unwrap_or(0)).map_err(|error| {
            let what = format!("cannot serve a page on 127.0.0.1: {error}");
            Failure::Impossible { what, help: "leave out --port: then a free one is taken".into() }
        })?;
        let stopped = service.clone();
        ctrlc::set_handler(move || stopped.stop()).map_err(|error| Failure::Impossible {
            what: format!("cannot wait for Ctrl-C: {error}"),
            help: "start it in a terminal".into(),
        })?;
        // Without its address the page cannot be opened.
        let said = |text: String, alone: String| if self.quiet.quiet { alone } else { text };
        let url = service.url();
        terminal::print_out(&said(format!("open {url}\nCtrl-C ends it\n"), format!("{url}\n")));
        service.serve();
        terminal::print_out(&said("\nended\n".into(), String::new()));
        Ok(())
    }
}
