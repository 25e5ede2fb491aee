//! Events at ever shorter intervals, which end a run.

use crate::engine::error::Stop;
use crate::engine::hybrid::Hybrid;
use crate::tolerance::events::{CASCADE_EVENTS, CASCADE_SPAN};

/// A sequence of events that follow one another without progress in time.
#[derive(Debug, Clone, Default)]
pub struct Cascade {
    /// When it began \[s\].
    since: f64,
    /// Number of events since then.
    events: u64,
}

impl Cascade {
    /// Ends a run after `CASCADE_EVENTS` events without progress in time. `rate` is an upper bound of the rates of the motion \[1/s\]. Time
    /// has progressed if the sequence is longer than `CASCADE_SPAN` / `rate`, and longer than the resolution of `f64`. The second condition
    /// is needed for very high rates, e.g. with 1e37 times the critical damping.
    ///
    /// # Errors
    /// [`Stop::Cascade`].
    #[inline]
    pub fn require_progress(&mut self, now: &Hybrid<'_>, rate: f64) -> Result<(), Stop> {
        let span = now.clock.until_about(self.since).abs();
        if span * rate > CASCADE_SPAN && span > f64::EPSILON * self.since {
            (self.since, self.events) = (now.clock.now(), 0);
            return Ok(());
        }
        self.events += 1;
        if self.events < CASCADE_EVENTS {
            return Ok(());
        }
        let (t, state, cell) = (now.clock.now(), now.state.describe(), now.cell());
        Err(Stop::Cascade { t, events: self.events as usize, span, state, cell })
    }
}
