//! The springs of a scene other than its meshes: parameters in which K is linear and on which M does not depend.
//!
//! They are found numerically, so that a model need not say which of its parameters are stiffnesses: K is evaluated at 1, 2 and 3
//! times the parameter, with every law at zero.

use nalgebra::DMatrix;

use crate::engine::Refusal;
use crate::run::Entry;
use crate::scene::Scene;
use crate::tolerance::analysis::{LINEAR_STIFFNESS, STIFFNESS_ROUNDING};

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
    let matrices = |parameter: usize, times: f64| {
        let mut scene = scene.clone();
        scene.parameters[parameter] *= times;
        let no_mesh = vec![0.0; scene.stiffnesses().count()];
        entry.linear_part(&scene)?.matrices(&no_mesh)
    };
    let mut springs = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        if scene.parameters[i] == 0.0 || parameter.with.is_some_and(|e| !scene.effects.has(e, scene.model)) {
            continue;
        }
        let once = matrices(i, 1.0)?;
        // If a multiple of the parameter gives no valid system, the parameter is not a stiffness.
        let (Ok(twice), Ok(thrice)) = (matrices(i, 2.0), matrices(i, 3.0)) else { continue };
        let stiffness = &twice.stiffness - &once.stiffness;
        let bend = (&thrice.stiffness - &twice.stiffness - &stiffness).amax();
        let rounding = STIFFNESS_ROUNDING * thrice.stiffness.amax();
        let size = stiffness.amax();
        if size > rounding && bend <= LINEAR_STIFFNESS * size + rounding && twice.mass == once.mass {
            springs.push(Spring { name: parameter.name, stiffness });
        }
    }
    Ok(springs)
}
