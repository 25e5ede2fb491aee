//! Whether planets can be assembled. A planet meets the teeth of sun and ring at once only at places (Z_s + Z_r) psi = 2 pi n with a whole n:
//! R. G. Parker, J. Lin, "Mesh Phasing Relationships in Planetary and Epicyclic Gears", J. Mech. Des. 126(2), 2004.

use std::f64::consts::TAU;

use super::Scene;
use super::mistake::Report;
use crate::tolerance::scene::PLANET_FIT;

/// The first planet that does not fit.
pub(super) struct Misfit {
    /// Its number, from 0.
    pub planet: usize,
    /// What is wrong: "planet 2 ...".
    pub message: String,
    pub help: String,
}

/// The first of the planets at `angles` [rad] that does not fit between `sun` and `ring` teeth, if one fits at the angle `from`.
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

/// Warns of the planets of a derived model that do not fit. Papers take such planets, with constant stiffnesses.
pub(super) fn check(scene: &Scene, report: &mut Report) {
    let angles: Vec<f64> = (1..).map_while(|i| scene.parameter(&format!("psi{i}"))).collect();
    let (Some(sun), Some(ring), Some(first)) = (scene.parameter("Z_s"), scene.parameter("Z_r"), angles.first()) else {
        return;
    };
    if let Some(found) = misfit([sun, ring], &angles, *first, "the stage") {
        report.warn(format!("{}: {}", found.message, found.help));
    }
}
