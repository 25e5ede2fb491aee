//! Ensembles: many simulations of one model side by side, eight to a processor core, one a lane.
//!
//! A simulation whose next event is plain (its phase monotone for certain, the step passed, before the end of its run) takes
//! it in a lane; any other event it takes by itself, in the scalar engine, and comes back. So it goes through the same events
//! as alone, with the same guarantee, to states that differ by roundings only, whatever its neighbours do.
//!
//! `pulp` picks the instructions that the processor has.

mod cells;
mod elementary;
mod flight;
mod lanes;
mod pack;
#[cfg(test)]
mod tests;

use pulp::{Arch, NullaryFnOnce};

use crate::engine::Stop;
use crate::engine::simulate::Simulation;
use lanes::Lanes;
use pack::{LANES, Mask};

/// Runs simulations to their ends, unrecorded.
///
/// # Errors
/// For each, why it could not go on.
pub fn run<const N: usize>(simulations: &mut [Simulation<'_, N>]) -> Vec<Result<(), Stop>> {
    let results = vec![Ok(()); simulations.len()];
    let mut ensemble = Ensemble { simulations, results, lanes: None, held: [None; LANES], waiting: 0 };
    (0..LANES).for_each(|lane| ensemble.next(lane));
    while let Some(lanes) = &mut ensemble.lanes
        && ensemble.held.iter().any(Option::is_some)
    {
        let active = Mask::of(|lane| ensemble.held[lane].is_some());
        let passed = Arch::new().dispatch(Advance { lanes, active });
        for lane in (0..LANES).filter(|lane| active.says(*lane) && !passed.says(*lane)) {
            ensemble.by_itself(lane);
        }
    }
    ensemble.results
}

/// Simulations, some of them in lanes.
struct Ensemble<'s, 'a, const N: usize> {
    simulations: &'s mut [Simulation<'a, N>],
    results: Vec<Result<(), Stop>>,
    lanes: Option<Lanes<N>>,
    /// The simulation in each lane.
    held: [Option<usize>; LANES],
    /// The next simulation that has not begun.
    waiting: usize,
}

/// Goes on in all lanes until one of the `active` cannot.
struct Advance<'l, const N: usize> {
    lanes: &'l mut Lanes<N>,
    active: Mask,
}

impl<const N: usize> NullaryFnOnce for Advance<'_, N> {
    type Output = Mask;

    #[inline(always)]
    fn call(self) -> Mask {
        loop {
            let passed = self.lanes.pass();
            if !passed.covers(self.active) {
                return passed;
            }
        }
    }
}

impl<const N: usize> Ensemble<'_, '_, N> {
    /// Puts the next simulation into a lane, if there is one.
    fn next(&mut self, lane: usize) {
        while self.held[lane].is_none() && self.waiting < self.simulations.len() {
            self.waiting += 1;
            self.enter(lane, self.waiting - 1, true);
        }
    }

    /// Has the simulation in a lane take an event by itself, and come back or make room.
    fn by_itself(&mut self, lane: usize) {
        let (Some(lanes), Some(which)) = (&self.lanes, self.held[lane].take()) else { return };
        lanes.unload(lane, &mut self.simulations[which]);
        if !self.step(which) {
            self.enter(lane, which, false);
        }
        self.next(lane);
    }

    /// Puts a simulation into a lane, once its next event could be a plain one and it is in step with the other lanes. It
    /// may come to its end before.
    fn enter(&mut self, lane: usize, which: usize, new: bool) {
        let mut patience = self.simulations[which].laws.first().map_or(0, |law| law.pitch.cells());
        loop {
            let simulation = &self.simulations[which];
            if simulation.is_plain() && (patience == 0 || self.in_step(simulation.laws[0].cell)) {
                let lanes = self.lanes.take().or_else(|| Lanes::new(simulation));
                self.lanes = lanes;
                if let Some(lanes) = self.lanes.as_mut().filter(|lanes| lanes.fits(simulation)) {
                    lanes.load(lane, simulation, new);
                    self.held[lane] = Some(which);
                    return;
                }
            }
            patience = patience.saturating_sub(1);
            if self.step(which) {
                return;
            }
        }
    }

    /// Whether all lanes are in the cell `at`: then none has to be gathered.
    fn in_step(&self, at: usize) -> bool {
        let lanes = self.lanes.iter().flat_map(|lanes| lanes.at.iter().zip(&self.held));
        lanes.filter(|(_, held)| held.is_some()).all(|(other, _)| *other == at)
    }

    /// One event of a simulation; tells whether it has come to its end.
    fn step(&mut self, which: usize) -> bool {
        let step = self.simulations[which].step(&mut None, &mut 0);
        step.unwrap_or_else(|stop| {
            self.results[which] = Err(stop);
            true
        })
    }
}
