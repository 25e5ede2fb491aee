//! What a run recorded, in few numbers, and how far two runs are apart in them.

use crate::analysis::spectrum::{segment_length, uniform_samples, welch};
use crate::model::Model;
use crate::run::Outcome;
use crate::trajectory::{Moment, Trajectory};

/// Frequency bands, each as wide as whole mesh orders.
#[derive(Debug, Clone, PartialEq)]
pub struct Bands {
    /// Lower end of the first [Hz].
    pub from: f64,
    /// Width of each [Hz].
    pub width: f64,
    /// How many there are.
    pub count: usize,
}

/// A run in few numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// Root mean square of each elastic coordinate about its mean.
    pub rms: Vec<f64>,
    /// Greatest amount of each elastic coordinate.
    pub peak: Vec<f64>,
    /// Power of each elastic coordinate in each band.
    pub bands: Vec<Vec<f64>>,
    /// Mean speed of each coordinate that rolls on, over the last tenth of the run.
    pub speed: Vec<f64>,
    /// U = T + V - W at the end [J].
    pub energy: f64,
    /// T + V at the start [J].
    pub at_start: f64,
    /// Steps met.
    pub events: f64,
    /// Of them, those that turned the motion back.
    pub reflections: u64,
}

/// How far apart two runs are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// Of the root mean squares, relative: the worst coordinate.
    pub rms: f64,
    /// Of the peaks, relative: the worst coordinate.
    pub peak: f64,
    /// Of the power in a band \[dB\]: the worst band of the worst coordinate.
    pub bands: f64,
    /// Of the speed at the end, relative.
    pub speed: f64,
    /// Of the energy at the end, over that at the start.
    pub energy: f64,
    /// Of the number of events, relative.
    pub events: f64,
}

/// Power of a coordinate in a band, over that in all, below which the band says nothing.
const FAINT: f64 = 1e-6;
/// Motion of a coordinate, over the largest of its unit, that is rounding.
const ROUNDING: f64 = 1e-9;
/// Events that the ends of a run may cut off.
const COUNTED: f64 = 2.0;
/// A difference that has no end, such as a band that is empty [dB].
const SILENT: f64 = 200.0;

impl Bands {
    /// Whole orders of the mesh frequency `mesh`, 0.4 of the natural frequency `natural` at least, up to `end` [Hz].
    pub fn of(mesh: f64, natural: f64, end: f64) -> Bands {
        let width = (0.4 * natural / mesh).ceil().max(1.0) * mesh;
        let from = 0.5 * mesh;
        Bands { from, width, count: ((end - from) / width).floor().clamp(1.0, 1000.0) as usize }
    }

    /// The band of a frequency [Hz].
    pub fn index(&self, frequency: f64) -> Option<usize> {
        let at = ((frequency - self.from) / self.width).floor();
        (at >= 0.0 && at < self.count as f64).then_some(at as usize)
    }
}

/// The coordinates that do not roll on, and those that do.
pub fn coordinates(model: &Model) -> (Vec<usize>, Vec<usize>) {
    let rolls = |i: &usize| model.laws.iter().any(|law| law.rolling && law.phase == model.coordinates[*i].name);
    let (rolling, elastic) = (0..model.coordinates.len()).partition(rolls);
    (elastic, rolling)
}

impl Measures {
    /// Those of a run.
    pub fn of(outcome: &Outcome, bands: &Bands) -> Measures {
        let run = &outcome.trajectory;
        let (elastic, rolling) = coordinates(run.model);
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
            peak: elastic.iter().map(|&i| run.q[i].iter().fold(0.0f64, |m, x| m.max(x.abs()))).collect(),
            bands: elastic.iter().map(powers).collect(),
            speed: rolling.iter().map(|&i| mean(&column(&run.q_dot[i])[late..])).collect(),
            energy: run.energy(last),
            at_start: outcome.energy_at_start,
            events: instants(run).unwrap_or(counts.events()) as f64,
            reflections: counts.reflections,
        }
    }

    /// How far `other` is from this one, whose numbers are the measure.
    pub fn apart(&self, other: &Measures, units: &[&str]) -> Apart {
        let worst = |mine: &[f64], theirs: &[f64]| {
            let each = (0..mine.len()).map(|i| {
                let largest = (0..mine.len()).filter(|&j| units[j] == units[i]);
                let largest = largest.fold(0.0f64, |m, j| m.max(mine[j]).max(theirs[j]));
                let rounding = mine[i].max(theirs[i]) <= ROUNDING * largest;
                if rounding { 0.0 } else { relative(theirs[i], mine[i]) }
            });
            each.fold(0.0, f64::max)
        };
        let total = |powers: &[f64]| powers.iter().sum::<f64>();
        let decibels = (0..self.bands.len()).flat_map(|i| {
            let (mine, theirs) = (&self.bands[i], &other.bands[i]);
            let sounds = self.rms[i].max(other.rms[i]) > ROUNDING * self.peak[i].max(other.peak[i]);
            let faint = FAINT * total(mine).max(total(theirs));
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
            events: if (other.events - self.events).abs() <= COUNTED {
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

    /// All of them, in the order of their declaration.
    pub fn each(&self) -> [f64; 6] {
        [self.rms, self.peak, self.bands, self.speed, self.energy, self.events]
    }
}

/// Instants at which something happens; `None` where events are not recorded. Steps that meshes of one phase meet together are one
/// event to the motion, and several where each steps by the time alone: counts of events do not compare, instants do.
fn instants(run: &Trajectory) -> Option<u64> {
    let end = run.t.last().copied().unwrap_or(0.0);
    let mut last = f64::NEG_INFINITY;
    let after = (0..run.len()).filter(|&i| run.moment[i] == Moment::After).map(|i| run.t[i]);
    let count = after.filter(|t| *t - std::mem::replace(&mut last, *t) > 1e-10 * end).count() as u64;
    (count > 0).then_some(count)
}

/// |b - a|/|a|; 0 where both are 0.
fn relative(b: f64, a: f64) -> f64 {
    if b == a { 0.0 } else { ((b - a) / a).abs() }
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len() as f64
}

/// Root mean square about the mean.
fn deviation(x: &[f64]) -> f64 {
    let middle = mean(x);
    (x.iter().map(|x| (x - middle).powi(2)).sum::<f64>() / x.len() as f64).sqrt()
}
