//! Transfer of simulations into lanes and back.

use xprec::Df64;

use crate::engine::equations::Switching;
use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::expected::Expected;
use crate::engine::lanes::kind::Kind;
use crate::engine::lanes::pack::Pack;
use crate::engine::simulate::Simulation;

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// Empty lanes for simulations of one kind, with at most N coordinates.
    pub fn new(kind: &Kind) -> Self {
        let zero = Pack::all(0.0);
        let Kind { places, phase, ref rigid, .. } = *kind;
        // Modes beyond those of the model stay at rest.
        let rigid = std::array::from_fn(|i| rigid.get(i).copied().unwrap_or(true));
        Lanes {
            tables: vec![Cells::empty(); places],
            rigid,
            phase,
            compliance: zero,
            direction: [zero; N],
            q: [zero; N],
            q_dot: [zero; N],
            lost: [zero; N],
            clock: [zero; 2],
            end: zero,
            dissipated: zero,
            at: [0; L],
            turns: [0; L],
            long: false,
            changes: [0; L],
            reflections: [0; L],
            expected: vec![Expected::NOTHING; places],
        }
    }

    /// Loads a simulation into a lane. Its cells are loaded only if it is `new` in the lane.
    pub fn load(&mut self, lane: usize, simulation: &Simulation<'_>, new: bool) {
        let law = &simulation.now.laws[0];
        if new {
            let mut k = simulation.now.k[..].to_vec();
            let mut stiffness = |place| {
                k[0] = law.pitch.level(place);
                simulation.equations().stiffness(&k)
            };
            let stiffness: Vec<_> = (0..self.tables.len()).map(&mut stiffness).collect();
            self.tables
                .iter_mut()
                .enumerate()
                .for_each(|(place, table)| table.fill(lane, simulation, place, &stiffness));
            self.expected.iter_mut().for_each(|expected| expected.forget(lane));
            self.long |= law.pitch.pitches() > 1;
            let impulse = law.switching == Switching::WithJump;
            self.compliance.0[lane] = if impulse { law.surface.compliance } else { 0.0 };
            (0..simulation.now.state.q.len()).for_each(|i| self.direction[i].0[lane] = law.surface.direction[i]);
        }
        for i in 0..simulation.now.state.q.len() {
            self.q[i].0[lane] = simulation.now.state.q[i];
            self.q_dot[i].0[lane] = simulation.now.state.q_dot[i];
            self.lost[i].0[lane] = simulation.now.state.lost[i];
        }
        (self.clock[0].0[lane], self.clock[1].0[lane]) = (simulation.now.clock.0.hi(), simulation.now.clock.0.lo());
        self.end.0[lane] = simulation.now.t_end;
        self.dissipated.0[lane] = simulation.now.dissipated;
        (self.at[lane], self.turns[lane]) = (law.cell, 0);
        (self.changes[lane], self.reflections[lane]) = (0, 0);
    }

    /// Writes the state of a lane back to its simulation.
    pub fn unload(&self, lane: usize, simulation: &mut Simulation<'_>) {
        for i in 0..simulation.now.state.q.len() {
            simulation.now.state.q[i] = self.q[i].0[lane];
            simulation.now.state.q_dot[i] = self.q_dot[i].0[lane];
            simulation.now.state.lost[i] = self.lost[i].0[lane];
        }
        simulation.now.state.turns[self.phase] += self.turns[lane];
        simulation.stand_in(self.at[lane]);
        simulation.now.clock.0 = Df64::new_full(self.clock[0].0[lane], self.clock[1].0[lane]);
        simulation.now.dissipated = self.dissipated.0[lane];
        simulation.now.counts.cell_changes += self.changes[lane];
        simulation.now.counts.reflections += self.reflections[lane];
    }
}
