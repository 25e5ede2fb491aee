//! A varied quantity: a key of the scene and its values, `parameters.T0=1:100:50`.
//!
//! | text | values |
//! | --- | --- |
//! | `a:b:n` | n values from a to b in equal steps, both included |
//! | `log:a:b:n` | n values from a to b in equal ratios, both included |
//! | `v1,v2,v3` | these values, in this order |
//! | `uniform:a:b` | random values, uniformly distributed between a and b |
//! | `log-uniform:a:b` | random values whose logarithm is uniformly distributed |
//! | `normal:m:s` | random values, normally distributed with mean m and standard deviation s |
//! | `normal:m:s:a:b` | the same, between a and b only |
//!
//! Values between the ends are rounded to 15 decimal digits, in the unit of the ends. They can therefore be typed exactly: `gearsim run`
//! with `--set` runs the same scene as the point of a sweep. If a sweep records end states only, its results differ by rounding errors.

use crate::scene::quantity::{self, Quantity};

use super::distribution::Distribution;

/// A varied quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Key in the scene, e.g. `parameters.T0`.
    pub key: String,
    /// Unit in which its values are written, e.g. `rpm`; empty for plain numbers and for a list.
    pub unit: String,
    /// Its values.
    pub values: Values,
}

/// The values of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// A list of values, each as in a scene file.
    List(Vec<String>),
    /// Values from `low` to `high` [unit of the axis].
    Range {
        /// First value.
        low: f64,
        /// Last value.
        high: f64,
        /// How the values between them are spaced.
        spacing: Spacing,
        /// Number of values, at least 2.
        count: usize,
    },
    /// Random values, one for each point.
    Random(Distribution),
}

/// How values are spaced between two ends.
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
            Values::Range { count, .. } => Some(*count),
            Values::Random(_) => None,
        }
    }

    /// Value `i` of a list or a range, or the first trial of a random axis, written as in a scene file.
    pub fn value(&self, i: usize) -> String {
        match &self.values {
            Values::List(values) => values[i].clone(),
            Values::Range { low, high, spacing, count } => {
                self.written(spacing.between(*low, *high, i as f64 / (count - 1) as f64))
            }
            Values::Random(distribution) => self.written(distribution.trials()[0]),
        }
    }

    /// The value of a random axis for a random number in [0, 1), or the first value of another axis, written as in a scene file.
    pub fn drawn(&self, fraction: f64) -> String {
        match &self.values {
            Values::Random(distribution) => self.written(distribution.quantile(fraction)),
            _ => self.value(0),
        }
    }

    /// The values to check instead of all: every value of a list, and the ends of a range or of a distribution. The ends are enough,
    /// because the valid values of a number form an interval.
    pub fn trials(&self) -> Vec<String> {
        match &self.values {
            Values::List(values) => values.clone(),
            Values::Range { low, high, .. } => vec![self.written(*low), self.written(*high)],
            Values::Random(distribution) => distribution.trials().into_iter().map(|x| self.written(x)).collect(),
        }
    }

    /// Whether all values are quantities; else they are texts.
    pub fn is_numeric(&self) -> bool {
        match &self.values {
            Values::List(values) => values.iter().all(|value| Quantity::parse(value).is_ok()),
            Values::Range { .. } | Values::Random(_) => true,
        }
    }

    /// Whether its values are spaced in equal ratios.
    pub fn is_logarithmic(&self) -> bool {
        let (Values::Range { spacing, .. } | Values::Random(Distribution::Uniform { spacing, .. })) = self.values
        else {
            return false;
        };
        spacing == Spacing::Logarithmic
    }

    /// `x` with the unit of the axis, as in a scene file.
    fn written(&self, x: f64) -> String {
        let text = format!("{x:?}");
        let text = text.strip_suffix(".0").unwrap_or(&text);
        if self.unit.is_empty() { text.to_owned() } else { format!("{text} {}", self.unit) }
    }
}

impl Spacing {
    /// The value at `fraction`, 0 to 1, of the way from `low` to `high`.
    pub(super) fn between(self, low: f64, high: f64, fraction: f64) -> f64 {
        Spacing::rounded(match (self, fraction) {
            (_, 0.0) => return low,
            (_, 1.0) => return high,
            (Spacing::Linear, fraction) => low + (high - low) * fraction,
            (Spacing::Logarithmic, fraction) => (low.ln() + (high.ln() - low.ln()) * fraction).exp(),
        })
    }

    /// `x` rounded to 15 decimal digits.
    pub(super) fn rounded(x: f64) -> f64 {
        // Parsing a formatted number cannot fail.
        format!("{x:.14e}").parse().unwrap_or(x)
    }
}

/// The number in `value` without its unit: 300 of `300 rpm`; NaN if `value` is not a quantity.
pub fn number(value: &str) -> f64 {
    quantity::split(value).map_or(f64::NAN, |(number, _)| number)
}

/// `value` in SI units; NaN if it is not a quantity.
pub fn si(value: &str) -> f64 {
    Quantity::parse(value).map_or(f64::NAN, |quantity| quantity.value)
}
