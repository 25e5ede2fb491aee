//! A picture: SVG, and the PNG made from it.
//!
//! The SVG has its text as text, so that it can be searched and edited. The PNG is rasterised from the same SVG with
//! the outlines of the glyphs in place of the text: the fonts that the system has installed do not change it.

use std::fmt;

use resvg::{tiny_skia, usvg};

use super::PlotError;
use super::text::{self, Anchor};

/// Width of every picture in SVG units (1/96 inch).
pub(super) const WIDTH: f64 = 800.0;
/// Pixels of a PNG per unit of length of the SVG.
const PNG_SCALE: f32 = 2.0;
const FONTS: &str = "'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif";

/// A finished picture.
pub struct Picture {
    title: String,
    drawing: Drawing,
}

/// The elements of a picture. Everything that is written to it goes to both forms of the SVG. Only [`Drawing::text`] writes something else
/// to each form.
#[derive(Default)]
pub(super) struct Drawing {
    /// SVG with text as text.
    svg: String,
    /// SVG with text as outlines.
    outlined: String,
}

impl Drawing {
    /// Draws `words` at `at`, with the content of `_{...}` as a subscript; `attributes` are those of SVG.
    pub(super) fn text(&mut self, at: (f64, f64), anchor: Anchor, size: f64, attributes: &str, words: &str) {
        self.svg += &text::element(at, anchor, size, attributes, words);
        self.outlined += &text::outlines(at, anchor, size, attributes, words);
    }

    /// The picture of these elements: `height` tall, on white.
    pub(super) fn finish(self, title: &str, height: f64) -> Picture {
        let whole = |body: String| {
            format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" \
                 viewBox=\"0 0 {WIDTH} {height}\" font-family=\"{FONTS}\" role=\"img\">\n<title>{}</title>\n\
                 <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{body}</svg>\n",
                text::escape(title)
            )
        };
        let drawing = Drawing { svg: whole(self.svg), outlined: whole(self.outlined) };
        Picture { title: title.to_owned(), drawing }
    }
}

impl fmt::Write for Drawing {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        self.svg.push_str(part);
        self.outlined.push_str(part);
        Ok(())
    }
}

impl Picture {
    /// The picture as SVG, self-contained but for the font.
    pub fn svg(&self) -> &str {
        &self.drawing.svg
    }

    /// The picture as PNG at twice the resolution of the SVG, its font included. Errors: [`PlotError::Render`].
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let failed = |why: String| PlotError::Render { title: self.title.clone(), why };
        let tree = usvg::Tree::from_str(&self.drawing.outlined, &usvg::Options::default());
        let tree = tree.map_err(|e| failed(e.to_string()))?;
        let size = tree.size().to_int_size().scale_by(PNG_SCALE);
        let pixels = size.and_then(|s| tiny_skia::Pixmap::new(s.width(), s.height()));
        let mut pixels = pixels.ok_or_else(|| failed("it has no size".into()))?;
        let scale = tiny_skia::Transform::from_scale(PNG_SCALE, PNG_SCALE);
        pixels.fill(tiny_skia::Color::WHITE);
        resvg::render(&tree, scale, &mut pixels.as_mut());
        encode(&pixels).map_err(|e| failed(e.to_string()))
    }
}

/// An opaque picture as PNG. Without the channel of opacity it is encoded in half the time. Large areas have one colour: the filter `Up`
/// turns these into zeros.
fn encode(pixels: &tiny_skia::Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = vec![];
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::Up);
    let mut colours = vec![0; 3 * pixels.pixels().len()];
    for (colour, pixel) in colours.chunks_exact_mut(3).zip(pixels.data().chunks_exact(4)) {
        colour.copy_from_slice(&pixel[..3]);
    }
    encoder.write_header()?.write_image_data(&colours)?;
    Ok(file)
}
