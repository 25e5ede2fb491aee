//! The part of tests/costs.md on compile times.

use crate::build::Build;
use crate::format::{exponent, memory, time};
use crate::models::Compiled;

/// The line at which the part begins.
pub const TITLE: &str = "## Compile time\n";
/// Dependencies with a row of their own.
const NAMED: usize = 15;

/// The part, without its title.
pub fn write(models: &[Compiled], effects: &[Compiled], build: &Build) -> String {
    format!(
        "\nProcessor times of rustc, by `cargo xtask costs --compile`. Each model is compiled by itself, optimised. The exponent compares \
         it with the one above of the same kind.\n\n\
         ### Models against the number n of coordinates\n\n\
         Each file of gearsim/generated/src.\n\n{}\n\
         One more model adds {} to the compile time of gearsim (median of the table).\n\n\
         ### Models against the number n of effects\n\n\
         A chain whose n springs have a transmission error and a damper each, every one an effect of its own: all 2^n sets are admissible.\n\n\
         {}\n\
         ### gearsim and its dependencies\n\n\
         `cargo build --release --package gearsim` from scratch. A dependency's time includes its build script's compilation.\n\n{}",
        table(models),
        time(median(models)),
        table(effects),
        packages(build)
    )
}

fn table(models: &[Compiled]) -> String {
    let mut text = String::from(
        "| model | n | its file | compile time | exponent | code |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    let kind = |c: &Compiled| c.model.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
    let mut before: Option<&Compiled> = None;
    for c in models {
        let before = before.replace(c).filter(|b| kind(b) == kind(c));
        let grows = before.map_or(String::new(), |b| exponent([b.n, c.n], [b.time, c.time]));
        let (source, code) = (memory(c.source as f64), memory(c.code as f64));
        text += &format!("| `{}` | {} | {source} | {} | {grows} | {code} |\n", c.model, c.n, time(c.time));
    }
    text
}

/// What one more model adds to the compile time of gearsim [s].
fn median(models: &[Compiled]) -> f64 {
    let mut times: Vec<f64> = models.iter().map(|c| c.time).collect();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

fn packages(build: &Build) -> String {
    let Build { gearsim, dependencies, whole } = build;
    let sum = |part: &[(String, f64)]| part.iter().map(|(_, time)| time).sum::<f64>();
    let (named, others) = dependencies.split_at(NAMED.min(dependencies.len()));
    let (own, all) = (sum(gearsim), sum(dependencies));
    let mut rows = gearsim.clone();
    rows.push(("gearsim, all of these".into(), own));
    rows.push((format!("all {} dependencies", dependencies.len()), all));
    rows.extend(named.iter().map(|(name, time)| (format!("of these: `{name}`"), *time)));
    rows.push((format!("of these: the other {}", others.len()), sum(others)));
    rows.push(("cargo, and runs of build scripts".into(), (whole - own - all).max(0.0)));
    rows.push(("the whole build".into(), *whole));
    let mut text = String::from("| package | processor time | share |\n| --- | --- | --- |\n");
    for (what, seconds) in rows {
        text += &format!("| {what} | {} | {:.1} % |\n", time(seconds), 100.0 * seconds / whole);
    }
    text
}
