//! What a plot shows, for the script that draws it.

use serde::Serialize;

use super::data::Column;

/// A plot: curves over one axis. The reader chooses among the curves.
#[derive(Debug, Clone, Serialize)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// The x axis.
    pub x: Axis,
    /// The y axis.
    pub y: Axis,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Plots of the same group have the same limits of x and one cursor.
    pub group: Option<&'static str>,
    /// Values of x at which something happens, marked below the curves.
    pub events: Option<Column>,
    /// Vertical lines with names.
    pub lines: Vec<Line>,
    /// Value of x from which on the plot is shaded, because no digit of the state is left there.
    pub shaded_from: Option<f64>,
}

/// An axis.
#[derive(Debug, Clone, Serialize)]
pub struct Axis {
    /// The quantity.
    pub label: String,
    /// Its unit; empty for a plain number.
    pub unit: String,
    /// Whether the axis is logarithmic.
    pub log: bool,
    /// Limits at first; `None`: those of the data.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// A linear axis with the limits of its data.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Axis { label: label.into(), unit: unit.into(), log: false, range: None }
    }
}

/// A curve.
#[derive(Debug, Clone, Serialize)]
pub struct Curve {
    /// Name, as in the files of the result.
    pub name: String,
    /// What it is, in words; may be empty.
    pub doc: String,
    /// Abscissae, not decreasing.
    pub x: Column,
    /// Ordinates.
    pub y: Column,
    /// Whether it is drawn at first.
    pub shown: bool,
}

/// A vertical line.
#[derive(Debug, Clone, Serialize)]
pub struct Line {
    /// Its place.
    pub x: f64,
    /// Its name.
    pub name: String,
}
