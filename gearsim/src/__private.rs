//! Not part of the public interface: it changes without notice. It exports the items of the engine that two users need: the code that
//! `equations!` generates in other crates, and the tests, benches and chores of this repository.

// For the code of `equations!`: the trait of a model's equations, the arguments and results of its functions, and their arithmetic.
pub use gearsim_equations::__private::{Effects, Matrix, Vector, model, real};

/// For the code of `equations!`. `DerivedModel` is for tests and benches.
pub mod equations {
    pub use gearsim_equations::__private::equations::*;

    pub use crate::engine::equations::DerivedModel;
}

// Parts of the engine, for the tests (`tests/suite`), the benches (`benches`) and the chores (`xtask/chores`).
pub use crate::engine::cell::{Cell, Flight, Point};
pub use crate::engine::clock::Clock;
pub use crate::engine::crossing::{Cost, Delay, Search, SearchError, Side};
pub use crate::engine::hybrid::Hybrid;
pub use crate::engine::jump::{Passage, Surface};
pub use crate::engine::law::LawState;
pub use crate::engine::modal::{Matrices, Modal};
pub use crate::engine::record::{Recorder, State};
pub use crate::engine::signal::Signal;
pub use crate::engine::simulate::Simulation;
pub use crate::engine::system::{LinearisedAbout, System};
pub use crate::engine::vector::dot;

/// Runs many simulations side by side, as sweeps do. Benches and chores measure it alone.
pub mod ensemble {
    pub use crate::ensemble::run;
}

/// The types of the derived models: tests compare them with hand-written equations.
#[cfg(feature = "models")]
pub use gearsim_generated::models;

/// Modes and Floquet multipliers, for tests that change the equations. For a scene, use [`Scene::modes`] and [`Scene::floquet`].
pub mod linear {
    use nalgebra::DMatrix;

    use super::{Matrices, System};
    use crate::analysis::floquet::{Floquet, FloquetError};
    use crate::analysis::modes::{self, CellModes};
    use crate::analysis::steady;
    use crate::run::{Entry, Refusal};
    use crate::scene::Scene;

    pub use modes::masses::Mass;
    pub use modes::parts::Parts;

    /// The parts of a scene among which the energies of its modes are divided.
    ///
    /// # Errors
    /// Those of the matrices of the scene.
    pub fn parts(scene: &Scene, entry: &Entry, system: &System) -> Result<Parts, Refusal> {
        Parts::of(scene, entry, system, &|| {})
    }

    /// The modes of the cell with the law values `k` \[SI\].
    ///
    /// # Errors
    /// Those of [`Modal::of`](super::Modal::of).
    pub fn modes(system: &System, k: &[f64], parts: &Parts) -> Result<CellModes, Refusal> {
        modes::of(system, k, parts, &|| {})
    }

    /// The modes of a cell without laws, from its matrices.
    ///
    /// # Errors
    /// Those of [`Modal::of`](super::Modal::of).
    pub fn modes_of(matrices: &Matrices, parts: &Parts) -> Result<CellModes, Refusal> {
        let laws: [DMatrix<f64>; 0] = [];
        modes::of_matrices(matrices, &[], &laws, parts, &|| {})
    }

    /// The stiffnesses of a scene in steady rotation as a function of the time \[s\].
    ///
    /// # Errors
    /// If the start of the scene cannot be determined.
    pub fn stiffnesses(scene: &Scene, system: &System) -> Result<impl Fn(f64) -> Vec<f64>, Refusal> {
        let courses = steady::courses(scene, system)?;
        Ok(move |t| courses.iter().map(|course| course.at(t)).collect())
    }

    /// The Floquet multipliers of a scene whose equations are `system`.
    ///
    /// # Errors
    /// Those of [`Scene::floquet`].
    pub fn floquet(scene: &Scene, system: &System) -> Result<Floquet, FloquetError> {
        Floquet::of(scene, system, &|| {})
    }
}

/// The number of correct digits of a result: tests compare methods by it.
pub mod digits {
    pub use crate::analysis::digits::{companion, noted};
}

/// The distance of two trajectories: tests compare methods by it.
pub mod error {
    pub use crate::analysis::work_precision::error::{difference, of, sizes};
}

// Parts of commands, for tests and fuzz targets.
pub use crate::analysis::work_precision::Runner;
pub use crate::analysis::work_precision::reference::of as reference;
pub use crate::output::marker::MARKER;
pub use crate::scene::template::Template;
pub use crate::sweep::folder::Folder;
pub use crate::sweep::manifest::Manifest;
pub use crate::sweep::merge::gather;
pub use crate::sweep::{Request, Sweep};

// Usual values for the scenes of any model, for tests of all models.
pub use crate::library::{usual_levels, usual_value};

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::run::Entry;
use crate::scene::Scene;

/// Functions of a model that only tests, benches and chores use.
pub trait Inside {
    /// The equations of a scene.
    ///
    /// # Errors
    /// If its effects contradict one another.
    fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal>;

    /// A simulation of `scene` as [`Entry::run`] runs it; `equations` are those of the scene.
    ///
    /// # Errors
    /// Those of [`Entry::run`].
    fn simulation<'a>(&self, scene: &'a Scene, equations: &'a dyn Equations) -> Result<Simulation<'a>, Refusal>;

    /// The simulation with state and time in double-double precision.
    ///
    /// # Errors
    /// If the cells of the scene cannot be solved in double-double precision.
    fn compensate<'a>(&self, simulation: Simulation<'a>, scene: &'a Scene) -> Result<Simulation<'a>, Refusal>;

    /// The equations of a scene, for analyses.
    ///
    /// # Errors
    /// Those of [`System::of`].
    fn system(&self, scene: &Scene) -> Result<System, Refusal>;

    /// The equations of a scene about its steady motion.
    ///
    /// # Errors
    /// Those of [`System::about_steady_motion`].
    fn about_steady_motion(&self, scene: &Scene) -> Result<System, Refusal>;
}

impl Inside for Entry {
    fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        self.equations(scene)
    }

    fn simulation<'a>(&self, scene: &'a Scene, equations: &'a dyn Equations) -> Result<Simulation<'a>, Refusal> {
        self.simulation(scene, equations)
    }

    fn compensate<'a>(&self, simulation: Simulation<'a>, scene: &'a Scene) -> Result<Simulation<'a>, Refusal> {
        self.compensate(simulation, scene)
    }

    fn system(&self, scene: &Scene) -> Result<System, Refusal> {
        self.system(scene)
    }

    fn about_steady_motion(&self, scene: &Scene) -> Result<System, Refusal> {
        self.about_steady_motion(scene)
    }
}
