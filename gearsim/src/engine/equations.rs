//! The equations of a scene: those of its model with its parameters, which may vary in time.

#[cfg(test)]
mod tests;
mod varying;

use xprec::Df64;

pub use gearsim_equations::Known;
pub use gearsim_equations::interface::*;
pub use varying::varying_by_steps;

use crate::engine::error::Refusal;
use crate::model::Model;
use crate::scene::Scene;
use crate::tolerance::events::EDGE_ROUNDING;
use varying::Varying;

/// Where the equations of a scene come from: a derived model, or the parts of a train ([`train`](crate::engine::train)).
pub trait Source: Sync {
    /// The equations of a scene. `parameters` are the values of its parameters \[SI\], `mids` the mid values of its laws. `None` if its
    /// effects contradict one another.
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>>;
    /// The linear cells of a scene in double-double precision.
    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a>;
}

impl Source for Functions {
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>> {
        (self.equations)(&scene.effects, parameters, mids)
    }

    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a> {
        (self.exactly)(&scene.effects, &parameters, &mids)
    }
}

/// A model for the engine: its description, and the source of its equations.
#[derive(Clone, Copy)]
pub struct DerivedModel {
    /// The description of the model. For a train it does not contain the parts; these are in the description of the scene.
    pub model: &'static Model,
    /// The source of its equations.
    pub source: &'static dyn Source,
}

impl DerivedModel {
    /// The model `D` with its derived functions.
    pub const fn of<D: Derived>() -> DerivedModel {
        DerivedModel { model: &D::MODEL, source: const { &Functions::of::<D>() } }
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// If its effects contradict one another.
    pub fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        let mids = scene.mids();
        let which = || scene.effects.contradictions(scene.model);
        let start = self.source.equations(scene, &scene.parameters, &mids);
        let equations = start.and_then(|start| Varying::of(start, self.source, scene, &mids));
        equations.ok_or_else(|| Refusal::Effects { which: which() })
    }
}

/// The rounding error of the value of a guard near zero; `k` are the values of laws and switches.
pub fn rounding(guard: &Affine, k: &[f64]) -> f64 {
    EDGE_ROUNDING * guard.size_at(k)
}
