//! Sensitivity indices: which share of the variance of a quantity each random axis causes.
//!
//! The first-order index S of an axis is the share of the variance that its value alone explains. The total index T is the share that
//! would remain if all others were known: it counts interactions too. With the points A, B and A_i (A with the value of axis i from B)
//! of the design `saltelli`, f the quantity, m its mean and V its variance,
//!
//! ```text
//! S_i = mean((f(B) - m) (f(A_i) - f(A))) / V          A. Saltelli et al., Comput. Phys. Commun. 181 (2010), 259-270, Table 2 (b)
//! T_i = mean((f(A) - f(A_i))²) / 2V                   M. J. W. Jansen, Comput. Phys. Commun. 117 (1999), 35-43
//! ```
//!
//! The bounds of 95 % are those of the asymptotic normal distribution of a ratio of means (A. Janon et al., ESAIM: Probab. Stat. 18
//! (2014), 342-364). They hold for independent samples; those of a Sobol' sequence are usually closer.

use std::borrow::Cow;

use super::Block;
use crate::output::{OutputError, Table, table::Values};
use crate::sweep::axis::Axis;
use crate::sweep::manifest::Layout;

/// File name of the table.
pub const FILE: &str = "sensitivity.csv";
/// Half the width of an interval that holds 95 % of a normal distribution, in standard deviations.
const BOUND: f64 = 1.959_963_984_540_054;

/// An index with its 95 % confidence interval, `value` ± `bound`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The estimate.
    pub value: f64,
    /// Half the width of the interval.
    pub bound: f64,
}

impl Index {
    /// The ratio of the means of `u` and `v`.
    fn ratio(u: &[f64], v: &[f64]) -> Index {
        let n = u.len() as f64;
        let mean = |x: &[f64]| x.iter().sum::<f64>() / n;
        let (variance, value) = (mean(v), mean(u) / mean(v));
        let square: f64 = u.iter().zip(v).map(|(u, v)| ((u - value * v) / variance).powi(2)).sum();
        Index { value, bound: BOUND * (square / (n * (n - 1.0))).sqrt() }
    }
}

/// The indices of one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Indices {
    /// Key of the axis.
    pub key: String,
    /// First-order index.
    pub first: Index,
    /// Total index.
    pub total: Index,
}

/// The indices of all random axes, and the number of base samples used. A base sample is left out if one of its points did not run to its
/// end. `None` if fewer than two base samples are left, or the quantity does not vary.
pub fn of(layout: &Layout, block: &Block<'_>, column: usize) -> Option<(Vec<Indices>, usize)> {
    let axes: Vec<&Axis> = layout.plan.axes.iter().filter(|axis| axis.count().is_none()).collect();
    let number = |row: &Option<&crate::sweep::row::Row>| row.map(|row| row.numbers[column]).filter(|x| x.is_finite());
    let samples = block.rows.chunks(axes.len() + 2);
    let samples: Vec<Vec<f64>> = samples.filter_map(|rows| rows.iter().map(number).collect()).collect();
    let indices = estimate(&samples)?.into_iter().zip(axes);
    let named = indices.map(|((first, total), axis)| Indices { key: axis.key.clone(), first, total });
    Some((named.collect(), samples.len()))
}

/// First-order and total index of each axis, from samples f(A), f(A_1), .., f(A_d), f(B).
fn estimate(samples: &[Vec<f64>]) -> Option<Vec<(Index, Index)>> {
    let d = samples.first()?.len() - 2;
    // The values are compared, because the computed variance of equal numbers may differ from 0: their mean has a rounding error.
    if samples.len() < 2 || samples.iter().all(|f| f[0] == samples[0][0] && f[d + 1] == samples[0][0]) {
        return None;
    }
    let n = samples.len() as f64;
    let mean = samples.iter().map(|f| f[0] + f[d + 1]).sum::<f64>() / (2.0 * n);
    let variance = |f: &Vec<f64>| 0.5 * ((f[0] - mean).powi(2) + (f[d + 1] - mean).powi(2));
    let variances: Vec<f64> = samples.iter().map(variance).collect();
    let ratio = |of: &dyn Fn(&Vec<f64>) -> f64| Index::ratio(&samples.iter().map(of).collect::<Vec<_>>(), &variances);
    let both = |i: usize| {
        let first = ratio(&|f| (f[d + 1] - mean) * (f[i] - f[0]));
        let total = ratio(&|f| 0.5 * (f[0] - f[i]).powi(2));
        (first, total)
    };
    Some((1..=d).map(both).collect())
}

/// The indices of all quantities that vary, one row per axis, quantity and grid point.
///
/// # Errors
/// [`OutputError`].
pub fn table(layout: &Layout, blocks: &[Block<'_>]) -> Result<Table, OutputError> {
    let (mut places, mut names, mut found) = (vec![], vec![], vec![]);
    for block in blocks {
        for (column, (name, _)) in layout.columns.iter().enumerate() {
            let Some((indices, samples)) = of(layout, block, column) else { continue };
            for one in indices {
                places.push(block);
                names.push((Cow::Owned(name.clone()), Cow::Owned(one.key.clone())));
                found.push((one.first, one.total, samples));
            }
        }
    }
    let mut table = super::table(layout, &places)?;
    let (quantities, keys) = names.into_iter().unzip();
    table.push("quantity", "", Values::Text(quantities))?;
    table.push("key", "", Values::Text(keys))?;
    let mut push = |name: &str, of: fn(&(Index, Index, usize)) -> f64| {
        table.push(name, "1", Values::Number(found.iter().map(of).collect()))
    };
    push("first_order", |(first, ..)| first.value)?;
    push("first_order_bound", |(first, ..)| first.bound)?;
    push("total", |(_, total, _)| total.value)?;
    push("total_bound", |(_, total, _)| total.bound)?;
    push("samples", |(.., samples)| *samples as f64)?;
    Ok(table)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::sweep::design::{Design, Sampler};

    /// Ishigami's function with a = 7, b = 0.1 on three uniform axes from -pi to pi. Its indices in closed form, e.g. from Saltelli et
    /// al., "Global Sensitivity Analysis: The Primer" (2008): V1 = (1 + b pi^4/5)²/2, V2 = a²/8, V13 = b² pi^8 (1/18 - 1/50).
    #[test]
    fn indices_of_ishigamis_function_are_those_of_its_closed_form() {
        let (a, b) = (7.0, 0.1);
        let f = |x: [f64; 3]| x[0].sin() + a * x[1].sin().powi(2) + b * x[2].powi(4) * x[0].sin();
        let v1 = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
        let (v2, v13) = (a * a / 8.0, b * b * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0));
        let v = v1 + v2 + v13;
        let expected = [(v1 / v, (v1 + v13) / v), (v2 / v, v2 / v), (0.0, v13 / v)];

        let n = 4096;
        let mut inside = 0;
        for seed in 0..20 {
            let sampler = Sampler::new(Design::Saltelli, n, seed, 3);
            let point = |sample: usize| [0, 1, 2].map(|axis| PI * (2.0 * sampler.fraction(0, sample, axis) - 1.0));
            let samples: Vec<Vec<f64>> = (0..n).map(|j| (0..5).map(|k| f(point(5 * j + k))).collect()).collect();
            for ((first, total), (s, t)) in estimate(&samples).unwrap().into_iter().zip(expected) {
                assert!(
                    (first.value - s).abs() < 0.01 && (total.value - t).abs() < 0.02,
                    "{first:?} {s} {total:?} {t}"
                );
                inside += usize::from((first.value - s).abs() <= first.bound);
                inside += usize::from((total.value - t).abs() <= total.bound);
            }
        }
        // 95 % of 120 is 114. The bounds are for independent points; the estimates from a Sobol' sequence are usually closer.
        assert!(inside >= 112, "{inside} of 120");
    }

    /// For independent samples 95 of 100 intervals contain the true index.
    #[test]
    fn bounds_hold_as_often_as_they_say_for_independent_samples() {
        let (n, trials) = (400, 500);
        let mut inside = 0;
        for seed in 0..trials {
            let x = |j: usize, k: usize| crate::sweep::random::fraction(seed, (4 * j + k) as u64) - 0.5;
            // f = x1 + 2 x2: S = T = 1/5 and 4/5.
            let f = |x1: f64, x2: f64| x1 + 2.0 * x2;
            let sample = |j: usize| {
                let (a1, a2, b1, b2) = (x(j, 0), x(j, 1), x(j, 2), x(j, 3));
                vec![f(a1, a2), f(b1, a2), f(a1, b2), f(b1, b2)]
            };
            let both = estimate(&(0..n).map(sample).collect::<Vec<_>>()).unwrap();
            inside += usize::from((both[0].0.value - 0.2).abs() <= both[0].0.bound);
        }
        // 95 % of 500 is 475, with a standard deviation of 4.9.
        assert!((455..=495).contains(&inside), "{inside} of {trials}");
    }

    #[test]
    fn a_quantity_that_does_not_vary_has_no_indices() {
        for x in [2.0, 0.1] {
            assert!(estimate(&vec![vec![x; 4]; 256]).is_none(), "{x}");
        }
        assert!(estimate(&[]).is_none());
    }
}
