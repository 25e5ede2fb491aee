//! The inertias of a scene: moments of inertia and masses, parameters in which T is linear.
//!
//! T is the sum of the energies of the parts, each its inertia times half a square of speeds. So the part of M that comes from an inertia
//! is positive semidefinite, and its share of the kinetic energy is between 0 and 1. (A coordinate has no such share: where inertia
//! couples coordinates, Re(conj(phi_i) (M phi)_i) may be negative, and others more than the whole.) The parts of M are found numerically,
//! so that a model need not say which of its parameters are inertias: M at 1, 2 and 3 times the parameter.

use nalgebra::{DMatrix, DVector};

use crate::engine::Refusal;
use crate::engine::system::System;
use crate::engine::vector::Vector;
use crate::run::Entry;
use crate::scene::Scene;
use crate::tolerance::analysis::{LINEAR_STIFFNESS, STIFFNESS_ROUNDING};

/// The units of inertias.
const UNITS: [&str; 2] = ["kg*m^2", "kg"];

/// A moment of inertia or a mass, or all with the same parameter.
#[derive(Debug, Clone)]
pub struct Mass {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its part of M (n x n).
    pub inertia: DMatrix<f64>,
    /// Its momentum in a motion by unit of each coordinate (n), counted along its motion in the first rigid motion; if that leaves it at
    /// rest, along its largest component. Its product with a mode shape has the sign of the part's motion.
    pub sense: DVector<f64>,
}

/// The inertias of `scene`, in the order of the parameters, at the place of its `system`.
///
/// # Errors
/// Those of the equations of the scene.
pub fn of(scene: &Scene, entry: &Entry, system: &System) -> Result<Vec<Mass>, Refusal> {
    let place = system.steady().map_or_else(|| Vector::zeros(scene.model.coordinates.len()), |about| about.q.clone());
    let mass = |parameter: usize, times: f64| {
        let mut scene = scene.clone();
        scene.parameters[parameter] *= times;
        Ok::<_, Refusal>(entry.equations(&scene)?.mass(&place))
    };
    let rigid = (!scene.model.motions.is_empty()).then(|| DVector::from_column_slice(&system.motion(0)));
    let mut masses = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        let is_active = parameter.with.is_none_or(|effect| scene.effects.has(effect, scene.model));
        if scene.parameters[i] == 0.0 || !is_active || !UNITS.contains(&parameter.unit) {
            continue;
        }
        let once = mass(i, 1.0)?;
        let (Ok(twice), Ok(thrice)) = (mass(i, 2.0), mass(i, 3.0)) else { continue };
        let inertia = &twice - &once;
        let bend = (&thrice - &twice - &inertia).amax();
        let rounding = STIFFNESS_ROUNDING * thrice.amax();
        if inertia.amax() > 0.0 && bend <= LINEAR_STIFFNESS * inertia.amax() + rounding {
            masses.push(Mass { name: parameter.name, sense: sense(&inertia, rigid.as_ref()), inertia });
        }
    }
    Ok(masses)
}

fn sense(inertia: &DMatrix<f64>, rigid: Option<&DVector<f64>>) -> DVector<f64> {
    let along = rigid.map(|rigid| inertia * rigid).filter(|along| along.amax() > 0.0);
    along.unwrap_or_else(|| inertia.column(inertia.diagonal().imax()).into_owned())
}
