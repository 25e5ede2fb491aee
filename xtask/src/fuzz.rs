//! `cargo xtask fuzz`: look for scenes and numbers that break the reader or the engine, with libFuzzer.
//!
//! Builds the targets with plain cargo and the compiler at hand. libFuzzer is to be told of the program's blocks and
//! comparisons, which any rustc can do; a sanitizer would have nothing to watch, there is no unsafe code. Only gearsim and the
//! targets are compiled so: this program stands between cargo and rustc, and adds the flags. All else is what other builds
//! have built. Needs a C++ compiler, for libFuzzer itself. New inputs go to `out/fuzz`, crashes too: the committed corpus
//! grows by hand.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context, bail};

/// The targets, `tests/fuzz/fuzz_targets`.
const TARGETS: [&str; 2] = ["scene", "engine"];
/// A single input may take as long [s].
const SLOWEST: u32 = 60;
/// Crates that libFuzzer is told of.
const WATCHED: [&str; 3] = ["gearsim", "scene", "engine"];
/// Set where this program stands in for rustc.
const COMPILING: &str = "GEARSIM_FUZZ_COMPILING";
/// What libFuzzer is told of the program: blocks reached, and numbers compared.
const INSTRUMENTATION: [&str; 6] = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
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
        TARGETS
            .into_iter()
            .filter(|target| self.target.as_deref().is_none_or(|named| named == *target))
            .try_for_each(|target| self.fuzz(&root, target))
    }

    fn fuzz(&self, root: &Path, target: &str) -> anyhow::Result<()> {
        let found = root.join("out/fuzz").join(target);
        let committed = root.join("tests/fuzz/corpus").join(target);
        std::fs::create_dir_all(&found).with_context(|| format!("cannot make the folder {}", found.display()))?;
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--locked", "--release", "--manifest-path"]).arg(root.join("tests/fuzz/Cargo.toml"));
        command.args(["--bin", target, "--"]).args([&found, &committed]);
        command.args([format!("-max_total_time={}", self.seconds), format!("-timeout={SLOWEST}")]);
        command.arg("-print_final_stats=1");
        command.arg(format!("-artifact_prefix={}/{target}-", root.join("out/fuzz").display()));
        if std::env::var_os("CARGO_TARGET_DIR").is_none() {
            command.env("CARGO_TARGET_DIR", root.join("target"));
        }
        command.env("RUSTC_WRAPPER", std::env::current_exe()?).env(COMPILING, "1");
        let status = command.current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the target `{target}` failed: put the input named above into {}", committed.display());
        }
        Ok(())
    }
}

/// Where cargo has called this program in place of rustc, with the whole command: runs it, with what libFuzzer needs.
pub fn compile() -> Option<ExitCode> {
    std::env::var_os(COMPILING)?;
    let mut arguments = std::env::args_os().skip(1);
    let rustc = arguments.next()?;
    let arguments: Vec<_> = arguments.collect();
    let watched = arguments.windows(2).any(|a| a[0] == "--crate-name" && WATCHED.iter().any(|name| a[1] == *name));
    let mut command = Command::new(rustc);
    command.args(arguments).args(INSTRUMENTATION.iter().filter(|_| watched));
    let compiled = command.status().is_ok_and(|status| status.success());
    Some(if compiled { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
