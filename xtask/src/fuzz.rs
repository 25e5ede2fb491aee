//! `cargo xtask fuzz`: search with libFuzzer for inputs that break the readers or the engine. The targets: `tests/fuzz/README.md`.
//!
//! Builds the targets with cargo and the installed rustc. libFuzzer needs coverage instrumentation (basic blocks, comparisons), which
//! any rustc can add; a sanitizer is not needed, since there is no unsafe code. Only gearsim and the target `derived_file`, which contains
//! the macro, are instrumented: this program runs as cargo's rustc wrapper and adds the flags for these crates, so that dependencies of
//! other builds are reused. libFuzzer itself needs a C++ compiler. New inputs and crashes are written to `out/fuzz`; inputs are added to
//! the committed corpus by hand.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context, bail};

/// The targets, `tests/fuzz/fuzz_targets`.
const TARGETS: [&str; 6] = ["scene", "axes", "parts", "derived_file", "engine", "combination"];
/// Targets that run only if they are named; suites of the tests have random cases of both. A search of minutes in `combination` finds open
/// faults of rare combinations. In `parts` the reader of Parquet panics at damaged pages: gearsim catches that, and libFuzzer does not.
const NAMED: [&str; 2] = ["combination", "parts"];
/// Time limit for a single input [s].
const TIMEOUT: u32 = 60;
/// Crates that are instrumented.
const INSTRUMENTED: [&str; 4] = ["gearsim", "gearsim_equations", "gearsim_generated", "derived_file"];
/// Environment variable that is set while this program runs as rustc wrapper.
const COMPILING: &str = "GEARSIM_FUZZ_COMPILING";
/// The flags that add coverage instrumentation: blocks reached, and numbers compared.
const INSTRUMENTATION: [&str; 6] = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
];

/// Search for inputs that break the readers or the engine.
#[derive(clap::Args)]
pub struct Fuzz {
    /// The target; without it, all but `combination` and `parts`.
    #[arg(value_parser = TARGETS)]
    target: Option<String>,
    /// Time for each target [s].
    #[arg(long, default_value_t = 30)]
    seconds: u32,
}

impl Fuzz {
    /// Runs the targets, until one fails.
    ///
    /// # Errors
    /// If there is no C++ compiler, or a target finds an input that crashes or takes too long.
    pub fn run(&self) -> anyhow::Result<()> {
        let compiler = std::env::var_os("CXX").unwrap_or_else(|| OsString::from("c++"));
        if Command::new(&compiler).arg("--version").output().is_err() {
            bail!(
                "libFuzzer needs a C++ compiler, but `{}` cannot be started: install g++ or clang, or set CXX",
                compiler.display()
            );
        }
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        TARGETS
            .into_iter()
            .filter(|target| self.target.as_deref().map_or(!NAMED.contains(target), |named| named == *target))
            .try_for_each(|target| self.fuzz(&root, target))
    }

    fn fuzz(&self, root: &Path, target: &str) -> anyhow::Result<()> {
        let found = root.join("out/fuzz").join(target);
        let committed = root.join("tests/fuzz/corpus").join(target);
        std::fs::create_dir_all(&found).with_context(|| format!("cannot make the folder {}", found.display()))?;
        let itself = std::env::current_exe()?;
        let cargo = |what: &str| {
            let mut command = Command::new(env!("CARGO"));
            command.args([what, "--locked", "--release", "--manifest-path"]).arg(root.join("tests/fuzz/Cargo.toml"));
            if std::env::var_os("CARGO_TARGET_DIR").is_none() {
                command.env("CARGO_TARGET_DIR", root.join("target"));
            }
            command.args(["--bin", target]).env("RUSTC_WRAPPER", &itself).env(COMPILING, "1").current_dir(root);
            command
        };
        if !cargo("build").status().context("cannot start cargo")?.success() {
            bail!("the target `{target}` could not be built");
        }
        let mut command = cargo("run");
        command.arg("--").args([&found, &committed]);
        command.args([format!("-max_total_time={}", self.seconds), format!("-timeout={TIMEOUT}")]);
        command.arg("-print_final_stats=1");
        command.arg(format!("-artifact_prefix={}/{target}-", root.join("out/fuzz").display()));
        if !command.status().context("cannot start cargo")?.success() {
            bail!("the target `{target}` failed; add the input named above to the corpus {}", committed.display());
        }
        Ok(())
    }
}

/// If cargo has called this program as rustc wrapper, runs rustc, with instrumentation for [`INSTRUMENTED`] crates, and returns its
/// exit code; otherwise `None`.
pub fn compile() -> Option<ExitCode> {
    std::env::var_os(COMPILING)?;
    let mut arguments = std::env::args_os().skip(1);
    let rustc = arguments.next()?;
    let arguments: Vec<_> = arguments.collect();
    let instrumented =
        arguments.windows(2).any(|a| a[0] == "--crate-name" && INSTRUMENTED.iter().any(|name| a[1] == *name));
    let mut command = Command::new(rustc);
    command.args(arguments).args(INSTRUMENTATION.iter().filter(|_| instrumented));
    let compiled = command.status().is_ok_and(|status| status.success());
    Some(if compiled { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};
    use std::path::Path;

    fn read(file: &str) -> String {
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file)).unwrap()
    }

    /// The settings of the release profile in a manifest, without those of crates that are instrumented.
    fn profile(manifest: &str) -> BTreeSet<String> {
        let text = read(manifest);
        let (_, release) = text.split_once("[profile.release]\n").unwrap();
        let (release, _) = release.split_once("[profile.release.package.").unwrap_or((release, ""));
        let own = ["gearsim.debug", "gearsim.overflow-checks"];
        let settings = release.lines().filter(|line| line.contains(" = ") && !line.starts_with('#'));
        settings.filter(|line| !own.iter().any(|own| line.starts_with(own))).map(str::to_owned).collect()
    }

    /// The versions of each package in a lock file.
    fn versions(lock: &str) -> BTreeMap<String, BTreeSet<String>> {
        let mut versions = BTreeMap::<String, BTreeSet<String>>::new();
        let text = read(lock);
        for package in text.split("[[package]]").skip(1) {
            let value =
                |key: &str| package.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = ")).unwrap();
            versions.entry(value("name").into()).or_default().insert(value("version").into());
        }
        versions
    }

    /// A dependency that is compiled with other settings or in another version is compiled once more.
    #[test]
    fn the_other_workspaces_have_the_dependencies_of_this_one() {
        let mut here = profile("Cargo.toml");
        assert!(here.len() > 20, "{here:?}");
        assert_eq!(profile("tests/fuzz/Cargo.toml"), here);
        assert!(here.remove("parquet.opt-level = 0"));
        assert_eq!(profile("gearsim/python/Cargo.toml"), here);
        let manifest = read("gearsim/Cargo.toml");
        let (_, dependencies) = manifest.split_once("[dependencies]\n").unwrap();
        let (dependencies, _) = dependencies.split_once("\n[").unwrap();
        let here = versions("Cargo.lock");
        for lock in ["tests/fuzz/Cargo.lock", "gearsim/python/Cargo.lock"] {
            let there = versions(lock);
            for line in dependencies.lines().filter(|line| !line.starts_with('#') && !line.contains("optional")) {
                let name = line.split(['.', ' ']).next().unwrap();
                assert!(
                    name.is_empty() || there.contains_key(&format!("\"{name}\"")),
                    "{lock} lacks {name}: run `cargo tree` there"
                );
            }
            for (name, there) in there {
                let known = here.get(&name).is_none_or(|here| there.is_subset(here));
                assert!(known, "{lock}: {name} {there:?}. Copy Cargo.lock there, then run `cargo tree` there");
            }
        }
    }
}
