//! Modes of the switches of a run.

use crate::engine::equations::Affine;
use crate::engine::switch;

use super::Hybrid;

impl Hybrid<'_> {
    /// Sets the mode of a switch, then follows its exits until the state violates no guard. `crossed` is the guard that has just become
    /// zero.
    pub fn put(&mut self, switch: usize, mode: usize, crossed: Option<&Affine>) {
        let place = &mut self.switches[switch];
        let before = std::mem::replace(&mut place.mode, mode);
        place.write(&mut self.k);
        let state = (&self.state.q[..], &self.state.q_dot[..]);
        switch::settle(place, self.equations, state, &mut self.k, crossed);
        self.counts.impacts += u64::from(place.count(before));
        place.leave(before, self.clock.now());
    }

    /// Puts every switch into the mode that the state admits, after a sudden change.
    pub fn settle(&mut self) {
        (0..self.switches.len()).for_each(|i| self.put(i, self.switches[i].mode, None));
    }

    /// Sets the mode of a switch without comparing its guards with the state.
    pub fn set_mode(&mut self, switch: usize, mode: usize) {
        let place = &mut self.switches[switch];
        let before = std::mem::replace(&mut place.mode, mode);
        place.write(&mut self.k);
        place.leave(before, self.clock.now());
    }
}
