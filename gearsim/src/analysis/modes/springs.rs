//! The springs of a scene beside its meshes: parameters in which the stiffness matrix is linear, and the masses have no part.
//!
//! Found by their numbers, so that no model has to say which of its parameters are stiffnesses: K at once, twice and three
//! times the parameter, every law at zero.

use nalgebra::DMatrix;

use crate::engine::Refusal;
use crate::run::Entry;
use crate::scene::Scene;

/// A spring, or all those of one parameter.
#[derive(Debug, Clone)]
pub struct Spring {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its part of K.
    pub stiffness: DMatrix<f64>,
}

/// Deviation from a straight line that is rounding, in parts of the spring's stiffness.
const STRAIGHT: f64 = 1e-9;

/// The springs of `scene`, in the order of the parameters.
///
/// # Errors
/// Those of the scene's matrices.
pub fn of(scene: &Scene, entry: &Entry) -> Result<Vec<Spring>, Refusal> {
    let matrices = |parameter: usize, times: f64| {
        let mut scene = scene.clone();
        scene.parameters[parameter] *= times;
        let no_mesh = vec![0.0; scene.stiffnesses().count()];
        entry.system(&scene)?.matrices(&no_mesh)
    };
    let mut springs = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        if scene.parameters[i] == 0.0 || parameter.with.is_some_and(|e| !scene.effects.names(scene.model).contains(&e))
        {
            continue;
        }
        let once = matrices(i, 1.0)?;
        // A multiple that makes no system is not that of a stiffness.
        let (Ok(twice), Ok(thrice)) = (matrices(i, 2.0), matrices(i, 3.0)) else { continue };
        let stiffness = &twice.stiffness - &once.stiffness;
        let bend = (&thrice.stiffness - &twice.stiffness - &stiffness).amax();
        let rounding = 8.0 * f64::EPSILON * thrice.stiffness.amax();
        let size = stiffness.amax();
        if size > rounding && bend <= STRAIGHT * size + rounding && twice.mass == once.mass {
            springs.push(Spring { name: parameter.name, stiffness });
        }
    }
    Ok(springs)
}
