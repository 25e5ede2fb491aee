//! The state at t = 0 from the start that a scene states.

mod equilibrium;

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::{self, LawState};
use crate::engine::record::State;
use crate::engine::switch::{self, Switch};
use crate::engine::vector::Vector;
use crate::scene::Scene;

use equilibrium::{Equilibrium, Settled, courses};

/// A start: the state, the laws in their cells, and the switches in their modes.
#[derive(Clone)]
pub struct Initial {
    pub state: State,
    pub laws: Vec<LawState>,
    pub switches: Vec<Switch>,
    /// Other static equilibria that were found, in words; `None` if there are none, or no static start is asked for.
    pub others: Option<String>,
}

impl Initial {
    /// The coordinates, with their whole turns (N).
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

/// The speeds q' of the rigid motions by which a scene states its start (n) [SI].
pub fn rigid_speeds(equations: &dyn Equations, scene: &Scene) -> Vector {
    let mut q_dot = Vector::zeros(equations.coordinates());
    for (i, size) in scene.start.motions.iter().enumerate() {
        q_dot.add_times(*size, &equations.motion(i));
    }
    q_dot
}

/// The state at the start.
///
/// The speeds are those given, otherwise those of the rigid motions ([`rigid_speeds`]). Coordinates with the value `static` are where the
/// generalised forces on them vanish; the other coordinates and the speeds have the given values, and each law is in the cell of
/// its phase. Switches are in the modes that this state admits: flanks are in contact where the forces press them together. If there are several equilibria, it is
/// the one found from the stated value, or from zero.
///
/// # Errors
/// If the forces do not determine the equilibrium, or a phase is too large.
pub fn begin(equations: &dyn Equations, scene: &Scene) -> Result<Initial, Refusal> {
    let n = equations.coordinates();
    let mut q_dot = rigid_speeds(equations, scene);
    for (i, given) in scene.start.q_dot.iter().enumerate() {
        if let Some(given) = given {
            q_dot[i] = *given;
        }
    }
    let guess = Vector::from_fn(n, |i| scene.start.q[i].guess());
    let free: Vec<usize> = (0..n).filter(|&i| scene.start.q[i].is_static()).collect();
    let mut switches = Switch::all(equations, scene.model, &guess, &scene.model.in_contact([]));
    let (mut state, mut others) = (State::new(guess.clone(), q_dot.clone()), None);
    let laws = if free.is_empty() {
        LawState::begin(equations, scene, &mut state)?
    } else {
        let balance = Equilibrium { equations, scene, free: &free, q_dot };
        let settle = |switches: &[Switch]| balance.from(&guess, switches);
        let mut settled = in_modes(equations, scene, &mut switches, settle)?;
        let found = balance.others(&settled, &guess, &switches);
        others = balance.describe(&settled, &found);
        if !settled.stable
            && let Some(nearest) = found.iter().find(|other| other.stable)
        {
            // The equilibrium is unstable: take the nearest stable one.
            others = balance.describe(nearest, &[&found[..], &[settled]].concat());
            settled = nearest.clone();
        }
        state = settled.state;
        settled.laws
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
    Ok(Initial { state, laws, switches, others })
}

/// Finds the modes of the switches at an equilibrium. `settle` gives the equilibrium for given modes. A switch whose guards are violated
/// there is tried in its next mode.
fn in_modes(
    equations: &dyn Equations,
    scene: &Scene,
    switches: &mut [Switch],
    mut settle: impl FnMut(&[Switch]) -> Result<Settled, Refusal>,
) -> Result<Settled, Refusal> {
    switches.iter_mut().for_each(|switch| switch.mode = switch.rests().next().unwrap_or(0));
    let most: usize = switches.iter().map(|switch| switch.rests().count()).sum();
    // After all modes the last result is used.
    for _ in 0..most {
        let settled = settle(switches)?;
        let [mut k, ..] = courses(scene, &settled.state, &settled.laws);
        switches.iter().for_each(|switch| switch.write(&mut k));
        let at_rest = Vector::zeros(settled.state.q.len());
        let next = switches.iter_mut().find_map(|switch| {
            let exits = switch.exits(equations, &settled.state.q, &k);
            let guards = exits.iter().map(|exit| &exit.guard).filter(|guard| guard.on_reaction == 0.0);
            let violated =
                guards.into_iter().any(|guard| guard.value(&settled.state.q, &at_rest, &k) < -guard.rounding(&k));
            let next = switch.rests().find(|mode| *mode > switch.mode).filter(|_| violated)?;
            Some((switch, next))
        });
        let Some((switch, next)) = next else { return Ok(settled) };
        switch.mode = next;
    }
    settle(switches)
}

/// Whether the coordinates `q` with the speeds `q_dot` admit a mode of a switch: every guard of the coordinates alone is positive or about
/// to be. If `resting`, it may be zero.
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
