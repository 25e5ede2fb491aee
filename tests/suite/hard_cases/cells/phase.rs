//! The turning points of a phase and a bound on its motion, for drawing cells.

use gearsim_tests::precise;
use gearsim_tests::precise::cell::Motion;

/// The phase in `f64`: accurate enough to find crests, not to judge them.
pub struct Phase<const N: usize>(pub [(Motion<f64>, f64); N]);

impl<const N: usize> Phase<N> {
    /// The phase and its rate.
    pub fn at(&self, t: f64) -> [f64; 2] {
        self.0.iter().fold([0.0; 2], |[s, r], (m, c)| {
            let (x, v) = m.state(&t);
            [s + c * x, r + c * v]
        })
    }

    /// The time between `left` and `right` at which the phase turns, and the phase there.
    pub fn top(&self, mut left: f64, mut right: f64) -> (f64, f64) {
        for _ in 0..60 {
            let middle = 0.5 * (left + right);
            if self.at(middle)[1] > 0.0 { left = middle } else { right = middle }
        }
        (left, self.at(left)[0].max(self.at(right)[0]))
    }
}

/// A bound on the distance that a mode moves from x = 0 within `t`.
pub fn bound(m: &precise::Mode, t: f64) -> f64 {
    let omega = m.omega2.sqrt();
    let gain = t.min(1.0 / omega).min(1.0 / m.sigma);
    m.v.abs() * gain + m.force.abs() * (0.5 * t * t).min(2.0 / m.omega2)
}
