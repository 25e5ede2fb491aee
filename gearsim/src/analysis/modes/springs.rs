//! The springs of a scene other than its meshes: parameters in which K is linear and on which M does not depend. K is evaluated with every
//! law at zero.

use nalgebra::DMatrix;

use super::linear::{multiples, part};
use crate::engine::Refusal;
use crate::run::Entry;
use crate::scene::Scene;

/// A spring, or all springs with the same parameter.
#[derive(Debug, Clone)]
pub struct Spring {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its part of K (n x n).
    pub stiffness: DMatrix<f64>,
}

/// The springs of `scene`, in the order of the parameters.
///
/// # Errors
/// Those of the matrices of the scene.
pub fn of(scene: &Scene, entry: &Entry) -> Result<Vec<Spring>, Refusal> {
    let matrices = |scene: &Scene| {
        let no_mesh = vec![0.0; scene.stiffnesses().count()];
        entry.linear_part(scene)?.matrices(&no_mesh)
    };
    let mut springs = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        if scene.parameters[i] == 0.0 || !scene.effects.activate(parameter.with, scene.model) {
            continue;
        }
        let Some([once, twice, thrice]) = multiples(scene, i, &matrices)? else { continue };
        if let Some((stiffness, rounding)) = part([&once.stiffness, &twice.stiffness, &thrice.stiffness])
            && stiffness.amax() > rounding
            && twice.mass == once.mass
        {
            springs.push(Spring { name: parameter.name, stiffness });
        }
    }
    Ok(springs)
}
