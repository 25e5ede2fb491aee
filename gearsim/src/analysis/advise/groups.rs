//! The dimensionless groups of a scene that indicate which effects matter.

use crate::analysis::modes::{self, Meeting};
use crate::analysis::steady::{self, SteadyLaw};
use crate::engine::Refusal;
use crate::engine::system::System;
use crate::scene::Scene;

/// The dimensionless groups of a scene.
#[derive(Debug, Clone)]
pub struct Groups {
    /// The groups of every law that steps.
    pub meshes: Vec<Mesh>,
    /// Damped natural frequency \[Hz\] and damping factor of each mode at the mid stiffness, by ascending frequency.
    pub modes: Vec<(f64, f64)>,
    /// Harmonics of a mesh frequency near a natural frequency, the nearest first, each with the name of its law.
    pub meetings: Vec<(&'static str, Meeting)>,
    /// Parameters of effects, each over a static deflection in the same unit. The backlash of a mesh is over the deflection of this mesh,
    /// any other parameter over the largest deflection of a coordinate.
    pub gaps: Vec<(&'static str, f64)>,
}

/// The groups of a mesh.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// Name of its law.
    pub law: &'static str,
    /// Jump strength J = 2 G dV/v²: the energy of a step over the kinetic energy of the phase. dV is the energy of the largest step, at
    /// the static deflection of the softest cell. For a gear pair J = M2 dk (T0/k)²/theta'².
    pub strength: f64,
    /// Mesh frequency \[Hz\].
    pub frequency: f64,
    /// Largest stiffness over smallest.
    pub ratio: f64,
}

impl Groups {
    /// The groups of a scene.
    ///
    /// # Errors
    /// [`Refusal`] if the modes of the scene cannot be computed.
    pub(crate) fn of(scene: &Scene, system: &System) -> Result<Groups, Refusal> {
        let model = scene.model;
        let courses = steady::courses(scene, system)?;
        let mids = scene.mid_stiffnesses();
        let cell = modes::of(system, &mids, &modes::Parts::default(), &|| {})?;
        let coordinate = |name: &str| model.coordinates.iter().position(|c| c.name == name).unwrap_or(0);
        let mut meshes = vec![];
        for (i, course) in courses.iter().enumerate().filter(|(_, c)| c.varies) {
            let (low, high) = course.extremes();
            let phase = coordinate(model.laws[i].phase);
            meshes.push(Mesh {
                law: course.name,
                strength: strength(system, &mids, (i, low, high), phase, course)?,
                frequency: course.mesh_frequency(),
                ratio: high / low,
            });
        }
        let statics = statics(system, &mids)?;
        let gap = |p: &(usize, &'static crate::model::Parameter)| {
            let (i, parameter) = *p;
            let effect = parameter.with?;
            let present = scene.effects.has(effect, model);
            let turns = |j: usize| scene.effects.turns(model.coordinates[j].name, model);
            let alike = (0..statics.len()).filter(|&j| model.coordinates[j].unit == parameter.unit && !turns(j));
            let largest = || alike.fold(0.0f64, |m, j| m.max(statics[j].abs()));
            if !present {
                return None;
            }
            // The play of a part is compared with the deflection of this part.
            let own = system.switched(effect, &statics).map(f64::abs).filter(|own| *own > 0.0);
            let size = own.unwrap_or_else(largest);
            (size > 0.0).then(|| (parameter.name, scene.parameters[i] / size))
        };
        let gaps = model.parameters.iter().enumerate().filter_map(|p| gap(&p)).collect();
        let modes = cell.modes.iter().filter_map(|mode| Some((mode.damped, mode.zeta?))).collect();
        let meetings = modes::meetings(&courses, &cell).into_iter().map(|m| (model.laws[m.law].name, m)).collect();
        Ok(Groups { meetings, meshes, modes, gaps })
    }

    /// The largest jump strength.
    pub fn strength(&self) -> f64 {
        self.meshes.iter().fold(0.0, |m, mesh| m.max(mesh.strength))
    }

    /// The lowest mesh frequency \[Hz\]; 0 if no law steps.
    pub fn mesh(&self) -> f64 {
        let lowest = self.meshes.iter().map(|m| m.frequency).filter(|f| *f > 0.0).fold(f64::INFINITY, f64::min);
        if lowest.is_finite() { lowest } else { 0.0 }
    }
}

/// Jump strength J of the step of a law from its lowest to its highest level, at the static deflection of the lowest.
fn strength(
    system: &System,
    mids: &[f64],
    (law, low, high): (usize, f64, f64),
    phase: usize,
    course: &SteadyLaw,
) -> Result<f64, Refusal> {
    let mut k = mids.to_vec();
    k[law] = low;
    let q = nalgebra::DVector::from_vec(statics(system, &k)?);
    let soft = system.matrices(&k)?;
    k[law] = high;
    let dk = system.matrices(&k)?.stiffness - &soft.stiffness;
    let dv = 0.5 * q.dot(&(dk * &q));
    Ok(2.0 * soft.mobility[(phase, phase)] * dv / (course.speed * course.speed))
}

/// Static deflections in the cell with law values `k`, without its rigid motions (n) [SI].
fn statics(system: &System, k: &[f64]) -> Result<Vec<f64>, Refusal> {
    let modal = crate::engine::modal::Modal::of(&system.matrices(k)?)?;
    let amplitude = |i: usize| if modal.modes[i].omega2 > 0.0 { modal.load[i] / modal.modes[i].omega2 } else { 0.0 };
    let xi = nalgebra::DVector::from_fn(modal.modes.len(), |i, _| amplitude(i));
    Ok((&modal.shapes * xi).iter().copied().collect())
}
