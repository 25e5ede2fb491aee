//! Compile time of gearsim and of its dependencies: the processor time of every rustc process in a build from scratch.
//!
//! Cargo builds gearsim in an empty target folder with this program as RUSTC_WRAPPER: it calls the program in place of
//! rustc. The program starts rustc, and appends the package and the processor time to a log.

use std::collections::BTreeMap;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

use crate::{models, processor_time};

/// The environment variable that names the log, and tells this program that it stands in for rustc.
const LOG: &str = "GEARSIM_COSTS_LOG";

/// Processor times of a build [s]: user and system time of rustc and of the linker, to 0.02 s for each call of rustc.
pub struct Build {
    /// The processor time of each crate of gearsim, and of its program, with its name in the table.
    pub gearsim: Vec<(String, f64)>,
    /// Each dependency by its name, all its versions and its build script included, the longest time first.
    pub dependencies: Vec<(String, f64)>,
    /// The whole build: also cargo itself and the runs of build scripts.
    pub whole: f64,
}

/// The crates of gearsim: package, whether it is the program, and name in the table.
const GEARSIM: [(&str, bool, &str); 4] = [
    ("gearsim-equations", false, "gearsim, interface of the equations"),
    ("gearsim-generated", false, "gearsim, derived models"),
    ("gearsim", false, "gearsim, library"),
    ("gearsim", true, "gearsim, program"),
];

/// Builds gearsim from scratch in the release profile.
///
/// # Errors
/// If gearsim does not build, or if the system does not report processor times.
pub fn gearsim() -> anyhow::Result<Build> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    let folder = models::folder()?.join("scratch");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    let log = folder.join("log");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--locked", "--package", "gearsim", "--target-dir"]).arg(&folder);
    cargo.env("RUSTC_WRAPPER", std::env::current_exe()?).env(LOG, &log).env_remove("RUSTC_WORKSPACE_WRAPPER");
    let before = processor_time::of_children()?;
    if !cargo.current_dir(root).status().context("cannot start cargo")?.success() {
        bail!("gearsim does not build; the compiler's messages are above");
    }
    let whole = processor_time::of_children()? - before;
    let text = std::fs::read_to_string(&log).with_context(|| format!("cannot read {}", log.display()))?;
    std::fs::remove_dir_all(&folder)?;
    read(&text, whole)
}

/// The build from its log: a line per call of rustc with package, kind of crate and processor time [s].
fn read(log: &str, whole: f64) -> anyhow::Result<Build> {
    let mut times = BTreeMap::<(&str, bool), f64>::new();
    for line in log.lines() {
        let fields: Vec<&str> = line.split(' ').collect();
        let [package, kind, seconds] = fields[..] else { bail!("the log of the build has the line `{line}`") };
        *times.entry((package, package == "gearsim" && kind == "bin")).or_default() += seconds.parse::<f64>()?;
    }
    let mut gearsim = vec![];
    for (package, is_program, name) in GEARSIM {
        let time = times.remove(&(package, is_program));
        gearsim.push((name.to_owned(), time.with_context(|| format!("the log of the build does not name {package}"))?));
    }
    let mut dependencies: Vec<_> = times.into_iter().map(|((name, _), time)| (name.to_owned(), time)).collect();
    dependencies.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(Build { gearsim, dependencies, whole })
}

/// If cargo has called this program in place of rustc: runs rustc, logs its processor time, and returns its exit code.
///
/// # Errors
/// If rustc does not start, or if the log cannot be written.
pub fn as_rustc() -> anyhow::Result<Option<i32>> {
    let Some(log) = std::env::var_os(LOG) else { return Ok(None) };
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let (rustc, arguments) = arguments.split_first().context("rustc is not named")?;
    let status = Command::new(rustc).args(arguments).status().context("cannot start rustc")?;
    let after = |flag: &str| arguments.windows(2).find(|pair| pair[0] == flag).map(|pair| pair[1].to_string_lossy());
    // Cargo also calls rustc to ask for its version and its targets: without a crate, or with one called `___`.
    if after("--crate-name").is_some_and(|name| name != "___") {
        let package = std::env::var("CARGO_PKG_NAME").context("cargo does not name the package")?;
        let kind = after("--crate-type").unwrap_or_default();
        let line = format!("{package} {kind} {}\n", processor_time::of_children()?);
        // One call of write(2), because cargo runs several rustc at once.
        OpenOptions::new().create(true).append(true).open(log)?.write_all(line.as_bytes())?;
    }
    Ok(Some(status.code().unwrap_or(1)))
}
