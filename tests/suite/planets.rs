//! Play and friction at the meshes of planets, in torsion and in the plane: energy accounts, two methods, forces as vectors.

mod common;
#[path = "planets/flanks.rs"]
mod flanks;
#[path = "planets/loose.rs"]
mod loose;
#[path = "planets/mirrored.rs"]
mod mirrored;

use gearsim::run::Outcome;

/// The names of the meshes of a stage: s1, r1, s2, ...
fn meshes(planets: usize) -> Vec<String> {
    (1..=planets).flat_map(|i| [format!("s{i}"), format!("r{i}")]).collect()
}

/// Runs `planetary_3`, or the planar stage with the given number of planets. The overrides are `all`, and `each` for every mesh, where `{}`
/// stands for the name of the mesh.
fn run(model: &str, planets: usize, all: &[&str], each: &[&str]) -> Outcome {
    let mut set: Vec<String> = all.iter().map(|text| text.to_string()).collect();
    for mesh in meshes(planets) {
        set.extend(each.iter().map(|text| text.replace("{}", &mesh)));
    }
    set.push(format!("model=\"{model}\""));
    let scene = if model == "planetary_3" { model } else { "planar_planetary_3" };
    common::run(&common::scene(scene, &set))
}

/// The largest residual of the energy account, relative to the largest part of the account.
fn unaccounted(outcome: &Outcome) -> f64 {
    let t = &outcome.trajectory;
    let peak = |column: &[f64]| column.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let scale = [&t.kinetic, &t.strain, &t.work, &t.dissipated].map(|c| peak(c)).into_iter().fold(0.0, f64::max);
    peak(&t.residual) / scale
}
