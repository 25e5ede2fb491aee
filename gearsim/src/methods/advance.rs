//! A run by a numerical method: step, look for the first boundary in it, land there, jump.
//!
//! The dense output says for certain which boundary it meets first ([`crate::engine::root`]); the step is then taken again,
//! as long as to there, so that states at events are as accurate as steps, not as their interpolation. Laws, jumps and the
//! account are those of the exact engine. It has no held contact: a phase that is pressed against a step ends as a cascade.

mod events;
mod flanks;
mod work;

use crate::engine::cells;
use crate::engine::clock::Clock;
use crate::engine::crossing::Side;
use crate::engine::dead_band::Regime;
use crate::engine::equations::Equations;
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::guard::Guard;
use crate::engine::law;
use crate::engine::record::{Recorder, State, Turns};
use crate::engine::simulate::Counts;
use crate::engine::start::{self, Begun};
use crate::engine::vector::{Matrix, Vector};
use crate::scene::Scene;
use crate::trajectory::Moment;

use super::control::{Control, Steps};
use super::dense::Dense;
use super::field::Field;
use super::flow::Flow;
use super::radau::Radau;
use super::{Method, Trial};

/// Where events are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Events {
    /// Where they happen.
    Located,
    /// After the step in which they happened, as programs do that know of none: for comparison.
    AfterStep,
}

/// How a run is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// How long steps are.
    pub steps: Steps,
    /// Where events are taken.
    pub events: Events,
    /// Whether an explicit method may give way to an implicit one where it is held back by stability.
    pub give_way: bool,
    /// Steps after which a run is given up.
    pub most_steps: u64,
}

/// Steps held back by stability, one after another, that show a stiff cell.
const STIFF_STEPS: u32 = 15;
/// Rejections of one step that end a run.
const MOST_REJECTED: u32 = 100;

/// A run under way.
pub struct Advance<'a> {
    field: Field<'a>,
    method: Box<dyn Method>,
    settings: Settings,
    control: Control,
    guard: Guard,
    t_end: f64,
    /// The fastest rate of the motion at the start \[1/s\].
    fastest: f64,
    /// The state, and its rate.
    y: Flow,
    rate: Flow,
    stiff: u32,
    /// Whether each dead band was free of contact after the last step.
    free: Vec<bool>,
    /// The method that takes over with the next step.
    replacement: Option<Box<dyn Method>>,

    /// Whole turns of each coordinate (N).
    pub turns: Turns,
    /// Work of each torque as far as it is not constant [J]; empty where all are.
    work: Vec<f64>,
    /// Time.
    pub clock: Clock,
    /// Events and costs.
    pub counts: Counts,
    /// Steps taken, and tried in vain.
    pub steps: (u64, u64),
    /// When the method gave way to an implicit one \[s\].
    pub gave_way: Option<f64>,
}

/// What a step meets.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Met {
    /// A law meets a boundary of its cell.
    Step(usize, Side),
    /// A dead band meets its edge at a side, and goes over into another regime.
    Edge(usize, Side, Regime),
}

/// What is due where a step must end.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Due {
    /// The step ended before that.
    Nothing,
    /// A law switches by time.
    Switch(usize, Side),
    /// The course of a torque breaks.
    Break,
    /// The run is over.
    End,
}

/// What is recorded: by whom, at which rate \[1/s\], and whether with the limits at events.
type Recording<'r, 'e> = Option<(&'r mut Recorder<'e>, f64, bool)>;

impl<'a> Advance<'a> {
    /// Prepares a scene with what varies in time.
    ///
    /// # Errors
    /// Where the start is not determined.
    pub fn new(
        equations: &'a dyn Equations,
        scene: &Scene,
        method: Box<dyn Method>,
        settings: Settings,
        forcing: Option<Forcing>,
    ) -> Result<Self, Refusal> {
        Ok(Self::begun(equations, scene, start::begin(equations, scene)?, method, settings, forcing))
    }

    /// The same from a start that is known.
    pub fn begun(
        equations: &'a dyn Equations,
        scene: &Scene,
        begun: Begun,
        method: Box<dyn Method>,
        settings: Settings,
        forcing: Option<Forcing>,
    ) -> Self {
        let swings = forcing.as_ref().map_or(0.0, Forcing::fastest);
        let torques = if forcing.is_some() || equations.has_powers() { scene.model.torques.len() } else { 0 };
        let Begun { state, laws, bands, .. } = begun;
        let y = Flow { q: state.q, v: state.q_dot, lost: 0.0 };
        let mut field = Field::new(scene.model, equations, (laws, bands), forcing);
        let rate = field.rate(0.0, &y);
        // Speeds that the energy at the start allows, or the forces soon give; the fastest of the motion.
        let energy = equations.kinetic(&y.v) + equations.potential(&y.q, field.levels(0.0, &y));
        let [by_q, by_v] = field.jacobian(0.0, &y);
        let sum = |a: &Matrix| a.row_iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
        let fastest = sum(&by_q).sqrt().max(sum(&by_v)).max(swings).max(1.0 / scene.t_end);
        let mobility = equations.mobility();
        let speeds =
            Vector::from_fn(y.q.len(), |i| (2.0 * energy * mobility[(i, i)]).sqrt().max(rate.v[i].abs() / fastest));
        let control = Control::new(settings.steps, &y, &speeds, fastest, method.exponent(), scene.t_end);
        let free = field.bands.iter().map(|band| band.regime == Regime::Free).collect();
        Advance {
            free,
            field,
            method,
            settings,
            control,
            guard: Guard::default(),
            t_end: scene.t_end,
            fastest,
            y,
            rate,
            stiff: 0,
            replacement: None,
            turns: state.turns,
            work: vec![0.0; torques],
            clock: Clock::default(),
            counts: Counts::default(),
            steps: (0, 0),
            gave_way: None,
        }
    }

    /// Runs to the end, as [`Simulation::run`](crate::engine::simulate::Simulation::run) does.
    ///
    /// # Errors
    /// Where the run cannot go on; what was recorded until then is in the recorder.
    pub fn run(&mut self, mut recording: Recording<'_, '_>, watch: &mut dyn FnMut(f64)) -> Result<(), Stop> {
        let mut sample = 0;
        loop {
            // Step, as far as the run and the laws that switch by time allow.
            let (left, due) = self.horizon();
            let (h, trial) = self.step(left)?;
            let dense = match h > 0.0 {
                true => self.method.dense(&mut self.field, &self.y, h, &trial),
                false => Dense::new(vec![self.y.clone()]),
            };
            // Locate, and land there.
            let met = self.first_met(&dense);
            let (taken, trial) = match met {
                Some((x, met)) => self.land(h, x, met, &dense),
                None => (h, trial),
            };
            if let Some((recorder, rate, _)) = &mut recording {
                self.samples(&dense, h, taken, *rate, &mut sample, recorder);
            }
            if let Some(method) = self.replacement.take() {
                self.method = method;
            }
            self.work_on(&dense, h, taken);
            self.clock.advance(taken);
            self.field.begins = self.clock.now();
            (self.y, self.rate) = (trial.end, trial.rate);
            self.count_impacts();
            self.control.reach(&self.y);
            self.counts.cost.evaluations = self.field.evaluations;
            self.demand_numbers()?;
            // Jump.
            let due = if taken >= left { due } else { Due::Nothing };
            let event = match (met, due) {
                (Some((_, met)), _) => Some(met),
                (None, Due::Switch(law, side)) => Some(Met::Step(law, side)),
                _ => None,
            };
            match event {
                Some(Met::Step(law, side)) => self.pass(law, side, &mut recording)?,
                Some(Met::Edge(band, _, beyond)) => self.pass_edge(band, beyond, &mut recording)?,
                None if due == Due::Break => self.enter_course(),
                None => {}
            }
            if event.is_none() && due != Due::Break && self.settings.events == Events::AfterStep {
                self.catch_up(&mut recording)?;
            }
            if event.is_none() && due == Due::End {
                self.clock.set(self.t_end);
                self.meet_at_the_end(&mut recording)?;
                recording.into_iter().for_each(|(recorder, ..)| self.note(recorder, Moment::Sample));
                self.counts.cost.evaluations = self.field.evaluations;
                return Ok(());
            }
            watch(self.clock.now());
            recording.iter().try_for_each(|(recorder, ..)| recorder.demand_room())?;
        }
    }

    /// Time until the step must end, and what is then due.
    fn horizon(&self) -> (f64, Due) {
        let switches = self.field.laws.iter().enumerate().filter_map(|(i, law)| {
            let (t, side) = law.next_switch()?;
            Some((self.clock.until(t).max(0.0), Due::Switch(i, side)))
        });
        let next = self.field.forcing.iter().map(|f| f.next()).filter(|next| next.is_finite());
        let breaks = next.map(|next| (self.clock.until(next).max(0.0), Due::Break));
        let switches = switches.chain(breaks);
        let end = (self.clock.until(self.t_end), Due::End);
        switches.fold(end, |first, other| if other.0 < first.0 { other } else { first })
    }

    /// A step of at most `left` whose error is small enough: how long, and where it leads.
    fn step(&mut self, left: f64) -> Result<(f64, Trial), Stop> {
        let exponent = self.method.exponent();
        if left <= 0.0 {
            return Ok((0.0, Trial { end: self.y.clone(), rate: self.rate.clone(), error: 0.0, stiffness: 0.0 }));
        }
        for _ in 0..MOST_REJECTED {
            let h = self.control.step(left);
            let t = self.clock.now();
            if h < left && t + h <= t.next_up() && t > 0.0 {
                break;
            }
            if self.steps.0 + self.steps.1 >= self.settings.most_steps {
                let (steps, state, cell) = (self.settings.most_steps, self.state().describe(), self.cell());
                return Err(Stop::Steps { t, steps, state, cell });
            }
            let trial = self.method.attempt(&mut self.field, &self.y, &self.rate, h, &self.control.allowed());
            // A step that leads nowhere is as bad as one whose error is not a number.
            let usable = trial.filter(|trial| trial.end.is_finite() && trial.rate.is_finite());
            let error = usable.as_ref().map_or(f64::NAN, |trial| trial.error);
            if self.control.accepts(h, error, exponent) {
                let Some(trial) = usable else { break };
                self.steps.0 += 1;
                self.watch_stiffness(&trial);
                return Ok((h, trial));
            }
            self.steps.1 += 1;
        }
        let (t, h) = (self.clock.now(), self.control.h);
        Err(Stop::Step { t, h, method: self.method.name(), state: self.state().describe(), cell: self.cell() })
    }

    /// Gives way to an implicit method once stability, step after step, is what holds an explicit one back.
    fn watch_stiffness(&mut self, trial: &Trial) {
        let Steps::Adaptive(tolerance) = self.settings.steps else { return };
        if !self.settings.give_way || self.gave_way.is_some() {
            return;
        }
        self.stiff = if trial.stiffness > self.method.stability() { self.stiff + 1 } else { 0 };
        if self.stiff >= STIFF_STEPS {
            self.gave_way = Some(self.clock.now());
            self.replacement = Some(Box::new(Radau::new(tolerance)));
        }
    }

    fn samples(&mut self, dense: &Dense, h: f64, taken: f64, rate: f64, next: &mut u64, recorder: &mut Recorder<'_>) {
        loop {
            let at = *next as f64 / rate;
            let tau = self.clock.until(at);
            // The end of the run is noted by itself; a sample at a boundary belongs to the cell it ends.
            if tau > taken || at >= self.t_end {
                return;
            }
            let y = if h > 0.0 { dense.at((tau / h).clamp(0.0, 1.0)) } else { self.y.clone() };
            let state = State { turns: self.turns.clone(), ..State::new(y.q.clone(), y.v.clone()) };
            let lost = (y.lost, 0.0);
            recorder.beyond = self.work_after(dense, h, tau);
            recorder.row(at, Moment::Sample, &state, self.field.levels(tau, &y), lost);
            *next += 1;
        }
    }

    /// Notes the state as it is.
    pub fn note(&mut self, recorder: &mut Recorder<'_>, moment: Moment) {
        let (state, y) = (self.state(), self.y.clone());
        recorder.beyond.clone_from(&self.work);
        recorder.row(self.clock.now(), moment, &state, self.field.levels(0.0, &y), (y.lost, 0.0));
    }

    /// An event, its left and right limits noted.
    fn event(&mut self, recording: &mut Recording<'_, '_>, act: impl FnOnce(&mut Self)) -> Result<(), Stop> {
        let noting = recording.as_ref().is_some_and(|(.., noting)| *noting);
        let mut recorder = recording.as_mut().filter(|_| noting);
        if let Some((recorder, ..)) = &mut recorder {
            self.note(recorder, Moment::Before);
        }
        act(self);
        if let Some((recorder, ..)) = &mut recorder {
            self.note(recorder, Moment::After);
        }
        self.demand_numbers()?;
        self.guard.against_cascades(&self.clock, self.fastest, &self.state(), self.cell())
    }

    fn demand_numbers(&self) -> Result<(), Stop> {
        if self.y.is_finite() && self.rate.is_finite() {
            return Ok(());
        }
        Err(Stop::NotFinite { t: self.clock.now(), state: self.state().describe(), cell: self.cell() })
    }

    /// The state as the engine has it.
    pub fn state(&self) -> State {
        State { turns: self.turns.clone(), ..State::new(self.y.q.clone(), self.y.v.clone()) }
    }

    fn set(&mut self, state: State) {
        (self.y.q, self.y.v, self.turns) = (state.q, state.q_dot, state.turns);
    }

    /// The laws' values now.
    pub fn levels(&mut self) -> Vec<f64> {
        let y = self.y.clone();
        self.field.levels(0.0, &y).to_vec()
    }

    fn cell(&self) -> usize {
        cells::index(&self.field.laws, &self.field.bands)
    }

    /// Length of one turn of each coordinate (N): the pitch, where it rolls.
    pub fn turn_lengths(&self) -> Vector {
        law::turn_lengths(self.y.q.len(), &self.field.laws)
    }

    /// The name of the method at work.
    pub fn method(&self) -> &'static str {
        self.method.name()
    }
}
