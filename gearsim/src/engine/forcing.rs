//! Torques that vary in time: the generalised forces beyond those of the start, sum over p of B_p (T_p(t) - T_p(0)).
//!
//! The equations of a scene are those with T_p(0). While all T_p are constant, the cells are solved as without forcing, with another load
//! ([`Forcing::load`]). While one is linear in time or harmonic, the motion is computed in windows of a power series ([`window`]). A
//! breakpoint of a time history is an event: the present piece is part of the state, as the cell of a stiffness is.
//!
//! Where B_p depends on the state ([`with_state`]), no cell is linear, and only methods by steps compute the motion.

use std::sync::Arc;

use smallvec::SmallVec;
use xprec::Df64;

use crate::engine::clock::Clock;
use crate::engine::equations::{DerivedModel, Equations};
use crate::engine::vector::{Matrix, Vector};
use crate::model::Varies;
use crate::scene::{Scene, TimeHistory};

pub mod linear;
pub mod window;
mod with_state;

use window::TERMS;
pub use with_state::At;
use with_state::Farthest;

/// The parameters that vary.
#[derive(Debug, Clone)]
pub struct Forcing {
    drives: Arc<[Drive]>,
    /// The piece of its time history in which each parameter is. State: never computed from the time.
    pieces: SmallVec<[usize; 4]>,
    /// Number of external torques of the scene.
    torques: usize,
}

/// A parameter that varies.
#[derive(Debug, Clone)]
struct Drive {
    /// Its index.
    parameter: usize,
    course: TimeHistory,
    /// T_p(0).
    at_start: f64,
    /// B_p: generalised forces per unit of the parameter (N); zero if they depend on the state.
    load: Vector,
    /// Power of each torque of the scene per unit of the parameter: its factors of the speeds (N each).
    power: Vec<Vector>,
    /// The forces, if they depend on the state.
    with_state: Option<Farthest>,
}

impl Forcing {
    /// The parameters of a scene that vary and act on its motion; `None` if there are none.
    pub fn of(derived: &DerivedModel, scene: &Scene) -> Option<Self> {
        let mids = scene.mids();
        let varies = scene.model.parameters.iter().map(|p| p.varies.may());
        let bare: Vec<f64> =
            scene.parameters.iter().zip(varies).map(|(x, varies)| if varies { 0.0 } else { *x }).collect();
        let (k, flat) = (scene.model.in_contact(mids.iter().copied()), vec![0.0; scene.model.laws.len()]);
        let torques = scene.torques();
        let equations = |values: &[f64]| derived.source.equations(scene, values, &mids);
        let with_state = |p: usize, course: &TimeHistory, at_start: f64| {
            let mut values = scene.parameters.clone();
            values[p] = Farthest::value(course, at_start);
            Some(Farthest::new(equations(&values)?, values[p] - at_start))
        };
        let drive = |(p, course): &(usize, TimeHistory)| {
            let at_start = course.at(course.piece(0.0), 0.0);
            if scene.model.parameters[*p].varies == Varies::WithState {
                let with_state = Some(with_state(*p, course, at_start)?);
                let load = Vector::zeros(scene.model.coordinates.len());
                return Some(Drive {
                    parameter: *p,
                    course: course.clone(),
                    at_start,
                    load,
                    power: vec![],
                    with_state,
                });
            }
            // The forces are linear in the parameter: B_p is the difference of those at 1 and at 0.
            let mut unit = bare.clone();
            unit[*p] = 1.0;
            let unit = equations(&unit)?;
            let none = equations(&bare)?;
            let n = unit.coordinates();
            let still = Vector::zeros(n);
            let force = |e: &dyn Equations| e.force(&still, &still, &k, &flat);
            let load = force(&*unit) - &force(&*none);
            let along = |i: usize, j: usize| {
                let unit_dq = Vector::from_fn(n, |k| f64::from(u8::from(k == j)));
                unit.torque_work(i, &unit_dq) - none.torque_work(i, &unit_dq)
            };
            let power = torques.iter().map(|&i| Vector::from_fn(n, |j| along(i, j))).collect();
            let course = course.clone();
            (load.amax() > 0.0).then(|| Drive { parameter: *p, course, at_start, load, power, with_state: None })
        };
        let drives: Arc<[_]> = scene.time_histories.iter().filter(|c| !c.1.is_constant()).filter_map(drive).collect();
        let pieces = drives.iter().map(|d| d.course.piece(0.0)).collect();
        (!drives.is_empty()).then(|| Forcing { drives, pieces, torques: torques.len() })
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

    /// The generalised forces beyond those of the start at the time `t` \[s\] (N), without those that depend on the state.
    pub fn load(&self, t: f64) -> Vector {
        let n = self.drives.first().map_or(0, |drive| drive.load.len());
        self.changes(t).fold(Vector::zeros(n), |mut sum, (d, change)| {
            sum.add_times(change, &d.load);
            sum
        })
    }

    /// Adds the generalised forces beyond those of the start to these (N).
    pub fn add_force(&self, t: f64, at: At<'_>, force: &mut Vector) {
        let at_start = force.clone();
        for (d, change) in self.changes(t) {
            force.add_times(change, &d.load);
            if let Some(farthest) = &d.with_state {
                farthest.add_force(change, at, &at_start, force);
            }
        }
    }

    /// Adds the derivatives of these forces by q and by q' to those of the forces of the start; `ddk` are the second derivatives of the laws.
    pub fn add_jacobian(&self, t: f64, at: At<'_>, ddk: &[f64], jacobian: &mut [Matrix; 2]) {
        let mut of_state = self.changes(t).filter_map(|(d, change)| Some((d.with_state.as_ref()?, change))).peekable();
        if of_state.peek().is_none() {
            return;
        }
        let at_start = jacobian.clone();
        of_state.for_each(|(farthest, change)| farthest.add_jacobian(change, at, ddk, &at_start, jacobian));
    }

    /// Power of each torque of the scene beyond that of its value at the start \[W\]; `torques` are their numbers in the model.
    pub fn all_power(&self, t: f64, at: At<'_>, equations: &dyn Equations, torques: &[usize]) -> Vec<f64> {
        let mut power = self.power(t, at.1);
        for (d, change) in self.changes(t) {
            if let Some(farthest) = &d.with_state {
                let further = torques.iter().map(|&i| farthest.power(change, i, at, equations));
                power.iter_mut().zip(further).for_each(|(sum, further)| *sum += further);
            }
        }
        power
    }

    /// The same at the speeds `q_dot`, without the powers that depend on the state otherwise.
    pub fn power(&self, t: f64, q_dot: &[f64]) -> Vec<f64> {
        let mut power = vec![0.0; self.torques];
        for (d, change) in self.changes(t) {
            power.iter_mut().zip(&d.power).for_each(|(sum, row)| *sum += change * row.dot(q_dot));
        }
        power
    }

    /// Power series of T_p(t) - T_p(0) about the clock's time, in parts of `width` \[s\].
    fn series(&self, clock: &Clock, width: f64) -> Vec<[f64; TERMS]> {
        self.in_pieces().map(|(d, piece)| d.series(piece, clock, width)).collect()
    }
}

/// 2 pi in 32 digits: the nearest f64, and the remainder.
pub(crate) const TURN: (f64, f64) = (std::f64::consts::TAU, 2.449_293_598_294_706_4e-16);

impl Drive {
    fn series(&self, piece: usize, clock: &Clock, width: f64) -> [f64; TERMS] {
        let mut c = [0.0; TERMS];
        let piece = self.course.pieces[piece];
        c[0] = piece.value - self.at_start + piece.slope * (clock.0 - piece.begin).hi();
        c[1] = piece.slope * width;
        for h in &self.course.harmonics {
            // Whole turns are removed exactly, so the phase keeps its digits at any time.
            let angle = Df64::from(h.omega) * clock.0;
            let turns = (angle.hi() / TURN.0).round();
            let (sin, cos) = ((angle - Df64::from(TURN.0) * turns - TURN.1 * turns) + h.phase).hi().sin_cos();
            // a cos(phi + z x) = a sum of (i z x)^n/n! times e^(i phi).
            let z = h.omega * width;
            let (mut real, mut imaginary) = (h.amplitude * cos, h.amplitude * sin);
            for (n, c) in c.iter_mut().enumerate() {
                *c += real;
                let by = z / (n + 1) as f64;
                (real, imaginary) = (-imaginary * by, real * by);
            }
        }
        c
    }
}

#[cfg(test)]
mod tests;
