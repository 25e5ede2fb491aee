//! The measures of an output at a point of a response. To add a measure, add one file here and one line in [`MEASURES`].

mod dynamic_factor;
mod statistics;

use super::ResponsePoint;
use crate::model::{Model, Output};

/// A measure of outputs.
#[derive(Clone, Copy)]
pub struct Measure {
    /// Name on the command line, and the end of the names of its columns.
    pub name: &'static str,
    /// Its SI unit; `None`: that of the output.
    pub unit: Option<&'static str>,
    /// The measure that is drawn beside it, with its words in legends.
    pub beside: Option<(&'static str, &'static str)>,
    /// Whether an output of a model has it.
    pub is_of: fn(&Model, &Output) -> bool,
    /// Its value for an output, by its index; NaN where there is none.
    pub value: fn(&ResponsePoint, usize) -> f64,
    /// Why it has no value for an output.
    pub lacks: fn(&ResponsePoint, usize) -> Option<&str>,
}

/// All measures, in the order of their columns.
pub const MEASURES: [Measure; 7] = [
    statistics::MEAN,
    statistics::RMS,
    statistics::PEAK_TO_PEAK,
    dynamic_factor::FACTOR,
    dynamic_factor::ISO_6336,
    dynamic_factor::PULLING_SHARE,
    dynamic_factor::LARGEST_PULL,
];

/// The measure with a name.
pub fn measure(name: &str) -> Option<Measure> {
    MEASURES.into_iter().find(|measure| measure.name == name)
}

impl Measure {
    /// Its unit for an output.
    pub fn unit(&self, output: &'static Output) -> &'static str {
        self.unit.unwrap_or(output.unit)
    }
}
