//! Numbers in a page: columns as base64 typed arrays, and JSON that is safe inside a script element.
//!
//! A column is stored in blocks of [`BLOCK`] values: value = offset + scale * count, with an offset and a scale for each block, so that an
//! angle of a million radians still shows its oscillation. Counts have 16 or 32 bits; the highest count stands for a value that is
//! not finite. Bytes: offset and scale of every block in f64, little endian, then all counts, packed ([`pack`]).

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use super::pack::pack;

/// Values in a block; `assets/data.js` has the same number.
pub const BLOCK: usize = 1024;

/// How finely a column is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counts {
    /// 16 bits, with a rounding error of 1/131,000 of the range of each block: for curves on a screen and values with five digits.
    Short,
    /// 32 bits, with a rounding error of 1/8.6e9 of the range of each block: for times and frequencies.
    Long,
}

/// A column that is embedded in the page.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Column {
    /// Identifier of the element with its bytes.
    pub id: String,
    /// Number of values.
    pub length: usize,
    /// Bits of a count before it is packed: 16 or 32.
    pub bits: u32,
}

/// The column called `id` with `values` below 8.9e307, and its bytes in base64.
pub fn encode(id: String, values: &[f64], counts: Counts) -> (Column, String) {
    let (bits, most) = match counts {
        Counts::Short => (16, f64::from(u16::MAX - 1)),
        Counts::Long => (32, f64::from(u32::MAX - 1)),
    };
    let mut bytes = Vec::with_capacity(16 * values.len().div_ceil(BLOCK) + values.len());
    let mut all = Vec::with_capacity(values.len());
    for block in values.chunks(BLOCK) {
        let finite = || block.iter().copied().filter(|x| x.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let offset = if low.is_finite() { low } else { 0.0 };
        // Divide before the subtraction: the difference of the largest numbers would overflow.
        let scale = if high > low { high / most - low / most } else { 0.0 };
        bytes.extend(offset.to_le_bytes().into_iter().chain(scale.to_le_bytes()));
        for x in block {
            let count = if scale > 0.0 { (x / scale - offset / scale).round() } else { 0.0 };
            all.push(if x.is_finite() { count.clamp(0.0, most) } else { most + 1.0 } as u32);
        }
    }
    pack(&all, &mut bytes);
    (Column { id, length: values.len(), bits }, STANDARD.encode(bytes))
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
