//! The models that scenes may name: those of gearsim, and those that a program adds.

use std::sync::RwLock;

use gearsim_generated::{ELEMENTS, TRAIN};

use crate::engine::train::Elements;
use crate::run::Entry;
use crate::scene::Scene;

// Unused without the feature `models`.
#[cfg(feature = "models")]
macro_rules! entry {
    ($model:ty) => {
        Entry::new::<$model>()
    };
}

static TRAINS: Elements = Elements(ELEMENTS);

/// The models of gearsim.
pub(crate) static MODELS: &[Entry] = &gearsim_generated::each_model!(entry, Entry::train(&TRAIN, &TRAINS));

static KNOWN: RwLock<&'static [Entry]> = RwLock::new(MODELS);

/// Adds the models of another crate, for example `add(&[Entry::new::<my_axle::MyAxle>()])`. Call it once, before any scene is read. If two
/// models have the same name, the one added last is used.
pub fn add(own: &[Entry]) {
    if own.is_empty() {
        return;
    }
    // Scenes hold references to their models until the program ends, so the list is never freed.
    let mut known = KNOWN.write().unwrap_or_else(|poisoned| poisoned.into_inner());
    *known = Box::leak([own, *known].concat().into_boxed_slice());
}

/// All models.
pub fn models() -> &'static [Entry] {
    *KNOWN.read().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// The descriptions of all models.
pub(crate) fn descriptions() -> Vec<&'static crate::model::Model> {
    models().iter().map(|entry| entry.model).collect()
}

/// The entry of the model of a scene; `None` if the scene was read with other models.
pub fn of(scene: &Scene) -> Option<&'static Entry> {
    models().iter().find(|entry| entry.model.name == scene.model.name)
}
