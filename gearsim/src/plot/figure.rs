//! A figure: stacked panels of curves over a common x axis, as SVG or PNG.
//!
//! Plots use only the types of this file. `canvas` lays out a figure; only `picture` uses the rasteriser.

use super::picture::Picture;
use super::{PlotError, canvas};

/// A curve has markers if it has at most this many points. Markers of more points would touch each other.
pub(super) const MARKED: usize = 250;

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title, above everything.
    pub title: String,
    /// A line below the title.
    pub subtitle: Option<String>,
    /// The x axis, common to all panels.
    pub x: Axis,
    /// The panels, from top to bottom.
    pub panels: Vec<Panel>,
}

/// One frame with its curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The y axis.
    pub y: Axis,
    /// The curves; later ones are drawn over earlier ones.
    pub series: Vec<Series>,
}

impl Panel {
    /// Removes the legend of this panel; for panels whose curves are named in another panel.
    pub fn unnamed(&mut self) {
        self.series.iter_mut().for_each(|series| series.label.clear());
    }
}

/// Names each `common` curve only in the legend of the first of `panels` that has a curve of this name.
pub(super) fn name_once(panels: &mut [Panel], common: impl Fn(&Series) -> bool) {
    let mut named: Vec<String> = vec![];
    for panel in panels {
        let known = named.len();
        for series in panel.series.iter_mut().filter(|series| common(series)) {
            if named[..known].contains(&series.label) {
                series.label.clear();
            } else {
                named.push(series.label.clone());
            }
        }
    }
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The quantity, e.g. `energy U`.
    pub label: String,
    /// The unit, e.g. `J`; empty for a plain number. A power of ten is put before it where this shortens the tick numbers.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Limits of the axis in data units; `None`: the limits of the data.
    pub range: Option<(f64, f64)>,
    /// Names shown at 0, 1, 2, ... instead of numbers; empty: numbers.
    pub names: Vec<String>,
    /// For an x axis: the value from which on panels are shaded, because no digits of the state are left there.
    pub shaded_from: Option<f64>,
}

impl Axis {
    /// A linear axis with the limits of its data.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Axis {
            label: label.into(),
            unit: unit.into(),
            scale: Scale::Linear,
            range: None,
            names: vec![],
            shaded_from: None,
        }
    }

    /// A logarithmic axis with the limits of its data. Values that are not positive leave gaps.
    pub fn log10(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Axis { scale: Scale::Log10, ..Axis::linear(label, unit) }
    }

    /// The same axis with names at 0, 1, 2, ... instead of numbers.
    pub fn named(self, names: Vec<String>) -> Self {
        Axis { names, ..self }
    }

    /// The same axis, with panels shaded from the value `shaded_from` on.
    pub fn shaded(self, shaded_from: Option<f64>) -> Self {
        Axis { shaded_from, ..self }
    }

    /// The same axis between `low` and `high`.
    pub fn between(self, low: f64, high: f64) -> Self {
        Axis { range: Some((low, high)), ..self }
    }
}

/// How values are mapped to positions on an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// In proportion to the value.
    Linear,
    /// In proportion to its decimal logarithm.
    Log10,
}

/// A curve. It has a gap where x or y is not finite. Two points in a row with equal x are a jump, drawn as a vertical line.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend; empty: not in the legend.
    pub label: String,
    /// Abscissae, not decreasing (n).
    pub x: Vec<f64>,
    /// Ordinates (n).
    pub y: Vec<f64>,
    /// How it looks.
    pub style: Style,
    /// Text at its last point within the frame.
    pub note: Note,
}

impl Series {
    /// A curve in the style [`Style::nth`] of `index`.
    pub fn new(index: usize, label: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Series { label: label.into(), x, y, style: Style::nth(index), note: Note::default() }
    }
}

/// A text at the last point of a curve.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
pub struct Note {
    /// The text; empty: none.
    pub text: String,
    /// Where it stands.
    pub place: NotePlace,
}

/// Where a note stands, relative to the last point of its curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NotePlace {
    /// Above it, to its left.
    #[default]
    Before,
    /// To its right. Notes that would cover each other are moved up or down.
    After,
    /// Above it. Notes that would cover each other are moved to the sides.
    Above,
}

/// The symbol drawn at each point of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Marker {
    None,
    Dot,
    Square,
    Diamond,
    Triangle,
    Cross,
}

impl Marker {
    /// The `index`-th of four different markers, repeated after the fourth.
    pub fn nth(index: usize) -> Self {
        [Marker::Dot, Marker::Square, Marker::Diamond, Marker::Triangle][index % 4]
    }
}

/// Colour, dashes and width of a line, and the markers at its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// CSS colour.
    pub colour: &'static str,
    /// Lengths of dashes and gaps in turn [SVG units]; empty: a solid line.
    pub dashes: &'static [f64],
    /// Line width [SVG units]; 0: no line.
    pub width: f64,
    /// The symbol at each point.
    pub marker: Marker,
}

impl Style {
    /// A thin solid black line, for a curve on its own.
    pub const PLAIN: Style = Style { colour: "#000000", dashes: &[], width: 1.3, marker: Marker::None };

    /// The `index`-th of a series of line styles that differ in colour and in dashes. Colour-blind readers can distinguish the colours.
    ///
    /// Colours: M. Okabe, K. Ito, "Color universal design" (2008), the dark ones, with a brown and a dark blue added.
    pub fn nth(index: usize) -> Self {
        const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#000000", "#009e73", "#cc79a7", "#57330f", "#200080"];
        const DASHES: [&[f64]; 5] = [&[], &[7.0, 3.0], &[1.8, 4.0], &[8.0, 2.5, 1.8, 2.5], &[12.0, 4.0]];
        Style {
            colour: COLOURS[index % COLOURS.len()],
            dashes: DASHES[index % DASHES.len()],
            // The first line is wider, so that it is visible where another covers it.
            width: if index == 0 { 1.7 } else { 1.3 },
            marker: Marker::None,
        }
    }
}

impl Figure {
    /// The figure as a picture. Errors: [`PlotError::Ragged`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        for series in self.panels.iter().flat_map(|p| &p.series) {
            let (x, y) = (series.x.len(), series.y.len());
            if x != y {
                return Err(PlotError::Ragged { series: series.label.clone(), x, y });
            }
        }
        Ok(canvas::draw(self))
    }

    /// The figure as SVG, self-contained but for the font. Errors: [`PlotError::Ragged`].
    pub fn svg(&self) -> Result<String, PlotError> {
        Ok(self.picture()?.svg().to_owned())
    }

    /// The figure as PNG at twice the resolution of the SVG. Errors: [`PlotError::Ragged`], [`PlotError::Render`].
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        self.picture()?.png()
    }
}

/// The largest absolute value of curves; below zero if there is none.
pub(super) fn largest(series: &[Series]) -> f64 {
    let (low, high) = extremes(series.iter().flat_map(|s| s.y.iter().copied()));
    high.max(-low)
}

/// Smallest and largest finite value; `(inf, -inf)` if there is none.
pub(super) fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}
