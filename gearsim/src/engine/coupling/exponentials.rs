//! Energy dissipated on a flight by modes that damping couples: ∫ uᵀG u dt with u = sum X1 a' + X2 a'', where a'' is without the
//! part that a changing load adds at once ([`Driven`]).
//!
//! The speeds are sums of terms: two exponentials of each mode, and the steady motion, which all modes share. The products of the
//! exponentials have weights that are computed once for each cell.

use nalgebra::{Complex, DMatrix};

use crate::engine::cell::{Driven, Speed, Sum, Term, derivative, moment, rate_of};
use crate::engine::modal::Coupled;
use crate::engine::mode::exp_m1;
use crate::tolerance::modes::SERIES_SPAN;

type Vector = Vec<Complex<f64>>;

/// The exponentials of the modes of one cell: two of each mode.
#[derive(Debug, Clone)]
pub struct Exponentials {
    /// X1, X2.
    shapes: [DMatrix<f64>; 2],
    damping: DMatrix<f64>,
    /// G phi of each exponential, with phi = X1 + lambda X2.
    damped: Vec<Vector>,
    /// phi_kᵀG phi_l.
    weights: DMatrix<Complex<f64>>,
}

impl Exponentials {
    /// Those of `coupled`; `None` if the two eigenvalues of a mode coincide.
    pub fn new(coupled: &Coupled) -> Option<Self> {
        let Coupled { modes, by_speed, by_acceleration, damping, .. } = coupled;
        let m = by_speed.nrows();
        let mut shapes: Vec<Vector> = vec![];
        for (k, mode) in modes.iter().enumerate() {
            let of = |lambda: Complex<f64>| -> Vector {
                (0..m).map(|i| by_speed[(i, k)] + lambda * by_acceleration[(i, k)]).collect()
            };
            // The shape of a rigid mode without damping has no part in the loss.
            shapes.extend(if mode.is_rigid() { [0.0.into(), 0.0.into()] } else { mode.eigenvalues()? }.map(of));
        }
        let damped: Vec<Vector> = shapes.iter().map(|shape| times(damping, shape)).collect();
        let weights = DMatrix::from_fn(shapes.len(), shapes.len(), |i, j| dot(&shapes[i], &damped[j]));
        let [by_speed, by_acceleration] = [by_speed, by_acceleration].map(Clone::clone);
        Some(Exponentials { shapes: [by_speed, by_acceleration], damping: damping.clone(), damped, weights })
    }

    /// The integral from 0 to `t` \[s\], from the speeds a' of the modes.
    pub fn lost(&self, speeds: &[Speed], driven: Option<&Driven>, t: f64) -> f64 {
        let free: Vec<(usize, Complex<f64>, Complex<f64>, Complex<f64>)> = speeds
            .iter()
            .enumerate()
            .flat_map(|(k, speed)| (0..2).map(move |of| (2 * k + of, speed.free[of])))
            .filter(|(_, (_, factor))| *factor != Complex::from(0.0))
            .map(|(number, (rate, factor))| (number, rate, factor, exp_m1(rate * t)))
            .collect();
        let mut sum = Complex::from(0.0);
        for (at, (i, first, a, e)) in free.iter().enumerate() {
            let mut row = Complex::from(0.0);
            for (j, second, b, f) in &free[at..] {
                let weight = self.weights[(*i, *j)];
                if weight == Complex::from(0.0) {
                    continue;
                }
                let rate = first + second;
                let grown = match rate.norm() * t >= SERIES_SPAN {
                    true => (e + f + e * f) / rate,
                    false => moment(rate, 0, t),
                };
                row += b * weight * grown * if i == j { 1.0 } else { 2.0 };
            }
            sum += row * a;
        }
        let steady = self.steady(speeds, driven);
        for (at, (term, u)) in steady.iter().enumerate() {
            for (i, rate, a, _) in &free {
                sum += a * dot(&self.damped[*i], u) * moment(rate + term.rate, term.power, t) * 2.0;
            }
            let damped = times(&self.damping, u);
            for (number, (other, v)) in steady.iter().enumerate().skip(at) {
                let twice = if number == at { 1.0 } else { 2.0 };
                sum += dot(v, &damped) * moment(term.rate + other.rate, term.power + other.power, t) * twice;
            }
        }
        sum.re
    }

    /// The steady part of u, by its terms.
    fn steady(&self, speeds: &[Speed], driven: Option<&Driven>) -> Vec<(Term, Vector)> {
        let mut all: Vec<(Term, Vector)> = vec![];
        let m = self.damping.nrows();
        let mut add = |which: usize, k: usize, sum: &Sum, sign: f64| {
            for (term, factor) in sum.iter().filter(|(_, factor)| *factor != Complex::from(0.0)) {
                let at = all.iter().position(|(other, _)| other == term).unwrap_or_else(|| {
                    all.push((*term, vec![0.0.into(); m]));
                    all.len() - 1
                });
                all[at].1.iter_mut().enumerate().for_each(|(i, u)| *u += factor * sign * self.shapes[which][(i, k)]);
            }
        };
        for (k, speed) in speeds.iter().enumerate() {
            add(0, k, &speed.steady, 1.0);
            add(1, k, &derivative(&speed.steady), 1.0);
            if let Some((driven, [of_speed, _])) = driven.and_then(|driven| Some((driven, driven.coupled.as_ref()?))) {
                add(1, k, &rate_of(of_speed, driven, k), -1.0);
            }
        }
        all
    }
}

fn times(a: &DMatrix<f64>, x: &[Complex<f64>]) -> Vector {
    (0..a.nrows()).map(|i| x.iter().enumerate().map(|(j, x)| x * a[(i, j)]).sum()).collect()
}

fn dot(a: &[Complex<f64>], b: &[Complex<f64>]) -> Complex<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
