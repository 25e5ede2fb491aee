//! What derived equations cost the compiler: each generated file compiled by itself against the library, once for its
//! equations alone, once with the engine for its number of coordinates.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};
use gearsim::generated::MODELS;

/// One generated file.
pub struct Compiled {
    pub model: &'static str,
    /// Coordinates.
    pub n: usize,
    /// Size of the file [bytes].
    pub source: u64,
    /// Processor time of the compiler [s], and size of the code [bytes]: of the equations, and with an engine.
    pub equations: (f64, u64),
    pub engine: (f64, u64),
}

/// The files to compile: two families.
const FILES: [&str; 11] = [
    "chain_2",
    "chain_5",
    "chain_32",
    "planetary_3",
    "planetary_4",
    "planetary_5",
    "planetary_6",
    "planetary_7",
    "planar_planetary_3",
    "planar_planetary_4",
    "planar_planetary_5",
];

/// Compiles all of them.
///
/// # Errors
/// Where one does not compile.
pub fn all() -> anyhow::Result<Vec<Compiled>> {
    FILES.iter().map(|name| one(name)).collect()
}

fn one(name: &'static str) -> anyhow::Result<Compiled> {
    let model = MODELS.iter().map(|entry| entry.model).find(|model| model.name == name);
    let model = model.with_context(|| format!("there is no model {name}"))?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/generated/{name}.rs"));
    let n = model.coordinates.len();
    let type_name: String = name.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
    let equations = format!(
        "pub fn equations(e: u32, p: &[f64], m: &[f64]) -> Option<Box<dyn gearsim::engine::equations::Equations<{n}>>> {{
            <model::{type_name} as gearsim::engine::equations::Derived<{n}>>::equations(e, p, m)
        }}"
    );
    let engine =
        format!("pub static ENTRY: gearsim::run::Entry = gearsim::run::Entry::new::<model::{type_name}, {n}>();");
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

/// Processor time and size of the code of a library that has the file as a module, and `item`.
fn compile(file: &Path, item: &str) -> anyhow::Result<(f64, u64)> {
    let own = std::env::current_exe()?;
    let release = own.ancestors().nth(2).context("the example is not where cargo builds it")?;
    let folder = release.join("costs");
    std::fs::create_dir_all(&folder)?;
    let source = folder.join("one.rs");
    let text = format!("pub use gearsim::{{engine, model}};\n#[path = {file:?}]\npub mod model_file;\n{item}\n");
    std::fs::write(&source, text.replace("model_file", "derived").replace("model::", "derived::"))?;
    let object = folder.join("one.o");
    let before = children()?;
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
    rustc.args([
        "--edition=2024",
        "--crate-type=lib",
        "--emit=obj",
        "-Copt-level=3",
        "-Ccodegen-units=1",
        "--cap-lints=allow",
    ]);
    rustc.arg("--extern").arg(format!("gearsim={}", library(release)?.display()));
    rustc.arg("--extern").arg(format!("gearsim_macros={}", macros(release)?.display()));
    rustc.arg("-L").arg(format!("dependency={}", release.join("deps").display()));
    let output = rustc.arg("-o").arg(&object).arg(&source).output().context("cannot start rustc")?;
    if !output.status.success() {
        bail!("{} does not compile by itself:\n{}", file.display(), String::from_utf8_lossy(&output.stderr));
    }
    Ok((children()? - before, std::fs::metadata(&object)?.len()))
}

fn library(release: &Path) -> anyhow::Result<PathBuf> {
    let library = release.join("libgearsim.rlib");
    if !library.exists() {
        bail!("{} is not there: `cargo build --release -p gearsim --lib` builds it", library.display());
    }
    Ok(library)
}

/// The proc-macro of the library, the newest where there are several.
fn macros(release: &Path) -> anyhow::Result<PathBuf> {
    let ours = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libgearsim_macros-") && path.extension().is_some_and(|e| e == std::env::consts::DLL_EXTENSION)
    };
    let files = std::fs::read_dir(release.join("deps"))?.filter_map(|entry| Some(entry.ok()?.path()));
    let newest = files.filter(ours).max_by_key(|path| path.metadata().and_then(|m| m.modified()).ok());
    newest.context("the proc-macro of the library is not where cargo builds it")
}

/// Processor time of all child processes so far [s].
fn children() -> anyhow::Result<f64> {
    let stat =
        std::fs::read_to_string("/proc/self/stat").context("processor times of others are measured on Linux only")?;
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or("").split_whitespace().collect();
    // Fields 16 and 17 of the whole line, in ticks of 1/100 s: proc(5).
    let ticks = |i: usize| fields.get(i - 3).and_then(|field| field.parse::<f64>().ok());
    let sum = ticks(16).zip(ticks(17)).map(|(user, system)| (user + system) / 100.0);
    sum.context("the system does not tell what its child processes took")
}
