//! Plain events: steps that the kernel passes ([`lanes`](crate::engine::lanes)).

use crate::engine::lanes::alone::{self, Stopped};
use crate::trajectory::Moment;

use super::{Recording, Simulation};

impl Simulation<'_> {
    /// Passes plain events, many at once where their rows are not recorded. Returns whether it passed any and the next one may be
    /// plain too.
    pub(super) fn pass_all_plain(&mut self, recording: &mut Option<Recording<'_, '_>>) -> bool {
        if recording.as_mut().is_some_and(|recording| recording.of_events().is_some()) {
            return self.pass_plain(recording);
        }
        let Some(mut kernel) = self.kernel.take().unwrap_or_else(|| alone::of(self)) else {
            self.kernel = Some(None);
            return false;
        };
        let until = recording.as_ref().map_or(f64::INFINITY, Recording::due);
        let stopped = kernel.advance(self, until);
        self.kernel = Some(Some(kernel));
        match stopped {
            Stopped::Enough => true,
            Stopped::Due => self.pass_plain(recording),
            Stopped::General => false,
        }
    }

    /// Passes the next step if the kernel can, otherwise changes nothing. Returns whether it has passed the step.
    #[inline]
    pub(super) fn pass_plain(&mut self, recording: &mut Option<Recording<'_, '_>>) -> bool {
        let Some(mut kernel) = self.kernel.take().unwrap_or_else(|| alone::of(self)) else {
            self.kernel = Some(None);
            return false;
        };
        // Solve, locate, propagate and jump.
        let located = kernel.locate(self);
        if let Some(t) = located {
            self.samples_until(t, recording);
            match recording.as_mut().and_then(Recording::of_events) {
                Some(recorder) => {
                    let mut arrived = self.now.state.clone();
                    let (t, dissipated) = kernel.arrive(&mut arrived);
                    let lost = (dissipated, self.now.ignored);
                    recorder.row(&self.now, (t, Moment::Before), &arrived, &self.now.k, lost);
                    kernel.pass(self);
                    self.now.note(recorder, Moment::After);
                }
                None => kernel.pass(self),
            }
        }
        self.kernel = Some(Some(kernel));
        located.is_some()
    }

    /// Records the samples that are due within the time `t` \[s\], in the present cell.
    fn samples_until(&mut self, t: f64, recording: &mut Option<Recording<'_, '_>>) {
        let Some(recording) = recording else { return };
        let at = recording.due();
        if self.now.clock.until(at) > t || at >= self.now.t_end {
            return;
        }
        if (self.entered || self.change_mode().is_ok())
            && let Ok(mut motion) = self.solver.solve(&self.now, t)
        {
            recording.samples(&self.now, &mut *motion, t);
        }
    }
}
