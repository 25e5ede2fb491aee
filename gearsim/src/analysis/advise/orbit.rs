//! The settled motion in steady rotation: the fixed point of the exact propagators over one common period of the meshes.
//!
//! Every mesh phase moves on at a constant speed, so that the stiffnesses are k(t). In the coordinates z of what is not rigid,
//! q = B z with the shapes B of the mean stiffness, L = BᵀM, a stretch without steps takes y = (z, z') by its propagator P,
//!
//! ```text
//! y -> y_s + P (y - y_s),     (BᵀK B) z_s = Bᵀf
//! ```
//!
//! so that a period is affine, y -> A y + a, and the settled motion begins with (1 - A) y = a. The impulses of the steps
//! enter at the ends of stretches: dz' = L M⁻¹n (v+ - v)/G from the jump rule, at the motion found before, until it stays the
//! same. The rolling speed is kept; what the motion takes from it, the loss to damping a period, is told.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use crate::analysis::floquet::{Aperiodic, Stretch, stretches};
use crate::analysis::steady::{self, Course};
use crate::engine::Refusal;
use crate::engine::equations::Switching;
use crate::engine::modal::Modal;
use crate::engine::system::System;
use crate::scene::Scene;

/// Why numbers do not tell how a scene moves.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Unknown {
    #[error("{0}")]
    Refused(#[from] Refusal),
    #[error("{0}")]
    Aperiodic(#[from] Aperiodic),
    #[error("a common period of the meshes has {0} cells")]
    Long(usize),
    #[error("a period of the meshes has {0:.0} of the fastest vibration")]
    Slow(f64),
    #[error("nothing vibrates")]
    Rigid,
    #[error("the vibration of the start does not die away within the run")]
    Unsettled,
    #[error("torques that do not balance change the speed")]
    Unbalanced,
    #[error("the stiffness follows curves between its steps")]
    Curved,
    #[error("a transmission error moves the flanks")]
    Displaced,
}

/// Cells of a period, at most.
const MOST_STRETCHES: usize = 240;
/// Instants at which the motion is looked at: of a period, and of the fastest vibration, at least; of a period, at most.
const INSTANTS: f64 = 480.0;
const OF_A_CYCLE: f64 = 40.0;
const MOST_INSTANTS: f64 = 50_000.0;
/// Lines of the spectrum, at most.
const LINES: usize = 200;
/// Times that impulses are worked out from the motion that they make.
const ROUNDS: usize = 12;
/// What may be left at the end of the run of the vibration of its start.
const SETTLED: f64 = 0.2;
/// Change of the speed by torques over the run, relative, that is none.
const BALANCED: f64 = 1e-3;

/// What a scene is in steady rotation.
pub struct Steady<'a> {
    system: &'a dyn System,
    /// The stiffnesses.
    pub courses: Vec<Course>,
    /// Coordinate that is the phase of each law.
    phases: Vec<usize>,
    /// Common period at the scene's speed [s], and its stretches.
    pub period: f64,
    stretches: Vec<Stretch>,
    /// B and L.
    shapes: DMatrix<f64>,
    onto: DMatrix<f64>,
    /// Kinetic energy of the rotation [J].
    pub rolling: f64,
    /// Lowest and highest natural frequency at the mean stiffness [Hz].
    pub natural: (f64, f64),
    /// Static deflections at the mid stiffness (n).
    pub statics: DVector<f64>,
}

/// The settled motion over a period.
#[derive(Debug, Clone)]
pub struct Orbit {
    /// The period [s].
    pub period: f64,
    /// Mean of each coordinate.
    pub mean: Vec<f64>,
    /// Mean square of each coordinate about its mean.
    pub square: Vec<f64>,
    /// Greatest amount of each coordinate.
    pub peak: Vec<f64>,
    /// Power of each coordinate at each multiple of 1/period, from 1 on.
    pub lines: Vec<Vec<f64>>,
    /// Energy lost to damping [J].
    pub lost: f64,
    /// Steps met.
    pub steps: usize,
    /// Largest 2 G dV/v² of a step: beyond 1, it turns the motion back.
    pub strength: f64,
}

/// A stretch, ready to be walked.
struct Leg {
    /// Of one substep.
    propagator: DMatrix<f64>,
    substeps: usize,
    step: f64,
    /// z_s.
    rest: DVector<f64>,
    /// Impulses at its end: by each phase that steps, its coordinate, speed, and the step of K.
    steps: Vec<(usize, f64, DMatrix<f64>)>,
}

impl<'a> Steady<'a> {
    /// That of a scene.
    ///
    /// # Errors
    /// Where its numbers do not make a settled motion that this finds.
    pub fn of(scene: &Scene, system: &'a dyn System) -> Result<Steady<'a>, Unknown> {
        if scene.present().any(|(_, law)| !law.steps_only()) {
            return Err(Unknown::Curved);
        }
        if scene.present().any(|(law, _)| law.with.is_some()) {
            return Err(Unknown::Displaced);
        }
        let courses = steady::courses(scene, system);
        let (period, stretches) = stretches(&courses)?;
        if stretches.len() > MOST_STRETCHES {
            return Err(Unknown::Long(stretches.len()));
        }
        let model = scene.model;
        let phase = |name: &str| model.coordinates.iter().position(|c| c.name == name).unwrap_or(0);
        let means: Vec<f64> = courses.iter().map(Course::mean).collect();
        let at_mean = system.matrices(&means)?;
        let modal = Modal::of(&at_mean)?;
        let elastic: Vec<usize> = (0..modal.modes.len()).filter(|&i| modal.modes[i].omega2 > 0.0).collect();
        let frequency = |i: &usize| modal.modes[*i].omega2.sqrt() / TAU;
        let (Some(low), Some(high)) = (elastic.first().map(frequency), elastic.last().map(frequency)) else {
            return Err(Unknown::Rigid);
        };
        let speeds = DVector::from_vec(steady::speeds(scene, system));
        let rolling = 0.5 * speeds.dot(&(&at_mean.mass * &speeds));
        let power = speeds.dot(&at_mean.load);
        if (power * scene.t_end).abs() > 2.0 * BALANCED * rolling {
            return Err(Unknown::Unbalanced);
        }
        if OF_A_CYCLE * high * period > MOST_INSTANTS {
            return Err(Unknown::Slow(high * period));
        }
        let mut steady = Steady {
            system,
            phases: model.laws.iter().map(|law| phase(law.phase)).collect(),
            courses,
            period,
            stretches,
            shapes: modal.shapes.select_columns(&elastic),
            onto: modal.momentum.select_rows(&elastic),
            rolling,
            natural: (low, high),
            statics: DVector::zeros(speeds.len()),
        };
        let mids: Vec<f64> = scene.stiffnesses().map(|(_, law)| law.mid()).collect();
        steady.statics = &steady.shapes * steady.rest(&mids)?;
        let growth = steady.growth()?;
        if growth.powf(scene.t_end / steady.period) > SETTLED {
            return Err(Unknown::Unsettled);
        }
        Ok(steady)
    }

    /// The settled motion at `factor` times the scene's speed; with the impulses of the steps if `jumps`.
    ///
    /// # Errors
    /// Where a cell has no modes.
    pub fn orbit(&self, factor: f64, jumps: bool) -> Result<Orbit, Unknown> {
        let legs = self.legs(factor)?;
        let size = 2 * self.shapes.ncols();
        let mut kicks: Vec<DVector<f64>> = legs.iter().map(|_| DVector::zeros(size)).collect();
        let mut start = self.fixed_point(&legs, &kicks)?;
        let mut strength = 0.0;
        let rounds = if jumps { ROUNDS } else { 0 };
        for _ in 0..rounds {
            let mut y = start.clone();
            strength = 0.0f64;
            for (leg, kick) in legs.iter().zip(&mut kicks) {
                for _ in 0..leg.substeps {
                    y = leg.walk(&y);
                }
                let (impulse, here) = self.impulse(leg, &y)?;
                strength = strength.max(here);
                // The mean with the one before: where they are strong, they would overshoot each other.
                *kick = (&*kick + impulse) * 0.5;
                y += &*kick;
            }
            if strength >= 1.0 {
                break;
            }
            start = self.fixed_point(&legs, &kicks)?;
        }
        self.look(&legs, &kicks, start, self.period / factor, strength)
    }

    fn legs(&self, factor: f64) -> Result<Vec<Leg>, Unknown> {
        let count = self.stretches.len();
        let leg = |i: usize| -> Result<Leg, Unknown> {
            let (here, next) = (&self.stretches[i], &self.stretches[(i + 1) % count]);
            let time = here.time / factor;
            // Slower rotation has more cycles of the vibration in a period.
            let cycles = self.natural.1 * self.period / factor;
            let share = here.time / self.period * (OF_A_CYCLE * cycles).clamp(INSTANTS, MOST_INSTANTS);
            let substeps = (share.ceil() as usize).max(2);
            let step = time / substeps as f64;
            let changed = (0..here.levels.len()).filter(|&law| here.levels[law] != next.levels[law]);
            let changed = changed.filter(|&law| self.system.switching(law) == Switching::WithJump);
            let mut steps: Vec<(usize, f64, DMatrix<f64>)> = vec![];
            for law in changed {
                let mut k = here.levels.clone();
                let before = self.system.matrices(&k)?.stiffness;
                k[law] = next.levels[law];
                let dk = self.system.matrices(&k)?.stiffness - before;
                let (phase, speed) = (self.phases[law], self.courses[law].speed * factor);
                match steps.iter_mut().find(|step| step.0 == phase) {
                    Some(step) => step.2 += dk,
                    None => steps.push((phase, speed, dk)),
                }
            }
            let propagator = self.reduced(&self.system.propagator(&here.levels, step)?);
            Ok(Leg { propagator, substeps, step, rest: self.rest(&here.levels)?, steps })
        };
        (0..count).map(leg).collect()
    }

    /// z_s of a cell.
    fn rest(&self, levels: &[f64]) -> Result<DVector<f64>, Unknown> {
        let matrices = self.system.matrices(levels)?;
        let k = self.shapes.transpose() * &matrices.stiffness * &self.shapes;
        k.lu().solve(&(self.shapes.transpose() * &matrices.load)).ok_or(Unknown::Rigid)
    }

    /// A propagator of (q, q') as one of (z, z').
    fn reduced(&self, propagator: &DMatrix<f64>) -> DMatrix<f64> {
        let (n, m) = self.shapes.shape();
        let mut reduced = DMatrix::zeros(2 * m, 2 * m);
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let part = &self.onto * propagator.view((row * n, column * n), (n, n)) * &self.shapes;
            reduced.view_mut((row * m, column * m), (m, m)).copy_from(&part);
        }
        reduced
    }

    /// y -> A y + a over a period.
    fn period_map(legs: &[Leg], kicks: &[DVector<f64>], size: usize) -> (DMatrix<f64>, DVector<f64>) {
        let (mut a, mut b) = (DMatrix::identity(size, size), DVector::zeros(size));
        for (leg, kick) in legs.iter().zip(kicks) {
            for _ in 0..leg.substeps {
                a = &leg.propagator * a;
                b = leg.walk(&b);
            }
            b += kick;
        }
        (a, b)
    }

    fn fixed_point(&self, legs: &[Leg], kicks: &[DVector<f64>]) -> Result<DVector<f64>, Unknown> {
        let size = 2 * self.shapes.ncols();
        let (a, b) = Self::period_map(legs, kicks, size);
        (DMatrix::identity(size, size) - a).lu().solve(&b).ok_or(Unknown::Unsettled)
    }

    /// What a disturbance grows by in a period, at most.
    fn growth(&self) -> Result<f64, Unknown> {
        let legs = self.legs(1.0)?;
        let size = 2 * self.shapes.ncols();
        let kicks: Vec<_> = legs.iter().map(|_| DVector::zeros(size)).collect();
        let (a, _) = Self::period_map(&legs, &kicks, size);
        Ok(a.complex_eigenvalues().iter().fold(0.0f64, |m, z| m.max(z.norm())))
    }

    /// The impulse at the end of a leg, as a change of (z, z'), and the largest 2 G dV/v².
    fn impulse(&self, leg: &Leg, y: &DVector<f64>) -> Result<(DVector<f64>, f64), Unknown> {
        let m = self.shapes.ncols();
        let mut change = DVector::zeros(2 * m);
        let mut strength = 0.0f64;
        if leg.steps.is_empty() {
            return Ok((change, strength));
        }
        let mobility = self.system.matrices(&self.stretches[0].levels)?.mobility;
        let (q, v) = (&self.shapes * y.rows(0, m), &self.shapes * y.rows(m, m));
        for (phase, speed, dk) in &leg.steps {
            let direction = mobility.column(*phase).into_owned();
            let g = direction[*phase];
            let (dv, v) = (0.5 * q.dot(&(dk * &q)), speed + v[*phase]);
            strength = strength.max(2.0 * g * dv / (v * v));
            let after = (v * v - 2.0 * g * dv).max(0.0).sqrt().copysign(v);
            // (v+ - v)/G without cancellation.
            let per = -2.0 * dv / (after + v);
            let part = &self.onto * direction * per;
            let mut speeds = change.rows_mut(m, m);
            speeds += part;
        }
        Ok((change, strength))
    }

    /// Walks the period and notes what there is to see.
    fn look(
        &self,
        legs: &[Leg],
        kicks: &[DVector<f64>],
        start: DVector<f64>,
        period: f64,
        strength: f64,
    ) -> Result<Orbit, Unknown> {
        let (n, m) = self.shapes.shape();
        let c = self.system.matrices(&self.stretches[0].levels)?.damping;
        let mut points: Vec<(f64, f64, DVector<f64>)> = vec![];
        let (mut y, mut t, mut lost) = (start, 0.0, 0.0);
        let power = |y: &DVector<f64>| {
            let v = &self.shapes * y.rows(m, m);
            v.dot(&(&c * &v))
        };
        for (leg, kick) in legs.iter().zip(kicks) {
            for _ in 0..leg.substeps {
                let next = leg.walk(&y);
                lost += 0.5 * leg.step * (power(&y) + power(&next));
                // The trapezoid rule, piece by piece.
                points.push((t, leg.step / 2.0, &self.shapes * y.rows(0, m)));
                t += leg.step;
                points.push((t, leg.step / 2.0, &self.shapes * next.rows(0, m)));
                y = next;
            }
            y += kick;
        }
        let mean = |i: usize| points.iter().map(|(_, w, q)| w * q[i]).sum::<f64>() / period;
        let means: Vec<f64> = (0..n).map(mean).collect();
        let square = |i: usize| points.iter().map(|(_, w, q)| w * (q[i] - means[i]).powi(2)).sum::<f64>() / period;
        let mut lines = vec![Vec::with_capacity(LINES); n];
        for order in 1..=LINES {
            let turn = TAU * order as f64 / period;
            let mut sums = vec![Complex::from(0.0); n];
            for (t, w, q) in &points {
                let turned = Complex::from_polar(*w, -turn * t);
                sums.iter_mut().enumerate().for_each(|(i, sum)| *sum += turned * (q[i] - means[i]));
            }
            lines.iter_mut().zip(sums).for_each(|(line, sum)| line.push(2.0 * (sum / period).norm_sqr()));
        }
        Ok(Orbit {
            period,
            square: (0..n).map(square).collect(),
            peak: (0..n).map(|i| points.iter().fold(0.0f64, |m, p| m.max(p.2[i].abs()))).collect(),
            lines,
            mean: means,
            lost,
            steps: legs.iter().filter(|leg| !leg.steps.is_empty()).count(),
            strength,
        })
    }
}

impl Leg {
    fn walk(&self, y: &DVector<f64>) -> DVector<f64> {
        let m = self.rest.len();
        let mut from = y.clone();
        let mut place = from.rows_mut(0, m);
        place -= &self.rest;
        let mut to = &self.propagator * from;
        let mut place = to.rows_mut(0, m);
        place += &self.rest;
        to
    }
}
