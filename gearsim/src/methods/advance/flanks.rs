//! Play under a numerical method: an event where flanks meet or part. In contact the damper is clipped in the right-hand side
//! ([`Field`](crate::methods::field::Field)), where the force has kinks but no steps, for the control of the step to deal with.

use crate::engine::crossing::Side;
use crate::engine::dead_band::{DeadBand, Grip, Regime};
use crate::engine::error::Stop;
use crate::engine::root;
use crate::engine::vector::Vector;
use crate::methods::dense::Dense;
use crate::methods::field::wanders;

use super::{Advance, Met, Recording};

impl Advance<'_> {
    /// The first edge that a dead band meets in a step, if it is before `first`.
    pub(super) fn first_edge(&mut self, dense: &Dense, mut first: Option<(f64, Met)>) -> Option<(f64, Met)> {
        for (i, band) in self.field.bands.iter().enumerate().filter(|(_, band)| !wanders(band, &self.field.laws)) {
            let ends = match band.regime {
                Regime::Free => [Side::Upper, Side::Lower].map(|side| Some((side, Regime::Contact(side, Grip::Touch)))),
                Regime::Contact(side, _) => [Some((side, Regime::Free)), None],
            };
            for (side, beyond) in ends.into_iter().flatten() {
                let (constant, slopes) = to_edge(band, side, beyond);
                let gap = dense.along(constant, &slopes);
                let found = root::first(&gap, 4.0 * f64::EPSILON * band.half);
                self.counts.cost.steps += found.steps;
                self.counts.cost.grazes += found.grazes;
                if let Some(x) = found.root.filter(|x| first.is_none_or(|first| *x < first.0)) {
                    first = Some((x, Met::Edge(i, side, beyond)));
                }
            }
        }
        first
    }

    /// Counts the flanks that have met in a step across edges that move along curves.
    pub(super) fn count_impacts(&mut self) {
        if !self.field.bands.iter().any(|band| wanders(band, &self.field.laws)) {
            return;
        }
        self.levels();
        for (i, free) in self.free.iter_mut().enumerate() {
            let now = self.field.bands[i].regime == Regime::Free;
            self.counts.impacts += u64::from(*free && !now && wanders(&self.field.bands[i], &self.field.laws));
            *free = now;
        }
    }

    /// Lets flanks meet, or part.
    pub(super) fn pass_edge(
        &mut self,
        band: usize,
        beyond: Regime,
        recording: &mut Recording<'_, '_>,
    ) -> Result<(), Stop> {
        self.event(recording, |run| {
            run.counts.impacts += u64::from(beyond != Regime::Free);
            run.field.bands[band].regime = beyond;
            run.field.enter();
            run.rate = run.field.rate(0.0, &run.y);
        })
    }

    /// Puts dead bands where the step has brought them.
    pub(super) fn catch_up_with_flanks(&mut self, recording: &mut Recording<'_, '_>) -> Result<(), Stop> {
        for i in 0..self.field.bands.len() {
            let (band, state) = (&self.field.bands[i], self.state());
            let now = band.met(&state.q);
            if now != band.regime {
                self.pass_edge(i, now, recording)?;
            }
        }
        Ok(())
    }
}

/// What is left to the edge at a side where a band goes over into the regime `beyond`: constant + slopes.q, positive before it.
pub(super) fn to_edge(band: &DeadBand, side: Side, beyond: Regime) -> (f64, Vector) {
    let out = if beyond == Regime::Free { 1.0 } else { -1.0 };
    let (constant, slopes) = band.depth_along(side);
    (out * constant, &slopes * out)
}
