//! The modes of a scene as text.

use std::fmt::Write;
use std::hash::Hash;

use indexmap::IndexMap;

use crate::analysis::modes::{AT_A_PLACE, CellModes, HARMONICS, MOST_CELLS, OverATurn, Parts, Vibration, meetings};
use crate::analysis::steady::SteadyLaw;
use crate::cli::number::short;
use crate::cli::terminal;
use crate::scene::Scene;
use crate::tolerance::analysis::NEAR_RESONANCE;

/// Shares of energy below this are not printed.
const LEAST: f64 = 0.005;
/// Maximum number of components of a mode shape that are printed, the largest ones.
const PARTS: usize = 6;

/// The whole text; `moves`: the coefficients change along the motion.
pub(super) fn render(
    (scene, moves): (&Scene, bool),
    courses: &[SteadyLaw],
    parts: &Parts,
    chosen: &CellModes,
    cells: &[CellModes],
    width: usize,
) -> String {
    let mut text = format!("modes at {}\n\n", levels(scene, &chosen.levels));
    if moves {
        text += &terminal::wrap(AT_A_PLACE, width);
        text += "\n\n";
    }
    if chosen.coupled {
        text += "Damping couples the modes: shapes are complex; each component has an amplitude and a phase.\n\n";
    }
    for (i, mode) in chosen.modes.iter().enumerate() {
        text += &one((scene, moves), parts, i, mode, width);
    }
    text += "\n";
    text += &all(scene, cells);
    text + &harmonics(courses, chosen)
}

fn levels(scene: &Scene, values: &[f64]) -> String {
    let level = |(law, value): (&crate::model::Law, &f64)| format!("{} = {} {}", law.name, short(*value), law.unit);
    let all: Vec<_> = scene.model.laws.iter().zip(values).map(level).collect();
    if all.is_empty() { "constant stiffness".into() } else { all.join(", ") }
}

fn one((scene, moves): (&Scene, bool), of: &Parts, i: usize, mode: &Vibration, width: usize) -> String {
    let head = match mode.zeta {
        _ if mode.growth > 0.0 && moves => {
            format!("at this position a disturbance grows at {} 1/s", short(mode.growth))
        }
        _ if mode.growth > 0.0 => format!("unstable: a disturbance grows at {} 1/s", short(mode.growth)),
        None => "rigid motion".to_owned(),
        Some(zeta) if mode.damped > 0.0 => {
            format!("{} Hz, damped {} Hz, zeta {}", short(mode.natural), short(mode.damped), short(zeta))
        }
        Some(zeta) => format!("{} Hz, does not oscillate, zeta {}", short(mode.natural), short(zeta)),
    };
    let coordinates = scene.model.coordinates;
    let names: Vec<&str> = coordinates.iter().map(|c| c.name).collect();
    // If all coordinates have the same unit, no unit is printed: only ratios of amplitudes have a meaning.
    let mixed = coordinates.iter().any(|c| c.unit != coordinates[0].unit);
    let unit = |i: usize| if mixed { format!(" {}", coordinates[i].unit) } else { String::new() };
    let mut parts: Vec<usize> = (0..names.len()).collect();
    parts.sort_by(|&a, &b| mode.shape[b].norm().total_cmp(&mode.shape[a].norm()));
    let shape = parts.iter().take(PARTS).map(|&i| {
        let z = mode.shape[i];
        match z.im.abs() > 1e-6 * z.norm() {
            true => format!("{} {}{} ∠ {:.0}°", names[i], short(z.norm()), unit(i), z.arg().to_degrees()),
            false => format!("{} {}{}", names[i], short(z.re), unit(i)),
        }
    });
    let mut shape: String = shape.collect::<Vec<_>>().join(", ");
    if names.len() > PARTS {
        shape += ", ...";
    }
    let laws = scene.model.laws.iter().map(|l| l.name).zip(mode.strain.iter().copied());
    let springs = of.springs.iter().map(|s| s.name).zip(mode.springs.iter().copied());
    let strain = shares(laws.chain(springs));
    let kinetic = shares(of.masses.iter().map(|m| m.name).zip(mode.kinetic.iter().copied()));
    let mut text = format!("{i:>4}  {head}\n");
    for (name, says) in [("shape", shape), ("strain", strain), ("kinetic", kinetic)] {
        if says.is_empty() {
            continue;
        }
        for (n, line) in terminal::wrap(&says, width.saturating_sub(16).max(20)).lines().enumerate() {
            let _ = writeln!(text, "      {:<8}  {line}", if n == 0 { name } else { "" });
        }
    }
    text
}

/// The ranges of the natural frequencies over a turn of the motion.
pub(super) fn over_a_turn(turn: &OverATurn) -> String {
    let mut text = format!("\nnatural frequencies over a turn of the motion, {} s, in Hz\n\n", short(turn.time));
    for (i, [low, high]) in turn.natural.iter().enumerate().filter(|(_, range)| range[1] > 0.0) {
        let _ = writeln!(text, "{i:>4}  {} to {}", short(*low), short(*high));
    }
    text
}

/// Shares of energy in percent, the largest first.
fn shares<'a>(of: impl Iterator<Item = (&'a str, f64)>) -> String {
    let mut largest: Vec<(&str, f64)> = of.filter(|(_, share)| share.abs() >= LEAST).collect();
    largest.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    largest.truncate(PARTS);
    largest.iter().map(|(name, share)| format!("{name} {:.0} %", 100.0 * share)).collect::<Vec<_>>().join(", ")
}

/// Natural frequencies of every cell.
fn all(scene: &Scene, cells: &[CellModes]) -> String {
    if cells.is_empty() {
        return format!("There are more than {MOST_CELLS} cells, which are not listed: choose one with --cell.\n\n");
    }
    if cells.len() == 1 {
        return String::new();
    }
    let mut text = String::from("natural frequencies of every cell in Hz, without rigid motions\n\n");
    for cell in cells {
        let frequencies = cell.modes.iter().filter(|m| m.natural > 0.0).map(|m| format!("{:>9}", short(m.natural)));
        let frequencies: Vec<String> = frequencies.take(8).collect();
        let more = if cell.modes.iter().filter(|m| m.natural > 0.0).count() > 8 { " ..." } else { "" };
        let _ = writeln!(text, "  {:<40}{}{more}", levels(scene, &cell.levels), frequencies.concat());
    }
    text + "\n"
}

/// The mesh frequencies, and their harmonics near natural frequencies.
fn harmonics(courses: &[SteadyLaw], chosen: &CellModes) -> String {
    let moving: Vec<&SteadyLaw> = courses.iter().filter(|c| c.turns()).collect();
    if moving.is_empty() {
        return "There are no mesh frequencies: the scene has no speed, or no stiffness steps.\n".into();
    }
    let mut text = String::new();
    for (frequency, names) in alike(moving.iter().map(|c| (short(c.mesh_frequency()).to_string(), c.name))) {
        let _ = writeln!(text, "mesh frequency of {names}: {frequency} Hz");
    }
    let near = meetings(courses, chosen);
    if near.is_empty() {
        let _ = writeln!(
            text,
            "  none of its first {HARMONICS} harmonics is within {:.0} % of a mode",
            100.0 * NEAR_RESONANCE
        );
    }
    let near = near.iter().map(|m| {
        let distance = format!("{:+.1} % from mode {}", 100.0 * (m.ratio - 1.0), m.mode);
        ((m.harmonic, distance), courses[m.law].name)
    });
    for ((harmonic, distance), names) in alike(near) {
        let _ = writeln!(text, "  harmonic {harmonic} of {names} is {distance}");
    }
    text
}

/// Groups the names of meshes that have the same text, such as the meshes of several planets.
fn alike<'a, T: Hash + Eq>(all: impl Iterator<Item = (T, &'a str)>) -> impl Iterator<Item = (T, String)> {
    let mut names: IndexMap<T, Vec<&str>> = IndexMap::new();
    all.for_each(|(says, name)| names.entry(says).or_default().push(name));
    names.into_iter().map(|(says, names)| (says, names.join(", ")))
}
