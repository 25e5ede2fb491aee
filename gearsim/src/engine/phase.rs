//! Where a stiffness law stands in its pitch: the cell is state, not computed from the angle, and the angle is kept as
//! a count of pitches and a remainder, so that a billion revolutions cost no digits.

use crate::engine::crossing::Side;
use crate::scene::{Curve, Stiffness};

/// One law's pitch: boundaries and levels.
#[derive(Debug, Clone, PartialEq)]
pub struct Pitch {
    /// Boundaries b_0 < b_1 < ... < b_m = b_0 + period, with -period < b_0 <= 0.
    boundaries: Vec<f64>,
    /// Length of the pitch.
    period: f64,
    /// Level between b_i and b_{i+1}.
    levels: Vec<f64>,
    /// What it follows from b_i on; empty where it is constant.
    curves: Vec<Curve>,
}

impl Pitch {
    /// The pitch of a stiffness with the given period.
    pub fn new(stiffness: &Stiffness, period: f64) -> Self {
        let within = stiffness.origin.rem_euclid(period);
        let origin = if within == 0.0 || within >= period { 0.0 } else { within - period };
        let mut boundaries = vec![origin];
        let mut end = 0.0;
        for step in &stiffness.steps[..stiffness.steps.len() - 1] {
            end += step.width;
            boundaries.push(origin + end);
        }
        boundaries.push(origin + period);
        let levels = stiffness.steps.iter().map(|s| s.value).collect();
        Pitch { boundaries, period, levels, curves: stiffness.curves.clone() }
    }

    /// One level throughout: for a law that does not step.
    pub fn constant(value: f64, period: f64) -> Self {
        Pitch { boundaries: vec![0.0, period], period, levels: vec![value], curves: vec![] }
    }

    /// Length of the pitch.
    #[inline]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// The first boundary and the last.
    fn ends(&self) -> (f64, f64) {
        (self.boundaries[0], self.boundaries[self.levels.len()])
    }

    /// Number of cells.
    #[inline]
    pub fn cells(&self) -> usize {
        self.levels.len()
    }

    /// Stiffness in a cell.
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
    #[inline]
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
        let other = if side == Side::Upper { Side::Lower } else { Side::Upper };
        let ([here, slope, _], [there, beyond, _]) = (self.edge(cell, side), self.edge(beyond, other));
        // Curves that meet do so to rounding, of their values and of the boundaries.
        let places = 16.0 * f64::EPSILON * self.period() * (slope.abs() + beyond.abs());
        let rounding = places + 1e-12 * here.abs().max(there.abs());
        if (there - here).abs() <= rounding { 0.0 } else { there - here }
    }

    /// Lower and upper boundary of a cell.
    #[inline]
    pub fn bounds(&self, cell: usize) -> (f64, f64) {
        (self.boundaries[cell], self.boundaries[cell + 1])
    }

    /// Pitch count, remainder and cell of an absolute phase that moves on at `speed`. On a boundary the motion
    /// decides: the cell is the one it moves into, the upper one at rest.
    pub fn locate(&self, phase: f64, speed: f64) -> (i64, f64, usize) {
        let (period, (first, last)) = (self.period, self.ends());
        // The quotient alone would round up just below a pitch, where the remainder does not.
        let mut rest = phase.rem_euclid(period);
        let mut count = ((phase - rest) / period).round() as i64;
        if rest >= period {
            (count, rest) = (count + 1, 0.0);
        }
        if rest >= last {
            (count, rest) = (count + 1, (rest - period).max(first));
        }
        // What the number does not tell from a boundary is on it.
        let resolution = 2.0 * f64::EPSILON * phase.abs();
        if let Some(boundary) = self.boundaries.iter().find(|&&b| (rest - b).abs() <= resolution) {
            (count, rest) = if *boundary == last { (count + 1, first) } else { (count, *boundary) };
        }
        let mut cell = self.boundaries[1..].iter().position(|&b| rest < b).unwrap_or(self.cells() - 1);
        if rest == self.boundaries[cell] && speed < 0.0 {
            if cell == 0 {
                (count, rest, cell) = (count - 1, last, self.cells());
            }
            cell -= 1;
        }
        (count, rest, cell)
    }

    /// The neighbour of `cell` beyond a side: its index, the remainder on entering it, and the change of the count.
    #[inline]
    pub fn beyond(&self, cell: usize, side: Side) -> (usize, f64, i64) {
        match side {
            Side::Upper if cell + 1 == self.cells() => (0, self.ends().0, 1),
            Side::Upper => (cell + 1, self.boundaries[cell + 1], 0),
            Side::Lower if cell == 0 => (self.cells() - 1, self.ends().1, -1),
            Side::Lower => (cell - 1, self.boundaries[cell], 0),
        }
    }
}

#[cfg(test)]
mod runs;
#[cfg(test)]
mod tests;
