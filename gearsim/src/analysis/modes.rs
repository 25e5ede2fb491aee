//! Natural frequencies, damping, mode shapes and energies of the cells of a scene.
//!
//! A mode is a pair of eigenvalues lambda of M lambda² + C lambda + K: natural frequency |lambda|/2 pi, damping factor
//! zeta = -Re lambda/|lambda|, damped frequency Im lambda/2 pi, mode shape phi, complex if damping couples the modes.
//!
//! About an equilibrium or a steady motion, C and K need not be symmetric (`general.rs`). Energies are those of the forces that have a
//! potential. If M and K change along the motion, the modes are those at one position; `over_a_turn` computes the natural frequencies at
//! all positions.
//!
//! - Share of a stiffness law in the strain energy: phi* (K(k) - K(k without the law)) phi/(phi* K phi), since K is linear in
//!   the laws. Share of a spring: phi* K_s phi/(phi* K phi), see `springs.rs`.
//! - Share of an inertia in the kinetic energy: phi* M_j phi/(phi* M phi), between 0 and 1, see `masses.rs`.

mod energies;
mod general;
mod linear;
pub(crate) mod masses;
pub(crate) mod parts;
pub(crate) mod springs;

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use crate::analysis::steady::SteadyLaw;
use crate::analysis::turn::Turn;
use crate::engine::Refusal;
use crate::engine::modal::{Matrices, Modal};
use crate::engine::mode::Mode;
use crate::engine::system::{Steady, System};
use crate::scene::Scene;
use crate::tolerance::analysis::NEAR_RESONANCE;

use energies::{Forms, SymmetricForm};
pub(crate) use parts::Parts;

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct CellModes {
    /// The value of each law \[SI\].
    pub levels: Vec<f64>,
    /// Names of the parameters that are stiffnesses of springs, in the order of [`Vibration::springs`].
    pub springs: Vec<&'static str>,
    /// Names of the parameters that are inertias, in the order of [`Vibration::kinetic`].
    pub inertias: Vec<&'static str>,
    /// Rigid motions first, then the others by ascending frequency.
    pub modes: Vec<Vibration>,
    /// Whether damping couples the modes of the undamped system.
    pub coupled: bool,
}

impl CellModes {
    fn new(k: &[f64], parts: &Parts, modes: Vec<Vibration>, coupled: bool) -> CellModes {
        CellModes {
            levels: k.to_vec(),
            springs: parts.springs.iter().map(|spring| spring.name).collect(),
            inertias: parts.masses.iter().map(|mass| mass.name).collect(),
            modes,
            coupled,
        }
    }
}

/// One mode.
#[derive(Debug, Clone)]
pub struct Vibration {
    /// Natural frequency \[Hz\]; 0 for a rigid motion.
    pub natural: f64,
    /// Damped natural frequency \[Hz\]; 0 if the mode does not oscillate.
    pub damped: f64,
    /// Damping factor; `None` for a rigid motion.
    pub zeta: Option<f64>,
    /// Rate at which a disturbance in this mode grows [1/s], the largest real part of its eigenvalues; 0 if none does.
    pub growth: f64,
    /// Mode shape: amplitude of each coordinate (n). The coordinate with the largest sqrt(M_ii) |phi_i| has the amplitude 1.
    pub shape: Vec<Complex<f64>>,
    /// Share of each stiffness law in the strain energy, in the order of [`Scene::stiffnesses`]; empty for a rigid motion.
    pub strain: Vec<f64>,
    /// Share of each spring in the strain energy; empty for a rigid motion.
    pub springs: Vec<f64>,
    /// Share of each inertia in the kinetic energy.
    pub kinetic: Vec<f64>,
}

/// Maximum number of cells that are analysed one by one.
pub(crate) const MOST_CELLS: usize = 64;

/// Every combination of levels, in which the first law varies fastest; empty if there are more than [`MOST_CELLS`].
pub(crate) fn combinations(courses: &[SteadyLaw]) -> Vec<Vec<f64>> {
    let count = courses.iter().map(|c| c.levels.len()).fold(1, usize::saturating_mul);
    if count > MOST_CELLS {
        return vec![];
    }
    let levels = |mut index: usize| {
        let level = |course: &SteadyLaw| {
            let at = index % course.levels.len();
            index /= course.levels.len();
            course.levels[at].0
        };
        courses.iter().map(level).collect()
    };
    (0..count).map(levels).collect()
}

/// The modes of the cell with law values `k` \[SI\], and the shares of `parts` in their energies. `watch` is called many times during the
/// computation.
///
/// # Errors
/// Those of [`Modal::of`].
pub(crate) fn of(system: &System, k: &[f64], parts: &Parts, watch: &dyn Fn()) -> Result<CellModes, Refusal> {
    let matrices = system.matrices(k)?;
    let without = |law: usize| {
        watch();
        let mut k = k.to_vec();
        k[law] = 0.0;
        system.matrices(&k).map(|m| &matrices.stiffness - m.stiffness)
    };
    let laws = (0..k.len()).map(without).collect::<Result<Vec<_>, _>>()?;
    if system.steady().is_some() {
        return Ok(general::of(&matrices, &system.linearised(k)?, k, (&laws, parts), watch));
    }
    of_matrices(&matrices, k, &laws, parts, watch)
}

/// The modes of the cell with the given `matrices`; `laws` are the parts of K that come from the laws, whose values are `k`.
///
/// # Errors
/// Those of [`Modal::of`].
pub(crate) fn of_matrices(
    matrices: &Matrices,
    k: &[f64],
    laws: &[DMatrix<f64>],
    parts: &Parts,
    watch: &dyn Fn(),
) -> Result<CellModes, Refusal> {
    let modal = Modal::watched(matrices, watch)?;
    let modes = modal.coupled.as_ref().map_or(&modal.modes, |coupled| &coupled.modes);
    let forms = Forms::of(laws, parts);
    let vibration = |(i, mode): (usize, &Mode)| {
        watch();
        vibration(mode, shape(&modal, i, mode), matrices, &forms)
    };
    let modes = modes.iter().enumerate().map(vibration).collect();
    Ok(CellModes::new(k, parts, modes, modal.coupled.is_some()))
}

/// The mode shape phi = X1 + lambda X2 in the coordinates. If a mode does not oscillate, lambda is that of its slower decay.
fn shape(modal: &Modal, i: usize, mode: &Mode) -> DVector<Complex<f64>> {
    let complex = |x: DVector<f64>| x.map(Complex::from);
    let Some(coupled) = &modal.coupled else { return complex(modal.shapes.column(i).into_owned()) };
    let w = mode.damped_frequency();
    let lambda = if w > 0.0 {
        Complex::new(-mode.sigma, w)
    } else {
        let kappa = (mode.sigma * mode.sigma - mode.omega2).max(0.0).sqrt();
        Complex::from(if mode.sigma > 0.0 { -mode.omega2 / (mode.sigma + kappa) } else { 0.0 })
    };
    let [x1, x2] = [&coupled.by_speed, &coupled.by_acceleration].map(|x| complex(&modal.shapes * x.column(i)));
    x1 + x2 * lambda
}

fn vibration(mode: &Mode, shape: DVector<Complex<f64>>, m: &Matrices, forms: &Forms) -> Vibration {
    let weight = |i: usize| m.mass[(i, i)].sqrt() * shape[i].norm();
    let heaviest = (0..shape.len()).max_by(|&i, &j| weight(i).total_cmp(&weight(j))).unwrap_or(0);
    let unit = shape[heaviest];
    let shape = shape.map(|x| x / unit);
    let energy = |form: &SymmetricForm| form.energy(&shape);
    let (kinetic, total) = (energy(&SymmetricForm::of(&m.mass)), energy(&SymmetricForm::of(&m.stiffness)));
    let rigid = mode.omega2 == 0.0;
    let share = |k: &SymmetricForm| (!rigid).then(|| if total == 0.0 { 0.0 } else { energy(k) / total });
    let omega = mode.omega2.sqrt();
    Vibration {
        natural: omega / TAU,
        damped: mode.damped_frequency() / TAU,
        zeta: (!rigid).then(|| mode.sigma / omega),
        growth: 0.0,
        strain: forms.laws.iter().filter_map(share).collect(),
        springs: forms.springs.iter().filter_map(share).collect(),
        kinetic: forms.masses.iter().map(|mass| energy(mass) / kinetic).collect(),
        shape: shape.iter().copied().collect(),
    }
}

/// Natural frequencies over a turn of a motion along which M or K change.
#[derive(Debug, Clone)]
pub(crate) struct OverATurn {
    /// How long a turn takes \[s\].
    pub time: f64,
    /// Lowest and highest natural frequency of each mode over the positions of a turn \[Hz\], by ascending frequency at each position.
    pub natural: Vec<[f64; 2]>,
}

/// The note on modes whose coefficients change along the motion.
pub(crate) const AT_A_PLACE: &str = "Coefficients change along the motion: these are the modes at this position of the cycle. They do not tell \
     whether the motion is stable; gearsim floquet does.";

/// Number of positions in a turn at which modes are computed. The inertia of a crank has few harmonics.
const PLACES: u32 = 72;

/// The natural frequencies at the positions of a turn with law values `k`, at the speeds of the start. `None` if the matrices do not change
/// along the motion, or do not repeat.
///
/// # Errors
/// Those of [`of`].
pub(crate) fn over_a_turn(scene: &Scene, mut system: System, k: &[f64]) -> Result<Option<OverATurn>, Refusal> {
    if !system.steady().is_some_and(Steady::moves) {
        return Ok(None);
    }
    let Some(Turn { shift, time, .. }) = Turn::of(scene, &system)? else { return Ok(None) };
    let (step, mut natural) = (&shift * (1.0 / f64::from(PLACES)), vec![[f64::INFINITY, 0.0f64]; shift.len()]);
    for _ in 0..PLACES {
        for (range, mode) in natural.iter_mut().zip(of(&system, k, &Parts::default(), &|| {})?.modes) {
            *range = [range[0].min(mode.natural), range[1].max(mode.natural)];
        }
        system = system.moved(&step);
    }
    Ok(Some(OverATurn { time, natural }))
}

/// A harmonic of a mesh frequency near a natural frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// Index of the law.
    pub law: usize,
    /// Number of the harmonic, from 1.
    pub harmonic: usize,
    /// Index of the mode, from 0.
    pub mode: usize,
    /// Frequency of the harmonic over that of the mode.
    pub ratio: f64,
}

/// Number of harmonics of each mesh frequency that are compared with the natural frequencies.
pub(crate) const HARMONICS: usize = 8;

/// The harmonics of the mesh frequencies within `NEAR_RESONANCE` of a damped natural frequency, the nearest first.
pub(crate) fn meetings(courses: &[SteadyLaw], cell: &CellModes) -> Vec<Meeting> {
    let mut meetings = vec![];
    for (law, course) in courses.iter().enumerate().filter(|(_, course)| course.varies) {
        for (mode, vibration) in cell.modes.iter().enumerate().filter(|(_, v)| v.damped > 0.0) {
            for harmonic in 1..=HARMONICS {
                let ratio = harmonic as f64 * course.mesh_frequency() / vibration.damped;
                if (ratio - 1.0).abs() <= NEAR_RESONANCE {
                    meetings.push(Meeting { law, harmonic, mode, ratio });
                }
            }
        }
    }
    meetings.sort_by(|a, b| (a.ratio - 1.0).abs().total_cmp(&(b.ratio - 1.0).abs()));
    meetings
}
