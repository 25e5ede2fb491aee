//! The run: solve a cell, locate its end, jump; the six steps of Oh, Grosh & Barber (2005), for any number of
//! coordinates, stiffnesses and levels a pitch, and both directions of rotation.

use xprec::Df64;

use crate::engine::cells::{self, Cells, Prepared};
use crate::engine::clock::Clock;
use crate::engine::compensated::Compensated;
use crate::engine::contact::{Contact, Ending};
use crate::engine::crossing::{Cost, Lateness, Side};
use crate::engine::dead_band::{DeadBand, Regime};
use crate::engine::equations::{Equations, Matrices, Switching};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::guard::Guard;
use crate::engine::lanes::alone::Alone;
use crate::engine::law::{self, Law};
use crate::engine::record::{Recorder, State};
use crate::engine::start::{self, Begun};
use crate::engine::vector::Vector;
use crate::model::Model;
use crate::scene::Scene;
use crate::trajectory::Moment;

mod events;
mod forced;
mod locate;
mod plain;
mod samples;

/// What a run did, besides its trajectory.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counts {
    /// Steps of a stiffness passed.
    pub cell_changes: u64,
    /// Steps at which the motion turned back.
    pub reflections: u64,
    /// Times that a phase was held at a step.
    pub holds: u64,
    /// Times that flanks met across their play.
    pub impacts: u64,
    /// Steps met together whose order changes what comes of them: the result is one of several.
    pub ambiguous: u64,
    /// What the searches for crossings cost.
    pub cost: Cost,
}

impl Counts {
    /// Steps of a stiffness met: passed, or turned back from.
    pub fn events(&self) -> u64 {
        self.cell_changes + self.reflections
    }
}

/// A simulation under way: one scene's equations, cells and state.
pub struct Simulation<'a> {
    equations: &'a dyn Equations,
    cells: Cells,
    guard: Guard,
    /// How late the phase was in each cell of a pitch, when it was last there; of a single law, whose motion repeats itself.
    lateness: Vec<Lateness>,

    /// End of the run [s]. May be set later, and the simulation run on.
    pub t_end: f64,
    /// Time.
    pub clock: Clock,
    /// State.
    pub state: State,
    /// Where the stiffnesses stand. To be set by [`Simulation::go_on_from`] alone.
    pub laws: Vec<Law>,
    /// Where the dead bands stand.
    pub bands: Vec<DeadBand>,
    /// When flanks last met or parted, and how often since without passing time.
    rattle: (f64, u32),
    /// The law values now: of the laws, then touch, edge, damp, clip of each dead band of the model.
    k: Vec<f64>,
    /// Phases held at a step that they cannot climb.
    contact: Option<Box<Contact>>,
    /// The state in twice the digits, if it is carried.
    compensated: Option<Box<Compensated>>,
    /// What varies in time, if anything does.
    forcing: Option<Box<forced::Forced>>,
    /// The kernel of plain events, once it was asked for; `None` where no event is plain.
    kernel: Option<Option<Box<dyn Alone>>>,
    /// Energy lost to damping so far [J].
    pub dissipated: f64,
    /// Energy of bounces that were not followed to their ends, so far [J].
    pub ignored: f64,
    /// What happened so far.
    pub counts: Counts,
}

/// How a flight ends.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    /// A law meets a boundary of its cell.
    Step(usize, Side),
    /// The hold of a law ends.
    Hold(usize, Ending),
    /// A dead band goes over into another regime.
    Flank(usize, Regime),
    /// The course of a torque breaks.
    Break,
    /// The run is over.
    Run,
}

impl<'a> Simulation<'a> {
    /// Prepares a scene with constant torques: its cells, its start.
    ///
    /// # Errors
    /// Where the numbers do not make a system that can be simulated.
    pub fn new(model: &Model, equations: &'a dyn Equations, scene: &Scene) -> Result<Self, Refusal> {
        match scene.varying() {
            Some(torques) => Err(Refusal::Varying { torques }),
            None => Self::driven(model, equations, scene, None),
        }
    }

    /// Prepares a scene with what varies in time.
    ///
    /// # Errors
    /// Those of [`Simulation::new`].
    pub fn driven(
        model: &Model,
        equations: &'a dyn Equations,
        scene: &Scene,
        forcing: Option<Forcing>,
    ) -> Result<Self, Refusal> {
        Self::begun(model, equations, scene, start::begin(equations, scene)?, forcing)
    }

    /// The same from a start that is known.
    ///
    /// # Errors
    /// Those of [`Simulation::new`].
    pub fn begun(
        model: &Model,
        equations: &'a dyn Equations,
        scene: &Scene,
        begun: Begun,
        forcing: Option<Forcing>,
    ) -> Result<Self, Refusal> {
        let terms = scene.effects.nonlinear(model);
        if !terms.is_empty() {
            return Err(Refusal::Nonlinear { terms });
        }
        let Begun { state, laws, mut bands, .. } = begun;
        if let Some(terms) = law::curved(model, &laws) {
            return Err(Refusal::Nonlinear { terms });
        }
        let mut k = model.in_contact(laws.iter().map(Law::level));
        cells::write(&laws, &mut bands, &mut k);
        let cells = Cells::new(equations, model.motions.len(), (&laws, &bands, &k))?;
        let mut forcing = forcing.map(forced::Forced::new);
        if let Some(forced) = &mut forcing {
            forced.meet(equations, cells::index(&laws, &bands), &k)?;
        }
        Ok(Simulation {
            forcing: forcing.map(Box::new),
            equations,
            cells,
            lateness: vec![Lateness::default(); laws.first().map_or(1, |law| law.pitch.cells())],
            t_end: scene.t_end,
            guard: Guard::default(),
            clock: Clock::default(),
            state,
            laws,
            bands,
            rattle: (f64::NAN, 0),
            k,
            contact: None,
            compensated: None,
            kernel: None,
            dissipated: 0.0,
            ignored: 0.0,
            counts: Counts::default(),
        })
    }

    /// From here on carries state and time in twice the digits; `matrices` are those of a cell with given law values.
    ///
    /// # Errors
    /// Those of [`Compensated::new`].
    pub fn compensate(&mut self, matrices: &dyn Fn(&[Df64]) -> Matrices<Df64>) -> Result<(), Refusal> {
        if !self.bands.is_empty() || self.laws.iter().any(|law| law.is_error) {
            return Err(Refusal::CompensatedCells);
        }
        let stand = (&self.laws[..], &self.k[self.laws.len()..]);
        self.compensated = Some(Box::new(Compensated::new(matrices, &self.cells, stand, &self.state)?));
        Ok(())
    }

    /// Runs to the end. `recorder` notes samples at `rate` [1/s] and, if `events`, the limits at every event; `watch`
    /// is told the time after every event.
    ///
    /// # Errors
    /// Where the run cannot go on; what was recorded until then is in the recorder.
    pub fn run(
        &mut self,
        mut recorder: Option<(&mut Recorder<'_>, f64, bool)>,
        watch: &mut dyn FnMut(f64),
    ) -> Result<(), Stop> {
        let mut sample = 0;
        while !self.step(&mut recorder, &mut sample)? {
            watch(self.clock.now());
            if let Some((recorder, ..)) = &recorder {
                recorder.demand_room()?;
            }
        }
        Ok(())
    }

    /// Goes on to the next event, or to the end of the run; tells whether that was it. `sample` is the next one to note.
    ///
    /// # Errors
    /// Those of [`Simulation::run`].
    #[inline]
    pub fn step(
        &mut self,
        recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>,
        sample: &mut u64,
    ) -> Result<bool, Stop> {
        if self.is_plain() && self.pass_plain(recorder, sample) {
            return Ok(false);
        }
        self.step_in_general(recorder, sample)
    }

    /// The same without the kernel of plain events.
    ///
    /// # Errors
    /// Those of [`Simulation::run`].
    pub(crate) fn step_in_general(
        &mut self,
        recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>,
        sample: &mut u64,
    ) -> Result<bool, Stop> {
        if self.forcing.as_ref().is_some_and(|forcing| !forcing.is_flat()) {
            return self.step_in_window(recorder, sample);
        }
        // Solve: the motion in this cell, in closed form.
        let here = self.here();
        let mut flight = here.cell.flight(&self.state.q, &self.state.q_dot);
        if self.forcing.is_some() {
            flight = here.cell.pushed(flight, &self.further_load());
        }
        // Locate: its end.
        let (mut point, mut cost) = (flight.begin(), self.counts.cost);
        let (cell, mut lateness) = self.expected();
        let end = self.locate(here, &flight, &mut lateness, &mut point, &mut cost)?;
        if let Some((recorder, rate, _)) = recorder {
            self.samples(here, &flight, point.t, *rate, sample, recorder);
        }
        // Propagate to it.
        let (dq, dv) = flight.increments(&point);
        self.dissipated += flight.dissipated(&point) + self.clipped(here, &dq);
        self.counts.cost = cost;
        self.lateness[cell] = lateness;
        if let Some(forcing) = &mut self.forcing {
            forcing.account(&self.clock, &dq);
        }
        self.state.q += &dq;
        self.state.gain(&dv);
        let t = if self.compensated.is_none() { point.t.into() } else { self.propagate_again(end, point.t) };
        self.clock.advance(t);
        self.finish(end, recorder)
    }

    /// What happens where a flight ends; tells whether the run is over.
    #[inline(always)]
    fn finish(&mut self, end: End, recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>) -> Result<bool, Stop> {
        self.demand_numbers()?;
        // Jump: through the step, or back from it.
        if end == End::Run {
            self.clock.set(self.t_end);
            self.meet_at_the_end(recorder)?;
            if let Some((recorder, ..)) = recorder {
                self.note(recorder, Moment::Sample);
            }
            return Ok(true);
        }
        self.pass(end, recorder)?;
        let rate = self.cells.here().cell.rate;
        self.guard.against_cascades(&self.clock, rate, &self.state, self.cell())?;
        Ok(false)
    }

    /// Propagates in twice the digits to where the plain flight ended, after the time `t`; gives the time.
    #[cold]
    fn propagate_again(&mut self, end: End, t: f64) -> Df64 {
        let Some(compensated) = &mut self.compensated else { return t.into() };
        if self.contact.is_some() {
            compensated.set(&self.state);
            return t.into();
        }
        let cell = cells::index(&self.laws, &self.bands);
        let t = match end {
            End::Step(law, side) => match self.laws[law].next_switch() {
                None => compensated.meet(cell, law, self.laws[law].boundary(side), t),
                Some((switch, _)) => compensated.go(cell, self.clock.exactly_until(switch)),
            },
            End::Hold(..) | End::Flank(..) | End::Break => compensated.go(cell, t.into()),
            End::Run => compensated.go(cell, self.clock.exactly_until(self.t_end)),
        };
        compensated.round(&mut self.state);
        t
    }

    /// Ends a run whose state is beyond numbers.
    #[inline(always)]
    fn demand_numbers(&self) -> Result<(), Stop> {
        if self.state.is_finite() {
            return Ok(());
        }
        Err(Stop::NotFinite { t: self.clock.now(), state: self.state.describe(), cell: self.cell() })
    }

    /// Has its only law stand in another cell, for which it has been simulated elsewhere.
    pub(crate) fn stand_in(&mut self, cell: usize) {
        self.laws[0].cell = cell;
        self.change_cell().expect("all cells of a plain simulation are there");
    }

    /// Goes on from where another run of the scene has come to: its state, laws and dead bands.
    ///
    /// # Errors
    /// Where the cell has no modes.
    pub fn go_on_from(&mut self, state: State, laws: Vec<Law>, bands: Vec<DeadBand>) -> Result<(), Stop> {
        (self.state, self.laws, self.bands) = (state, laws, bands);
        self.change_cell()
    }

    /// Has the law values and the cell follow laws and dead bands.
    #[inline]
    fn change_cell(&mut self) -> Result<(), Stop> {
        cells::write(&self.laws, &mut self.bands, &mut self.k);
        let met = self.cells.meet(self.equations, (&self.laws, &self.bands, &self.k));
        met.map_err(|reason| self.no_modes(reason))?;
        match &mut self.forcing {
            Some(forced) => {
                let met = forced.meet(self.equations, cells::index(&self.laws, &self.bands), &self.k);
                met.map_err(|reason| self.no_modes(reason))
            }
            None => Ok(()),
        }
    }

    #[cold]
    fn no_modes(&self, reason: Refusal) -> Stop {
        Stop::Cell { t: self.clock.now(), state: self.state.describe(), cell: self.cell(), reason }
    }

    /// The cell with what is held in it.
    #[inline]
    fn here(&self) -> &Prepared {
        self.contact.as_ref().map_or_else(|| self.cells.here(), |contact| &contact.left)
    }

    /// Its equations.
    pub fn equations(&self) -> &'a dyn Equations {
        self.equations
    }

    /// Its cells.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// Whether its next event could be a plain one: one stiffness whose phase rolls with the motion, nothing held, nothing
    /// carried in more digits.
    pub fn is_plain(&self) -> bool {
        let rolls = |law: &Law| law.turn() > 0.0 && law.switching != Switching::Never && law.next_switch().is_none();
        let one = matches!(&self.laws[..], [law] if rolls(law)) && self.bands.is_empty();
        one && self.contact.is_none() && self.compensated.is_none() && self.forcing.is_none()
    }

    /// The cell: the place of each law in its pitch and of each dead band, the first law's counting fastest.
    pub fn cell(&self) -> usize {
        cells::index(&self.laws, &self.bands)
    }

    /// The law values now: of the laws, then of the dead bands.
    pub fn levels(&self) -> &[f64] {
        &self.k
    }

    /// Length of one turn of each coordinate (N): the pitch, where it rolls.
    pub fn turn_lengths(&self) -> Vector {
        law::turn_lengths(self.state.q.len(), &self.laws)
    }
}
