//! The expected results of a run: computed from settled motions without a run, or extrapolated from a short run.

use super::candidates::Way;
use super::measures::{Apart, Bands, Measures, coordinates};
use super::orbit::{Orbit, Steady, Unknown};
use crate::scene::Scene;

/// Number of speeds at which the settled motion is computed while the rotation slows down.
const SPEEDS: usize = 8;
/// Duration of a short run, as a fraction of the run.
const SHORT: f64 = 0.1;
/// Minimum duration of a short run [pitches], and its maximum as a fraction of the run.
const PITCHES: f64 = 20.0;
const AT_MOST: f64 = 0.5;

/// The expected results of a scene.
#[derive(Debug, Clone)]
pub struct Expected {
    /// The quantities that a run would record.
    pub measures: Measures,
    /// Whether a step is expected to reflect the motion. Then `measures` are not valid.
    pub turned_back: bool,
}

/// The expected results of a scene without the terms that `without` leaves out; `None`: of the scene itself.
///
/// With the jump terms, the energy that damping dissipates comes from the rotation: dT/dt = -(loss per period)/period. The motion is
/// assumed to be settled at every speed.
///
/// # Errors
/// [`Unknown`] if the modes of a cell cannot be computed or a settled motion does not exist.
pub(crate) fn expected(
    scene: &Scene,
    steady: &Steady<'_>,
    bands: &Bands,
    without: Option<Way>,
) -> Result<Expected, Unknown> {
    let (elastic, rolling) = coordinates(scene);
    let mut measures = Measures {
        rms: vec![0.0; elastic.len()],
        peak: vec![0.0; elastic.len()],
        size: elastic.iter().map(|&i| steady.statics[i].abs()).collect(),
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
    measures.size.fill(0.0);
    let mut rate = 0.0;
    for _ in 0..SPEEDS {
        // The speed in the middle of this part of the run, relative to the speed at the start.
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
        measures.size[place] = measures.size[place].max(orbit.size[i]);
        for (order, power) in orbit.lines[i].iter().enumerate() {
            if let Some(at) = bands.index((order + 1) as f64 / orbit.period) {
                measures.bands[place][at] += power / SPEEDS as f64;
            }
        }
    }
}

/// Duration of a short run of a scene [s]; `mesh` is its lowest mesh frequency [Hz], 0 if it has none.
pub(crate) fn short_run(scene: &Scene, mesh: f64) -> f64 {
    let least = if mesh > 0.0 { PITCHES / mesh } else { 0.0 };
    (SHORT * scene.t_end).max(least).min(AT_MOST * scene.t_end)
}

impl Apart {
    /// Extrapolates deviations over the duration `short` \[s\] to the duration `long` \[s\]. Deviations of speed and energy grow in
    /// proportion to the duration, the others stay the same.
    pub fn over(self, short: f64, long: f64) -> Apart {
        let more = long / short;
        Apart { speed: self.speed * more, energy: self.energy * more, ..self }
    }
}
