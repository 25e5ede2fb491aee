//! Torques that vary in time: the generalised forces beyond those of the start, sum over p of B_p (T_p(t) - T_p(0)).
//!
//! The equations of a scene are those with T_p(0). While all T_p are constant, the cells are solved as without forcing, with another load
//! ([`Forcing::load`]). While one is linear in time or harmonic, the motion is that of a driven flight ([`Driven`](crate::engine::cell::Driven)).
//! A breakpoint of a time history is an event: the present piece is part of the state, as the cell of a stiffness is.
//!
//! Where B_p depends on the state, or guards depend on p, only methods by steps compute the motion. The equations are then those of
//! [`varying`](crate::engine::equations). They read from the law values how far each such parameter has changed.

use std::sync::Arc;

use nalgebra::Complex;
use smallvec::SmallVec;
use xprec::Df64;

use crate::engine::cell::Varying;
use crate::engine::clock::Clock;
use crate::engine::equations::{DerivedModel, Equations, varying_by_steps};
use crate::engine::vector::Vector;
use crate::model::Varies;
use crate::scene::time_history::{Harmonic, LinearPiece};
use crate::scene::{Scene, TimeHistory};

/// The parameters that vary.
#[derive(Debug, Clone)]
pub struct Forcing {
    drives: Arc<[Drive]>,
    /// Number of the drives whose factors are constant. Those of [`varying_by_steps`] follow, in their order.
    loads: usize,
    /// Whether guards or losses of switches depend on one of these parameters.
    moves_guards: bool,
    /// The piece of its time history in which each parameter is. It is part of the state and never computed from the time.
    pieces: SmallVec<[usize; 4]>,
    /// Number of external torques of the scene.
    torques: usize,
}

/// A parameter that varies, from a time on: now + slope t + sum of Re(swing (e^{i W t} - 1)), beyond its value at the start of the run.
#[derive(Debug, Clone)]
pub struct Onward<'a> {
    pub now: f64,
    pub slope: f64,
    /// W \[rad/s\], and the complex amplitude.
    pub swings: SmallVec<[(f64, Complex<f64>); 2]>,
    /// Generalised forces per unit (n).
    pub load: &'a Vector,
    /// Power of each torque of the scene per unit, as factors of the speeds (n each).
    pub power: &'a [Vector],
}

/// A parameter that varies.
#[derive(Debug, Clone)]
struct Drive {
    /// Its index.
    parameter: usize,
    course: TimeHistory,
    /// T_p(0).
    at_start: f64,
    /// Its largest change, p_1 - p_0.
    largest: f64,
    /// B_p: generalised forces per unit of the parameter (n); zero if they depend on the state.
    load: Vector,
    /// Power of each torque of the scene per unit of the parameter, as factors of the speeds (n each).
    power: Vec<Vector>,
}

impl Forcing {
    /// The parameters of a scene that vary and act on its motion; `None` if there are none.
    pub fn of(derived: &DerivedModel, scene: &Scene) -> Option<Self> {
        let mids = scene.mids();
        let varies = |p: usize| scene.model.parameters[p].varies;
        let without_loads = |(p, x): (usize, &f64)| if varies(p) == Varies::AsLoad { 0.0 } else { *x };
        let bare: Vec<f64> = scene.parameters.iter().enumerate().map(without_loads).collect();
        let (k, flat) = (scene.model.in_contact(mids.iter().copied()), vec![0.0; scene.model.laws.len()]);
        let torques = scene.torques();
        let drive = |(p, course): &(usize, TimeHistory), load, power| {
            let (at_start, course) = (course.at_start(), course.clone());
            Drive { parameter: *p, at_start, largest: course.farthest() - at_start, course, load, power }
        };
        let as_load = |history: &(usize, TimeHistory)| {
            let p = history.0;
            // The forces are linear in the parameter: B_p is the difference of those at 1 and at 0.
            let mut unit = bare.clone();
            unit[p] = 1.0;
            let unit = derived.source.equations(scene, &unit, &mids)?;
            let none = derived.source.equations(scene, &bare, &mids)?;
            let n = unit.coordinates();
            let still = Vector::zeros(n);
            let force = |e: &dyn Equations| e.force(&still, &still, &k, &flat);
            let load = force(&*unit) - &force(&*none);
            let along = |i: usize, j: usize| {
                let unit_dq = Vector::from_fn(n, |k| f64::from(u8::from(k == j)));
                unit.torque_work(i, &unit_dq) - none.torque_work(i, &unit_dq)
            };
            let power = torques.iter().map(|&i| Vector::from_fn(n, |j| along(i, j))).collect();
            (load.amax() > 0.0).then(|| drive(history, load, power))
        };
        let histories = scene.time_histories.iter().filter(|c| !c.1.is_constant());
        let mut drives: Vec<Drive> =
            histories.filter(|(p, _)| varies(*p) == Varies::AsLoad).filter_map(as_load).collect();
        let loads = drives.len();
        let none = Vector::zeros(scene.model.coordinates.len());
        drives.extend(varying_by_steps(scene).map(|history| drive(history, none.clone(), vec![])));
        let moves_guards = varying_by_steps(scene).any(|(p, _)| varies(*p) == Varies::WithGuards);
        let pieces = drives.iter().map(|d| d.course.piece(0.0)).collect();
        let drives: Arc<[_]> = drives.into();
        (!drives.is_empty()).then(|| Forcing { drives, loads, moves_guards, pieces, torques: torques.len() })
    }

    /// The time of the next breakpoint \[s\]; infinite if there is none.
    pub fn next(&self) -> f64 {
        let next =
            |(d, piece): (&Drive, usize)| d.course.pieces.get(piece + 1).map_or(f64::INFINITY, |piece| piece.begin);
        self.in_pieces().map(next).fold(f64::INFINITY, f64::min)
    }

    /// Enters the pieces that begin by the time `t` \[s\].
    pub fn enter(&mut self, t: f64) {
        for (drive, piece) in self.drives.iter().zip(&mut self.pieces) {
            while drive.course.pieces.get(*piece + 1).is_some_and(|piece| piece.begin <= t) {
                *piece += 1;
            }
        }
    }

    /// Whether every parameter is constant until the next breakpoint.
    pub fn is_flat(&self) -> bool {
        self.in_pieces().all(|(d, piece)| d.course.harmonics.is_empty() && d.course.pieces[piece].slope == 0.0)
    }

    /// The fastest angular frequency of a harmonic \[rad/s\].
    pub fn fastest(&self) -> f64 {
        self.drives.iter().flat_map(|d| &d.course.harmonics).map(|h| h.omega).fold(0.0, f64::max)
    }

    /// Whether only methods by steps compute the motion.
    pub fn is_by_steps(&self) -> bool {
        self.loads < self.drives.len()
    }

    /// Whether guards or losses of switches depend on a parameter that varies.
    pub fn moves_guards(&self) -> bool {
        self.moves_guards
    }

    /// Writes the change of each parameter of [`varying_by_steps`], as a share of its largest change, to the end of the law values `k`,
    /// which has a place for each.
    pub fn write_shares(&self, t: f64, k: &mut [f64]) {
        let at = k.len() - (self.drives.len() - self.loads);
        for (share, (drive, change)) in k[at..].iter_mut().zip(self.changes(t).skip(self.loads)) {
            *share = change / drive.largest;
        }
    }

    /// T_p(t) - T_p(0) of each.
    fn changes(&self, t: f64) -> impl Iterator<Item = (&Drive, f64)> {
        self.in_pieces().map(move |(d, piece)| (d, d.course.at(piece, t) - d.at_start))
    }

    /// The parameters that vary, each with its present piece.
    fn in_pieces(&self) -> impl Iterator<Item = (&Drive, usize)> {
        self.drives.iter().zip(self.pieces.iter().copied())
    }

    /// The time history of each, its present piece, and its value at the start.
    pub fn histories(&self) -> impl Iterator<Item = (&TimeHistory, usize, f64)> {
        self.in_pieces().map(|(d, piece)| (&d.course, piece, d.at_start))
    }

    /// The parameters that vary, by their indices.
    pub fn parameters(&self) -> impl Iterator<Item = usize> {
        self.drives.iter().map(|d| d.parameter)
    }

    /// The generalised forces beyond those of the start at the time `t` \[s\] (n).
    pub fn load(&self, t: f64) -> Vector {
        let n = self.drives.first().map_or(0, |drive| drive.load.len());
        self.changes(t).fold(Vector::zeros(n), |mut sum, (d, change)| {
            sum.add_times(change, &d.load);
            sum
        })
    }

    /// Power of each torque of the scene beyond that of its value at the start, at the speeds `q_dot` \[W\].
    pub fn power(&self, t: f64, q_dot: &Vector) -> Vec<f64> {
        let mut power = vec![0.0; self.torques];
        for (d, change) in self.changes(t) {
            power.iter_mut().zip(&d.power).for_each(|(sum, row)| *sum += change * row.dot(q_dot));
        }
        power
    }

    /// The parameters from the clock's time on.
    pub fn onward(&self, clock: &Clock) -> Vec<Onward<'_>> {
        self.in_pieces().map(|(drive, piece)| drive.onward(piece, clock)).collect()
    }
}

/// 2 pi in 32 digits: the nearest f64, and the remainder.
pub(crate) const TURN: (f64, f64) = (std::f64::consts::TAU, 2.449_293_598_294_706_4e-16);

impl Drive {
    fn onward(&self, piece: usize, clock: &Clock) -> Onward<'_> {
        let LinearPiece { begin, value, slope } = self.course.pieces[piece];
        let swing = |h: &Harmonic| {
            // Whole turns are removed exactly, so the phase keeps its digits at any time.
            let angle = Df64::from(h.omega) * clock.0;
            let turns = (angle.hi() / TURN.0).round();
            let angle = (angle - Df64::from(TURN.0) * turns - TURN.1 * turns) + h.phase;
            (h.omega, Complex::from_polar(h.amplitude, angle.hi()))
        };
        let swings: SmallVec<[_; 2]> = self.course.harmonics.iter().map(swing).collect();
        let steady = value - self.at_start + slope * (clock.0 - begin).hi();
        let now = swings.iter().fold(steady, |sum, (_, swing)| sum + swing.re);
        Onward { now, slope, swings, load: &self.load, power: &self.power }
    }
}

impl Onward<'_> {
    /// The generalised forces of parameters at the start of a motion (n), beyond those at the start of the run.
    pub fn force(all: &[Self], n: usize) -> Vector {
        all.iter().fold(Vector::zeros(n), |mut sum, of| {
            sum.add_times(of.now, of.load);
            sum
        })
    }

    /// Work of each torque of the scene beyond that of its value at the start of the run, along `dq` (n), if they are constant \[J\].
    pub fn work(all: &[Self], dq: &Vector) -> Vec<f64> {
        let mut work = vec![0.0; all.first().map_or(0, |of| of.power.len())];
        for Onward { now, power, .. } in all {
            work.iter_mut().zip(*power).for_each(|(sum, row)| *sum += now * row.dot(dq));
        }
        work
    }

    /// How they vary from then on, and the frequencies of their swings \[rad/s\]; `None` if they are constant.
    pub fn varying(all: &[Self], n: usize) -> Option<(Vec<f64>, Varying)> {
        let mut varying = Varying { slope: Vector::zeros(n), swings: vec![] };
        let mut frequencies = vec![];
        for Onward { slope, swings, load, .. } in all {
            varying.slope.add_times(*slope, load);
            for (frequency, swing) in swings.iter().filter(|(frequency, _)| *frequency != 0.0) {
                frequencies.push(*frequency);
                varying.swings.push(load.iter().map(|load| swing * *load).collect());
            }
        }
        (varying.slope.amax() > 0.0 || !frequencies.is_empty()).then_some((frequencies, varying))
    }
}

#[cfg(test)]
mod tests;
