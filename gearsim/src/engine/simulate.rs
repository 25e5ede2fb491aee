//! The run: solve a cell, locate its end, jump; the six steps of Oh, Grosh & Barber (2005), for any number of
//! coordinates, stiffnesses and levels a pitch, and both directions of rotation.

use nalgebra::SVector;
use xprec::Df64;

use crate::engine::cell::{Flight, Point};
use crate::engine::cells::{self, Banded, Cells, Prepared};
use crate::engine::clock::Clock;
use crate::engine::compensated::Compensated;
use crate::engine::contact::{self, Contact, Ending};
use crate::engine::crossing::{Cost, Lateness, Lost, Search, Side};
use crate::engine::dead_band::{DeadBand, Regime};
use crate::engine::equations::{Equations, Matrices, Switching};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::guard::{self, Guard};
use crate::engine::jump::Passage;
use crate::engine::law::{self, Law};
use crate::engine::record::{Recorder, State};
use crate::engine::signal::Signal;
use crate::engine::start;
use crate::methods::choice;
use crate::model::Model;
use crate::scene::Scene;
use crate::trajectory::Moment;

mod forced;

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

/// A simulation under way: one scene's equations, cells and state.
pub struct Simulation<'a, const N: usize> {
    equations: &'a dyn Equations<N>,
    cells: Cells<N>,
    guard: Guard,
    /// How late the phase was in each cell of a pitch, when it was last there; of a single law, whose motion repeats itself.
    lateness: Vec<Lateness>,

    /// End of the run [s]. May be set later, and the simulation run on.
    pub t_end: f64,
    /// Time.
    pub clock: Clock,
    /// State.
    pub state: State<N>,
    /// Where the stiffnesses stand. To be set by [`Simulation::go_on_from`] alone.
    pub laws: Vec<Law<N>>,
    /// Where the dead bands stand.
    pub bands: Vec<DeadBand<N>>,
    /// The law values now: of the laws, then touch, edge, damp, clip of each dead band of the model.
    k: Vec<f64>,
    /// Phases held at a step that they cannot climb.
    contact: Option<Box<Contact<N>>>,
    /// The state in twice the digits, if it is carried.
    compensated: Option<Box<Compensated<N>>>,
    /// What varies in time, if anything does.
    forcing: Option<Box<forced::Forced<N>>>,
    /// Energy lost to damping so far [J].
    pub dissipated: f64,
    /// Energy of bounces that were not followed to their ends, so far [J].
    pub ignored: f64,
    /// What happened so far.
    pub counts: Counts,
    /// Leaves out the guarantee of crossings, to measure what it costs: `benches/guarantee.rs`. Never set otherwise.
    #[doc(hidden)]
    pub unguarded: bool,
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

impl<'a, const N: usize> Simulation<'a, N> {
    /// Prepares a scene with constant torques: its cells, its start.
    ///
    /// # Errors
    /// Where the numbers do not make a system that can be simulated.
    pub fn new(model: &Model, equations: &'a dyn Equations<N>, scene: &Scene) -> Result<Self, Refusal> {
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
        equations: &'a dyn Equations<N>,
        scene: &Scene,
        forcing: Option<Forcing<N>>,
    ) -> Result<Self, Refusal> {
        let terms = scene.effects.nonlinear(model);
        if !terms.is_empty() {
            return Err(Refusal::Nonlinear { terms });
        }
        let (state, laws, bands) = start::begin(equations, scene)?;
        if let Some(terms) = choice::curved(model, &laws) {
            return Err(Refusal::Nonlinear { terms });
        }
        let mut k = model.in_contact(laws.iter().map(Law::level));
        cells::write(&laws, &bands, &mut k);
        let cells = Cells::new(equations, (&laws, &bands, &k))?;
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
            k,
            contact: None,
            compensated: None,
            dissipated: 0.0,
            ignored: 0.0,
            counts: Counts::default(),
            unguarded: false,
        })
    }

    /// From here on carries state and time in twice the digits; `matrices` are those of a cell with given law values.
    ///
    /// # Errors
    /// Those of [`Compensated::new`].
    pub fn compensate(&mut self, matrices: &dyn Fn(&[Df64]) -> Matrices<N, Df64>) -> Result<(), Refusal> {
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
        mut recorder: Option<(&mut Recorder<'_, N>, f64, bool)>,
        watch: &mut dyn FnMut(f64),
    ) -> Result<(), Stop> {
        let mut sample = 0;
        while !self.step(&mut recorder, &mut sample)? {
            watch(self.clock.now());
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
        recorder: &mut Option<(&mut Recorder<'_, N>, f64, bool)>,
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
        self.dissipated += flight.dissipated(&point) + self.clipped(here, &self.state, &dq);
        self.counts.cost = cost;
        self.lateness[cell] = lateness;
        if let Some(forcing) = &mut self.forcing {
            forcing.account(&self.clock, &dq);
        }
        self.state.q += dq;
        self.state.q_dot += dv;
        let t = if self.compensated.is_none() { point.t.into() } else { self.propagate_again(end, point.t) };
        self.clock.advance(t);
        self.finish(end, recorder)
    }

    /// What happens where a flight ends; tells whether the run is over.
    #[inline]
    fn finish(&mut self, end: End, recorder: &mut Option<(&mut Recorder<'_, N>, f64, bool)>) -> Result<bool, Stop> {
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

    /// The cell of the pitch, and how late the phase was when it was last there.
    #[inline]
    fn expected(&self) -> (usize, Lateness) {
        match &self.laws[..] {
            [law] => (law.cell, self.lateness[law.cell]),
            _ => (0, Lateness::default()),
        }
    }

    /// How the flight ends; `point` is moved to where.
    #[inline]
    fn locate(
        &self,
        here: &Prepared<N>,
        flight: &Flight<'_, N>,
        lateness: &mut Lateness,
        point: &mut Point<N>,
        cost: &mut Cost,
    ) -> Result<End, Stop> {
        let lost = |lost| self.lost(lost);
        let (mut end, mut horizon) = (End::Run, self.clock.until_about(self.t_end));
        if let Some(forcing) = &self.forcing {
            (end, horizon) = forcing.horizon(&self.clock, horizon);
        }
        for (i, law) in self.laws.iter().enumerate() {
            if law.switching == Switching::Never || self.contact.as_ref().is_some_and(|c| c.holds(i)) {
                continue;
            }
            let mut trial = flight.begin();
            if let Some((t, side)) = law.next_switch() {
                let t = self.clock.until(t).max(0.0);
                if t < horizon {
                    flight.go(&mut trial, t);
                    (*point, end, horizon) = (trial, End::Step(i, side), t);
                }
                continue;
            }
            let (lower, upper) = law.bounds();
            let s = self.state.q[law.phase];
            let signal = Signal { flight, on_moved: &here.participation[i], on_speed: here.on_speed[i].as_ref() };
            let rate = law.surface.normal.dot(&self.state.q_dot);
            let search = Search { signal, rate, down: s - lower, up: upper - s, horizon };
            // The first law's search moves the point itself: mostly there is no other.
            let (place, lateness) =
                if i == 0 { (&mut *point, &mut *lateness) } else { (&mut trial, &mut Lateness::default()) };
            let met = match self.unguarded {
                false => search.first_near(lateness, place, cost).map_err(lost)?,
                true => search.unguarded(lateness, place, cost),
            };
            if let Some(side) = met {
                (end, horizon) = (End::Step(i, side), place.t);
                if i > 0 {
                    *point = trial;
                }
            }
        }
        if !here.bands.is_empty() || self.contact.is_some() {
            end = self.leave(here, flight, (end, horizon), point, cost).map_err(lost)?;
        }
        if matches!(end, End::Run | End::Break) {
            cost.evaluations += 1;
            flight.go(point, horizon);
        }
        Ok(end)
    }

    /// How the flight ends, which would end as `end` at the `horizon`, were there no dead bands and nothing held.
    #[inline(never)]
    fn leave(
        &self,
        here: &Prepared<N>,
        flight: &Flight<'_, N>,
        (mut end, mut horizon): (End, f64),
        point: &mut Point<N>,
        cost: &mut Cost,
    ) -> Result<End, Lost> {
        for (i, banded) in here.bands.iter().enumerate() {
            for (beyond, watch) in &banded.exits {
                let mut trial = flight.begin();
                // Less than nothing is rounding: the value is not negative until the exit.
                let value = watch.value(&self.state).max(0.0);
                if watch.first_zero(value, flight, horizon, &mut trial, cost)? {
                    (horizon, end) = (trial.t, End::Flank(i, *beyond));
                    *point = trial;
                }
            }
        }
        if let Some(contact) = &self.contact {
            let ending = contact.first_ending(flight, &self.state, horizon, point, cost)?;
            end = ending.map_or(end, |(law, ending)| End::Hold(law, ending));
        }
        Ok(end)
    }

    /// Why a search without an answer ends the run.
    #[cold]
    fn lost(&self, lost: Lost) -> Stop {
        let (t, state, cell) = (self.clock.now(), self.state.describe(), self.cell());
        match lost {
            Lost::Stuck(steps) => Stop::Search { t, steps: steps as usize, state, cell },
            Lost::Overflow => Stop::NotFinite { t, state, cell },
        }
    }

    /// Meets the steps that a phase has just come to as the run ends, so that a run split there equals the whole.
    fn meet_at_the_end(&mut self, recorder: &mut Option<(&mut Recorder<'_, N>, f64, bool)>) -> Result<(), Stop> {
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

    /// Ends a run whose state is beyond numbers.
    #[inline]
    fn demand_numbers(&self) -> Result<(), Stop> {
        if self.state.is_finite() {
            return Ok(());
        }
        Err(Stop::NotFinite { t: self.clock.now(), state: self.state.describe(), cell: self.cell() })
    }

    /// An event, its left and right limits noted.
    #[inline]
    fn pass(&mut self, end: End, recorder: &mut Option<(&mut Recorder<'_, N>, f64, bool)>) -> Result<(), Stop> {
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
    fn arrive(&mut self, end: End) {
        if let End::Step(law, side) = end {
            self.laws[law].snap(side, &mut self.state);
            self.place(law);
        }
    }

    /// Has the state in twice the digits follow the plain one, whose phase has been put on a boundary.
    #[inline]
    fn place(&mut self, law: usize) {
        if let Some(compensated) = &mut self.compensated
            && self.laws[law].next_switch().is_none()
        {
            compensated.place(law, &self.state);
        }
    }

    /// What happens at an event.
    #[inline]
    fn act(&mut self, end: End) -> Result<(), Stop> {
        match end {
            End::Step(law, side) => {
                if self.laws.len() > 1 {
                    let ambiguous = guard::order_matters(self.equations, (&self.laws, &self.k), &self.state, law, side);
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
                self.change_cell()?;
                // What is held now presses otherwise, or against nothing.
                let held = self.contact.take().map_or(vec![], |contact| contact.laws);
                let stand = (&self.laws[..], &self.k[..]);
                let void = |held: &(usize, Side)| contact::is_void(self.equations, stand, *held, &self.state);
                let (void, held): (Vec<_>, Vec<_>) = held.into_iter().partition(void);
                void.into_iter().try_for_each(|(law, side)| self.enter(law, side))?;
                self.hold(held)
            }
            End::Break => self.enter_course(),
            End::Run => Ok(()),
        }
    }

    /// Passes a step, or is turned back by it.
    #[inline]
    fn jump(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let passage = match self.laws[law].switching {
            Switching::WithJump => match &mut self.compensated {
                None => {
                    let dv = law::barrier(self.equations, (&self.laws, &self.k), law, side, &self.state);
                    self.laws[law].surface.pass(&mut self.state.q_dot, side, dv)
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
        if let [only] = &mut self.laws[..] {
            only.enter(side, &mut self.state);
            self.place(law);
            self.change_cell()?;
            return self.grip();
        }
        let met: Vec<usize> = law::met(&self.laws, law, side, &self.state).collect();
        let phase = self.laws[law].phase;
        let turns: i64 = met.into_iter().map(|i| self.laws[i].enter(side, &mut self.state)).sum();
        self.laws.iter_mut().for_each(|law| law.follow(phase, turns));
        self.place(law);
        self.change_cell()?;
        self.grip()
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
    pub fn go_on_from(&mut self, state: State<N>, laws: Vec<Law<N>>, bands: Vec<DeadBand<N>>) -> Result<(), Stop> {
        (self.state, self.laws, self.bands) = (state, laws, bands);
        self.change_cell()
    }

    /// Has the law values and the cell follow laws and dead bands.
    #[inline]
    fn change_cell(&mut self) -> Result<(), Stop> {
        cells::write(&self.laws, &self.bands, &mut self.k);
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

    /// Has the dampers of contacts follow a step of the forces.
    #[inline]
    fn grip(&mut self) -> Result<(), Stop> {
        if self.bands.is_empty() {
            return Ok(());
        }
        let here = self.cells.here();
        let gripped = |(band, banded): (&DeadBand<N>, &Banded<N>)| match band.regime {
            Regime::Free => Regime::Free,
            Regime::Contact(side, _) => band.gripped(side, banded.elastic, &self.state),
        };
        let regimes: Vec<Regime> = self.bands.iter().zip(&here.bands).map(gripped).collect();
        if self.bands.iter().zip(&regimes).all(|(band, regime)| band.regime == *regime) {
            return Ok(());
        }
        self.bands.iter_mut().zip(regimes).for_each(|(band, regime)| band.regime = regime);
        self.change_cell()
    }

    #[cold]
    fn no_modes(&self, reason: Refusal) -> Stop {
        Stop::Cell { t: self.clock.now(), state: self.state.describe(), cell: self.cell(), reason }
    }

    /// The cell with what is held in it.
    #[inline]
    fn here(&self) -> &Prepared<N> {
        self.contact.as_ref().map_or_else(|| self.cells.here(), |contact| &contact.left)
    }

    /// What the clipped dampers of dead bands take where the coordinates move on by `dq` from `state` [J].
    #[inline]
    fn clipped(&self, here: &Prepared<N>, state: &State<N>, dq: &SVector<f64, N>) -> f64 {
        self.bands.iter().zip(&here.bands).map(|(band, banded)| band.clipped(banded.elastic, state, dq)).sum()
    }

    /// Holds a phase that was just turned back, if it is pressed against the step and its bounces no longer count.
    fn press(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let (q, v, k) = (self.state.q.into(), self.state.q_dot.into(), &self.k);
        let energy = self.equations.kinetic(&v) + self.equations.potential(&q, k);
        let mut acceleration = SVector::from(self.equations.acceleration(&q, &v, k, &vec![0.0; self.laws.len()]));
        if self.forcing.is_some() {
            acceleration += self.further_acceleration();
        }
        let rate = self.cells.here().cell.rate;
        if !contact::presses(&self.laws[law], side, &self.state, &acceleration, rate, energy) {
            return Ok(());
        }
        self.counts.holds += 1;
        self.hold(vec![(law, side)])
    }

    /// Holds phases at their steps, those of them that press.
    fn hold(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        let further = if self.forcing.is_some() { self.further_load() } else { SVector::zeros() };
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

    fn samples(
        &self,
        here: &Prepared<N>,
        flight: &Flight<'_, N>,
        t: f64,
        rate: f64,
        next: &mut u64,
        recorder: &mut Recorder<'_, N>,
    ) {
        // A sample a rounding before the event that ends the flight is not noted after it.
        let mut end = self.clock;
        end.advance(t);
        loop {
            let at = *next as f64 / rate;
            let tau = self.clock.until(at);
            // The end of the run is noted by itself; a sample at a boundary belongs to the cell it ends.
            if tau > t || at >= self.t_end {
                return;
            }
            let point = flight.at(tau.max(0.0));
            let (dq, dv) = flight.increments(&point);
            let state = State { q: self.state.q + dq, q_dot: self.state.q_dot + dv, turns: self.state.turns };
            let dissipated = flight.dissipated(&point) + self.clipped(here, &self.state, &dq);
            if let Some(forcing) = &self.forcing {
                recorder.beyond = forcing.work_after(&self.clock, &dq);
            }
            let lost = (self.dissipated + dissipated, self.ignored);
            recorder.row(at.min(end.now()), Moment::Sample, &state, &self.k, lost);
            *next += 1;
        }
    }

    /// Adds a row of how it stands.
    pub fn note(&self, recorder: &mut Recorder<'_, N>, moment: Moment) {
        if let Some(forcing) = &self.forcing {
            recorder.beyond.clone_from(forcing.work());
        }
        recorder.row(self.clock.now(), moment, &self.state, &self.k, (self.dissipated, self.ignored));
    }

    /// Its equations.
    pub fn equations(&self) -> &'a dyn Equations<N> {
        self.equations
    }

    /// Its cells.
    pub fn cells(&self) -> &Cells<N> {
        &self.cells
    }

    /// Whether its next event could be a plain one: one stiffness whose phase rolls with the motion, nothing held, nothing
    /// carried in more digits.
    pub fn is_plain(&self) -> bool {
        let rolls = |law: &Law<N>| law.turn() > 0.0 && law.switching != Switching::Never && law.next_switch().is_none();
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
    pub fn turn_lengths(&self) -> [f64; N] {
        let length = |i| self.laws.iter().find(|l| l.phase == i).map_or(0.0, Law::turn);
        std::array::from_fn(length)
    }
}
