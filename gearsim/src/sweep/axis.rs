//! A varied quantity: a key of the scene and its values, `parameters.T0=1:100:50`.
//!
//! | values | are |
//! | --- | --- |
//! | `a:b:n` | n from a to b, evenly, both included |
//! | `log:a:b:n` | n from a to b in equal ratios |
//! | `v1,v2,v3` | these, in this order |
//! | `uniform:a:b` | random between a and b |
//! | `log-uniform:a:b` | random, with an evenly distributed logarithm |
//!
//! Values between the ends are rounded to 15 digits, as one would type them, in the unit of the ends: any point of a
//! sweep can be run on its own with `--set`, to the same last bit.

use crate::scene::quantity::{self, Quantity};

use super::random;

/// A varied quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Key in the scene, e.g. `parameters.T0`.
    pub key: String,
    /// Unit of its values as they are written, e.g. `rpm`; empty for plain numbers, and for a list.
    pub unit: String,
    /// Its values.
    pub values: Values,
}

/// The values of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// These, as they would stand in a scene.
    List(Vec<String>),
    /// From `low` to `high` [unit of the axis].
    Range {
        /// First value.
        low: f64,
        /// Last value.
        high: f64,
        /// How those between are spaced.
        spacing: Spacing,
        /// How many; `None`: random ones, as many as there are points.
        count: Option<usize>,
    },
}

/// How values lie between two ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// In equal steps.
    Linear,
    /// In equal ratios.
    Logarithmic,
}

impl Axis {
    /// Number of values; `None` if they are random.
    pub fn count(&self) -> Option<usize> {
        match &self.values {
            Values::List(values) => Some(values.len()),
            Values::Range { count, .. } => *count,
        }
    }

    /// Value `i` of a list or a range, or that of the random number `i` of `seed`, as it would stand in a scene.
    pub fn value(&self, i: usize, seed: u64) -> String {
        match self.values {
            Values::List(ref values) => values[i].clone(),
            Values::Range { low, high, spacing, count: Some(n) } => {
                let part = i as f64 / (n - 1) as f64;
                self.written(spacing.between(low, high, part))
            }
            Values::Range { low, high, spacing, count: None } => {
                self.written(spacing.between(low, high, random::fraction(seed, i as u64)))
            }
        }
    }

    /// The values that stand for all when they are checked: all of a list, and both ends of a range, since what a
    /// scene admits of a number is an interval.
    pub fn samples(&self) -> Vec<String> {
        match self.values {
            Values::List(ref values) => values.clone(),
            Values::Range { low, high, .. } => vec![self.written(low), self.written(high)],
        }
    }

    /// Whether all values are quantities; else they are words.
    pub fn is_numeric(&self) -> bool {
        match &self.values {
            Values::List(values) => values.iter().all(|value| Quantity::parse(value).is_ok()),
            Values::Range { .. } => true,
        }
    }

    /// Whether its values are spaced in equal ratios.
    pub fn is_logarithmic(&self) -> bool {
        matches!(self.values, Values::Range { spacing: Spacing::Logarithmic, .. })
    }

    fn written(&self, x: f64) -> String {
        let text = format!("{x:?}");
        let text = text.strip_suffix(".0").unwrap_or(&text);
        if self.unit.is_empty() { text.to_owned() } else { format!("{text} {}", self.unit) }
    }
}

impl Spacing {
    /// What lies at a `part` between 0 and 1 of the way.
    fn between(self, low: f64, high: f64, part: f64) -> f64 {
        let x = match (self, part) {
            (_, 0.0) => return low,
            (_, 1.0) => return high,
            (Spacing::Linear, part) => low + (high - low) * part,
            (Spacing::Logarithmic, part) => (low.ln() + (high.ln() - low.ln()) * part).exp(),
        };
        // Formatting cannot give what does not parse.
        format!("{x:.14e}").parse().unwrap_or(x)
    }
}

/// The number in `value` as it is written: `300` of `300 rpm`; NaN if there is none.
pub fn number(value: &str) -> f64 {
    quantity::split(value).map_or(f64::NAN, |(number, _)| number)
}

/// `value` in SI; NaN if it is no quantity.
pub fn si(value: &str) -> f64 {
    Quantity::parse(value).map_or(f64::NAN, |quantity| quantity.value)
}
