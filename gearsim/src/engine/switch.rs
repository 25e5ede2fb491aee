//! Switches: modes of a deflection, each a linear cell, until a linear function of the state becomes zero. Play, a clipped damper, a clutch
//! and dry friction are such switches. The modes and their guards are derived ([`Equations::mode`], [`Equations::exits`]). This module does
//! not depend on their meaning.
//!
//! A mode lasts while the guard of each of its exits is >= 0. Where a guard becomes zero, the mode beyond this exit follows. The guards of
//! the new mode are then compared with the state: if one is already violated, this mode is left at once ([`settle`]). Energies do not step
//! at an exit (this is proved by the derivation), so there is no impulse. A step of a transmission error may violate a guard, and V then
//! steps with the mode. This is an impulse like any other ([`law::barrier`](crate::engine::law::barrier)).
//!
//! A deflection may bend: it is not linear in the coordinates, e.g. along a line of action that turns with the centres. Its guards are then
//! those of its tangent at a place, which are exact there. Methods by steps follow them along the motion.
//!
//! A mode may hold its deflection: x' = 0, by a reaction ([`crate::engine::contact`]).

use std::sync::Arc;

use smallvec::SmallVec;

use crate::engine::equations::{self, Affine, Deflection, Equations, Exit};
use crate::engine::vector::Vector;
use crate::model::{Model, SwitchMode};
use crate::tolerance::events::{AT_REST, SAME_GUARD};

/// A switch under way.
#[derive(Debug, Clone)]
pub struct Switch {
    /// Its index in the model.
    pub index: usize,
    /// Index of the first of its values among the law values.
    at: usize,
    /// Gradient of its deflection (n).
    pub normal: Vector,
    /// Whether laws shift its deflection.
    shifted: bool,
    /// The present mode. It is part of the state and not computed from the deflection.
    pub mode: usize,
    /// The modes, and the values of its symbols in each.
    modes: Arc<(&'static [SwitchMode], Vec<Vec<f64>>)>,
    /// Time spent in each mode until it was last left [s].
    spent: Vec<f64>,
    /// Times that each mode was entered by an impact.
    impacts: Vec<u64>,
    /// When the present mode began [s].
    since: f64,
    /// Whether its deflection has been away from the modes whose entry counts, by more than rounding errors, since the present mode began.
    pub parted: bool,
}

impl Switch {
    /// The switches of a model that its effects need, each in its first mode, at the coordinates `q` and the law values `k`.
    pub fn all(equations: &dyn Equations, model: &Model, q: &[f64], k: &[f64]) -> Vec<Switch> {
        let mut at = model.laws.len();
        let mut all = vec![];
        for (index, switch) in model.switches.iter().enumerate() {
            let values: Option<Vec<_>> = (0..switch.modes.len()).map(|mode| equations.mode(index, mode)).collect();
            if let Some(values) = values {
                let Deflection { normal, errors, .. } = equations.deflection(equations.switched(index), q, k);
                let modes = Arc::new((switch.modes, values));
                let (spent, impacts) = (vec![0.0; switch.modes.len()], vec![0; switch.modes.len()]);
                let shifted = !errors.is_empty();
                all.push(Switch {
                    index,
                    at,
                    normal,
                    shifted,
                    mode: 0,
                    modes,
                    spent,
                    impacts,
                    since: 0.0,
                    parted: false,
                });
            }
            at += switch.neutral.len();
        }
        all
    }

    /// Index of the first of its values among the law values.
    pub fn place(&self) -> usize {
        self.at
    }

    /// Number of its modes.
    pub fn modes(&self) -> usize {
        self.modes.0.len()
    }

    /// Its present mode.
    pub fn here(&self) -> &'static SwitchMode {
        &self.modes.0[self.mode]
    }

    /// When its present mode began \[s\].
    pub fn since(&self) -> f64 {
        self.since
    }

    /// Whether an entry into `mode` from the present mode counts as an impact.
    pub fn counts(&self, mode: usize) -> bool {
        self.modes.0[mode].counts_after(self.here())
    }

    /// Counts the exit from the mode `before` to the present mode if it is an impact: the mode counts its entries, and the deflection had
    /// parted. Returns whether it is.
    pub fn count(&mut self, before: usize) -> bool {
        let is_impact = self.parted && self.here().counts_after(&self.modes.0[before]);
        self.impacts[self.mode] += u64::from(is_impact);
        is_impact
    }

    /// For each mode that counts its entries: what it counts, and how often it was entered by an impact.
    pub fn impacts(&self) -> impl Iterator<Item = (&'static str, u64)> {
        self.modes.0.iter().zip(&self.impacts).filter_map(|(mode, impacts)| Some((mode.counts?, *impacts)))
    }

    /// Notes that the mode `before` ended at the time `now` \[s\], if the present mode is another one.
    pub fn leave(&mut self, before: usize, now: f64) {
        if self.mode != before {
            self.spend_in(before, now);
            self.parted = false;
        }
    }

    /// Adds the time until `now` \[s\] to that of the present mode, which may end now.
    pub fn spend(&mut self, now: f64) {
        self.spend_in(self.mode, now);
    }

    fn spend_in(&mut self, mode: usize, now: f64) {
        self.spent[mode] += now - self.since;
        self.since = now;
    }

    /// The time spent in each mode until the last [`Switch::spend`] \[s\].
    pub fn spent(&self) -> impl Iterator<Item = (&'static SwitchMode, f64)> {
        self.modes.0.iter().zip(self.spent.iter().copied())
    }

    /// Whether transmission errors shift its deflection.
    pub fn is_shifted(&self) -> bool {
        self.shifted
    }

    /// The same switch in another mode, and the law values `k` there.
    pub fn in_mode(&self, mode: usize, k: &[f64]) -> (Switch, Vec<f64>) {
        let (other, mut k) = (Switch { mode, ..self.clone() }, k.to_vec());
        other.write(&mut k);
        (other, k)
    }

    /// Writes the values of its symbols to their places in the law values `k`.
    pub fn write(&self, k: &mut [f64]) {
        let values = &self.modes.1[self.mode];
        k[self.at..self.at + values.len()].copy_from_slice(values);
    }

    /// The modes in which a static equilibrium may be.
    pub fn rests(&self) -> impl Iterator<Item = usize> + use<> {
        let modes = self.modes.0;
        (0..modes.len()).filter(move |mode| modes[*mode].rests)
    }

    /// What can end its present mode, at the coordinates `q` and the law values `k`.
    pub fn exits(&self, equations: &dyn Equations, q: &[f64], k: &[f64]) -> Vec<Exit> {
        equations.exits(self.index, self.mode, q, k)
    }

    /// The gradient of the rate that its present mode holds, at the coordinates `q` and the law values `k`. A hold begins at a zero of this
    /// rate. It is the rate of the deflection, or another rate with friction laws as factors. The gradient has the direction of the motion
    /// that begins when the reaction exceeds its bound.
    pub fn held(&self, equations: &dyn Equations, q: &[f64], k: &[f64]) -> Vector {
        let prevented = self.exits(equations, q, k).into_iter().find(|exit| exit.guard.on_reaction < 0.0);
        let back = prevented.and_then(|exit| self.before_hold(exit.beyond, equations, q, k));
        back.unwrap_or_else(|| self.normal.clone())
    }

    /// The gradient of the rate whose zero leads from `mode` to a mode that holds; `None` if no exit does.
    pub fn before_hold(&self, mode: usize, equations: &dyn Equations, q: &[f64], k: &[f64]) -> Option<Vector> {
        let exits = equations.exits(self.index, mode, q, k);
        let exit = exits.into_iter().find(|exit| self.modes.0[exit.beyond].held)?;
        Some(exit.guard.on_speed)
    }

    /// The gradient of the rate that its present mode holds, or whose zero leads to a mode that holds; of its deflection if there is no
    /// such rate.
    pub fn gradient(&self, equations: &dyn Equations, q: &[f64], k: &[f64]) -> Vector {
        if self.here().held {
            return self.held(equations, q, k);
        }
        let rate = self.before_hold(self.mode, equations, q, k).filter(|rate| rate.amax() > 0.0);
        rate.unwrap_or_else(|| self.normal.clone())
    }

    /// How fast the factors of the held rate change along the motion `q`, `q_dot`, times the speeds: N'ᵀq'. `k_dot` are the rates of the
    /// law values, in which a rate is linear.
    pub fn drift(&self, equations: &dyn Equations, (q, q_dot): (&[f64], &[f64]), k_dot: &[f64]) -> f64 {
        let none = vec![0.0; k_dot.len()];
        self.held(equations, q, k_dot).dot(q_dot) - self.held(equations, q, &none).dot(q_dot)
    }

    /// Whether laws are factors of the held rate.
    pub fn turns(&self, equations: &dyn Equations, q: &[f64], k: &[f64]) -> bool {
        (self.held(equations, q, k) - &self.held(equations, q, &vec![0.0; k.len()])).amax() > 0.0
    }

    /// Whether the rate that it holds is zero, up to the rounding errors of the speeds. The forces have rounding errors too, so that the
    /// speeds of a train at rest under load have errors in proportion to its strain.
    pub fn is_at_rest(&self, equations: &dyn Equations, (q, q_dot): (&[f64], &[f64]), k: &[f64]) -> bool {
        let normal = self.held(equations, q, k);
        let energy = equations.kinetic(q, q_dot) + equations.potential(q, k).max(0.0);
        normal.dot(q_dot).abs() <= AT_REST * allowed(equations, (q, energy), &normal)
    }
}

/// The largest rate along `normal` (n) that the kinetic energy of the state `q`, `q_dot` allows: sqrt(2 T n.M⁻¹n).
pub fn fastest(equations: &dyn Equations, (q, q_dot): (&[f64], &[f64]), normal: &Vector) -> f64 {
    allowed(equations, (q, equations.kinetic(q, q_dot)), normal)
}

/// The largest rate along `normal` (n) that the kinetic energy `energy` \[J\] allows at `q`.
fn allowed(equations: &dyn Equations, (q, energy): (&[f64], f64), normal: &Vector) -> f64 {
    (2.0 * energy * normal.dot(&(&equations.mobility(q) * normal))).sqrt()
}

/// The rate along `normal` (n) up to which a deflection counts as at rest in the state `q`, `q_dot`: rounding errors of the speeds are
/// smaller.
pub fn rest(equations: &dyn Equations, state: (&[f64], &[f64]), normal: &Vector) -> f64 {
    AT_REST * fastest(equations, state, normal)
}

/// The guards of the present modes of switches.
#[derive(Debug, Clone, Default)]
pub struct Guards {
    /// The exits of each switch that a motion can take.
    pub exits: Vec<SmallVec<[Exit; 2]>>,
    /// The dissipative forces of switches that are not zero.
    lost: Vec<Loss>,
}

/// The dissipative force of a switch against its deflection x: constant + slope x.
#[derive(Debug, Clone)]
struct Loss {
    over: Deflection,
    constant: f64,
    slope: f64,
}

impl Guards {
    /// The guards of `switches` at the coordinates `q` and the law values `k`.
    pub fn of(equations: &dyn Equations, switches: &[Switch], q: &[f64], k: &[f64]) -> Self {
        let exits = |switch: &Switch| watched(switch.exits(equations, q, k));
        let lost = |switch: &Switch| {
            let [constant, slope] = equations.lost(switch.index, k);
            let over = || equations.deflection(equations.switched(switch.index), q, k);
            ((constant, slope) != (0.0, 0.0)).then(|| Loss { over: over(), constant, slope })
        };
        Guards { exits: switches.iter().map(exits).collect(), lost: switches.iter().filter_map(lost).collect() }
    }

    /// Energy that the forces of switches dissipate while the coordinates move from `q` by `dq`, at the law values `k` \[J\].
    #[inline]
    pub fn lost(&self, q: &[f64], dq: &Vector, k: &[f64]) -> f64 {
        let of = |Loss { over, constant, slope }: &Loss| {
            let (x, dx) = (over.value(q, k), over.normal.dot(dq));
            (constant + slope * (x + 0.5 * dx)) * dx
        };
        self.lost.iter().map(of).sum()
    }

    /// The power that the forces of switches dissipate \[W\].
    pub fn power(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        let of = |Loss { over, constant, slope }: &Loss| (constant + slope * over.value(q, k)) * over.normal.dot(q_dot);
        self.lost.iter().map(of).sum()
    }
}

/// The exits that a motion can take before any other exit. If the guards of several exits are multiples of one another, only the first is
/// used. Exits by a reaction are watched with the hold.
fn watched(exits: Vec<Exit>) -> SmallVec<[Exit; 2]> {
    let mut watched: SmallVec<[Exit; 2]> = SmallVec::new();
    for exit in exits.into_iter().filter(|exit| !exit.sudden && exit.guard.on_reaction == 0.0) {
        if !watched.iter().any(|other| ratio(&exit.guard, &other.guard).is_some_and(|c| c > 0.0)) {
            watched.push(exit);
        }
    }
    watched
}

/// The factor by which one guard is a multiple of another; `None` if it is not a multiple.
fn ratio(guard: &Affine, of: &Affine) -> Option<f64> {
    let parts = |guard: &Affine| {
        let errors = guard.errors.iter().map(|(_, unit)| *unit);
        let slopes = guard.on_q.iter().chain(guard.on_speed.iter()).copied();
        slopes.chain([guard.constant, guard.on_reaction]).chain(errors).collect::<SmallVec<[f64; 16]>>()
    };
    let (a, b) = (parts(guard), parts(of));
    let largest = (0..b.len()).max_by(|&i, &j| b[i].abs().total_cmp(&b[j].abs()))?;
    let factor = a.get(largest)? / b[largest];
    let same = |(a, b): (&f64, &f64)| (a - factor * b).abs() <= SAME_GUARD * a.abs();
    (a.len() == b.len() && factor != 0.0 && a.iter().zip(&b).all(same)).then_some(factor)
}

/// Goes on to the mode in which the state `q`, `q_dot` violates no guard. `crossed` is the guard that has just become zero: it counts as
/// negative, and its multiples have the sign that follows, regardless of their rounded values. Updates the values of the switch's symbols
/// in `k`. Returns whether the mode has changed.
pub fn settle(
    switch: &mut Switch,
    equations: &dyn Equations,
    (q, q_dot): (&[f64], &[f64]),
    k: &mut [f64],
    crossed: Option<&Affine>,
) -> bool {
    let before = switch.mode;
    for _ in 0..switch.modes() {
        let exits = switch.exits(equations, q, k);
        let violated = |exit: &Exit| match crossed.and_then(|crossed| ratio(&exit.guard, crossed)) {
            Some(factor) => factor > 0.0,
            None => exit.guard.value(q, q_dot, k) < -equations::rounding(&exit.guard, k),
        };
        // The guard that has become zero is the held rate if its exit leads here. Otherwise, e.g. at a change of flanks, the rate has any
        // value.
        let stops = crossed.is_some() && switch.mode == before;
        let exit = match switch.here().held {
            // The reaction is not known before the hold begins. If the rate to be held is not zero, the hold ends at once.
            true if stops || switch.is_at_rest(equations, (q, q_dot), k) => {
                exits.iter().find(|exit| exit.guard.on_reaction == 0.0 && violated(exit))
            }
            true => {
                let admitted = |at_edge| {
                    let found =
                        |exit: &&Exit| admits(switch, equations, (exit.beyond, at_edge), (q, q_dot), k, crossed);
                    exits.iter().find(found)
                };
                admitted(false).or_else(|| admitted(true))
            }
            false => exits.iter().find(|exit| violated(exit)),
        };
        let Some(exit) = exit else { break };
        switch.mode = exit.beyond;
        switch.write(k);
    }
    switch.mode != before
}

/// Whether another mode of a switch admits a state: its guards are positive there, or zero and increasing. If `at_edge`, a mode that does
/// not hold also admits a state at which guards that depend on the coordinates only are zero, e.g. gears that roll without load. `crossed`
/// is as in [`settle`].
fn admits(
    switch: &Switch,
    equations: &dyn Equations,
    (mode, at_edge): (usize, bool),
    (q, q_dot): (&[f64], &[f64]),
    k: &[f64],
    crossed: Option<&Affine>,
) -> bool {
    let (other, k) = switch.in_mode(mode, k);
    let stays = at_edge && !other.here().held;
    other.exits(equations, q, &k).iter().map(|exit| &exit.guard).filter(|guard| guard.on_reaction == 0.0).all(|guard| {
        if let Some(factor) = crossed.and_then(|crossed| ratio(guard, crossed)) {
            return factor < 0.0;
        }
        let value = guard.value(q, q_dot, &k);
        let edge = stays && guard.on_speed.amax() == 0.0 && value.abs() <= equations::rounding(guard, &k);
        value > 0.0 || edge || (value == 0.0 && guard.on_q.dot(q_dot) > 0.0)
    })
}
