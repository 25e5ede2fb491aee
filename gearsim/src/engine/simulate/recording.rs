//! The rows that are recorded during a run.

use crate::engine::error::Stop;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::Motion;
use crate::engine::record::Recorder;
use crate::trajectory::Moment;

/// A recorder in use: it records samples at a rate and, if requested, the limits at events.
pub struct Recording<'r, 'e> {
    recorder: &'r mut Recorder<'e>,
    /// Sampling rate \[1/s\].
    rate: f64,
    /// Whether the left and right limits at events are recorded.
    events: bool,
    /// The number of the next sample.
    next: u64,
}

impl<'r, 'e> Recording<'r, 'e> {
    /// Records samples with `recorder` at `rate` \[1/s\] and, if `events`, the limits at events.
    pub fn new(recorder: &'r mut Recorder<'e>, rate: f64, events: bool) -> Self {
        Recording { recorder, rate, events, next: 0 }
    }

    /// The recorder, if events are recorded.
    pub fn of_events(&mut self) -> Option<&mut Recorder<'e>> {
        self.events.then_some(&mut *self.recorder)
    }

    /// When the next sample is due \[s\].
    pub fn due(&self) -> f64 {
        self.next as f64 / self.rate
    }

    /// Adds the samples that are due within the time `t` \[s\] of a motion from `now`, except at the end of the run, which has its own row.
    /// A sample at an event belongs to the motion that ends there.
    pub fn samples(&mut self, now: &Hybrid<'_>, motion: &mut dyn Motion, t: f64) {
        let mut end = now.clock;
        end.advance(t);
        loop {
            let at = self.due();
            let tau = now.clock.until(at);
            if tau > t || at >= now.t_end {
                return;
            }
            let reached = motion.at(tau.max(0.0));
            self.recorder.beyond = now.work.iter().zip(reached.work).map(|(work, more)| work + more).collect();
            let lost = (now.dissipated + reached.dissipated, now.ignored);
            // A sample just before the event that ends the motion must not be recorded with a later time.
            let at = at.min(end.now());
            let k = now.levels_at(&reached.state, at);
            self.recorder.row(now, (at, Moment::Sample), &reached.state, &k, lost);
            self.next += 1;
        }
    }

    /// Adds a row with the present state.
    pub fn note(&mut self, now: &Hybrid<'_>, moment: Moment) {
        now.note(self.recorder, moment);
    }

    /// Stops a run that has reached a limit: [`Recorder::allow`].
    ///
    /// # Errors
    /// [`Stop::Rows`], [`Stop::Time`].
    #[inline]
    pub fn allow(&mut self) -> Result<(), Stop> {
        self.recorder.allow()
    }
}

impl Hybrid<'_> {
    /// Adds a row with the present state to a recorder.
    pub fn note(&self, recorder: &mut Recorder<'_>, moment: Moment) {
        recorder.beyond.clone_from(&self.work);
        let t = self.clock.now();
        let k = self.levels_at(&self.state, t);
        recorder.row(self, (t, moment), &self.state, &k, (self.dissipated, self.ignored));
    }
}
