//! Unit symbols: the unit of each symbol, and suggestions for unknown symbols.

use std::f64::consts::PI;

use super::dimension::Dimension;
use super::mistake::did_you_mean;
use super::unit::Unit;

/// The symbols, as shown in messages.
pub(super) const KNOWN: &str = "m g s N J W Pa Hz rad, with prefixes n u m c d k M G T; min h deg rev rpm %";

const PREFIXES: [(&str, i32); 11] = [
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// Units that take a prefix: symbol, power of ten relative to kg, m, s, rad, and dimension.
const SI: [(&str, i32, Dimension); 10] = [
    ("m", 0, Dimension::new(1, 0, 0, 0)),
    ("g", -3, Dimension::new(0, 1, 0, 0)),
    ("s", 0, Dimension::new(0, 0, 1, 0)),
    ("N", 0, Dimension::new(1, 1, -2, 0)),
    ("Nm", 0, Dimension::new(2, 1, -2, 0)),
    ("J", 0, Dimension::new(2, 1, -2, 0)),
    ("W", 0, Dimension::new(2, 1, -3, 0)),
    ("Pa", 0, Dimension::new(-1, 1, -2, 0)),
    ("Hz", 0, Dimension::new(0, 0, -1, 0)),
    ("rad", 0, Dimension::new(0, 0, 0, 1)),
];

/// Units that take no prefix: symbol, power of ten, factor, divisor and dimension.
const OTHER: [(&str, i32, f64, f64, Dimension); 8] = [
    ("1", 0, 1.0, 1.0, Dimension::NONE),
    ("%", -2, 1.0, 1.0, Dimension::NONE),
    ("min", 0, 60.0, 1.0, Dimension::new(0, 0, 1, 0)),
    ("h", 0, 3600.0, 1.0, Dimension::new(0, 0, 1, 0)),
    ("deg", 0, PI, 180.0, Dimension::new(0, 0, 0, 1)),
    ("°", 0, PI, 180.0, Dimension::new(0, 0, 0, 1)),
    ("rev", 0, 2.0 * PI, 1.0, Dimension::new(0, 0, 0, 1)),
    ("rpm", 0, PI, 30.0, Dimension::new(0, 0, -1, 1)),
];

/// The unit of a symbol. Symbols without a prefix take precedence: `min` is a minute, `m` a metre, `h` an hour.
pub(super) fn find(symbol: &str) -> Option<Unit> {
    let prefixed = || PREFIXES.iter().find_map(|(prefix, decimal)| si(symbol.strip_prefix(prefix)?, *decimal));
    other(symbol).or_else(|| si(symbol, 0)).or_else(prefixed)
}

fn si(symbol: &str, prefix: i32) -> Option<Unit> {
    let (_, decimal, dimension) = SI.into_iter().find(|unit| unit.0 == symbol)?;
    Some(Unit { dimension, decimal: decimal + prefix, ..Unit::ONE })
}

fn other(symbol: &str) -> Option<Unit> {
    let unit = OTHER.into_iter().find(|unit| unit.0 == symbol)?;
    let (_, decimal, numerator, denominator, dimension) = unit;
    Some(Unit { dimension, decimal, numerator, denominator })
}

/// A suggestion for an unknown symbol: kHz for `KHz`, Nm or nm for `NM`, deg for `degs`, N*mm for `Nmm`.
pub(super) fn meant(symbol: &str) -> Option<String> {
    let whole = || OTHER.iter().map(|unit| unit.0).chain(["rad"]);
    let prefixes = PREFIXES.iter().map(|prefix| prefix.0).chain([""]);
    let all = prefixes.flat_map(|prefix| SI.iter().map(move |unit| format!("{prefix}{}", unit.0)));
    let all = all.chain(whole().map(str::to_string));
    // Names that differ in fewer letters come first.
    let mut cases: Vec<String> = all.filter(|name| name.to_lowercase() == symbol.to_lowercase()).collect();
    cases.sort_by_key(|name| (name.chars().zip(symbol.chars()).filter(|(a, b)| a != b).count(), name.clone()));
    cases.dedup();
    let case = (!cases.is_empty()).then(|| cases.join(" or "));
    let product = || {
        let mut pairs = symbol.char_indices().map(|(i, _)| symbol.split_at(i));
        pairs.find(|(a, b)| find(a).and(find(b)).is_some()).map(|(a, b)| format!("{a}*{b}"))
    };
    case.or_else(|| did_you_mean(symbol, whole()).map(str::to_string)).or_else(product)
}
