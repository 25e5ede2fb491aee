//! `gearsim new`: a crate for models of one's own.

use std::path::{Path, PathBuf};

use clap::Parser;

use super::failure::Failure;
use super::printing::Quiet;
use super::{Verb, known, terminal};
use crate::output::staging::Staging;
use crate::output::{OutputError, WholeFiles};

/// Write a crate for models of your own: energies, derived equations, a scene, tests, and a program
#[derive(Parser)]
#[command(
    name = "new",
    after_help = "\
The crate has a model to begin with, a motor that drives a wheel through a gear pair and a shaft.
Its program has all commands of gearsim. Its README.md is a tutorial that changes the model step by
step.

The crate is compiled with the sources of gearsim: it needs a checkout of gearsim, which must stay
where it is. The first build takes about 6 minutes of processor time, later ones take seconds.

Examples:
  gearsim new my-axle
  gearsim new drives/hoist --gearsim ../gearsim"
)]
pub(super) struct New {
    /// Folder of the new crate. Its last part is the name of the crate: small letters, digits and hyphens
    crate_folder: PathBuf,
    /// The checkout of gearsim on which the crate depends [default: the one that this program was built from]
    #[arg(long, value_name = "DIR")]
    gearsim: Option<PathBuf>,
    #[command(flatten)]
    quiet: Quiet,
}

/// The files of the crate: path, and text with the names of the template.
const FILES: &[(&str, &str)] = &[
    ("Cargo.toml", include_str!("new/template/Cargo.toml.txt")),
    ("README.md", include_str!("new/template/README.md")),
    (".gitignore", include_str!("new/template/gitignore.txt")),
    (".cargo/config.toml", include_str!("new/template/cargo/config.toml")),
    ("src/main.rs", include_str!("new/template/src/main.rs")),
    ("src/lib.rs", include_str!("new/template/src/lib.rs")),
    ("src/generated/mod.rs", include_str!("new/template/src/generated/mod.rs")),
    ("src/generated/my_axle.rs", include_str!("new/template/src/generated/my_axle.rs")),
    ("src/generated/text/my_axle.txt", include_str!("new/template/src/generated/text/my_axle.txt")),
    ("src/generated/latex/my_axle.tex", include_str!("new/template/src/generated/latex/my_axle.tex")),
    ("energies/Cargo.toml", include_str!("new/template/energies/Cargo.toml.txt")),
    ("energies/src/main.rs", include_str!("new/template/energies/src/main.rs")),
    ("energies/src/lib.rs", include_str!("new/template/energies/src/lib.rs")),
    ("energies/src/my_axle.rs", include_str!("new/template/energies/src/my_axle.rs")),
    ("energies/tests/derived.rs", include_str!("new/template/energies/tests/derived.rs")),
    ("scenes/my_axle.toml", include_str!("new/template/scenes/my_axle.toml")),
    ("tests/by_hand.rs", include_str!("new/template/tests/by_hand.rs")),
];

/// Names that the new crate cannot have: other crates in it, or Rust, use them.
const TAKEN: &[&str] = &["energies", "gearsim", "test", "core", "std", "alloc", "proc-macro"];

/// Words of Rust, which cannot be names of modules (The Rust Reference, "Keywords").
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true",
    "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

impl Verb for New {
    fn run(self) -> Result<(), Failure> {
        let name = name(&self.crate_folder)?;
        let gearsim = self.checkout()?;
        if self.crate_folder.exists() {
            let what = format!("{} exists already", self.crate_folder.display());
            return Err(Failure::Impossible { what, help: "give a folder that does not exist".into() });
        }
        let snake = name.replace('-', "_");
        let camel: String = name.split('-').map(capital).collect();
        let profiles = profiles(&gearsim);
        // A slash is valid in TOML strings and Rust paths on all systems.
        let gearsim = gearsim.display().to_string().replace('\\', "/");
        let failed = |source| OutputError::Write { path: self.crate_folder.clone(), source };
        // The crate appears when all its files are whole.
        let parent = self.crate_folder.parent().filter(|parent| *parent != Path::new("")).unwrap_or(Path::new("."));
        std::fs::create_dir_all(parent).map_err(failed)?;
        let staging = Staging::create(parent).map_err(failed)?;
        let from = staging.path().join("crate");
        let mut files = WholeFiles::create(&from).map_err(|error| error.moved(&from, &self.crate_folder))?;
        for (path, text) in FILES {
            let renamed = |text: &str| {
                let text = text.replace("my-axle", &name).replace("my_axle", &snake).replace("MyAxle", &camel);
                text.replace("{gearsim}", &gearsim).replace("{profiles}", &profiles)
            };
            let written = files.write_bytes(&renamed(path), renamed(text).as_bytes());
            written.map_err(|error| error.moved(&from, &self.crate_folder))?;
        }
        std::fs::rename(files.path(), &self.crate_folder).map_err(failed)?;
        if self.quiet.quiet {
            return Ok(());
        }
        let shown = self.crate_folder.display();
        terminal::print_out(&format!(
            "{shown} is a crate with the model `{snake}`. Next:\n\n  cd {shown}\n  cargo run --release -- run scenes/{snake}.toml\n\n\
             README.md there is a tutorial: change the model, derive it, test it.\n"
        ));
        Ok(())
    }
}

impl New {
    /// The folder of gearsim's sources, absolute.
    fn checkout(&self) -> Result<PathBuf, Failure> {
        let built_from = || Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let folder = self.gearsim.clone().unwrap_or_else(built_from);
        let found = folder.canonicalize().ok().filter(|folder| folder.join("gearsim/Cargo.toml").is_file());
        found.ok_or_else(|| Failure::Impossible {
            what: format!("{} is not a checkout of gearsim", folder.display()),
            help: "give the folder with the sources of gearsim: --gearsim ../gearsim".into(),
        })
    }
}

/// The name of the crate: the last part of its folder.
fn name(folder: &Path) -> Result<String, Failure> {
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let parts = name.split('-').all(|part| part.starts_with(|c: char| c.is_ascii_lowercase()));
    if KEYWORDS.contains(&name) || TAKEN.contains(&name) {
        let what = format!("`{name}` is reserved, and cannot be the name of the crate");
        return Err(Failure::Impossible { what, help: "take another name: my-axle".into() });
    }
    // The crate's model has the name of the crate.
    if known::models().iter().any(|entry| entry.model.name == name.replace('-', "_")) {
        let what = format!("`{name}` is a model of gearsim, and the crate's own model would hide it");
        return Err(Failure::Impossible { what, help: "take another name: my-axle".into() });
    }
    if name.is_empty() {
        let what = format!("{} names no new folder", folder.display());
        return Err(Failure::Impossible {
            what,
            help: "give the folder that is to be created: gearsim new my-axle".into(),
        });
    }
    if name.chars().all(plain) && parts && name.len() <= 60 {
        return Ok(name.into());
    }
    Err(Failure::Impossible {
        what: format!("`{name}` cannot be the name of the crate"),
        help: "take small letters and digits, words joined by hyphens, each beginning with a letter: my-axle".into(),
    })
}

/// The cargo profiles of the checkout. With them dependencies compile in a third of the time, and tests do not take minutes.
fn profiles(gearsim: &Path) -> String {
    let manifest = std::fs::read_to_string(gearsim.join("Cargo.toml")).unwrap_or_default();
    let profiles = manifest.lines().skip_while(|line| !line.starts_with("[profile"));
    let lines = profiles.filter(|line| !line.starts_with("gearsim-tests"));
    lines.collect::<Vec<_>>().join("\n")
}

/// A word with a capital first letter.
fn capital(word: &str) -> String {
    let (first, rest) = word.split_at(word.len().min(1));
    first.to_uppercase() + rest
}
