//! Prints the speeds at which the steady rotation of a gear pair without damping is unstable.
//!
//! `cargo run --release --example stability`, from the root of the repository.

use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    let speeds: Vec<f64> = (20..=120).map(|hundreds| 100.0 * f64::from(hundreds)).collect();
    println!("unstable at {:?} rpm", unstable("models/scenes/oh2005/energy_300rpm.toml", &speeds)?);
    Ok(())
}

/// The speeds among `speeds` [rpm] at which a small disturbance grows if there is no damping.
pub fn unstable(path: &str, speeds: &[f64]) -> Result<Vec<f64>, Error> {
    let scene = Scene::load(path)?.with("parameters.zeta", 0)?;
    let mut found = vec![];
    for &speed in speeds {
        if scene.with("start.speed", format!("{speed} rpm"))?.floquet()?.verdict.is_unstable() {
            found.push(speed);
        }
    }
    Ok(found)
}
