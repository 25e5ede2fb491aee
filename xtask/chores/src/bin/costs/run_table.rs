//! The part of tests/costs.md on run time and memory.

use crate::format::{exponent, memory, time};
use crate::row::{Group, ROWS, Row};
use crate::threads::Gain;

/// The whole part, with the title of the file.
pub fn write(rows: &[Row], gains: &[Gain]) -> String {
    format!(
        "# How costs grow\n\n\
         `cargo xtask costs` measures run time and memory, `cargo xtask costs --compile` compile times. Run times are processor times \
         on one core, the least of several; those of sweeps are elapsed times.\n\n\
         ## A cell change against the number n of coordinates\n\n\
         The exponent compares a row with the row above: time grows as n^exponent. The engine multiplies by matrices of n x n between \
         coordinates and modes, so the exponent tends to 2 for large n.\n\n{}{}{}\
         ## Sweeps on one thread and on two\n\n{}\n",
        cells("Without damping", Group::Undamped, rows),
        cells("With dampers that couple the modes", Group::Coupled, rows),
        cells(
            "Planetary stages without damping, as trains, the mesh phases of the planets evenly spaced",
            Group::Planetary,
            rows
        ),
        threads(gains)
    )
}

fn cells(title: &str, group: Group, rows: &[Row]) -> String {
    let mut text = format!(
        "{title}:\n\n| system | n | time per cell change | exponent | evaluations per cell change | time to prepare | memory |\n\
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

fn threads(gains: &[Gain]) -> String {
    let mut text = String::from("| sweep | points | one thread | two | gain |\n| --- | --- | --- | --- | --- |\n");
    for Gain { what, points, elapsed: [one, two] } in gains {
        text += &format!("| {what} | {points} | {} | {} | {:.2} |\n", time(*one), time(*two), one / two);
    }
    text
}
