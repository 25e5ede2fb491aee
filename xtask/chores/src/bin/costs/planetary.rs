//! Planetary stages as trains, with evenly spaced mesh phases: two laws per planet, all on one phase.

use std::f64::consts::TAU;

use anyhow::Context;
use gearsim::__private::Inside;
use gearsim::scene::{Profile, Scene, Step};

use crate::row::Row;

/// The stage of models/scenes/planetary_3.toml as a train. The number of planets is appended, and the stiffness laws are replaced.
const STAGE: &str = r#"
model = "train"
effects = ["stiffness_step", "torques"]
[rotors]
s = "5.84e-4 kg*m^2"
c = "6.28e-2 kg*m^2"
r = "6.04e-2 kg*m^2"
[supports.r]
rotor = "r"
stiffness = "20.1 MN*m/rad"
[drives.motor]
rotor = "s"
torque = "300 N*m"
[loads.load]
rotor = "c"
torque = "1400 N*m"
[start]
speed = "1500 rpm"
[run]
t_end = "0.2 s"
[planets.p]
sun = "s"
carrier = "c"
ring = "r"
teeth = [27, 99]
base_radius = "38.7 mm"
pressure_angle = "24.6 deg"
mass = "0.66 kg"
inertia = "1.62e-3 kg*m^2"
sun_stiffness = { steps = [{ value = "1 N/m" }], phase = 0 }
ring_stiffness = { steps = [{ value = "1 N/m" }], phase = 0 }
"#;

/// Measures the stage with `planets` planets. The mesh phases of planet i lag by (i - 1)/planets of a pitch.
///
/// # Errors
/// If it does not run.
pub fn planetary(planets: usize) -> anyhow::Result<Row> {
    let mut scene = Scene::from_toml("planetary", &format!("{STAGE}count = {planets}\n"))?;
    for (law, stiffness) in scene.model.laws.iter().zip(&mut scene.laws) {
        let Some((with, planet)) = law.name.strip_prefix("k_p_").and_then(|mesh| mesh.split_at_checked(1)) else {
            continue;
        };
        let offset = TAU * (planet.parse::<f64>()? - 1.0) / planets as f64;
        *stiffness = match with {
            "s" => shifted(offset, 2.6, [3.5e8, 6e8]),
            _ => shifted(offset + 1.0, 4.4, [6e8, 4e8]),
        };
    }
    let train = gearsim::models().iter().find(|entry| entry.model.name == "train").context("no trains")?;
    Row::of(&scene, &*train.equations(&scene)?)
}

/// A law of two levels [N/m]: the first from `offset` [rad] over `width` [rad], the second over the rest of the pitch of 2 pi.
fn shifted(offset: f64, width: f64, [first, second]: [f64; 2]) -> Profile {
    let offset = offset.rem_euclid(TAU);
    let step = |value, width| Step { value, width };
    let steps = match offset + width - TAU {
        over if over > 0.0 => vec![step(first, over), step(second, TAU - width), step(first, width - over)],
        _ if offset == 0.0 => vec![step(first, width), step(second, TAU - width)],
        _ => vec![step(second, offset), step(first, width), step(second, TAU - offset - width)],
    };
    Profile::stepping(steps)
}
