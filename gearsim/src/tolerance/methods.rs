//! Tolerances of numerical methods: the error of a step, the choice of the method, and the tolerances that a scene may state.

/// Tolerance of a step if the scene states none [relative to the size of each component].
pub(crate) const DEFAULT: f64 = 1e-9;
/// Tolerances that a scene may state [relative]. Below 1e-14, the rounding errors of a step are larger; above 1e-2, the error
/// estimate is meaningless. Others are refused.
pub(crate) const ALLOWED: std::ops::RangeInclusive<f64> = 1e-14..=1e-2;
/// Steps after which a run stops if the scene states no limit [steps]: some hours of computing time.
pub(crate) const STEPS: u64 = 10_000_000_000;
/// Below this tolerance [relative] the method of order 8 is cheaper than that of order 5. It decides the cost, not the accuracy.
pub(crate) const HIGH_ORDER: f64 = 1e-7;
/// A speed below this counts as zero [relative to the speed that the energy of the start allows]: the error of a smaller
/// component is measured against this size. Smaller: a component at rest forces tiny steps. Larger: small components are less
/// accurate.
pub(crate) const SMALLEST_SPEED: f64 = 1e-3;
/// Growth of the kinetic energy after which the speeds that it allows are computed again [1]: they have then doubled. Smaller: more work,
/// the same accuracy. Larger: the steps of a train that starts from rest are tiny for longer.
pub(crate) const ENERGY_GROWN: f64 = 4.0;
/// Length of the next step [relative to the one that would just meet the tolerance]. Larger: more steps are rejected.
pub(crate) const SAFETY: f64 = 0.9;
/// Smallest and largest ratio of a step's length to that of the last one [1], similar to the values of Hairer, Norsett & Wanner,
/// Solving Ordinary Differential Equations I (1993), II.4. They decide the cost, not the accuracy.
pub(crate) const STEP_RATIO: [f64; 2] = [0.2, 6.0];
/// A step is extended to the end of the cell or run if its length is then at most this [relative to the step]. Otherwise a very short step
/// would follow.
pub(crate) const LAST_STEP: f64 = 1.1;
/// Newton's method in the implicit method has converged if its error is below a limit [relative to the allowed error of the step]. The
/// limit is the smaller of this constant and the square root of the tolerance, but at least ten roundings of the state (Hairer & Wanner,
/// Solving Ordinary Differential Equations II, 1996, IV.8). Larger: its error becomes visible beside that of the step. Smaller: more
/// iterations.
pub(crate) const NEWTON: f64 = 0.03;
/// The ten roundings of [`NEWTON`] [relative to the state].
pub(crate) const NEWTON_ROUNDING: f64 = 10.0 * f64::EPSILON;
/// Longest correction of an event time by two terms of a Taylor series [fastest time of the motion]. The third term is below 1e-18 of the
/// motion. Larger: digits are lost. Smaller: more steps are repeated.
pub(crate) const LANDING: f64 = 1e-6;
/// Consecutive steps limited by stability after which the implicit method takes over [steps] (Hairer & Wanner, Solving Ordinary
/// Differential Equations II, 1996, IV.2). It decides the cost.
pub(crate) const STIFF_STEPS: u32 = 15;
/// Rejections of one step that end the run [1]: the motion is singular there, or the tolerance is below the rounding errors.
pub(crate) const REJECTIONS: u32 = 100;
/// Rounding error of a coordinate, and of a force, in the energy account [relative to it, times the number of coordinates of the train].
/// Larger: no effect on the account of a moving train. Smaller: the result for a train at rest, whose energies are only rounding errors, is
/// refuted.
pub(crate) const REST_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Largest residual of the energy account of exact cells [relative to its largest part]: the rounding errors of ill-conditioned cells, over
/// many events. Larger: wrong results pass. Smaller: sound results of ill-conditioned models are refuted.
pub(crate) const EXACT_RESIDUAL: f64 = 1e-9;
/// The same for a method with adaptive steps [tolerance of the method, times the largest part of the account]: the errors of the steps add
/// up.
pub(crate) const STEP_RESIDUAL: f64 = 1e3;
/// The same for a method with fixed steps, which has no tolerance [relative to the largest part of the account].
pub(crate) const FIXED_STEP_RESIDUAL: f64 = 1e-2;
/// The margin of a release ([`RELEASE`](super::events::RELEASE)) for methods by steps [relative to the forces of the reaction]. It is above the
/// error of a step that ends at the release. Larger: the release is late by this fraction. Smaller: by this error, a motion is held again just
/// after its release.
pub(crate) const STEP_RELEASE: f64 = 1e-9;
/// Longest step while contacts are held and torques vary [rad of the fastest harmonic of the torques]. The error of the interpolated
/// reaction is then 1e-11 of their amplitude, below the margin of a release ([`STEP_RELEASE`]). Larger: releases are missed, or found where
/// there are none.
pub(crate) const HELD_STEP: f64 = 0.5;
