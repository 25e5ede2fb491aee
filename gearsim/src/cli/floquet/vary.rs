//! The option `--vary KEY=LOW..HIGH UNIT` of `gearsim floquet`: a range of a quantity of the scene.

use std::str::FromStr;

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
        let (low, rest) = range.split_once("..").ok_or_else(usage)?;
        let (high, unit) = rest.trim().split_once(char::is_whitespace).unwrap_or((rest.trim(), ""));
        let number = |x: &str| x.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(usage);
        let (low, high) = (number(low)?, number(high)?);
        if low >= high {
            return Err(format!(
                "the range of `{key}` must go from a lower to a higher value, not from {low} to {high}"
            ));
        }
        Ok(Vary { key: key.trim().into(), low, high, unit: unit.trim().into() })
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
    for wrong in ["start.speed", "a=1", "a=1..", "a=2..1", "a=1..nan", "a=x..3 m"] {
        assert!(wrong.parse::<Vary>().is_err(), "{wrong}");
    }
}
