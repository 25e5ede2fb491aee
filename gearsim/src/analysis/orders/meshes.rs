//! The frequencies of the meshes and rotors of a run, from its recorded samples.

use super::lines::SIDEBANDS;
use super::{SHAFT, planets};
use crate::model::{Model, Output, Switch};
use crate::trajectory::Trajectory;

/// A phase has one mesh frequency if its mean speed in each part of the run differs from that of the run by at most this fraction.
const STEADY: f64 = 0.02;
/// Parts of a run whose mean speeds are compared. Vibrations average out in them.
const PARTS: usize = 8;
/// The ratio of mesh and rotor frequency is a number of teeth if it differs from a whole number by at most this [teeth]. It is not exactly
/// whole, because shafts twist during a run.
const WHOLE: f64 = 0.02;
/// Numbers of teeth.
const TEETH: std::ops::RangeInclusive<f64> = 5.0..=1000.0;

/// A group of meshes with the same phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Name of its first stiffness law.
    pub name: &'static str,
    /// Mean number of pitches a second \[Hz\].
    pub frequency: f64,
    /// Largest mean number of pitches a second in an eighth of the run \[Hz\].
    pub fastest: f64,
    /// Whether the mean speed of its phase is constant within 2 %, so that its lines are at multiples of this frequency.
    pub steady: bool,
    /// The output that is its force, or its torque in models that have no base radii.
    pub force: Option<&'static str>,
    /// The rotors of its gears whose speeds are recorded. The mesh frequency is a whole multiple of the rotor frequency, the number of
    /// teeth. If rotors have equal speeds, only the first is listed. For a planet set: its gears, relative to the carrier.
    pub rotors: Vec<Rotor>,
    /// The recorded speeds of which the mesh frequency is a whole multiple.
    pub(super) geared: Vec<&'static str>,
}

/// A rotor of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// The output that is its speed. For a gear of a planet set a difference such as `rotor_speed_s - rotor_speed_c`.
    pub name: &'static str,
    /// Mean number of revolutions a second \[Hz\]. For a gear of a planet set relative to the carrier.
    pub frequency: f64,
    /// Its number of teeth in the mesh.
    pub teeth: f64,
    /// How often a tooth of the gear is in mesh in one such revolution.
    pub meets: u32,
}

impl Rotor {
    /// The sidebands of a mesh order at which faults show, in multiples of the frequency of the rotor: the first 3 n on either side for a
    /// gear that is in mesh n times a turn. If planets mesh out of phase, multiples of n times the frequency lie at any of these distances
    /// from a mesh order.
    pub fn sidebands(&self) -> impl Iterator<Item = i32> + Clone + use<> {
        let most = SIDEBANDS * self.meets as i32;
        (-most..=most).filter(|k| *k != 0)
    }
}

/// The name of a rotor as a factor of a product: a difference is put in parentheses.
pub fn term(name: &str) -> String {
    if name.contains(" - ") { format!("({name})") } else { name.to_owned() }
}

/// The output that is the force of the mesh with the stiffness law `law`, or its torque: `mesh_force_12` of `k12`, `mesh_force_s1` of
/// `k_s1`, `mesh_torque` of `k`.
pub fn force(model: &Model, law: &str) -> Option<&'static Output> {
    let part = law.strip_prefix('k').map(|part| part.trim_start_matches('_'))?;
    let named = |stem: &str| if part.is_empty() { stem.to_owned() } else { format!("{stem}_{part}") };
    let names = ["mesh_force", "mesh_torque"].map(named);
    model.outputs.iter().find(|output| names.iter().any(|name| name == output.name))
}

/// The play of the mesh with the stiffness law `law`: the switch `over12` of `k12`, `overs1` of `k_s1`; `None` if the model has none.
pub fn play(model: &Model, law: &str) -> Option<&'static Switch> {
    let part = law.strip_prefix('k')?.trim_start_matches('_');
    let of = |switch: &Switch| switch.name.strip_prefix("over").is_some_and(|of| of.trim_start_matches('_') == part);
    model.switches.iter().find(|switch| of(switch))
}

/// The meshes of a run whose phases move by at least one pitch, over its samples from the time `from` \[s\] on.
pub fn meshes(run: &Trajectory, from: f64) -> Vec<Mesh> {
    let rows: Vec<usize> = run.samples().filter(|&row| run.t[row] >= from).collect();
    let (Some(&first), Some(&last)) = (rows.first(), rows.last()) else { return vec![] };
    let duration = run.t[last] - run.t[first];
    let mut meshes: Vec<Mesh> = vec![];
    let mut phases = vec![];
    for law in run.model.laws.iter().filter(|law| law.with.is_none()) {
        let Some(i) = run.model.coordinates.iter().position(|c| c.name == law.phase) else { continue };
        let mean = (run.q[i][last] - run.q[i][first]) / duration;
        let frequency = mean.abs() / law.period;
        if phases.contains(&i) || frequency * duration < 1.0 || !frequency.is_finite() {
            continue;
        }
        phases.push(i);
        let ends: Vec<usize> = (0..=PARTS).map(|part| rows[part * (rows.len() - 1) / PARTS]).collect();
        let parts =
            || ends.windows(2).map(|pair| (run.q[i][pair[1]] - run.q[i][pair[0]], run.t[pair[1]] - run.t[pair[0]]));
        let steady = parts().all(|(q, t)| (q - mean * t).abs() <= STEADY * (mean * t).abs());
        let fastest = parts().filter(|(_, t)| *t > 0.0).fold(frequency, |f, (q, t)| f.max((q / t).abs() / law.period));
        let force = force(run.model, law.name).map(|output| output.name);
        let rotors = rotors(run, &rows, frequency);
        let geared = rotors.iter().map(|rotor| rotor.name).collect();
        let relative = planets::rotors(run, &rows, law.phase, frequency);
        let rotors = if relative.is_empty() { rotors } else { relative };
        meshes.push(Mesh { name: law.name, frequency, fastest, steady, force, rotors, geared });
    }
    meshes
}

fn rotors(run: &Trajectory, rows: &[usize], mesh: f64) -> Vec<Rotor> {
    let mut rotors: Vec<Rotor> = vec![];
    for (output, column) in run.outputs.iter().filter(|(output, _)| output.unit == SHAFT) {
        let frequency = mean(column, rows).abs() / std::f64::consts::TAU;
        let teeth = teeth(mesh, frequency).filter(|teeth| rotors.iter().all(|rotor| rotor.teeth != *teeth));
        rotors.extend(teeth.map(|teeth| Rotor { name: output.name, frequency, teeth, meets: 1 }));
    }
    rotors
}

/// The number of teeth of a gear, if the mesh frequency is a whole multiple of its frequency.
pub(super) fn teeth(mesh: f64, gear: f64) -> Option<f64> {
    let teeth = (mesh / gear).round();
    (TEETH.contains(&teeth) && (mesh / gear - teeth).abs() <= WHOLE).then_some(teeth)
}

/// The mean of evenly spaced samples, by the trapezoidal rule.
pub(super) fn mean(column: &[f64], rows: &[usize]) -> f64 {
    let ends = 0.5 * (column[rows[0]] + column[rows[rows.len() - 1]]);
    (rows.iter().map(|&row| column[row]).sum::<f64>() - ends) / (rows.len() - 1).max(1) as f64
}
