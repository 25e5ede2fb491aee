//! The rotors of the meshes of planet sets, relative to their carriers.
//!
//! A tooth of the sun meets the first planet f_s - f_c times a second, and any of the n planets n times as often. A cracked or spalled
//! tooth therefore shows at the mesh order plus and minus multiples of n (f_s - f_c). An eccentric sun shows at plus and minus multiples of
//! f_s - f_c, as does every fault in the force of one mesh. The same holds for the ring with f_r - f_c. A tooth of a planet, with f_p -
//! f_c, meets the sun with one flank and the ring with the other, so that damage through the tooth shows twice a turn. Source: Z. Feng, M.
//! J. Zuo, J. Sound Vib. 331 (2012) 4919-4939; before it P. D. McFadden, Mech. Syst. Signal Process. 5 (1991) 273-291 (averages over the
//! teeth of suns and planets).

use super::meshes::{mean, teeth};
use super::{Rotor, SHAFT};
use crate::model::{Model, Relative};
use crate::trajectory::Trajectory;

/// Names of the sun's, carrier's and ring's speed in models whose equations are derived as a whole.
const SUN: &str = "rotor_speed_s";
const CARRIER: &str = "rotor_speed_c";
const RING: &str = "rotor_speed_r";
/// The first sun mesh of these models.
const LAW: &str = "k_s1";
/// The planets of these models, whose speeds are no outputs.
const PLANETS: &str = "planets - rotor_speed_c";

/// The rotors of the planet sets whose meshes have this phase; empty if the phase is not that of a planet set. `mesh` is the mesh frequency
/// \[Hz\].
pub(super) fn rotors(run: &Trajectory, rows: &[usize], phase: &str, mesh: f64) -> Vec<Rotor> {
    let of_phase = |name: &str| run.model.laws.iter().any(|law| law.name == name && law.phase == phase);
    let speed = |name: Option<&str>| match name {
        None => Some(0.0),
        Some(name) => run.outputs.iter().find(|(o, _)| o.name == name && o.unit == SHAFT).map(|(_, x)| mean(x, rows)),
    };
    let mut all: Vec<Rotor> = vec![];
    for of in relative(run.model).iter().filter(|of| of_phase(of.law)) {
        let (Some(gear), Some(carrier)) = (speed(of.gear), speed(of.carrier)) else { continue };
        let frequency = (gear - carrier).abs() / std::f64::consts::TAU;
        let teeth = teeth(mesh, frequency);
        all.extend(teeth.map(|teeth| Rotor { name: of.name, frequency, teeth, meets: of.meets }));
    }
    // The planets of a derived stage fill the space between sun and ring.
    if let ([sun, ring], true) = (&all[..], run.model.relative.is_empty()) {
        let teeth = (ring.teeth - sun.teeth) / 2.0;
        all.push(Rotor { name: PLANETS, frequency: mesh / teeth, teeth, meets: 2 });
    }
    all
}

/// The relative rotations of a model. For a model that is derived as a whole, they follow from the names of its outputs and laws.
fn relative(model: &Model) -> Vec<Relative> {
    let has = |name: &str| model.outputs.iter().any(|output| output.name == name);
    if !model.relative.is_empty() || !has(SUN) || !has(CARRIER) {
        return model.relative.to_vec();
    }
    let meets = (1..).take_while(|i| model.laws.iter().any(|law| law.name == format!("k_s{i}"))).count() as u32;
    let of = |name, gear| Relative { name, law: LAW, gear, carrier: Some(CARRIER), meets };
    let ring = if has(RING) { of("rotor_speed_r - rotor_speed_c", Some(RING)) } else { of(CARRIER, None) };
    vec![of("rotor_speed_s - rotor_speed_c", Some(SUN)), ring]
}
