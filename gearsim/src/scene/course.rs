//! The course of a torque in time: straight pieces, and harmonics on top of them.

use std::f64::consts::TAU;

use super::{Scene, list};

/// T(t) = value + slope (t - begin) + sum a cos(omega t + phase), from the piece in which t lies.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// The pieces, by rising beginning; the first holds from t = 0 on.
    pub pieces: Vec<Piece>,
    /// What swings about them.
    pub harmonics: Vec<Harmonic>,
}

/// A straight piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Where it begins \[s\].
    pub begin: f64,
    /// Its value there \[unit of the torque\].
    pub value: f64,
    /// Its slope \[unit of the torque per second\].
    pub slope: f64,
}

/// One harmonic, a cos(omega t + phase).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// a \[unit of the torque\].
    pub amplitude: f64,
    /// omega \[rad/s\].
    pub omega: f64,
    /// phase \[rad\].
    pub phase: f64,
}

impl Course {
    /// Levels that hold until the times given; the last for ever.
    pub fn steps(levels: &[(f64, Option<f64>)]) -> Self {
        let begins = std::iter::once(0.0).chain(levels.iter().map(|(_, until)| until.unwrap_or(f64::INFINITY)));
        let piece = |(begin, (value, _)): (f64, &(f64, Option<f64>))| Piece { begin, value: *value, slope: 0.0 };
        Course { pieces: begins.zip(levels).map(piece).collect(), harmonics: vec![] }
    }

    /// Straight lines through points (time, value) at rising times >= 0; constant before the first and after the last.
    pub fn table(points: &[(f64, f64)]) -> Self {
        let mut pieces = vec![];
        if let Some((_, value)) = points.first().filter(|point| point.0 > 0.0) {
            pieces.push(Piece { begin: 0.0, value: *value, slope: 0.0 });
        }
        for (i, (begin, value)) in points.iter().copied().enumerate() {
            let slope = points.get(i + 1).map_or(0.0, |next| (next.1 - value) / (next.0 - begin));
            pieces.push(Piece { begin, value, slope });
        }
        Course { pieces, harmonics: vec![] }
    }

    /// The same with harmonics on top.
    pub fn with(self, harmonics: Vec<Harmonic>) -> Self {
        Course { harmonics, ..self }
    }

    /// Its value at the time `t` \[s\], in the piece of this number.
    pub fn at(&self, piece: usize, t: f64) -> f64 {
        let Piece { begin, value, slope } = self.pieces[piece];
        let swing = |h: &Harmonic| h.amplitude * (h.omega * t + h.phase).cos();
        value + slope * (t - begin) + self.harmonics.iter().map(swing).sum::<f64>()
    }

    /// The piece in which the time `t` lies; where one ends, the next.
    pub fn piece(&self, t: f64) -> usize {
        self.pieces.iter().rposition(|piece| piece.begin <= t).unwrap_or(0)
    }

    /// Whether it is the same at all times.
    pub fn is_constant(&self) -> bool {
        let first = self.pieces[0].value;
        self.harmonics.iter().all(|h| h.amplitude == 0.0)
            && self.pieces.iter().all(|piece| piece.slope == 0.0 && piece.value == first)
    }

    /// Values between which it stays.
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
    /// The names of the parameters that vary in time, in words; `None` where none does.
    pub fn varying(&self) -> Option<String> {
        let varying = self.courses.iter().filter(|(_, course)| !course.is_constant());
        let names: Vec<_> = varying.map(|(p, _)| self.model.parameters[*p].name).collect();
        (!names.is_empty()).then(|| list(&names))
    }
}

impl Harmonic {
    /// The harmonic of a frequency \[Hz\].
    pub fn new(amplitude: f64, frequency: f64, phase: f64) -> Self {
        Harmonic { amplitude, omega: TAU * frequency, phase }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn courses_are_what_they_say() {
        let at = |course: &Course, t: f64| course.at(course.piece(t), t);
        let steps = Course::steps(&[(1.0, Some(0.5)), (3.0, Some(2.0)), (2.0, None)]);
        assert_eq!([0.0, 0.49, 0.5, 1.9, 2.0, 9.0].map(|t| at(&steps, t)), [1.0, 1.0, 3.0, 3.0, 2.0, 2.0]);
        assert_eq!(steps.bounds(), (1.0, 3.0));
        let table = Course::table(&[(1.0, 2.0), (3.0, 6.0), (4.0, 0.0)]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 9.0].map(|t| at(&table, t)), [2.0, 2.0, 4.0, 6.0, 3.0, 0.0, 0.0]);
        assert_eq!(table.bounds(), (0.0, 6.0));
        let wave = Course::steps(&[(5.0, None)]).with(vec![Harmonic::new(2.0, 0.25, 0.0)]);
        assert!((at(&wave, 2.0) - 3.0).abs() < 1e-15 && (at(&wave, 1.0) - 5.0).abs() < 1e-15);
        assert_eq!(wave.bounds(), (3.0, 7.0));
        assert!(!wave.is_constant() && !steps.is_constant() && Course::steps(&[(5.0, None)]).is_constant());
    }
}
