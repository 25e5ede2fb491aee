//! A random cell, its start, and the boundary that it may meet.

use gearsim_tests::precise;
use gearsim_tests::precise::cell::Motion;

use super::phase::{Phase, bound};
use crate::linear::Linear;
use crate::noise::Noise;

/// A cell in modal coordinates. All coordinates start at 0 with the speeds `v`.
#[derive(Debug, Clone)]
pub struct Drawn<const N: usize> {
    pub system: Linear<N>,
    pub v: [f64; N],
    /// Distance of the boundary that may be met.
    pub level: f64,
    /// Distance of the other boundary, which is not reached.
    pub far: f64,
    /// Length of the search [s].
    pub horizon: f64,
    /// Whether the boundary at `level` is the upper one.
    pub upper: bool,
    /// Whether the level is at a crest of the phase.
    pub grazing: bool,
}

impl<const N: usize> Drawn<N> {
    /// Draws a cell. If `to_graze`, the level is at a crest of the phase that is higher than all before, if there is one: about half
    /// of these cells have one.
    pub fn new(noise: &mut Noise, to_graze: bool) -> Self {
        // Frequencies over up to four and a half decades: stiffness ratios up to 1e9.
        let (unit, spread) = (noise.power(-3.0, 3.0), 4.5 * noise.unit().powi(2));
        let modes = [(); N].map(|()| mode(noise, unit, spread));
        let busiest = modes.iter().filter(|(sigma, w2)| sigma * sigma < 0.1 * w2).map(|(_, w2)| w2.sqrt());
        let rate = busiest.fold(0.0, f64::max);
        let horizon = if rate > 0.0 { noise.power(0.0, 2.0) / rate } else { noise.power(-1.0, 2.0) / unit };
        // The reference bounds rounding errors by sigma t. Searches over modes that do not oscillate therefore last at most a hundred decay
        // times.
        let strongest = modes.iter().filter(|(sigma, w2)| sigma * sigma > 0.1 * w2).map(|(sigma, _)| *sigma);
        let horizon = strongest.fold(horizon, |t, sigma| t.min(100.0 / sigma));
        let each = |(sigma, w2): (f64, f64), noise: &mut Noise| {
            let rate = w2.sqrt().max(1.0 / horizon);
            (noise.even() * rate.max(sigma * noise.unit()), noise.even() * rate * rate)
        };
        let start = modes.map(|mode| each(mode, noise));
        let mut system = Linear::modal(modes, start.map(|(_, f)| f));
        system.normal = [(); N].map(|()| noise.even());
        let mut drawn =
            Drawn { system, v: start.map(|(v, _)| v), level: 0.0, far: 0.0, horizon, upper: true, grazing: false };
        if let Some((crest, height)) = to_graze.then(|| drawn.crest(noise)).flatten() {
            drawn.graze(noise, crest, height);
        }
        if !drawn.grazing {
            drawn.far = drawn.reach();
            drawn.level = 0.5 * noise.unit() * drawn.far;
            drawn.far *= 2.0;
        }
        if noise.unit() < 0.5 {
            drawn.upper = false;
            drawn.system.normal = drawn.system.normal.map(|x| -x);
        }
        drawn
    }

    /// Puts the level within 1e-12, relative, above or below a crest with this `height` at the time `crest`.
    fn graze(&mut self, noise: &mut Noise, crest: f64, mut height: f64) {
        self.grazing = true;
        self.far = 2.0 * self.reach();
        if noise.unit() < 0.25 {
            // Starts just before the crest, in a cell that is narrow compared with the swing.
            let before = noise.power(-4.0, -0.5) * crest;
            for (i, (m, _)) in self.phase().0.iter().enumerate() {
                let [_, v, a] = m.at(&(crest - before));
                self.v[i] = v;
                self.system.load[i] = a + self.system.damping[i][i] * v;
            }
            self.horizon = 2.0 * before;
            let phase = self.phase();
            height = phase.top(0.0, self.horizon).1;
            self.far = 2.0 * self.reach();
            self.grazing = height > 0.0 && phase.at(self.horizon)[1] < 0.0 && phase.at(0.0)[1] > 0.0;
        }
        let depth = match noise.below(8) {
            0 => 0.0,
            _ => noise.power(-16.0, -12.0) * noise.even().signum(),
        };
        self.level = height * (1.0 - depth);
    }

    /// The time and the height of a crest of the phase that is higher than all before.
    fn crest(&self, noise: &mut Noise) -> Option<(f64, f64)> {
        let (phase, samples) = (self.phase(), 20 * N);
        let time = |i: usize| self.horizon * i as f64 / samples as f64;
        let (mut crests, mut most, mut rising) = (vec![], 0.0, phase.at(0.0)[1] > 0.0);
        for i in 1..=samples {
            let before = std::mem::replace(&mut rising, phase.at(time(i))[1] > 0.0);
            if before && !rising {
                let top = phase.top(time(i - 1), time(i));
                if top.1 > most {
                    most = top.1;
                    crests.push(top);
                }
            }
        }
        (!crests.is_empty()).then(|| crests[noise.below(crests.len())])
    }

    fn phase(&self) -> Phase<N> {
        Phase(std::array::from_fn(|i| (Motion::from(&self.mode(i)), self.system.normal[i])))
    }

    /// Mode `i` as the reference describes it.
    fn mode(&self, i: usize) -> precise::Mode {
        let Linear { damping, stiffness, load, normal, .. } = &self.system;
        let (sigma, omega2) = (0.5 * damping[i][i], stiffness[i][i]);
        precise::Mode { sigma, omega2, force: load[i], x: 0.0, v: self.v[i], weight: normal[i] }
    }

    /// A bound on the distance that the phase moves until the horizon; not a tight one.
    fn reach(&self) -> f64 {
        (0..N).map(|i| self.mode(i)).map(|m| m.weight.abs() * bound(&m, self.horizon)).sum()
    }
}

/// (sigma, omega²) of a mode: any damping, with and without stiffness.
fn mode(noise: &mut Noise, unit: f64, spread: f64) -> (f64, f64) {
    let omega = unit * 10f64.powf(spread * noise.unit());
    let zeta = match noise.below(20) {
        0..6 => 0.0,
        6..12 => noise.power(-6.0, -0.3),
        12..15 => 1.0 + noise.power(-14.0, -1.0) * noise.even().signum(),
        15..18 => noise.power(0.3, 6.0),
        18 => return (0.0, 0.0),
        _ => return (omega, 0.0),
    };
    (zeta * omega, omega * omega)
}
