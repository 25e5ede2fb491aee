//! Tolerances of events: the search for the first crossing of a boundary, and the first root of a polynomial.

/// Margin of a bound on the motion [relative]. A bound is a sum over the modes with a few roundings for each mode. 4500 eps are enough for
/// a thousand modes. Smaller: rounding errors could make a bound too low, and a crossing could be missed. Larger: more flights are searched
/// step by step.
pub(crate) const BOUND_MARGIN: f64 = 1e-12;

/// Margin of the time interval that contains the crossing of a monotone phase [relative]. It is 4.5 eps; the ends of the interval have two
/// or three roundings. Smaller: the root could lie outside the interval. Larger: no effect on the root.
pub(crate) const BRACKET_MARGIN: f64 = 1e-15;

/// Depth of a graze [relative to the distance between the two boundaries]: a boundary that is touched, but not passed by more
/// than this, is not crossed. A phase is known to a few roundings of this distance. Smaller: rounding errors decide whether a
/// touch is an event. Larger: shallow crossings are missed.
pub(crate) const GRAZE_DEPTH: f64 = 4.0 * f64::EPSILON;

/// Width of the bracket at which a search by bisection ends [relative to the time of the root]. Neighbouring numbers are up to 1
/// eps apart, so about 2 eps can be reached. Larger: the time of the event loses digits.
pub(crate) const BRACKET_WIDTH: f64 = 4.0 * f64::EPSILON;

/// Error of a root at which Newton's method ends [relative to the root]: one rounding. Smaller: it cannot be reached. Larger: the
/// time of the event loses digits.
pub(crate) const ROOT_ERROR: f64 = f64::EPSILON;

/// Remainder of the power series of a departure [relative to the speed at the start] up to which its root is used: one rounding.
/// Larger: the return to the boundary loses digits. Smaller: the step-by-step search finds it instead, at a higher cost.
pub(crate) const DEPARTURE_REMAINDER: f64 = f64::EPSILON;

/// Longest departure that is computed by power series [1]: time times the fastest rate. The remainder after 12 derivatives is then
/// 0.25¹³/14! = 2e-19 of the motion. Larger: the remainder exceeds the rounding error. Smaller: the step-by-step search is used more often.
pub(crate) const DEPARTURE_SPAN: f64 = 0.25;

/// Largest second-order term of a reverted Taylor series [relative to the first-order term] for which its root is accepted. The
/// terms then fall by a factor of five or more. Larger: the series may lead to another root, and the bracket corrects it.
/// Smaller: more bisections. It decides the cost, not the root.
pub(crate) const REVERSION_LIMIT: f64 = 0.1;

/// A root is accepted as the only root if 2 B f is below this fraction of r² [1]. Here f is the distance, r the approach speed, and B the
/// bound on the acceleration. The speed at the root is then at least sqrt(1 - 0.99) = 0.1 of r. Closer to 1: Newton's method becomes slow
/// near a graze. Smaller: the search takes more steps.
pub(crate) const SINGLE_ROOT: f64 = 0.99;

/// Steps of one search after which the run ends with an error [steps]. They take about a second of computing time; a search of a
/// scene with sensible numbers takes far fewer.
pub(crate) const SEARCH_STEPS: u64 = 1_000_000;

/// Rounding error of a polynomial's coefficient [relative to the coefficient], subtracted before the sign is decided. It covers
/// the few operations of a coefficient and its change to Bernstein's basis. Smaller: a root could be missed. Larger: more
/// bisections.
pub(crate) const BERNSTEIN_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Rounding error of a derivative of a signal [relative to the sum of the absolute values of its terms]. A term has three or four
/// roundings. Smaller: a proof that there is no crossing could fail. Larger: shorter steps of the search.
pub(crate) const SIGNAL_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Rounding error of the distance to a boundary during a vibration [relative to distance plus amplitude]. The distance is the difference of
/// two sums of such terms. Smaller: a crossing could be missed. Larger: shorter steps of the search.
pub(crate) const REACH_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A dense output is not searched if the sum of the absolute values of its coefficients c_1, c_2, ... is below this [relative to c_0]: it
/// then stays above (1 - 0.999) c_0. Smaller: more searches that find nothing. Larger: at 1, rounding errors of the sum could hide a root.
pub(crate) const DENSE_FAR: f64 = 0.999;

/// Rounding error of the coefficients of a dense output [tolerance of the root search]: they are differences of states, times numbers up to
/// some tens. If all coefficients of a polynomial are below this, its sign within the step is not known. Smaller: rounding errors become
/// events. Larger: slow departures from a boundary are found a step late.
pub(crate) const DENSE_NOISE: f64 = 16.0;

/// Bisections after which an interval of the root search is a point [1]: 2⁻⁵² of the step is 1 eps. More have no effect.
pub(crate) const ROOT_HALVINGS: u32 = 52;

/// Longest correction of an event time in double-double precision by a second-order Taylor polynomial [1]. It limits the correction times
/// the fastest rate of the cell, and the relative correction by the curvature. The omitted third-order term is 1e-30. Larger: digits are
/// lost. Smaller: one more iteration.
pub(crate) const COMPENSATED_TAYLOR: f64 = 1e-10;

/// Largest correction of an event time in double-double precision [fastest time of the cell]. Times in plain precision have errors of a few
/// roundings, near a graze of the square root of a rounding. Larger: the time of another event could be found. Smaller: an event near a
/// graze keeps its plain time.
pub(crate) const COMPENSATED_CORRECTION: f64 = 1e-6;

/// A phase that is pressed against a step is held if the energy of its normal motion is below this [relative to T + V]. The neglected
/// energy is in the energy account. Larger: visible energy is neglected. Smaller: more bounces are computed, up to a cascade.
pub(crate) const HOLD_ENERGY: f64 = 1e-12;

/// A bounce is short if its duration times the fastest rate of the cell is below this [1]. The force then changes by at most 1e-3 during
/// the bounce. Larger: vibrating contacts are held. Smaller: they are held later, after more events.
pub(crate) const SHORT_BOUNCE: f64 = 1e-3;

/// A hold in an exact cell ends if its reaction exceeds its bound by this [relative to the forces it consists of], and by the rounding errors
/// of the coordinates and speeds. It is a few roundings: the motion after the hold must begin with the sign of the reaction. Larger: the release is
/// late by this fraction, and stick-slip amplifies the delay. Smaller: by rounding errors, a motion is held again just after its release.
pub(crate) const RELEASE: f64 = 16.0 * f64::EPSILON;

/// The step of a law acts on a single deflection if its matrix and its load differ by less than this from those of one deflection [relative
/// to the largest entry]. They are products of a few numbers. Larger: several deflections count as one. Smaller: because of rounding
/// errors, a phase stays held although its step has vanished.
pub(crate) const ONE_DEFLECTION: f64 = 1e-10;

/// The step of a law is quadratic in the coordinates if it differs by less than this from the quadratic form of its matrices [relative to
/// the largest term]. Larger: a step that is not quadratic counts as one, and its zeros are wrong. Smaller: because of rounding errors, a
/// phase stays held although its step has vanished.
pub(crate) const QUADRATIC_STEP: f64 = 1e-10;

/// The two zeros of a step count as a double zero if half their distance, squared, is below this [relative to the square of their mean].
/// This square is the difference of two numbers of the size of the square of the mean. Larger: two zeros count as one. Smaller: rounding
/// errors split a double zero, or remove it.
pub(crate) const DOUBLE_ZERO: f64 = 1e-10;

/// Consecutive events within this time are a cascade [fastest time of the motion]. Larger: a fast sequence of events in a correct motion
/// ends the run. Smaller: a run without progress continues.
pub(crate) const CASCADE_SPAN: f64 = 1e-6;

/// Number of events of a cascade after which the run ends with an error [events]. It takes some tenths of a second of computing time.
pub(crate) const CASCADE_EVENTS: u64 = 100_000;

/// The order of two simultaneous steps matters if the speeds differ by more than this [relative to the largest speed]. Larger:
/// ambiguous results are not reported. Smaller: rounding errors are reported as ambiguous.
pub(crate) const ORDER: f64 = 1e-9;

/// Numbers of mode changes of switches at one time above which they are attributed to rounding errors [changes per switch, and in total].
/// They are larger than the number of contacts and dampers of a train that can change together. Smaller: an event at the same time as
/// others is late by a rounding error of its deflection. Larger: flanks rattle by rounding errors for longer.
pub(crate) const EVENTS_AT_ONE_TIME: (u32, u32) = (4, 16);

/// Time in which a rate counts as unchanged [1: time times the fastest rate]. If a clutch or dry friction changes its mode twice within
/// this time, errors of the rate are the cause. Smaller: it continues to rattle. Larger: fast stick-slip is taken for rattling.
pub(crate) const NO_TIME: f64 = 1e-9;

/// How often the margin of a guard is doubled while its switch rattles [1]. The margin grows to 1e6 times the rounding error of the guard,
/// which is the error of a numerical method with a loose tolerance. Smaller: the switch rattles until the run is stopped. Larger: no
/// effect, because the first sufficient margin ends the rattling.
pub(crate) const DOUBLINGS: u32 = 20;

/// Rounding error of the guard of a switch near zero [relative to the absolute values of its constant part and of the transmission errors
/// in it; for a play, half the play plus its offset]. If flanks meet and part repeatedly at one time, a guard must be violated by this
/// before the mode changes. An impulse must also violate a guard by this. Smaller: flanks continue to rattle. Larger: no effect on other
/// motions.
pub(crate) const EDGE_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Largest cost of computing the modes of all cells before the run [number of cells times the cube of the number of coordinates]. It is
/// some 50 ms. If the cost is higher, each cell is computed when it is first entered. Smaller: scenes with few cells look them up in a hash
/// table. Larger: runs wait for cells that they never enter.
pub(crate) const CELLS_IN_ADVANCE: usize = 100_000;

/// Rounding error of a sum over the modes at the start of a motion under loads that vary [relative to the sum of absolute values]. Mode shapes
/// have some hundred roundings. Smaller: flanks separate by the rounding errors of balanced forces. Larger: weak forces are neglected.
pub(crate) const BALANCED_RATES: f64 = 1024.0 * f64::EPSILON;

/// Longest window of a power series in double-double numbers [1]: time times the fastest rate of cell and load. After its 40 terms, the
/// remainder is 2⁴⁰/40! < 2e-36 of the motion.
/// Larger: digits are lost to cancellation. Smaller: more windows.
pub(crate) const WINDOW_SPAN: f64 = 2.0;

/// A phase within this distance of a boundary at the end of the run has reached it [rounding errors of the phase]. The distance that the
/// phase covers in half a unit in the last place of the time is added. Smaller: a run that is split at this time loses an event. Larger: an
/// event after the end of the run is counted.
pub(crate) const END_OF_RUN: f64 = 2.0;

/// Two guards are multiples of each other if each coefficient of the first is that of the second times one common factor, up to this
/// [relative to the coefficient]. Coefficients are products of a few numbers, whose rounding errors are 1e3 times smaller.
pub(crate) const SAME_GUARD: f64 = 1e-12;

/// A deflection is at rest if its rate is smaller than this [relative to the rate that the kinetic energy of the whole train allows]:
/// rounding errors of the speeds are 1e4 times smaller. It decides whether a held deflection is still at rest after an impulse. It also
/// decides how far flanks must separate before their next contact counts as an impact: this rate times the time. Larger: slow slip counts
/// as rest, with its energy in the account as neglected, and impacts after slow separations are not counted.
pub(crate) const AT_REST: f64 = 1e-12;

/// A motion is possible while others are held if its compliance is then larger than this [relative to its compliance without holds]. The
/// rounding error of this compliance is 1e3 times smaller.
pub(crate) const INDEPENDENT: f64 = 1e-12;

/// Rounding error of the mobility that remains with holds [relative to the mobility without them, times the number of coordinates]. Larger:
/// a heavy part that is held to a light one does not move. Smaller: by rounding errors, forces move held parts.
pub(crate) const HELD_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Number of cells with holds that are stored for the next time they are entered [cells]. It decides the memory, not the accuracy.
pub(crate) const HELD_CELLS: usize = 4096;

/// If a phase turns back within this distance of a boundary, the kernel of plain events leaves it to the general search [relative to the
/// width of the cell plus the distance that the phase has moved]. Rounding errors of this distance are 1e6 times smaller. Smaller: rounding
/// errors could decide whether a boundary is reached. Larger: more events are left to the general search.
pub(crate) const TURN_NEAR: f64 = 1e-9;

/// Error of the crossing time at which the search for the crossing of a reversing phase ends [fastest time of the cell]. It is half of the
/// longest shift by the series, with which the kernel continues from there. It decides the cost.
pub(crate) const TURN_STEP: f64 = 4e-3;
/// Longest step of that search by the series of the phase [fastest time of the cell]. In a longer step the omitted terms may be the larger
/// ones, so Newton's step is taken instead. It decides the cost.
pub(crate) const TURN_REACH: f64 = 1.0;

/// The kernel evaluates the motion in a cell in advance, at the predicted end of the next passage, if the error of the last prediction was
/// below this [fastest time of the cell]. A prediction is used if its error is below `modes::FAR_SHIFT_SPAN`. It decides the cost.
pub(crate) const WORTH_PREDICTING: f64 = 0.1;
