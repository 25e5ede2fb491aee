//! Rust crates that locate events, on the scenes of `cargo xtask peers`.
//!
//! `gearsim-peers SCENES NAME METHOD TOLERANCE` prints events, end and processor times as JSON. `gearsim-peers versions` prints the
//! crates and their versions. Each crate has one file.

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
            bail!("usage: gearsim-peers SCENES NAME METHOD TOLERANCE, or: gearsim-peers versions");
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
        _ => bail!("no method `{method}`; the methods are: diffsol tsit45, diffsol bdf, ivp DOP853, ivp DOPRI5"),
    };
    println!("{}", result?);
    Ok(())
}

/// The crates with their versions, read from the lock file.
fn versions() -> String {
    let lock = include_str!("../Cargo.lock");
    let version = |name: &str| {
        let entry = lock.split(&format!("name = \"{name}\"\nversion = \"")).nth(1).unwrap_or("?\"");
        format!("{name} {}", entry.split('"').next().unwrap_or("?"))
    };
    format!("{}, {}", version("diffsol"), version("ivp"))
}
