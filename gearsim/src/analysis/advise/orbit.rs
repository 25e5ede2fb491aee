//! The settled motion in steady rotation: the fixed point of the exact propagators over one common period of the meshes.
//!
//! Every mesh phase has a constant speed, so that stiffnesses and transmission errors are functions of t. Rigid motions are removed:
//! q = B z with the mode shapes B of the mean stiffness, L = BᵀM. A stretch without steps maps the state y = (z, z') by its
//! propagator P,
//!
//! ```text
//! y -> y_s + P (y - y_s),     (BᵀK B) z_s = Bᵀf
//! ```
//!
//! The map of a period is therefore affine, y -> A y + a, and the settled motion starts at the solution of (1 - A) y = a. The impulses
//! of the steps act at the ends of stretches: dz' = L M⁻¹n (v+ - v)/G from the jump rule. They are computed from the motion of the
//! previous iteration, a fixed number of times. The speed of rotation is kept constant; the energy dissipated per period, which comes
//! from the rotation, is part of the result.

mod leg;
mod quantities;

use std::f64::consts::TAU;

use leg::Leg;
use nalgebra::{DMatrix, DVector};

use crate::analysis::floquet::{Aperiodic, Stretch, stretches};
use crate::analysis::steady::{self, SteadyLaw};
use crate::engine::Refusal;
use crate::engine::equations::Switching;
use crate::engine::modal::Modal;
use crate::engine::system::System;
use crate::scene::Scene;
use crate::tolerance::analysis::{CONSTANT_SPEED, ORBIT_STRETCHES, SETTLED};

/// Why the settled motion of a scene cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Unknown {
    #[error("{0}")]
    Refused(#[from] Refusal),
    #[error("{0}")]
    Aperiodic(#[from] Aperiodic),
    #[error("the common period of the meshes has too many cells: {0}")]
    Long(usize),
    #[error("the common period of the meshes has too many periods of the fastest vibration: {0:.0}")]
    Slow(f64),
    #[error("nothing vibrates")]
    Rigid,
    #[error("the initial vibration does not decay within the run")]
    Unsettled,
    #[error("the torques are not in balance and change the speed")]
    Unbalanced,
    #[error("a stiffness or a transmission error is a curve, not constant between steps")]
    Curved,
}

/// Number of instants at which the motion is evaluated: minimum per period, minimum per period of the fastest vibration, and maximum
/// per period.
const INSTANTS: f64 = 480.0;
const OF_A_CYCLE: f64 = 40.0;
const MOST_INSTANTS: f64 = 50_000.0;
/// Number of iterations of impulses and motion.
const ROUNDS: usize = 12;

/// A scene in steady rotation.
pub struct Steady<'a> {
    system: &'a System,
    /// The laws.
    pub courses: Vec<SteadyLaw>,
    /// Index of the coordinate that is the phase of each law.
    phases: Vec<usize>,
    /// Common period at the scene's speed \[s\].
    pub period: f64,
    /// The stretches of the period.
    stretches: Vec<Stretch>,
    /// B (n x m) and L (m x n), m the number of elastic modes.
    shapes: DMatrix<f64>,
    onto: DMatrix<f64>,
    /// Kinetic energy of the rotation \[J\].
    pub rolling: f64,
    /// Lowest and highest natural frequency at the mean stiffness \[Hz\].
    pub natural: (f64, f64),
    /// Static deflections at the mid stiffness (n) \[SI\].
    pub statics: DVector<f64>,
}

/// The settled motion over a period.
#[derive(Debug, Clone)]
pub struct Orbit {
    /// The period \[s\].
    pub period: f64,
    /// Mean square of each coordinate about its mean (n) \[SI²\].
    pub square: Vec<f64>,
    /// Largest deviation of each coordinate from its mean (n) \[SI\].
    pub peak: Vec<f64>,
    /// Largest absolute value of each coordinate (n) \[SI\].
    pub size: Vec<f64>,
    /// Power of each coordinate in each spectral line, at multiples of 1/period from 1 on (n x number of lines) \[SI²\].
    pub lines: Vec<Vec<f64>>,
    /// Energy dissipated by damping per period \[J\].
    pub lost: f64,
    /// Number of steps per period.
    pub steps: usize,
    /// Largest jump strength 2 G dV/v² of a step. A step of strength 1 or more reflects the motion.
    pub strength: f64,
}

impl<'a> Steady<'a> {
    /// The steady rotation of a scene.
    ///
    /// # Errors
    /// [`Unknown`] if the settled motion cannot be computed.
    pub fn of(scene: &Scene, system: &'a System) -> Result<Steady<'a>, Unknown> {
        if scene.present().any(|(_, law)| !law.steps_only()) {
            return Err(Unknown::Curved);
        }
        let courses = steady::all_courses(scene, system)?;
        let means: Vec<f64> = courses.iter().map(SteadyLaw::mean).collect();
        if steady::is_held(scene, system, &means)? {
            return Err(Aperiodic::Held.into());
        }
        let (period, stretches) = stretches(&courses)?;
        if stretches.len() > ORBIT_STRETCHES {
            return Err(Unknown::Long(stretches.len()));
        }
        let model = scene.model;
        let phase = |name: &str| model.coordinates.iter().position(|c| c.name == name).unwrap_or(0);
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
        if (power * scene.t_end).abs() > 2.0 * CONSTANT_SPEED * rolling {
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
        let mids = scene.mid_stiffnesses();
        steady.statics = &steady.shapes * steady.rest(&mids)?;
        let growth = steady.growth()?;
        if growth.powf(scene.t_end / steady.period) > SETTLED {
            return Err(Unknown::Unsettled);
        }
        Ok(steady)
    }

    /// The settled motion at `factor` times the scene's speed, with the impulses of the steps if `jumps`.
    ///
    /// # Errors
    /// [`Unknown`] if the modes of a cell cannot be computed, or if 1 - A is singular.
    pub fn orbit(&self, factor: f64, jumps: bool) -> Result<Orbit, Unknown> {
        let legs = self.legs(factor)?;
        let size = 2 * self.shapes.ncols();
        let mut impulses: Vec<DVector<f64>> = legs.iter().map(|_| DVector::zeros(size)).collect();
        let to_return = (DMatrix::identity(size, size) - leg::period(&legs)).lu();
        let settled = |impulses: &[DVector<f64>]| {
            let a = legs.iter().zip(impulses).fold(DVector::zeros(size), |y, (leg, impulse)| leg.cross(&y) + impulse);
            to_return.solve(&a).ok_or(Unknown::Unsettled)
        };
        let mut start = settled(&impulses)?;
        let mut strength = 0.0;
        let rounds = if jumps { ROUNDS } else { 0 };
        for _ in 0..rounds {
            let mut y = start;
            strength = 0.0f64;
            for (leg, averaged) in legs.iter().zip(&mut impulses) {
                y = leg.cross(&y);
                let (impulse, here) = self.impulse(leg, &y)?;
                strength = strength.max(here);
                // Average with the previous iteration: strong impulses would otherwise overshoot.
                *averaged = (&*averaged + impulse) * 0.5;
                y += &*averaged;
            }
            start = settled(&impulses)?;
            if strength >= 1.0 {
                break;
            }
        }
        self.quantities(&legs, &impulses, start, self.period / factor, strength)
    }

    fn legs(&self, factor: f64) -> Result<Vec<Leg>, Unknown> {
        let count = self.stretches.len();
        let leg = |i: usize| -> Result<Leg, Unknown> {
            let (here, next) = (&self.stretches[i], &self.stretches[(i + 1) % count]);
            let time = here.time / factor;
            // At a lower speed a period contains more cycles of the vibration.
            let cycles = self.natural.1 * self.period / factor;
            let share = here.time / self.period * (OF_A_CYCLE * cycles).clamp(INSTANTS, MOST_INSTANTS);
            let substeps = (share.ceil() as usize).max(2);
            let step = time / substeps as f64;
            let changed = (0..here.levels.len()).filter(|&law| here.levels[law] != next.levels[law]);
            let changed = changed.filter(|&law| self.system.switching(law) == Switching::WithJump);
            let mut steps: Vec<leg::LawSteps> = vec![];
            for law in changed {
                let (phase, speed) = (self.phases[law], self.courses[law].speed * factor);
                let at = steps.iter().position(|step| step.phase == phase).unwrap_or_else(|| {
                    steps.push(leg::LawSteps { phase, speed, beyond: here.levels.clone() });
                    steps.len() - 1
                });
                steps[at].beyond[law] = next.levels[law];
            }
            let over = |time: f64| Ok::<_, Unknown>(self.reduced(&self.system.propagator(&here.levels, time)?));
            let (whole, part, rest) = (over(time)?, over(step)?, self.rest(&here.levels)?);
            Ok(Leg { levels: here.levels.clone(), whole, part, substeps, step, rest, steps })
        };
        (0..count).map(leg).collect()
    }

    /// The static deflection z_s of a cell.
    fn rest(&self, levels: &[f64]) -> Result<DVector<f64>, Unknown> {
        let matrices = self.system.matrices(levels)?;
        let k = self.shapes.transpose() * &matrices.stiffness * &self.shapes;
        k.lu().solve(&(self.shapes.transpose() * &matrices.load)).ok_or(Unknown::Rigid)
    }

    /// A propagator of (q, q'), reduced to (z, z').
    fn reduced(&self, propagator: &DMatrix<f64>) -> DMatrix<f64> {
        let (n, m) = self.shapes.shape();
        let mut reduced = DMatrix::zeros(2 * m, 2 * m);
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let part = &self.onto * propagator.view((row * n, column * n), (n, n)) * &self.shapes;
            reduced.view_mut((row * m, column * m), (m, m)).copy_from(&part);
        }
        reduced
    }

    /// Largest factor by which a disturbance grows in a period: the largest absolute value of an eigenvalue of A.
    fn growth(&self) -> Result<f64, Unknown> {
        let a = leg::period(&self.legs(1.0)?);
        Ok(a.complex_eigenvalues().iter().fold(0.0f64, |m, z| m.max(z.norm())))
    }

    /// The impulse at the end of a leg, as a change of (z, z'), and the largest jump strength 2 G dV/v².
    fn impulse(&self, leg: &Leg, y: &DVector<f64>) -> Result<(DVector<f64>, f64), Unknown> {
        let m = self.shapes.ncols();
        let mut change = DVector::zeros(2 * m);
        let mut strength = 0.0f64;
        if leg.steps.is_empty() {
            return Ok((change, strength));
        }
        let mobility = self.system.matrices(&self.stretches[0].levels)?.mobility;
        let (q, v) = (&self.shapes * y.rows(0, m), &self.shapes * y.rows(m, m));
        let before = self.system.potential(q.as_slice(), &leg.levels);
        for step in &leg.steps {
            let direction = mobility.column(step.phase).into_owned();
            let g = direction[step.phase];
            let dv = self.system.potential(q.as_slice(), &step.beyond) - before;
            let v = step.speed + v[step.phase];
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
}
