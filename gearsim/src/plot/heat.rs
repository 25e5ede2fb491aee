//! A heat map: a value at every point of a plane, shown as a colour, with a colour bar.
//!
//! Colours: viridis by N. Smith and S. van der Walt (2015, CC0). Its lightness rises evenly, for colour-blind readers too.

use std::fmt::Write;

use super::canvas::{LEFT, SMALL, TEXT, path};
use super::figure::{Axis, Scale, extremes};
use super::picture::{Drawing, Picture, WIDTH};
use super::text::{Anchor, BOLD};
use super::ticks::Ruler;

/// Width and height of the frame [SVG units].
const FRAME: (f64, f64) = (588.0, 430.0);
/// Left edge and width of the colour bar [SVG units].
const BAR: (f64, f64) = (LEFT + FRAME.0 + 22.0, 18.0);
/// Number of distinct colours.
const LEVELS: usize = 192;
/// Colour of points without a value.
const NONE: &str = "#d4d4d4";
/// Half the side of a dot [SVG units].
const DOT: f64 = 3.5;

/// A heat map.
#[derive(Debug, Clone)]
pub struct HeatMap {
    /// Title, above everything.
    pub title: String,
    /// A line below the title.
    pub subtitle: String,
    /// The x axis.
    pub x: Axis,
    /// The y axis.
    pub y: Axis,
    /// The quantity that the colours show.
    pub colour: Axis,
    /// The coloured areas.
    pub marks: Marks,
}

/// The coloured areas.
#[derive(Debug, Clone)]
pub enum Marks {
    /// A grid of cells. `x` (n + 1) and `y` (m + 1) are the edges of the cells in ascending order; `values` (n m) go row by row, from
    /// the lowest y up.
    Cells {
        /// Edges along x.
        x: Vec<f64>,
        /// Edges along y.
        y: Vec<f64>,
        /// The values.
        values: Vec<f64>,
    },
    /// Points and their values (n).
    Dots {
        /// Abscissae.
        x: Vec<f64>,
        /// Ordinates.
        y: Vec<f64>,
        /// The values.
        values: Vec<f64>,
    },
}

impl HeatMap {
    /// The heat map as a picture.
    pub(super) fn picture(&self) -> Picture {
        let top = 28.0 + 19.0 + 16.0;
        let mut body = Drawing::default();
        body.text((LEFT, 28.0), Anchor::Start, 16.0, BOLD, &self.title);
        body.text((LEFT, 47.0), Anchor::Start, SMALL, "fill=\"#555\"", &self.subtitle);

        let (Marks::Cells { x, y, values } | Marks::Dots { x, y, values }) = &self.marks;
        let margin = if matches!(self.marks, Marks::Dots { .. }) { 0.02 } else { 0.0 };
        let positive = |axis: &Axis, v: &f64| axis.scale == Scale::Linear || *v > 0.0;
        let ruler = |axis: &Axis, data: &[f64], count, margin| {
            let shown = data.iter().copied().filter(|v| positive(axis, v));
            Ruler::new(axis, extremes(shown), count, margin)
        };
        let (x_ruler, y_ruler) = (ruler(&self.x, x, 8, margin), ruler(&self.y, y, 12, margin));
        let bar = ruler(&self.colour, values, 10, 0.0);
        let level = |v: f64| {
            let place = bar.place(v).clamp(0.0, 1.0);
            place.is_finite().then(|| (place * (LEVELS - 1) as f64).round() as usize)
        };
        let place = |px: f64, py: f64| (LEFT + x_ruler.place(px) * FRAME.0, top + (1.0 - y_ruler.place(py)) * FRAME.1);

        // One path per colour. The last path is for points without a value.
        let mut paths = vec![String::new(); LEVELS + 1];
        match &self.marks {
            Marks::Cells { x, y, values } => {
                let columns = x.len().saturating_sub(1);
                for (row, values) in values.chunks(columns.max(1)).enumerate() {
                    let mut at = 0;
                    for run in values.chunk_by(|a, b| level(*a) == level(*b)) {
                        let (left, bottom) = place(x[at], y[row]);
                        at += run.len();
                        let (right, top) = place(x[at], y[row + 1]);
                        rectangle(&mut paths[level(run[0]).unwrap_or(LEVELS)], (left, top, right, bottom));
                    }
                }
            }
            Marks::Dots { x, y, values } => {
                for ((x, y), value) in x.iter().zip(y).zip(values) {
                    let (x, y) = place(*x, *y);
                    rectangle(&mut paths[level(*value).unwrap_or(LEVELS)], (x - DOT, y - DOT, x + DOT, y + DOT));
                }
            }
        }
        for (level, d) in paths.iter().enumerate().filter(|(_, d)| !d.is_empty()) {
            let fill = if level == LEVELS { NONE.to_owned() } else { colour(level as f64 / (LEVELS - 1) as f64) };
            let _ = writeln!(body, "<path d=\"{d}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>");
        }
        self.frame(&mut body, &x_ruler, &y_ruler, top);
        self.bar(&mut body, &bar, top, !paths[LEVELS].is_empty());
        body.finish(&self.title, top + FRAME.1 + 52.0)
    }

    /// The frame with its labels and ticks. The ticks are outside the frame, where they cover no cells.
    fn frame(&self, out: &mut Drawing, x: &Ruler, y: &Ruler, top: f64) {
        let (right, bottom) = (LEFT + FRAME.0, top + FRAME.1);
        let mut marks = format!("M{LEFT} {top:.1}H{right}V{bottom:.1}H{LEFT}Z");
        for (at, number) in x.ticks() {
            let px = LEFT + at * FRAME.0;
            let _ = write!(marks, "M{px:.1} {bottom:.1}v6");
            out.text((px, bottom + 20.0), Anchor::Middle, SMALL, "", &number);
        }
        for (at, number) in y.ticks() {
            let py = bottom - at * FRAME.1;
            let _ = write!(marks, "M{LEFT} {py:.1}h-6");
            out.text((LEFT - 10.0, py + 4.3), Anchor::End, SMALL, "", &number);
        }
        for at in minor(x, self.x.scale) {
            let _ = write!(marks, "M{:.1} {bottom:.1}v3", LEFT + at * FRAME.0);
        }
        for at in minor(y, self.y.scale) {
            let _ = write!(marks, "M{LEFT} {:.1}h-3", bottom - at * FRAME.1);
        }
        path(out, &marks, "stroke=\"#222\" stroke-width=\"1\"");
        out.text((LEFT + FRAME.0 / 2.0, bottom + 42.0), Anchor::Middle, TEXT, "", &x.label(&self.x));
        vertical_text(out, 20.0, top + FRAME.1 / 2.0, &y.label(&self.y));
    }

    /// The colour bar; below it, if there are `gaps`, the colour of points without a value.
    fn bar(&self, out: &mut Drawing, ruler: &Ruler, top: f64, gaps: bool) {
        let height = if gaps { FRAME.1 - 34.0 } else { FRAME.1 };
        let (left, right, bottom) = (BAR.0, BAR.0 + BAR.1, top + height);
        let slices = 96;
        for i in 0..slices {
            let (low, high) = (i as f64 / slices as f64, (i + 1) as f64 / slices as f64);
            let mut d = String::new();
            rectangle(&mut d, (left, bottom - high * height, right, bottom - low * height));
            let fill = colour(i as f64 / (slices - 1) as f64);
            let _ = writeln!(out, "<path d=\"{d}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>");
        }
        let mut marks = format!("M{left} {top:.1}H{right}V{bottom:.1}H{left}Z");
        for (at, number) in ruler.ticks() {
            let py = bottom - at * height;
            let _ = write!(marks, "M{right} {py:.1}h5");
            out.text((right + 9.0, py + 4.3), Anchor::Start, SMALL, "", &number);
        }
        if gaps {
            let mut d = String::new();
            rectangle(&mut d, (left, bottom + 16.0, right, bottom + 34.0));
            let _ = writeln!(out, "<path d=\"{d}\" fill=\"{NONE}\" stroke=\"#222\"/>");
            out.text((right + 9.0, bottom + 29.3), Anchor::Start, SMALL, "", "none");
        }
        path(out, &marks, "stroke=\"#222\" stroke-width=\"1\"");
        vertical_text(out, WIDTH - 14.0, top + height / 2.0, &ruler.label(&self.colour));
    }
}

/// Edges of the cells around ascending `centres` (n): n + 1 values, half-way between neighbours on the axis as drawn.
pub(super) fn edges(centres: &[f64], scale: Scale) -> Vec<f64> {
    let logarithmic = scale == Scale::Log10;
    let c: Vec<f64> = centres.iter().map(|&x| if logarithmic { x.ln() } else { x }).collect();
    let n = c.len();
    let half = |i: usize| if n > 1 { (c[i + 1] - c[i]) / 2.0 } else { 0.5 };
    let Some((first, last)) = c.first().zip(c.last()) else { return vec![] };
    let inner = c.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0);
    let all = [first - half(0)].into_iter().chain(inner).chain([last + half(n.saturating_sub(2))]);
    all.map(|x| if logarithmic { x.exp() } else { x }).collect()
}

/// Positions of the minor ticks: on a logarithmic axis at 2 to 9 in every decade.
fn minor(ruler: &Ruler, scale: Scale) -> Vec<f64> {
    match scale {
        Scale::Linear => ruler.minor(),
        Scale::Log10 => {
            let decade = ruler.decade();
            let tenth = |at: f64| (2..10).map(move |i| at + decade * f64::from(i).log10());
            let decades = ruler.minor();
            let below = decades.first().map(|at| at - decade);
            let all = below.into_iter().chain(decades).flat_map(tenth);
            all.filter(|at| (0.0..=1.0).contains(at)).collect()
        }
    }
}

fn rectangle(d: &mut String, (left, top, right, bottom): (f64, f64, f64, f64)) {
    if [left, top, right, bottom].iter().all(|x| x.is_finite()) {
        let _ = write!(d, "M{left:.1} {top:.1}H{right:.1}V{bottom:.1}H{left:.1}Z");
    }
}

fn vertical_text(out: &mut Drawing, x: f64, y: f64, words: &str) {
    out.text((x, y), Anchor::Middle, TEXT, &format!("transform=\"rotate(-90 {x} {y:.1})\""), words);
}

/// The colour at `place`, 0 to 1 from low to high values.
fn colour(place: f64) -> String {
    const VIRIDIS: [[f64; 3]; 9] = [
        [68.0, 1.0, 84.0],
        [71.0, 45.0, 123.0],
        [59.0, 82.0, 139.0],
        [44.0, 114.0, 142.0],
        [33.0, 144.0, 140.0],
        [39.0, 173.0, 129.0],
        [93.0, 200.0, 99.0],
        [170.0, 220.0, 50.0],
        [253.0, 231.0, 37.0],
    ];
    let x = place.clamp(0.0, 1.0) * 8.0;
    let i = (x as usize).min(7);
    let mix = |c: usize| (VIRIDIS[i][c] + (VIRIDIS[i + 1][c] - VIRIDIS[i][c]) * (x - i as f64)).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[test]
fn cell_edges_lie_half_way_between_centres() {
    assert_eq!(edges(&[1.0, 2.0, 4.0], Scale::Linear), [0.5, 1.5, 3.0, 5.0]);
    let logarithmic = edges(&[1.0, 100.0], Scale::Log10);
    // The tolerance allows for the rounding of a logarithm and its inverse.
    for (x, expected) in logarithmic.iter().zip([0.1, 10.0, 1000.0]) {
        assert!((x / expected - 1.0).abs() < 1e-14, "{logarithmic:?}");
    }
    assert_eq!(edges(&[3.0], Scale::Linear), [2.5, 3.5]);
    assert!(edges(&[], Scale::Linear).is_empty());
}
