//! The run: solve a cell, locate its end, jump; the six steps of Oh, Grosh & Barber (2005), for any number of
//! coordinates, stiffnesses and levels a pitch, and both directions of rotation.

use xprec::Df64;

use crate::engine::cell::{Flight, Point};
use crate::engine::cells::{self, Cells, Prepared};
use crate::engine::clock::Clock;
use crate::engine::compensated::Compensated;
use crate::engine::contact::{self, Contact, Ending};
use crate::engine::crossing::{Cost, Lost, Search, Side};
use crate::engine::equations::{Equations, Matrices, Switching};
use crate::engine::error::{Refusal, Stop};
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

/// What a run did, besides its trajectory.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counts {
    /// Steps of a stiffness passed.
    pub cell_changes: u64,
    /// Steps at which the motion turned back.
    pub reflections: u64,
    /// Times that a phase was held at a step.
    pub holds: u64,
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

    /// End of the run [s]. May be set later, and the simulation run on.
    pub t_end: f64,
    /// Time.
    pub clock: Clock,
    /// State.
    pub state: State<N>,
    /// Where the stiffnesses stand.
    pub laws: Vec<Law<N>>,
    /// Phases held at a step that they cannot climb.
    contact: Option<Box<Contact<N>>>,
    /// The state in twice the digits, if it is carried.
    compensated: Option<Box<Compensated<N>>>,
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
    /// The run is over.
    Run,
}

impl<'a, const N: usize> Simulation<'a, N> {
    /// Prepares a scene: its cells, its start.
    ///
    /// # Errors
    /// Where the numbers do not make a system that can be simulated.
    pub fn new(model: &Model, equations: &'a dyn Equations<N>, scene: &Scene) -> Result<Self, Refusal> {
        if !model.nonlinear.is_empty() {
            return Err(Refusal::Nonlinear { terms: model.nonlinear.into() });
        }
        let (state, laws) = start::begin(equations, scene)?;
        if let Some(terms) = choice::curved(model, &laws) {
            return Err(Refusal::Nonlinear { terms });
        }
        Ok(Simulation {
            equations,
            cells: Cells::new(equations, &laws)?,
            t_end: scene.t_end,
            guard: Guard::default(),
            clock: Clock::default(),
            state,
            laws,
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
        self.compensated = Some(Box::new(Compensated::new(matrices, &self.cells, &self.laws, &self.state)?));
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
        // Solve: the motion in this cell, in closed form.
        let here = self.contact.as_ref().map_or_else(|| self.cells.at(&self.laws), |contact| &contact.left);
        let flight = here.cell.flight(&self.state.q, &self.state.q_dot);
        // Locate: its end.
        let (mut point, mut cost) = (flight.begin(), self.counts.cost);
        let end = self.locate(here, &flight, &mut point, &mut cost)?;
        if let Some((recorder, rate, _)) = recorder {
            self.samples(&flight, point.t, *rate, sample, recorder);
        }
        // Propagate to it.
        let (dq, dv) = flight.increments(&point);
        self.dissipated += flight.dissipated(&point);
        self.counts.cost = cost;
        self.state.q += dq;
        self.state.q_dot += dv;
        let t = if self.compensated.is_none() { point.t.into() } else { self.propagate_again(end, point.t) };
        self.clock.advance(t);
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
        let rate = self.cells.at(&self.laws).cell.rate;
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
        let cell = cells::index(&self.laws);
        let t = match end {
            End::Step(law, side) => match self.laws[law].next_switch() {
                None => compensated.meet(cell, law, self.laws[law].boundary(side), t),
                Some((switch, _)) => compensated.go(cell, self.clock.exactly_until(switch)),
            },
            End::Hold(..) => compensated.go(cell, t.into()),
            End::Run => compensated.go(cell, self.clock.exactly_until(self.t_end)),
        };
        compensated.round(&mut self.state);
        t
    }

    /// How the flight ends; `point` is moved to where.
    #[inline]
    fn locate(
        &self,
        here: &Prepared<N>,
        flight: &Flight<'_, N>,
        point: &mut Point<N>,
        cost: &mut Cost,
    ) -> Result<End, Stop> {
        let lost = |lost| {
            let (t, state, cell) = (self.clock.now(), self.state.describe(), self.cell());
            match lost {
                Lost::Stuck(steps) => Stop::Search { t, steps: steps as usize, state, cell },
                Lost::Overflow => Stop::NotFinite { t, state, cell },
            }
        };
        let (mut end, mut horizon) = (End::Run, self.clock.until(self.t_end));
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
            let place = if i == 0 { &mut *point } else { &mut trial };
            let met =
                if self.unguarded { search.unguarded(place, cost) } else { search.first(place, cost).map_err(lost)? };
            if let Some(side) = met {
                (end, horizon) = (End::Step(i, side), place.t);
                if i > 0 {
                    *point = trial;
                }
            }
        }
        if let Some(contact) = &self.contact {
            let ending = contact.first_ending(flight, &self.state, horizon, point, cost).map_err(lost)?;
            end = ending.map_or(end, |(law, ending)| End::Hold(law, ending));
        }
        if end == End::Run {
            cost.evaluations += 1;
            flight.go(point, horizon);
        }
        Ok(end)
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
                    let ambiguous = guard::order_matters(self.equations, &self.laws, &self.state, law, side);
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
                    self.enter(law, side);
                }
                self.hold(held)
            }
            End::Run => Ok(()),
        }
    }

    /// Passes a step, or is turned back by it.
    #[inline]
    fn jump(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let passage = match self.laws[law].switching {
            Switching::WithJump => match &mut self.compensated {
                None => {
                    let dv = law::barrier(self.equations, &self.laws, law, side, &self.state);
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
            self.enter(law, side);
            return Ok(());
        }
        self.counts.reflections += 1;
        self.press(law, side)
    }

    /// Goes on into the cell beyond.
    #[inline]
    fn enter(&mut self, law: usize, side: Side) {
        self.counts.cell_changes += 1;
        if let [only] = &mut self.laws[..] {
            only.enter(side, &mut self.state);
            return self.place(law);
        }
        let met: Vec<usize> = law::met(&self.laws, law, side, &self.state).collect();
        let phase = self.laws[law].phase;
        let turns: i64 = met.into_iter().map(|i| self.laws[i].enter(side, &mut self.state)).sum();
        self.laws.iter_mut().for_each(|law| law.follow(phase, turns));
        self.place(law);
    }

    /// Holds a phase that was just turned back, if it is pressed against the step and its bounces no longer count.
    fn press(&mut self, law: usize, side: Side) -> Result<(), Stop> {
        let (q, v, k) = (self.state.q.into(), self.state.q_dot.into(), self.levels());
        let energy = self.equations.kinetic(&v) + self.equations.potential(&q, &k);
        let acceleration = self.equations.acceleration(&q, &v, &k, &vec![0.0; k.len()]).into();
        let rate = self.cells.at(&self.laws).cell.rate;
        if !contact::presses(&self.laws[law], side, &self.state, &acceleration, rate, energy) {
            return Ok(());
        }
        self.counts.holds += 1;
        self.hold(vec![(law, side)])
    }

    /// Holds phases at their steps, those of them that press.
    fn hold(&mut self, held: Vec<(usize, Side)>) -> Result<(), Stop> {
        let begun = Contact::begin(self.equations, &self.laws, held, &mut self.state);
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

    fn samples(&self, flight: &Flight<'_, N>, t: f64, rate: f64, next: &mut u64, recorder: &mut Recorder<'_, N>) {
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
            let lost = (self.dissipated + flight.dissipated(&point), self.ignored);
            recorder.row(at, Moment::Sample, &state, &self.levels(), lost);
            *next += 1;
        }
    }

    /// Adds a row of how it stands.
    pub fn note(&self, recorder: &mut Recorder<'_, N>, moment: Moment) {
        recorder.row(self.clock.now(), moment, &self.state, &self.levels(), (self.dissipated, self.ignored));
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
        matches!(&self.laws[..], [law] if rolls(law)) && self.contact.is_none() && self.compensated.is_none()
    }

    /// The cell: the place of each law in its pitch, the first law's counting fastest.
    pub fn cell(&self) -> usize {
        cells::index(&self.laws)
    }

    /// The stiffnesses now.
    pub fn levels(&self) -> Vec<f64> {
        self.laws.iter().map(Law::level).collect()
    }

    /// Length of one turn of each coordinate (N): the pitch, where it rolls.
    pub fn turn_lengths(&self) -> [f64; N] {
        let length = |i| self.laws.iter().find(|l| l.phase == i).map_or(0.0, Law::turn);
        std::array::from_fn(length)
    }
}
