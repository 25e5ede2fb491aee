//! Units: `kN*m`, `kg mm^2`, `rad/s` are read as a factor to SI and a dimension.
//!
//! A unit is a product of symbols, followed by divisions: `N*m*s/rad`. Products are written `*`, `.`, `·` or a space,
//! powers `^2` or `²`. A product after a division (`N*m/rad*s`) is ambiguous and is refused.

use std::ops::Range;

use super::dimension::Dimension;
use super::symbol;

/// A unit relative to SI: 1 unit = 10^`decimal` `numerator` / `denominator` SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Physical dimension.
    pub dimension: Dimension,
    /// Power of ten, stored separately so that decimal numbers are scaled without rounding.
    pub decimal: i32,
    /// Non-decimal factor, e.g. 60 for minutes.
    pub numerator: f64,
    /// Non-decimal divisor, e.g. 180 for degrees.
    pub denominator: f64,
}

/// Why a quantity could not be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{message}: {help}")]
pub struct UnitError {
    /// Byte range of the text that is wrong.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

/// Largest power of a symbol. It is far more than any unit needs, and the sum of powers in a file cannot overflow.
const MAX_POWER: i32 = 9;

impl Unit {
    /// The unit of a plain number.
    pub const ONE: Unit = Unit { dimension: Dimension::NONE, decimal: 0, numerator: 1.0, denominator: 1.0 };

    /// Reads a unit; the empty text is [`Unit::ONE`], and `/s` means `1/s`.
    pub fn parse(text: &str) -> Result<Unit, UnitError> {
        let mut unit = Unit::ONE;
        let mut at = 0;
        let mut operator = None;
        let mut factors = 0;
        let mut divided = false;
        while let Some(c) = text[at..].chars().next() {
            let next = at + c.len_utf8();
            if c.is_whitespace() {
                at = next;
            } else if matches!(c, '*' | '.' | '·' | '⋅' | '/') {
                if operator.is_some() || (factors == 0 && c != '/') {
                    return Err(error(at..next, "a unit is missing before this", "write for example N*m or rad/s"));
                }
                operator = Some((c, at..next));
                at = next;
            } else {
                let symbol = symbol_at(text, at)?;
                let (power, end) = power(text, symbol.end)?;
                let divide = matches!(operator.take(), Some(('/', _)));
                if divided && !divide {
                    let message = format!("unclear whether `{}` is above or below the `/`", &text[symbol.clone()]);
                    return Err(error(symbol, message, "put all products before the first `/`, as in N*m*s/rad"));
                }
                divided |= divide;
                factors += 1;
                let factor = symbol::find(&text[symbol.clone()]).ok_or_else(|| unknown(text, symbol))?;
                unit = unit.times(factor, if divide { -power } else { power });
                at = end;
            }
        }
        match operator {
            Some((_, span)) => Err(error(span, "a unit is missing after this", "write for example N*m or rad/s")),
            None => Ok(unit),
        }
    }

    fn times(self, factor: Unit, power: i32) -> Unit {
        let (numerator, denominator) = match power < 0 {
            true => (factor.denominator, factor.numerator),
            false => (factor.numerator, factor.denominator),
        };
        Unit {
            dimension: self.dimension.times(factor.dimension, power),
            decimal: self.decimal + factor.decimal * power,
            numerator: self.numerator * numerator.powi(power.abs()),
            denominator: self.denominator * denominator.powi(power.abs()),
        }
    }
}

/// Byte range of the symbol that begins at `at`: letters, or one of `%`, `°`, `1`.
fn symbol_at(text: &str, at: usize) -> Result<Range<usize>, UnitError> {
    let rest = &text[at..];
    let letters = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
    if letters > 0 {
        return Ok(at..at + letters);
    }
    match rest.chars().next() {
        Some(c @ ('%' | '°' | '1')) => Ok(at..at + c.len_utf8()),
        Some(c) => Err(error(
            at..at + c.len_utf8(),
            format!("`{c}` does not belong in a unit"),
            "units look like N*m, kg*m^2, rad/s",
        )),
        None => Ok(at..at),
    }
}

/// The power after a symbol, `^2`, `^-1` or `²`, and the byte where it ends; 1 if there is none.
fn power(text: &str, at: usize) -> Result<(i32, usize), UnitError> {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let rest = &text[at..];
    let caret = rest.starts_with('^');
    let mut digits = String::new();
    let mut end = at + usize::from(caret);
    for c in text[end..].chars() {
        match (RAISED.iter().position(|r| *r == c), c) {
            (Some(digit), _) if !caret => digits.push_str(&digit.to_string()),
            (None, '⁻') if !caret => digits.push('-'),
            (None, '-' | '0'..='9') if caret || c != '-' => digits.push(c),
            _ => break,
        }
        end += c.len_utf8();
    }
    if !caret && rest.starts_with(|c: char| c.is_ascii_digit()) {
        return Err(error(at..end, "a number in the middle of a unit", format!("write powers as ^{digits}")));
    }
    match digits.parse() {
        Ok(power) if (-MAX_POWER..=MAX_POWER).contains(&power) => Ok((power, end)),
        Err(_) if !caret && digits.is_empty() => Ok((1, at)),
        _ => Err(error(at..end, "not a power that a unit can have", "write a small whole number: ^2, ^-1")),
    }
}

fn unknown(text: &str, span: Range<usize>) -> UnitError {
    let name = &text[span.clone()];
    let mut help = symbol::meant(name).map_or(String::new(), |meant| format!("did you mean {meant}?\n"));
    help.push_str("known: ");
    help.push_str(symbol::KNOWN);
    error(span.clone(), format!("unknown unit `{name}`"), help)
}

fn error(span: Range<usize>, message: impl Into<String>, help: impl Into<String>) -> UnitError {
    UnitError { span, message: message.into(), help: help.into() }
}
