//! The parts of a scene that have a share in the energies of its modes.

use super::masses::{self, Mass};
use super::springs::{self, Spring};
use crate::engine::Refusal;
use crate::engine::system::System;
use crate::run::Entry;
use crate::scene::Scene;

/// The parts that have a share in the energies of modes.
#[derive(Debug, Clone, Default)]
pub struct Parts {
    /// Springs other than meshes.
    pub springs: Vec<Spring>,
    /// Inertias.
    pub masses: Vec<Mass>,
}

impl Parts {
    /// The parts of `scene`. `watch` is called many times during the computation.
    ///
    /// # Errors
    /// Those of the matrices of the scene.
    pub fn of(scene: &Scene, entry: &Entry, system: &System, watch: &dyn Fn()) -> Result<Parts, Refusal> {
        Ok(Parts { springs: springs::of(scene, entry, watch)?, masses: masses::of(scene, entry, system, watch)? })
    }
}
