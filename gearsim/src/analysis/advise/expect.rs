//! What a run is expected to record, without running it; or from a short run, where the numbers do not tell.

use super::candidates::Way;
use super::measures::{Apart, Bands, Measures, coordinates};
use super::orbit::{Orbit, Steady, Unknown};
use crate::scene::Scene;

/// Speeds at which the settled motion is looked at, on the way down.
const SPEEDS: usize = 8;
/// Part of a run that is short.
const SHORT: f64 = 0.1;
/// Pitches that a short run has, at least, and the part of the run that it has at most.
const PITCHES: f64 = 20.0;
const AT_MOST: f64 = 0.5;

/// What is expected of a scene.
#[derive(Debug, Clone)]
pub struct Expected {
    /// As a run would record it.
    pub measures: Measures,
    /// Whether a step is expected to turn the motion back, which ends what this can tell.
    pub turned_back: bool,
}

/// What a scene is expected to record, with what the way leaves out; `None` is the scene itself.
///
/// With the jump terms, what damping takes a pitch is taken from the rotation: dT/dt = -loss a period/period. The motion is settled
/// at every speed on the way.
///
/// # Errors
/// Where a cell has no modes.
pub fn expected(scene: &Scene, steady: &Steady<'_>, bands: &Bands, without: Option<Way>) -> Result<Expected, Unknown> {
    let (elastic, rolling) = coordinates(scene.model);
    let mut measures = Measures {
        rms: vec![0.0; elastic.len()],
        peak: elastic.iter().map(|&i| steady.statics[i].abs()).collect(),
        bands: vec![vec![0.0; bands.count]; elastic.len()],
        speed: vec![1.0; rolling.len()],
        energy: 0.0,
        at_start: steady.rolling,
        events: 0.0,
        reflections: 0,
    };
    if without == Some(Way::WithoutSteps) {
        return Ok(Expected { measures, turned_back: false });
    }
    let jumps = without.is_none();
    let (mut left, mut turned_back) = (1.0f64, false);
    let part = scene.t_end / SPEEDS as f64;
    measures.peak.fill(0.0);
    let mut rate = 0.0;
    for _ in 0..SPEEDS {
        // In the middle of this part of the run.
        let factor = (left - 0.5 * rate * part).max(f64::MIN_POSITIVE).sqrt();
        let orbit = steady.orbit(factor, jumps)?;
        add(&mut measures, &orbit, &elastic, bands);
        measures.events += orbit.steps as f64 * part / orbit.period;
        if !jumps {
            continue;
        }
        if orbit.strength >= 1.0 {
            turned_back = true;
            break;
        }
        rate = orbit.lost / orbit.period / steady.rolling;
        left -= rate * part;
        if left <= 0.05 {
            turned_back = true;
            break;
        }
    }
    measures.rms.iter_mut().for_each(|x| *x = x.sqrt());
    measures.speed.fill(left.max(0.0).sqrt());
    measures.energy = -(1.0 - left) * steady.rolling;
    measures.reflections = u64::from(turned_back);
    Ok(Expected { measures, turned_back })
}

fn add(measures: &mut Measures, orbit: &Orbit, elastic: &[usize], bands: &Bands) {
    for (place, &i) in elastic.iter().enumerate() {
        measures.rms[place] += orbit.square[i] / SPEEDS as f64;
        measures.peak[place] = measures.peak[place].max(orbit.peak[i]);
        for (order, power) in orbit.lines[i].iter().enumerate() {
            if let Some(at) = bands.index((order + 1) as f64 / orbit.period) {
                measures.bands[place][at] += power / SPEEDS as f64;
            }
        }
    }
}

/// A scene that is run shortly: its time [s].
pub fn short_run(scene: &Scene, mesh: f64) -> f64 {
    let least = if mesh > 0.0 { PITCHES / mesh } else { 0.0 };
    (SHORT * scene.t_end).max(least).min(AT_MOST * scene.t_end)
}

impl Apart {
    /// What a deviation over a time `short` [s] becomes over `long`: what adds up does so, the rest stays.
    pub fn over(self, short: f64, long: f64) -> Apart {
        let more = long / short;
        Apart { speed: self.speed * more, energy: self.energy * more, ..self }
    }
}
