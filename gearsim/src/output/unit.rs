//! The units in which people read numbers: rpm, um, kN.

use std::f64::consts::PI;

use super::number::short;

/// For SI units, the units that engineers use, with the factors to them: the first that suits the size of the numbers is taken.
/// `page/assets/plot.js` has the same.
const UNITS: [(&str, &[(&str, f64)]); 8] = [
    ("rad/s", &[("rpm", 30.0 / PI)]),
    ("N", &[("N", 1.0), ("kN", 1e-3), ("MN", 1e-6)]),
    ("N*m", &[("N*m", 1.0), ("kN*m", 1e-3), ("MN*m", 1e-6)]),
    ("m", &[("m", 1.0), ("mm", 1e3), ("um", 1e6)]),
    ("m/s", &[("m/s", 1.0), ("mm/s", 1e3), ("um/s", 1e6)]),
    ("rad", &[("rad", 1.0), ("mrad", 1e3), ("urad", 1e6)]),
    ("W", &[("W", 1.0), ("kW", 1e-3), ("MW", 1e-6)]),
    ("J", &[("J", 1.0), ("mJ", 1e3), ("kJ", 1e-3), ("MJ", 1e-6)]),
];

/// The unit in which numbers of the SI unit `unit` up to `largest` are from 1 to 1000, and the factor to it; the SI unit if there is none.
/// Speeds of rotors are in rpm, whatever their size.
pub(crate) fn readable(unit: &str, largest: f64) -> (&str, f64) {
    let known = UNITS.iter().find(|(si, _)| *si == unit);
    let sized = known.and_then(|(_, units)| match units {
        [only] => Some(only),
        _ => units.iter().find(|(_, factor)| (1.0..1000.0).contains(&(factor * largest.abs()))),
    });
    sized.copied().unwrap_or((unit, 1.0))
}

/// A number \[SI\] in the unit that suits its size.
pub(crate) fn in_words(x: f64, unit: &str) -> String {
    let (unit, scale) = readable(unit, x);
    let text = short(scale * x);
    if unit == "1" { text } else { format!("{text} {unit}") }
}

/// As [`in_words`], for a coordinate or its speed. Angles stay in rad and their speeds in rad/s: most are rotations, and their speeds are
/// not those of rotors.
pub(crate) fn coordinate_in_words(x: f64, unit: &str) -> String {
    if unit.starts_with("rad") { format!("{} {unit}", short(x)) } else { in_words(x, unit) }
}

#[test]
fn numbers_are_from_1_to_1000_where_a_unit_suits_them() {
    let cases = [
        ("N", 320.0, "N"),
        ("N", -3352.0, "kN"),
        ("m", 4.2e-6, "um"),
        ("m", 0.0, "m"),
        ("m", 1e-9, "m"),
        ("1", 5e3, "1"),
    ];
    for (unit, largest, shown) in cases {
        assert_eq!(readable(unit, largest).0, shown, "{largest} {unit}");
    }
    assert!((readable("rad/s", 0.1).1 - 9.549_296_585_513_721).abs() < 1e-15);
}
