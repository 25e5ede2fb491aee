//! The phase of a law: how far it is ahead in its pitch, k(s) = k0(s + phase).
//!
//! Meshes that roll on with one coordinate differ by their phases. Of the planets of a stage they follow from the tooth
//! numbers: R. G. Parker, J. Lin, "Mesh Phasing Relationships in Planetary and Epicyclic Gears", J. Mech. Des. 126(2), 2004.
//! Where the phase counts the teeth of the sun as they pass, counterclockwise seen from the carrier, a planet at the angle psi
//! meets each of them later than a planet at 0 would, and each tooth of the ring earlier:
//!
//! ```text
//! phase of k_sn = -Z_s psi_n/(2 pi)          k_rn:  +Z_r psi_n/(2 pi) - (Z_p - 1)/2        [pitches]
//! ```
//!
//! (their gamma_sn, gamma_rn and gamma_rs with the opposite sign: they count how late a mesh is). The two agree for a planet
//! that fits between sun and ring, (Z_s + Z_r) psi_n = 2 pi times a whole number. The last term is between the meshes of one
//! planet, whose teeth touch the sun with one flank and the ring with the other: laws that begin at the pitch point, and teeth
//! as thick as their spaces.

use std::f64::consts::TAU;

use super::document::{Entry, Node, Value};
use super::error::Report;
use super::quantity::Quantity;
use super::unit::Unit;
use super::{field, keys, measure};
use crate::model::Law;

/// Parts of a pitch at which teeth meet are whole fractions of this many, or fewer: so near to one, it is meant.
const PARTS: i32 = 360;
const NEAR: f64 = 1e-11;

/// Reads `phase`, in the unit of the law's phase; within the `pitches` after which the law repeats itself.
pub(super) fn read(law: &Law, unit: &str, pitches: u32, node: &Node, report: &mut Report) -> Option<f64> {
    let path = format!("laws.{}.phase", law.name);
    if let Value::Table(entries) = &node.value {
        return Some(of_planet(&path, entries, node, report)? * law.period);
    }
    let bare = match &node.value {
        Value::Number(_) => true,
        Value::Text(text) => Quantity::parse(text).is_ok_and(|q| {
            let angle = Unit::parse(unit).is_ok_and(|unit| q.dimension.fits(unit.dimension));
            q.bare || !angle && q.dimension.fits(Unit::ONE.dimension)
        }),
        _ => false,
    };
    match bare {
        true => Some(measure::quantity(&path, node, "1", report)? % f64::from(pitches) * law.period),
        false => Some(measure::quantity(&path, node, unit, report)? % (law.period * f64::from(pitches))),
    }
}

/// The phase of a planet's mesh [pitches].
fn of_planet(path: &str, entries: &[Entry], node: &Node, report: &mut Report) -> Option<f64> {
    keys::known(entries, &format!("`{path}`"), &["sun", "ring", "at", "planet"], report);
    let get = |key| keys::get(entries, key);
    let teeth = |key: &str, report: &mut Report| -> Option<Option<f64>> {
        let Some(node) = keys::get(entries, key) else { return Some(None) };
        let path = format!("{path}.{key}");
        let z = measure::quantity(&path, node, "1", report)?;
        if z.fract() != 0.0 || z < 1.0 {
            measure::out_of_range(&path, node, "must be a whole number", "it is a number of teeth", report);
            return None;
        }
        Some(Some(z))
    };
    let (sun, ring, planet) = (teeth("sun", report), teeth("ring", report), teeth("planet", report));
    let at = get("at").and_then(|node| measure::quantity(&format!("{path}.at"), node, "rad", report));
    if get("at").is_none() {
        keys::missing(&[("at", "at = \"120 deg\"".into())], &format!("`{path}`"), &node.place, report);
    }
    let lead = match (sun?, ring?) {
        (Some(z), None) => -z * at? / TAU,
        (None, Some(z)) => z * at? / TAU,
        _ => {
            let help = "give `sun` for the mesh of sun and planet, `ring` for that of ring and planet: their teeth";
            report.add(&node.place, format!("`{path}` is of a sun or of a ring"), "one of the two", help);
            return None;
        }
    };
    let between = match (planet?, get("sun"), get("planet")) {
        (Some(_), Some(_), Some(node)) => {
            let help = "leave it out here: it sets the ring's meshes against the sun's";
            report.add(&node.place, format!("`{path}.planet` goes with `ring`"), "out of place", help);
            return None;
        }
        (Some(z), ..) => (z - 1.0) / 2.0,
        _ => 0.0,
    };
    Some(whole_fraction((lead - between).fract()))
}

/// The whole fraction that `x` means, if it is that near to one.
fn whole_fraction(x: f64) -> f64 {
    let near = (1..=PARTS).map(f64::from).find(|d| (x * d - (x * d).round()).abs() < NEAR * d);
    near.map_or(x, |d| ((x * d).round() / d).fract())
}

/// What is allowed in place of a table.
pub(super) fn wrong_type(path: &str, node: &Node, report: &mut Report) -> bool {
    let readable = matches!(node.value, Value::Number(_) | Value::Text(_) | Value::Table(_));
    if !readable {
        let help = "write a part of a pitch, 0.25, an angle, \"90 deg\", or { sun = 27, at = \"120 deg\" }";
        field::wrong_type(path, node, "a phase", help, report);
    }
    !readable
}

#[test]
fn whole_fractions_are_met_exactly() {
    for (z, degrees) in [(27.0, 120.0), (28.0, 120.0), (31.0, 72.0), (99.0, 240.0), (1000.0, 288.0f64)] {
        let x = (z * degrees.to_radians() / TAU).fract();
        let found = whole_fraction(x);
        let want = (z * degrees % 360.0) / 360.0;
        assert!((found - want).abs() < 1e-15, "{z} {degrees}: {found} {want}");
    }
    assert_eq!(whole_fraction(0.123_456_789), 0.123_456_789);
}
