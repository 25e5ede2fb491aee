//! Leaves out one effect of a scene after another; prints by what factors the rms of the mesh torque and the processor time change.
//!
//! `cargo run --release --example effects_and_time`, from the root of the repository.

use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    for (effect, torque, time) in without_each("models/scenes/oh2005/spectrum_4500rpm_exact.toml", "mesh_torque")? {
        println!("without {effect:<16} torque times {torque:.3}, time times {time:.2}");
    }
    Ok(())
}

/// For each effect: its name, the ratio of the rms of an output without the effect to that with it, and the same ratio of the processor
/// times. Effects without which the scene is not valid are left out.
pub fn without_each(path: &str, output: &str) -> Result<Vec<(&'static str, f64, f64)>, Error> {
    let scene = Scene::load(path)?;
    let measure = |scene: &Scene| {
        let results = scene.run()?;
        Ok::<_, Error>((results.observed(output)?.rms.0, results.outcome.cpu_seconds))
    };
    let all = scene.effects.names(scene.model);
    let (rms, time) = measure(&scene)?;
    let mut found = vec![];
    for effect in &all {
        let others: Vec<_> = all.iter().filter(|other| *other != effect).collect();
        let Ok(without) = scene.with("effects", format!("{others:?}")) else { continue };
        let (its_rms, its_time) = measure(&without)?;
        found.push((*effect, its_rms / rms, its_time / time));
    }
    Ok(found)
}
