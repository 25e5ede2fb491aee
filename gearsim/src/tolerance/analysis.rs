//! Tolerances of analyses: stability, modes, spectra, digits of a result, comparisons of runs.

/// A coordinate or speed is at rest if it stays below this share of the largest one with the same unit \[1\]. Its recorded values are then
/// errors that the larger ones cause. Example: the deflection of a mesh in equilibrium while its gears turn. Larger: errors of small
/// vibrations are hidden. Smaller: a result with a deflection at rest seems to have no correct digits.
pub(crate) const AT_REST: f64 = 1e-9;

/// The spring force on a coordinate in a rigid motion counts as zero below this [relative to the sum of the absolute values of its terms]:
/// the terms cancel to a few rounding errors. Smaller: a free rotation counts as held by springs. Larger: a soft support of a stiff train
/// is not seen.
pub(crate) const STRAINED: f64 = 1e-12;

/// A Floquet multiplier within this distance of the unit circle [1] counts as being on it, and one with an imaginary part below
/// this [relative] counts as real. A double multiplier has an error of sqrt(eps) = 1.5e-8. Smaller: undamped systems become
/// unstable by rounding errors. Larger: slow growth is not seen.
pub(crate) const UNIT_CIRCLE: f64 = 1e-7;
/// The tolerance for a single vibration [1]. Its stability follows from the trace and the determinant of the monodromy matrix. These do not
/// have the large error of a double eigenvalue, but only some thousand eps.
pub(crate) const TRACE: f64 = 1e-11;
/// Two multipliers on the unit circle count as equal if their distance is at most this [1]. It is about the square root of sqrt(eps) =
/// 1.5e-8, for a pair that is about to leave the circle. Larger: two vibrations with neighbouring multipliers are reported as a border of
/// stability.
pub(crate) const EQUAL_MULTIPLIERS: f64 = 1e-4;
/// Rounding error of a multiplier [relative to the largest entry of the matrix]: 64 eps, the error of eigenvalues of some ten coordinates.
/// Smaller: rounding errors are printed as multipliers. Larger: for a strong decay, only a bound of the multiplier is known.
pub(crate) const MULTIPLIER_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Singular values below this [relative to the largest] count as zero. They belong to motions that are rigid at all levels of the
/// stiffness. It is 4500 eps. Larger: soft springs vanish.
pub(crate) const RIGID: f64 = 1e-12;
/// The ratio of two mesh frequencies counts as a fraction of whole numbers if its distance from this fraction is below this [relative].
/// Speeds in scenes are written with about ten digits. Smaller: meshes with a written ratio have no common period. Larger: incommensurate
/// speeds get a common period.
pub(crate) const FREQUENCY_RATIO: f64 = 1e-9;
/// Largest number of pitches of one mesh in a common period with another mesh [pitches]: numbers of teeth are smaller. If the period is
/// longer, the analysis is refused.
pub(crate) const COMMON_PITCHES: u64 = 1000;
/// Largest number of steps in a period [steps]. With more steps the analysis is refused, because it would take minutes.
pub(crate) const PERIOD_STEPS: usize = 100_000;
/// Two steps of the stiffness count as one if the time between them is below this [relative to the period]: their times are sums of some
/// hundred terms.
pub(crate) const SAME_TIME: f64 = 1e-12;
/// Two rows of a chart have the same frequency ratios below this difference [relative].
pub(crate) const SAME_RATIO: f64 = 1e-9;

/// A parameter is a spring if K changes linearly with it, to within this [relative to the change]. Larger: parameters that K depends on
/// nonlinearly count as springs.
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
/// Relative change of start and parameters in a second run, which shows how the motion amplifies rounding errors [eps]. It is a few
/// roundings, so that every changed number differs from the old one. Larger: in a chaotic motion, the difference of the runs leaves the
/// linear range earlier.
pub(crate) const PERTURBATION: f64 = 4.0;
/// Ratio of the claimed error to the distance of the two runs [1]. Two runs may come close to each other by chance. Larger: fewer digits
/// are claimed.
pub(crate) const CLAIM_MARGIN: f64 = 10.0;
/// The largest distance of the two runs in this last part of the run counts as the distance at the end [relative to the run]. The reason:
/// differences oscillate.
pub(crate) const LAST_PART: f64 = 0.02;
/// Tolerance of the second run of a numerical method [relative to that of the run].
pub(crate) const COMPANION_TOLERANCE: f64 = 10.0;

/// Samples are too far apart if the error of the trapezoidal rule, which integrates a speed between two samples, exceeds this part of the
/// variation of the coordinate [1] (both as root mean squares). The error is that of a vibration with 3.4 samples per period, or of one
/// with two samples per period and a quarter of the variation. Smaller: resolved vibrations give a warning. Larger: lines are wrong by more
/// than a quarter without a warning.
pub(crate) const FOLDED: f64 = 0.5;
/// A mode with more samples per period than this cannot be the vibration that samples do not show [1]. It is twice the 3.4 samples of
/// [`FOLDED`], because a mode is faster than at the mid stiffness in some cells. Larger: the decay of a fast overdamped mode beside a slow
/// vibration gives a warning. Smaller: a vibration without a known mode gives none.
pub(crate) const RESOLVED: f64 = 7.0;
/// Samples per period in a rate that is recommended for a frequency that the samples cannot show [1]: its first four multiples are then
/// below half the rate. Larger: files are larger than needed. Smaller: multiples of a mesh frequency still fold.
pub(crate) const SHOWN: f64 = 10.0;
/// A coordinate counts as not varying if its squared distances from a straight line are below this [relative to the sum of its squares].
/// They are then rounding errors.
pub(crate) const STILL: f64 = 1e-24;

/// A mesh force in static equilibrium below this counts as zero [relative to the largest force of the run]. Smaller: a rounding error
/// counts as a static load. Larger: a light load has no dynamic factor.
pub(crate) const STATIC_LOAD: f64 = 1e-12;

/// A force against the load of a mesh counts as pulling above this [relative to the largest force of the run]. Smaller: the rounding error
/// of an unloaded flank counts. Larger: a mesh that lifts off its flanks for a moment is not named.
pub(crate) const PULL: f64 = 1e-9;

/// Largest deflection of teeth that is not absurd [modules]: steel teeth bend by a hundredth, plastic ones by some hundredths. Above it a
/// run has a warning. Larger: a wrong unit passes.
pub(crate) const TOOTH_DEFLECTION: f64 = 0.1;

/// Largest number of intervals of constant stiffness in a period of a settled motion [intervals]. With more, the computation of the settled
/// motion takes longer than a run, so nothing is estimated from it.
pub(crate) const ORBIT_STRETCHES: usize = 240;
/// Largest part of the initial vibration that may be left at the end of a settled motion [relative].
pub(crate) const SETTLED: f64 = 0.2;
/// The speed is constant if the torques change it by less than this over the run [relative].
pub(crate) const CONSTANT_SPEED: f64 = 1e-3;
/// A frequency band with less than this part of the coordinate's power is not compared [relative].
pub(crate) const FAINT_BAND: f64 = 1e-6;
/// A motion below this part of the largest one with the same unit is a rounding error and is not compared [relative].
pub(crate) const NO_MOTION: f64 = 1e-9;
/// Two numbers of events count as equal if they differ by at most this [events]: the ends of the run may cut off an event.
pub(crate) const COUNTED_EVENTS: f64 = 2.0;
/// Two events count as one if the time between them is below this [relative to the run].
pub(crate) const SAME_INSTANT: f64 = 1e-10;

/// Tolerance of reference runs by numerical methods [relative]. With a smaller one, rounding errors dominate.
pub(crate) const REFERENCE: f64 = 1e-13;
/// Error of a sample of a run in double-double precision [eps]: the sample is computed in plain numbers from the last event.
pub(crate) const SAMPLE_ROUNDINGS: f64 = 16.0;
/// A change of up to this part of the largest value is a rounding error, not a jump [relative].
pub(crate) const NO_JUMP: f64 = 64.0 * f64::EPSILON;
/// A motion counts as chaotic if the error of its reference exceeds this [relative]. Errors of its states then have no meaning.
pub(crate) const CHAOTIC: f64 = 1e-2;
/// Tolerance of runs with ramps [relative to the width of the ramp in pitches], and the smallest tolerance of such runs [relative]. It is
/// far below the error caused by the ramp.
pub(crate) const RAMP: f64 = 1e-2;
pub(crate) const SMALLEST_RAMP: f64 = 1e-12;

/// Length of the first steps of the propagator of a linear system with varying coefficients [1]: time times the norm of the matrix. A step
/// is halved if its error is too large. Larger: the series of a step loses digits. Smaller: more steps.
pub(crate) const MAGNUS_SPAN: f64 = 2.0;
/// Smallest share of [`MAGNUS_ERROR`] that a step may have [1]. Larger: the errors of many short steps add up to more than the allowed
/// error. Smaller: rounding errors are taken for the error of a step.
pub(crate) const MAGNUS_SHARE: f64 = 1e-3;
/// Largest number of equal steps in an interval [steps]; no step is shorter than the interval divided by it. It is about a second of
/// computing time.
pub(crate) const MAGNUS_STEPS: f64 = 1e5;
/// Two eigenvalues count as equal if their difference is below this [relative], and an eigenvalue counts as real if its imaginary part is
/// below this. Rounding errors split a double eigenvalue by sqrt(eps) = 1.5e-8. Smaller: the two eigenvalues get the same mode shape.
/// Larger: neighbouring eigenvalues get the mode shapes of a double one.
pub(crate) const EQUAL_EIGENVALUES: f64 = 1e-7;
/// An eigenvalue of a direction without a spring counts as zero below this [relative to the fastest eigenvalue]: rounding errors split a
/// double zero by about sqrt(eps). Larger: a weak damper of a rigid motion is not seen. Smaller: a rigid motion becomes a vibration.
pub(crate) const RIGID_EIGENVALUE: f64 = 1e-6;

/// The flanks count as unloaded if their friction force has its kink within this distance of the present coordinate [SI unit of the
/// coordinate]. It is ten times the distance over which the model smooths the kink, 1e-12. Larger: a light load counts as no load. Smaller:
/// the smoothed kink is not seen.
pub(crate) const NO_LOAD: f64 = 1e-11;
/// The same distance for large coordinates [relative to the coordinate]. Their rounding errors are 1e9 times smaller.
pub(crate) const NO_LOAD_PART: f64 = 1e-6;
/// Two derivatives of a force count as different if their difference is above this [relative to the sum of their absolute values]. The
/// friction of flanks is some thousandths of the spring force. Smaller: rounding errors count as a change of flank. Larger: a change of
/// flank with little friction is not seen.
pub(crate) const BEND: f64 = 1e-6;
/// Differences of derivatives below this are rounding errors [relative to the largest derivative].
pub(crate) const BEND_ROUNDING: f64 = 1e-13;
/// The forces count as balanced if they are at most this [relative to the terms of K q]. The rest are the rounding errors of the
/// coordinates, and the error of an iteration. Larger: slow motions count as rest. Smaller: equilibria are not recognised.
pub(crate) const AT_EQUILIBRIUM: f64 = 1e-8;
/// The equations count as equal at two positions if M, accelerations and derivatives of the forces differ by less than this [relative].
/// Angles of thousands of radians have rounding errors of 1e-12. Larger: a weak dependence on the position is not seen.
pub(crate) const SAME_EQUATIONS: f64 = 1e-9;
/// Longest turn in the search for the turn after which the equations repeat [pitches, or whole turns]. It is enough for a crank behind
/// several stages. Larger: the search takes seconds.
pub(crate) const TURN_PITCHES: u32 = 20_000;
/// Allowed error of the propagator of small disturbances over an interval of a period; along a motion, of one of its steps [1]. Larger:
/// multipliers lose digits. Smaller: more steps.
pub(crate) const MAGNUS_ERROR: f64 = 1e-9;
/// The same while the search for the periodic motion is farther from it than [`ORBIT_NEAR`] [1]. It decides the cost, not the multipliers.
pub(crate) const MAGNUS_FIRST_ERROR: f64 = 1e-5;
/// Tolerance of the runs over a turn [relative]: the motion and its derivatives then have ten digits.
pub(crate) const ORBIT_TOLERANCE: f64 = 1e-12;
/// The same while the search for the periodic motion is farther from it than [`ORBIT_NEAR`] [relative]. It decides the cost, not the
/// motion.
pub(crate) const ORBIT_FIRST_TOLERANCE: f64 = 1e-8;
/// A turn counts as closed if speeds and coordinates return with a difference below this [relative to the rotation, by kinetic energy].
/// Larger: the multipliers are those of a motion that does not repeat. Smaller: the errors of the run are larger.
pub(crate) const ORBIT_CLOSED: f64 = 1e-9;
/// If the search cannot reduce the difference further, it is accepted up to this, and printed [relative to the rotation].
pub(crate) const ORBIT_ACCEPTED: f64 = 1e-6;
/// Above this difference [relative to the rotation] the search first continues from turn to turn, as long as the difference falls. Larger:
/// Newton's method starts where it does not converge. Smaller: more turns if vibrations decay slowly.
pub(crate) const ORBIT_NEAR: f64 = 1e-4;
/// Largest step of Newton's method for the speed at the start of a turn [relative to this speed]. A longer step is replaced by scaling the
/// speed, which converges linearly. Larger: the derivatives of the flow are not valid over such a step. Smaller: the speed is scaled in
/// more turns.
pub(crate) const ORBIT_SPEED_STEP: f64 = 0.3;
/// Largest number of rounds in the search for a periodic motion [rounds]. A round is one step of the search, with one or several runs.
pub(crate) const ORBIT_ROUNDS: usize = 30;
/// Singular values below this count as zero in Newton's method [relative to the largest]. A turn closes for any displacement in their
/// directions, as in rigid motions. Larger: the method does not correct weakly damped vibrations. Smaller: it takes arbitrarily long steps
/// in rigid motions.
pub(crate) const ORBIT_RANK: f64 = 1e-10;

/// The speed of a point of a response curve counts as steady if the force on the rigid motion changes it by less than this over the
/// measured time [relative]. Smaller: chaotic motions, whose mean force differs from period to period, use all runs. Larger: the speed
/// drifts through narrow resonances.
pub(crate) const HELD_STEADY: f64 = 1e-4;
/// The train has come to rest if its mean speed is below this [relative to the wanted speed]. Only the reason for a speed that is not held
/// depends on it. Larger: a slow train is said to be at rest. Smaller: a train at rest that creeps under smoothed friction is not.
pub(crate) const CAME_TO_REST: f64 = 1e-4;
/// The speed is correct if the mean speed differs from the wanted one by less than this [relative]. Larger: jumps of the response are drawn
/// at wrong speeds.
pub(crate) const HELD_SPEED: f64 = 1e-3;
/// A run has lost its speed when it falls below this part of the wanted speed [relative]. The braking force is then measured from the start
/// until this time. Larger: the time to measure it is shorter. Smaller: the braking force is that at speeds far from the wanted one.
pub(crate) const HELD_PART: f64 = 0.5;
/// If the adjustment of the speed fails, a point is left out if its mean speed differs from the wanted one by more than this [relative].
/// Larger: points are drawn at wrong speeds. Smaller: points of undamped or chaotic motions are left out although they are near their
/// speed.
pub(crate) const SPEED_NOT_HELD: f64 = 0.01;
