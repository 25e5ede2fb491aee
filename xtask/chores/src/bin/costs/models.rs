//! Compile time of a model: a file of derived equations compiled by itself against the library of gearsim.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};

use crate::{many_effects, processor_time};

/// A model and the cost of compiling it.
pub struct Compiled {
    /// Name of the model.
    pub model: String,
    /// The number that the table compares: coordinates or effects.
    pub n: usize,
    /// Size of the file [bytes].
    pub source: u64,
    /// Processor time of rustc [s].
    pub time: f64,
    /// Size of the object file [bytes].
    pub code: u64,
}

/// Numbers of effects of the models that [`of_effects`] compiles.
const EFFECTS: [usize; 4] = [6, 12, 24, 48];

/// Compiles the file of each model.
///
/// # Errors
/// If one does not compile.
pub fn all() -> anyhow::Result<Vec<Compiled>> {
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../gearsim/generated/src");
    // The model `train` has no derived file: it is a part of the library.
    let each = gearsim::models().iter().map(|entry| entry.model).filter(|model| model.name != "train");
    each.map(|model| compile(model.name, model.coordinates.len(), &generated.join(format!("{}.rs", model.name))))
        .collect()
}

/// Compiles models that differ only in the number of effects.
///
/// # Errors
/// If one does not compile.
pub fn of_effects() -> anyhow::Result<Vec<Compiled>> {
    let one = |n: usize| {
        let file = folder()?.join(format!("{}.rs", many_effects::name(n)));
        std::fs::write(&file, many_effects::file(n))?;
        compile(&many_effects::name(n), n, &file)
    };
    EFFECTS.into_iter().map(one).collect()
}

/// Compiles a library with the file as module `derived`.
fn compile(name: &str, n: usize, file: &Path) -> anyhow::Result<Compiled> {
    let (release, folder) = (release()?, folder()?);
    let (source, object) = (folder.join("one.rs"), folder.join("one.o"));
    let type_name: String = name.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
    let text = format!(
        "#[path = {file:?}]\npub mod derived;\n\
         pub static ENTRY: gearsim::Entry = gearsim::Entry::new::<derived::{type_name}>();\n"
    );
    std::fs::write(&source, text)?;
    let before = processor_time::of_children()?;
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
    rustc.args(["--edition=2024", "--crate-type=lib", "--emit=obj"]);
    rustc.args(["-Copt-level=3", "-Ccodegen-units=1", "--cap-lints=allow"]);
    rustc.arg("--extern").arg(format!("gearsim={}", library(&release)?.display()));
    rustc.arg("-L").arg(format!("dependency={}", release.join("deps").display()));
    let output = rustc.arg("-o").arg(&object).arg(&source).output().context("cannot start rustc")?;
    if !output.status.success() {
        bail!("{} does not compile by itself:\n{}", file.display(), String::from_utf8_lossy(&output.stderr));
    }
    let time = processor_time::of_children()? - before;
    let size = |file: &Path| std::fs::metadata(file).map(|file| file.len());
    eprintln!("{name}: {time} s");
    Ok(Compiled { model: name.to_owned(), n, source: size(file)?, time, code: size(&object)? })
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
