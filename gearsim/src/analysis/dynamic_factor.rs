//! Dynamic factors of meshes: the largest force of a run over the force without vibration, and beside it K_v of ISO 6336-1, method B.
//!
//! - Largest force: the largest magnitude of the recorded mesh force, over samples and both sides of events, from `output.from` on.
//! - Static force: the mesh force in static equilibrium at the torques of the start.
//! - K_v: ISO 6336-1, method B, for a scene that gives the teeth of the mesh. N is the mesh frequency of the run over
//!   sqrt(tr M⁻¹K_m)/2 pi, with K_m the part of K from the mesh at its mean stiffness: for two gears on torsional shafts
//!   sqrt(c_gamma b/m_red)/2 pi of the standard. F_t = F cos(alpha), K_A = 1. The base pitch deviation is the largest difference of
//!   neighbouring pitch errors of the scene; profile deviation and tip relief are zero, and there is no allowance for running-in.

use super::orders::force;
use crate::gear::{Gears, InternalDynamics, Iso6336};
use crate::model::{Law, Output, Role};
use crate::run::Entry;
use crate::scene::Scene;
use crate::trajectory::Trajectory;

/// The dynamic factors of a mesh. A value that does not exist has its reason.
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
    /// Largest over static \[1\].
    pub factor: Result<f64, String>,
    /// K_v of ISO 6336-1, method B \[1\].
    pub iso6336: Result<f64, String>,
}

/// The dynamic factors of all meshes of a run whose forces are recorded.
pub fn of(scene: &Scene, entry: &Entry, run: &Trajectory) -> Vec<DynamicFactor> {
    let at_rest = entry.outputs_at_rest(scene).map_err(|refusal| format!("there is no static equilibrium: {refusal}"));
    let mut all = vec![];
    for (i, (law, _)) in scene.present().enumerate().filter(|(_, (law, _))| law.role == Role::Stiffness) {
        let Some(force) = force(scene.model, law.name) else { continue };
        let Some(column) = run.output(force.name) else { continue };
        let largest = column[run.row_from(scene.output.from)..].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let number = scene.model.outputs.iter().position(|output| output.name == force.name);
        let at_rest = at_rest.clone().map(|values| number.map_or(f64::NAN, |i| values[i].abs()));
        let at_rest = at_rest.and_then(|force| match force > 0.0 {
            true => Ok(force),
            false => Err("the mesh carries no load at the torques of the start".to_owned()),
        });
        let factor = at_rest.clone().map(|at_rest| largest / at_rest);
        let iso6336 = at_rest.clone().and_then(|at_rest| iso6336(scene, entry, run, i, at_rest));
        all.push(DynamicFactor { law, force, largest, at_rest, factor, iso6336 });
    }
    all
}

fn iso6336(scene: &Scene, entry: &Entry, run: &Trajectory, i: usize, at_rest: f64) -> Result<f64, String> {
    let law = &scene.model.laws[i];
    let gears =
        scene.gears[i].as_ref().ok_or_else(|| format!("the scene gives the stiffness {} without teeth", law.name))?;
    let contact = gears.contact().map_err(|e| e.to_string())?;
    // A value in N m is the torque about the axis of the driving gear.
    let force = if law.unit == "N/m" { at_rest } else { at_rest / contact.base[0] };
    let line_load = force * contact.transverse_angle.cos() / gears.face_width;
    let single = Iso6336::of(gears, Some(line_load)).map_err(|e| e.to_string())?.single;
    let ratio = mesh_frequency(run, law)? / natural_frequency(scene, entry, i)?;
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

/// The mean mesh frequency of a run \[Hz\].
fn mesh_frequency(run: &Trajectory, law: &Law) -> Result<f64, String> {
    let standing = || format!("the mesh {} does not turn", law.name);
    let phase = run.model.coordinates.iter().position(|c| c.name == law.phase).ok_or_else(standing)?;
    let (q, last) = (&run.q[phase], run.len() - 1);
    let frequency = ((q[last] - q[0]) / law.period / (run.t[last] - run.t[0])).abs();
    if frequency > 0.0 { Ok(frequency) } else { Err(standing()) }
}

/// The natural frequency of the gears alone on the mean stiffness of their mesh \[Hz\].
fn natural_frequency(scene: &Scene, entry: &Entry, i: usize) -> Result<f64, String> {
    let matrices = |k: &[f64]| entry.system(scene)?.matrices(k);
    let mut k: Vec<f64> = scene.stiffnesses().map(|(_, profile)| profile.mean()).collect();
    let with = matrices(&k).map_err(|refusal| refusal.to_string())?;
    k[i] = 0.0;
    let without = matrices(&k).map_err(|refusal| refusal.to_string())?;
    let inverse = with.mass.clone().cholesky().ok_or("the mass matrix has no inverse")?.inverse();
    Ok((inverse * (with.stiffness - without.stiffness)).trace().sqrt() / std::f64::consts::TAU)
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
