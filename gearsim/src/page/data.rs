//! Numbers in a page: columns as base64 typed arrays, and JSON that is safe inside a script element.
//!
//! A column is stored in blocks of [`BLOCK`] values: value = offset + scale * count, with an offset and a scale for each block, so that an
//! angle of a million radians still shows its oscillation. Counts have two or four bytes; the highest count stands for a value that is
//! not finite. Bytes, little endian: offset and scale of every block in f64, then all counts.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

/// Values in a block; `assets/data.js` has the same number.
pub const BLOCK: usize = 1024;

/// How finely a column is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counts {
    /// To 1/131,000 of the range of each block, in two bytes: curves on a screen and values with five digits.
    Short,
    /// To 1/8.6e9 of the range of each block, in four bytes: times and frequencies.
    Long,
}

/// A column that is embedded in the page.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Column {
    /// Identifier of the element with its bytes.
    pub id: String,
    /// Number of values.
    pub length: usize,
    /// Bytes of a count: 2 or 4.
    pub width: usize,
}

/// The column called `id` with `values` below 8.9e307, and its bytes in base64.
pub fn encode(id: String, values: &[f64], counts: Counts) -> (Column, String) {
    let (width, most) = match counts {
        Counts::Short => (2, f64::from(u16::MAX - 1)),
        Counts::Long => (4, f64::from(u32::MAX - 1)),
    };
    let mut head = Vec::with_capacity(16 * values.len().div_ceil(BLOCK));
    let mut tail = Vec::with_capacity(width * values.len());
    for block in values.chunks(BLOCK) {
        let finite = || block.iter().copied().filter(|x| x.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let offset = if low.is_finite() { low } else { 0.0 };
        // Divided first: the difference of the largest numbers is not finite.
        let scale = if high > low { high / most - low / most } else { 0.0 };
        head.extend(offset.to_le_bytes().into_iter().chain(scale.to_le_bytes()));
        for x in block {
            let count = if scale > 0.0 { (x / scale - offset / scale).round() } else { 0.0 };
            let count = if x.is_finite() { count.clamp(0.0, most) } else { most + 1.0 } as u32;
            tail.extend_from_slice(&count.to_le_bytes()[..width]);
        }
    }
    head.append(&mut tail);
    (Column { id, length: values.len(), width }, STANDARD.encode(head))
}

/// `value` as JSON in which no text can end a script element or a line of a script.
pub fn json(value: &impl Serialize) -> String {
    // Specifications of plots consist of texts and numbers, which always serialise.
    let text = serde_json::to_string(value).unwrap_or_else(|_| "null".into());
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => safe.push_str(&format!("\\u{:04x}", c as u32)),
            c => safe.push(c),
        }
    }
    safe
}
