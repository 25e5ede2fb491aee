//! Ensembles: many simulations of one model side by side, eight to a processor core, one a lane.
//!
//! A simulation whose next event is plain (its phase monotone for certain, the step passed, before the end of its run) takes
//! it in a lane; any other event it takes by itself, in the scalar engine, and comes back. So it goes through the same events
//! as alone, with the same guarantee, to states that differ from those of the scalar engine by roundings only. Whatever its
//! neighbours, its result is the same to the last bit.
//!
//! `pulp` picks the instructions that the processor has.

#[cfg(test)]
mod tests;

use pulp::{Arch, NullaryFnOnce};

use crate::engine::Stop;
use crate::engine::lanes::kind::Kind;
use crate::engine::lanes::pack::Mask;
use crate::engine::lanes::{LARGEST, Lanes};
use crate::engine::simulate::Simulation;

/// Simulations side by side on a processor core: what its vectors hold.
const LANES: usize = 8;

/// Runs simulations to their ends, unrecorded.
///
/// # Errors
/// For each, why it could not go on.
pub fn run(simulations: &mut [Simulation<'_>]) -> Vec<Result<(), Stop>> {
    let kinds: Vec<_> = simulations.iter().map(Kind::of).collect();
    let mut results = vec![Ok(()); simulations.len()];
    let mut ensemble = Ensemble { results: &mut results, simulations };
    let mut done: Vec<&Option<Kind>> = vec![];
    for kind in &kinds {
        if !done.contains(&kind) {
            done.push(kind);
            let members: Vec<usize> = (0..kinds.len()).filter(|i| kinds[*i] == *kind).collect();
            match kind {
                // One by itself goes the same way, to the same bits, without seven empty lanes.
                Some(kind) if members.len() == 1 => ensemble.of_size::<1>(kind, &members),
                Some(kind) => ensemble.of_size::<LANES>(kind, &members),
                None => members.into_iter().for_each(|which| while !ensemble.step(which) {}),
            }
        }
    }
    results
}

/// Simulations, and what has become of them.
struct Ensemble<'s, 'a> {
    simulations: &'s mut [Simulation<'a>],
    results: &'s mut [Result<(), Stop>],
}

impl Ensemble<'_, '_> {
    /// Runs the `members` of one kind in lanes compiled for at least as many coordinates.
    fn of_size<const L: usize>(&mut self, kind: &Kind, members: &[usize]) {
        match kind.rigid.len() {
            0..=2 => self.side_by_side::<2, L>(kind, members),
            3..=4 => self.side_by_side::<4, L>(kind, members),
            _ => self.side_by_side::<LARGEST, L>(kind, members),
        }
    }

    /// Runs the `members` of one kind in lanes.
    fn side_by_side<const N: usize, const L: usize>(&mut self, kind: &Kind, members: &[usize]) {
        let mut lanes = Lanes::<N, L>::new(kind);
        let mut members = members.iter().copied();
        let mut held = [None; L];
        let mut waiting = Mask::of(|_| true);
        let mut left = waiting;
        loop {
            for lane in (0..L).filter(|lane| left.is_set(*lane)) {
                if let Some(which) = held[lane].take() {
                    lanes.unload(lane, &mut self.simulations[which]);
                    // The kernel has just left this event to the general loop.
                    let simulation: &mut Simulation<'_> = &mut self.simulations[which];
                    let step = simulation.step_in_general(&mut None, &mut 0);
                    if !self.is_over(which, step) && self.ready(which) {
                        lanes.load(lane, &self.simulations[which], false);
                        held[lane] = Some(which);
                    }
                }
                while held[lane].is_none()
                    && let Some(which) = members.next()
                {
                    if self.ready(which) {
                        lanes.load(lane, &self.simulations[which], true);
                        held[lane] = Some(which);
                    }
                }
            }
            waiting = waiting.with(left);
            let active = Mask::of(|lane| held[lane].is_some());
            if active == Mask::of(|_| false) {
                return;
            }
            let job = Advance { lanes: &mut lanes, active: active.without(waiting), waiting: active.and(waiting) };
            (left, waiting) = Arch::new().dispatch(job);
        }
    }

    /// Takes a simulation to the beginning of a pitch, where it can join the others, or to its end, or at least to where its next event
    /// could be a plain one; tells whether it goes on from there. Also where there are no others: a simulation must take the same way to
    /// the same bits with any neighbours.
    fn ready(&mut self, which: usize) -> bool {
        let mut patience = self.simulations[which].laws[0].pitch.cells();
        loop {
            let simulation = &self.simulations[which];
            if simulation.is_plain() && (patience == 0 || simulation.laws[0].cell == 0) {
                return true;
            }
            patience = patience.saturating_sub(1);
            if self.step(which) {
                return false;
            }
        }
    }

    /// One event of a simulation; tells whether it has come to its end.
    fn step(&mut self, which: usize) -> bool {
        let step = self.simulations[which].step(&mut None, &mut 0);
        self.is_over(which, step)
    }

    /// Whether a simulation has come to its end with a step, by itself or for a reason, which is noted.
    fn is_over(&mut self, which: usize, step: Result<bool, Stop>) -> bool {
        step.unwrap_or_else(|stop| {
            self.results[which] = Err(stop);
            true
        })
    }
}

/// Goes on in all lanes until one of the `active` cannot. Lanes that are `waiting` join when the others begin a pitch, too, so
/// that all are in one cell.
struct Advance<'l, const N: usize, const L: usize> {
    lanes: &'l mut Lanes<N, L>,
    active: Mask<L>,
    waiting: Mask<L>,
}

impl<const N: usize, const L: usize> NullaryFnOnce for Advance<'_, N, L> {
    /// Lanes that could not go on, and those that still wait.
    type Output = (Mask<L>, Mask<L>);

    #[inline(always)]
    fn call(self) -> (Mask<L>, Mask<L>) {
        let Advance { lanes, mut active, mut waiting } = self;
        let mut waited = 0;
        loop {
            let leader = (0..L).find(|lane| active.is_set(*lane));
            if leader.is_none_or(|leader| lanes.at[leader] == 0) || waited >= lanes.tables.len() {
                active = active.with(waiting);
                waiting = waiting.without(waiting);
            }
            waited += 1;
            let passed = lanes.pass(active);
            if !passed.covers(active) {
                return (active.without(passed), waiting);
            }
        }
    }
}
