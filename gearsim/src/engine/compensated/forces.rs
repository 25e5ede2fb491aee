//! Torques that vary in time, in double-double precision: the formulas of [`crate::engine::forcing`].

use nalgebra::DVector;
use xprec::Df64;

use super::series::TERMS;
use crate::engine::forcing::{Forcing, TURN};
use crate::scene::TimeHistory;

/// The parameters that vary. Each has its generalised forces per unit (n), its time history, its present piece, and its value at the start.
#[derive(Debug, Clone)]
pub struct Forces<'a>(Vec<Force<'a>>);

#[derive(Debug, Clone)]
struct Force<'a> {
    load: &'a DVector<Df64>,
    history: &'a TimeHistory,
    piece: usize,
    at_start: f64,
}

impl<'a> Forces<'a> {
    /// The parameters of `forcing` in their present pieces; `loads` are the generalised forces per unit of each.
    pub fn of(forcing: Option<&'a Forcing>, loads: &'a [DVector<Df64>]) -> Self {
        let all = forcing.into_iter().flat_map(Forcing::histories).zip(loads);
        Forces(all.map(|((history, piece, at_start), load)| Force { load, history, piece, at_start }).collect())
    }

    /// The generalised forces per unit of each.
    pub fn loads(&self) -> impl Iterator<Item = &DVector<Df64>> {
        self.0.iter().map(|force| force.load)
    }

    /// Power series of T(t) - T(0) of each parameter about the time `t` \[s\]. The variable is the time since `t`, divided by `width`
    /// \[s\].
    pub fn series(&self, t: Df64, width: f64) -> Vec<[Df64; TERMS]> {
        self.0.iter().map(|force| force.series(t, width)).collect()
    }
}

impl Force<'_> {
    /// The slope of the present piece. If the piece connects two given points, the slope is the quotient of their differences, computed in
    /// double-double precision.
    fn slope(&self) -> Df64 {
        let piece = self.history.pieces[self.piece];
        let Some(next) = self.history.pieces.get(self.piece + 1) else { return piece.slope.into() };
        let quotient = (next.value - piece.value) / (next.begin - piece.begin);
        if quotient != piece.slope {
            return piece.slope.into();
        }
        (Df64::from(next.value) - piece.value) / (Df64::from(next.begin) - piece.begin)
    }

    fn series(&self, t: Df64, width: f64) -> [Df64; TERMS] {
        let (mut c, slope) = ([Df64::from(0.0); TERMS], self.slope());
        let piece = self.history.pieces[self.piece];
        c[0] = Df64::from(piece.value) - self.at_start + slope * (t - piece.begin);
        c[1] = slope * width;
        for h in &self.history.harmonics {
            let angle = Df64::from(h.omega) * t;
            let turns = (angle.hi() / TURN.0).round();
            let (sin, cos) = ((angle - Df64::from(TURN.0) * turns - Df64::from(TURN.1) * turns) + h.phase).sin_cos();
            let z = Df64::from(h.omega) * width;
            let (mut real, mut imaginary) = (cos * h.amplitude, sin * h.amplitude);
            for (n, c) in c.iter_mut().enumerate() {
                *c += real;
                let by = z / (n + 1) as f64;
                (real, imaginary) = (-imaginary * by, real * by);
            }
        }
        c
    }
}
