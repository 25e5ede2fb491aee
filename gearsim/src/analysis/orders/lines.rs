//! The lines that a drivetrain is expected to have: mesh orders and their sidebands.
//!
//! Each amplitude is a Fourier integral over the angle theta \[revolutions\] of the shaft, at the order o of the line. It is exact at o,
//! also if o is not an order of a discrete transform. With the Hann window w over the angle, and x without its mean,
//!
//! ```text
//! A(o) = 2 |sum_n w_n x_n exp(-2 pi i o theta_n) dtheta_n| / sum_n w_n dtheta_n,    dtheta_n = (theta_(n+1) - theta_(n-1))/2
//! ```
//!
//! In a record of R revolutions, another line whose order differs from o by k/R does not change A, for whole k >= 2: there the transform of
//! the window is zero.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;
use rayon::prelude::*;

use super::{Mesh, Turning, term};

/// Multiples of a mesh order that are listed, and those that are listed with their sidebands.
const HARMONICS: usize = 20;
const WITH_SIDEBANDS: usize = 5;
/// Number of listed sidebands on either side of a mesh order, for a gear that is in mesh once a turn.
pub(super) const SIDEBANDS: i32 = 3;
/// Number of lines on either side of a line that belong to it: half the width of the main lobe of the Hann window.
pub(super) const LOBE: f64 = 2.0;
/// Least number of revolutions of a rotor in a record for which its sidebands are separate. Sidebands are as many lines apart as the rotor
/// makes revolutions, and the main lobe of the Hann window is 4 lines wide.
pub const APART: f64 = 4.0;
/// Least number of samples per period of a listed line: above half the sampling rate there are no lines.
const SAMPLES: f64 = 2.5;

/// Samples summed at a time, so that their phasors stay in the cache.
const CHUNK: usize = 2048;

/// A line that a drivetrain is expected to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The mesh, by its first stiffness law.
    pub mesh: &'static str,
    /// The multiple of the mesh order.
    pub harmonic: usize,
    /// The rotor of a sideband; `None`: the multiple itself.
    pub rotor: Option<&'static str>,
    /// Distance from the multiple in orders of the rotor; 0: the multiple itself.
    pub sideband: i32,
    /// Its order, relative to the shaft of the record.
    pub order: f64,
    /// Its frequency at the mean speed \[Hz\].
    pub frequency: f64,
}

impl Line {
    /// The line in words: `2 × k12 - 1 rotor_speed_1`.
    pub fn words(&self) -> String {
        let multiple = format!("{} × {}", self.harmonic, self.mesh);
        match self.rotor {
            None => multiple,
            Some(rotor) => {
                let sign = if self.sideband < 0 { '-' } else { '+' };
                format!("{multiple} {sign} {} {}", self.sideband.abs(), term(rotor))
            }
        }
    }
}

/// The lines of `meshes`, as far as the samples resolve them. A sideband that lies within the main lobe of a multiple of a mesh order is
/// left out.
pub fn lines(turning: &Turning, meshes: &[Mesh]) -> Vec<Line> {
    let shaft = turning.frequency();
    let duration = turning.duration();
    let fastest = turning.angle.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let mut all = vec![];
    for mesh in meshes {
        for harmonic in 1..=HARMONICS {
            let mut add = |rotor: Option<&'static str>, sideband: i32, frequency: f64| {
                let order = frequency / shaft;
                let resolved = order * fastest * SAMPLES <= 1.0
                    && (rotor.is_none() || !in_lobe(frequency, meshes, 1.0 / duration));
                if order > 0.0 && resolved {
                    all.push(Line { mesh: mesh.name, harmonic, rotor, sideband, order, frequency });
                }
            };
            let base = harmonic as f64 * mesh.frequency;
            add(None, 0, base);
            if harmonic > WITH_SIDEBANDS {
                continue;
            }
            for rotor in mesh.rotors.iter().filter(|rotor| rotor.frequency * duration >= APART) {
                for sideband in rotor.sidebands() {
                    add(Some(rotor.name), sideband, base + f64::from(sideband) * rotor.frequency);
                }
            }
        }
    }
    all
}

/// Whether a frequency lies within the main lobe of a multiple of a mesh frequency, where lines are `line` \[Hz\] apart.
pub(crate) fn in_lobe(frequency: f64, meshes: &[Mesh], line: f64) -> bool {
    meshes.iter().any(|mesh| {
        let multiple = (frequency / mesh.frequency).round().max(1.0);
        (frequency - multiple * mesh.frequency).abs() <= LOBE * line
    })
}

impl Turning {
    /// Whether a column has each of `lines`. A multiple of a mesh order always counts. A sideband counts if it is a separate line of the
    /// spectrum: at least three times as high as the median around it.
    pub fn has(&self, column: &[f64], lines: &[Line]) -> Vec<bool> {
        let orders = self.orders(column).ok();
        let stands_out = |order: f64| orders.as_ref().is_some_and(|orders| orders.stands_out(order));
        lines.iter().map(|line| line.rotor.is_none() || stands_out(line.order)).collect()
    }

    /// The length of the record over which lines are computed \[revolutions\]: whole revolutions, so that the sidebands of the shaft lie
    /// where the transform of the window is zero.
    pub(super) fn length(&self) -> f64 {
        let end = self.angle[self.angle.len() - 1];
        if end >= 2.0 { end.floor() } else { end }
    }

    /// The peak amplitudes of `columns` at the order of each of `lines` (lines, columns) [units of the columns]. Another line less than two
    /// lines of the transform away contributes to them.
    pub fn amplitudes(&self, columns: &[&[f64]], lines: &[Line]) -> Vec<Vec<f64>> {
        let all = self.transforms(columns, lines).into_iter();
        all.map(|line| line.into_iter().map(|integral| integral.norm()).collect()).collect()
    }

    /// The Fourier integrals of `columns` at the order of each of `lines` (lines, columns) [units of the columns]. Their magnitudes are peak
    /// amplitudes.
    pub(super) fn transforms(&self, columns: &[&[f64]], lines: &[Line]) -> Vec<Vec<Complex<f64>>> {
        let (last, length) = (self.angle.len() - 1, self.length());
        let inside = self.angle.partition_point(|angle| *angle < length);
        let weight = |i: usize| {
            let step = 0.5 * (self.angle[(i + 1).min(last)] - self.angle[i.saturating_sub(1)]);
            (PI * self.angle[i] / length).sin().powi(2) * step
        };
        let weights: Vec<f64> = (0..inside).map(weight).collect();
        let whole: f64 = weights.iter().sum();
        let weighed = |column: &&[f64]| {
            let x = || self.rows.iter().zip(&weights).map(|(&row, w)| (column[row], w));
            let mean = x().map(|(x, w)| x * w).sum::<f64>() / whole;
            x().map(|(x, w)| (x - mean) * w).collect::<Vec<_>>()
        };
        let columns: Vec<Vec<f64>> = columns.iter().map(weighed).collect();
        let at = |line: &Line| {
            let mut sums = vec![(0.0, 0.0); columns.len()];
            let mut phasors = Vec::with_capacity(CHUNK);
            for begin in (0..inside).step_by(CHUNK) {
                let chunk = begin..inside.min(begin + CHUNK);
                phasors.clear();
                phasors.extend(self.angle[chunk.clone()].iter().map(|a| (TAU * (line.order * a).fract()).sin_cos()));
                for (sum, column) in sums.iter_mut().zip(&columns) {
                    let add = |sum: (f64, f64), (x, p): (&f64, &(f64, f64))| (sum.0 + x * p.0, sum.1 + x * p.1);
                    *sum = column[chunk.clone()].iter().zip(&phasors).fold(*sum, add);
                }
            }
            let integral = |(sine, cosine): (f64, f64)| Complex::new(cosine, -sine) * (2.0 / whole);
            sums.into_iter().map(integral).collect()
        };
        // Each line is summed by itself: the result does not depend on the number of threads. Rayon's global threads would panic where the
        // system starts no further thread.
        match rayon::ThreadPoolBuilder::new().build() {
            Ok(pool) => pool.install(|| lines.par_iter().map(at).collect()),
            Err(_) => lines.iter().map(at).collect(),
        }
    }
}
