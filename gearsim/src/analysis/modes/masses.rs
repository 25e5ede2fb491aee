//! The inertias of a scene: the moments of inertia and the masses among its parameters. M is linear in each of them.
//!
//! T is the sum of the energies of the parts; the energy of a part is its inertia times half a square of speeds. The part of M that comes
//! from an inertia is therefore positive semidefinite, and its share of the kinetic energy is between 0 and 1. (Coordinates have no such
//! shares: where inertia couples coordinates, Re(conj(phi_i) (M phi)_i) may be negative, and for other coordinates larger than the sum.)

use nalgebra::{DMatrix, DVector};

use super::linear::{multiples, part};
use crate::engine::Refusal;
use crate::engine::system::System;
use crate::engine::vector::Vector;
use crate::run::Entry;
use crate::scene::Scene;

/// The units of inertias.
const UNITS: [&str; 2] = ["kg*m^2", "kg"];

/// A moment of inertia or a mass, or all with the same parameter.
#[derive(Debug, Clone)]
pub struct Mass {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its part of M (n x n).
    pub inertia: DMatrix<f64>,
    /// Its momentum in the first rigid motion (n). If the part is at rest there, its momentum in a motion of the coordinate with its
    /// largest inertia. The product with a mode shape has the sign of the part's motion.
    pub sense: DVector<f64>,
}

/// The inertias of `scene` in the order of its parameters. M is evaluated at the coordinates about which `system` is linearised.
///
/// # Errors
/// Those of the equations of the scene.
pub fn of(scene: &Scene, entry: &Entry, system: &System) -> Result<Vec<Mass>, Refusal> {
    let place = system.steady().map_or_else(|| Vector::zeros(scene.model.coordinates.len()), |about| about.q.clone());
    let mass = |scene: &Scene| Ok(entry.equations(scene)?.mass(&place));
    let rigid = (!scene.model.motions.is_empty()).then(|| DVector::from_column_slice(&system.motion(0)));
    let mut masses = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        let is_active = scene.effects.activate(parameter.with, scene.model);
        if scene.parameters[i] == 0.0 || !is_active || !UNITS.contains(&parameter.unit) {
            continue;
        }
        let Some([once, twice, thrice]) = multiples(scene, i, &mass)? else { continue };
        if let Some((inertia, _)) = part([&once, &twice, &thrice])
            && inertia.amax() > 0.0
        {
            masses.push(Mass { name: parameter.name, sense: sense(&inertia, rigid.as_ref()), inertia });
        }
    }
    Ok(masses)
}

fn sense(inertia: &DMatrix<f64>, rigid: Option<&DVector<f64>>) -> DVector<f64> {
    let along = rigid.map(|rigid| inertia * rigid).filter(|along| along.amax() > 0.0);
    along.unwrap_or_else(|| inertia.column(inertia.diagonal().imax()).into_owned())
}
