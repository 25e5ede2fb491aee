//! Text of a picture: as SVG text, and as the outlines of its glyphs in DejaVu Sans.

use std::fmt::Write;
use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Attribute of bold text.
pub(super) const BOLD: &str = "font-weight=\"bold\"";
/// Size of a subscript, and its distance below the line [SVG units].
const INDEX: (f64, f64) = (10.0, 3.0);

/// Which point of a text is at the given place.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// `words` as an SVG text.
pub(super) fn element(at: (f64, f64), anchor: Anchor, size: f64, attributes: &str, words: &str) -> String {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    format!(
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" {attributes}>{}</text>\n",
        at.0,
        at.1,
        markup(words)
    )
}

/// `words` as an SVG path, at the place where [`element`] puts them.
pub(super) fn outlines(at: (f64, f64), anchor: Anchor, size: f64, attributes: &str, words: &str) -> String {
    static REGULAR: LazyLock<Face<'_>> = LazyLock::new(|| parse(dejavu::sans::regular()));
    static BOLD_FACE: LazyLock<Face<'_>> = LazyLock::new(|| parse(dejavu::sans::bold()));
    let face: &Face<'_> = if attributes == BOLD { &BOLD_FACE } else { &REGULAR };

    // From the left end of the text, in SVG units.
    let mut width = 0.0;
    let mut glyphs: Vec<(GlyphId, f64, f64, f64)> = vec![];
    for (run, is_index) in runs(words) {
        let (size, below) = if is_index { INDEX } else { (size, 0.0) };
        let scale = size / f64::from(face.units_per_em());
        let mut before = None;
        for c in run.chars() {
            let glyph = face.glyph_index(c).unwrap_or_default();
            width += scale * before.map_or(0.0, |before| kerning(face, before, glyph));
            glyphs.push((glyph, width, below, scale));
            width += scale * f64::from(face.glyph_hor_advance(glyph).unwrap_or_default());
            before = Some(glyph);
        }
    }
    let left = match anchor {
        Anchor::Start => at.0,
        Anchor::Middle => at.0 - width / 2.0,
        Anchor::End => at.0 - width,
    };
    let mut d = String::new();
    for (glyph, x, below, scale) in glyphs {
        face.outline_glyph(glyph, &mut Pen { d: &mut d, origin: (left + x, at.1 + below), scale });
    }
    format!("<path d=\"{d}\" {attributes}/>\n")
}

/// A font that is part of the program.
fn parse(font: &'static [u8]) -> Face<'static> {
    Face::parse(font, 0).expect("the fonts of the crate `dejavu` are whole")
}

/// The kerning of two glyphs: the change of their distance, in units of the font.
fn kerning(face: &Face<'_>, left: GlyphId, right: GlyphId) -> f64 {
    let tables = face.tables().kern.into_iter().flat_map(|kern| kern.subtables);
    tables.filter(|table| table.horizontal).find_map(|table| table.glyphs_kerning(left, right)).map_or(0.0, f64::from)
}

/// Writes outlines in units of the font, y upwards, as SVG path data.
struct Pen<'a> {
    d: &'a mut String,
    /// Where the origin of the glyph is in the SVG.
    origin: (f64, f64),
    /// SVG units in a unit of the font.
    scale: f64,
}

impl Pen<'_> {
    fn draw<const N: usize>(&mut self, command: char, points: [(f32, f32); N]) {
        self.d.push(command);
        for (x, y) in points {
            let (x, y) = (self.origin.0 + self.scale * f64::from(x), self.origin.1 - self.scale * f64::from(y));
            let _ = write!(self.d, "{x:.3} {y:.3} ");
        }
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.draw('M', [(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.draw('L', [(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.draw('Q', [(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.draw('C', [(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.d.push('Z');
    }
}

/// Width of `words` in units of the font size, a little too large rather than too small.
pub(super) fn ems(words: &str) -> f64 {
    let width = |c: char| match c {
        'i' | 'j' | 'l' | 't' | 'f' | 'r' | ' ' | '.' | ',' | ':' | ';' | '(' | ')' | '[' | ']' | '\'' | '|' => 0.4,
        'm' | 'w' | 'M' | 'W' | '=' | '+' | '−' | '<' | '>' => 0.95,
        c if c.is_uppercase() => 0.76,
        _ => 0.64,
    };
    words.chars().map(width).sum()
}

/// The parts of `words`, and which of them are an index: `ω_{d} [1/s]` is `ω`, the index `d` and ` [1/s]`.
fn runs(mut words: &str) -> Vec<(&str, bool)> {
    let mut runs = vec![];
    while let Some((before, (index, after))) =
        words.split_once("_{").and_then(|(before, tail)| Some((before, tail.split_once('}')?)))
    {
        runs.extend([(before, false), (index, true)]);
        words = after;
    }
    runs.push((words, false));
    runs
}

/// `words` as SVG content, in which the subscript of e.g. `ω_{d}` is low and small.
fn markup(words: &str) -> String {
    let (size, below) = INDEX;
    let mut out = String::new();
    let mut is_low = false;
    for (run, is_index) in runs(words) {
        if is_index {
            let _ = write!(out, "<tspan dy=\"{below}\" font-size=\"{size}\">{}</tspan>", escape(run));
            is_low = true;
        } else if let Some(first) = run.chars().next().filter(|_| is_low) {
            // In SVG a shift also applies to all text that follows: undo it.
            let _ = write!(out, "<tspan dy=\"-{below}\">{}</tspan>", escape(&first.to_string()));
            out += &escape(&run[first.len_utf8()..]);
            is_low = false;
        } else {
            out += &escape(run);
        }
    }
    out
}

pub(super) fn escape(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Least and greatest x, and least and greatest y, of path data.
    fn extent(path: &str) -> [f64; 4] {
        let d = path.split('"').nth(1).unwrap();
        let numbers: Vec<f64> = d.split(|c: char| c.is_alphabetic() || c == ' ').flat_map(str::parse).collect();
        let of = |axis: usize| super::super::figure::extremes(numbers.iter().skip(axis).step_by(2).copied());
        let ((left, right), (top, bottom)) = (of(0), of(1));
        [left, right, top, bottom]
    }

    #[test]
    fn outlines_are_where_their_anchor_says() {
        let of = |anchor| extent(&outlines((100.0, 50.0), anchor, 20.0, "", "H-H"));
        let ([left, right, top, bottom], middle, end) = (of(Anchor::Start), of(Anchor::Middle), of(Anchor::End));
        // Capitals stand on the line; those of DejaVu Sans are 0.729 em high.
        assert!((bottom - 50.0).abs() < 1e-3 && (bottom - top - 0.729 * 20.0).abs() < 0.01, "{top} to {bottom}");
        // The bearings on either side of an H are equal.
        let bearing = left - 100.0;
        assert!(bearing > 0.0 && (100.0 - bearing - end[1]).abs() < 2e-3, "{left}, {end:?}");
        assert!((middle[0] + middle[1] - 200.0).abs() < 2e-3 && (middle[1] - middle[0] - (right - left)).abs() < 2e-3);
    }

    #[test]
    fn an_index_is_low_and_small_and_what_follows_is_not() {
        assert_eq!(runs("ω/ω_{d} [1]"), [("ω/ω", false), ("d", true), (" [1]", false)]);
        assert_eq!(markup("ω_{d}<"), "ω<tspan dy=\"3\" font-size=\"10\">d</tspan><tspan dy=\"-3\">&lt;</tspan>");
        let bottom = |words| extent(&outlines((0.0, 0.0), Anchor::Start, 12.0, "", words))[3];
        assert!((bottom("H_{H}H") - 3.0).abs() < 1e-3 && bottom("HHH").abs() < 1e-3);
    }

    #[test]
    fn pairs_are_kerned_and_bold_is_wider() {
        let width = |attributes: &str, words: &str| {
            let [left, right, ..] = extent(&outlines((0.0, 0.0), Anchor::Start, 12.0, attributes, words));
            right - left
        };
        let advance = |c: char| width("", &format!("H{c}H")) - width("", "HH");
        assert!(width("", "HAVH") - width("", "HH") < advance('A') + advance('V') - 0.5);
        assert!(width(BOLD, "HH") > width("", "HH"));
    }
}
