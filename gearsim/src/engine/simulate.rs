//! The run: solve a cell, locate its end, jump; the six steps of Oh, Grosh & Barber (2005), for any number of
//! coordinates, levels a pitch, and both directions of rotation.

use nalgebra::SVector;

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::clock::Clock;
use crate::engine::crossing::{Cost, Search, Side};
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::{Refusal, Stop};
use crate::engine::jump::{Passage, Surface};
use crate::engine::phase::Pitch;
use crate::engine::record::{Recorder, State};
use crate::engine::start;
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
    /// What the searches for crossings cost.
    pub cost: Cost,
}

/// A simulation under way: one scene's equations, cells and state.
pub struct Simulation<'a, const N: usize> {
    equations: &'a dyn Equations<N>,
    switching: Switching,
    /// The pitch of the stepping law, and its geometry.
    pitch: Pitch,
    surface: Surface<N>,
    /// Coordinate that is the phase, and whether its whole pitches are counted off.
    phase: usize,
    rolling: bool,
    /// The modes of every cell of a pitch, worked out once.
    cells: Vec<Cell<N>>,
    participation: Vec<SVector<f64, N>>,
    /// Angular speed of the frozen phase, and the phase itself at t = 0.
    frozen: Option<Frozen>,
    t_end: f64,
    /// Whole pitches that the phase has gone.
    pitches: i64,

    /// Time.
    pub clock: Clock,
    /// State.
    pub state: State<N>,
    /// Cell of the pitch.
    pub cell: usize,
    /// Energy lost to damping so far [J].
    pub dissipated: f64,
    /// What happened so far.
    pub counts: Counts,
    /// Leaves out the guarantee of crossings, to measure what it costs: `benches/guarantee.rs`. Never set otherwise.
    #[doc(hidden)]
    pub unguarded: bool,
    /// Time of the last event at which a cascade was seen to begin, and events since.
    cascade: (f64, u64),
}

/// The phase that runs by time alone: k(Omega0 t).
#[derive(Debug, Clone, Copy)]
struct Frozen {
    speed: f64,
    /// Remainder and pitches at t = 0.
    origin: f64,
    pitches: i64,
}

/// How a flight ends.
enum End {
    /// At a boundary of the cell.
    Step(Side),
    /// At the end of the run.
    Run,
}

/// Events closer than this part of the cell's shortest period, one after another, are a cascade.
const CASCADE_SPAN: f64 = 1e-9;
/// Events of a cascade that end the run.
const CASCADE_EVENTS: u64 = 10_000;

impl<'a, const N: usize> Simulation<'a, N> {
    /// Prepares a scene: its cells, its start.
    ///
    /// # Errors
    /// Where the numbers do not make a system that can be simulated.
    pub fn new(model: &Model, equations: &'a dyn Equations<N>, scene: &Scene) -> Result<Self, Refusal> {
        if !model.nonlinear.is_empty() {
            return Err(Refusal::Nonlinear { terms: model.nonlinear });
        }
        let (switching, pitch, surface, phase, rolling) = match model.laws {
            [] => (Switching::Never, Pitch::none(), Surface::none(), 0, false),
            [law] => {
                let switching = equations.switching(0);
                let pitch = match switching {
                    Switching::Never => Pitch::constant(scene.laws[0].mid(), law.period),
                    _ => Pitch::new(&scene.laws[0], law.period),
                };
                let phase = model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
                (switching, pitch, Surface::new(equations, 0), phase, law.rolling)
            }
            laws => return Err(Refusal::SeveralLaws { laws: laws.len() }),
        };
        let cells =
            (0..pitch.cells()).map(|c| Cell::new(equations, &[pitch.level(c)])).collect::<Result<Vec<_>, _>>()?;
        let participation = cells.iter().map(|c| c.participation(&surface.normal)).collect();
        let (state, pitches, cell) = start::begin(equations, scene, &pitch, phase, rolling)?;
        let frozen = (switching == Switching::ByTime).then(|| Frozen {
            speed: state.q_dot[phase],
            origin: pitch.locate(state.q[phase], state.q_dot[phase]).1,
            pitches,
        });
        Ok(Simulation {
            equations,
            switching,
            pitch,
            surface,
            phase,
            rolling,
            cells,
            participation,
            frozen,
            pitches,
            t_end: scene.t_end,
            clock: Clock::default(),
            state,
            cell,
            dissipated: 0.0,
            counts: Counts::default(),
            unguarded: false,
            cascade: (0.0, 0),
        })
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
        loop {
            // Solve: the motion in this cell, in closed form.
            let flight = self.cells[self.cell].flight(&self.state.q, &self.state.q_dot);
            // Locate: the first boundary it meets.
            let mut cost = self.counts.cost;
            let mut point = flight.begin();
            let end = self.locate(&flight, &mut point, &mut cost)?;
            if let Some((recorder, rate, _)) = &mut recorder {
                self.samples(&flight, point.t, *rate, &mut sample, recorder);
            }
            // Propagate to it.
            let (dq, dv) = flight.increments(&point);
            let lost = flight.dissipated(&point);
            self.counts.cost = cost;
            self.state.q += dq;
            self.state.q_dot += dv;
            self.dissipated += lost;
            self.clock.advance(point.t);
            if !self.state.q.iter().chain(self.state.q_dot.iter()).all(|x| x.is_finite()) {
                return Err(Stop::NotFinite { t: self.clock.now(), state: self.describe(), cell: self.cell });
            }
            let End::Step(side) = end else {
                self.clock.set(self.t_end);
                if let Some((recorder, ..)) = &mut recorder {
                    self.note(recorder, Moment::Sample);
                }
                return Ok(());
            };
            // Jump: through the step, or back from it.
            if let Some((recorder, _, true)) = &mut recorder {
                self.snap(side);
                self.note(recorder, Moment::Before);
                self.jump(side);
                self.note(recorder, Moment::After);
            } else {
                self.snap(side);
                self.jump(side);
            }
            self.guard_against_cascades()?;
            watch(self.clock.now());
        }
    }

    /// How the flight ends; `point` is moved to where.
    #[inline]
    fn locate(&self, flight: &Flight<'_, N>, point: &mut Point<N>, cost: &mut Cost) -> Result<End, Stop> {
        let left = self.clock.until(self.t_end);
        let (t, end) = match self.frozen {
            None if self.switching != Switching::Never => return self.meet(flight, left, point, cost),
            None => (left, End::Run),
            Some(frozen) => match self.next_switch(frozen) {
                (t, side) if t < self.t_end => (self.clock.until(t).max(0.0), End::Step(side)),
                _ => (left, End::Run),
            },
        };
        cost.evaluations += 1;
        flight.go(point, t);
        Ok(end)
    }

    /// The first boundary that the phase meets.
    #[inline]
    fn meet(&self, flight: &Flight<'_, N>, horizon: f64, point: &mut Point<N>, cost: &mut Cost) -> Result<End, Stop> {
        let (lower, upper) = self.bounds();
        let s = self.state.q[self.phase];
        let participation = &self.participation[self.cell];
        let search = Search { flight, participation, down: s - lower, up: upper - s, horizon };
        if self.unguarded {
            return Ok(search.unguarded(point, cost).map_or(End::Run, End::Step));
        }
        match search.first(point, cost) {
            Ok(met) => Ok(met.map_or(End::Run, End::Step)),
            Err(steps) => Err(Stop::Search {
                t: self.clock.now(),
                steps: steps as usize,
                state: self.describe(),
                cell: self.cell,
            }),
        }
    }

    /// When the frozen phase next meets a boundary of the present cell.
    fn next_switch(&self, frozen: Frozen) -> (f64, Side) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        let travelled = (self.pitches - frozen.pitches) as f64 * self.pitch.period();
        match frozen.speed {
            w if w > 0.0 => ((travelled + (upper - frozen.origin)) / w, Side::Upper),
            w if w < 0.0 => ((travelled + (lower - frozen.origin)) / w, Side::Lower),
            _ => (f64::INFINITY, Side::Upper),
        }
    }

    /// Boundaries of the present cell, in the coordinate that is the phase.
    #[inline]
    fn bounds(&self) -> (f64, f64) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        if self.rolling {
            return (lower, upper);
        }
        let before = self.pitches as f64 * self.pitch.period();
        (before + lower, before + upper)
    }

    /// Puts the phase exactly on the boundary that it met.
    fn snap(&mut self, side: Side) {
        if self.frozen.is_none() {
            let (lower, upper) = self.bounds();
            self.state.q[self.phase] = if side == Side::Upper { upper } else { lower };
        }
    }

    /// Passes a step, or is turned back by it.
    #[inline]
    fn jump(&mut self, side: Side) {
        let (beyond, entered, turn) = self.pitch.beyond(self.cell, side);
        let passage = match self.switching {
            Switching::WithJump => {
                let dk = self.pitch.level(beyond) - self.pitch.level(self.cell);
                self.surface.pass(self.equations, &self.state.q, &mut self.state.q_dot, dk)
            }
            _ => Passage::Transmitted,
        };
        if passage == Passage::Reflected {
            self.counts.reflections += 1;
            return;
        }
        self.counts.cell_changes += 1;
        self.cell = beyond;
        self.pitches += turn;
        if self.rolling && self.frozen.is_none() {
            self.state.q[self.phase] = entered;
            self.state.turns[self.phase] += turn;
        }
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
            let dissipated = self.dissipated + flight.dissipated(&point);
            recorder.row(at, Moment::Sample, &state, &[self.pitch.level(self.cell)], dissipated);
            *next += 1;
        }
    }

    fn note(&self, recorder: &mut Recorder<'_, N>, moment: Moment) {
        recorder.row(self.clock.now(), moment, &self.state, &[self.pitch.level(self.cell)], self.dissipated);
    }

    /// Ends a run whose events come ever faster.
    #[inline]
    fn guard_against_cascades(&mut self) -> Result<(), Stop> {
        let (since, events) = &mut self.cascade;
        let span = self.clock.until(*since).abs();
        if span > CASCADE_SPAN * self.t_end {
            *since = self.clock.now();
            *events = 0;
            return Ok(());
        }
        *events += 1;
        if *events < CASCADE_EVENTS {
            return Ok(());
        }
        let events = *events as usize;
        Err(Stop::Cascade { t: self.clock.now(), events, span, state: self.describe(), cell: self.cell })
    }

    fn describe(&self) -> String {
        let list = |v: &SVector<f64, N>| v.iter().map(|x| format!("{x:.6e}")).collect::<Vec<_>>().join(", ");
        format!("q = [{}], q' = [{}]", list(&self.state.q), list(&self.state.q_dot))
    }

    /// The stiffness of the present cell.
    pub fn stiffness(&self) -> f64 {
        self.pitch.level(self.cell)
    }

    /// Length of one turn of each coordinate (N): the pitch, where it rolls.
    pub fn turn_lengths(&self) -> [f64; N] {
        std::array::from_fn(|i| if self.rolling && i == self.phase { self.pitch.period() } else { 0.0 })
    }
}
