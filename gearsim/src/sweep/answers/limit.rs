//! Limits, and how probable it is that they are broken: `mesh_force_12_max <= 5 kN`.
//!
//! The interval of 95 % is exact for independent points (C. J. Clopper, E. S. Pearson, Biometrika 26 (1934), 404-413). For the points of
//! the designs `latin-hypercube` and `sobol` it is usually wider than necessary. For the design `saltelli` only the points of the samples A
//! and B are counted: each other point repeats all values of a point of A but one. Points of a grid are chosen, not drawn: they have no
//! probability.

use std::borrow::Cow;

use statrs::function::beta::inv_beta_reg;

use super::Block;
use crate::output::{OutputError, Table, table::Values};
use crate::scene::quantity::Quantity;
use crate::scene::unit::Unit;
use crate::sweep::manifest::Layout;
use crate::sweep::{Error, impossible};

/// File name of the table.
pub const FILE: &str = "limits.csv";
/// Function that returns whether a value keeps a limit.
type Keeps = fn(&f64, &f64) -> bool;
/// The comparisons, longer ones first.
const SIGNS: [(&str, Keeps); 4] = [("<=", f64::le), (">=", f64::ge), ("<", f64::lt), (">", f64::gt)];

/// A limit of a recorded quantity, which is kept or broken at each point.
#[derive(Debug, Clone)]
pub struct Limit {
    /// As the user wrote it.
    pub text: String,
    column: usize,
    keeps: Keeps,
    value: f64,
}

/// How often a limit is broken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Broken {
    /// Number of points that break it.
    pub broken: usize,
    /// Number of points that have the quantity.
    pub points: usize,
    /// Number of points that did not run to their end or do not have the quantity. They count neither as kept nor as broken.
    pub unknown: usize,
    /// Whether the points are drawn at random. Otherwise there is no probability.
    pub drawn: bool,
}

impl Limit {
    /// Reads a limit of one of the recorded quantities.
    ///
    /// # Errors
    /// If it has no comparison, no such quantity is recorded, or its value is of another dimension.
    pub fn read(text: &str, layout: &Layout) -> Result<Limit, Error> {
        let Some((sign, keeps)) = SIGNS.into_iter().find(|(sign, _)| text.contains(sign)) else {
            return impossible(
                format!("\"{text}\" is not a limit"),
                "write a recorded quantity, <= or >=, and a value: \"mesh_force_12_max <= 5 kN\"",
            );
        };
        let (name, value) = text.split_once(sign).unwrap_or((text, ""));
        let (name, value) = (name.trim(), value.trim());
        let column = layout.column(name)?;
        let unit = &layout.columns[column].1;
        let expected = Unit::parse(unit).map_err(|error| Error::Output(OutputError::format("unit", error)))?;
        match Quantity::parse(value) {
            Ok(read) if read.value.is_finite() && (read.dimension.fits(expected.dimension) || read.value == 0.0) => {
                Ok(Limit { text: text.trim().into(), column, keeps, value: read.value })
            }
            Ok(_) => impossible(
                format!("limit \"{text}\": `{value}` is no value of `{name}` [{unit}]"),
                "write a finite value with its unit",
            ),
            Err(error) => impossible(format!("limit \"{text}\": {}", error.message), error.help),
        }
    }

    /// Counts the independent points of a block that break the limit.
    pub fn count(&self, layout: &Layout, block: &Block<'_>) -> Broken {
        let block = block.independent(layout);
        let values: Vec<f64> = block.numbers(self.column).collect();
        let broken = values.iter().filter(|value| !(self.keeps)(value, &self.value)).count();
        Broken {
            broken,
            points: values.len(),
            unknown: block.rows.len() - values.len(),
            drawn: layout.plan.is_random(),
        }
    }
}

impl Broken {
    /// The probability that the limit is broken; NaN without points that are drawn.
    pub fn probability(&self) -> f64 {
        if self.drawn { self.broken as f64 / self.points as f64 } else { f64::NAN }
    }

    /// The ends of its confidence interval of 95 %; NaN without points that are drawn.
    pub fn interval(&self) -> (f64, f64) {
        if !self.drawn || self.points == 0 {
            return (f64::NAN, f64::NAN);
        }
        let (k, n) = (self.broken as f64, self.points as f64);
        let low = if self.broken == 0 { 0.0 } else { inv_beta_reg(k, n - k + 1.0, 0.025) };
        let high = if self.broken == self.points { 1.0 } else { inv_beta_reg(k + 1.0, n - k, 0.975) };
        (low, high)
    }
}

/// The limits at all points of the grid.
///
/// # Errors
/// [`OutputError`].
pub fn table(layout: &Layout, blocks: &[Block<'_>], limits: &[Limit]) -> Result<Table, OutputError> {
    let mut found = vec![];
    for block in blocks {
        found.extend(limits.iter().map(|limit| (block, limit, limit.count(layout, block))));
    }
    let mut table = super::table(layout, &found.iter().map(|(block, ..)| *block).collect::<Vec<_>>())?;
    table.push(
        "limit",
        "",
        Values::Text(found.iter().map(|(_, limit, _)| Cow::Owned(limit.text.clone())).collect()),
    )?;
    let mut push = |name: &str, of: fn(&Broken) -> f64| {
        table.push(name, "1", Values::Number(found.iter().map(|(.., broken)| of(broken)).collect()))
    };
    push("broken", |b| b.broken as f64)?;
    push("points", |b| b.points as f64)?;
    push("unknown", |b| b.unknown as f64)?;
    push("probability", Broken::probability)?;
    push("low_95", |b| b.interval().0)?;
    push("high_95", |b| b.interval().1)?;
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0 of n: the upper end is 1 - 0.025^(1/n); k of n is symmetric to n - k of n. 10 of 100: 0.0490 to 0.1762, from tables.
    #[test]
    fn intervals_are_those_of_clopper_and_pearson() {
        let interval = |broken, points| Broken { broken, points, unknown: 0, drawn: true }.interval();
        let (low, high) = interval(0, 50);
        assert!(low == 0.0 && (high - (1.0 - 0.025_f64.powf(0.02))).abs() < 1e-12, "{high}");
        let ((a, b), (c, d)) = (interval(3, 40), interval(37, 40));
        assert!((a + d - 1.0).abs() < 1e-12 && (b + c - 1.0).abs() < 1e-12);
        let (low, high) = interval(10, 100);
        assert!((low - 0.0490).abs() < 5e-5 && (high - 0.1762).abs() < 5e-5, "{low} {high}");
    }
}
