//! A torque as a function of time: piecewise linear, plus harmonics.

mod read;

use std::f64::consts::TAU;

pub(super) use read::{HISTORY, KEYS, read};

use super::{Scene, list};

/// T(t) = value + slope (t - begin) + sum a cos(omega t + phase), with value, slope and begin of the piece that contains t.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeHistory {
    /// The pieces, in ascending order of `begin`; the first begins at t = 0.
    pub pieces: Vec<LinearPiece>,
    /// Harmonics added to the pieces.
    pub harmonics: Vec<Harmonic>,
}

/// A linear piece. It ends where the next one begins; the last one never ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearPiece {
    /// Start of the piece \[s\].
    pub begin: f64,
    /// Value at `begin` \[unit of the torque\].
    pub value: f64,
    /// Slope \[unit of the torque per second\].
    pub slope: f64,
}

/// One harmonic, a cos(omega t + phase).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Amplitude a \[unit of the torque\].
    pub amplitude: f64,
    /// Angular frequency omega \[rad/s\].
    pub omega: f64,
    /// Phase at t = 0 \[rad\].
    pub phase: f64,
}

impl TimeHistory {
    /// Levels (value, end time \[s\]); the last one has no end.
    pub fn steps(levels: &[(f64, Option<f64>)]) -> Self {
        let begins = std::iter::once(0.0).chain(levels.iter().map(|(_, until)| until.unwrap_or(f64::INFINITY)));
        let piece = |(begin, (value, _)): (f64, &(f64, Option<f64>))| LinearPiece { begin, value: *value, slope: 0.0 };
        TimeHistory { pieces: begins.zip(levels).map(piece).collect(), harmonics: vec![] }
    }

    /// Linear interpolation between points (time \[s\], value) at ascending times >= 0; constant before the first and after the last point.
    pub fn table(points: &[(f64, f64)]) -> Self {
        let mut pieces = vec![];
        if let Some((_, value)) = points.first().filter(|point| point.0 > 0.0) {
            pieces.push(LinearPiece { begin: 0.0, value: *value, slope: 0.0 });
        }
        for (i, (begin, value)) in points.iter().copied().enumerate() {
            let slope = points.get(i + 1).map_or(0.0, |next| (next.1 - value) / (next.0 - begin));
            pieces.push(LinearPiece { begin, value, slope });
        }
        TimeHistory { pieces, harmonics: vec![] }
    }

    /// The same pieces, with these harmonics.
    pub fn with(self, harmonics: Vec<Harmonic>) -> Self {
        TimeHistory { harmonics, ..self }
    }

    /// Value at the time `t` \[s\], with the formula of the piece with index `piece`.
    pub fn at(&self, piece: usize, t: f64) -> f64 {
        let LinearPiece { begin, value, slope } = self.pieces[piece];
        let swing = |h: &Harmonic| h.amplitude * (h.omega * t + h.phase).cos();
        value + slope * (t - begin) + self.harmonics.iter().map(swing).sum::<f64>()
    }

    /// Index of the piece that contains the time `t` \[s\]; at a breakpoint, the piece that begins there.
    pub fn piece(&self, t: f64) -> usize {
        self.pieces.iter().rposition(|piece| piece.begin <= t).unwrap_or(0)
    }

    /// Whether the value is the same at all times.
    pub fn is_constant(&self) -> bool {
        let first = self.pieces[0].value;
        self.harmonics.iter().all(|h| h.amplitude == 0.0)
            && self.pieces.iter().all(|piece| piece.slope == 0.0 && piece.value == first)
    }

    /// Value at t = 0.
    pub fn at_start(&self) -> f64 {
        self.at(self.piece(0.0), 0.0)
    }

    /// Of the lower and upper bound of the value, the one that is farther from the value at t = 0.
    pub fn farthest(&self) -> f64 {
        let (start, (low, high)) = (self.at_start(), self.bounds());
        if high - start >= start - low { high } else { low }
    }

    /// Lower and upper bound of the value over all times.
    pub fn bounds(&self) -> (f64, f64) {
        let swing: f64 = self.harmonics.iter().map(|h| h.amplitude.abs()).sum();
        let ends = self.pieces.iter().enumerate().flat_map(|(i, piece)| {
            let end = self.pieces.get(i + 1).map_or(piece.value, |next| {
                piece.value + if piece.slope == 0.0 { 0.0 } else { piece.slope * (next.begin - piece.begin) }
            });
            [piece.value, end]
        });
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        (low - swing, high + swing)
    }
}

impl Scene {
    /// The names of the parameters that vary in time, as text; `None` if none varies.
    pub fn varying(&self) -> Option<String> {
        let varying = self.time_histories.iter().filter(|(_, history)| !history.is_constant());
        let names: Vec<_> = varying.map(|(p, _)| self.model.parameters[*p].name).collect();
        (!names.is_empty()).then(|| list(&names))
    }
}

impl Harmonic {
    /// A harmonic with its frequency in Hz.
    pub fn new(amplitude: f64, frequency: f64, phase: f64) -> Self {
        Harmonic { amplitude, omega: TAU * frequency, phase }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_pieces_and_bounds() {
        let at = |history: &TimeHistory, t: f64| history.at(history.piece(t), t);
        let steps = TimeHistory::steps(&[(1.0, Some(0.5)), (3.0, Some(2.0)), (2.0, None)]);
        assert_eq!([0.0, 0.49, 0.5, 1.9, 2.0, 9.0].map(|t| at(&steps, t)), [1.0, 1.0, 3.0, 3.0, 2.0, 2.0]);
        assert_eq!(steps.bounds(), (1.0, 3.0));
        let table = TimeHistory::table(&[(1.0, 2.0), (3.0, 6.0), (4.0, 0.0)]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 9.0].map(|t| at(&table, t)), [2.0, 2.0, 4.0, 6.0, 3.0, 0.0, 0.0]);
        assert_eq!(table.bounds(), (0.0, 6.0));
        let wave = TimeHistory::steps(&[(5.0, None)]).with(vec![Harmonic::new(2.0, 0.25, 0.0)]);
        assert!((at(&wave, 2.0) - 3.0).abs() < 1e-15 && (at(&wave, 1.0) - 5.0).abs() < 1e-15);
        assert_eq!(wave.bounds(), (3.0, 7.0));
        assert!(!wave.is_constant() && !steps.is_constant() && TimeHistory::steps(&[(5.0, None)]).is_constant());
    }
}
