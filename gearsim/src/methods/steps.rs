//! The solver by steps: a numerical method, the control of its steps, and its dense output.
//!
//! A step is as long as its error allows. The roots of the guards along its dense output are found with certainty
//! ([`crate::engine::root`]); the first one is the event. The step is then repeated so that it ends at this event. States at events
//! therefore have the accuracy of a step, not that of the dense output.

use std::sync::Arc;

use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{Effort, Motion, Solver};
use crate::engine::switch::Guards;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::methods::{ENERGY_GROWN, HELD_STEP, REJECTIONS, STEP_RELEASE, STIFF_STEPS};

use super::control::{Control, Steps};
use super::dense::Dense;
use super::field::Field;
use super::flow::Flow;
use super::radau::Radau;
use super::{Method, Trial};

mod guards;
mod landing;
mod motion;
mod work;

use motion::Step;

/// Where events are handled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Events {
    /// Where they happen.
    Located,
    /// After the step in which they happened, as in programs that do not locate events; for comparison.
    AfterStep,
}

/// How a run is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// How long steps are.
    pub steps: Steps,
    /// Where events are handled.
    pub events: Events,
    /// Whether an explicit method may be replaced by an implicit one where stability limits its steps.
    pub give_way: bool,
    /// Largest number of steps of a run, including rejected ones.
    pub most_steps: u64,
}

/// A solver by a numerical method.
pub struct BySteps<'a> {
    field: Field<'a>,
    method: Box<dyn Method>,
    settings: Settings,
    control: Control,
    /// The fastest rate of the motion at the start \[1/s\].
    fastest: f64,
    /// The energy from which the scale of the speeds follows \[J\].
    energy: f64,
    /// State and rate at the end of the last step; `None` in a new mode.
    last: Option<(Flow, Flow)>,
    /// Number of consecutive steps limited by stability.
    stiff: u32,
    effort: Effort,
}

impl<'a> BySteps<'a> {
    /// The solver of a run that begins with `now`, by `method`.
    pub fn new(now: &Hybrid<'a>, method: Box<dyn Method>, settings: Settings) -> Self {
        let equations = now.equations;
        let y = Flow { q: now.state.q.clone(), v: now.state.q_dot.clone(), lost: 0.0 };
        let mut field = Field::new(now);
        let rate = field.rate(0.0, &y);
        // The scale of each speed: the larger of the speed that the energy at the start allows, and the speed that the forces cause in the
        // time 1/`fastest`.
        let energy = equations.kinetic(&y.q, &y.v) + equations.potential(&y.q, &now.k);
        let [by_q, by_v] = field.jacobian(0.0, &y);
        let sum = |a: &Matrix| a.row_iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
        let swings = now.forcing.as_ref().map_or(0.0, |forcing| Forcing::fastest(forcing));
        let fastest = sum(&by_q).sqrt().max(sum(&by_v)).max(swings).max(1.0 / now.t_end);
        let speeds = allowed_speeds(&equations.mobility(&y.q), energy);
        let speeds = speeds.zip_map(&rate.v, |speed, a| speed.max(a.abs() / fastest));
        let control = Control::new(settings.steps, &y, &speeds, fastest, method.exponent(), now.t_end);
        let effort = Effort::default();
        BySteps { field, method, settings, control, fastest, energy, last: Some((y, rate)), stiff: 0, effort }
    }

    /// Updates the scale of the speeds from the kinetic energy at `y`, if it has grown by the factor [`ENERGY_GROWN`]. The reason: at
    /// first, a train that torques start from rest has only the energy of rounding errors.
    fn follow_energy(&mut self, y: &Flow) {
        let kinetic = self.field.equations.kinetic(&y.q, &y.v);
        if kinetic > ENERGY_GROWN * self.energy && kinetic.is_finite() {
            self.energy = kinetic;
            self.control.allow(&allowed_speeds(&self.field.equations.mobility(&y.q), kinetic));
        }
    }

    /// Tries steps of at most `horizon` \[s\] from the state `y` with the rate `rate`, until the error of one is accepted. Returns its
    /// length \[s\] and its trial.
    ///
    /// # Errors
    /// [`Stop::Steps`] if the run has used all its steps; [`Stop::Step`] if no step is accepted.
    fn attempt(&mut self, now: &Hybrid<'_>, y: &Flow, rate: &Flow, horizon: f64) -> Result<(f64, Trial), Stop> {
        let exponent = self.method.exponent();
        if horizon <= 0.0 {
            return Ok((0.0, Trial { end: y.clone(), rate: rate.clone(), error: 0.0, stiffness: 0.0 }));
        }
        let t = now.clock.now();
        for _ in 0..REJECTIONS {
            let h = self.control.step(horizon);
            if h < horizon && t + h <= t.next_up() && t > 0.0 {
                break;
            }
            if self.effort.steps + self.effort.rejected >= self.settings.most_steps {
                let (steps, state, cell) = (self.settings.most_steps, now.state.describe(), now.cell());
                return Err(Stop::Steps { t, steps, state, cell });
            }
            let trial = self.method.attempt(&mut self.field, y, rate, h, &self.control.allowed());
            // A step that fails is treated like one whose error is not a number.
            let usable = trial.filter(|trial| trial.end.is_finite() && trial.rate.is_finite());
            let error = usable.as_ref().map_or(f64::NAN, |trial| trial.error);
            if self.control.accepts(h, error, exponent) {
                let Some(trial) = usable else { break };
                self.effort.steps += 1;
                return Ok((h, trial));
            }
            self.effort.rejected += 1;
        }
        let (h, method) = (self.control.h, self.method.name());
        Err(Stop::Step { t, h, method, state: now.state.describe(), cell: now.cell() })
    }

    /// Replaces the method by the implicit one after [`STIFF_STEPS`] consecutive steps that stability limits.
    fn watch_stiffness(&mut self, t: f64, stiffness: f64) {
        let Steps::Adaptive(tolerance) = self.settings.steps else { return };
        if !self.settings.give_way || self.effort.replaced.is_some() {
            return;
        }
        self.stiff = if stiffness > self.method.stability() { self.stiff + 1 } else { 0 };
        if self.stiff >= STIFF_STEPS {
            self.method = Box::new(Radau::new(tolerance));
            self.effort.replaced = Some((t, self.method.name()));
        }
    }
}

/// The largest speed of each coordinate that an energy \[J\] allows, sqrt(2 E M⁻¹_ii) (N).
fn allowed_speeds(mobility: &Matrix, energy: f64) -> Vector {
    Vector::from_fn(mobility.nrows(), |i| (2.0 * energy * mobility[(i, i)]).sqrt())
}

impl Solver for BySteps<'_> {
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal> {
        now.guards = Arc::new(Guards::of(now.equations, &now.switches, &now.state.q, &now.k));
        self.field.enter(now);
        self.last = None;
        Ok(())
    }

    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop> {
        let y = Flow { q: now.state.q.clone(), v: now.state.q_dot.clone(), lost: 0.0 };
        self.field.begins = now.clock.now();
        // While contacts are held, the error of the motion may allow long steps. But the reaction follows the torques that vary, and its
        // guards are interpolated within a step. So the step is limited here.
        let swings = now.contact.as_ref().and(now.forcing.as_ref()).map_or(0.0, |forcing| Forcing::fastest(forcing));
        let horizon = if swings > 0.0 { horizon.min(HELD_STEP / swings) } else { horizon };
        let rate = match self.last.take() {
            Some((at, rate)) if at.q == y.q && at.v == y.v => rate,
            _ => self.field.rate(0.0, &y),
        };
        let (h, trial) = self.attempt(now, &y, &rate, horizon)?;
        let dense = match h > 0.0 {
            true => self.method.dense(&mut self.field, &y, h, &trial),
            false => Dense::new(std::slice::from_ref(&y)),
        };
        Ok(Box::new(Step { solver: self, now, start: y, rate, h, trial, dense, found: None, work: None }))
    }

    fn rate(&self) -> f64 {
        self.fastest
    }

    fn release(&self) -> f64 {
        STEP_RELEASE
    }

    fn locates(&self) -> bool {
        self.settings.events == Events::Located
    }

    fn effort(&self) -> Effort {
        self.effort
    }
}
