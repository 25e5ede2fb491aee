//! Order spectra: amplitudes over the frequency divided by that of a shaft.
//!
//! The samples are interpolated at equal angles of the shaft before the transform, so that lines stay sharp while the speed varies.
//! The record is cut to whole revolutions. With the Hann window w and N values x_n at equal angles, without their mean, the amplitude
//! of order m/(4 R) in a record of R revolutions is
//!
//! ```text
//! A_m = 2 |sum_n w_n x_n exp(-2 pi i m n/(4 N))| / sum_n w_n,    m > 0
//! ```
//!
//! the peak amplitude of a line at that order. The orders are four times as close as independent lines would be: a line between two of them
//! loses at most 1 % of its amplitude, instead of 15 %. Sources: K. R. Fyfe, E. D. S. Munck, Mech. Syst. Signal Process. 11 (1997) 187-205
//! (computed order tracking); G. Heinzel, A. Rüdiger, R. Schilling (2002), Eq. (24) (window correction).

mod cuts;
mod lines;
mod listed;
mod meshes;
mod planets;

pub use cuts::{Cut, Window, cuts, windows};
pub(crate) use lines::in_lobe;
pub use lines::{APART, Line, lines};
pub use listed::Listed;
pub use meshes::{Mesh, Rotor, force, meshes, play, term};

use realfft::RealFftPlanner;

use crate::analysis::spectrum::{SpectrumError, hann, highest, uniform_samples_from};
use crate::model::Output;
use crate::trajectory::Trajectory;

/// The unit of the outputs that may give the angle of a shaft.
pub const SHAFT: &str = "rad/s";

/// Amplitudes over orders of a shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Orders {
    /// Orders, evenly spaced from 0 \[1\].
    pub order: Vec<f64>,
    /// Peak amplitude at each order [unit of the signal].
    pub amplitude: Vec<f64>,
    /// Whole revolutions of the shaft in the record.
    pub revolutions: usize,
}

impl Orders {
    /// The order above which less than a fraction `share` of the power lies \[1\].
    pub fn highest(&self, share: f64) -> f64 {
        highest(&self.order, self.amplitude.iter().map(|a| a * a), share)
    }

    /// The amplitude at `order`, interpolated between the orders of the spectrum; `None` beyond the last order. Lines up to [`BANDWIDTH`]/2
    /// lines away contribute to it.
    pub fn at(&self, order: f64) -> Option<f64> {
        let amplitude = interpolated(&self.amplitude, order * (self.revolutions * CLOSER) as f64)?;
        Some(amplitude.max(0.0))
    }

    /// Whether the spectrum has a separate line at `order`.
    fn stands_out(&self, order: f64) -> bool {
        stands_out(&self.amplitude, order * (self.revolutions * CLOSER) as f64, CLOSER as f64, |x| PROMINENCE * x)
    }
}

/// A line counts as noise if its amplitude over the median of the amplitudes around it is at most this \[1\].
pub(crate) const PROMINENCE: f64 = 3.0;
/// Number of lines on either side of a line over which this median is taken.
const ABOUT: f64 = 12.0;

/// Whether a curve has a separate line at a `place` between its points. The curve must be higher there than at the distance `line` on
/// either side, and higher than `least` of the median of the curve around it. A line has half its height at this distance. On the skirt of
/// another line, the curve is higher on one side.
pub(crate) fn stands_out(y: &[f64], place: f64, line: f64, least: impl Fn(f64) -> f64) -> bool {
    let at = |place| interpolated(y, place);
    let higher = |than: Option<f64>| at(place).zip(than).is_some_and(|(here, there)| here > there);
    higher(at(place - line)) && higher(at(place + line)) && higher(median_about(y, place, ABOUT * line).map(least))
}

/// The median of the values of a curve up to `reach` points from a place. The first point is left out: it is the remainder of the mean.
fn median_about(y: &[f64], place: f64, reach: f64) -> Option<f64> {
    let (first, end) = ((place - reach).max(1.0) as usize, ((place + reach) as usize + 1).min(y.len()));
    let mut about: Vec<f64> = y.get(first..end)?.iter().copied().filter(|y| !y.is_nan()).collect();
    about.sort_by(f64::total_cmp);
    about.get(about.len() / 2).copied()
}

/// Width of the band that the Hann window passes with less than 3 dB of loss \[lines\]. An order has R lines. F. J. Harris, Proc. IEEE 66
/// (1978) 51-83, Table 1.
pub const BANDWIDTH: f64 = 1.44;

/// The value at a `place` between two points of a curve with evenly spaced points: that of the parabola through the three nearest points.
fn interpolated(y: &[f64], place: f64) -> Option<f64> {
    if y.len() < 3 || !(0.0..=(y.len() - 1) as f64).contains(&place) {
        return None;
    }
    let middle = (place.round() as usize).clamp(1, y.len() - 2);
    let (before, at, after) = (y[middle - 1], y[middle], y[middle + 1]);
    let d = place - middle as f64;
    Some(at + 0.5 * d * (after - before) + 0.5 * d * d * (after - 2.0 * at + before))
}

/// Number of orders of a spectrum per line; lines are 1/R apart. Zeros appended to the samples interpolate the transform.
pub(crate) const CLOSER: usize = 4;

/// Evenly spaced samples of a run, with the angle of a shaft.
#[derive(Debug, Clone)]
pub struct Turning {
    /// The rows of the trajectory.
    pub rows: Vec<usize>,
    /// Angle of the shaft at each row, from the first row \[revolutions\].
    pub angle: Vec<f64>,
    /// The sampling rate \[Hz\].
    pub rate: f64,
}

/// Revolutions that a spectrum over orders needs to separate neighbouring orders: the main lobe of the Hann window is 4 lines wide.
const ENOUGH: f64 = 4.0;

/// The shaft to which orders refer. If `asked` names a recorded output, it is the shaft with this speed. Otherwise it is the first recorded
/// rotor that makes at least four revolutions and turns in a fixed ratio to a mesh: a motor behind a freewheel has no constant mesh orders.
/// If there is none, it is the first rotor that makes at least four revolutions, or else the rotor that makes the most revolutions.
pub fn reference_shaft(run: &Trajectory, asked: Option<&str>) -> Option<&'static Output> {
    if let Some(found) = run.outputs.iter().find(|(output, _)| asked == Some(output.name)) {
        return Some(found.0);
    }
    let samples: Vec<usize> = run.samples().collect();
    let duration = run.t.last()? - run.t.first()?;
    let turns = |column: &[f64]| {
        let mean = samples.iter().map(|&row| column[row]).sum::<f64>() / samples.len().max(1) as f64;
        mean.abs() * duration / std::f64::consts::TAU
    };
    let shafts = run.outputs.iter().filter(|(output, _)| output.unit == SHAFT);
    let shafts: Vec<_> = shafts.map(|(output, column)| (*output, turns(column))).collect();
    let meshes = meshes(run, 0.0);
    let geared = |output: &Output| meshes.iter().any(|mesh| mesh.geared.contains(&output.name));
    let enough = || shafts.iter().filter(|(_, turns)| *turns >= ENOUGH);
    let enough = enough().find(|(output, _)| geared(output)).or_else(|| enough().next());
    let most = || shafts.iter().rev().max_by(|a, b| a.1.total_cmp(&b.1));
    enough.or_else(most).map(|(output, _)| *output)
}

impl Turning {
    /// The samples of a run from the time `from` \[s\] on, with the angle of the shaft whose speed is the recorded output `shaft`.
    ///
    /// # Errors
    /// [`SpectrumError::NotTurning`] if the output is not recorded, or if the shaft stands or turns back; those of
    /// [`uniform_samples_from`].
    pub fn of(run: &Trajectory, shaft: &str, from: f64) -> Result<Turning, SpectrumError> {
        let not_turning = || SpectrumError::NotTurning { shaft: shaft.to_owned() };
        let (rows, rate) = uniform_samples_from(run, from)?;
        if rows.len() < 4 {
            return Err(SpectrumError::TooShort { samples: rows.len() });
        }
        let speed = run.output(shaft).ok_or_else(not_turning)?;
        let speed: Vec<f64> = rows.iter().map(|&row| speed[row] / std::f64::consts::TAU).collect();
        let backwards = speed.iter().sum::<f64>() < 0.0;
        let mut angle = integral(&speed, 1.0 / rate);
        if backwards {
            angle.iter_mut().for_each(|angle| *angle = -*angle);
        }
        if angle.windows(2).any(|pair| pair[1].partial_cmp(&pair[0]) != Some(std::cmp::Ordering::Greater)) {
            return Err(not_turning());
        }
        Ok(Turning { rows, angle, rate })
    }

    /// The mean number of revolutions a second of the shaft \[Hz\].
    pub fn frequency(&self) -> f64 {
        self.angle[self.angle.len() - 1] * self.rate / (self.angle.len() - 1) as f64
    }

    /// The time of the record \[s\].
    pub fn duration(&self) -> f64 {
        (self.angle.len() - 1) as f64 / self.rate
    }

    /// Whole revolutions.
    pub fn revolutions(&self) -> usize {
        self.angle.last().map_or(0, |angle| angle.floor() as usize)
    }

    /// The orders of all spectra of these samples \[1\].
    ///
    /// # Errors
    /// [`SpectrumError::NoRevolution`] if there is less than one revolution, [`SpectrumError::TooShort`].
    pub fn axis(&self) -> Result<Vec<f64>, SpectrumError> {
        let n = self.values()?;
        Ok((0..CLOSER * n / 2 + 1).map(|m| m as f64 / (CLOSER * self.revolutions()) as f64).collect())
    }

    /// Number of values at equal angles in a spectrum. It is at most the number of samples, since the interpolation adds no content.
    fn values(&self) -> Result<usize, SpectrumError> {
        let revolutions = self.revolutions();
        let n = (self.rows.len() as f64 * revolutions as f64 / self.angle[self.angle.len() - 1]) as usize / 2 * 2;
        match (revolutions, n) {
            (0, _) => Err(SpectrumError::NoRevolution { turned: self.angle[self.angle.len() - 1] }),
            (_, ..4) => Err(SpectrumError::TooShort { samples: n }),
            _ => Ok(n),
        }
    }

    /// The order spectrum of a column of the trajectory.
    ///
    /// # Errors
    /// [`SpectrumError::NoRevolution`] if there is less than one revolution, [`SpectrumError::TooShort`], [`SpectrumError::NotFinite`].
    pub fn orders(&self, column: &[f64]) -> Result<Orders, SpectrumError> {
        let x: Vec<f64> = self.rows.iter().map(|&row| column[row]).collect();
        if let Some(index) = x.iter().position(|v| !v.is_finite()) {
            return Err(SpectrumError::NotFinite { index, value: x[index] });
        }
        let (n, revolutions) = (self.values()?, self.revolutions());
        let amplitude = amplitudes(&at_equal_angles(&x, &self.angle, revolutions as f64 / n as f64, n));
        Ok(Orders { order: self.axis()?, amplitude, revolutions })
    }
}

/// The integral of evenly spaced samples from the first on. It is exact for cubic polynomials, in the first and last interval for
/// parabolas.
fn integral(x: &[f64], h: f64) -> Vec<f64> {
    let last = x.len() - 1;
    let mut sum = vec![0.0; x.len()];
    for i in 0..last {
        let between = match i {
            0 => (5.0 * x[0] + 8.0 * x[1] - x[2]) / 12.0,
            _ if i + 1 == last => (5.0 * x[last] + 8.0 * x[last - 1] - x[last - 2]) / 12.0,
            _ => (13.0 * (x[i] + x[i + 1]) - x[i - 1] - x[i + 2]) / 24.0,
        };
        sum[i + 1] = sum[i] + h * between;
    }
    sum
}

/// `n` values at the angles 0, `step`, .., by cubic interpolation (Lagrange) between the four samples about each.
fn at_equal_angles(x: &[f64], angle: &[f64], step: f64, n: usize) -> Vec<f64> {
    let mut next = 0;
    (0..n)
        .map(|i| {
            let at = i as f64 * step;
            while next + 2 < angle.len() && angle[next + 1] <= at {
                next += 1;
            }
            let first = next.saturating_sub(1).min(angle.len() - 4);
            let weight = |j: usize| {
                let others = (first..first + 4).filter(|&k| k != j);
                others.map(|k| (at - angle[k]) / (angle[j] - angle[k])).product::<f64>()
            };
            (first..first + 4).map(|j| weight(j) * x[j]).sum()
        })
        .collect()
}

/// Peak amplitudes of the lines of a signal, with the Hann window.
fn amplitudes(x: &[f64]) -> Vec<f64> {
    let (n, window) = (x.len(), hann(x.len()));
    let mean = x.iter().sum::<f64>() / n as f64;
    let fft = RealFftPlanner::<f64>::new().plan_fft_forward(CLOSER * n);
    let mut input: Vec<f64> = x.iter().zip(&window).map(|(x, w)| (x - mean) * w).collect();
    input.resize(CLOSER * n, 0.0);
    let mut output = fft.make_output_vec();
    // The transform fails only on buffers of the wrong length; these were made for it.
    let _ = fft.process(&mut input, &mut output);
    let scale = 2.0 / window.iter().sum::<f64>();
    output.iter().map(|c| scale * c.norm()).collect()
}

#[cfg(test)]
mod tests;
