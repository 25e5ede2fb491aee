//! The state at t = 0, from the section `[start]` of a scene.

mod equilibrium;
mod rigid;

use crate::engine::equations::{self, Equations, Exit};
use crate::engine::error::Refusal;
use crate::engine::law::{self, LawState};
use crate::engine::record::State;
use crate::engine::switch::{self, Switch};
use crate::engine::vector::Vector;
use crate::scene::Scene;
use crate::tolerance::start::REACTION;

use equilibrium::{Equilibrium, Settled, courses};

/// A start: the state, the laws in their cells, and the switches in their modes.
#[derive(Clone)]
pub struct Initial {
    pub state: State,
    pub laws: Vec<LawState>,
    pub switches: Vec<Switch>,
}

impl Initial {
    /// The coordinates, with their whole turns (n).
    pub fn absolute(&self) -> Vector {
        self.state.unwrapped(&law::turn_lengths(self.state.q.len(), &self.laws))
    }

    /// The values of the laws, and those of the symbols of the switches.
    pub fn levels(&self, scene: &Scene) -> Vec<f64> {
        let [mut k, ..] = courses(scene, &self.state, &self.laws);
        self.switches.iter().for_each(|switch| switch.write(&mut k));
        k
    }
}

/// The speeds q' that the rigid motions in the section `[start]` of a scene give (n) [SI].
pub fn rigid_speeds(equations: &dyn Equations, scene: &Scene) -> Vector {
    let mut q_dot = Vector::zeros(equations.coordinates());
    for (i, size) in scene.start.motions.iter().enumerate() {
        q_dot.add_times(*size, &equations.motion(i));
    }
    q_dot
}

/// The content of the section `[start]` of a scene.
struct Stated {
    /// The stated coordinates (n). For a coordinate in static equilibrium: the value at which the search for it begins.
    guess: Vector,
    /// The speeds (n).
    q_dot: Vector,
    /// Indices of the coordinates in static equilibrium.
    free: Vec<usize>,
}

impl Stated {
    fn of(equations: &dyn Equations, scene: &Scene) -> Stated {
        let n = equations.coordinates();
        let mut q_dot = rigid_speeds(equations, scene);
        for (i, given) in scene.start.q_dot.iter().enumerate() {
            if let Some(given) = given {
                q_dot[i] = *given;
            }
        }
        let guess = Vector::from_fn(n, |i| scene.start.q[i].guess());
        Stated { guess, q_dot, free: (0..n).filter(|&i| scene.start.q[i].is_static()).collect() }
    }

    /// The equilibrium problem, and the equilibrium found from the guess. Sets the modes that the switches have there.
    fn settle<'a>(
        &'a self,
        equations: &'a dyn Equations,
        scene: &'a Scene,
        switches: &mut [Switch],
    ) -> Result<(Equilibrium<'a>, Settled), Refusal> {
        let balance = Equilibrium { equations, scene, free: &self.free, q_dot: self.q_dot.clone() };
        let settle = |switches: &[Switch]| balance.from(&self.guess, switches);
        let settled = in_modes(equations, scene, switches, (&self.guess, &self.q_dot), settle)?;
        Ok((balance, settled))
    }
}

/// The equilibrium at which a motion starts: the first one. If that is unstable, the nearest stable one of those `found`.
fn taken<'a>(first: &'a Settled, found: &'a [Settled]) -> &'a Settled {
    let stable = || found.iter().find(|other| other.stable);
    Some(first).filter(|first| first.stable).or_else(stable).unwrap_or(first)
}

/// Describes the static equilibria of a scene other than the one at which it starts. `None` if the search finds none, or if the start is
/// not static. The search solves for an equilibrium from many guesses, so it takes much longer than [`begin`].
///
/// # Errors
/// Those of [`begin`].
pub fn other_equilibria(equations: &dyn Equations, scene: &Scene) -> Result<Option<String>, Refusal> {
    let stated = Stated::of(equations, scene);
    if stated.free.is_empty() {
        return Ok(None);
    }
    let mut switches = Switch::all(equations, scene.model, &stated.guess, &scene.model.in_contact([]));
    let (balance, settled) = stated.settle(equations, scene, &mut switches)?;
    let found = balance.others(&settled, &stated.guess, &switches);
    Ok(balance.describe(taken(&settled, &found), &[&found[..], std::slice::from_ref(&settled)].concat()))
}

/// The state at the start.
///
/// The speeds are those given, otherwise those of the rigid motions ([`rigid_speeds`]). Coordinates with the value `static` are in
/// equilibrium: the generalised forces on them, without the part that accelerates rigid motions, are zero. The other coordinates have the
/// given values. Each law is in the cell of its phase. Switches are in the modes that this state admits: flanks are in contact where the
/// forces press them together. If there are several equilibria, the start is the one found from the stated value, or from zero.
///
/// # Errors
/// If the forces do not determine the equilibrium, or a phase is too large.
pub fn begin(equations: &dyn Equations, scene: &Scene) -> Result<Initial, Refusal> {
    let stated = Stated::of(equations, scene);
    let Stated { guess, q_dot, free } = &stated;
    let mut switches = Switch::all(equations, scene.model, guess, &scene.model.in_contact([]));
    let (state, laws) = if free.is_empty() {
        let mut state = State::new(guess.clone(), q_dot.clone());
        let laws = LawState::begin(equations, scene, &mut state)?;
        (state, laws)
    } else {
        let (balance, settled) = stated.settle(equations, scene, &mut switches)?;
        let found = if settled.stable { vec![] } else { balance.others(&settled, guess, &switches) };
        let Settled { state, laws, .. } = taken(&settled, &found).clone();
        (state, laws)
    };

    let [mut k, ..] = courses(scene, &state, &laws);
    for switch in &mut switches {
        let place = (&state.q[..], &state.q_dot[..]);
        let rests = || switch.rests().filter(|mode| !free.is_empty() && *mode == switch.mode);
        let mode = rests().find(|mode| is_at(switch, equations, *mode, place, &k, true));
        let mode = mode.or_else(|| switch.rests().find(|mode| is_at(switch, equations, *mode, place, &k, false)));
        switch.mode = mode.or_else(|| switch.rests().last()).unwrap_or(0);
        switch.write(&mut k);
        switch::settle(switch, equations, place, &mut k, None);
    }
    Ok(Initial { state, laws, switches })
}

/// Finds the modes of the switches at an equilibrium. `settle` gives the equilibrium for given modes. A switch whose deflection moves at
/// the speeds `q_dot` slides. Another switch is tried in its next mode if its guards are violated at the equilibrium, or if the force that
/// its hold must resist is too large.
fn in_modes(
    equations: &dyn Equations,
    scene: &Scene,
    switches: &mut [Switch],
    (guess, q_dot): (&Vector, &Vector),
    mut settle: impl FnMut(&[Switch]) -> Result<Settled, Refusal>,
) -> Result<Settled, Refusal> {
    let mut state = State::new(guess.clone(), q_dot.clone());
    let laws = LawState::moving(equations, scene, &mut state)?;
    let [k, ..] = courses(scene, &state, &laws);
    for switch in &mut *switches {
        let slides = sliding(switch, equations, (&state.q, q_dot), &k);
        switch.mode = slides.or_else(|| switch.rests().next()).unwrap_or(0);
    }
    let most: usize = switches.iter().map(|switch| switch.rests().count() + switch.modes()).sum();
    // If no combination satisfies all guards, the last result is used.
    for _ in 0..most {
        let settled = settle(switches)?;
        let [mut k, ..] = courses(scene, &settled.state, &settled.laws);
        switches.iter().for_each(|switch| switch.write(&mut k));
        let at_rest = Vector::zeros(settled.state.q.len());
        let next = switches.iter_mut().enumerate().find_map(|(i, switch)| {
            let reaction = settled.reactions.iter().find(|(of, _)| *of == i).map(|(_, r)| *r);
            let exits = switch.exits(equations, &settled.state.q, &k);
            let violated = exits.iter().find(|Exit { guard, .. }| {
                let resisted = match (guard.on_reaction == 0.0, reaction) {
                    (true, _) => 0.0,
                    (false, Some(r)) => guard.on_reaction * r,
                    (false, None) => return false,
                };
                let rounding = equations::rounding(guard, &k) + REACTION * resisted.abs();
                guard.value(&settled.state.q, &at_rest, &k) + resisted < -rounding
            })?;
            // A switch that slides, or whose hold breaks, goes where its guard leads. One that rests is tried in its next mode of rest.
            let next = match violated.guard.on_reaction != 0.0 || !switch.here().rests {
                true => Some(violated.beyond),
                false => switch.rests().find(|mode| *mode > switch.mode),
            }?;
            Some((switch, next))
        });
        let Some((switch, next)) = next else { return Ok(settled) };
        switch.mode = next;
    }
    settle(switches)
}

/// The mode in which a switch that can hold its rate slides at the speeds `q_dot`; `None` if it does not slide.
fn sliding(switch: &Switch, equations: &dyn Equations, (q, q_dot): (&[f64], &[f64]), k: &[f64]) -> Option<usize> {
    (0..switch.modes()).find(|mode| {
        let (there, k) = switch.in_mode(*mode, k);
        let rate = there.before_hold(*mode, equations, q, &k).filter(|_| !there.here().held);
        rate.is_some_and(|rate| rate.dot(q_dot) > switch::rest(equations, (q, q_dot), &rate))
    })
}

/// Whether the coordinates `q` with the speeds `q_dot` admit a mode of a switch: every guard that depends on the coordinates only is
/// positive, or zero and increasing. If `resting`, zero is sufficient.
fn is_at(
    switch: &Switch,
    equations: &dyn Equations,
    mode: usize,
    (q, q_dot): (&[f64], &[f64]),
    k: &[f64],
    resting: bool,
) -> bool {
    let (switch, k) = switch.in_mode(mode, k);
    let exits = switch.exits(equations, q, &k);
    let guards =
        exits.iter().map(|exit| &exit.guard).filter(|guard| guard.on_reaction == 0.0 && guard.on_speed.amax() == 0.0);
    guards.into_iter().all(|guard| {
        let value = guard.value(q, q_dot, &k);
        value > 0.0 || (value == 0.0 && (resting || guard.on_q.dot(q_dot) > 0.0))
    })
}
