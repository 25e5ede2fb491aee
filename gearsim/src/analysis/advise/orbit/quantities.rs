//! The quantities of a settled motion: means, peaks, spectral lines and the dissipated energy.

use std::f64::consts::TAU;

use nalgebra::{Complex, DVector};

use super::leg::Leg;
use super::{Orbit, Steady, Unknown};

/// Number of spectral lines.
const LINES: usize = 200;

impl Steady<'_> {
    /// Evaluates the motion over a period of length `period` [s] from the state `start`, with `impulses` at the ends of `legs`.
    pub(super) fn quantities(
        &self,
        legs: &[Leg],
        impulses: &[DVector<f64>],
        start: DVector<f64>,
        period: f64,
        strength: f64,
    ) -> Result<Orbit, Unknown> {
        let (n, m) = self.shapes.shape();
        let c = self.system.matrices(&self.stretches[0].levels)?.damping;
        let mut points: Vec<(f64, f64, DVector<f64>)> = vec![];
        let (mut y, mut t, mut lost) = (start, 0.0, 0.0);
        let power = |y: &DVector<f64>| {
            let v = &self.shapes * y.rows(m, m);
            v.dot(&(&c * &v))
        };
        for (leg, impulse) in legs.iter().zip(impulses) {
            for _ in 0..leg.substeps {
                let next = leg.walk(&y);
                lost += 0.5 * leg.step * (power(&y) + power(&next));
                // Both ends of the substep, with the weights of the trapezoidal rule.
                points.push((t, leg.step / 2.0, &self.shapes * y.rows(0, m)));
                t += leg.step;
                points.push((t, leg.step / 2.0, &self.shapes * next.rows(0, m)));
                y = next;
            }
            y += impulse;
        }
        let mean = |i: usize| points.iter().map(|(_, w, q)| w * q[i]).sum::<f64>() / period;
        let means: Vec<f64> = (0..n).map(mean).collect();
        let square = |i: usize| points.iter().map(|(_, w, q)| w * (q[i] - means[i]).powi(2)).sum::<f64>() / period;
        let mut lines = vec![Vec::with_capacity(LINES); n];
        for order in 1..=LINES {
            let turn = TAU * order as f64 / period;
            let mut sums = vec![Complex::from(0.0); n];
            for (t, w, q) in &points {
                let turned = Complex::from_polar(*w, -turn * t);
                sums.iter_mut().enumerate().for_each(|(i, sum)| *sum += turned * (q[i] - means[i]));
            }
            lines.iter_mut().zip(sums).for_each(|(line, sum)| line.push(2.0 * (sum / period).norm_sqr()));
        }
        Ok(Orbit {
            period,
            square: (0..n).map(square).collect(),
            peak: (0..n).map(|i| points.iter().fold(0.0f64, |m, p| m.max((p.2[i] - means[i]).abs()))).collect(),
            size: (0..n).map(|i| points.iter().fold(0.0f64, |m, p| m.max(p.2[i].abs()))).collect(),
            lines,
            lost,
            steps: legs.iter().filter(|leg| !leg.steps.is_empty()).count(),
            strength,
        })
    }
}
