//! Compile time of a model: its generated file compiled by itself against the library of gearsim, once with the equations
//! alone, once with the engine for its number of coordinates.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};
use gearsim::generated::MODELS;
use gearsim::model::Model;

use crate::processor_time;

/// A model and what rustc needed for it.
pub struct Compiled {
    /// Name of the model.
    pub model: &'static str,
    /// Number of coordinates.
    pub n: usize,
    /// Size of the generated file [bytes].
    pub source: u64,
    /// Of the equations: processor time of rustc [s], size of the object file [bytes].
    pub equations: (f64, u64),
    /// The same of the equations and the engine.
    pub engine: (f64, u64),
}

/// Compiles the file of each model.
///
/// # Errors
/// If one does not compile.
pub fn all() -> anyhow::Result<Vec<Compiled>> {
    MODELS.iter().map(|entry| one(entry.model)).collect()
}

fn one(model: &'static Model) -> anyhow::Result<Compiled> {
    let (name, n) = (model.name, model.coordinates.len());
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../gearsim/src/generated/{name}.rs"));
    let type_name: String = name.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
    let equations = format!(
        "pub fn equations(e: u32, p: &[f64], m: &[f64]) -> Option<Box<dyn gearsim::engine::equations::Equations<{n}>>> {{
            <derived::{type_name} as gearsim::engine::equations::Derived<{n}>>::equations(e, p, m)
        }}"
    );
    let engine =
        format!("pub static ENTRY: gearsim::run::Entry = gearsim::run::Entry::new::<derived::{type_name}, {n}>();");
    let compiled = Compiled {
        model: name,
        n,
        source: std::fs::metadata(&file).with_context(|| format!("cannot read {}", file.display()))?.len(),
        equations: compile(&file, &equations)?,
        engine: compile(&file, &engine)?,
    };
    eprintln!("{name}: {:?} {:?}", compiled.equations, compiled.engine);
    Ok(compiled)
}

/// Compiles a library with the generated file as module `derived`, and with `item`: processor time [s], size of the object file [bytes].
fn compile(file: &Path, item: &str) -> anyhow::Result<(f64, u64)> {
    let (release, folder) = (release()?, folder()?);
    let (source, object) = (folder.join("one.rs"), folder.join("one.o"));
    let text = format!("pub use gearsim::{{engine, model}};\n#[path = {file:?}]\npub mod derived;\n{item}\n");
    std::fs::write(&source, text)?;
    let before = processor_time::of_children()?;
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
    rustc.args(["--edition=2024", "--crate-type=lib", "--emit=obj"]);
    rustc.args(["-Copt-level=3", "-Ccodegen-units=1", "--cap-lints=allow"]);
    rustc.arg("--extern").arg(format!("gearsim={}", library(&release)?.display()));
    rustc.arg("--extern").arg(format!("gearsim_macros={}", macros(&release)?.display()));
    rustc.arg("-L").arg(format!("dependency={}", release.join("deps").display()));
    let output = rustc.arg("-o").arg(&object).arg(&source).output().context("cannot start rustc")?;
    if !output.status.success() {
        bail!("{} does not compile by itself:\n{}", file.display(), String::from_utf8_lossy(&output.stderr));
    }
    Ok((processor_time::of_children()? - before, std::fs::metadata(&object)?.len()))
}

/// The folder of cargo's release profile, in which this program is.
fn release() -> anyhow::Result<PathBuf> {
    let folder = std::env::current_exe()?.parent().map(Path::to_path_buf);
    folder.context("the program is not in a folder of cargo's")
}

/// A folder for files of the measurements, `costs` in the target folder.
pub fn folder() -> anyhow::Result<PathBuf> {
    let folder = release()?.with_file_name("costs");
    std::fs::create_dir_all(&folder).with_context(|| format!("cannot make the folder {}", folder.display()))?;
    Ok(folder)
}

fn library(release: &Path) -> anyhow::Result<PathBuf> {
    let library = release.join("libgearsim.rlib");
    if !library.exists() {
        bail!("{} does not exist: run `cargo build --release -p gearsim --lib`", library.display());
    }
    Ok(library)
}

/// The proc-macro of the library; the newest if there are several.
fn macros(release: &Path) -> anyhow::Result<PathBuf> {
    let ours = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libgearsim_macros-") && path.extension().is_some_and(|e| e == std::env::consts::DLL_EXTENSION)
    };
    let files = std::fs::read_dir(release.join("deps"))?.filter_map(|entry| Some(entry.ok()?.path()));
    let newest = files.filter(ours).max_by_key(|path| path.metadata().and_then(|m| m.modified()).ok());
    newest.context("the proc-macro gearsim_macros is not in the folder deps of the release profile")
}
