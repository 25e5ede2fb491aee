//! Crates of Rust that locate events, on the scenes of `cargo xtask peers`.
//!
//! `gearsim-peers SCENES NAME METHOD TOLERANCE` prints events, end and processor times as JSON; `gearsim-peers versions`
//! which crates these are. One crate, one file.

mod clock;
mod diffsol_events;
mod ivp_events;
mod scene;

use anyhow::{Context, bail};

use scene::Scene;

fn main() -> anyhow::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, name, method, tolerance] = &arguments[..] else {
        if arguments != ["versions"] {
            bail!("wanted: SCENES NAME METHOD TOLERANCE, or: versions");
        }
        println!("{}", serde_json::json!(versions()));
        return Ok(());
    };
    let scene = Scene::read(file, name)?;
    let tolerance: f64 = tolerance.parse().context("a tolerance is a number")?;
    let result = match method.as_str() {
        "diffsol tsit45" => clock::measure(|| diffsol_events::tsit45(&scene, tolerance)),
        "diffsol bdf" => clock::measure(|| diffsol_events::bdf(&scene, tolerance)),
        "ivp DOP853" => clock::measure(|| ivp_events::run(&scene, ivp::prelude::Method::DOP853, tolerance)),
        "ivp DOPRI5" => clock::measure(|| ivp_events::run(&scene, ivp::prelude::Method::DOPRI5, tolerance)),
        _ => bail!("no method `{method}`"),
    };
    println!("{}", result?);
    Ok(())
}

/// The crates with their versions, out of the lock file.
fn versions() -> String {
    let lock = include_str!("../Cargo.lock");
    let version = |name: &str| {
        let entry = lock.split(&format!("name = \"{name}\"\nversion = \"")).nth(1).unwrap_or("?\"");
        format!("{name} {}", entry.split('"').next().unwrap_or("?"))
    };
    format!("{}, {}", version("diffsol"), version("ivp"))
}
