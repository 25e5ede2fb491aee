//! Statistics of the recorded quantities over random points.

use std::borrow::Cow;

use super::Block;
use crate::analysis::statistics::percentile;
use crate::output::{OutputError, Table, table::Values};
use crate::sweep::manifest::Layout;

/// File name of the table.
pub const FILE: &str = "statistics.csv";

/// The percentiles: column name, and share of the points.
const SHARES: [(&str, f64); 7] =
    [("p01", 0.01), ("p05", 0.05), ("p25", 0.25), ("p50", 0.5), ("p75", 0.75), ("p95", 0.95), ("p99", 0.99)];

/// Statistics of a quantity over some points [its unit].
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// Number of points that have it.
    pub points: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the population, estimated from the points: the sum of squares over n - 1.
    pub deviation: f64,
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
    /// Percentiles 1, 5, 25, 50, 75, 95, 99, interpolated between points.
    pub percentiles: [f64; SHARES.len()],
}

impl Spread {
    /// The statistics of numbers that are finite; `None` if there are none.
    pub fn of(mut x: Vec<f64>) -> Option<Spread> {
        let n = x.len() as f64;
        let mean = x.iter().sum::<f64>() / n;
        let square: f64 = x.iter().map(|x| (x - mean) * (x - mean)).sum();
        x.sort_by(f64::total_cmp);
        let (min, max) = (*x.first()?, *x.last()?);
        let deviation = if x.len() > 1 { (square / (n - 1.0)).sqrt() } else { f64::NAN };
        let percentiles = SHARES.map(|(_, share)| percentile(&mut x, share));
        Some(Spread { points: x.len(), mean, deviation, min, max, percentiles })
    }
}

/// Statistics of quantity `column` at a point of the grid.
pub fn of(block: &Block<'_>, column: usize) -> Option<Spread> {
    Spread::of(block.numbers(column).collect())
}

/// The statistics of all quantities, one row per quantity and grid point.
///
/// # Errors
/// [`OutputError`].
pub fn table(layout: &Layout, blocks: &[Block<'_>]) -> Result<Table, OutputError> {
    let mut found = vec![];
    for block in blocks {
        let each = layout.columns.iter().enumerate();
        found.extend(each.filter_map(|(i, column)| Some((block, column, of(block, i)?))));
    }
    let mut table = super::table(layout, &found.iter().map(|(block, ..)| *block).collect::<Vec<_>>())?;
    let text = |of: fn(&(String, String)) -> &String| {
        Values::Text(found.iter().map(|(_, column, _)| Cow::Owned(of(column).clone())).collect())
    };
    table.push("quantity", "", text(|(name, _)| name))?;
    table.push("unit", "", text(|(_, unit)| unit))?;
    let mut push = |name: &str, of: &dyn Fn(&Spread) -> f64| {
        table.push(name, "", Values::Number(found.iter().map(|(_, _, spread)| of(spread)).collect()))
    };
    push("points", &|spread| spread.points as f64)?;
    push("mean", &|spread| spread.mean)?;
    push("deviation", &|spread| spread.deviation)?;
    push("min", &|spread| spread.min)?;
    for (i, (name, _)) in SHARES.iter().enumerate() {
        push(name, &|spread| spread.percentiles[i])?;
    }
    push("max", &|spread| spread.max)?;
    Ok(table)
}
