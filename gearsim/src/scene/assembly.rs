//! Whether planets can be assembled, and whether there is room for each of them. A planet meets the teeth of both sun and ring only at
//! the angles psi with (Z_s + Z_r) psi = 2 pi n, where n is a whole number:
//! R. G. Parker, J. Lin, "Mesh Phasing Relationships in Planetary and Epicyclic Gears", J. Mech. Des. 126(2), 2004.

use std::f64::consts::TAU;

use super::Scene;
use super::mistake::Report;
use crate::tolerance::scene::{ONE_PLACE, PLANET_FIT};

/// The first planet that does not fit.
pub(super) struct Misfit {
    /// Its number, from 0.
    pub planet: usize,
    /// What is wrong: "planet 2 ...".
    pub message: String,
    pub help: String,
}

/// The first of the planets at `angles` [rad] that does not fit between `sun` and `ring` teeth. A planet at the angle `from` [rad] fits.
pub(super) fn misfit([sun, ring]: [f64; 2], angles: &[f64], from: f64, of: &str) -> Option<Misfit> {
    let pitches = |angle: &f64| (sun + ring) * (angle - from) / TAU;
    let planet = angles.iter().map(pitches).position(|pitches| (pitches - pitches.round()).abs() > PLANET_FIT)?;
    let at = |n: f64| (from + TAU * n / (sun + ring)).to_degrees();
    let n = pitches(&angles[planet]).floor();
    let message = format!(
        "planet {} of {of} at {:.4} deg does not fit between {sun} and {ring} teeth",
        planet + 1,
        angles[planet].to_degrees()
    );
    let help = format!(
        "places are multiples of 360/{} deg apart; the nearest are {:.4} and {:.4} deg",
        sun + ring,
        at(n),
        at(n + 1.0)
    );
    Some(Misfit { planet, message, help })
}

/// Two planets that are too near to one another.
pub(super) enum Narrow {
    /// They are in one place. The number of one of them, from 0.
    OnePlace(usize),
    /// Their tips would meet, in words.
    Tips(String),
}

/// Checks the two nearest of the planets with `teeth` at `angles` [rad] between `sun` and `ring` teeth. `None` if there is room for both.
pub(super) fn narrow([sun, ring, teeth]: [f64; 3], angles: &[f64], of: &str) -> Option<Narrow> {
    let centre = (sun + ring) / 4.0;
    let pairs = (0..angles.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    // Distances of centres [modules].
    let apart = pairs.map(|(i, j)| (i, 2.0 * centre * (0.5 * (angles[i] - angles[j])).sin().abs()));
    let (planet, distance) = apart.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let tips = teeth + 2.0 * ADDENDUM;
    if distance < ONE_PLACE * teeth {
        return Some(Narrow::OnePlace(planet));
    }
    let said = || {
        format!(
            "{of}: the centres of two planets with {teeth} teeth are {distance:.1} modules apart, but standard teeth have a tip diameter of {tips} \
         modules: the planets collide unless they lie in different planes"
        )
    };
    (distance < tips).then(|| Narrow::Tips(said()))
}

/// Addendum of standard teeth [modules].
const ADDENDUM: f64 = 1.0;

/// Warns of the planets of a derived model that do not fit, or that are too near to one another. This is no error, because papers use such
/// planets with constant stiffnesses.
pub(super) fn check(scene: &Scene, report: &mut Report) {
    let (Some(sun), Some(ring)) = (scene.parameter("Z_s"), scene.parameter("Z_r")) else { return };
    // The places of the planets; without such parameters they are equally spaced.
    let mut angles: Vec<f64> = (1..).map_while(|i| scene.parameter(&format!("psi{i}"))).collect();
    if angles.is_empty() {
        let count = (1..).take_while(|i| scene.model.laws.iter().any(|law| law.name == format!("k_s{i}"))).count();
        angles = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
    }
    let Some(&first) = angles.first() else { return };
    if let Some(found) = misfit([sun, ring], &angles, first, "the stage") {
        report.warn(format!("{}: {}", found.message, found.help));
    }
    match narrow([sun, ring, (ring - sun) / 2.0], &angles, "the stage") {
        Some(Narrow::OnePlace(_)) => report.warn("the stage has two planets in one place".into()),
        Some(Narrow::Tips(said)) => report.warn(said),
        None => {}
    }
}
