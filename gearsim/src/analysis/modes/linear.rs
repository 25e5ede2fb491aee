//! The part of a matrix that comes from one parameter, if the matrix is linear in this parameter. It is computed numerically, from 1, 2 and
//! 3 times the parameter, so that a model need not say which of its parameters are stiffnesses or inertias.

use nalgebra::DMatrix;

use crate::engine::Refusal;
use crate::scene::Scene;
use crate::tolerance::analysis::{LINEAR_STIFFNESS, STIFFNESS_ROUNDING};

/// The value of `of` for `scene` with `times` times a parameter. `None` if that gives no valid equations: the parameter is then neither a
/// stiffness nor an inertia.
pub(super) fn multiple<T>(
    scene: &Scene,
    (parameter, times): (usize, f64),
    of: &dyn Fn(&Scene) -> Result<T, Refusal>,
) -> Option<T> {
    let mut scene = scene.clone();
    scene.parameters[parameter] *= times;
    of(&scene).ok()
}

/// The part of a matrix that comes from the parameter, and the rounding error of its elements; `None` if the matrix is not linear in it.
pub(super) fn part([once, twice, thrice]: [&DMatrix<f64>; 3]) -> Option<(DMatrix<f64>, f64)> {
    let part = twice - once;
    let bend = (thrice - twice - &part).amax();
    let rounding = STIFFNESS_ROUNDING * thrice.amax();
    (bend <= LINEAR_STIFFNESS * part.amax() + rounding).then_some((part, rounding))
}
