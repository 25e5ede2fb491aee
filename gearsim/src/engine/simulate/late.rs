//! Events handled after the step in which they happened, as in programs that do not locate events; for comparison.

use crate::engine::crossing::Side;
use crate::engine::error::Stop;
use crate::engine::motion::End;
use crate::engine::simulate::{Recording, Simulation};
use crate::engine::switch;

impl Simulation<'_> {
    /// Handles the events that have happened by now.
    pub(super) fn catch_up(&mut self, recording: &mut Option<Recording<'_, '_>>) -> Result<(), Stop> {
        for law in 0..self.now.laws.len() {
            for side in [Side::Upper, Side::Lower] {
                while self.pass_late(law, side, recording)? {}
            }
        }
        for switch in 0..self.now.switches.len() {
            let mut after = self.now.switches[switch].clone();
            let (state, mut k) = (&self.now.state, self.now.k.clone());
            if switch::settle(&mut after, self.now.equations, (&state.q, &state.q_dot), &mut k, None) {
                self.pass(End::Loose(switch, after.mode), recording)?;
            }
        }
        Ok(())
    }

    /// Passes the boundary of a law at a side, if the phase is beyond it. The phase stays where it is, as such programs leave it.
    fn pass_late(&mut self, law: usize, side: Side, recording: &mut Option<Recording<'_, '_>>) -> Result<bool, Stop> {
        if !self.now.watches(law) {
            return Ok(false);
        }
        let here = &self.now.laws[law];
        let (phase, speed) = (here.phase, side.sign() * here.surface.normal.dot(&self.now.state.q_dot));
        let over = self.now.state.q[phase] - here.boundary(side);
        if side.sign() * over < 0.0 || speed <= 0.0 {
            return Ok(false);
        }
        let before = self.now.counts.reflections;
        self.pass(End::Step(law, side), recording)?;
        if self.now.counts.reflections == before {
            let entered = self.now.laws[law].boundary(side.opposite());
            self.now.state.put(phase, entered + over);
        }
        Ok(true)
    }
}
