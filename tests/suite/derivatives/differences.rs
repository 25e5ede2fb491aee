//! Derivatives by central differences whose steps shrink, extrapolated to the step zero (Ridders 1982), each with an estimate of its error.

use gearsim::__private::Vector;

/// First step, in units of the usual size of the coordinate.
const FIRST: f64 = 0.01;
/// Factor between two steps.
const SHRINK: f64 = 1.6;
/// Number of steps.
const STEPS: usize = 14;
/// Rounding errors of a function value, in units of the largest component: large terms may cancel in the others.
const ROUNDINGS: f64 = 32.0;

/// The estimate of the error may be too small by this factor: the force of a fan has a kink in its slope where its speed is zero.
const SAFETY: f64 = 10.0;

/// The derivative of a vector along one direction.
#[derive(Debug, Clone)]
pub struct Difference {
    pub value: Vec<f64>,
    pub error: Vec<f64>,
}

/// The derivatives of `f` at `x` along each coordinate; `sizes` are the usual sizes of the coordinates.
pub fn by_direction(x: &[f64], sizes: &[f64], f: impl Fn(&[f64]) -> Vector) -> Vec<Difference> {
    (0..x.len()).map(|j| along(x, j, sizes[j], &f)).collect()
}

fn along(x: &[f64], j: usize, size: f64, f: &impl Fn(&[f64]) -> Vector) -> Difference {
    let at = |h: f64| {
        let mut moved = x.to_vec();
        moved[j] += h;
        (f(&moved), moved[j])
    };
    let n = f(x).len();
    let (mut value, mut error) = (vec![f64::NAN; n], vec![f64::INFINITY; n]);
    // Row m of the table has the estimates from the m + 1 latest steps.
    let mut before: Vec<Vec<f64>> = vec![];
    for step in 0..STEPS {
        let h = FIRST * size / SHRINK.powi(step as i32);
        let ((above, right), (below, left)) = (at(h), at(-h));
        let rounding = ROUNDINGS * f64::EPSILON * (above.amax() + below.amax()) / (right - left);
        let mut row = vec![(0..n).map(|i| (above[i] - below[i]) / (right - left)).collect::<Vec<f64>>()];
        for m in 0..before.len() {
            let factor = SHRINK.powi(2 * (m as i32 + 1));
            let next = (0..n).map(|i| {
                let next = (factor * row[m][i] - before[m][i]) / (factor - 1.0);
                let change = (next - row[m][i]).abs().max((next - before[m][i]).abs()) + rounding;
                if change < error[i] {
                    (value[i], error[i]) = (next, change);
                }
                next
            });
            let next = next.collect();
            row.push(next);
        }
        before = row;
    }
    let error = error.into_iter().map(|error| SAFETY * error).collect();
    Difference { value, error }
}
