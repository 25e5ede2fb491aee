//! Snapshots of the summary of each paper scene, without the entries that depend on the machine.
//!
//! Numbers are rounded to nine significant digits: the engine agrees with two references to 1e-11, and exp and sincos of other
//! processors differ in the last place. A coordinate or speed is rounded to the decimal places of its largest value in the run. A
//! residual that is zero except for rounding is shown as a bound. The scenes are damped or short, so rounding errors do not grow.

mod common;

use std::fmt::Write;

use common::{root, run, scene};
use gearsim::output::summary::{Energy, Named};
use gearsim::run::Outcome;
use gearsim::scene::Scene;

const SIGNIFICANT: usize = 9;

/// A number as in the snapshot.
fn rounded(x: f64) -> String {
    format!("{x:.*e}", SIGNIFICANT - 1)
}

/// A number that may be near zero, rounded to the decimal places that `scale` has.
fn rounded_to(scale: f64, x: f64) -> String {
    let places = SIGNIFICANT as i32 - 1 - scale.abs().log10().floor() as i32;
    format!("{x:.*}", places.max(0) as usize)
}

fn text(scene: &Scene, outcome: &Outcome) -> String {
    let mut out = String::new();
    let mut line = |name: &str, value: String| writeln!(out, "{name}: {value}").expect("a string takes all");
    line("model", scene.model.name.into());
    line("effects", scene.effects.names(scene.model).join(", "));
    line("t_end [s]", rounded(*outcome.trajectory.t.last().expect("rows were recorded")));
    let t = &outcome.trajectory;
    let columns = t.q.iter().zip(&t.q_dot).flat_map(|(q, q_dot)| [q, q_dot]);
    for ((name, x), column) in Named::state(t).0.iter().zip(columns) {
        line(name, rounded_to(column.iter().fold(0.0, |m, x| x.abs().max(m)), x.0));
    }
    line("cell changes", outcome.counts.cell_changes.to_string());
    line("reflections", outcome.counts.reflections.to_string());
    let energy = Energy::at_end(&outcome.trajectory).expect("rows were recorded");
    for (name, x) in [
        ("kinetic [J]", energy.kinetic),
        ("strain [J]", energy.strain),
        ("work [J]", energy.work),
        ("dissipated [J]", energy.dissipated),
        ("at the start [J]", energy.at_start),
    ] {
        line(name, rounded(x.0));
    }
    let accounted = energy.residual.0.abs() < 1e-12 * energy.at_start.0.abs();
    line(
        "residual [J]",
        if accounted { "below 1e-12 of the start".into() } else { rounded_to(energy.at_start.0, energy.residual.0) },
    );
    let frequency = outcome.reference_frequency.map_or("none".into(), rounded);
    line("damped frequency at the mid stiffness [rad/s]", frequency);
    line("rows", outcome.trajectory.len().to_string());
    out
}

#[test]
fn summaries_of_the_paper_scenes_match_the_snapshot() {
    let folder = root().join("models/scenes/oh2005");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .expect("the paper's scenes are there")
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| path.file_stem().expect("a file").to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(!names.is_empty());
    let all: String = names
        .iter()
        .map(|name| {
            let scene = scene(&format!("oh2005/{name}"), &[]);
            format!("# {name}\n{}\n", text(&scene, &run(&scene)))
        })
        .collect();
    insta::assert_snapshot!("paper_scenes", all);
}
