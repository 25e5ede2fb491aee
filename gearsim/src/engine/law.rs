//! The state of one law during a run (a stiffness, a transmission error or a friction law): its levels, how it switches, and its
//! present cell.

use xprec::Df64;

use crate::engine::cells::{Number, Stand};
use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::jump::Surface;
use crate::engine::phase::{Pitch, turn};
use crate::engine::record::State;
use crate::engine::switch::{self, Switch};
use crate::engine::vector::Vector;
use crate::model::{Model, Role};
use crate::scene::Scene;
use crate::tolerance::phases;

/// A law: its levels, and its present cell.
#[derive(Debug, Clone)]
pub struct LawState {
    /// How it switches with the effects of the scene.
    pub switching: Switching,
    /// Its levels and the boundaries between them.
    pub pitch: Pitch,
    /// Geometry of its steps.
    pub surface: Surface,
    /// Index of the coordinate that is its phase.
    pub phase: usize,
    /// Whether it is a transmission error.
    pub is_error: bool,
    /// Whether this law counts the whole turns of its coordinate. At most one law per coordinate does.
    turns: bool,
    /// Length of one turn of the coordinate; 0 if turns are not counted.
    turn: f64,
    /// The phase as a function of time alone, for k(Omega0 t); `None` if the phase is a coordinate.
    frozen: Option<Frozen>,

    /// Index of its cell in the pitch. It is part of the state and never computed from the phase.
    pub cell: usize,
    /// Whole pitches of this law's cell that are not counted in `State::turns`; all of them if turns are not counted.
    ahead: i64,
}

/// A phase that depends on time alone.
#[derive(Debug, Clone, Copy)]
struct Frozen {
    speed: f64,
    /// Phase at t = 0, without whole pitches.
    origin: f64,
}

impl LawState {
    /// The laws at the start of a scene. The rolling coordinates of `state` keep only their remainders; their whole turns go to
    /// `State::turns`.
    ///
    /// # Errors
    /// If a phase is too large for its place in the pitch to be known, or an inertia overflows.
    pub fn begin(equations: &dyn Equations, scene: &Scene, state: &mut State) -> Result<Vec<LawState>, Refusal> {
        let q = state.q.clone();
        let mut laws = LawState::moving(equations, scene, state)?;
        laws.iter_mut().for_each(|law| law.freeze(&q, &state.q_dot));
        Ok(laws)
    }

    /// The same with phases that follow their coordinates, also where the scene freezes them.
    ///
    /// # Errors
    /// Those of [`LawState::begin`].
    pub fn moving(equations: &dyn Equations, scene: &Scene, state: &mut State) -> Result<Vec<LawState>, Refusal> {
        let model = scene.model;
        let absolute = state.q.clone();
        let mut laws: Vec<LawState> = vec![];
        for (i, (law, given)) in scene.present().enumerate() {
            let switching = equations.switching(i);
            let phase = model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
            // All laws on one coordinate are counted in the same turns.
            let on_phase: Vec<_> = scene.present().filter(|(other, _)| other.phase == law.phase).collect();
            let periods: Vec<f64> = on_phase.iter().map(|(other, _)| other.period).collect();
            let counted = turn::common(&periods).filter(|_| scene.effects.rolls(law, model));
            let which = on_phase.iter().position(|(other, _)| other.name == law.name).unwrap_or(0);
            let (period, times) = counted.as_ref().map_or((law.period, 1), |(turn, times)| (*turn, times[which]));
            let pitch = match switching {
                Switching::Never => Pitch::constant(given.mid(), period),
                _ => Pitch::counted(given, period, times * given.pitches),
            };
            let speed = state.q_dot[phase];
            if (absolute[phase] / law.period).abs() > phases::FARTHEST_START {
                return Err(Refusal::Far { coordinate: law.phase });
            }
            let (pitches, rest, mut cell) = pitch.locate(absolute[phase], speed);
            let first = laws.iter().find(|l| l.phase == phase);
            let turns = counted.is_some() && first.is_none();
            let turn = if counted.is_some() { period } else { 0.0 };
            if turns {
                state.q[phase] = rest;
                state.turns[phase] = pitches;
            }
            let surface = Surface::new(equations, i, &state.q);
            if !surface.compliance.is_finite() || surface.direction.iter().any(|x| !x.is_finite()) {
                let definite = equations.mass(&state.q).cholesky().is_some();
                return Err(if definite { Refusal::Overflow } else { Refusal::Mass });
            }
            // Laws on one coordinate may have their boundaries at different places.
            let ahead = match turns {
                true => 0,
                false if turn > 0.0 => {
                    let (ahead, here) = pitch.locate_from(state.turns[phase], state.q[phase], speed);
                    cell = here;
                    ahead
                }
                false => pitches,
            };
            let is_error = law.role == Role::Error;
            laws.push(LawState { switching, pitch, surface, phase, is_error, turns, turn, frozen: None, cell, ahead });
        }
        Ok(laws)
    }

    /// Freezes the phase at the coordinates `q` (n, with whole turns) if the scene freezes phases. From there it moves with the constant
    /// speed that it has in `q_dot`.
    pub fn freeze(&mut self, q: &[f64], q_dot: &[f64]) {
        if self.switching == Switching::ByTime {
            let speed = q_dot[self.phase];
            let (_, origin, cell) = self.pitch.locate(q[self.phase], speed);
            (self.frozen, self.cell, self.ahead) = (Some(Frozen { speed, origin }), cell, 0);
        }
    }

    /// Its value in the present cell if it is constant there, else its mean over the cell.
    pub fn level(&self) -> f64 {
        self.pitch.level(self.cell)
    }

    /// k, dk/ds and d²k/ds² at the value `q` of the coordinate and the time `t` [s].
    #[inline]
    pub fn course(&self, q: f64, t: f64) -> [f64; 3] {
        if self.pitch.steps_only() {
            return [self.level(), 0.0, 0.0];
        }
        let s = self.frozen.map_or(q, |frozen| frozen.origin + frozen.speed * t);
        self.pitch.course(self.cell, s - self.bounds().0)
    }

    /// The speed of its phase in a motion with the speeds `q_dot`.
    #[inline]
    pub fn speed(&self, q_dot: &[f64]) -> f64 {
        self.frozen.map_or(q_dot[self.phase], |frozen| frozen.speed)
    }

    /// Length of one turn of the coordinate; 0 if turns are not counted.
    pub fn turn(&self) -> f64 {
        self.turn
    }

    /// The step of its value at a side of the present cell.
    #[inline]
    pub fn step(&self, side: Side) -> f64 {
        self.pitch.step(self.cell, side)
    }

    /// Its level beyond a side of the present cell.
    pub fn level_beyond(&self, side: Side) -> f64 {
        self.pitch.level(self.pitch.beyond(self.cell, side).0)
    }

    /// The boundary of the present cell at a side, in the coordinate without its turns.
    #[inline]
    pub fn boundary(&self, side: Side) -> f64 {
        let (lower, upper) = self.bounds();
        if side == Side::Upper { upper } else { lower }
    }

    /// The lower and upper boundary of the present cell, in the coordinate without its turns.
    #[inline]
    pub fn bounds(&self) -> (f64, f64) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        let base = self.ahead as f64 * self.pitch.period();
        (base + lower, base + upper)
    }

    /// Whether this law's phase is at the same side of its cell when `other` reaches that side. The two steps are then one.
    #[inline]
    pub fn joins(&self, other: &LawState, side: Side, state: &State) -> bool {
        self.phase == other.phase && self.is_at(side, state, phases::SAME_BOUNDARY * self.pitch.width(self.cell))
    }

    /// The rounding error of a phase in the present cell [unit of the phase].
    #[inline]
    pub fn rounding(&self) -> f64 {
        f64::EPSILON * self.pitch.width(self.cell)
    }

    /// Whether the phase is within `slack` of that side of its cell.
    #[inline]
    pub fn is_at(&self, side: Side, state: &State, slack: f64) -> bool {
        if self.switching == Switching::Never || self.frozen.is_some() {
            return false;
        }
        let (lower, upper) = self.bounds();
        let gap = if side == Side::Upper { upper - state.q[self.phase] } else { state.q[self.phase] - lower };
        gap.abs() <= slack
    }

    /// The time at which a frozen phase next reaches a boundary, and the side; `None` if the phase moves with the motion.
    #[inline]
    pub fn next_switch(&self) -> Option<(Df64, Side)> {
        self.frozen.as_ref().map(|frozen| self.switch_of(frozen))
    }

    #[cold]
    fn switch_of(&self, frozen: &Frozen) -> (Df64, Side) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        let travelled = Df64::from(self.ahead as f64) * self.pitch.period();
        match frozen.speed {
            w if w > 0.0 => ((travelled + upper - frozen.origin) / w, Side::Upper),
            w if w < 0.0 => ((travelled + lower - frozen.origin) / w, Side::Lower),
            _ => (f64::INFINITY.into(), Side::Upper),
        }
    }

    /// Sets the phase to exactly the boundary of the cell.
    #[inline]
    pub fn snap(&self, side: Side, state: &mut State) {
        if self.frozen.is_none() {
            state.put(self.phase, self.boundary(side));
        }
    }

    /// Enters the cell beyond a side. Returns the turns by which it changed the count of the coordinate.
    #[inline]
    pub fn enter(&mut self, side: Side, state: &mut State) -> i64 {
        let (beyond, entered, turn) = self.pitch.beyond(self.cell, side);
        self.cell = beyond;
        if self.turns && self.frozen.is_none() {
            state.put(self.phase, entered);
            state.turns[self.phase] += turn;
            return turn;
        }
        self.ahead += turn;
        0
    }

    /// Adapts to `turns` that another law has counted on coordinate `phase`.
    pub fn follow(&mut self, phase: usize, turns: i64) {
        if !self.turns && self.phase == phase && self.frozen.is_none() {
            self.ahead -= turns;
        }
    }
}

/// Length of one turn of each coordinate (n); 0 if turns are not counted.
pub fn turn_lengths(n: usize, laws: &[LawState]) -> Vector {
    Vector::from_fn(n, |i| laws.iter().find(|law| law.phase == i).map_or(0.0, LawState::turn))
}

/// The laws that step when `law` reaches a boundary: this law, and those that join it.
#[inline]
pub fn met<'a>(laws: &'a [LawState], law: usize, side: Side, state: &'a State) -> impl Iterator<Item = usize> + 'a {
    (0..laws.len()).filter(move |&i| i == law || laws[i].joins(&laws[law], side, state))
}

/// Moves `law`, and the laws that join it, into the cells beyond its boundary.
#[inline(never)]
pub fn enter(laws: &mut [LawState], law: usize, side: Side, state: &mut State) {
    let entering: Vec<usize> = met(laws, law, side, state).collect();
    let phase = laws[law].phase;
    let turns: i64 = entering.into_iter().map(|i| laws[i].enter(side, state)).sum();
    laws.iter_mut().for_each(|law| law.follow(phase, turns));
}

/// The change dV of the potential energy at the step that `law` meets at `side` [J].
#[inline]
pub fn barrier(
    equations: &dyn Equations,
    (laws, switches, k): Stand<'_>,
    law: usize,
    side: Side,
    state: &State,
) -> f64 {
    let q = &state.q;
    if let [only] = laws
        && !moves(only, switches)
    {
        return equations.step(law, q, k, only.step(side));
    }
    if met(laws, law, side, state).any(|i| moves(&laws[i], switches)) {
        // The step of a transmission error may open or close contacts.
        return equations.potential(q, &beyond(equations, (laws, switches, k), law, side, state))
            - equations.potential(q, k);
    }
    // Apply the steps one after the other. If a stiffness and a transmission error step together, the change of V is not the sum of their
    // separate steps.
    let (mut k, mut dv) = (k.to_vec(), 0.0);
    for i in met(laws, law, side, state) {
        let step = laws[i].step(side);
        dv += equations.step(i, q, &k, step);
        k[i] += step;
    }
    dv
}

/// Whether the step of a law may change the mode of a switch.
#[inline]
fn moves(law: &LawState, switches: &[Switch]) -> bool {
    law.is_error && switches.iter().any(Switch::is_shifted)
}

/// The law values beyond the boundary, with the switches in the modes that follow.
pub fn beyond(
    equations: &dyn Equations,
    (laws, switches, k): Stand<'_>,
    law: usize,
    side: Side,
    state: &State,
) -> Vec<f64> {
    let mut beyond = k.to_vec();
    met(laws, law, side, state).for_each(|i| beyond[i] += laws[i].step(side));
    for mut switch in switches.iter().filter(|switch| switch.is_shifted()).cloned() {
        switch::settle(&mut switch, equations, (&state.q, &state.q_dot), &mut beyond, None);
    }
    beyond
}

/// The number of the cell beyond the boundary, with the switches in the given modes.
pub fn number_beyond(laws: &[LawState], switches: &[Switch], law: usize, side: Side, state: &State) -> Number {
    let met = |i: usize| i == law || laws[i].joins(&laws[law], side, state);
    let cell = |i: usize| if met(i) { laws[i].pitch.beyond(laws[i].cell, side).0 } else { laws[i].cell };
    Number::with(laws, switches, cell)
}

/// The switches in the modes that follow beyond the boundary; `None` if no mode can change there.
pub fn switches_beyond(
    equations: &dyn Equations,
    (laws, switches, k): Stand<'_>,
    law: usize,
    side: Side,
    state: &State,
) -> Option<Vec<Switch>> {
    if !met(laws, law, side, state).any(|i| moves(&laws[i], switches)) {
        return None;
    }
    let (mut beyond, mut switches) = (k.to_vec(), switches.to_vec());
    met(laws, law, side, state).for_each(|i| beyond[i] += laws[i].step(side));
    for switch in switches.iter_mut().filter(|switch| switch.is_shifted()) {
        switch::settle(switch, equations, (&state.q, &state.q_dot), &mut beyond, None);
    }
    Some(switches)
}

/// The laws that are not constant within their cells, in words; `None` if all are constant.
pub fn curved(model: &Model, laws: &[LawState]) -> Option<String> {
    let curved: Vec<_> = model.laws.iter().zip(laws).filter(|(_, law)| !law.pitch.steps_only()).collect();
    let names: Vec<_> = curved.iter().map(|(law, _)| format!("{}({})", law.name, law.phase)).collect();
    (!names.is_empty()).then(|| format!("{} varies within a cell, in V and its forces", names.join(", ")))
}
