//! The models that the program knows: those of a crate that runs it, then its own.

use std::sync::OnceLock;

use crate::generated::MODELS;
use crate::run::Entry;

static KNOWN: OnceLock<Vec<Entry>> = OnceLock::new();

/// Adds the models of another crate. Of two models of one name the first counts.
pub(super) fn add(own: &[Entry]) {
    // The program starts once; models that come later would not be seen by what has run before.
    let _ = KNOWN.set([own, MODELS].concat());
}

/// All models.
pub(super) fn models() -> &'static [Entry] {
    KNOWN.get_or_init(|| MODELS.to_vec())
}
