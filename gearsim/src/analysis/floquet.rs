//! Stability of steady rotation: the stiffnesses are periodic in time. The monodromy matrix is the product of the propagators of the cells
//! of a period. They are exact where the stiffnesses are constant, and integrated where one follows a curve. The eigenvalues of the
//! monodromy matrix are the Floquet multipliers, the factors by which a small disturbance grows per period (Meissner's equation and its
//! generalisations; G. Floquet, 1883).
//!
//! Forces that are not linear, such as friction of the flanks, are linearised about the steady motion (`about.rs`). If M or F change along
//! the motion, the reference is a motion that repeats, and the monodromy matrix is integrated along it (`orbit.rs`).
//!
//! Rigid motions, the null space of every K and of C, have the double multiplier 1. They are split off exactly, through their
//! M-orthogonal complement. The verdict is on the other motions.

use nalgebra::{Complex, DMatrix};

use crate::analysis::steady::{self, SteadyLaw};
use crate::engine::Refusal;
use crate::engine::modal::Modal;
use crate::engine::system::{Steady, System};
use crate::scene::Scene;
use crate::tolerance::analysis;

mod about;
mod chart;
mod magnus;
mod orbit;
mod period;

pub(crate) use chart::{Chart, Spot, Varied};
pub use orbit::Orbit;
pub use period::Aperiodic;
pub(crate) use period::{Stretch, stretches};

/// Why the stability of a scene cannot be determined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the messages are the documentation
pub enum FloquetError {
    #[error(transparent)]
    Refused(#[from] Refusal),
    #[error(transparent)]
    Aperiodic(#[from] Aperiodic),
    #[error("nothing vibrates: every motion of the model is rigid")]
    Rigid,
    #[error(
        "no motion is found that repeats after a turn: the torques change the speed too fast, steps turn the motion back, or it is chaotic"
    )]
    NoOrbit,
    #[error("the motion of a turn is not smooth: {why}, so that it has no derivative")]
    NotSmooth { why: &'static str },
    #[error("the run of a turn stopped early: {why}")]
    Stopped { why: String },
    #[error(
        "a period at this speed is too long: {most} steps do not resolve the vibration in it; choose a higher speed"
    )]
    Unresolved { most: f64 },
    #[error("the multipliers overflow: a period at this speed is too long for the growth in it; choose a higher speed")]
    Overflow,
}

/// The Floquet multipliers of a scene.
#[derive(Debug, Clone)]
pub struct Floquet {
    /// Common period of all stiffnesses \[s\].
    pub period: f64,
    /// Multipliers of the motions that are not rigid, by descending absolute value. The list ends with the last one that is larger than
    /// `rounding`.
    pub multipliers: Vec<Complex<f64>>,
    /// Number of multipliers that are left out because their absolute value is at most `rounding`.
    pub unresolved: usize,
    /// Rounding error of a multiplier.
    pub rounding: f64,
    /// Number of rigid motions, which are left out.
    pub rigid: usize,
    /// Stability according to the multipliers.
    pub verdict: Verdict,
    /// Lowest natural frequency \[Hz\] at the mean stiffness.
    pub natural: f64,
    /// Frequency of the first mesh whose stiffness varies \[Hz\].
    pub mesh: f64,
    /// The steady motion about which forces are linearised; `None` if all are linear.
    #[doc(hidden)]
    pub steady: Option<Steady>,
    /// The motion that repeats, about which the equations are linearised; `None` if they do not change along the motion.
    pub orbit: Option<Orbit>,
    /// Whether propagators are integrated, because a law follows a curve.
    pub(crate) is_integrated: bool,
}

/// How a small disturbance develops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It decays.
    Stable,
    /// It keeps its size: there is neither damping nor excitation.
    Neutral,
    /// It keeps its size or grows linearly: two multipliers coincide on the unit circle. There an undamped system may become unstable.
    Border,
    /// It grows with the period of the stiffness: a real multiplier above 1.
    Growing,
    /// It grows with twice that period: a real multiplier below -1.
    Alternating,
    /// It grows at a frequency other than that of the stiffness or half of it (combination resonance): two complex multipliers outside the
    /// unit circle.
    Combination,
}

impl Verdict {
    /// Whether a disturbance grows exponentially.
    pub fn is_unstable(self) -> bool {
        matches!(self, Verdict::Growing | Verdict::Alternating | Verdict::Combination)
    }
}

impl Floquet {
    /// How the monodromy matrix was found, in words.
    pub fn method(&self) -> &'static str {
        match self.orbit {
            Some(_) => "variational equations along the motion that repeats, with saltation matrices",
            None if self.is_integrated => "product of propagators, integrated where a law follows a curve",
            None => "product of exact cell propagators",
        }
    }

    /// The multipliers of `scene` in steady rotation at the speeds of its start. `watch` is called many times during the computation; it
    /// may unwind.
    ///
    /// # Errors
    /// If the modes of a cell cannot be computed, the stiffnesses have no common period, nothing vibrates, or the multipliers overflow.
    pub(crate) fn of(scene: &Scene, system: &System, watch: &dyn Fn()) -> Result<Floquet, FloquetError> {
        if let Some(about) = system.steady().filter(|about| about.moves()) {
            return orbit::of(scene, system, about, watch);
        }
        let courses = steady::acting(scene, system)?;
        let means: Vec<f64> = courses.iter().map(SteadyLaw::mean).collect();
        if steady::is_held(scene, system, &means)? {
            return Err(Aperiodic::Held.into());
        }
        let (period, stretches) = stretches(&courses)?;
        let modes = Modal::of(&system.matrices(&means)?)?.modes;
        let omega = || modes.iter().map(|mode| mode.omega2.sqrt()).filter(|omega| *omega > 0.0);
        let lowest = omega().reduce(f64::min).ok_or(FloquetError::Rigid)?;
        // With this unit of speed, displacements and speeds have values of the same size, and the norm of a matrix is about the highest
        // natural frequency [rad/s].
        let unit = omega().fold(lowest, f64::max);

        let split = Split::of(system, &stretches)?;
        let size = 2 * split.elastic;
        let mut monodromy = DMatrix::<f64>::identity(size, size);
        let is_stepped = courses.iter().all(|course| course.curves.is_empty());
        for stretch in &stretches {
            watch();
            let over = match system.steady() {
                None if is_stepped => split.reduced(&system.propagator(&stretch.levels, stretch.time)?, unit),
                _ => about::propagator(system, &courses, stretch, &split, unit, watch)?,
            };
            monodromy = over * monodromy;
        }
        if monodromy.iter().any(|x| !x.is_finite()) {
            return Err(FloquetError::Overflow);
        }
        let mut multipliers: Vec<Complex<f64>> = if size == 2 {
            pair(monodromy.trace(), monodromy.determinant()).to_vec()
        } else {
            monodromy.complex_eigenvalues().iter().copied().collect()
        };
        // A motion on which dampers act, but no springs, stays where it comes to rest. Its multiplier 1 says nothing about stability and is
        // removed.
        for _ in 0..split.drifting {
            let apart = |z: &Complex<f64>| (z - 1.0).norm();
            let nearest =
                (0..multipliers.len()).min_by(|&i, &j| apart(&multipliers[i]).total_cmp(&apart(&multipliers[j])));
            nearest.map(|i| multipliers.remove(i));
        }
        multipliers.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        let verdict = if size == 2 { of_one(monodromy.trace(), monodromy.determinant()) } else { of_all(&multipliers) };
        // Two multipliers follow from the trace and the determinant without cancellation.
        let rounding = if size == 2 { 0.0 } else { analysis::MULTIPLIER_ROUNDING * monodromy.amax() };
        let unresolved = leave_out(&mut multipliers, rounding);
        let mesh = courses.iter().find(|c| c.varies).map_or(0.0, SteadyLaw::mesh_frequency);
        let natural = lowest / std::f64::consts::TAU;
        let steady = system.steady().cloned();
        Ok(Floquet {
            period,
            multipliers,
            unresolved,
            rounding,
            rigid: split.rigid,
            verdict,
            natural,
            mesh,
            steady,
            orbit: None,
            is_integrated: !is_stepped,
        })
    }

    /// Why the motion meets both flanks of a mesh, in words; `None` if it meets one. Linearised friction is that of one flank, so that the
    /// multipliers are then uncertain.
    pub fn both_flanks(&self) -> Option<&str> {
        self.steady.as_ref()?.both_flanks.as_deref()
    }

    /// Exponential growth of a disturbance per period: ln of the largest absolute value of a multiplier; negative if it decays. An upper
    /// bound if no multiplier is larger than its rounding error.
    pub fn growth(&self) -> f64 {
        self.multipliers.first().map_or(self.rounding, |z| z.norm()).ln()
    }
}

/// Removes the multipliers that are smaller than their rounding error from a list in descending order. Returns their number.
fn leave_out(multipliers: &mut Vec<Complex<f64>>, rounding: f64) -> usize {
    let resolved = multipliers.iter().take_while(|z| z.norm() > rounding).count();
    multipliers.drain(resolved..).count()
}

/// The two eigenvalues of a 2 x 2 matrix from its trace and determinant, without cancellation.
fn pair(trace: f64, determinant: f64) -> [Complex<f64>; 2] {
    let d = 0.25 * trace * trace - determinant;
    if d < 0.0 {
        let z = Complex::new(0.5 * trace, (-d).sqrt());
        return [z, z.conj()];
    }
    let large = 0.5 * trace + d.sqrt().copysign(trace);
    [Complex::from(large), Complex::from(if large == 0.0 { 0.0 } else { determinant / large })]
}

/// The verdict on a single vibration. It is stable for |trace| <= 1 + determinant and determinant <= 1.
fn of_one(trace: f64, determinant: f64) -> Verdict {
    let beyond = trace.abs() - (1.0 + determinant);
    let undamped = (determinant - 1.0).abs() <= analysis::TRACE;
    match beyond {
        b if b > analysis::TRACE && trace > 0.0 => Verdict::Growing,
        b if b > analysis::TRACE => Verdict::Alternating,
        b if b >= -analysis::TRACE => Verdict::Border,
        _ if undamped => Verdict::Neutral,
        _ => Verdict::Stable,
    }
}

/// The verdict on several vibrations, from the multipliers by descending absolute value.
fn of_all(multipliers: &[Complex<f64>]) -> Verdict {
    let Some(first) = multipliers.first() else { return Verdict::Neutral };
    if first.norm() > 1.0 + analysis::UNIT_CIRCLE {
        let real = first.im.abs() <= analysis::UNIT_CIRCLE * first.norm();
        return match (real, first.re > 0.0) {
            (false, _) => Verdict::Combination,
            (true, true) => Verdict::Growing,
            (true, false) => Verdict::Alternating,
        };
    }
    if first.norm() < 1.0 - analysis::UNIT_CIRCLE {
        return Verdict::Stable;
    }
    let on = || multipliers.iter().take_while(|z| z.norm() >= 1.0 - analysis::UNIT_CIRCLE);
    let meet =
        on().enumerate().any(|(i, z)| on().take(i).any(|other| (z - other).norm() <= analysis::EQUAL_MULTIPLIERS));
    if meet { Verdict::Border } else { Verdict::Neutral }
}

/// The separation of rigid motions from the others.
struct Split {
    /// Number of rigid motions.
    rigid: usize,
    /// Number of motions that are not rigid.
    elastic: usize,
    /// Number of directions that no spring acts on, but a damper does.
    drifting: usize,
    /// E, a basis of the M-orthogonal complement of the rigid motions (n x elastic), and (EᵀME)⁻¹EᵀM.
    basis: DMatrix<f64>,
    onto: DMatrix<f64>,
}

impl Split {
    fn of(system: &System, stretches: &[Stretch]) -> Result<Split, FloquetError> {
        let first = system.linearised(&stretches[0].levels)?;
        let n = first.load.len();
        // Scale the coordinates so that M has a unit diagonal.
        let unit = first.mass.diagonal().map(|m| 1.0 / m.sqrt());
        let scaled = |a: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| a[(i, j)] * unit[i] * unit[j]);
        let mut springs = DMatrix::zeros(0, n);
        let below = |above: DMatrix<f64>, a: &DMatrix<f64>| {
            let size = a.amax();
            let rows = above.nrows();
            let mut all = above.insert_rows(rows, n, 0.0);
            all.rows_mut(rows, n).copy_from(&if size > 0.0 { a / size } else { a.clone() });
            all
        };
        for stretch in stretches {
            springs = below(springs, &scaled(&system.linearised(&stretch.levels)?.stiffness));
        }
        let held = below(springs.clone(), &scaled(&first.damping));
        let (rigid, unheld) = (null_space(&held), null_space(&springs).ncols());
        let rigid = DMatrix::from_fn(n, rigid.ncols(), |i, j| rigid[(i, j)] * unit[i]);
        let basis = null_space(&(rigid.transpose() * &first.mass * DMatrix::from_diagonal(&unit)));
        let basis = DMatrix::from_diagonal(&unit) * basis;
        if basis.ncols() == 0 {
            return Err(FloquetError::Rigid);
        }
        let momentum = basis.transpose() * &first.mass;
        let onto = (&momentum * &basis).cholesky().ok_or(Refusal::Mass)?.solve(&momentum);
        let (elastic, drifting) = (basis.ncols(), unheld - rigid.ncols());
        Ok(Split { rigid: rigid.ncols(), elastic, drifting, basis, onto })
    }

    /// A propagator of (q, q'), reduced to the motions that are not rigid, (e, e'/omega) with a unit of speed omega [1/s].
    fn reduced(&self, propagator: &DMatrix<f64>, omega: f64) -> DMatrix<f64> {
        let (n, e) = (self.basis.nrows(), self.elastic);
        let mut reduced = DMatrix::zeros(2 * e, 2 * e);
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let unit = if row == column {
                1.0
            } else if row == 1 {
                1.0 / omega
            } else {
                omega
            };
            let part = &self.onto * propagator.view((row * n, column * n), (n, n)) * &self.basis;
            reduced.view_mut((row * e, column * e), (e, e)).copy_from(&(part * unit));
        }
        reduced
    }
}

/// An orthonormal basis of the null space of a matrix of n columns.
fn null_space(a: &DMatrix<f64>) -> DMatrix<f64> {
    let n = a.ncols();
    let (values, vectors) = {
        // Pad with zero rows to at least n rows, so that the decomposition has all n right singular vectors.
        let padded = a.clone().insert_rows(a.nrows(), n.saturating_sub(a.nrows()), 0.0);
        let svd = padded.svd(false, true);
        (svd.singular_values, svd.v_t.unwrap_or_else(|| DMatrix::identity(n, n)))
    };
    let largest = values.amax();
    let null: Vec<usize> = (0..n).filter(|&i| values[i] <= analysis::RIGID * largest).collect();
    DMatrix::from_fn(n, null.len(), |i, c| vectors[(null[c], i)])
}
