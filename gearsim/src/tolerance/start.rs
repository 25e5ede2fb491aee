//! Tolerances of the static equilibrium at the start.
//!
//! Displacements are compared by their strain energy, because it has the same unit for coordinates in m and in rad.

/// The potential energy is concave if a curvature, scaled to a unit diagonal, is below minus this [1]: 4500 eps. Smaller: in a flat
/// potential, rounding errors reverse the step. Larger: the iteration may go uphill, to an unstable equilibrium.
pub(crate) const FLAT: f64 = 1e-12;
/// The iteration has converged if its step is below this [relative to the largest displacement reached, square root of strain
/// energy].
pub(crate) const CONVERGED: f64 = 4.0 * f64::EPSILON;
/// The iteration also ends at a step below this [relative, as above] that is not smaller than half the previous step: the remaining step is
/// the rounding error of the forces. Smaller: ill-conditioned equilibria are refused. Larger: a slowly converging iteration ends too early.
pub(crate) const STALLED: f64 = 1e-8;
/// Two equilibria are the same if their coordinates differ by less than this [relative to the larger]. It is 100 times the error
/// of an iteration that stalled. Larger: neighbouring equilibria are reported as one.
pub(crate) const SAME: f64 = 1e-6;
/// The strain energy of a motion counts as zero below this [relative to the sum of the absolute values of its terms, or to the energy of
/// the stiffest coordinate at the same kinetic energy]: the terms cancel to a few rounding errors. Smaller: rounding errors count as
/// springs that hold a rotation. Larger: a soft support of a stiff train is not seen.
pub(crate) const STRAINED: f64 = 1e-14;
/// A motion counts as a linear combination of others if the kinetic energy of its remainder is below this [relative to the kinetic energy
/// of the motion]. The remainder then consists of rounding errors. Smaller: rounding errors count as motions. Larger: a light rotor has no
/// acceleration of its own.
pub(crate) const SAME_MOTION: f64 = 1e-14;
/// Rigid motions contribute to a held rate if their share of its compliance is above this [relative to its compliance]. It is the square of
/// about 1e6 rounding errors. Larger: a light rotor behind a clutch turns freely. Smaller: rounding errors of rigid motions are held.
pub(crate) const TAKES_PART: f64 = 1e-18;
/// Torques on a rigid motion count as balanced if their sum is below this [relative to the sum of their absolute values]: a governor or a
/// damper cancels a torque to some rounding errors. Smaller: the iteration follows rounding errors. Larger: a weak torque causes no
/// acceleration.
pub(crate) const BALANCED: f64 = 1e-13;
/// Largest number of steps of the iteration, boundaries included; then the scene is refused [1]. Newton's method needs about ten, and a
/// phase crosses a few boundaries.
pub(crate) const STEPS: usize = 200;
/// A search for another equilibrium starts at this distance, slightly beyond a boundary [relative to the distance of the boundary].
pub(crate) const BEYOND: f64 = 1.001;
/// A reaction in the equilibrium is within its bound if it exceeds it by less than this [relative to the reaction]: far more than the rounding
/// errors of an iteration that has converged. Smaller: a reaction at its bound breaks the hold by rounding errors. Larger: a hold that must
/// break is kept at the start.
pub(crate) const REACTION: f64 = 1e-9;
