//! Layout of a figure: titles, then for each panel a row of legend, the frame and the curves.
//!
//! Legends stand above the frames, where they cover no data. Lengths are in SVG units (1/96 inch).

use std::fmt::Write;

use super::decimate::decimate;
use super::figure::{Figure, Marker, Panel, Scale, Series, extremes};
use super::notes;
use super::picture::{Drawing, Picture, WIDTH};
use super::text::{Anchor, BOLD, ems};
use super::ticks::Ruler;

pub(super) const LEFT: f64 = 84.0;
const RIGHT: f64 = 22.0;
const FRAME: f64 = WIDTH - LEFT - RIGHT;
/// Height of the frame: of a single panel, of each of two, of each of more.
const HEIGHTS: [f64; 3] = [400.0, 250.0, 190.0];
const LEGEND_ROW: f64 = 19.0;
const GAP: f64 = 14.0;
pub(super) const TEXT: f64 = 13.0;
pub(super) const SMALL: f64 = 12.0;
const SAMPLE: f64 = 34.0;
/// Height of a row of names below an axis, and most of such rows.
const NAME_ROW: f64 = 15.0;
const NAME_ROWS: usize = 6;

/// The figure as a picture.
pub(super) fn draw(figure: &Figure) -> Picture {
    let height = HEIGHTS[figure.panels.len().clamp(1, HEIGHTS.len()) - 1];
    let mut y = 28.0;
    let mut body = Drawing::default();
    body.text((LEFT, y), Anchor::Start, 16.0, BOLD, &figure.title);
    if let Some(subtitle) = &figure.subtitle {
        y += 19.0;
        body.text((LEFT, y), Anchor::Start, SMALL, "fill=\"#555\"", subtitle);
    }
    y += 10.0;

    let x = figure.panels.iter().flat_map(|p| &p.series).flat_map(|s| s.x.iter().copied());
    let x = Ruler::new(&figure.x, extremes(x), 10, 0.0);
    for (i, panel) in figure.panels.iter().enumerate() {
        let last = i + 1 == figure.panels.len();
        y = legend(&mut body, panel, y);
        frame(&mut body, panel, (&x, figure.x.shaded_from), last, y, height);
        y += height + GAP;
    }
    y += 14.0 + NAME_ROW * (name_rows(&x) - 1) as f64;
    body.text((LEFT + FRAME / 2.0, y + 10.0), Anchor::Middle, TEXT, "", &x.label(&figure.x));
    body.finish(&figure.title, y + 24.0)
}

/// Number of rows for the names below an axis, so that neighbours do not cover each other.
fn name_rows(x: &Ruler) -> usize {
    let ticks = if x.is_named() { x.ticks() } else { vec![] };
    let widest = ticks.iter().map(|(_, name)| SMALL * ems(name) + 8.0).fold(0.0, f64::max);
    let apart = ticks.windows(2).map(|pair| FRAME * (pair[1].0 - pair[0].0)).fold(f64::INFINITY, f64::min);
    ((widest / apart).ceil() as usize).clamp(1, NAME_ROWS)
}

/// Names the curves above a frame, in as many rows as they need; returns where the frame begins.
fn legend(out: &mut Drawing, panel: &Panel, top: f64) -> f64 {
    let named: Vec<_> = panel.series.iter().filter(|s| !s.label.is_empty()).collect();
    if named.is_empty() {
        return top + 4.0;
    }
    let (mut x, mut y) = (LEFT, top + 9.0);
    for series in named {
        let width = SAMPLE + 8.0 + SMALL * ems(&series.label) + 24.0;
        if x > LEFT && x + width > LEFT + FRAME {
            (x, y) = (LEFT, y + LEGEND_ROW);
        }
        polyline(out, &[(x, y), (x + SAMPLE, y)], series);
        marker(out, (x + 0.5 * SAMPLE, y), series);
        out.text((x + SAMPLE + 8.0, y + 4.3), Anchor::Start, SMALL, "", &series.label);
        x += width;
    }
    y + 12.0
}

/// Draws the frame of a panel, with numbers at the x axis below the last one, its axes and its curves.
fn frame(out: &mut Drawing, panel: &Panel, (x, shaded): (&Ruler, Option<f64>), last: bool, top: f64, height: f64) {
    // Only what lies within the x axis may stretch the y axis.
    let visible = |s: &Series, i: usize| (-1e-9..=1.0 + 1e-9).contains(&x.place(s.x[i]));
    let logarithmic = panel.y.scale == Scale::Log10;
    let values = panel
        .series
        .iter()
        .flat_map(|s| (0..s.y.len()).filter(|&i| visible(s, i)).map(|i| s.y[i]).filter(|&v| !logarithmic || v > 0.0));
    let y = Ruler::new(&panel.y, extremes(values), (height / 32.0) as usize, 0.05);
    let (bottom, right) = (top + height, LEFT + FRAME);

    let mut grid = String::new();
    let mut marks = String::new();
    let rows = name_rows(x);
    for (i, (at, number)) in x.ticks().into_iter().enumerate() {
        let px = LEFT + at * FRAME;
        let _ = write!(grid, "M{px:.1} {top:.1}V{bottom:.1}");
        let _ = write!(marks, "M{px:.1} {bottom:.1}v-6M{px:.1} {top:.1}v6");
        if last {
            out.text((px, bottom + 17.0 + NAME_ROW * (i % rows) as f64), Anchor::Middle, SMALL, "", &number);
        }
    }
    for (at, number) in y.ticks() {
        let py = bottom - at * height;
        let _ = write!(grid, "M{LEFT} {py:.1}H{right}");
        let _ = write!(marks, "M{LEFT} {py:.1}h6M{right} {py:.1}h-6");
        out.text((LEFT - 7.0, py + 4.3), Anchor::End, SMALL, "", &number);
    }
    for at in x.minor() {
        let px = LEFT + at * FRAME;
        let _ = write!(marks, "M{px:.1} {bottom:.1}v-3M{px:.1} {top:.1}v3");
    }
    for at in y.minor() {
        let py = bottom - at * height;
        let _ = write!(marks, "M{LEFT} {py:.1}h3M{right} {py:.1}h-3");
    }
    let mut shade = None;
    if let Some(from) = shaded.map(|from| x.place(from).max(0.0)).filter(|from| *from < 1.0) {
        let (left, width) = (LEFT + from * FRAME, (1.0 - from) * FRAME);
        let _ = writeln!(
            out,
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height}\" fill=\"#f3ecdf\"/>"
        );
        shade = Some(width);
    }
    path(out, &grid, "stroke=\"#e4e4e4\" stroke-width=\"0.8\"");

    // A nested `svg` element clips its content without an identifier. Identifiers could clash if several figures are on one page.
    let _ = writeln!(
        out,
        "<svg x=\"{LEFT}\" y=\"{top:.1}\" width=\"{FRAME}\" height=\"{height}\" \
         viewBox=\"{LEFT} {top:.1} {FRAME} {height}\">"
    );
    let mut ends = vec![];
    for series in &panel.series {
        let points = series
            .x
            .iter()
            .zip(&series.y)
            .map(|(&vx, &vy)| (LEFT + x.place(vx) * FRAME, bottom - y.place(vy) * height));
        let points: Vec<_> = points.collect();
        curve(out, &points, series);
        let inside = |p: &&(f64, f64)| (LEFT..=right).contains(&p.0) && (top..=bottom).contains(&p.1);
        if let Some(&end) = points.iter().rfind(inside).filter(|_| !series.note.text.is_empty()) {
            ends.push((end, series));
        }
    }
    let _ = writeln!(out, "</svg>");
    notes::draw(out, &ends, LEFT, right, (top, bottom));
    if let Some(width) = shade {
        shaded_note(out, width, (right, top));
    }

    path(out, &marks, "stroke=\"#222\" stroke-width=\"0.8\"");
    let outline = format!("M{LEFT} {top:.1}H{right}V{bottom:.1}H{LEFT}Z");
    path(out, &outline, "stroke=\"#222\" stroke-width=\"1\"");
    name(out, &y.label(&panel.y), top + height / 2.0, height);
}

/// Writes the name of a y axis along it, about the height `cy`. A name that is longer than the axis has its unit in a second line.
fn name(out: &mut Drawing, text: &str, cy: f64, height: f64) {
    let (first, unit) = match text.rsplit_once(" [") {
        Some((first, unit)) if TEXT * ems(text) > height => (first.to_owned(), format!("[{unit}")),
        _ => (text.to_owned(), String::new()),
    };
    let size = (10.0 * TEXT.min(height / ems(&first))).floor() / 10.0;
    let lines = if unit.is_empty() { vec![(20.0, first)] } else { vec![(12.0, first), (12.0 + TEXT + 2.0, unit)] };
    for (cx, line) in lines {
        let turn = format!("transform=\"rotate(-90 {cx} {cy:.1})\"");
        out.text((cx, cy), Anchor::Middle, size, &turn, &line);
    }
}

/// Says what the shade of a panel means, over the curves that cross the text. `width` is that of the shade, which ends at `right`.
fn shaded_note(out: &mut Drawing, width: f64, (right, top): (f64, f64)) {
    let says = "no digits of the state are left";
    let long = SMALL * ems(says);
    if long + 12.0 < width {
        let ground = format!(
            "M{:.1} {:.1}h{:.1}v{}h-{:.1}Z",
            right - long - 10.0,
            top + 3.0,
            long + 8.0,
            SMALL + 4.0,
            long + 8.0
        );
        path(out, &ground, "style=\"fill:#f3ecdf\" opacity=\"0.85\"");
        out.text((right - 6.0, top + 15.0), Anchor::End, SMALL, "fill=\"#7a5c2e\"", says);
    }
}

/// Draws a curve given in pixels: without what is outside the frame, in one piece between gaps.
fn curve(out: &mut Drawing, points: &[(f64, f64)], series: &Series) {
    let inside = |p: &(f64, f64)| (LEFT - 1.0..=LEFT + FRAME + 1.0).contains(&p.0);
    let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    for piece in points.split(|p| !finite(p)) {
        // One point more on either side, so that the line goes on to the edge.
        let (Some(first), Some(last)) = (piece.iter().position(inside), piece.iter().rposition(inside)) else {
            continue;
        };
        let piece = &piece[first.saturating_sub(1)..piece.len().min(last + 2)];
        polyline(out, &decimate(piece), series);
    }
    let seen = |p: &&(f64, f64)| finite(p) && inside(p);
    points.iter().filter(seen).for_each(|p| marker(out, *p, series));
}

/// Draws the marker of a point.
fn marker(out: &mut Drawing, (x, y): (f64, f64), series: &Series) {
    let colour = series.style.colour;
    let fill = format!("fill=\"{colour}\"");
    let shape = match series.style.marker {
        Marker::None => return,
        Marker::Dot => format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.4\" {fill}/>"),
        Marker::Square => {
            format!("<rect x=\"{:.1}\" y=\"{:.1}\" width=\"6\" height=\"6\" {fill}/>", x - 3.0, y - 3.0)
        }
        Marker::Diamond => format!("<path d=\"M{x:.1} {:.1}l4.2 4.2l-4.2 4.2l-4.2 -4.2z\" {fill}/>", y - 4.2),
        Marker::Triangle => format!("<path d=\"M{x:.1} {:.1}l4 7h-8z\" {fill}/>", y - 4.2),
        Marker::Cross => {
            let d = format!("M{:.1} {:.1}l7 7M{:.1} {:.1}l7 -7", x - 3.5, y - 3.5, x - 3.5, y + 3.5);
            format!("<path d=\"{d}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.8\"/>")
        }
    };
    let _ = writeln!(out, "{shape}");
}

fn polyline(out: &mut Drawing, points: &[(f64, f64)], series: &Series) {
    let style = series.style;
    if style.width == 0.0 {
        return;
    }
    let mut line = String::with_capacity(14 * points.len());
    for (x, y) in points {
        // Far outside the frame rasterisers lose their accuracy.
        let (x, y) = (x.clamp(-1e4, 1e4), y.clamp(-1e4, 1e4));
        let _ = write!(line, "{x:.2},{y:.2} ");
    }
    let dashes = match style.dashes {
        [] => String::new(),
        lengths => {
            let lengths: Vec<_> = lengths.iter().map(f64::to_string).collect();
            format!(" stroke-dasharray=\"{}\"", lengths.join(" "))
        }
    };
    let _ = writeln!(
        out,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashes}/>",
        line.trim_end(),
        style.colour,
        style.width
    );
}

pub(super) fn path(out: &mut Drawing, d: &str, style: &str) {
    let _ = writeln!(out, "<path d=\"{d}\" fill=\"none\" {style}/>");
}
