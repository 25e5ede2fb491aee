//! `cargo xtask fuzz`: look for scenes and numbers that break the reader or the engine, with libFuzzer.
//!
//! Needs a nightly compiler and cargo-fuzz; installs neither. New inputs go to `out/fuzz`, crashes too: the committed
//! corpus grows by hand.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail};

/// The targets, `tests/fuzz/fuzz_targets`.
const TARGETS: [&str; 2] = ["scene", "engine"];
/// A single input may take as long [s].
const SLOWEST: u32 = 20;

/// Look for inputs that break the scene reader or the engine.
#[derive(clap::Args)]
pub struct Fuzz {
    /// Time for each target [s].
    #[arg(long, default_value_t = 30)]
    seconds: u32,
}

impl Fuzz {
    /// Runs both targets; the first crash ends it.
    pub fn run(&self) -> anyhow::Result<()> {
        let missing: Vec<_> = [
            (
                !works(&["+nightly", "--version"]),
                "a nightly compiler: rustup toolchain install nightly --profile minimal",
            ),
            (!works(&["fuzz", "--version"]), "cargo-fuzz: cargo install cargo-fuzz --locked"),
        ]
        .into_iter()
        .filter_map(|(missing, what)| missing.then_some(what))
        .collect();
        if !missing.is_empty() {
            bail!("fuzzing needs what is not installed:\n  {}", missing.join("\n  "));
        }
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        TARGETS.into_iter().try_for_each(|target| self.fuzz(&root, target))
    }

    fn fuzz(&self, root: &Path, target: &str) -> anyhow::Result<()> {
        let (found, committed): (PathBuf, PathBuf) =
            (root.join("out/fuzz").join(target), root.join("tests/fuzz/corpus").join(target));
        std::fs::create_dir_all(&found).with_context(|| format!("cannot make the folder {}", found.display()))?;
        let mut command = Command::new("cargo");
        command.args(["+nightly", "fuzz", "run", "--fuzz-dir"]).arg(root.join("tests/fuzz")).arg(target);
        command.args([&found, &committed]).arg("--");
        command.args([format!("-max_total_time={}", self.seconds), format!("-timeout={SLOWEST}")]);
        command.arg(format!("-artifact_prefix={}/", root.join("out/fuzz").display()));
        // The compiler that runs this chore is not the one that fuzzing needs, nor is its folder.
        command.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO").env_remove("CARGO_TARGET_DIR");
        let status = command.current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the target `{target}` failed: put the input named above into {}", committed.display());
        }
        Ok(())
    }
}

/// Whether cargo, as the user has it, answers.
fn works(arguments: &[&str]) -> bool {
    let mut command = Command::new("cargo");
    command.args(arguments).env_remove("RUSTUP_TOOLCHAIN").stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}
