//! Tolerances of the static equilibrium at the start.
//!
//! Displacements are compared by their strain energy, which has one unit for coordinates in m and in rad.

/// The potential energy is concave if a curvature, scaled to a unit diagonal, is below minus this [1]: 4500 eps. Smaller:
/// rounding errors of a flat potential turn the step around. Larger: the iteration may go uphill, to an unstable equilibrium.
pub(crate) const FLAT: f64 = 1e-12;
/// The iteration has converged if its step is below this [relative to the largest displacement reached, square root of strain
/// energy].
pub(crate) const CONVERGED: f64 = 4.0 * f64::EPSILON;
/// The iteration also ends at a step below this [relative, as above] that is not smaller than half the last one: the rest is the
/// rounding error of the forces. Smaller: ill-conditioned balances are refused. Larger: a slowly converging iteration ends too
/// early.
pub(crate) const STALLED: f64 = 1e-8;
/// Two equilibria are the same if their coordinates differ by less than this [relative to the larger]. It is 100 times the error
/// of an iteration that stalled. Larger: neighbouring equilibria are reported as one.
pub(crate) const SAME: f64 = 1e-6;
/// Springs have no energy in a motion up to this [relative to the sum of the absolute values, or to the stiffest coordinate]: its terms cancel
/// to a few rounding errors of each. Smaller: rounding errors count as springs that hold a rotation. Larger: a soft support of a stiff train is not seen.
pub(crate) const STRAINED: f64 = 1e-14;
/// A motion is a sum of others if its remainder has less kinetic energy than this [relative to its own]: the rounding errors of its squares.
/// Smaller: rounding errors are motions. Larger: a light rotor does not accelerate by itself.
pub(crate) const SAME_MOTION: f64 = 1e-14;
/// Rigid motions take part in a held rate if their share of its compliance is above this [relative to its compliance]: the square of 1e6 rounding errors.
/// Larger: a light rotor behind a clutch turns freely. Smaller: rounding errors of rigid motions are held.
pub(crate) const TAKES_PART: f64 = 1e-18;
/// Torques on a rigid motion are in balance if their sum is below this [relative to the sum of their sizes]: a governor or a damper cancels
/// a torque to some rounding errors. Smaller: the iteration follows rounding errors. Larger: a weak torque accelerates nothing.
pub(crate) const BALANCED: f64 = 1e-13;
/// Steps of the iteration, boundaries included, after which the scene is refused [1]. Newton's method needs about ten, and a
/// phase crosses a few boundaries.
pub(crate) const STEPS: usize = 200;
/// A search for other equilibria starts this much beyond a boundary [relative to the distance of the boundary], not on it.
pub(crate) const BEYOND: f64 = 1.001;
