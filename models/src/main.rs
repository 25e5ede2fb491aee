//! The derivation program behind `cargo xtask derive`, the only program that runs the computer algebra system.
//!
//! Usage: `[--check] [MODEL]...`. Without a licence key Symbolica allows one process and one thread at a time on a machine, so
//! that this program uses one thread, and `xtask` starts one derivation after another.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use anyhow::{Context, bail};
use gearsim_derive::{Expr, Model, derive};
use gearsim_models::MODELS;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> anyhow::Result<()> {
    let (flags, names): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|a| a.starts_with("--"));
    let check = match flags.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        _ => bail!("unknown option in {flags:?}; allowed is --check"),
    };
    let known: Vec<&str> = MODELS.iter().map(|m| m.0).collect();
    if let Some(name) = names.iter().find(|n| !known.contains(&n.as_str())) {
        bail!("no model `{name}`; there are: {}", known.join(", "));
    }
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../gearsim/src/generated");
    // The computer algebra starts with its first expression: not in the time of the first model.
    let _ = Expr::from(0) + 1;
    let mut stale = vec![];
    for (name, describe) in MODELS.iter().filter(|m| names.is_empty() || names.iter().any(|n| n == m.0)) {
        let start = Instant::now();
        let files = derive(&Model::new(name, describe))?.files();
        let old = |path: &str| std::fs::read_to_string(folder.join(path)).unwrap_or_default();
        let fresh = files.iter().all(|(path, text)| *text == old(path));
        let milliseconds = 1e3 * start.elapsed().as_secs_f64();
        match (check, fresh) {
            (_, true) => println!("{name}: up to date ({milliseconds:.1} ms)"),
            (true, false) => stale.push(*name),
            (false, false) => {
                for (path, text) in files {
                    let path = folder.join(path);
                    path.parent().map_or(Ok(()), std::fs::create_dir_all)?;
                    std::fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
                }
                println!(
                    "{name}: derived, proved and written to gearsim/src/generated/{name}.rs ({milliseconds:.1} ms)"
                );
            }
        }
    }
    if !stale.is_empty() {
        bail!(
            "these committed files differ from what the energies give: {}. Update them with: cargo xtask derive {}",
            stale.join(", "),
            stale.join(" ")
        );
    }
    Ok(())
}
