//! Where the steps of a run meet boundaries, and what happens there.

use crate::engine::cells;
use crate::engine::crossing::Side;
use crate::engine::equations::Switching;
use crate::engine::error::Stop;
use crate::engine::guard;
use crate::engine::jump::Passage;
use crate::engine::law;

use super::flanks::to_edge;
use super::{Advance, Events, Met, Recording};
use crate::engine::root;
use crate::methods::Trial;
use crate::methods::dense::Dense;
use crate::methods::field::Field;
use crate::methods::flow::Flow;

impl Advance<'_> {
    /// The first boundary that the motion of a step meets: at which part of it, and which.
    pub(super) fn first_met(&mut self, dense: &Dense) -> Option<(f64, Met)> {
        if self.settings.events == Events::AfterStep {
            return None;
        }
        let slack = self.control.slack();
        let mut first: Option<(f64, Met)> = None;
        for (i, law) in self.field.laws.iter().enumerate() {
            if law.switching == Switching::Never && law.pitch.steps_only() || law.next_switch().is_some() {
                continue;
            }
            let (lower, upper) = law.bounds();
            for (side, bound) in [(Side::Upper, upper), (Side::Lower, lower)] {
                let gap = dense.gap(law.phase, bound, side.sign());
                let found = root::first_known_to(&gap, 4.0 * law.rounding(), slack[law.phase]);
                self.counts.cost.steps += found.steps;
                self.counts.cost.grazes += found.grazes;
                if let Some(x) = found.root.filter(|x| first.is_none_or(|first| *x < first.0)) {
                    first = Some((x, Met::Step(i, side)));
                }
            }
        }
        self.first_edge(dense, first)
    }

    /// What is left to a boundary, and its rate; positive before it is met.
    fn gap(&self, met: Met, y: &Flow) -> (f64, f64) {
        match met {
            Met::Step(law, side) => {
                let law = &self.field.laws[law];
                (side.sign() * (law.boundary(side) - y.q[law.phase]), -side.sign() * y.v[law.phase])
            }
            Met::Edge(band, side, beyond) => {
                let (constant, slopes) = to_edge(&self.field.bands[band], side, beyond);
                (constant + slopes.dot(&y.q), slopes.dot(&y.v))
            }
        }
    }

    /// Takes the step that met a boundary at its part `x` again, as long as to there.
    pub(super) fn land(&mut self, h: f64, x: f64, met: Met, dense: &Dense) -> (f64, Trial) {
        let (start, rate, allowed) = (self.y.clone(), self.rate.clone(), self.control.allowed());
        let interpolated = |field: &mut Field<'_>| {
            let end = dense.at(x);
            (x * h, Trial { rate: field.rate(x * h, &end), end, error: 0.0, stiffness: 0.0 })
        };
        if x == 0.0 {
            return (0.0, Trial { end: start, rate, error: 0.0, stiffness: 0.0 });
        }
        let rounding = match met {
            Met::Step(law, _) => self.field.laws[law].rounding(),
            Met::Edge(band, ..) => f64::EPSILON * self.field.bands[band].half,
        };
        let mut taken = x * h;
        for _ in 0..8 {
            let Some(mut trial) = self.method.attempt(&mut self.field, &start, &rate, taken, &allowed) else { break };
            let (gap, rate_of_gap) = self.gap(met, &trial.end);
            let dt = -gap / rate_of_gap;
            if gap.abs() <= rounding {
                return (taken, trial);
            }
            // Turning there, or not there at all: the polynomial has the last word.
            if !(rate_of_gap < 0.0 && taken + dt > 0.0 && dt.abs() <= 0.5 * h) {
                break;
            }
            // So near that two terms of Taylor's series carry the rest.
            if dt.abs() * self.fastest < 1e-6 {
                let Flow { q, v, .. } = &mut trial.end;
                q.add_times(dt, v);
                q.add_times(0.5 * dt * dt, &trial.rate.v);
                v.add_times(dt, &trial.rate.v);
                trial.end.lost += trial.rate.lost * dt;
                trial.rate = self.field.rate(taken + dt, &trial.end);
                return (taken + dt, trial);
            }
            taken += dt;
        }
        interpolated(&mut self.field)
    }

    /// A boundary is passed, or turns the motion back.
    pub(super) fn pass(&mut self, law: usize, side: Side, recording: &mut Recording<'_, '_>) -> Result<(), Stop> {
        let mut state = self.state();
        if self.settings.events == Events::Located {
            self.field.laws[law].snap(side, &mut state);
        }
        self.set(state);
        // A kink is a boundary of a curve, and no event to people.
        let kink = !self.field.laws[law].pitch.steps_only() && self.field.laws[law].step(side) == 0.0;
        let noting = if kink { &mut None } else { recording };
        self.event(noting, |run| run.jump(law, side, kink))
    }

    /// Passes a boundary, or is turned back by it.
    fn jump(&mut self, law: usize, side: Side, kink: bool) {
        let (equations, mut state) = (self.field.equations, self.state());
        let mut k = self.levels();
        let (laws, bands) = (&mut self.field.laws, &mut self.field.bands);
        if laws.len() > 1 {
            self.counts.ambiguous += u64::from(guard::order_matters(equations, (laws, bands, &k), &state, law, side));
        }
        let passage = match laws[law].switching {
            Switching::WithJump => {
                let dv = law::barrier(equations, (laws, bands, &k), law, side, &state);
                laws[law].surface.pass(&mut state.q_dot, side, dv)
            }
            _ => Passage::Transmitted,
        };
        match passage {
            Passage::Transmitted => {
                self.counts.cell_changes += u64::from(!kink);
                law::enter(laws, law, side, &mut state);
                self.counts.impacts += cells::displace((laws, bands), &mut k, &state);
            }
            Passage::Reflected => self.counts.reflections += 1,
        }
        self.set(state);
        self.field.enter();
        self.rate = self.field.rate(0.0, &self.y);
    }

    /// Takes the boundaries that phases were found to have passed in the step, where they are found.
    pub(super) fn catch_up(&mut self, recording: &mut Recording<'_, '_>) -> Result<(), Stop> {
        for law in 0..self.field.laws.len() {
            for side in [Side::Upper, Side::Lower] {
                loop {
                    let laws = &self.field.laws[law];
                    if laws.switching == Switching::Never || laws.next_switch().is_some() {
                        break;
                    }
                    let (lower, upper) = laws.bounds();
                    let bound = if side == Side::Upper { upper } else { lower };
                    let over = self.y.q[laws.phase] - bound;
                    if side.sign() * over < 0.0 || side.sign() * self.y.v[laws.phase] <= 0.0 {
                        break;
                    }
                    let (phase, before) = (laws.phase, self.counts.reflections);
                    self.pass(law, side, recording)?;
                    // Entering puts the phase on the boundary; such programs leave it where it is.
                    if self.counts.reflections == before {
                        let (lower, upper) = self.field.laws[law].bounds();
                        self.y.q[phase] = over + if side == Side::Upper { lower } else { upper };
                        self.rate = self.field.rate(0.0, &self.y);
                    }
                }
            }
        }
        self.catch_up_with_flanks(recording)
    }

    /// Meets the steps that a phase has just come to as the run ends, so that a run split there equals the whole.
    pub(super) fn meet_at_the_end(&mut self, recording: &mut Recording<'_, '_>) -> Result<(), Stop> {
        for i in 0..self.field.laws.len() {
            let law = &self.field.laws[i];
            let v = law.surface.normal.dot(&self.y.v);
            let side = if v > 0.0 { Side::Upper } else { Side::Lower };
            let slack = v.abs() * 0.5 * (self.t_end.next_up() - self.t_end) + 2.0 * law.rounding();
            if v != 0.0 && law.is_at(side, &self.state(), slack) {
                self.pass(i, side, recording)?;
            }
        }
        Ok(())
    }
}
