//! Where a law stands in its pitch: the cell is state, not computed from the angle, and the angle is kept as
//! a count of pitches and a remainder, so that a billion revolutions cost no digits.

pub mod turn;

use xprec::Df64;

use crate::engine::crossing::Side;
use crate::profile::{Curve, Profile};
use crate::tolerance::phases;

/// One law's pitch, or pitches: boundaries and levels.
#[derive(Debug, Clone, PartialEq)]
pub struct Pitch {
    /// What each cell spans; the first begins within one repetition before zero.
    spans: Vec<Span>,
    /// Length of one pitch.
    period: f64,
    /// Pitches after which it repeats itself.
    pitches: i64,
    /// Level in each cell.
    levels: Vec<f64>,
    /// What it follows in each cell; empty where it is constant.
    curves: Vec<Curve>,
}

/// What a cell spans, counted from a whole number of pitches on: its boundaries have the digits of one pitch, however many
/// lie before it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    lower: f64,
    upper: f64,
    /// Pitches before it; 0 throughout, where it repeats itself once a pitch.
    before: i64,
}

impl Pitch {
    /// The pitch of a law with the given period.
    pub fn new(law: &Profile, period: f64) -> Self {
        Self::counted(law, period, law.pitches)
    }

    /// The same of a law that repeats itself after a number of pitches of length `period`, by which it is counted.
    pub fn counted(law: &Profile, period: f64, pitches: u32) -> Self {
        let length = Df64::from(period) * f64::from(pitches);
        let origin = Df64::from(law.origin) - length * (law.origin / length.hi()).ceil();
        let mut ends = vec![Df64::from(0.0)];
        for step in &law.steps[..law.steps.len() - 1] {
            ends.push(ends[ends.len() - 1] + step.width);
        }
        ends.push(length);
        // A boundary within rounding of a whole pitch, such as a pitch point worked out from tooth data, is at the pitch.
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

    /// One level throughout: for a law that does not step.
    pub fn constant(value: f64, period: f64) -> Self {
        let span = Span { lower: 0.0, upper: period, before: 0 };
        Pitch { spans: vec![span], period, pitches: 1, levels: vec![value], curves: vec![] }
    }

    /// Length of one pitch.
    #[inline]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Length after which it repeats itself.
    fn length(&self) -> f64 {
        self.period * self.pitches as f64
    }

    /// Lower and upper boundary of a cell, from the beginning of the first pitch on.
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

    /// Value in a cell.
    #[inline]
    pub fn level(&self, cell: usize) -> f64 {
        self.levels[cell]
    }

    /// Whether it is constant in every cell.
    #[inline]
    pub fn steps_only(&self) -> bool {
        self.curves.is_empty()
    }

    /// k, dk/ds and d²k/ds² in a cell, at the phase `x` from its lower boundary on.
    #[inline]
    pub fn course(&self, cell: usize, x: f64) -> [f64; 3] {
        self.curves.get(cell).map_or([self.levels[cell], 0.0, 0.0], |curve| curve.at(x))
    }

    /// k and its derivatives at that side of a cell, within it.
    fn edge(&self, cell: usize, side: Side) -> [f64; 3] {
        let (lower, upper) = self.bounds(cell);
        self.course(cell, if side == Side::Upper { upper - lower } else { 0.0 })
    }

    /// The step of the stiffness beyond a side of a cell; 0 at a mere kink.
    #[inline(always)]
    pub fn step(&self, cell: usize, side: Side) -> f64 {
        let (beyond, ..) = self.beyond(cell, side);
        if self.steps_only() {
            return self.levels[beyond] - self.levels[cell];
        }
        self.step_of_curves(cell, beyond, side)
    }

    /// The same from one curve to the other.
    #[cold]
    fn step_of_curves(&self, cell: usize, beyond: usize, side: Side) -> f64 {
        let ([here, slope, _], [there, beyond, _]) = (self.edge(cell, side), self.edge(beyond, side.opposite()));
        // Curves that meet do so to rounding, of their values and of the boundaries.
        let places = phases::CURVE_PLACE * self.length() * (slope.abs() + beyond.abs());
        let rounding = places + phases::CURVE_VALUE * here.abs().max(there.abs());
        if (there - here).abs() <= rounding { 0.0 } else { there - here }
    }

    /// Lower and upper boundary of a cell, from its whole number of pitches on.
    #[inline]
    pub fn bounds(&self, cell: usize) -> (f64, f64) {
        (self.spans[cell].lower, self.spans[cell].upper)
    }

    /// Width of a cell [unit of the phase].
    #[inline]
    pub fn width(&self, cell: usize) -> f64 {
        self.spans[cell].upper - self.spans[cell].lower
    }

    /// Pitch count, remainder and cell of an absolute phase that moves on at `speed`. On a boundary the motion
    /// decides: the cell is the one it moves into, the upper one at rest.
    pub fn locate(&self, phase: f64, speed: f64) -> (i64, f64, usize) {
        let (length, first, last) = (self.length(), self.whole(0).0, self.whole(self.cells() - 1).1);
        // The quotient alone would round up just below a pitch, where the remainder does not.
        let mut rest = phase.rem_euclid(length);
        let mut count = ((phase - rest) / length).round() as i64;
        if rest >= length {
            (count, rest) = (count + 1, 0.0);
        }
        if rest >= last {
            (count, rest) = (count + 1, (rest - length).max(first));
        }
        // What the number does not tell from a boundary is on it; boundaries have a rounding of the pitch.
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

    /// Where a coordinate `rest` beyond a number of `turns`, each a pitch, is in this law: the pitches from its turn to the whole pitch
    /// from which the cell is counted, and the cell. A boundary within four roundings of its cell is on it: the events of other
    /// laws on the coordinate are met together with it to within as much.
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
        // Where a boundary is within rounding of none and of both, the cells in their order decide.
        let found = cells.clone().find(|&(ahead, cell)| within(cell, ahead));
        let middle = |&(ahead, cell): &(i64, usize)| {
            let Span { lower, upper, .. } = self.spans[cell];
            (rest - ahead as f64 * self.period - 0.5 * (lower + upper)).abs() - 0.5 * (upper - lower)
        };
        found.or_else(|| cells.min_by(|a, b| middle(a).total_cmp(&middle(b)))).unwrap_or((0, 0))
    }

    /// The neighbour of `cell` beyond a side: its index, the remainder on entering it, and the change of the count of pitches.
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
