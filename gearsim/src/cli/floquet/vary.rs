//! The option `--vary KEY=LOW..HIGH UNIT` of `gearsim floquet`: a range of a quantity of the scene.

use std::str::FromStr;

use crate::scene::quantity;

/// A range of values of a key.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::cli) struct Vary {
    /// Key in the scene, e.g. `start.speed`.
    pub(in crate::cli) key: String,
    low: f64,
    high: f64,
    /// Unit of both ends; empty for plain numbers.
    pub(in crate::cli) unit: String,
}

impl FromStr for Vary {
    type Err = String;

    fn from_str(text: &str) -> Result<Vary, String> {
        let usage = || format!("`{text}` is not a range: write for example start.speed=\"300..9000 rpm\"");
        let (key, range) = text.split_once('=').ok_or_else(usage)?;
        let (low, high) = range.split_once("..").ok_or_else(usage)?;
        let (low, low_unit) = end(low)?;
        let (high, unit) = end(high)?;
        // The unit after the range is that of both ends: 300..9000 rpm.
        if !low_unit.is_empty() && low_unit != unit {
            return Err(format!(
                "the ends of the range of `{key}` have different units, or the second has none: write both in `{low_unit}`, or one unit after the range"
            ));
        }
        if low >= high {
            return Err(format!(
                "the range of `{key}` must go from a lower to a higher value, not from {low} to {high}"
            ));
        }
        Ok(Vary { key: key.trim().into(), low, high, unit: unit.trim().into() })
    }
}

/// An end of the range: its number and its unit, read as quantities of a scene are.
fn end(text: &str) -> Result<(f64, &str), String> {
    match quantity::split(text) {
        Ok((number, unit)) if number.is_finite() => Ok((number, unit)),
        Ok(_) => Err(format!("`{}` is not a finite number", text.trim())),
        Err(error) => Err(format!("`{}` cannot be read: {}; {}", text.trim(), error.message, error.help)),
    }
}

impl Vary {
    /// `count` evenly spaced values, both ends included.
    pub(in crate::cli) fn values(&self, count: usize) -> Vec<f64> {
        let step = (self.high - self.low) / (count - 1) as f64;
        (0..count).map(|i| if i + 1 == count { self.high } else { self.low + step * i as f64 }).collect()
    }

    /// A value in the form of an option --set, `KEY=VALUE UNIT`.
    pub(in crate::cli) fn set(&self, value: f64) -> String {
        format!("{}={value:?} {}", self.key, self.unit).trim_end().to_owned()
    }
}

#[test]
fn ranges_are_parsed_with_their_unit() {
    let range: Vary = "start.speed=300..9000 rpm".parse().unwrap();
    assert_eq!((range.key.as_str(), range.unit.as_str()), ("start.speed", "rpm"));
    assert_eq!(range.values(3), [300.0, 4650.0, 9000.0]);
    assert_eq!(range.set(300.0), "start.speed=300.0 rpm");
    assert_eq!("parameters.zeta=0..0.15".parse::<Vary>().unwrap().set(0.1), "parameters.zeta=0.1");
    for same in ["300rpm..9000rpm", "300 rpm .. 9000 rpm", "300..9000rpm"] {
        assert_eq!(format!("start.speed={same}").parse::<Vary>().unwrap(), range, "{same}");
    }
    for wrong in
        ["start.speed", "a=1", "a=1..", "a=2..1", "a=1..nan", "a=1..1e999", "a=x..3 m", "a=1 m..3", "a=1 m..3 mm"]
    {
        assert!(wrong.parse::<Vary>().is_err(), "{wrong}");
    }
}
