//! Quantities: `1.43 kN*m` is read as 1430 and a dimension.
//!
//! Decimal factors (prefixes) are applied to the exponent of the decimal text. The result is therefore the f64 nearest to the written
//! value: `2890 kg*mm^2` is 2.89e-3 to the last bit. Only degrees, revolutions, minutes and hours need a floating-point multiplication.

use super::dimension::Dimension;
use super::unit::{Unit, UnitError};

/// A number with a unit, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Value [SI].
    pub value: f64,
    /// Physical dimension.
    pub dimension: Dimension,
    /// Whether it was written without a unit.
    pub bare: bool,
}

impl Quantity {
    /// A number without a unit.
    pub fn bare(value: f64) -> Quantity {
        Quantity { value, dimension: Dimension::NONE, bare: true }
    }

    /// Reads a number and its unit, e.g. `300 rpm`. The value may overflow to infinity.
    pub fn parse(text: &str) -> Result<Quantity, UnitError> {
        let start = text.len() - text.trim_start().len();
        let (mantissa, exponent, end) = number(text, start)?;
        let rest = &text[end..];
        if rest.starts_with(',') {
            let message = "a comma in a number".to_string();
            return Err(UnitError { span: end..end + 1, message, help: "write a decimal point".to_string() });
        }
        let unit = Unit::parse(rest).map_err(|mut error| {
            error.span = error.span.start + end..error.span.end + end;
            error
        })?;
        // f64 parses every text of this form, so the default is never used; a NaN would be refused later.
        let decimal: f64 = format!("{mantissa}e{}", exponent + i64::from(unit.decimal)).parse().unwrap_or(f64::NAN);
        let value = match (unit.numerator, unit.denominator) {
            (1.0, 1.0) => decimal,
            (numerator, denominator) => decimal * numerator / denominator,
        };
        Ok(Quantity { value, dimension: unit.dimension, bare: rest.trim().is_empty() })
    }
}

/// Splits a quantity into its number and its unit, both as written (the number not scaled by the unit).
///
/// # Errors
/// As [`Quantity::parse`].
pub fn split(text: &str) -> Result<(f64, &str), UnitError> {
    Quantity::parse(text)?;
    let start = text.len() - text.trim_start().len();
    let (_, _, end) = number(text, start)?;
    // `Quantity::parse` has accepted this number, so f64 parses it.
    Ok((text[start..end].parse().unwrap_or(f64::NAN), text[end..].trim()))
}

/// Reads a time, e.g. `0.1 s` [s].
///
/// # Errors
/// If the text is not a quantity, not a time, negative or not finite.
pub fn parse_time(text: &str) -> Result<f64, String> {
    let quantity = Quantity::parse(text).map_err(|error| error.to_string())?;
    let second = Unit::parse("s").map_err(|error| error.to_string())?;
    let none = quantity.bare && quantity.value == 0.0;
    match quantity.dimension == second.dimension || none {
        true if quantity.value >= 0.0 && quantity.value.is_finite() => Ok(quantity.value),
        true => Err("the time must be finite and not negative".into()),
        false => Err(format!("a time is required, e.g. \"0.1 s\", not {}", quantity.dimension.describe())),
    }
}

/// The decimal number at byte `start`: its mantissa, its power of ten, and the byte where it ends.
fn number(text: &str, start: usize) -> Result<(&str, i64, usize), UnitError> {
    let skip = |from: usize, what: fn(char) -> bool| from + text[from..].chars().take_while(|c| what(*c)).count();
    let digit = |c: char| c.is_ascii_digit();
    let sign = |at: usize| at + usize::from(text[at..].starts_with(['+', '-']));

    let whole = skip(sign(start), digit);
    let mut end = whole;
    if text[end..].starts_with('.') {
        end = skip(end + 1, digit);
    }
    let mantissa = &text[start..end];
    if !mantissa.contains(|c: char| c.is_ascii_digit()) {
        let message = if text.trim().is_empty() { "no number" } else { "does not begin with a number" };
        let help = "write a number and a unit, e.g. \"10 N*m\"";
        return Err(UnitError { span: 0..text.len(), message: message.into(), help: help.into() });
    }
    if text[end..].starts_with(['e', 'E']) {
        let digits = sign(end + 1);
        let after = skip(digits, digit);
        if after > digits {
            // An exponent beyond i32 gives 0 or infinity for every mantissa.
            let exponent = text[end + 1..after].parse::<i32>().unwrap_or(if text[end + 1..].starts_with('-') {
                i32::MIN
            } else {
                i32::MAX
            });
            return Ok((mantissa, exponent.into(), after));
        }
    }
    Ok((mantissa, 0, end))
}
