//! The key `phase` of a law: the shift of the law within its pitch, k(s) = k0(s + phase).
//!
//! Meshes that share one coordinate differ in their phases (mesh phasing). The phases of the planets of a stage follow from the tooth
//! numbers: R. G. Parker, J. Lin, "Mesh Phasing Relationships in Planetary and Epicyclic Gears", J. Mech. Des. 126(2), 2004.
//! Let the mesh phase s count the passing teeth of the sun, counterclockwise as seen from the carrier. A planet at the angle psi
//! meets each tooth of the sun later than a planet at the angle 0, and each tooth of the ring earlier:
//!
//! ```text
//! phase of k_sn = -Z_s psi_n/(2 pi)          k_rn:  +Z_r psi_n/(2 pi) - (Z_p - 1)/2        [pitches]
//! ```
//!
//! A law over several pitches, such as that of a damaged tooth of the sun, keeps the whole pitches of the shift: the tooth passes the planets
//! one after the other, in the direction in which the sun turns. A law with a damaged tooth of the planets is shifted in the
//! same way. So the teeth of each planet count from the one that meets tooth 1 of the sun. A tooth of a planet meets the ring half a turn
//! of the planet after the sun.
//!
//! These phases are the paper's gamma_sn, gamma_rn and gamma_rs with the opposite sign, because the paper counts the delay of a mesh. The
//! first two terms agree modulo 1 for a planet that fits between sun and ring, (Z_s + Z_r) psi_n = 2 pi times a whole number. The last
//! term is the shift between the two meshes of one planet, whose teeth touch the sun with one flank and the ring with the other. It holds
//! for laws that begin at the pitch point, and for teeth as thick as their spaces.

use std::f64::consts::TAU;

use super::document::{KeyEntry, Node, Value};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::quantity::Quantity;
use super::unit::Unit;
use super::{field, keys};
use crate::model::Law;
use crate::tolerance::scene::{PHASE_DENOMINATOR, PHASE_FRACTION};

/// Kind of the value.
pub(super) const KIND: Kind =
    Kind::Either(&[Kind::ValueIn("unit of the mesh phase, or pitches"), Kind::Table(&[PLANET])]);

/// Keys of the phase of a planet's mesh.
const PLANET: &[Key] = &[
    key("sun", Kind::Number, "none", "number of teeth of the sun, for its mesh with the planet"),
    key("ring", Kind::Number, "none", "number of teeth of the ring, for its mesh with the planet"),
    key("at", Kind::Quantity("rad"), REQUIRED, "place of the planet on the carrier"),
    key("planet", Kind::Number, "1", "number of teeth of the planet, with ring"),
];

/// Reads `phase` [unit of the law's phase coordinate], reduced to less than the period of `pitches` pitches. Whole pitches count in a law
/// over several pitches: they decide which tooth a planet meets.
pub(super) fn read(law: &Law, unit: &str, pitches: u32, node: &Node, report: &mut Report) -> Option<f64> {
    let path = format!("laws.{}.phase", law.name);
    if let Value::Table(entries) = &node.value {
        return Some(within(pitches, of_planet(&path, entries, node, report)?) * law.period);
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
        true => Some(field::quantity(&path, node, "1", report)? % f64::from(pitches) * law.period),
        false => Some(field::quantity(&path, node, unit, report)? % (law.period * f64::from(pitches))),
    }
}

/// Reads the phase of a planet's mesh from tooth numbers and angle [pitches].
fn of_planet(path: &str, entries: &[KeyEntry], node: &Node, report: &mut Report) -> Option<f64> {
    keys::known(entries, &format!("`{path}`"), &[PLANET], report);
    let get = |key| keys::get(entries, key);
    let teeth = |key: &str, report: &mut Report| -> Option<Option<f64>> {
        let Some(node) = keys::get(entries, key) else { return Some(None) };
        let path = format!("{path}.{key}");
        let z = field::quantity(&path, node, "1", report)?;
        if z.fract() != 0.0 || z < 1.0 {
            field::out_of_range(&path, node, "must be a whole number", "it is a number of teeth", report);
            return None;
        }
        Some(Some(z))
    };
    let (sun, ring, planet) = (teeth("sun", report), teeth("ring", report), teeth("planet", report));
    let at = get("at").and_then(|node| field::quantity(&format!("{path}.at"), node, "rad", report));
    if get("at").is_none() {
        keys::missing(&[("at", "at = \"120 deg\"".into())], &format!("`{path}`"), &node.place, report);
    }
    let lead = match (sun?, ring?) {
        (Some(z), None) => -z * at? / TAU,
        (None, Some(z)) => z * at? / TAU,
        _ => {
            let help = "give the number of teeth of the sun for a sun-planet mesh, of the ring for a ring-planet mesh";
            report.add(&node.place, format!("`{path}` must have either `sun` or `ring`"), "one of the two", help);
            return None;
        }
    };
    let between = match (planet?, get("sun"), get("planet")) {
        (Some(_), Some(_), Some(node)) => {
            let help = "leave it out: it shifts the ring mesh relative to the sun mesh";
            report.add(&node.place, format!("`{path}.planet` goes with `ring`"), "out of place", help);
            return None;
        }
        (Some(z), ..) => (z - 1.0) / 2.0,
        _ => 0.0,
    };
    Some(lead - between)
}

/// The shift `x` [pitches], reduced to less than `pitches`. Its fraction is rounded to one with a denominator of at most
/// [`PHASE_DENOMINATOR`] if there is one within [`PHASE_FRACTION`].
fn within(pitches: u32, x: f64) -> f64 {
    let (whole, part) = (x.trunc(), x.fract());
    let near = |d: &f64| (part * d - (part * d).round()).abs() < PHASE_FRACTION * d;
    let part = (1..=PHASE_DENOMINATOR).map(f64::from).find(near).map_or(part, |d| (part * d).round() / d);
    // A fraction may have been rounded to a whole pitch.
    (whole + part.trunc()) % f64::from(pitches) + part.fract()
}

/// Reports a value of `phase` that is neither a number, a text nor a table; returns whether it did.
pub(super) fn wrong_type(path: &str, node: &Node, report: &mut Report) -> bool {
    let readable = matches!(node.value, Value::Number(_) | Value::Text(_) | Value::Table(_));
    if !readable {
        let help = "write a fraction of a pitch, 0.25, an angle, \"90 deg\", or { sun = 27, at = \"120 deg\" }";
        field::wrong_type(path, node, "a phase", help, report);
    }
    !readable
}

#[test]
fn phases_near_a_fraction_are_rounded_to_it() {
    for (z, degrees) in [(27.0, 120.0), (28.0, 120.0), (31.0, 72.0), (99.0, 240.0), (1000.0, 288.0f64)] {
        let x = z * degrees.to_radians() / TAU;
        let found = within(1, x);
        let want = (z * degrees % 360.0) / 360.0;
        assert!((found - want).abs() < 1e-15, "{z} {degrees}: {found} {want}");
    }
    assert_eq!(within(1, 0.123_456_789), 0.123_456_789);
}

#[test]
fn whole_pitches_count_in_a_law_over_several_pitches() {
    assert_eq!(within(27, -27.0 * 120f64.to_radians() / TAU), -9.0);
    assert_eq!(within(27, -27.0 * 240f64.to_radians() / TAU), -18.0);
    assert_eq!(within(27, -2.0 * 27.0 - 9.5), -9.5);
    // A rounding error beside a whole pitch does not lose it.
    assert_eq!([within(24, 9.0 - 1e-14), within(24, 9.0 + 1e-14), within(24, -9.0 + 1e-14)], [9.0, 9.0, -9.0]);
    assert_eq!([within(9, 9.0 - 1e-14), within(1, 9.0 - 1e-14)], [0.0, 0.0]);
}
