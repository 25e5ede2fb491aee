//! The scenes of the models: each runs to its end, and its energy account closes.

use crate::common::{root, run, scene};

/// The names of the scenes directly in `models/scenes`.
pub fn names() -> Vec<String> {
    let folder = root().join("models/scenes");
    let files = std::fs::read_dir(&folder).expect("the folder of scenes is there");
    let mut names: Vec<String> = files
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| path.file_stem().expect("a file").to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// T + V - W + D at every row equals its value at the start.
pub fn keeps_its_energy(name: &str) {
    let scene = scene(name, &[]);
    assert!(gearsim::models().iter().any(|m| m.model.name == scene.model.name));
    let t = run(&scene).trajectory;
    let peak = |column: &[f64]| column.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    // The rounding error of the account is relative to its largest part.
    let scale = [&t.kinetic, &t.strain, &t.work, &t.dissipated].map(|c| peak(c)).into_iter().fold(0.0, f64::max);
    let worst = peak(&t.residual) / scale;
    println!("{name}: {} rows, energy unaccounted for {worst:.1e} of the largest part", t.len());
    assert!(worst < 1e-11, "{name}: {worst:e} of the energy is not accounted for");
}
