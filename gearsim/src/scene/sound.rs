//! `[output] sound`: which signals are written as sound, and how slowly they are played.

use super::document::Node;
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::{field, keys, spectrum};

/// Keys of the table.
pub(super) const KEYS: &[Key] = &[
    key("of", Kind::List(&Kind::Name(spectrum::SIGNAL)), REQUIRED, "signals to write"),
    key(
        "stretch",
        Kind::Number,
        "1",
        "playing time over model time: 10 plays 10 times slower, and divides each frequency by 10",
    ),
];
/// Factors by which time may be stretched \[1\]: beyond them nothing can be heard.
const STRETCHES: std::ops::RangeInclusive<f64> = 1e-3..=1e6;

/// What is written as sound.
#[derive(Debug, Clone, PartialEq)]
pub struct Sound {
    /// Names of the signals: recorded outputs and coordinates.
    pub of: Vec<&'static str>,
    /// Playing time over model time \[1\]: 10 is ten times as slow, and all frequencies a tenth.
    pub stretch: f64,
}

/// Reads the table; `signals` are the recorded signals.
pub(super) fn read(node: &Node, signals: &[&'static str], report: &mut Report) -> Option<Sound> {
    let given = field::table("output.sound", node, report)?;
    keys::known(given, "[output.sound]", &[KEYS], report);
    let Some(of) = keys::get(given, "of") else {
        keys::missing(&[("of", "of = [\"...\"]".into())], "[output.sound]", &node.place, report);
        return None;
    };
    let of = field::names("output.sound.of", of, "recorded signal", signals, report)?;
    let stretch = match keys::get(given, "stretch") {
        None => 1.0,
        Some(node) => {
            let stretch = field::quantity("output.sound.stretch", node, "1", report)?;
            if !STRETCHES.contains(&stretch) {
                let must = format!("must lie between {} and {:e}", STRETCHES.start(), STRETCHES.end());
                let help = "1 plays the signal as fast as it happens, 10 plays it 10 times slower and divides each frequency by 10";
                field::out_of_range("output.sound.stretch", node, &must, help, report);
                return None;
            }
            stretch
        }
    };
    Some(Sound { of: of.into_iter().map(|i| signals[i]).collect(), stretch })
}
