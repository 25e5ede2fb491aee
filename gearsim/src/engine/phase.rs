//! The place of a law in its pitch. The cell is part of the state and not computed from the angle. The angle is kept as a number
//! of whole pitches and a remainder, so that a billion revolutions cost no digits.

pub mod turn;

use xprec::Df64;

use crate::engine::crossing::Side;
use crate::profile::{Curve, Profile};
use crate::tolerance::phases;

/// The cells of one period of a law: boundaries and levels.
#[derive(Debug, Clone, PartialEq)]
pub struct Pitch {
    /// The range of each cell; the first begins at most one period below zero.
    spans: Vec<Span>,
    /// Length of one pitch [unit of the phase].
    period: f64,
    /// Number of pitches in one period of the law.
    pitches: i64,
    /// Level in each cell [unit of the law].
    levels: Vec<f64>,
    /// The curve in each cell; empty if the law is constant in every cell.
    curves: Vec<Curve>,
}

/// The range of a cell, counted from a whole number of pitches. The boundaries have the digits of one pitch, however many pitches
/// lie before the cell.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    lower: f64,
    upper: f64,
    /// Whole pitches before the cell; 0 for all cells if the period is one pitch.
    before: i64,
}

impl Pitch {
    /// The pitch of a law with the given period.
    pub fn new(law: &Profile, period: f64) -> Self {
        Self::counted(law, period, law.pitches)
    }

    /// The same for a law that is counted in pitches of length `period`, of which one period of the law has `pitches`.
    pub fn counted(law: &Profile, period: f64, pitches: u32) -> Self {
        let length = Df64::from(period) * f64::from(pitches);
        let origin = Df64::from(law.origin) - length * (law.origin / length.hi()).ceil();
        let mut ends = vec![Df64::from(0.0)];
        for step in &law.steps[..law.steps.len() - 1] {
            ends.push(ends[ends.len() - 1] + step.width);
        }
        ends.push(length);
        // A boundary within rounding of a whole pitch, e.g. a pitch point computed from tooth data, is set to the whole pitch.
        let near_whole = |x: f64| {
            let whole = (x / period).round() * period;
            if (x - whole).abs() <= phases::WHOLE_PITCH * period { whole } else { x }
        };
        let span = |ends: &[Df64]| {
            let [lower, upper] = [ends[0] + origin, ends[1] + origin];
            let before = (lower.hi() / period).trunc();
            let base = Df64::from(before) * period;
            Span {
                lower: near_whole((lower - base).hi()),
                upper: near_whole((upper - base).hi()),
                before: before as i64,
            }
        };
        Pitch {
            spans: ends.windows(2).map(span).collect(),
            period,
            pitches: pitches.into(),
            levels: law.steps.iter().map(|s| s.value).collect(),
            curves: law.curves.clone(),
        }
    }

    /// A law that never steps: one level.
    pub fn constant(value: f64, period: f64) -> Self {
        let span = Span { lower: 0.0, upper: period, before: 0 };
        Pitch { spans: vec![span], period, pitches: 1, levels: vec![value], curves: vec![] }
    }

    /// Length of one pitch [unit of the phase].
    #[inline]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Number of pitches in one period of the law.
    pub fn pitches(&self) -> i64 {
        self.pitches
    }

    /// Period of the law [unit of the phase].
    fn length(&self) -> f64 {
        self.period * self.pitches as f64
    }

    /// Lower and upper boundary of a cell, counted from the beginning of the first pitch.
    fn whole(&self, cell: usize) -> (f64, f64) {
        let Span { lower, upper, before } = self.spans[cell];
        let base = before as f64 * self.period;
        (base + lower, base + upper)
    }

    /// Number of cells.
    #[inline]
    pub fn cells(&self) -> usize {
        self.levels.len()
    }

    /// Level in a cell [unit of the law].
    #[inline]
    pub fn level(&self, cell: usize) -> f64 {
        self.levels[cell]
    }

    /// Whether it is constant in every cell.
    #[inline]
    pub fn steps_only(&self) -> bool {
        self.curves.is_empty()
    }

    /// k, dk/ds and d²k/ds² in a cell, at the distance `x` from its lower boundary.
    #[inline]
    pub fn course(&self, cell: usize, x: f64) -> [f64; 3] {
        self.curves.get(cell).map_or([self.levels[cell], 0.0, 0.0], |curve| curve.at(x))
    }

    /// k and its derivatives at the given side of a cell, inside the cell.
    fn edge(&self, cell: usize, side: Side) -> [f64; 3] {
        let (lower, upper) = self.bounds(cell);
        self.course(cell, if side == Side::Upper { upper - lower } else { 0.0 })
    }

    /// The step of the value at a side of a cell; 0 if only the slope changes.
    #[inline(always)]
    pub fn step(&self, cell: usize, side: Side) -> f64 {
        let (beyond, ..) = self.beyond(cell, side);
        if self.steps_only() {
            return self.levels[beyond] - self.levels[cell];
        }
        self.step_of_curves(cell, beyond, side)
    }

    /// The step of the value between two curves.
    #[cold]
    fn step_of_curves(&self, cell: usize, beyond: usize, side: Side) -> f64 {
        let ([here, slope, _], [there, beyond, _]) = (self.edge(cell, side), self.edge(beyond, side.opposite()));
        // Two curves that meet differ by rounding errors of their values and of the boundary.
        let places = phases::CURVE_PLACE * self.length() * (slope.abs() + beyond.abs());
        let rounding = places + phases::CURVE_VALUE * here.abs().max(there.abs());
        if (there - here).abs() <= rounding { 0.0 } else { there - here }
    }

    /// Lower and upper boundary of a cell, counted from its whole number of pitches.
    #[inline]
    pub fn bounds(&self, cell: usize) -> (f64, f64) {
        (self.spans[cell].lower, self.spans[cell].upper)
    }

    /// Width of a cell [unit of the phase].
    #[inline]
    pub fn width(&self, cell: usize) -> f64 {
        self.spans[cell].upper - self.spans[cell].lower
    }

    /// Number of whole pitches, remainder and cell of an absolute phase that moves with `speed`. On a boundary the cell is the
    /// one into which the phase moves; at rest it is the upper one.
    pub fn locate(&self, phase: f64, speed: f64) -> (i64, f64, usize) {
        let (length, first, last) = (self.length(), self.whole(0).0, self.whole(self.cells() - 1).1);
        // Just below a whole pitch the quotient rounds up, but the remainder does not.
        let mut rest = phase.rem_euclid(length);
        let mut count = ((phase - rest) / length).round() as i64;
        if rest >= length {
            (count, rest) = (count + 1, 0.0);
        }
        if rest >= last {
            (count, rest) = (count + 1, (rest - length).max(first));
        }
        // A phase within a rounding error of a boundary is on it. Boundaries have a rounding error of the pitch.
        let resolution = f64::EPSILON * (2.0 * phase.abs()).max(self.period);
        let boundaries = (0..self.cells()).map(|cell| self.whole(cell).0).chain([last]);
        if let Some(boundary) = boundaries.into_iter().find(|&b| (rest - b).abs() <= resolution) {
            (count, rest) = if boundary == last { (count + 1, first) } else { (count, boundary) };
        }
        let mut cell = (0..self.cells()).position(|cell| rest < self.whole(cell).1).unwrap_or(self.cells() - 1);
        let (on_boundary, back) = (rest == self.whole(cell).0, speed < 0.0);
        if on_boundary && back {
            if cell == 0 {
                (count, cell) = (count - 1, self.cells());
            }
            cell -= 1;
        }
        let Span { lower, upper, before } = self.spans[cell];
        let rest = match (on_boundary, back) {
            (true, false) => lower,
            (true, true) => upper,
            _ => rest - before as f64 * self.period,
        };
        (count * self.pitches + before, rest, cell)
    }

    /// The place of a coordinate in this law, given by its count of `turns` (one pitch each) and the remainder `rest`. Returns the pitches
    /// from its turn to the whole pitch from which the cell is counted, and the cell. A phase within four rounding errors of a boundary is
    /// on it. Events of other laws on the same coordinate have the same tolerance.
    pub fn locate_from(&self, turns: i64, rest: f64, speed: f64) -> (i64, usize) {
        let within = |cell: usize, ahead: i64| {
            let Span { lower, upper, .. } = self.spans[cell];
            let (x, slack) = (rest - ahead as f64 * self.period, phases::SAME_BOUNDARY * (upper - lower));
            let (on_lower, on_upper) = ((x - lower).abs() <= slack, (x - upper).abs() <= slack);
            (x > lower && x < upper && !on_lower && !on_upper) || if speed < 0.0 { on_upper } else { on_lower }
        };
        let cells = (0..self.cells()).flat_map(|cell| {
            let nearest = (self.spans[cell].before - turns).rem_euclid(self.pitches);
            [nearest, nearest - self.pitches, nearest + self.pitches].map(|ahead| (ahead, cell))
        });
        // If rounding errors allow two cells or none, take the first cell, or the nearest one.
        let found = cells.clone().find(|&(ahead, cell)| within(cell, ahead));
        let middle = |&(ahead, cell): &(i64, usize)| {
            let Span { lower, upper, .. } = self.spans[cell];
            (rest - ahead as f64 * self.period - 0.5 * (lower + upper)).abs() - 0.5 * (upper - lower)
        };
        found.or_else(|| cells.min_by(|a, b| middle(a).total_cmp(&middle(b)))).unwrap_or((0, 0))
    }

    /// The cell next to `cell` on a side: its index, the remainder after entering it, and the change of the count of pitches.
    #[inline]
    pub fn beyond(&self, cell: usize, side: Side) -> (usize, f64, i64) {
        let here = self.spans[cell].before;
        match side {
            Side::Upper => {
                let (next, round) = if cell + 1 == self.cells() { (0, self.pitches) } else { (cell + 1, 0) };
                (next, self.spans[next].lower, self.spans[next].before - here + round)
            }
            Side::Lower => {
                let (next, round) = if cell == 0 { (self.cells() - 1, self.pitches) } else { (cell - 1, 0) };
                (next, self.spans[next].upper, self.spans[next].before - here - round)
            }
        }
    }
}

#[cfg(test)]
mod runs;
#[cfg(test)]
mod tests;
