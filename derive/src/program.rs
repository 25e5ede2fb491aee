//! The program that derives the models of a crate and writes their files.
//!
//! Usage: `[--check] [MODEL]...`. Without a licence key Symbolica allows one process and one thread at a time on a machine, so
//! that this program uses one thread.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use crate::{Expr, Home, Model, derive};

/// A model's name and the function that describes it.
pub type Entry = (&'static str, fn(&mut Model));

/// Derives the models that the arguments of the process name, or all, and writes their files to `folder`. With `--check` it writes nothing
/// and fails if a file differs from what the energies give.
pub fn program(models: &[Entry], folder: &Path, home: Home<'_>) -> ExitCode {
    match run(models, folder, home) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(models: &[Entry], folder: &Path, home: Home<'_>) -> Result<(), String> {
    let (flags, names): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|a| a.starts_with("--"));
    let check = match flags.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        _ => return Err(format!("unknown option in {flags:?}; allowed is --check")),
    };
    let known: Vec<&str> = models.iter().map(|m| m.0).collect();
    if let Some(name) = names.iter().find(|n| !known.contains(&n.as_str())) {
        return Err(format!("no model `{name}`; there are: {}", known.join(", ")));
    }
    // The computer algebra starts up at its first expression. This time must not be part of the time of the first model.
    let _ = Expr::from(0) + 1;
    let mut stale = vec![];
    for (name, describe) in models.iter().filter(|m| names.is_empty() || names.iter().any(|n| n == m.0)) {
        let start = Instant::now();
        let files = derive(&Model::new(name, describe)).map_err(|slip| slip.to_string())?.files(home);
        let old = |path: &str| std::fs::read_to_string(folder.join(path)).unwrap_or_default();
        let fresh = files.iter().all(|(path, text)| *text == old(path));
        let milliseconds = 1e3 * start.elapsed().as_secs_f64();
        match (check, fresh) {
            (_, true) => println!("{name}: up to date ({milliseconds:.1} ms)"),
            (true, false) => stale.push(*name),
            (false, false) => {
                files.iter().try_for_each(|(path, text)| write(&folder.join(path), text))?;
                println!("{name}: derived, proved and written to {name}.rs ({milliseconds:.1} ms)");
            }
        }
    }
    match stale.join(" ") {
        none if none.is_empty() => Ok(()),
        stale => Err(format!(
            "committed files differ from what the energies give. Update them with: {} {stale}",
            home.command
        )),
    }
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    let written = path.parent().map_or(Ok(()), std::fs::create_dir_all).and_then(|()| std::fs::write(path, text));
    written.map_err(|error| format!("cannot write {}: {error}", path.display()))
}
