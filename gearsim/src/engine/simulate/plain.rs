//! Plain events: steps that the kernel passes ([`lanes`](crate::engine::lanes)).

use crate::engine::lanes::alone;
use crate::engine::record::Recorder;
use crate::trajectory::Moment;

use super::Simulation;

impl Simulation<'_> {
    /// Passes the next step, if the kernel can; else changes nothing. Tells whether it has.
    #[inline]
    pub(super) fn pass_plain(
        &mut self,
        recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>,
        sample: &mut u64,
    ) -> bool {
        let Some(mut kernel) = self.kernel.take().unwrap_or_else(|| alone::of(self)) else {
            self.kernel = Some(None);
            return false;
        };
        // Solve, locate, propagate and jump.
        let located = kernel.locate(self);
        if let Some(t) = located {
            if let Some((recorder, rate, _)) = recorder {
                self.samples_until(t, *rate, sample, recorder);
            }
            let noting = recorder.as_mut().filter(|(.., events)| *events).map(|(recorder, ..)| recorder);
            match noting {
                Some(recorder) => {
                    let mut arrived = self.state.clone();
                    let (t, dissipated) = kernel.arrive(&mut arrived);
                    recorder.row(t, Moment::Before, &arrived, &self.k, (dissipated, self.ignored));
                    kernel.pass(self);
                    self.note(recorder, Moment::After);
                }
                None => kernel.pass(self),
            }
        }
        self.kernel = Some(Some(kernel));
        located.is_some()
    }

    /// Records the samples that are due within the time `t` [s], in the cell as it is.
    fn samples_until(&self, t: f64, rate: f64, next: &mut u64, recorder: &mut Recorder<'_>) {
        let at = *next as f64 / rate;
        if self.clock.until(at) <= t && at < self.t_end {
            let here = self.here();
            self.samples(here, &here.cell.flight(&self.state.q, &self.state.q_dot), t, rate, next, recorder);
        }
    }
}
