//! The springs of a scene other than its meshes: parameters in which K is linear and on which M does not depend. K is evaluated with every
//! law at zero.

use nalgebra::DMatrix;

use super::linear::{multiple, part};
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

/// The springs of `scene`, in the order of the parameters. `watch` is called for each parameter.
///
/// # Errors
/// Those of the matrices of the scene.
pub fn of(scene: &Scene, entry: &Entry, watch: &dyn Fn()) -> Result<Vec<Spring>, Refusal> {
    let matrices = |scene: &Scene| {
        let no_mesh = vec![0.0; scene.stiffnesses().count()];
        entry.linear_part(scene)?.matrices(&no_mesh)
    };
    let once = matrices(scene)?;
    let mut springs = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        if scene.parameters[i] == 0.0 || !scene.effects.activate(parameter.with, scene.model) {
            continue;
        }
        watch();
        let Some(twice) = multiple(scene, (i, 2.0), &matrices) else { continue };
        // Most parameters are no stiffnesses: they leave K as it is, or change M.
        if twice.mass != once.mass || twice.stiffness == once.stiffness {
            continue;
        }
        let Some(thrice) = multiple(scene, (i, 3.0), &matrices) else { continue };
        if let Some((stiffness, rounding)) = part([&once.stiffness, &twice.stiffness, &thrice.stiffness])
            && stiffness.amax() > rounding
        {
            springs.push(Spring { name: parameter.name, stiffness });
        }
    }
    Ok(springs)
}
