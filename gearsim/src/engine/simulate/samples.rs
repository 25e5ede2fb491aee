//! What is written down of a run.

use crate::engine::cell::Flight;
use crate::engine::cells::Prepared;
use crate::engine::record::Recorder;
use crate::engine::vector::Vector;
use crate::trajectory::Moment;

use super::Simulation;

impl Simulation<'_> {
    pub(super) fn samples(
        &self,
        here: &Prepared,
        flight: &Flight<'_>,
        t: f64,
        rate: f64,
        next: &mut u64,
        recorder: &mut Recorder<'_>,
    ) {
        // A sample a rounding before the event that ends the flight is not noted after it.
        let mut end = self.clock;
        end.advance(t);
        loop {
            let at = *next as f64 / rate;
            let tau = self.clock.until(at);
            // The end of the run is noted by itself; a sample at a boundary belongs to the cell it ends.
            if tau > t || at >= self.t_end {
                return;
            }
            let point = flight.at(tau.max(0.0));
            let (dq, dv) = flight.increments(&point);
            let state = self.state.moved(&dq, &dv);
            let dissipated = flight.dissipated(&point) + self.clipped(here, &dq);
            if let Some(forcing) = &self.forcing {
                recorder.beyond = forcing.work_after(&self.clock, &dq);
            }
            let lost = (self.dissipated + dissipated, self.ignored);
            recorder.row(at.min(end.now()), Moment::Sample, &state, &self.k, lost);
            *next += 1;
        }
    }

    /// Adds a row of how it stands.
    pub fn note(&self, recorder: &mut Recorder<'_>, moment: Moment) {
        if let Some(forcing) = &self.forcing {
            recorder.beyond.clone_from(forcing.work());
        }
        recorder.row(self.clock.now(), moment, &self.state, &self.k, (self.dissipated, self.ignored));
    }

    /// What the clipped dampers of dead bands take where the coordinates move on by `dq` [J].
    #[inline]
    pub(super) fn clipped(&self, here: &Prepared, dq: &Vector) -> f64 {
        self.bands.iter().zip(&here.bands).map(|(band, banded)| band.clipped(banded.elastic, &self.state.q, dq)).sum()
    }
}
