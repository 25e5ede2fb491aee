//! The lines of a signal, as far as its record separates them. Two lines that are closer than half the main lobe of the Hann window, two
//! lines of the transform, are one line in the list: it is at the order of the higher one, and names both. The others have amplitudes A by
//! least squares over the whole record, so that no line contributes to another. With x = (o_i - o_j) R in a record of R revolutions, and
//! with b the Fourier integrals at the orders o of the lines,
//!
//! ```text
//! sum_j W(o_i - o_j) A_j = b_i,    W = exp(-i pi x) sin(pi x)/(pi x (1 - x^2))
//! ```
//!
//! W is the transform of the window. The matrix is Hermitian and positive definite, so that Gauss-Seidel iterations converge.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::Turning;
use super::lines::{LOBE, Line};

/// A line of a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// The line.
    pub line: Line,
    /// Further lines that the record does not separate from it, the nearest first.
    pub with: Vec<Line>,
    /// Peak amplitude [unit of the signal].
    pub amplitude: f64,
}

/// Lines farther from each other than this contribute less than 3e-6 of their amplitude to each other [lines of the transform].
const FAR: f64 = 50.0;
/// The iteration ends when no amplitude changes by more than this [relative to the largest].
const CONVERGED: f64 = 1e-12;
/// Most iterations [iterations]. Lines two lines of the transform apart need about ten.
const MOST: usize = 100;

impl Turning {
    /// The lines of each of `columns` among `lines`. A multiple of a mesh order is always listed, a sideband only where it stands out.
    pub fn listed(&self, columns: &[&[f64]], lines: &[Line]) -> Vec<Vec<Listed>> {
        let transforms = self.transforms(columns, lines);
        let of = |(c, column): (usize, &&[f64])| {
            let has = self.has(column, lines);
            let present = lines.iter().zip(&transforms).zip(has).filter(|(_, has)| *has);
            self.separated(present.map(|((line, transforms), _)| (*line, transforms[c])).collect())
        };
        columns.iter().enumerate().map(of).collect()
    }

    /// The lines with their Fourier integrals, joined where the record does not separate them.
    fn separated(&self, mut all: Vec<(Line, Complex<f64>)>) -> Vec<Listed> {
        let apart = |a: &Line, b: &Line| (a.order - b.order).abs() * self.length();
        // A multiple of a mesh order before sidebands, then the higher line.
        all.sort_by(|(a, x), (b, y)| a.rotor.is_some().cmp(&b.rotor.is_some()).then(y.norm().total_cmp(&x.norm())));
        let (mut listed, mut integrals): (Vec<Listed>, Vec<Complex<f64>>) = (vec![], vec![]);
        for (line, integral) in all {
            let near = listed.iter_mut().min_by(|a, b| apart(&a.line, &line).total_cmp(&apart(&b.line, &line)));
            match near.filter(|near| apart(&near.line, &line) < LOBE) {
                Some(near) => near.with.push(line),
                None => {
                    listed.push(Listed { line, with: vec![], amplitude: 0.0 });
                    integrals.push(integral);
                }
            }
        }
        let orders: Vec<f64> = listed.iter().map(|of| of.line.order * self.length()).collect();
        for (of, amplitude) in listed.iter_mut().zip(amplitudes(&orders, &integrals)) {
            of.amplitude = amplitude.norm();
            of.with.sort_by(|a, b| apart(&of.line, a).total_cmp(&apart(&of.line, b)));
        }
        listed.sort_by(|a, b| a.line.order.total_cmp(&b.line.order));
        listed
    }
}

/// The amplitudes of lines at these orders [lines of the transform] with these Fourier integrals.
fn amplitudes(orders: &[f64], integrals: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let near = |i: usize| {
        let others = (0..orders.len()).filter(move |&j| j != i && (orders[i] - orders[j]).abs() < FAR);
        others.map(|j| (j, window(orders[i] - orders[j]))).collect::<Vec<_>>()
    };
    let near: Vec<_> = (0..orders.len()).map(near).collect();
    let mut found = integrals.to_vec();
    let largest = found.iter().fold(0.0, |m: f64, x| m.max(x.norm()));
    for _ in 0..MOST {
        let mut change: f64 = 0.0;
        for i in 0..found.len() {
            let others: Complex<f64> = near[i].iter().map(|(j, w)| w * found[*j]).sum();
            let next = integrals[i] - others;
            change = change.max((next - found[i]).norm());
            found[i] = next;
        }
        if change <= CONVERGED * largest {
            break;
        }
    }
    found
}

/// The transform of the Hann window at a distance of `x` lines, 1 at x = 0 and 1/2 in magnitude at x = 1.
fn window(x: f64) -> Complex<f64> {
    let magnitude = match x.abs() {
        zero if zero < 1e-9 => 1.0,
        one if (one - 1.0).abs() < 1e-9 => 0.5,
        _ => (PI * x).sin() / (PI * x * (1.0 - x * x)),
    };
    Complex::from_polar(1.0, -PI * x) * magnitude
}
