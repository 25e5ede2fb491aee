//! Tolerances of analyses: stability, modes, spectra, digits of a result, comparisons of runs.

/// A coordinate or speed is at rest if it stays below this share of the largest one with the same unit \[1\]. Its recorded values are then
/// errors of the others: an example is a mesh in equilibrium while its gears turn. Larger: errors of small vibrations are hidden.
/// Smaller: a result with a deflection at rest seems to have no digits left.
pub(crate) const AT_REST: f64 = 1e-9;

/// Forces of springs along a rigid motion are zero up to this [relative to the sum of their absolute values]: they cancel to a few rounding
/// errors of each. Smaller: rounding errors hold what turns. Larger: a soft support of a stiff train is not seen.
pub(crate) const STRAINED: f64 = 1e-12;

/// A Floquet multiplier within this distance of the unit circle [1] counts as being on it, and one with an imaginary part below
/// this [relative] counts as real. A double multiplier has an error of sqrt(eps) = 1.5e-8. Smaller: undamped systems become
/// unstable by rounding errors. Larger: slow growth is not seen.
pub(crate) const UNIT_CIRCLE: f64 = 1e-7;
/// The tolerance for a single vibration [1], for which the trace and the determinant of the monodromy matrix decide. They have no
/// double roots, so their error is some thousand eps.
pub(crate) const TRACE: f64 = 1e-11;
/// Two multipliers on the unit circle coincide if their distance is at most this [1]: the root of sqrt(eps) = 1.5e-8, for a pair
/// that is about to leave the circle. Larger: neighbouring vibrations are reported as a border of stability.
pub(crate) const EQUAL_MULTIPLIERS: f64 = 1e-4;
/// Rounding error of a multiplier [relative to the largest entry of the matrix]: 64 eps, the error of eigenvalues of some ten coordinates.
/// Smaller: rounding errors are printed as multipliers. Larger: strong decay is only bounded.
pub(crate) const MULTIPLIER_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Singular values below this [relative to the largest] count as zero: rigid motions of all stiffness levels. It is 4500 eps.
/// Larger: soft springs vanish.
pub(crate) const RIGID: f64 = 1e-12;
/// The ratio of two mesh frequencies is a fraction if it is this close to one [relative]. Speeds in scenes are written with about
/// ten digits. Smaller: written ratios have no common period. Larger: incommensurate speeds get one.
pub(crate) const FREQUENCY_RATIO: f64 = 1e-9;
/// Largest number of pitches of one mesh in a common period with another [pitches]: numbers of teeth are smaller. Otherwise the
/// analysis is refused.
pub(crate) const COMMON_PITCHES: u64 = 1000;
/// Largest number of steps in a period [steps]; the analysis is refused above it, since it would take minutes.
pub(crate) const PERIOD_STEPS: usize = 100_000;
/// Two steps of the stiffness closer than this are one [relative to the period]: their times are sums of some hundred terms.
pub(crate) const SAME_TIME: f64 = 1e-12;
/// Two rows of a chart have the same frequency ratios below this difference [relative].
pub(crate) const SAME_RATIO: f64 = 1e-9;

/// A parameter is a spring if K changes linearly with it, to within this [relative to the change]. Larger: parameters that act
/// otherwise count as springs.
pub(crate) const LINEAR_STIFFNESS: f64 = 1e-9;
/// Rounding error of a difference of two stiffness matrices [relative to the largest entry].
pub(crate) const STIFFNESS_ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A harmonic of the mesh frequency is reported if it is this close to a damped natural frequency [relative].
pub(crate) const NEAR_RESONANCE: f64 = 0.1;

/// Samples are evenly spaced if their intervals differ by less than this [relative], in addition to the rounding error of the
/// times. Times read from a file have six digits or more.
pub(crate) const EVEN_SPACING: f64 = 1e-6;
/// Rounding error of the difference of two times [relative to the time].
pub(crate) const TIME_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Decimal digits of a plain number and of a double-double number [digits]: -log10 of half an eps, and of 1e-31.
pub(crate) const PLAIN_DIGITS: f64 = 15.95;
pub(crate) const COMPENSATED_DIGITS: f64 = 31.0;
/// Relative change of start and parameters [eps] that shows how the motion amplifies rounding errors. It is a few roundings, so
/// that every changed number differs from the old one. Larger: it leaves the linear range earlier in a chaotic motion.
pub(crate) const PERTURBATION: f64 = 4.0;
/// Claimed error over the distance of the two runs [1]. Two runs may come close to each other by chance. Larger: fewer digits are
/// claimed.
pub(crate) const CLAIM_MARGIN: f64 = 10.0;
/// The largest distance over this last fraction of the run counts as that at the end [relative to the run]: differences
/// oscillate.
pub(crate) const LAST_PART: f64 = 0.02;
/// Tolerance of the second run of a numerical method [relative to that of the run].
pub(crate) const COMPANION_TOLERANCE: f64 = 10.0;

/// Samples are too far apart if the trapezoidal rule misses this part of a coordinate's variation (root mean square) between two of them [1]:
/// that of a vibration with 3.6 samples a period, or with two samples and a quarter of the variation. Smaller: vibrations that are resolved are
/// named. Larger: lines are wrong by more than a quarter without a warning.
pub(crate) const FOLDED: f64 = 0.5;
/// A coordinate does not vary if its variation about a line is below this [relative to its size, squares]: rounding errors.
pub(crate) const STILL: f64 = 1e-24;

/// Below this, a mesh force in static equilibrium counts as zero [relative to the largest force of the run]. Smaller: a rounding error is a static load.
/// Larger: a light load has no dynamic factor.
pub(crate) const STATIC_LOAD: f64 = 1e-12;

/// Largest number of stretches of constant stiffness in a period of a settled motion [stretches]. With more, its computation
/// takes longer than a run, so none is estimated.
pub(crate) const ORBIT_STRETCHES: usize = 240;
/// Largest part of the initial vibration that may be left at the end of a settled motion [relative].
pub(crate) const SETTLED: f64 = 0.2;
/// The speed is constant if the torques change it by less than this over the run [relative].
pub(crate) const CONSTANT_SPEED: f64 = 1e-3;
/// A frequency band with less than this part of the coordinate's power is not compared [relative].
pub(crate) const FAINT_BAND: f64 = 1e-6;
/// A motion below this part of the largest one with the same unit is a rounding error and is not compared [relative].
pub(crate) const NO_MOTION: f64 = 1e-9;
/// A difference of up to this number of events is not counted [events]: the ends of the run may cut one more.
pub(crate) const COUNTED_EVENTS: f64 = 2.0;
/// Two events closer than this are one [relative to the run].
pub(crate) const SAME_INSTANT: f64 = 1e-10;

/// Tolerance of references by numerical methods [relative]. Below it rounding errors dominate.
pub(crate) const REFERENCE: f64 = 1e-13;
/// Error of a sample of a compensated run [eps]: it is computed in plain numbers from the last event.
pub(crate) const SAMPLE_ROUNDINGS: f64 = 16.0;
/// A change of up to this part of the largest value is a rounding error, not a jump [relative].
pub(crate) const NO_JUMP: f64 = 64.0 * f64::EPSILON;
/// A motion is chaotic if the error of its reference exceeds this [relative]: errors of its states then mean nothing.
pub(crate) const CHAOTIC: f64 = 1e-2;
/// Tolerance of runs with ramps [relative to the width of the ramp in pitches], and the smallest one [relative]. It is far below
/// the error caused by the ramp.
pub(crate) const RAMP: f64 = 1e-2;
pub(crate) const SMALLEST_RAMP: f64 = 1e-12;

/// First steps of the propagator of a linearised system whose coefficients vary [1]: time times the norm of its matrix. Steps are halved where
/// the error is not small. Larger: the series of a step loses digits. Smaller: more steps.
pub(crate) const MAGNUS_SPAN: f64 = 2.0;
/// Smallest share of [`MAGNUS_ERROR`] that a step may have [1]. Larger: many short steps add up to more than that error. Smaller: rounding
/// errors are taken for it.
pub(crate) const MAGNUS_SHARE: f64 = 1e-3;
/// Most steps of one length in a stretch [steps]: a second of computing time.
pub(crate) const MAGNUS_STEPS: f64 = 1e5;
/// Two eigenvalues are equal, or one is real, if they differ, or its imaginary part is, less than this [relative]. A double one splits by
/// the root of a rounding, 1.5e-8. Smaller: its two shapes are one. Larger: neighbours share shapes.
pub(crate) const EQUAL_EIGENVALUES: f64 = 1e-7;
/// An eigenvalue of a direction without a spring is zero below this [relative to the fastest]: a double zero splits by the root of a
/// rounding. Larger: a weak damper of a rigid motion is not seen. Smaller: rigid motions vibrate.
pub(crate) const RIGID_EIGENVALUE: f64 = 1e-6;

/// Flanks bear no load if the friction between them bends within this distance of their deflection [SI unit of the coordinate]: ten times
/// the distance over which the model smooths the bend, 1e-12. Larger: a light load counts as none. Smaller: the smoothed bend is not seen.
pub(crate) const NO_LOAD: f64 = 1e-11;
/// The same [relative to the coordinate], whose rounding errors are 1e9 times smaller.
pub(crate) const NO_LOAD_PART: f64 = 1e-6;
/// Two slopes of a force differ above this [relative to their sum]: friction of the flanks is some thousandths of the spring's force. Smaller:
/// rounding errors are taken for another flank. Larger: the flanks of a mesh with little friction are not told apart.
pub(crate) const BEND: f64 = 1e-6;
/// Slopes below this are rounding errors [relative to the largest].
pub(crate) const BEND_ROUNDING: f64 = 1e-13;
/// The forces are in balance if they are at most this [relative to the terms of K q]: coordinates have rounding errors, and iterations end.
/// Larger: slow motions count as rest. Smaller: equilibria are not recognised.
pub(crate) const AT_EQUILIBRIUM: f64 = 1e-8;
/// The equations are the same at two places if M, accelerations and derivatives of the forces differ by less than this [relative]. Angles
/// of thousands of radians have rounding errors of 1e-12. Larger: a weak dependence on the position is not seen.
pub(crate) const SAME_EQUATIONS: f64 = 1e-9;
/// Largest turn that is sought along which equations change [pitches, or whole turns]: a crank behind several stages. Larger: the search takes
/// seconds.
pub(crate) const TURN_PITCHES: u32 = 20_000;
/// Error of the propagator of small disturbances over a stretch of a period, and of a step of it along a motion [1]. Larger: multipliers lose digits. Smaller: more steps.
pub(crate) const MAGNUS_ERROR: f64 = 1e-9;
/// The same while the motion that repeats is farther away than [`ORBIT_NEAR`] [1]. It decides the cost, not the multipliers.
pub(crate) const MAGNUS_FIRST_ERROR: f64 = 1e-5;
/// Tolerance of the runs of a turn [relative]: the motion and its derivatives have ten digits.
pub(crate) const ORBIT_TOLERANCE: f64 = 1e-12;
/// The same while the motion that repeats is farther away than [`ORBIT_NEAR`] [relative]. It decides the cost, not the motion.
pub(crate) const ORBIT_FIRST_TOLERANCE: f64 = 1e-8;
/// A turn is closed if speeds and places return to this [relative to the rotation, by kinetic energy]. Larger: multipliers are those of a
/// motion that does not repeat. Smaller: the errors of the run decide.
pub(crate) const ORBIT_CLOSED: f64 = 1e-9;
/// A turn that the search does not close further is accepted up to this, and its gap is printed [relative to the rotation].
pub(crate) const ORBIT_ACCEPTED: f64 = 1e-6;
/// Farther from closed than this [relative to the rotation], turns are taken one after another as long as they come closer. Larger: Newton's
/// method starts where it does not converge. Smaller: more turns where vibrations decay slowly.
pub(crate) const ORBIT_NEAR: f64 = 1e-4;
/// Largest step of Newton's method on the speed at the start of a turn \[of this speed\]. Larger: the derivatives of the flow do not reach so
/// far. Smaller: the speed comes closer by a constant factor a turn for longer.
pub(crate) const ORBIT_SPEED_STEP: f64 = 0.3;
/// Largest number of runs in the search of a motion that repeats [runs].
pub(crate) const ORBIT_ROUNDS: usize = 30;
/// Singular values below this count as zero [relative to the largest]: a turn closes for any displacement in their directions, as for rigid
/// motions. Larger: weakly damped vibrations do
/// not settle. Smaller: rigid motions run away.
pub(crate) const ORBIT_RANK: f64 = 1e-10;

/// A point of a response curve is held at its speed if the force on the rigid motion changes it by less than this over the measured time
/// [relative]. Smaller: chaotic motions, whose mean force differs from period to period, take all runs. Larger: the speed drifts through
/// narrow resonances.
pub(crate) const HELD_STEADY: f64 = 1e-4;
/// And if its mean speed is this close to the wanted one [relative]. Larger: jumps are drawn at other speeds than where they are.
pub(crate) const HELD_SPEED: f64 = 1e-3;
/// A run that has less than this part of its wanted speed has lost it [relative]: the force that braked it is measured until then. Larger: less
/// time to measure it. Smaller: the drag of a speed far from the wanted one.
pub(crate) const HELD_PART: f64 = 0.5;
/// A point whose speed was adjusted without success is no result if its mean speed differs by more than this from the wanted one [relative].
/// Larger: points are drawn at other speeds than theirs. Smaller: points of undamped or chaotic motions near their speed are left out.
pub(crate) const SPEED_NOT_HELD: f64 = 0.01;
