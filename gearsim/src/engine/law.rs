//! One stepping law under way, a stiffness, a transmission error or one of friction: its steps, how they switch, and where it stands between them.

use xprec::Df64;

use crate::engine::cells::Stand;
use crate::engine::crossing::Side;
use crate::engine::dead_band::DeadBand;
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::jump::Surface;
use crate::engine::phase::{Pitch, turn};
use crate::engine::record::State;
use crate::engine::vector::Vector;
use crate::model::{Model, Role};
use crate::scene::Scene;
use crate::tolerance::phases;

/// A stepping law: what it is, and where it stands.
#[derive(Debug, Clone)]
pub struct Law {
    /// How it switches with the effects in force.
    pub switching: Switching,
    /// Its levels and boundaries.
    pub pitch: Pitch,
    /// Geometry of its steps.
    pub surface: Surface,
    /// Coordinate that is its phase.
    pub phase: usize,
    /// Whether it is a transmission error.
    pub is_error: bool,
    /// Whether it counts off the whole turns of that coordinate; one law a coordinate does.
    turns: bool,
    /// Length of a turn of the coordinate, 0 where none are counted.
    turn: f64,
    /// The phase that runs by time alone, k(Omega0 t).
    frozen: Option<Frozen>,

    /// Cell of the pitch that it is in. State: never worked out from the phase.
    pub cell: usize,
    /// Pitches that its cell is beyond the turns counted off the coordinate; all of them, where none are counted.
    ahead: i64,
}

/// The phase that runs by time alone.
#[derive(Debug, Clone, Copy)]
struct Frozen {
    speed: f64,
    /// Remainder at t = 0.
    origin: f64,
}

impl Law {
    /// The laws that a scene has, as it starts them; `state`'s rolling coordinates are left with their remainders.
    ///
    /// # Errors
    /// Where a phase is so far off that its place in the pitch is lost, or an inertia beyond numbers.
    pub fn begin(equations: &dyn Equations, scene: &Scene, state: &mut State) -> Result<Vec<Law>, Refusal> {
        let model = scene.model;
        let absolute = state.q.clone();
        let mut laws: Vec<Law> = vec![];
        for (i, (law, given)) in scene.present().enumerate() {
            let switching = equations.switching(i);
            let phase = model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
            // Laws on one coordinate are counted in one unit.
            let on_phase: Vec<_> = scene.present().filter(|(other, _)| other.phase == law.phase).collect();
            let periods: Vec<f64> = on_phase.iter().map(|(other, _)| other.period).collect();
            let counted = turn::common(&periods).filter(|_| law.rolling);
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
            let frozen = (switching == Switching::ByTime).then_some(Frozen { speed, origin: rest });
            let surface = Surface::new(equations, i);
            if !surface.compliance.is_finite() || surface.direction.iter().any(|x| !x.is_finite()) {
                return Err(Refusal::Overflow);
            }
            // They may begin their pitches at different places of it.
            let ahead = match (frozen, turns) {
                (Some(_), _) | (None, true) => 0,
                (None, false) if turn > 0.0 => {
                    let (ahead, here) = pitch.locate_from(state.turns[phase], state.q[phase], speed);
                    cell = here;
                    ahead
                }
                (None, false) => pitches,
            };
            let is_error = law.role == Role::Error;
            laws.push(Law { switching, pitch, surface, phase, is_error, turns, turn, frozen, cell, ahead });
        }
        Ok(laws)
    }

    /// Its value now, where it is constant in its cells; else its mean in this one.
    pub fn level(&self) -> f64 {
        self.pitch.level(self.cell)
    }

    /// k, dk/ds and d²k/ds² where the coordinate is `q` at the time `t`.
    #[inline]
    pub fn course(&self, q: f64, t: f64) -> [f64; 3] {
        if self.pitch.steps_only() {
            return [self.level(), 0.0, 0.0];
        }
        let s = self.frozen.map_or(q, |frozen| frozen.origin + frozen.speed * t);
        self.pitch.course(self.cell, s - self.bounds().0)
    }

    /// Length of one turn of the coordinate, 0 where none are counted.
    pub fn turn(&self) -> f64 {
        self.turn
    }

    /// The step of its value beyond a side of the present cell.
    #[inline]
    pub fn step(&self, side: Side) -> f64 {
        self.pitch.step(self.cell, side)
    }

    /// The same in twice the digits.
    pub fn exact_step(&self, side: Side) -> Df64 {
        Df64::from(self.pitch.level(self.pitch.beyond(self.cell, side).0)) - self.level()
    }

    /// The boundary of the present cell on a side, in the coordinate less its turns.
    #[inline]
    pub fn boundary(&self, side: Side) -> f64 {
        let (lower, upper) = self.bounds();
        if side == Side::Upper { upper } else { lower }
    }

    /// Boundaries of the present cell, in the coordinate less its turns.
    #[inline]
    pub fn bounds(&self) -> (f64, f64) {
        let (lower, upper) = self.pitch.bounds(self.cell);
        let base = self.ahead as f64 * self.pitch.period();
        (base + lower, base + upper)
    }

    /// Whether this law's phase is at that side of its cell too, on the way of `other`, which met it: one step for both.
    #[inline]
    pub fn joins(&self, other: &Law, side: Side, state: &State) -> bool {
        self.phase == other.phase && self.is_at(side, state, phases::SAME_BOUNDARY * self.pitch.width(self.cell))
    }

    /// One rounding of a phase in the present cell.
    #[inline]
    pub fn rounding(&self) -> f64 {
        f64::EPSILON * self.pitch.width(self.cell)
    }

    /// Whether the phase is at that side of its cell, to within `slack`.
    #[inline]
    pub fn is_at(&self, side: Side, state: &State, slack: f64) -> bool {
        if self.switching == Switching::Never || self.frozen.is_some() {
            return false;
        }
        let (lower, upper) = self.bounds();
        let gap = if side == Side::Upper { upper - state.q[self.phase] } else { state.q[self.phase] - lower };
        gap.abs() <= slack
    }

    /// When a frozen phase next meets a boundary, and which; `None` where the phase moves with the motion.
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

    /// Puts the phase exactly on a boundary of the cell.
    #[inline]
    pub fn snap(&self, side: Side, state: &mut State) {
        if self.frozen.is_none() {
            state.q[self.phase] = self.boundary(side);
        }
    }

    /// Goes on into the cell beyond a side. Gives the turns that this counts off the coordinate, for the others on it.
    #[inline]
    pub fn enter(&mut self, side: Side, state: &mut State) -> i64 {
        let (beyond, entered, turn) = self.pitch.beyond(self.cell, side);
        self.cell = beyond;
        if self.turns && self.frozen.is_none() {
            state.q[self.phase] = entered;
            state.turns[self.phase] += turn;
            return turn;
        }
        self.ahead += turn;
        0
    }

    /// Another law has counted `turns` off coordinate `phase`.
    pub fn follow(&mut self, phase: usize, turns: i64) {
        if !self.turns && self.phase == phase && self.frozen.is_none() {
            self.ahead -= turns;
        }
    }
}

/// Length of one turn of each coordinate (N), 0 where none are counted.
pub fn turn_lengths(n: usize, laws: &[Law]) -> Vector {
    Vector::from_fn(n, |i| laws.iter().find(|law| law.phase == i).map_or(0.0, Law::turn))
}

/// What steps where `law` meets a boundary: it, and whatever joins it.
#[inline]
pub fn met<'a>(laws: &'a [Law], law: usize, side: Side, state: &'a State) -> impl Iterator<Item = usize> + 'a {
    (0..laws.len()).filter(move |&i| i == law || laws[i].joins(&laws[law], side, state))
}

/// Takes `law`, and whatever joins it at its boundary, on into the cells beyond.
#[inline(never)]
pub fn enter(laws: &mut [Law], law: usize, side: Side, state: &mut State) {
    let entering: Vec<usize> = met(laws, law, side, state).collect();
    let phase = laws[law].phase;
    let turns: i64 = entering.into_iter().map(|i| laws[i].enter(side, state)).sum();
    laws.iter_mut().for_each(|law| law.follow(phase, turns));
}

/// What the potential energy gains there, dV [J].
#[inline]
pub fn barrier(equations: &dyn Equations, (laws, bands, k): Stand<'_>, law: usize, side: Side, state: &State) -> f64 {
    let q = &state.q;
    if let [only] = laws
        && !moves(only, bands)
    {
        return equations.step(law, q, k, only.step(side));
    }
    if met(laws, law, side, state).any(|i| moves(&laws[i], bands)) {
        // Flanks part or meet with the step.
        return equations.potential(q, &beyond((laws, bands, k), law, side, state)) - equations.potential(q, k);
    }
    // One after the other: a stiffness and a transmission error that step together are more than each by itself.
    let (mut k, mut dv) = (k.to_vec(), 0.0);
    for i in met(laws, law, side, state) {
        let step = laws[i].step(side);
        dv += equations.step(i, q, &k, step);
        k[i] += step;
    }
    dv
}

/// Whether a law moves the edges of a dead band.
#[inline]
fn moves(law: &Law, bands: &[DeadBand]) -> bool {
    law.is_error && !bands.is_empty()
}

/// The law values beyond that boundary.
pub fn beyond((laws, bands, k): Stand<'_>, law: usize, side: Side, state: &State) -> Vec<f64> {
    let mut beyond = k.to_vec();
    met(laws, law, side, state).for_each(|i| beyond[i] += laws[i].step(side));
    for mut band in bands.iter().filter(|band| !band.errors.is_empty()).cloned() {
        band.displace(&beyond, &state.q);
        band.write(&mut beyond);
    }
    beyond
}

/// What is not constant within the cells of `laws`, in words; `None` where all stiffnesses are.
pub fn curved(model: &Model, laws: &[Law]) -> Option<String> {
    let curved: Vec<_> = model.laws.iter().zip(laws).filter(|(_, law)| !law.pitch.steps_only()).collect();
    let names: Vec<_> = curved.iter().map(|(law, _)| format!("{}({})", law.name, law.phase)).collect();
    (!names.is_empty()).then(|| format!("{} varies within a cell, in V and its forces", names.join(", ")))
}
