//! Runs a gear pair up and down in speed, and prints where the two directions differ. Each point starts from the settled state of the point
//! before.
//!
//! `cargo run --release --example response_curve`, from the root of the repository.

use gearsim::sweep::response::ResponseCurve;
use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    let response = curve("models/scenes/response.toml", "start.speed=2000 rpm:4000 rpm:21")?;
    let rms = |i: usize| response.points[i].observed[0].map_or(f64::NAN, |observed| observed.rms);
    let last = response.points.len() - 1;
    for i in 0..=last / 2 {
        let (up, down) = (rms(i), rms(last - i));
        let note = if (up / down - 1.0).abs() > 0.01 { "  two steady motions" } else { "" };
        println!("{:7.1} {}: {up:.3e} up, {down:.3e} down{note}", response.points[i].value, response.unit);
    }
    Ok(())
}

/// The response over `axis`, measured after the first 0.05 s of each point.
pub fn curve(path: &str, axis: &str) -> Result<ResponseCurve, Error> {
    Scene::load(path)?.vary(axis).from(0.05).response()
}
