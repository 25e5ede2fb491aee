//! The hybrid loop: solve, locate, propagate, record, jump. These are the six steps of Oh, Grosh & Barber (2005), for any number of
//! coordinates, of stiffnesses and of levels per pitch, both directions of rotation, and any [`Solver`].

use crate::engine::cascade::Cascade;
use crate::engine::cells::Cells;
use crate::engine::compensated::{Compensated, Given};
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::{Refusal, Stop};
use crate::engine::exact::Exact;
use crate::engine::forcing::Forcing;
use crate::engine::hybrid::Hybrid;
use crate::engine::lanes::alone::Alone;
use crate::engine::law::{self, LawState};
use crate::engine::motion::{Effort, End, Solver};
use crate::engine::record::{Recorder, State};
use crate::engine::start::{self, Initial};
use crate::engine::switch::Switch;
use crate::engine::vector::Vector;
use crate::scene::Scene;
use crate::trajectory::Moment;

mod events;
mod late;
mod locate;
mod parting;
mod plain;
mod recording;

pub use recording::Recording;

/// A simulation under way.
pub struct Simulation<'a> {
    /// The state: continuous, discrete, and the energy account.
    pub now: Hybrid<'a>,
    /// The solver for the motion between two events.
    solver: Box<dyn Solver + 'a>,
    /// Whether the solver has entered the present mode. The kernel of plain events does not need the solver.
    entered: bool,
    /// The detection of events at ever shorter intervals.
    cascade: Cascade,
    /// The kernel of plain events, once it was asked for; `None` where no event is plain.
    kernel: Option<Option<Box<dyn Alone>>>,
}

impl<'a> Simulation<'a> {
    /// Prepares a scene with constant torques for the exact solver: its cells, its start.
    ///
    /// # Errors
    /// If the scene cannot be simulated.
    pub fn new(equations: &'a dyn Equations, scene: &Scene) -> Result<Self, Refusal> {
        match scene.varying() {
            Some(torques) => Err(Refusal::Varying { torques }),
            None => Self::exact(equations, scene, start::begin(equations, scene)?, None),
        }
    }

    /// Prepares a scene for the exact solver, from a known start and with torques that vary in time.
    ///
    /// # Errors
    /// Those of [`Simulation::new`].
    pub fn exact(
        equations: &'a dyn Equations,
        scene: &Scene,
        begun: Initial,
        forcing: Option<Forcing>,
    ) -> Result<Self, Refusal> {
        let now = Hybrid::new(equations, scene, begun, forcing);
        let solver = Exact::new(scene, &now)?;
        Self::with(now, Box::new(solver))
    }

    /// Begins a run in the state `now`, by a solver.
    ///
    /// # Errors
    /// If the solver cannot solve the first mode.
    pub fn with(mut now: Hybrid<'a>, mut solver: Box<dyn Solver + 'a>) -> Result<Self, Refusal> {
        now.release = solver.release();
        if now.is_stuck() {
            now.hold(vec![])?;
        }
        solver.enter(&mut now)?;
        Ok(Simulation { now, solver, entered: true, cascade: Cascade::default(), kernel: None })
    }

    /// The same simulation with state and time in double-double precision. `given` provides its cells.
    ///
    /// # Errors
    /// If its cells cannot be solved in double-double precision.
    pub fn compensate(mut self, given: Given<'a>) -> Result<Self, Refusal> {
        self.solver = Box::new(Compensated::new(given, self.solver, &mut self.now)?);
        Ok(self)
    }

    /// Runs to the end. `recorder` comes with the sampling rate \[1/s\], and whether it records the limits at every event. `watch` is
    /// called with the time \[s\] after events. Many plain events that are passed together are followed by one call.
    ///
    /// # Errors
    /// If the run cannot continue. `recorder` has the rows up to that time.
    pub fn run(
        &mut self,
        recorder: Option<(&mut Recorder<'_>, f64, bool)>,
        watch: &mut dyn FnMut(f64),
    ) -> Result<(), Stop> {
        let mut recording = recorder.map(|(recorder, rate, events)| Recording::new(recorder, rate, events));
        while !self.go_on(&mut recording)? {
            watch(self.now.clock.now());
            if let Some(recording) = &mut recording {
                recording.allow()?;
            }
        }
        Ok(())
    }

    /// Goes on to the next event. Passes many events if they are plain and not recorded. Returns whether the run is over.
    #[inline]
    fn go_on(&mut self, recording: &mut Option<Recording<'_, '_>>) -> Result<bool, Stop> {
        if self.is_plain() && self.pass_all_plain(recording) {
            return Ok(false);
        }
        self.step_in_general(recording)
    }

    /// Goes on to the next event, or to the end of the run. Returns whether the run is over.
    ///
    /// # Errors
    /// Those of [`Simulation::run`].
    #[inline]
    pub fn step(&mut self, recording: &mut Option<Recording<'_, '_>>) -> Result<bool, Stop> {
        if self.is_plain() && self.pass_plain(recording) {
            return Ok(false);
        }
        self.step_in_general(recording)
    }

    /// The same without the kernel of plain events: one turn of the hybrid loop.
    ///
    /// # Errors
    /// Those of [`Simulation::run`].
    pub(crate) fn step_in_general(&mut self, recording: &mut Option<Recording<'_, '_>>) -> Result<bool, Stop> {
        if !self.entered {
            self.change_mode()?;
        }
        let (now, mut cost) = (&self.now, self.now.counts.cost);
        // Solve: the motion in this mode.
        let horizon = locate::horizon(now);
        let mut motion = self.solver.solve(now, horizon.0)?;
        // Locate: when and how the motion ends.
        let (t, end) = locate::first(now, &mut *motion, horizon, &mut cost)?;
        // Propagate: the state at t.
        let (t, reached) = motion.arrive(t, end, &mut cost);
        // Record: the samples until t.
        if let Some(recording) = recording {
            recording.samples(now, &mut *motion, t.hi());
        }
        let parted = parting::parted(now, &mut *motion, (t.hi(), &reached.state));
        drop(motion);
        parted.into_iter().for_each(|switch| self.now.switches[switch].parted = true);
        self.now.take(t, reached);
        self.now.counts.cost = cost;
        self.now.require_finite()?;
        // Jump: through the step, or back from it.
        self.finish(end, recording)
    }

    /// Handles the end of a motion. Returns whether the run is over.
    #[inline]
    fn finish(&mut self, end: End, recording: &mut Option<Recording<'_, '_>>) -> Result<bool, Stop> {
        match end {
            End::Open | End::Run if !self.solver.locates() => self.catch_up(recording)?,
            _ => {}
        }
        match end {
            End::Open => Ok(false),
            End::Run => {
                self.now.clock.set(self.now.t_end);
                self.meet_at_the_end(recording)?;
                if let Some(recording) = recording {
                    recording.note(&self.now, Moment::Sample);
                }
                Ok(true)
            }
            _ => {
                self.pass(end, recording)?;
                self.cascade.require_progress(&self.now, self.solver.rate())?;
                Ok(false)
            }
        }
    }

    /// Sets the cell of the only law to the one that the kernel has reached.
    #[inline]
    pub(crate) fn stand_in(&mut self, cell: usize) {
        self.now.laws[0].cell = cell;
        self.now.k[0] = self.now.laws[0].level();
        self.entered = false;
    }

    /// Goes on from the state of another run of the scene: its coordinates and speeds, laws and switches.
    ///
    /// # Errors
    /// If the modes of the cell cannot be computed.
    pub fn go_on_from(&mut self, state: State, laws: Vec<LawState>, switches: Vec<Switch>) -> Result<(), Stop> {
        (self.now.state, self.now.laws, self.now.switches) = (state, laws, switches);
        self.now.set_levels();
        if self.now.is_stuck() { self.hold(vec![]) } else { self.change_mode() }
    }

    /// Updates the law values and the solver after a change of laws or switches.
    #[inline]
    fn change_mode(&mut self) -> Result<(), Stop> {
        self.now.set_levels();
        self.entered = true;
        self.solver.enter(&mut self.now).map_err(|reason| self.no_modes(reason))
    }

    #[cold]
    fn no_modes(&self, reason: Refusal) -> Stop {
        let Hybrid { clock, state, .. } = &self.now;
        Stop::Cell { t: clock.now(), state: state.describe(), cell: self.now.cell(), reason }
    }

    /// Its equations.
    pub fn equations(&self) -> &'a dyn Equations {
        self.now.equations
    }

    /// Its linear cells, if it has them in plain precision.
    pub fn cells(&self) -> Option<&Cells> {
        self.solver.cells()
    }

    /// Step counts of a method by steps.
    pub fn effort(&self) -> Effort {
        self.solver.effort()
    }

    /// Whether the next event may be plain: there is one law, its phase rolls with the motion, and there are no switches, no
    /// held phases and no torques that vary. The kernel decides whether it is.
    pub fn is_plain(&self) -> bool {
        let rolls =
            |law: &LawState| law.turn() > 0.0 && law.switching != Switching::Never && law.next_switch().is_none();
        let Hybrid { laws, switches, contact, forcing, .. } = &self.now;
        matches!(&laws[..], [law] if rolls(law)) && switches.is_empty() && contact.is_none() && forcing.is_none()
    }

    /// Length of one turn of each coordinate (n): the pitch if the coordinate rolls, otherwise 0.
    pub fn turn_lengths(&self) -> Vector {
        law::turn_lengths(self.now.state.q.len(), &self.now.laws)
    }
}
