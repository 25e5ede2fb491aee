//! Builds a scene without a file: two discs on a shaft, one of which is struck.
//!
//! `cargo run --release --example build_a_scene`.

use gearsim::{Error, Results, Scene};

fn main() -> Result<(), Error> {
    let twist = struck(0.5, 0.25, 1e4, 2.0)?.column("shaft_twist_1")?;
    println!("largest twist: {:.6} rad", twist.iter().fold(0.0, |largest: f64, x| largest.max(x.abs())));
    Ok(())
}

/// The motion after disc 1 was struck. Inertias [kg m^2], stiffness of the shaft [N m/rad], speed of disc 1 after the blow [rad/s].
pub fn struck(inertia1: f64, inertia2: f64, stiffness: f64, speed: f64) -> Result<Results, Error> {
    Scene::of_model("chain_2")
        .name("struck")
        .set("parameters.I1", inertia1)
        .set("parameters.I2", inertia2)
        .set("parameters.k1", stiffness)
        .set("start.theta1_dot", speed)
        .set("start.theta2", 0)
        .set("run.t_end", "0.1 s")
        .build()?
        .run()
}
