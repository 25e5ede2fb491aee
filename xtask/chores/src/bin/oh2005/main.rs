//! Runs the cases of Oh, Grosh & Barber (2005) again, and checks the claims of the paper; `cargo xtask oh2005` starts it.
//!
//! It writes the plots and the tables of models/scenes/oh2005/README.md. With `--check` it writes nothing, and fails if a table
//! differs from what the runs give.

mod energy;
mod figures;
mod long;
mod measure;
mod misprints;
mod paper;
mod printed;
mod scan;
mod spectra;
mod text;

use std::fs;

use anyhow::{Context, bail};
use clap::Parser;

use energy::Energies;
use scan::Scan;
use spectra::Spectra;
use text::{Part, number, table};

/// Run the cases of Oh, Grosh & Barber (2005) again: plots and tables of models/scenes/oh2005.
#[derive(Parser)]
#[command(name = "cargo xtask oh2005")]
struct Arguments {
    /// Write nothing; fail if a table of the README differs from what the runs give
    #[arg(long)]
    check: bool,
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    let readme = paper::folder().join("README.md");
    let old = fs::read_to_string(&readme).context("cannot read models/scenes/oh2005/README.md")?;
    let new = text::fill(&old, &parts()?)?;
    if arguments.check {
        if let Some((line, is, should)) = text::difference(&old, &new) {
            bail!(
                "models/scenes/oh2005/README.md differs from what the scenes give. Line {line} is\n  {is}\nand should be\n  \
                 {should}\nRun `cargo xtask oh2005` to write it anew, and check the difference"
            );
        }
        println!("models/scenes/oh2005/README.md agrees with what the scenes give");
        return Ok(());
    }
    let plots = paper::folder().join("plots");
    fs::create_dir_all(&plots)?;
    for (name, figure) in figures::all()? {
        fs::write(plots.join(format!("{name}.svg")), figure.svg()?)?;
        fs::write(plots.join(format!("{name}.png")), figure.png()?)?;
    }
    fs::write(&readme, new)?;
    println!("written: models/scenes/oh2005/README.md and plots/");
    Ok(())
}

/// All tables of the README.
fn parts() -> anyhow::Result<Vec<Part>> {
    let energies = Energies::run()?;
    let (slow, fast) = (Spectra::run(600)?, Spectra::run(4500)?);
    let scan = Scan::run()?;
    let long = long::run()?;
    let undamped = long::undamped()?;
    let [exact, _] = energies.committed().context("no energy balance at the T0 of the scenes")?;
    let known = misprints::Known { exact, long: &long, undamped: &undamped };
    Ok(vec![
        claims(&energies, &slow, &fast, &scan),
        misprints::misprints(&known),
        energies.table(),
        slow.table("600 rpm"),
        fast.table("4500 rpm"),
        long::long_table(&long),
        scan.by_torque(),
        scan.by_window(),
    ])
}

/// The claims of the paper, and at which T0 each holds.
fn claims(energies: &Energies, slow: &Spectra, fast: &Spectra, scan: &Scan) -> Part {
    let mut rows = energies.claims();
    let mut add = |claim: &str, t0: String, evidence: String| rows.push(vec![claim.into(), t0, evidence]);
    let (of_slow, of_fast) = (number(spectra::mesh(600), 4), number(spectra::mesh(4500), 4));
    add(
        "N1 Omega1/wd = 0.1 at 600 rpm, 0.75 at 4500 rpm",
        "all".into(),
        format!("{of_slow} and {of_fast}, with inertias 10^3 times the printed ones"),
    );
    add(
        "Fig. 4, 4500 rpm: the three sets of equations agree",
        fast.all_agree(),
        format!("within 1 dB in every band up to 4 wd. The exact spectrum differs at T0 = {}", fast.exact_differs()),
    );
    add(
        "Fig. 4, 600 rpm: (4)/(5) and (6) agree with each other",
        slow.rigid_agrees(),
        "within 1 dB in every band up to 4 wd".into(),
    );
    let reflects = slow.reflects();
    add(
        "Fig. 4, 600 rpm: the exact equations differ markedly from both",
        slow.exact_differs(),
        format!(
            "by more than 1 dB in some band; at T0 = {} they agree. The cause is the speed, which falls and so smears the \
             lines: at {} N m the highest density beyond 2.6 wd is {} times the classical one (at 4500 rpm: {}), while the \
             power of whole bands is nearly the same. At T0 = {reflects} the gear is turned back at a step within the 0.5 s",
            slow.exact_agrees(),
            paper::T0,
            number(slow.line(), 2),
            number(fast.line(), 2)
        ),
    );
    let (count, all, height) = scan.peaks();
    let [passing, any] = scan.largest();
    add(
        "Fig. 4, 600 rpm: a peak near 3.2 wd, nearly 400 times the classical amplitude",
        if count == 0 { "none".into() } else { format!("{count} of {all}") },
        format!(
            "{count} of {all} runs and windows have one: the band 3.0-3.4 wd has at most {} times the power of those beside \
             it. Its power is at most {} times the classical one where the gear passes every step, {} where it does not",
            number(height, 2),
            number(passing, 2),
            number(any, 2)
        ),
    );
    ("claims", table(&["the paper", "holds at T0 [N m]", "evidence"], &rows))
}
