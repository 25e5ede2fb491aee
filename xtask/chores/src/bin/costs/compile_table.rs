//! The part of tests/costs.md on compile times.

use crate::build::Build;
use crate::format::{exponent, memory, time};
use crate::models::Compiled;

/// The line at which the part begins.
pub const TITLE: &str = "## Compile time\n";
/// Dependencies with a row of their own.
const NAMED: usize = 15;

/// The part, without its title.
pub fn write(models: &[Compiled], build: &Build) -> String {
    format!(
        "\nProcessor times of rustc, by `cargo xtask costs --compile`.\n\n\
         ### Models against the number n of coordinates\n\n\
         Each file of gearsim/src/generated is compiled by itself, optimised: its equations for all sets of effects, and these with the \
         engine for its number of coordinates. The exponent compares a model with the one above of the same kind.\n\n{}\n{}\n\
         ### gearsim and its dependencies\n\n\
         `cargo build --release --package gearsim` from scratch. A dependency's time includes its build script's compilation.\n\n{}",
        equations(models),
        growth(models),
        packages(build)
    )
}

fn equations(models: &[Compiled]) -> String {
    let mut text = String::from(
        "| model | n | its file | equations: compile time | exponent | code | with the engine: compile time | code |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let kind = |c: &Compiled| c.model.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut before: Option<&Compiled> = None;
    for c in models {
        let before = before.replace(c).filter(|b| kind(b) == kind(c));
        let grows = before.map_or(String::new(), |b| exponent([b.n, c.n], [b.equations.0, c.equations.0]));
        text += &format!(
            "| `{}` | {} | {} | {} | {grows} | {} | {} | {} |\n",
            c.model,
            c.n,
            memory(c.source as f64),
            time(c.equations.0),
            memory(c.equations.1 as f64),
            time(c.engine.0),
            memory(c.engine.1 as f64),
        );
    }
    text
}

/// What one more model adds to the compile time of gearsim.
fn growth(models: &[Compiled]) -> String {
    let median = |of: fn(&Compiled) -> f64| {
        let mut times: Vec<f64> = models.iter().map(of).collect();
        times.sort_by(f64::total_cmp);
        time(times.get(times.len() / 2).copied().unwrap_or(f64::NAN))
    };
    format!(
        "One more model adds {} to the compile time of gearsim if another model has the same n, else {} (medians of the table).\n",
        median(|c| c.equations.0),
        median(|c| c.engine.0)
    )
}

fn packages(build: &Build) -> String {
    let Build { library, program, dependencies, whole } = build;
    let sum = |part: &[(String, f64)]| part.iter().map(|(_, time)| time).sum::<f64>();
    let (named, others) = dependencies.split_at(NAMED.min(dependencies.len()));
    let all = sum(dependencies);
    let mut rows = vec![
        ("gearsim, library".to_owned(), *library),
        ("gearsim, program".into(), *program),
        (format!("all {} dependencies", dependencies.len()), all),
    ];
    rows.extend(named.iter().map(|(name, time)| (format!("of these: `{name}`"), *time)));
    rows.push((format!("of these: the other {}", others.len()), sum(others)));
    rows.push(("cargo, and runs of build scripts".into(), (whole - library - program - all).max(0.0)));
    rows.push(("the whole build".into(), *whole));
    let mut text = String::from("| package | processor time | share |\n| --- | --- | --- |\n");
    for (what, seconds) in rows {
        text += &format!("| {what} | {} | {:.1} % |\n", time(seconds), 100.0 * seconds / whole);
    }
    text
}
