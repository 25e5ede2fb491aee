//! Tolerances of phases: positions of boundaries, pitches and turns.

/// A boundary closer to a whole pitch than this [pitches] is moved to it. A pitch point computed from tooth data has about this error.
/// Smaller: two boundaries that should be equal differ by a rounding error and cause two events. Larger: no effect below the digits of
/// written widths.
pub(crate) const WHOLE_PITCH: f64 = 8.0 * f64::EPSILON;
/// Two laws step together if both boundaries are this close [relative to the width of the cell]. Boundaries of different laws on
/// one phase are computed by different sums. Smaller: one step is taken as two, one after the other. Larger: neighbouring steps
/// merge.
pub(crate) const SAME_BOUNDARY: f64 = 4.0 * f64::EPSILON;
/// Rounding error of the position of a boundary [relative to the period of the law]. Multiplied by the slopes of two curves, it is part of
/// the tolerance below which they meet without a step.
pub(crate) const CURVE_PLACE: f64 = 16.0 * f64::EPSILON;
/// Two curves meet without a step if their values differ by less than this [relative to the larger], in addition to the effect of the
/// position ([`CURVE_PLACE`]). Values of curves are sums of up to a thousand terms. Smaller: rounding errors become steps, each with an
/// event. Larger: the jump of the energy at small steps is neglected.
pub(crate) const CURVE_VALUE: f64 = 1e-12;
/// Largest number of turns in a period of a law, and largest denominator of the ratio of two periods [1]. Numbers of teeth are below it.
/// Larger: rounded irrational ratios are taken for fractions. Smaller: some real gears have no common turn.
pub(crate) const TURNS: u32 = 1000;
/// The ratio of two periods counts as a fraction of whole numbers if its distance from this fraction is below this [relative]. Periods have
/// a few roundings. Smaller: a common turn is missed. Larger: incommensurate periods get a common turn.
pub(crate) const TURN_RATIO: f64 = 16.0 * f64::EPSILON;
/// Largest phase at the start [pitches]; the scene is refused above it. At 1e15 the rounding error of the phase is 0.1 pitch.
pub(crate) const FARTHEST_START: f64 = 1e15;
