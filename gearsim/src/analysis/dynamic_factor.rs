//! Dynamic factors of meshes: the largest force of a run over the force without vibration. For comparison: K_v of ISO 6336-1, method B.
//!
//! - Largest force: the largest magnitude of the recorded mesh force over samples and both sides of events. Only rows from a given time on
//!   count: `output.from`, or the time that a sweep gives.
//! - Static force: the mesh force without vibration at the torques of the start. If they are not in balance, the gears speed up steadily.
//! - K_v: ISO 6336-1, method B, for a scene that gives the teeth of the mesh. N is the mean mesh frequency from that time on over
//!   the natural frequency sqrt(tr M⁻¹K_m)/2 pi of the gears with their centres held. K_m is the part of K from the mesh at its mean
//!   stiffness. For two gears this frequency is sqrt(c_gamma b/m_red)/2 pi of the standard. F_t = F cos(alpha), K_A = 1. The base pitch
//!   deviation is the largest difference of neighbouring pitch errors of the scene. Profile deviation and tip relief are zero, and there is
//!   no allowance for running-in.

use nalgebra::DMatrix;

use super::orders::{SHAFT, force};
use super::pulling::{self, Pulling};
use crate::engine::equations::Known;
use crate::engine::system::System;
use crate::gear::{Gears, InternalDynamics, Iso6336};
use crate::model::{Law, Output, Role};
use crate::run::Entry;
use crate::scene::Scene;
use crate::tolerance::analysis::STATIC_LOAD;
use crate::trajectory::Trajectory;

/// The dynamic factors of a mesh. If a value does not exist, the error says why.
#[derive(Debug, Clone)]
pub struct DynamicFactor {
    /// The stiffness law of the mesh.
    pub law: &'static Law,
    /// The output that is its force, or its torque in models that have no base radii.
    pub force: &'static Output,
    /// Largest magnitude in the run \[N or N m\].
    pub largest: f64,
    /// Magnitude in static equilibrium \[N or N m\].
    pub at_rest: Result<f64, String>,
    /// How it pulls; `None` if no time passes.
    pub pulling: Option<Pulling>,
    /// Largest over static \[1\].
    pub factor: Result<f64, String>,
    /// K_v of ISO 6336-1, method B \[1\].
    pub iso6336: Result<f64, String>,
}

/// The dynamic factors of all meshes of a run whose forces are recorded, from the time `from` \[s\] on.
pub fn of(scene: &Scene, entry: &Entry, run: &Trajectory, from: f64) -> Vec<DynamicFactor> {
    let at_rest = entry.outputs_at_rest(scene).map_err(|refusal| format!("there is no static equilibrium: {refusal}"));
    let mut all = vec![];
    for (i, (law, _)) in scene.present().enumerate().filter(|(_, (law, _))| law.role == Role::Stiffness) {
        let Some(force) = force(scene.model, law.name) else { continue };
        let Some(column) = run.output(force.name) else { continue };
        let largest = column[run.row_from(from)..].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let number = scene.model.outputs.iter().position(|output| output.name == force.name);
        let at_rest = at_rest.clone().map(|values| number.map_or(f64::NAN, |i| values[i].abs()));
        let at_rest = at_rest.and_then(|force| match force > STATIC_LOAD * largest {
            true => Ok(force),
            false => Err("the mesh carries no load at the torques of the start".to_owned()),
        });
        let factor = at_rest.clone().map(|at_rest| largest / at_rest);
        let iso6336 = at_rest.clone().and_then(|at_rest| iso6336(scene, entry, (run, from), i, at_rest));
        let pulling = pulling::of_mesh(scene, run, law, from);
        all.push(DynamicFactor { law, force, largest, at_rest, pulling, factor, iso6336 });
    }
    all
}

fn iso6336(
    scene: &Scene,
    entry: &Entry,
    (run, from): (&Trajectory, f64),
    i: usize,
    at_rest: f64,
) -> Result<f64, String> {
    let law = &scene.model.laws[i];
    let gears = scene.gears[i].as_ref().ok_or("the scene gives the stiffness of this mesh without teeth")?;
    let contact = gears.contact().map_err(|e| e.to_string())?;
    // A value in N m is the torque about the axis of the driving gear.
    let force = if law.unit == "N/m" { at_rest } else { at_rest / contact.base[0] };
    let line_load = force * contact.transverse_angle.cos() / gears.face_width;
    let single = Iso6336::of(gears, Some(line_load)).map_err(|e| e.to_string())?.single;
    let ratio = mesh_frequency(run, law, from)? / natural_frequency(scene, entry, i)?;
    let pitch_deviation = pitch_deviation(scene, law, gears);
    let kv = InternalDynamics {
        ratio,
        line_load,
        single,
        // The coefficients are those of the total contact ratio.
        contact_ratio: contact.ratio() + contact.overlap,
        pitch_deviation,
        form_deviation: 0.0,
        tip_relief: 0.0,
    };
    Ok(kv.factor())
}

/// The mean mesh frequency of a run from the time `from` \[s\] on \[Hz\].
fn mesh_frequency(run: &Trajectory, law: &Law, from: f64) -> Result<f64, String> {
    let standing = || "this mesh does not turn".to_owned();
    let phase = run.model.coordinates.iter().position(|c| c.name == law.phase).ok_or_else(standing)?;
    let (q, first, last) = (&run.q[phase], run.row_from(from), run.len() - 1);
    let frequency = ((q[last] - q[first]) / law.period / (run.t[last] - run.t[first])).abs();
    if frequency > 0.0 { Ok(frequency) } else { Err(standing()) }
}

/// The natural frequency of the gears alone on the mean stiffness of their mesh, with their centres held \[Hz\].
fn natural_frequency(scene: &Scene, entry: &Entry, i: usize) -> Result<f64, String> {
    let system = entry.system(scene).map_err(|refusal| refusal.to_string())?;
    let turning = turning(scene, &system);
    let held = |a: &DMatrix<f64>| a.select_rows(&turning).select_columns(&turning);
    let matrices = |k: &[f64]| system.matrices(k);
    let mut k: Vec<f64> = scene.stiffnesses().map(|(_, profile)| profile.mean()).collect();
    let with = matrices(&k).map_err(|refusal| refusal.to_string())?;
    k[i] = 0.0;
    let without = matrices(&k).map_err(|refusal| refusal.to_string())?;
    let inverse = held(&with.mass).cholesky().ok_or("the mass matrix has no inverse")?.inverse();
    Ok((inverse * held(&(with.stiffness - without.stiffness))).trace().sqrt() / std::f64::consts::TAU)
}

/// The coordinates that turn a rotor: those on which an output depends that is a rotational speed. If there are none, all coordinates. The
/// other coordinates move the centres of gears.
fn turning(scene: &Scene, system: &System) -> Vec<usize> {
    let (equations, model) = (system.equations(), scene.model);
    let n = model.coordinates.len();
    let (q, k) = (vec![0.0; n], model.in_contact(scene.mids()));
    let speeds = (0..model.outputs.len()).filter(|i| model.outputs[*i].unit == SHAFT);
    let speeds: Vec<usize> = speeds.filter(|i| scene.effects.activate(model.outputs[*i].with, model)).collect();
    let turns = |&coordinate: &usize| {
        let q_dot: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == coordinate))).collect();
        speeds.iter().any(|i| equations.output(*i, &q, &q_dot, &k, &Known::default()) != 0.0)
    };
    let turning: Vec<usize> = (0..n).filter(turns).collect();
    if turning.is_empty() { (0..n).collect() } else { turning }
}

/// The largest difference of neighbouring pitch errors along the line of action [m]; 0 if the scene gives none.
fn pitch_deviation(scene: &Scene, law: &Law, gears: &Gears) -> f64 {
    let name = law.name.replacen('k', "e", 1);
    let error = scene.present().find(|(e, _)| e.role == Role::Error && e.name == name);
    let Some((error, profile)) = error.filter(|(_, profile)| profile.steps.len() == profile.pitches as usize) else {
        return 0.0;
    };
    // In gear_pair the deflection phi is half the difference of pitch angles: delta = 2 h phi, with the base radius h per tooth.
    let length = if error.unit == "m" { 1.0 } else { 2.0 * gears.base_radius_per_tooth() };
    let next = profile.steps.iter().cycle().skip(1);
    let largest = profile.steps.iter().zip(next).map(|(a, b)| (b.value - a.value).abs()).fold(0.0, f64::max);
    length * largest
}
