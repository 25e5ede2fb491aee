//! Tolerances of events: the search for the first crossing of a boundary, and the first root of a polynomial.

/// Margin of a bound on the motion [relative]. A bound is a sum over the modes, a few roundings each; 4500 eps cover a thousand
/// modes. Smaller: rounding errors could make a bound too low, and a crossing could be missed. Larger: more flights are searched
/// step by step.
pub(crate) const BOUND_MARGIN: f64 = 1e-12;

/// Margin of the time interval that contains the crossing of a monotone phase [relative]. It is 4.5 eps, and the ends of the
/// interval have two or three roundings. Smaller: the root could lie outside the interval. Larger: no effect on the root.
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

/// Longest departure that is computed by power series [1]: time times the fastest rate. The remainder of 12 derivatives is then
/// 0.25¹³/14! = 2e-19 of the motion. Larger: the remainder exceeds the rounding error. Smaller: the step-by-step search does more
/// of the work.
pub(crate) const DEPARTURE_SPAN: f64 = 0.25;

/// Largest second-order term of a reverted Taylor series [relative to the first-order term] for which its root is accepted. The
/// terms then fall by a factor of five or more. Larger: the series may lead to another root, and the bracket corrects it.
/// Smaller: more bisections. It decides the cost, not the root.
pub(crate) const REVERSION_LIMIT: f64 = 0.1;

/// A root counts as the only one if 2 B f is below this fraction of r² [1], with the distance f, the approach speed r and the
/// bound B on the acceleration. The speed at the root is then at least sqrt(1 - 0.99) = 0.1 of r. Closer to 1: Newton's method
/// becomes slow near a graze. Smaller: the search takes more steps.
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

/// Rounding error of the distance to a boundary beside a vibration [relative to distance plus amplitude]. It is the difference of
/// two sums of such terms. Smaller: a crossing could be missed. Larger: shorter steps of the search.
pub(crate) const REACH_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Largest sum of the sizes of the coefficients c_1, c_2, ... of a dense output for which it is not searched [c_0]: it then stays above
/// (1 - 0.999) c_0. Smaller: more searches that find nothing. Larger: at 1, rounding errors of the sum could hide a root.
pub(crate) const DENSE_FAR: f64 = 0.999;

/// Rounding error of the coefficients of a dense output [tolerance of the root search]: they are differences of states, times
/// numbers up to some tens. A polynomial whose coefficients are all below this has no sign of its own within the step. Smaller:
/// rounding errors become events. Larger: slow departures from a boundary are found a step late.
pub(crate) const DENSE_NOISE: f64 = 16.0;

/// Bisections after which an interval of the root search is a point [1]: 2⁻⁵² of the step is 1 eps. More have no effect.
pub(crate) const ROOT_HALVINGS: u32 = 52;

/// Longest correction of an event time that double-double numbers make by a second-order Taylor polynomial [1]: its length in the
/// fastest time of the cell, and its curvature. The omitted cube is 1e-30. Larger: digits are lost. Smaller: one more iteration.
pub(crate) const COMPENSATED_TAYLOR: f64 = 1e-10;

/// Largest correction of an event time by double-double numbers [fastest time of the cell]. Plain times have errors of a few roundings, and
/// of their square root near a graze. Larger: the time of another event could be found. Smaller: an event near a graze keeps its plain time.
pub(crate) const COMPENSATED_CORRECTION: f64 = 1e-6;

/// A pressed phase is held if the energy of its normal motion is below this [relative to T + V]. The neglected energy is in the
/// account. Larger: visible energy is neglected. Smaller: more bounces are computed, up to a cascade.
pub(crate) const HOLD_ENERGY: f64 = 1e-12;

/// A bounce is short if its time, times the fastest rate of the cell, is below this [1]. The force is then constant during the bounce
/// to 1e-3. Larger: vibrating contacts are held. Smaller: they are held later, after more events.
pub(crate) const SHORT_BOUNCE: f64 = 1e-3;

/// A held phase is released if the reaction pulls by this [relative to the forces it consists of]. It is above the rounding errors of
/// the reaction. Larger: the release is late by this fraction. Smaller: rounding errors release a phase at balance.
pub(crate) const RELEASE: f64 = 1e-9;

/// The step of a law strains a single deflection if its matrix and its load differ by less than this from those of one deflection
/// [relative to the largest entry]. They are products of a few numbers. Larger: different deflections are taken for one. Smaller:
/// rounding errors keep a phase held that slips through.
pub(crate) const ONE_DEFLECTION: f64 = 1e-10;

/// The two zeros of a vanishing step are one if their squared distance is below this [relative to the square of their mean]. It is the
/// difference of two numbers of this size. Larger: two zeros are taken for one. Smaller: rounding errors separate a double zero, or
/// remove it.
pub(crate) const DOUBLE_ZERO: f64 = 1e-10;

/// Events within this time, one after another, are a cascade [fastest time of the motion]. Larger: a fast sequence of events of a sound
/// motion ends a run. Smaller: a run without progress goes on.
pub(crate) const CASCADE_SPAN: f64 = 1e-6;

/// Events of a cascade after which the run ends with an error [events]: some tenths of a second of computing time.
pub(crate) const CASCADE_EVENTS: u64 = 100_000;

/// The order of two simultaneous steps matters if the speeds differ by more than this [relative to the largest speed]. Larger:
/// ambiguous results are not reported. Smaller: rounding errors are reported as ambiguous.
pub(crate) const ORDER: f64 = 1e-9;

/// Events of flanks without a motion between them above which they are taken for rounding errors [events of each switch, and of all]: more
/// than the contacts and dampers of a train that can change together. Smaller: an event at the same time as others is late by a rounding
/// error of its deflection. Larger: flanks rattle by rounding errors for longer.
pub(crate) const EVENTS_AT_ONE_TIME: (u32, u32) = (4, 16);

/// Time in which a rate does not change [1: time times the fastest rate]. A clutch or dry friction that changes its mode twice within it does so
/// by errors of the rate. Smaller: it rattles on. Larger: fast stick-slip is taken for rattling.
pub(crate) const NO_TIME: f64 = 1e-9;

/// How often the allowance for a guard that rattles is doubled: up to 1e6 times its rounding error, the error of a method by steps with a loose
/// tolerance. Smaller: it rattles until the run is stopped. Larger: no effect, since the first allowance that suffices ends the rattling.
pub(crate) const DOUBLINGS: u32 = 20;

/// Rounding error of the guard of a switch near zero [relative to its constant part plus that of transmission errors: of a play, half the
/// play plus its offset]. Flanks that meet and part without passing time must pass the edge by this, and an impulse must violate a guard
/// by this. Smaller: they rattle on. Larger: no effect on other motions.
pub(crate) const EDGE_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Most work before the run for the modes of all cells [cells times the cube of the coordinates]: they take some 50 ms. With more, each cell
/// is computed when it is first entered. Smaller: scenes of few cells look them up by a hash. Larger: runs wait for cells that they never
/// enter.
pub(crate) const CELLS_IN_ADVANCE: usize = 100_000;

/// Rounding error of a sum over the modes in a window [relative to the sum of absolute values]. Mode shapes have some hundred roundings.
/// Smaller: the rounding errors of balanced forces part flanks. Larger: weak forces are neglected.
pub(crate) const WINDOW_ROUNDING: f64 = 1024.0 * f64::EPSILON;

/// Longest window, times the fastest rate of cell and load [1]. Its 28 terms leave 2²⁸/28! < 1e-21 of the motion. Larger: digits are lost to
/// cancellation. Smaller: more windows.
pub(crate) const WINDOW_SPAN: f64 = 2.0;

/// A window in which a phase would go far beyond its cell is made shorter. One such step makes it at most this much shorter [1]. It decides
/// the cost, not the result.
pub(crate) const WINDOW_CUT: f64 = 1e-3;

/// A phase this close to a boundary as the run ends has reached it [rounding errors of the phase], besides its way in half a unit of the
/// last place of the time. Smaller: a run split there loses an event. Larger: an event of the time after the run is taken.
pub(crate) const END_OF_RUN: f64 = 2.0;

/// Two guards are multiples of one another if each coefficient of the one is a multiple of that of the other by the same factor, up to
/// this [relative to the coefficient]. Coefficients are products of a few numbers, whose rounding errors are 1e3 times smaller.
pub(crate) const SAME_GUARD: f64 = 1e-12;

/// A deflection is at rest if its rate is smaller [relative to the rate that the kinetic energy of the whole train allows]: rounding errors
/// of the speeds are 1e4 times smaller. It decides whether a held deflection is still at rest after an impulse, and by how much flanks must
/// part before they can meet: this rate times the time. Larger: slow slip is taken for rest, with its energy in the account as neglected,
/// and impacts after slow separations are not counted.
pub(crate) const AT_REST: f64 = 1e-12;

/// A motion is possible beside others that are held if its compliance is larger [relative to its compliance without them]. The rounding
/// error of the difference is 1e3 times smaller.
pub(crate) const INDEPENDENT: f64 = 1e-12;

/// Rounding error of the mobility that holds leave [relative to the mobility without them, for each coordinate]. Larger: a heavy part that is
/// held to a light one does not move. Smaller: forces move what is held, by rounding errors.
pub(crate) const HELD_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Cells with holds that are kept for the next time they are met [cells]. It decides the memory, not the accuracy.
pub(crate) const HELD_CELLS: usize = 4096;

/// A phase that turns back this close to a boundary is left to the general search [relative to the width of the cell and the way of the phase]:
/// rounding errors of the way are 1e6 times smaller. Smaller: rounding errors could decide whether a boundary is met. Larger: more
/// events are left.
pub(crate) const TURN_NEAR: f64 = 1e-9;

/// Error of the crossing of such a phase at which its search ends [fastest time of the cell]: half of the longest shift of the series, by
/// which the motion goes on from there. It decides the cost.
pub(crate) const TURN_STEP: f64 = 4e-3;
/// Longest step of that search by the series of the phase [fastest time of the cell]. Beyond, omitted terms may exceed those that are there;
/// Newton's step is taken. It decides the cost.
pub(crate) const TURN_REACH: f64 = 1.0;

/// The kernel evaluates a cell's motion at the predicted time of its next passage if the last prediction was this close [fastest time of the
/// cell]. Predictions that are used are closer than `modes::FAR_SHIFT_SPAN`. It decides the cost.
pub(crate) const WORTH_PREDICTING: f64 = 0.1;
