//! `cargo xtask fuzz`: look for scenes and numbers that break the reader or the engine, with libFuzzer.
//!
//! Builds the targets with plain cargo and the compiler at hand: libFuzzer needs its coverage instrumentation, which any rustc
//! has, and no sanitizer, since there is no unsafe code to watch. Needs a C++ compiler, for libFuzzer itself. New inputs
//! go to `out/fuzz`, crashes too: the committed corpus grows by hand.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// The targets, `tests/fuzz/fuzz_targets`.
const TARGETS: [&str; 2] = ["scene", "engine"];
/// A single input may take as long [s].
const SLOWEST: u32 = 20;
/// What libFuzzer is told of the program: blocks reached, and numbers compared.
const INSTRUMENTATION: [&str; 7] = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Cdebug-assertions",
];

/// Look for inputs that break the scene reader or the engine.
#[derive(clap::Args)]
pub struct Fuzz {
    /// The target; all of them, if none is named.
    #[arg(value_parser = TARGETS)]
    target: Option<String>,
    /// Time for each target [s].
    #[arg(long, default_value_t = 30)]
    seconds: u32,
}

impl Fuzz {
    /// Runs the targets; the first crash ends it.
    pub fn run(&self) -> anyhow::Result<()> {
        let compiler = std::env::var_os("CXX").unwrap_or_else(|| OsString::from("c++"));
        if Command::new(&compiler).arg("--version").output().is_err() {
            bail!(
                "libFuzzer needs a C++ compiler, and `{}` does not start: install g++ or clang, or name one in CXX",
                compiler.display()
            );
        }
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        let host = host()?;
        TARGETS
            .into_iter()
            .filter(|target| self.target.as_deref().is_none_or(|named| named == *target))
            .try_for_each(|target| self.fuzz(&root, &host, target))
    }

    fn fuzz(&self, root: &Path, host: &str, target: &str) -> anyhow::Result<()> {
        let found = root.join("out/fuzz").join(target);
        let committed = root.join("tests/fuzz/corpus").join(target);
        std::fs::create_dir_all(&found).with_context(|| format!("cannot make the folder {}", found.display()))?;
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--locked", "--release", "--manifest-path"]).arg(root.join("tests/fuzz/Cargo.toml"));
        // With a target named, the flags are for what is fuzzed, not for build scripts and macros.
        command.args(["--target", host, "--bin", target, "--"]).args([&found, &committed]);
        command.args([format!("-max_total_time={}", self.seconds), format!("-timeout={SLOWEST}")]);
        command.arg("-print_final_stats=1");
        command.arg(format!("-artifact_prefix={}/{target}-", root.join("out/fuzz").display()));
        command.env("CARGO_ENCODED_RUSTFLAGS", INSTRUMENTATION.join("\u{1f}"));
        let status = command.current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the target `{target}` failed: put the input named above into {}", committed.display());
        }
        Ok(())
    }
}

/// The platform that this runs on, as rustc names it.
fn host() -> anyhow::Result<String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| OsString::from("rustc"));
    let told = Command::new(rustc).arg("-vV").output().context("cannot start rustc")?;
    let text = String::from_utf8(told.stdout).context("rustc -vV is not text")?;
    let host = text.lines().find_map(|line| line.strip_prefix("host: ")).context("rustc -vV names no host")?;
    Ok(host.to_string())
}
