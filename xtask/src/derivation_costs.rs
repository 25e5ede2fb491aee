//! `cargo xtask derivation-costs`: instructions of derivations with their proofs, under callgrind.

use std::process::Command;

use anyhow::{Context, bail};

use xtask::callgrind::instructions;

use crate::chore;

/// The models that are derived.
const MODELS: [&str; 3] = ["gear_pair", "planar_planetary_5", "chain_128"];
/// The program that derives them, an example of `gearsim-models`.
const PROGRAM: &str = "scale";
/// The file with the table.
const TABLE: &str = "tests/derivation-costs.md";
/// Largest relative increase over a committed count: versions of the compiler and of the C library change the counts.
const TOLERANCE: f64 = 0.05;

/// Count the instructions of derivations with their proofs under callgrind; write them to tests/derivation-costs.md.
#[derive(clap::Args)]
pub struct DerivationCosts {
    /// Write nothing; fail if a count is more than 5 % above that in the table.
    #[arg(long)]
    check: bool,
}

impl DerivationCosts {
    /// Counts, and writes or compares.
    ///
    /// # Errors
    /// If a model cannot be derived or valgrind started, or a count is too large.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = chore::root()?;
        // `--workspace`: with the same features as for the tests, so that Symbolica is compiled once.
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--quiet", "--locked", "--workspace", "--example", PROGRAM]).current_dir(root);
        if !build.status().context("cannot start cargo")?.success() {
            bail!("the program that derives does not compile; the compiler's messages are above");
        }
        let counts = MODELS.iter().map(|model| count(model)).collect::<anyhow::Result<Vec<_>>>()?;
        let path = root.join(TABLE);
        if !self.check {
            std::fs::write(&path, table(&counts)?)?;
            println!("written: {TABLE}");
            return Ok(());
        }
        let kept = std::fs::read_to_string(&path).with_context(|| format!("cannot read {TABLE}"))?;
        for (model, now) in MODELS.iter().zip(&counts) {
            let row = kept.lines().find(|line| line.starts_with(&format!("| `{model}` |")));
            let then = row.and_then(|row| row.split('|').nth(2)?.trim().parse::<f64>().ok());
            let then = then.with_context(|| format!("{TABLE} has no row of `{model}`"))?;
            if *now > (1.0 + TOLERANCE) * then {
                bail!(
                    "the derivation of `{model}` takes {now:.1} million instructions, {then:.1} in {TABLE}. If the change is intended, run \
                     `cargo xtask derivation-costs` to write the table anew"
                );
            }
            println!("{model:20} {now:10.1}");
        }
        Ok(())
    }
}

/// Instructions of the derivation of a model [1e6].
fn count(model: &str) -> anyhow::Result<f64> {
    let (count, _) = instructions("*scale::derived*", &program()?, &["--once", model])?;
    if count < 1e6 {
        bail!("callgrind counted {count} instructions for the derivation of `{model}`");
    }
    Ok(count / 1e6)
}

/// The file of [`PROGRAM`]: cargo puts examples into a folder beside the programs, also if another target folder is set.
fn program() -> anyhow::Result<std::path::PathBuf> {
    let itself = std::env::current_exe().context("cannot tell where this program is")?;
    Ok(itself.with_file_name("examples").join(PROGRAM).with_extension(std::env::consts::EXE_EXTENSION))
}

/// The table, with the times that the same program measures without callgrind.
fn table(counts: &[f64]) -> anyhow::Result<String> {
    let output = Command::new(program()?).args(MODELS).output().context("cannot start the program that derives")?;
    let times = String::from_utf8(output.stdout)?;
    let time = |model: &str| {
        let row = times.lines().find(|line| line.starts_with(&format!("| {model} |")));
        row.and_then(|row| row.split('|').nth(2)).map(str::trim).context("a row of the times is missing")
    };
    let mut text = format!(
        "# Cost of derivations\n\nA derivation with its proofs, without writing its file. Measured by `cargo xtask derivation-costs` under callgrind; with `--check`, as in \
         CI, a count must not\nbe more than {} % above that in the table. The time is the shortest of three on one core of the machine that wrote \
         the table.\n\n| model | million instructions | time |\n| --- | ---: | ---: |\n",
        100.0 * TOLERANCE
    );
    for (model, count) in MODELS.iter().zip(counts) {
        text += &format!("| `{model}` | {count:.1} | {} |\n", time(model)?);
    }
    Ok(text)
}
