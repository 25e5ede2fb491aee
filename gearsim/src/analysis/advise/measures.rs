//! The results of a run in a few numbers, and the deviations between the results of two runs.

use crate::analysis::spectrum::{segment_length, uniform_samples, welch};
use crate::run::Outcome;
use crate::scene::Scene;
use crate::tolerance::analysis::{COUNTED_EVENTS, FAINT_BAND, NO_MOTION, SAME_INSTANT};
use crate::trajectory::{Moment, Trajectory};

/// Frequency bands, each a whole number of mesh orders wide.
#[derive(Debug, Clone, PartialEq)]
pub struct Bands {
    /// Lower end of the first band \[Hz\].
    pub from: f64,
    /// Width of each band \[Hz\].
    pub width: f64,
    /// Number of bands.
    pub count: usize,
}

/// The results of a run in a few numbers. Elastic coordinates are those that do not rotate continuously.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// Root mean square of each elastic coordinate about its mean \[SI\].
    pub rms: Vec<f64>,
    /// Largest deviation of each elastic coordinate from its mean \[SI\]. The mean itself is not compared: it contains half the backlash,
    /// which causes no force.
    pub peak: Vec<f64>,
    /// Largest absolute value of each elastic coordinate \[SI\]: the scale of its rounding errors.
    pub size: Vec<f64>,
    /// Power of each elastic coordinate in each band \[SI²\].
    pub bands: Vec<Vec<f64>>,
    /// Mean speed of each continuously rotating coordinate over the last tenth of the samples \[SI\]. In an expected result it is the speed
    /// at the end, relative to the speed at the start.
    pub speed: Vec<f64>,
    /// U = T + V - W at the end \[J\].
    pub energy: f64,
    /// T + V at the start \[J\].
    pub at_start: f64,
    /// Number of events. Events at the same time count once.
    pub events: f64,
    /// Number of reflections among them.
    pub reflections: u64,
}

/// The deviations of two runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// Relative deviation of the root mean square, of the worst coordinate.
    pub rms: f64,
    /// Relative deviation of the peak, of the worst coordinate.
    pub peak: f64,
    /// Deviation of the power in a band \[dB\], of the worst band of the worst coordinate.
    pub bands: f64,
    /// Relative deviation of the speed at the end, of the worst coordinate.
    pub speed: f64,
    /// Deviation of the energy at the end, over the energy at the start.
    pub energy: f64,
    /// Relative deviation of the number of events.
    pub events: f64,
}

/// Maximum deviation of a band [dB], e.g. if the band is empty in one run.
const SILENT: f64 = 200.0;

impl Bands {
    /// Bands from half the mesh frequency `mesh` up to `end` \[Hz\]. Their width is a whole number of mesh orders, and at least 0.4 of
    /// the natural frequency `natural` \[Hz\].
    pub fn of(mesh: f64, natural: f64, end: f64) -> Bands {
        let width = (0.4 * natural / mesh).ceil().max(1.0) * mesh;
        let from = 0.5 * mesh;
        Bands { from, width, count: ((end - from) / width).floor().clamp(1.0, 1000.0) as usize }
    }

    /// Index of the band that contains a frequency \[Hz\].
    pub fn index(&self, frequency: f64) -> Option<usize> {
        let at = ((frequency - self.from) / self.width).floor();
        (at >= 0.0 && at < self.count as f64).then_some(at as usize)
    }
}

/// Indices of the coordinates that do not rotate continuously in a scene, and of those that do.
pub(crate) fn coordinates(scene: &Scene) -> (Vec<usize>, Vec<usize>) {
    let turns = |i: &usize| scene.effects.turns(scene.model.coordinates[*i].name, scene.model);
    let (rolling, elastic) = (0..scene.model.coordinates.len()).partition(turns);
    (elastic, rolling)
}

impl Measures {
    /// The measures of a run. `scene` says which coordinates are elastic and which rotate: it is the scene with which the run is compared.
    pub fn of(outcome: &Outcome, scene: &Scene, bands: &Bands) -> Measures {
        let run = &outcome.trajectory;
        let (elastic, rolling) = coordinates(scene);
        let samples: Vec<usize> = run.samples().collect();
        let column = |of: &[f64]| samples.iter().map(|&row| of[row]).collect::<Vec<_>>();
        let even = uniform_samples(run).ok();
        let powers = |i: &usize| {
            let mut powers = vec![0.0; bands.count];
            let Some((rows, rate)) = &even else { return powers };
            let x: Vec<f64> = rows.iter().map(|&row| run.q[*i][row]).collect();
            let Ok(spectrum) = welch(&x, *rate, segment_length(x.len())) else { return powers };
            for (f, p) in spectrum.frequency.iter().zip(&spectrum.density) {
                if let Some(at) = bands.index(*f) {
                    powers[at] += p * spectrum.resolution();
                }
            }
            powers
        };
        let last = run.len().saturating_sub(1);
        let late = samples.len() - samples.len().div_ceil(10);
        let counts = &outcome.counts;
        Measures {
            rms: elastic.iter().map(|&i| deviation(&column(&run.q[i]))).collect(),
            peak: elastic.iter().map(|&i| largest(&run.q[i], mean(&column(&run.q[i])))).collect(),
            size: elastic.iter().map(|&i| largest(&run.q[i], 0.0)).collect(),
            bands: elastic.iter().map(powers).collect(),
            speed: rolling.iter().map(|&i| mean(&column(&run.q_dot[i])[late..])).collect(),
            energy: run.energy(last),
            at_start: outcome.energy_at_start,
            events: instants(run).unwrap_or(counts.events()) as f64,
            reflections: counts.reflections,
        }
    }

    /// The deviation of `other` from this run, relative to this run. `units` are those of the elastic coordinates.
    pub fn apart(&self, other: &Measures, units: &[&str]) -> Apart {
        let worst = |mine: &[f64], theirs: &[f64]| {
            let each = (0..mine.len()).map(|i| {
                let largest = (0..mine.len()).filter(|&j| units[j] == units[i]);
                let largest = largest.fold(0.0f64, |m, j| m.max(self.size[j]).max(other.size[j]));
                let rounding = mine[i].max(theirs[i]) <= NO_MOTION * largest;
                if rounding { 0.0 } else { relative(theirs[i], mine[i]) }
            });
            each.fold(0.0, f64::max)
        };
        let total = |powers: &[f64]| powers.iter().sum::<f64>();
        let decibels = (0..self.bands.len()).flat_map(|i| {
            let (mine, theirs) = (&self.bands[i], &other.bands[i]);
            let sounds = self.rms[i].max(other.rms[i]) > NO_MOTION * self.size[i].max(other.size[i]);
            let faint = FAINT_BAND * total(mine).max(total(theirs));
            mine.iter().zip(theirs).map(move |(a, b)| match a.max(*b) > faint && sounds {
                true => (10.0 * (b / a).log10()).abs().min(SILENT),
                false => 0.0,
            })
        });
        let speeds = self.speed.iter().zip(&other.speed).map(|(a, b)| relative(*b, *a));
        Apart {
            rms: worst(&self.rms, &other.rms),
            peak: worst(&self.peak, &other.peak),
            bands: decibels.fold(0.0, f64::max),
            speed: speeds.fold(0.0, f64::max),
            energy: if self.at_start == 0.0 { 0.0 } else { ((other.energy - self.energy) / self.at_start).abs() },
            events: if (other.events - self.events).abs() <= COUNTED_EVENTS {
                0.0
            } else {
                relative(other.events, self.events)
            },
        }
    }
}

impl Apart {
    /// Whether every deviation is within its limit.
    pub fn within(&self, limits: &Apart) -> bool {
        self.each().iter().zip(limits.each()).all(|(x, limit)| *x <= limit)
    }

    /// The names of the deviations.
    pub const NAMES: [&str; 6] = ["rms", "peak", "bands", "speed", "energy", "events"];

    /// All deviations, in the order of [`Apart::NAMES`].
    pub fn each(&self) -> [f64; 6] {
        [self.rms, self.peak, self.bands, self.speed, self.energy, self.events]
    }

    /// All deviations as texts, in % and dB.
    pub fn in_words(&self) -> [String; 6] {
        let mut words = self.each().map(percent);
        words[2] = decibels(self.bands);
        words
    }
}

/// A deviation in dB, as text. At the maximum, 200 dB, a band is empty in one of the two runs.
fn decibels(x: f64) -> String {
    if x >= 0.995 * SILENT { "all".into() } else { format!("{x:.2} dB") }
}

fn percent(x: f64) -> String {
    match 100.0 * x {
        p if !p.is_finite() => "-".into(),
        p if p >= 1000.0 => ">1000 %".into(),
        p if p >= 10.0 => format!("{p:.0} %"),
        p if p >= 0.01 || p == 0.0 => format!("{p:.2} %"),
        _ => "<0.01 %".into(),
    }
}

/// Number of distinct times with an event; `None` if no events are recorded. Distinct times are counted instead of events: steps that
/// several meshes of one phase meet together are one event in the exact equations, but several events if the phase is frozen.
fn instants(run: &Trajectory) -> Option<u64> {
    let end = run.t.last().copied().unwrap_or(0.0);
    let mut last = f64::NEG_INFINITY;
    let after = (0..run.len()).filter(|&i| run.moment[i] == Moment::After).map(|i| run.t[i]);
    let count = after.filter(|t| *t - std::mem::replace(&mut last, *t) > SAME_INSTANT * end).count() as u64;
    (count > 0).then_some(count)
}

/// |b - a|/|a|; 0 where both are 0.
fn relative(b: f64, a: f64) -> f64 {
    if b == a { 0.0 } else { ((b - a) / a).abs() }
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len() as f64
}

/// Largest distance of a number from `middle`.
fn largest(x: &[f64], middle: f64) -> f64 {
    x.iter().fold(0.0f64, |m, x| m.max((x - middle).abs()))
}

/// Root mean square about the mean.
fn deviation(x: &[f64]) -> f64 {
    let middle = mean(x);
    (x.iter().map(|x| (x - middle).powi(2)).sum::<f64>() / x.len() as f64).sqrt()
}
