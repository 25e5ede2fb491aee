//! Which effects a scene needs: the deviation without each effect is estimated without a full run, then measured by runs with and
//! without it.
//!
//! - [`groups`]: the dimensionless groups of the scene: jump strength (Oh, Grosh & Barber 2005), mesh frequency over natural
//!   frequency, damping factor, stiffness ratio;
//! - [`candidates`]: the effects and terms that could be left out;
//! - [`orbit`]: the settled motion in steady rotation, a fixed point of the exact propagators over one period, with or without the
//!   impulses of the steps, computed without time integration;
//! - [`expect`]: the results that a run is expected to record, from settled motions at several speeds of the run;
//! - [`measures`]: the recorded results of a run, and the deviations between two such results;
//! - [`LIMITS`]: the deviations up to which an effect is negligible.

pub mod candidates;
pub mod expect;
pub mod groups;
pub mod measures;
pub mod orbit;

pub use candidates::{Candidate, Way};
pub(crate) use candidates::{base, candidates, with_play};
pub(crate) use expect::{expected, short_run};
pub use measures::{Apart, Bands, Measures};

/// Deviations up to which an effect may be left out; relative, those of bands in dB.
///
/// Bands: 1 dB, the limit used for the scenes of Oh, Grosh & Barber (`models/scenes/oh2005/README.md`). At 4500 rpm and 10 N m the
/// classical equations deviate by less than 0.03 dB, at 600 rpm by more than 1 dB. The other limits were chosen on the same scenes. At 4500
/// rpm every deviation is below a fifth of its limit. At 600 rpm speed and energy exceed their limits too.
pub const LIMITS: Apart = Apart { rms: 0.05, peak: 0.05, bands: 1.0, speed: 0.01, energy: 0.01, events: 0.01 };

#[cfg(test)]
mod tests;
