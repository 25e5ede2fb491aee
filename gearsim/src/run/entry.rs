//! A model for programs.

use super::compensated::compensate;
use super::{Outcome, Prepared, Prospect, Refusal, together};
use crate::engine::equations::{Derived, DerivedModel, Equations};
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::engine::system::System;
use crate::engine::train::Elements;
use crate::model::Model;
use crate::scene::Scene;

/// A model for programs: its description, and how to run a scene of it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The description of the model.
    pub model: &'static Model,
    derived: DerivedModel,
}

impl Entry {
    /// The entry of a derived model: `D` is a type that [`equations!`](crate::equations) defines.
    pub const fn new<D: Derived>() -> Entry {
        Entry { model: &D::MODEL, derived: DerivedModel::of::<D>() }
    }

    /// The entry of trains, whose parts a scene lists. `elements` are the elements of `model`, in its order.
    pub(crate) const fn train(model: &'static Model, elements: &'static Elements) -> Entry {
        Entry { model, derived: DerivedModel { model, source: elements } }
    }

    /// This entry with the description of a scene's model. For a train this description contains its parts.
    pub(crate) fn described(self, model: &'static Model) -> Entry {
        Entry { model, ..self }
    }

    /// Runs a scene. `watch` gets the model time \[s\] as the run proceeds.
    ///
    /// # Errors
    /// If the scene cannot be run.
    pub fn run(&self, scene: &Scene, watch: &mut dyn FnMut(f64)) -> Result<Outcome, Refusal> {
        let equations = self.equations(scene)?;
        Ok(Prepared::new(&self.derived, scene, &*equations)?.run(watch))
    }

    /// The method and the initial state with which a scene would be run. The scene is not run.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    pub fn check(&self, scene: &Scene) -> Result<Prospect, Refusal> {
        let equations = self.equations(scene)?;
        let Prepared { simulation, plan } = Prepared::new(&self.derived, scene, &*equations)?;
        let (method, why) = (plan.choice.method.name(), plan.choice.why);
        Ok(Prospect { method, why, q: simulation.now.state.q.to_vec(), q_dot: simulation.now.state.q_dot.to_vec() })
    }

    /// Describes the static equilibria of a scene other than the one at which it starts, as a remark on its run. `None` if there are none.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    pub(crate) fn other_equilibria(&self, scene: &Scene) -> Result<Option<String>, Refusal> {
        start::other_equilibria(&*self.equations(scene)?, scene)
    }

    /// Runs scenes side by side. If a scene has linear cells, constant torques and plain precision, only its start and its end are
    /// recorded.
    ///
    /// # Errors
    /// For each scene, those of [`Entry::run`].
    pub fn ends(&self, scenes: &[Scene]) -> Vec<Result<Outcome, Refusal>> {
        let equations: Vec<_> = scenes.iter().map(|scene| self.equations(scene)).collect();
        let prepared = scenes.iter().zip(&equations).map(|(scene, equations)| match equations {
            Ok(equations) => Prepared::new(&self.derived, scene, &**equations),
            Err(refusal) => Err(refusal.clone()),
        });
        together::run(prepared.collect())
    }

    /// The equations of a scene, for analyses.
    ///
    /// # Errors
    /// Those of [`System::of`].
    pub(crate) fn system(&self, scene: &Scene) -> Result<System, Refusal> {
        System::of(&self.derived, scene)
    }

    /// The equations of a scene about its steady motion.
    ///
    /// # Errors
    /// Those of [`System::about_steady_motion`].
    pub(crate) fn about_steady_motion(&self, scene: &Scene) -> Result<System, Refusal> {
        System::about_steady_motion(&self.derived, scene)
    }

    /// The linear part of the equations of a scene.
    ///
    /// # Errors
    /// Those of [`System::linear_part`].
    pub(crate) fn linear_part(&self, scene: &Scene) -> Result<System, Refusal> {
        System::linear_part(&self.derived, scene)
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// If its effects contradict one another.
    pub(crate) fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        self.derived.equations(scene)
    }

    /// A simulation of `scene` as [`Entry::run`] runs it, for programs that use its states. `equations` are those of the scene.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    pub(crate) fn simulation<'a>(
        &self,
        scene: &'a Scene,
        equations: &'a dyn Equations,
    ) -> Result<Simulation<'a>, Refusal> {
        Ok(Prepared::new(&self.derived, scene, equations)?.simulation)
    }

    /// A simulation of `scene` with state and time in double-double precision.
    ///
    /// # Errors
    /// If its cells cannot be solved in double-double precision.
    pub(crate) fn compensate<'a>(
        &self,
        simulation: Simulation<'a>,
        scene: &'a Scene,
    ) -> Result<Simulation<'a>, Refusal> {
        compensate(&self.derived, simulation, scene)
    }
}
