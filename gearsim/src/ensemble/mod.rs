//! Ensembles: many simulations of one model side by side, eight on a processor core, one per lane.
//!
//! If the next event of a simulation is plain, as defined in [`lanes`](crate::engine::lanes), the kernel handles it in a lane. The general
//! loop handles every other event; afterwards the simulation returns to its lane. The events are those of a single run, with the same
//! guarantee; the states differ from it by rounding errors only. The result of a simulation does not depend on the other lanes, to the last
//! bit.
//!
//! On a processor without the vector instructions for which the kernel is compiled, the general loop handles each event.

#[cfg(test)]
mod tests;

use pulp::NullaryFnOnce;

use crate::engine::Stop;
use crate::engine::lanes::kind::Kind;
use crate::engine::lanes::pack::Mask;
use crate::engine::lanes::{LARGEST, Lanes};
use crate::engine::simulate::Simulation;

/// Number of simulations side by side on a processor core: as many as its vectors have numbers.
const LANES: usize = 8;

/// Runs simulations to their ends, without recording.
///
/// # Errors
/// For each simulation that stopped early: the reason.
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
                // A single simulation takes the same path, with the same bits, without seven empty lanes.
                Some(kind) if members.len() == 1 => ensemble.of_size::<1>(kind, &members),
                Some(kind) => ensemble.of_size::<LANES>(kind, &members),
                None => members.into_iter().for_each(|which| while !ensemble.step(which) {}),
            }
        }
    }
    results
}

/// The simulations and their results.
struct Ensemble<'s, 'a> {
    simulations: &'s mut [Simulation<'a>],
    results: &'s mut [Result<(), Stop>],
}

impl Ensemble<'_, '_> {
    /// Runs the `members`, which are of one kind, in lanes compiled for at least their number of coordinates.
    fn of_size<const L: usize>(&mut self, kind: &Kind, members: &[usize]) {
        match kind.rigid.len() {
            0..=2 => self.side_by_side::<2, L>(kind, members),
            3..=4 => self.side_by_side::<4, L>(kind, members),
            _ => self.side_by_side::<LARGEST, L>(kind, members),
        }
    }

    /// Runs the `members`, which are of one kind, in lanes.
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
                    let step = simulation.step_in_general(&mut None);
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
            (left, waiting) = kind.vectors.run(job);
        }
    }

    /// Advances a simulation by the general loop until its next event may be plain and its phase is at the beginning of a pitch, where it
    /// can join the others. After as many events as a pitch has cells it need not be at the beginning of a pitch. Returns whether the run
    /// continues. This is also done without other simulations: the result of a simulation must not depend on the others, to the last bit.
    fn ready(&mut self, which: usize) -> bool {
        let mut events_left = self.simulations[which].now.laws[0].pitch.cells();
        loop {
            let simulation = &self.simulations[which];
            if simulation.is_plain() && (events_left == 0 || simulation.now.laws[0].cell == 0) {
                return true;
            }
            events_left = events_left.saturating_sub(1);
            if self.step(which) {
                return false;
            }
        }
    }

    /// Takes one event of a simulation; returns whether its run has ended.
    fn step(&mut self, which: usize) -> bool {
        let step = self.simulations[which].step(&mut None);
        self.is_over(which, step)
    }

    /// Whether the run of a simulation has ended with this step: at its end time, or with an error. The error is stored.
    fn is_over(&mut self, which: usize, step: Result<bool, Stop>) -> bool {
        step.unwrap_or_else(|stop| {
            self.results[which] = Err(stop);
            true
        })
    }
}

/// Advances all `active` lanes until one of them cannot continue. Lanes that are `waiting` join when the others begin a pitch, so
/// that all are in the same cell.
struct Advance<'l, const N: usize, const L: usize> {
    lanes: &'l mut Lanes<N, L>,
    active: Mask<L>,
    waiting: Mask<L>,
}

impl<const N: usize, const L: usize> NullaryFnOnce for Advance<'_, N, L> {
    /// The lanes that cannot continue, and the lanes that still wait.
    type Output = (Mask<L>, Mask<L>);

    #[inline(always)]
    fn call(self) -> (Mask<L>, Mask<L>) {
        let Advance { lanes, mut active, mut waiting } = self;
        if L == 1 {
            // A single lane does not wait for others. Its mask is constant, so the compiler omits the selections by masks.
            let all = Mask::of(|_| true);
            while lanes.pass(all).is_all() {}
            return (all, Mask::of(|_| false));
        }
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
