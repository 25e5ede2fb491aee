//! Energy dissipated on a flight by modes that damping couples: ∫ uᵀG u dt with u = sum X1 a' + X2 a'', where a'' is without the
//! part that a changing load adds at once ([`Driven`]).
//!
//! The speeds are sums of terms: two exponentials of each mode, and the steady motion, which all modes share. The products of the
//! exponentials have weights that are computed once for each cell.

use nalgebra::{Complex, DMatrix};

use crate::engine::cell::{Driven, Moments, Speed, Sum, derivative, rate_of};
use crate::engine::modal::Coupled;
use crate::engine::mode::exp_m1;
use crate::tolerance::modes::SERIES_SPAN;

type Vector = Vec<Complex<f64>>;

/// The exponentials of the modes of one cell: two of each mode.
#[derive(Debug, Clone)]
pub struct Exponentials {
    /// G phi of each exponential, with phi = X1 + lambda X2.
    damped: Vec<Vector>,
    /// phi_kᵀG phi_l, and the same divided by lambda_k + lambda_l.
    weights: [DMatrix<Complex<f64>>; 2],
}

/// An exponential of a motion. A complex one stands for its conjugate, too.
struct Part {
    number: usize,
    rate: Complex<f64>,
    factor: Complex<f64>,
    /// e^{lambda t} - 1.
    grown: Complex<f64>,
    /// 1 for a real one, 2 for a complex one.
    count: f64,
}

/// Steady terms of one rate, by their powers of t.
type Steady = Vec<(Complex<f64>, Vec<Vector>)>;

impl Exponentials {
    /// Those of `coupled`; `None` if the two eigenvalues of a mode coincide.
    pub fn new(coupled: &Coupled) -> Option<Self> {
        let Coupled { modes, by_speed, by_acceleration, damping, .. } = coupled;
        let m = by_speed.nrows();
        let (mut shapes, mut rates): (Vec<Vector>, Vec<Complex<f64>>) = (vec![], vec![]);
        for (k, mode) in modes.iter().enumerate() {
            let of = |lambda: Complex<f64>| -> Vector {
                (0..m).map(|i| by_speed[(i, k)] + lambda * by_acceleration[(i, k)]).collect()
            };
            // The shape of a rigid mode without damping has no part in the loss.
            let own = if mode.is_rigid() { [0.0.into(); 2] } else { mode.eigenvalues()? };
            shapes.extend(own.map(of));
            rates.extend(own);
        }
        let damped: Vec<Vector> = shapes.iter().map(|shape| times(damping, shape)).collect();
        let weights = DMatrix::from_fn(shapes.len(), shapes.len(), |i, j| dot(&shapes[i], &damped[j]));
        let divided = DMatrix::from_fn(shapes.len(), shapes.len(), |i, j| weights[(i, j)] / (rates[i] + rates[j]));
        Some(Exponentials { damped, weights: [weights, divided] })
    }

    /// The integral from 0 to `t` \[s\], from the speeds a' of the modes; `modal` are X1, X2 and G.
    pub fn lost(&self, modal: &[DMatrix<f64>; 3], speeds: &[Speed], driven: Option<&Driven>, t: f64) -> f64 {
        let parts = parts(speeds, t);
        let mut sum = 0.0;
        for (at, a) in parts.iter().enumerate() {
            let mut row = Complex::from(0.0);
            for (further, b) in parts[at..].iter().enumerate() {
                let twice = if further == 0 { 1.0 } else { 2.0 };
                let mut each = self.between(a, (b.number, b.rate, b.factor, b.grown), t);
                if a.count * b.count == 4.0 {
                    let conjugate = (b.number + 1, b.rate.conj(), b.factor.conj(), b.grown.conj());
                    each += self.between(a, conjugate, t);
                }
                row += each * twice * a.count.max(b.count);
            }
            sum += (row * a.factor).re;
        }
        let [by_speed, by_acceleration, damping] = modal;
        let steady = steady([by_speed, by_acceleration], speeds, driven);
        let damped: Vec<Vec<Vector>> =
            steady.iter().map(|(_, by_power)| by_power.iter().map(|u| times(damping, u)).collect()).collect();
        for (at, (rate, by_power)) in steady.iter().enumerate() {
            for a in &parts {
                let moments = Moments::of(a.rate + rate, by_power.len(), t);
                let along = by_power.iter().enumerate().map(|(k, u)| dot(&self.damped[a.number], u) * moments.0[k]);
                sum += 2.0 * a.count * (along.sum::<Complex<f64>>() * a.factor).re;
            }
            for (number, (other, forces)) in steady.iter().map(|(rate, _)| rate).zip(&damped).enumerate().skip(at) {
                let moments = Moments::of(rate + other, by_power.len() + forces.len() - 1, t);
                let twice = if number == at { 1.0 } else { 2.0 };
                for (k, u) in by_power.iter().enumerate() {
                    for (l, force) in forces.iter().enumerate() {
                        sum += twice * (dot(u, force) * moments.0[k + l]).re;
                    }
                }
            }
        }
        sum
    }

    /// The integral of the product of two exponentials, without the factor of the first.
    #[inline]
    fn between(
        &self,
        a: &Part,
        (number, rate, factor, grown): (usize, Complex<f64>, Complex<f64>, Complex<f64>),
        t: f64,
    ) -> Complex<f64> {
        let ([whole, divided], at) = (&self.weights, (a.number, number));
        let sum = a.rate + rate;
        match sum.norm_sqr() * t * t >= SERIES_SPAN * SERIES_SPAN {
            true => factor * divided[at] * (a.grown + grown + a.grown * grown),
            false => factor * whole[at] * Moments::of(sum, 1, t).0[0],
        }
    }
}

/// The steady part of u, by its terms, from the shapes X1, X2.
fn steady(shapes: [&DMatrix<f64>; 2], speeds: &[Speed], driven: Option<&Driven>) -> Steady {
    let mut all: Steady = vec![];
    let m = shapes[0].nrows();
    let mut add = |which: usize, k: usize, sum: &Sum, sign: f64| {
        for (term, factor) in sum.iter().filter(|(_, factor)| *factor != Complex::from(0.0)) {
            let at = all.iter().position(|(rate, _)| *rate == term.rate).unwrap_or_else(|| {
                all.push((term.rate, vec![]));
                all.len() - 1
            });
            let by_power = &mut all[at].1;
            by_power.resize(by_power.len().max(term.power + 1), vec![0.0.into(); m]);
            let shape = shapes[which].column(k);
            by_power[term.power].iter_mut().zip(shape.iter()).for_each(|(u, x)| *u += factor * sign * *x);
        }
    };
    for (k, speed) in speeds.iter().enumerate() {
        if !speed.steady.is_empty() {
            add(0, k, &speed.steady, 1.0);
            add(1, k, &derivative(&speed.steady), 1.0);
        }
        if let Some((driven, [of_speed, _])) = driven.and_then(|driven| Some((driven, driven.coupled.as_ref()?))) {
            add(1, k, &rate_of(of_speed, driven, k), -1.0);
        }
    }
    all
}

/// The exponentials of a motion after the time `t` \[s\]; one of each pair of conjugates.
fn parts(speeds: &[Speed], t: f64) -> Vec<Part> {
    let mut parts = vec![];
    for (k, speed) in speeds.iter().enumerate() {
        let oscillates = speed.free[0].0.im != 0.0;
        for (of, (rate, factor)) in speed.free.iter().enumerate().take(if oscillates { 1 } else { 2 }) {
            // An undamped vibration has no part in the loss.
            if *factor != Complex::from(0.0) && rate.re != 0.0 {
                let count = if oscillates { 2.0 } else { 1.0 };
                parts.push(Part { number: 2 * k + of, rate: *rate, factor: *factor, grown: exp_m1(rate * t), count });
            }
        }
    }
    parts
}

fn times(a: &DMatrix<f64>, x: &[Complex<f64>]) -> Vector {
    let mut product = vec![Complex::from(0.0); a.nrows()];
    for (column, x) in a.column_iter().zip(x) {
        product.iter_mut().zip(column.iter()).for_each(|(sum, a)| *sum += x * *a);
    }
    product
}

#[inline]
fn dot(a: &[Complex<f64>], b: &[Complex<f64>]) -> Complex<f64> {
    let mut sum = Complex::from(0.0);
    for i in 0..a.len().min(b.len()) {
        sum += a[i] * b[i];
    }
    sum
}
