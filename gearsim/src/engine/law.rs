//! One stepping stiffness under way: its steps, how they switch, and where it stands between them.

use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, Switching};
use crate::engine::jump::Surface;
use crate::engine::phase::Pitch;
use crate::engine::record::State;
use crate::scene::Scene;

/// A stepping stiffness: what it is, and where it stands.
#[derive(Debug, Clone)]
pub struct Law<const N: usize> {
    /// How it switches with the effects in force.
    pub switching: Switching,
    /// Its levels and boundaries.
    pub pitch: Pitch,
    /// Geometry of its steps.
    pub surface: Surface<N>,
    /// Coordinate that is its phase.
    pub phase: usize,
    /// Whether it counts off the whole turns of that coordinate; one law a coordinate does.
    turns: bool,
    /// Length of a turn of the coordinate, 0 where none are counted.
    turn: f64,
    /// The phase that runs by time alone, k(Omega0 t).
    frozen: Option<Frozen>,

    /// Cell of the pitch that it is in. State: never worked out from the phase.
    pub cell: usize,
    /// Whole pitches that the phase has gone.
    pitches: i64,
}

/// The phase that runs by time alone.
#[derive(Debug, Clone, Copy)]
struct Frozen {
    speed: f64,
    /// Remainder and pitches at t = 0.
    origin: f64,
    pitches: i64,
}

impl<const N: usize> Law<N> {
    /// The laws of a model as the scene starts them; `state`'s rolling coordinates are left with their remainders.
    pub fn begin(equations: &dyn Equations<N>, scene: &Scene, state: &mut State<N>) -> Vec<Law<N>> {
        let model = scene.model;
        let absolute = state.q;
        let mut laws: Vec<Law<N>> = vec![];
        for (i, law) in model.laws.iter().enumerate() {
            let switching = equations.switching(i);
            let pitch = match switching {
                Switching::Never => Pitch::constant(scene.laws[i].mid(), law.period),
                _ => Pitch::new(&scene.laws[i], law.period),
            };
            let phase = model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
            let speed = state.q_dot[phase];
            let (pitches, rest, cell) = pitch.locate(absolute[phase], speed);
            let first = laws.iter().find(|l| l.phase == phase);
            let turns = law.rolling && first.is_none();
            let turn = first.map_or(if law.rolling { law.period } else { 0.0 }, |l| l.turn);
            if turns {
                state.q[phase] = rest;
                state.turns[phase] = pitches;
            }
            let frozen = (switching == Switching::ByTime).then_some(Frozen { speed, origin: rest, pitches });
            let surface = Surface::new(equations, i);
            laws.push(Law { switching, pitch, surface, phase, turns, turn, frozen, cell, pitches });
        }
        laws
    }

    /// The stiffness now.
    pub fn level(&self) -> f64 {
        self.pitch.level(self.cell)
    }

    /// Length of one turn of the coordinate, 0 where none are counted.
    pub fn turn(&self) -> f64 {
        self.turn
    }

    /// The step of the stiffness beyond a side of the present cell.
    pub fn step(&self, side: Side) -> f64 {
        self.pitch.level(self.pitch.beyond(self.cell, side).0) - self.level()
    }

    /// Boundaries of the present cell, in the coordinate less its turns.
    #[inline]
    pub fn bounds(&self, state: &State<N>) -> (f64, f64) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        // Both products are rounded alike: where turns are pitches, nothing is left of them.
        let base = self.pitches as f64 * self.pitch.period() - state.turns[self.phase] as f64 * self.turn;
        if base.is_nan() { (lower, upper) } else { (base + lower, base + upper) }
    }

    /// Whether this law's phase is at that side of its cell too, on the way of `other`, which met it: one step for both.
    #[inline]
    pub fn joins(&self, other: &Law<N>, side: Side, state: &State<N>) -> bool {
        if self.phase != other.phase || self.switching == Switching::Never || self.frozen.is_some() {
            return false;
        }
        let (lower, upper) = self.bounds(state);
        let gap = if side == Side::Upper { upper - state.q[self.phase] } else { state.q[self.phase] - lower };
        gap.abs() <= 4.0 * f64::EPSILON * (upper - lower)
    }

    /// When a frozen phase next meets a boundary, and which; `None` where the phase moves with the motion.
    pub fn next_switch(&self) -> Option<(f64, Side)> {
        let frozen = self.frozen?;
        let (lower, upper) = self.pitch.bounds(self.cell);
        let travelled = (self.pitches - frozen.pitches) as f64 * self.pitch.period();
        Some(match frozen.speed {
            w if w > 0.0 => ((travelled + (upper - frozen.origin)) / w, Side::Upper),
            w if w < 0.0 => ((travelled + (lower - frozen.origin)) / w, Side::Lower),
            _ => (f64::INFINITY, Side::Upper),
        })
    }

    /// Puts the phase exactly on a boundary of the cell.
    #[inline]
    pub fn snap(&self, side: Side, state: &mut State<N>) {
        if self.frozen.is_none() {
            let (lower, upper) = self.bounds(state);
            state.q[self.phase] = if side == Side::Upper { upper } else { lower };
        }
    }

    /// Goes on into the cell beyond a side.
    #[inline]
    pub fn enter(&mut self, side: Side, state: &mut State<N>) {
        let (beyond, entered, turn) = self.pitch.beyond(self.cell, side);
        self.cell = beyond;
        self.pitches += turn;
        if self.turns && self.frozen.is_none() {
            state.q[self.phase] = entered;
            state.turns[self.phase] += turn;
        }
    }
}

/// What steps where `law` meets a boundary: it, and whatever joins it.
#[inline]
pub fn met<'a, const N: usize>(
    laws: &'a [Law<N>],
    law: usize,
    side: Side,
    state: &'a State<N>,
) -> impl Iterator<Item = usize> + 'a {
    (0..laws.len()).filter(move |&i| i == law || laws[i].joins(&laws[law], side, state))
}

/// What the potential energy gains there, dV [J].
#[inline]
pub fn barrier<const N: usize>(
    equations: &dyn Equations<N>,
    laws: &[Law<N>],
    law: usize,
    side: Side,
    state: &State<N>,
) -> f64 {
    met(laws, law, side, state).map(|i| equations.step(i, &state.q.data.0[0], laws[i].step(side))).sum()
}
