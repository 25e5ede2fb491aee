//! What happens where a flight ends: steps are passed or turn the motion back, phases are held, flanks meet.

use crate::engine::cells::{self, Banded, Stand};
use crate::engine::contact::{self, Contact, Ending};
use crate::engine::crossing::Side;
use crate::engine::dead_band::{DeadBand, Regime};
use crate::engine::equations::Switching;
use crate::engine::error::Stop;
use crate::engine::guard;
use crate::engine::jump::Passage;
use crate::engine::law;
use crate::engine::record::Recorder;
use crate::trajectory::Moment;

use super::{End, Simulation};

impl Simulation<'_> {
    /// Meets the steps that a phase has just come to as the run ends, so that a run split there equals the whole.
    pub(super) fn meet_at_the_end(
        &mut self,
        recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>,
    ) -> Result<(), Stop> {
        for i in 0..self.laws.len() {
            let v = self.laws[i].surface.normal.dot(&self.state.q_dot);
            let side = if v > 0.0 { Side::Upper } else { Side::Lower };
            let held = self.contact.as_ref().is_some_and(|c| c.holds(i));
            // A time of an event, as a number, is half a unit of its last place off; so far the phase goes in it.
            let slack = v.abs() * 0.5 * (self.t_end.next_up() - self.t_end) + 2.0 * self.laws[i].rounding();
            if v != 0.0 && !held && self.laws[i].is_at(side, &self.state, slack) {
                self.pass(End::Step(i, side), recorder)?;
                self.demand_numbers()?;
            }
        }
        Ok(())
    }

    /// An event, its left and right limits noted.
    #[inline(always)]
    pub(super) fn pass(&mut self, end: End, recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>) -> Result<(), Stop> {
        self.arrive(end);
        if end == End::Break {
            return self.act(end);
        }
        let Some((recorder, _, true)) = recorder else { return self.act(end) };
        self.note(recorder, Moment::Before);
        self.act(end)?;
        self.note(recorder, Moment::After);
        Ok(())
    }

    /// Puts the phase that met a step exactly on it.
    #[inline]
    pub(super) fn arrive(&mut self, end: End) {
        if let End::Step(law, side) = end {
            self.laws[law].snap(side, &mut self.state);
            self.place(law);
        }
    }

    /// Has the state in twice the digits follow the plain one, whose phase has been put on a boundary.
    #[inline]
    pub(super) fn place(&mut self, law: usize) {
        if let Some(compensated) = &mut self.compensated
            && self.laws[law].next_switch().is_none()
        {
            compensated.place(law, &self.state);
        }
    }

    /// What happens at an event.
    #[inline]
    pub(super) fn act(&mut self, end: End) -> Result<(), Stop> {
        match end {
            End::Step(law, side) => {
                if self.laws.len() > 1 {
                    let ambiguous = guard::order_matters(self.equations, self.stand(), &self.state, law, side);
                    self.counts.ambiguous += u64::from(ambiguous);
                }
                // An impulse ends what is held, which bounces or leaves.
                self.contact = None;
                self.jump(law, side)
            }
            End::Hold(law, ending) => {
                let mut held = self.contact.take().map_or(vec![], |contact| contact.laws);
                let side = held.iter().find(|l| l.0 == law).map_or(Side::Upper, |l| l.1);
                held.retain(|l| l.0 != law);
                if ending == Ending::Slip {
                    self.enter(law, side)?;
                }
                self.hold(held)
            }
            End::Flank(band, regime) => {
                let free = |regime| regime == Regime::Free;
                self.counts.impacts += u64::from(free(self.bands[band].regime) && !free(regime));
                self.bands[band].regime = regime;
                let now = self.clock.now();
                self.rattle = if now == self.rattle.0 { (now, self.rattle.1 + 1) } else { (now, 0) };
                self.change_cell()?;
                // What is held now presses otherwise, or against nothing.
                let held = self.contact.take().map_or(vec![], |contact| contact.laws);
                let void = |held: &(usize, Side)| contact::is_void(self.equations, self.stand(), *held, &self.state);
                let (void, held): (Vec<_>, Vec<_>) = held.into_iter().partition(void);
                void.into_iter().try_for_each(|(law, side)| self.enter(law, side))?;
                self.hold(held)
            }
            End::Break => self.enter_course(),
            End::Run => Ok(()),
        }
    }

    /// Where laws and dead bands stand.
    #[inline]
    fn stand(&self) -> Stand<'_> {
        (&self.laws, &self.bands, &self.k)
    }

    /// Passes a step, or is turned back by it.
    #[inline]
    fn jump(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let passage = match self.laws[law].switching {
            Switching::WithJump => match &mut self.compensated {
                None => {
                    let dv = law::barrier(self.equations, self.stand(), law, side, &self.state);
                    let (passage, gained) = self.laws[law].surface.jump(&self.state.q_dot, side, dv);
                    self.state.gain(&gained);
                    passage
                }
                Some(compensated) => {
                    let met = law::met(&self.laws, law, side, &self.state);
                    let passage = compensated.pass(law, side, met.map(|i| (i, self.laws[i].exact_step(side))));
                    compensated.round(&mut self.state);
                    passage
                }
            },
            _ => Passage::Transmitted,
        };
        if passage == Passage::Transmitted {
            return self.enter(law, side);
        }
        self.counts.reflections += 1;
        self.grip()?;
        self.press(law, side)
    }

    /// Goes on into the cell beyond.
    #[inline]
    fn enter(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        self.counts.cell_changes += 1;
        match &mut self.laws[..] {
            [only] => {
                only.enter(side, &mut self.state);
            }
            laws => law::enter(laws, law, side, &mut self.state),
        }
        if !self.bands.is_empty() {
            self.counts.impacts += cells::displace((&self.laws, &mut self.bands), &mut self.k, &self.state);
        }
        self.place(law);
        self.change_cell()?;
        self.grip()
    }

    /// Has the dampers of contacts follow a step of the forces.
    #[inline]
    pub(super) fn grip(&mut self) -> Result<(), Stop> {
        if self.bands.is_empty() {
            return Ok(());
        }
        let here = self.cells.here();
        let gripped =
            |(band, banded): (&DeadBand, &Banded)| band.gripped(banded.elastic, &self.state.q, &self.state.q_dot);
        let regimes: Vec<Regime> = self.bands.iter().zip(&here.bands).map(gripped).collect();
        if self.bands.iter().zip(&regimes).all(|(band, regime)| band.regime == *regime) {
            return Ok(());
        }
        self.bands.iter_mut().zip(regimes).for_each(|(band, regime)| band.regime = regime);
        self.change_cell()
    }

    /// Holds a phase that was just turned back, if it is pressed against the step and its bounces no longer count.
    fn press(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let (q, v, k) = (&self.state.q, &self.state.q_dot, &self.k);
        let energy = self.equations.kinetic(v) + self.equations.potential(q, k);
        let mut acceleration = self.equations.acceleration(q, v, k, &vec![0.0; self.laws.len()]);
        if self.forcing.is_some() {
            acceleration += &self.further_acceleration();
        }
        let rate = self.cells.here().cell.rate;
        if !contact::presses(&self.laws[law], side, &self.state, &acceleration, rate, energy) {
            return Ok(());
        }
        self.counts.holds += 1;
        self.hold(vec![(law, side)])
    }

    /// Holds phases at their steps, those of them that press.
    pub(super) fn hold(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        let further = self.further_load();
        let stand = (&self.laws[..], &self.bands[..], &self.k[..]);
        let begun = Contact::begin(self.equations, stand, held, &mut self.state, &further);
        let (contact, ignored) = begun.map_err(|reason| Stop::Held {
            t: self.clock.now(),
            state: self.state.describe(),
            cell: self.cell(),
            reason,
        })?;
        self.contact = contact.map(Box::new);
        if let Some(compensated) = &mut self.compensated {
            compensated.set(&self.state);
        }
        self.ignored += ignored;
        Ok(())
    }
}
