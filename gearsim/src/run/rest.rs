//! The outputs of a scene in static equilibrium, without vibration.

use super::Entry;
use crate::engine::equations::Known;
use crate::engine::error::Refusal;
use crate::engine::start;
use crate::model::Start;
use crate::scene::Scene;

impl Entry {
    /// The value of each output of the model \[SI\] in the static equilibrium of a scene, at the torques, phases and speeds of its start.
    /// Coordinates that are static by default are static here even if the scene states a value for them.
    ///
    /// # Errors
    /// If the forces do not determine the equilibrium, or the scene's effects contradict one another.
    pub fn outputs_at_rest(&self, scene: &Scene) -> Result<Vec<f64>, Refusal> {
        let mut scene = scene.clone();
        for (coordinate, start) in scene.model.coordinates.iter().zip(&mut scene.start.q) {
            if coordinate.start.is_static() && !start.is_static() {
                *start = Start::Static;
            }
        }
        // Without vibration the speeds are those of the rigid motions.
        if !scene.start.motions.iter().all(|speed| *speed == 0.0) {
            scene.start.q_dot.iter_mut().for_each(|speed| *speed = None);
        }
        let equations = self.equations(&scene)?;
        let initial = start::begin(&*equations, &scene)?;
        let (q, q_dot, k) = (initial.absolute(), &initial.state.q_dot, initial.levels(&scene));
        Ok((0..scene.model.outputs.len()).map(|i| equations.output(i, &q, q_dot, &k, &Known::default())).collect())
    }
}
