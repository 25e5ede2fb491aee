//! The tables as text.

use crate::compile::Compiled;
use crate::row::{Group, ROWS, Row};
use crate::threads::Gain;

/// All of it.
pub fn write(rows: &[Row], compiled: &[Compiled], gains: &[Gain]) -> String {
    format!(
        "# What grows, and how\n\n\
         `cargo xtask costs`, in one run. Times are the least of several on one core, of processor time but for the sweeps'.\n\n\
         ## A cell change against the number n of coordinates\n\n\
         Exponents are those of the row against the one before: time grows as n^exponent. The laws of the motion are matrices \
         of n x n between coordinates and modes: n^2 is what is to be expected of large n.\n\n{}{}{}\n\
         ## Derived equations against n\n\n\
         Each file of gearsim/src/generated compiled by itself, optimised: its equations for all sets of effects, and these \
         with the engine for its number of coordinates.\n\n{}\n\
         ## Sweeps on one thread and on two\n\n{}",
        cells("Without damping", Group::Undamped, rows),
        cells("With dampers that couple the modes", Group::Coupled, rows),
        cells("Planetary stages without damping, planets one after another", Group::Planetary, rows),
        equations(compiled),
        threads(gains)
    )
}

fn exponent(n: [usize; 2], x: [f64; 2]) -> String {
    format!("{:.2}", (x[1] / x[0]).ln() / (n[1] as f64 / n[0] as f64).ln())
}

fn cells(title: &str, group: Group, rows: &[Row]) -> String {
    let mut text = format!(
        "{title}:\n\n| system | n | time a cell change | exponent | evaluations | until it begins | memory |\n\
         | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    let mut before: Option<&Row> = None;
    for (system, row) in ROWS.iter().zip(rows).filter(|(system, _)| system.group == group) {
        let grows = before.map_or(String::new(), |b| exponent([b.n, row.n], [b.change, row.change]));
        text += &format!(
            "| {} | {} | {} | {grows} | {:.2} | {} | {} |\n",
            system.name,
            row.n,
            time(row.change),
            row.evaluations,
            time(row.prepare),
            memory(1024.0 * row.memory),
        );
        before = Some(row);
    }
    text + "\n"
}

fn equations(compiled: &[Compiled]) -> String {
    let mut text = String::from(
        "| model | n | its file | equations: compile time | exponent | code | with the engine: compile time | code |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let family = |c: &Compiled| c.model.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut before: Option<&Compiled> = None;
    for c in compiled {
        let before = before.replace(c).filter(|b| family(b) == family(c));
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

fn threads(gains: &[Gain]) -> String {
    let mut text = String::from("| sweep | points | one thread | two | gain |\n| --- | --- | --- | --- | --- |\n");
    for Gain { what, points, elapsed: [one, two] } in gains {
        text += &format!("| {what} | {points} | {} | {} | {:.2} |\n", time(*one), time(*two), one / two);
    }
    text
}

fn time(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "us")];
    let unit = units.into_iter().find(|(scale, _)| seconds >= *scale);
    let (scale, unit) = unit.unwrap_or((1e-9, "ns"));
    format!("{} {unit}", digits(seconds / scale))
}

fn memory(bytes: f64) -> String {
    if bytes < 1e6 { format!("{} kB", digits(bytes / 1e3)) } else { format!("{} MB", digits(bytes / 1e6)) }
}

/// Three digits.
fn digits(x: f64) -> String {
    if x >= 100.0 {
        format!("{x:.0}")
    } else if x >= 10.0 {
        format!("{x:.1}")
    } else {
        format!("{x:.2}")
    }
}
