//! Handling of events: steps are passed or reflect the motion, phases are held, switches change their modes.

use crate::engine::cells::Stand;
use crate::engine::contact::{self, Ending};
use crate::engine::crossing::Side;
use crate::engine::equations::Switching;
use crate::engine::error::Stop;
use crate::engine::jump::Passage;
use crate::engine::law::{self, LawState};
use crate::engine::motion::End;
use crate::engine::order;
use crate::tolerance::events::END_OF_RUN;
use crate::trajectory::Moment;

use super::{Recording, Simulation, parting};

impl Simulation<'_> {
    /// Passes the steps that a phase reaches just at the end of the run, so that a run split at this time equals the whole run.
    pub(super) fn meet_at_the_end(&mut self, recording: &mut Option<Recording<'_, '_>>) -> Result<(), Stop> {
        for i in 0..self.now.laws.len() {
            let (law, state) = (&self.now.laws[i], &self.now.state);
            let v = law.surface.normal.dot(&state.q_dot);
            let side = if v > 0.0 { Side::Upper } else { Side::Lower };
            // The time of an event has a rounding error of half a unit in the last place. In this time the phase moves by `slack`.
            let slack = v.abs() * 0.5 * (self.now.t_end.next_up() - self.now.t_end) + END_OF_RUN * law.rounding();
            if v != 0.0 && !self.now.holds(i) && law.is_at(side, state, slack) {
                self.pass(End::Step(i, side), recording)?;
                self.now.require_finite()?;
            }
        }
        Ok(())
    }

    /// Handles an event, and records its left and right limits.
    #[inline]
    pub(super) fn pass(&mut self, end: End, recording: &mut Option<Recording<'_, '_>>) -> Result<(), Stop> {
        let mut seen = end != End::Breakpoint;
        if let End::Step(i, side) = end {
            let law = &self.now.laws[i];
            if self.solver.locates() {
                law.snap(side, &mut self.now.state);
            }
            // A kink of a curve is a boundary of a cell, but it is not reported as an event.
            seen = !is_kink(law, side);
        }
        let recorder = recording.as_mut().filter(|_| seen).and_then(Recording::of_events);
        let Some(recorder) = recorder else { return self.act(end) };
        self.now.note(recorder, Moment::Before);
        self.act(end)?;
        self.now.note(recorder, Moment::After);
        Ok(())
    }

    /// Changes the state and the mode at an event.
    #[inline]
    fn act(&mut self, end: End) -> Result<(), Stop> {
        self.now.still();
        match end {
            End::Step(law, side) => {
                self.now.set_surfaces();
                if self.now.laws.len() > 1 {
                    let (equations, state) = (self.now.equations, &self.now.state);
                    let ambiguous = order::matters(equations, self.stand(), state, law, side);
                    self.now.counts.ambiguous += u64::from(ambiguous);
                }
                // An impulse ends all holds: held phases bounce or leave.
                self.now.contact = None;
                self.jump(law, side)
            }
            End::Hold(law, ending) => {
                let mut held = self.now.contact.take().map_or(vec![], |contact| contact.laws);
                let side = held.iter().find(|l| l.0 == law).map_or(Side::Upper, |l| l.1);
                held.retain(|l| l.0 != law);
                if ending == Ending::Slip {
                    self.enter(law, side)?;
                }
                self.resume(held)
            }
            End::Exit(switch, which) => {
                let exit = self.now.guards.exits[switch][which].clone();
                self.now.put(switch, exit.beyond, Some(&exit.guard));
                self.follow_switch()?;
                self.now.counts.sticks += u64::from(self.now.switches[switch].here().held);
                Ok(())
            }
            End::Loose(switch, mode) => {
                self.now.set_mode(switch, mode);
                self.follow_switch()
            }
            End::Breakpoint => {
                if let Some(forcing) = &mut self.now.forcing {
                    let t = forcing.next();
                    self.now.clock.set(t);
                    forcing.enter(t);
                }
                // The new torque may end the holds.
                let held = self.now.contact.take().map_or(vec![], |contact| contact.laws);
                self.resume(held)
            }
            End::Open | End::Run => Ok(()),
        }
    }

    /// The laws, the switches and their values.
    #[inline]
    fn stand(&self) -> Stand<'_> {
        (&self.now.laws, &self.now.switches, &self.now.k)
    }

    /// Passes a step, or is reflected by it.
    #[inline]
    fn jump(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        self.now.set_levels();
        let passage = match self.now.laws[law].switching {
            Switching::WithJump => self.solver.jump(&mut self.now, law, side),
            _ => Passage::Transmitted,
        };
        if passage == Passage::Transmitted {
            return self.enter(law, side);
        }
        self.now.counts.reflections += 1;
        self.resume(vec![])?;
        self.press(law, side)
    }

    /// Goes on into the cell beyond the boundary.
    #[inline]
    fn enter(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let now = &mut self.now;
        now.counts.cell_changes += u64::from(!is_kink(&now.laws[law], side));
        match &mut now.laws[..] {
            [only] => {
                only.enter(side, &mut now.state);
            }
            laws => law::enter(laws, law, side, &mut now.state),
        }
        self.resume(vec![])
    }

    /// Goes on after a switch has changed its mode.
    fn follow_switch(&mut self) -> Result<(), Stop> {
        let (rate, now) = (self.solver.rate(), &mut self.now);
        now.note_change(rate);
        // The contact forces have changed: test every held contact again.
        let held = now.contact.take().map_or(vec![], |contact| contact.laws);
        let void = |held: &(usize, Side)| contact::is_void(self.now.equations, self.stand(), *held, &self.now.state);
        let (void, held): (Vec<_>, Vec<_>) = held.into_iter().partition(void);
        void.into_iter().try_for_each(|(law, side)| self.enter(law, side))?;
        self.proceed(held)
    }

    /// Goes on after a sudden change of the state or of the forces: the switches follow it. Phases of `held` stay held, if they press.
    #[inline]
    fn resume(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        if !self.now.switches.is_empty() {
            self.now.set_levels();
            self.now.settle();
            parting::forget(&mut self.now);
        }
        self.proceed(held)
    }

    /// Goes on in the present mode, with holds if there are any.
    #[inline]
    fn proceed(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        if held.is_empty() && !self.now.is_stuck() { self.change_mode() } else { self.hold(held) }
    }

    /// Holds a phase that was just reflected, if it is pressed against the step and its bounces are negligible.
    fn press(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let (equations, state, k) = (self.now.equations, &self.now.state, &self.now.k);
        let energy = equations.kinetic(&state.q, &state.q_dot) + equations.potential(&state.q, k);
        let acceleration = &self.now.mobility() * &self.now.force();
        if !contact::presses(&self.now.laws[law], side, state, &acceleration, self.solver.rate(), energy) {
            return Ok(());
        }
        self.now.counts.holds += 1;
        self.hold(vec![(law, side)])
    }

    /// Holds the phases of `held` and the deflections of switches if their reactions admit it.
    pub(super) fn hold(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        self.entered = true;
        let begun = self.now.hold(held).and_then(|()| self.solver.enter(&mut self.now));
        begun.map_err(|reason| {
            let (t, state) = (self.now.clock.now(), self.now.state.describe());
            Stop::Held { t, state, cell: self.now.cell(), reason }
        })
    }
}

/// Whether the curve of a law has only a kink at a boundary of its cell: the value does not step there.
fn is_kink(law: &LawState, side: Side) -> bool {
    !law.pitch.steps_only() && law.step(side) == 0.0
}
