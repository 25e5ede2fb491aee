//! The content of a plot, for the script that draws it.

use serde::Serialize;

use super::data::Column;
use crate::plot::Note;

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
    pub curves: Vec<PageCurve>,
    /// Plots of the same group have the same limits of x and one cursor.
    pub group: Option<String>,
    /// Values of x at which something happens, marked below the curves.
    pub events: Option<Column>,
    /// Vertical lines with names.
    pub lines: Vec<Line>,
    /// Value of x from which on the plot is shaded, because no digit of the state is left there.
    pub shaded_from: Option<f64>,
    /// Whether the axes have the same scale, as a plane of complex numbers.
    pub square: bool,
}

/// An axis.
#[derive(Debug, Clone, Serialize)]
pub struct Axis {
    /// The quantity.
    pub label: String,
    /// Its unit; empty for a plain number.
    pub unit: String,
    /// The unit that the page shows at first: one of the units into which it can convert `unit`. `None`: the unit that suits the size of
    /// the numbers.
    pub usual: Option<&'static str>,
    /// Whether the axis is logarithmic.
    pub log: bool,
    /// Limits at first; `None`: those of the data.
    pub range: Option<(f64, f64)>,
    /// Names shown at 0, 1, 2, ... instead of numbers; empty: numbers.
    pub names: Vec<String>,
}

impl Axis {
    /// A linear axis with the limits of its data.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Axis { label: label.into(), unit: unit.into(), usual: None, log: false, range: None, names: vec![] }
    }
}

/// A curve.
#[derive(Debug, Clone, Serialize)]
pub struct PageCurve {
    /// Name, as in the files of the result.
    pub name: String,
    /// What it is, in words; may be empty.
    pub doc: String,
    /// Abscissae, not decreasing; on a logarithmic axis their decimal logarithms.
    pub x: Column,
    /// Ordinates; on a logarithmic axis their decimal logarithms.
    pub y: Column,
    /// Whether it is drawn at first.
    pub shown: bool,
    /// Its style; `None`: the default style for its position among the curves.
    pub style: Option<Style>,
    /// The index of the curve with which it is shown and hidden: it has no check box of its own. A curve without a name and without such an
    /// index is always drawn.
    pub with: Option<usize>,
    /// Text at its last point.
    pub note: Option<Note>,
}

impl PageCurve {
    /// A curve with the default style for its position among the curves.
    pub fn new(name: impl Into<String>, doc: impl Into<String>, x: Column, y: Column, shown: bool) -> Self {
        PageCurve { name: name.into(), doc: doc.into(), x, y, shown, style: None, with: None, note: None }
    }
}

/// Colour, dashes, width and markers of a curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Style {
    /// Its colour.
    pub colour: Colour,
    /// Lengths of dashes and gaps in turn, in plotly.js's notation.
    pub dash: String,
    /// Width of the line [pixels]; 0: no line.
    pub width: f64,
    /// plotly.js's name of the symbol at each point.
    pub marker: Option<&'static str>,
}

/// A colour.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Colour {
    /// One of the colours of curves, which differ between light and dark pages.
    Curve(usize),
    /// A CSS colour, the same on all pages.
    Fixed(&'static str),
}

/// A vertical line.
#[derive(Debug, Clone, Serialize)]
pub struct Line {
    /// Its place.
    pub x: f64,
    /// Its name.
    pub name: String,
}

/// A map: values as colours over two axes. Columns have decimal logarithms where their axis is logarithmic.
#[derive(Debug, Clone, Serialize)]
pub struct Map {
    /// What it shows.
    pub title: String,
    /// The x axis.
    pub x: Axis,
    /// The y axis.
    pub y: Axis,
    /// The quantity that the colours show.
    pub colour: Axis,
    /// Whether the values are those of the cells of a grid, or of points.
    pub cells: bool,
    /// The n + 1 edges of the cells along x, or the abscissae of the points.
    pub across: Column,
    /// The m + 1 edges of the cells along y, or the ordinates of the points.
    pub up: Column,
    /// The values, row by row from the lowest y up.
    pub values: Column,
}
