//! Power spectral density by Welch's method: averaged periodograms of overlapping, windowed segments.
//!
//! For segments `x` of length L, without their mean, at the sampling rate fs, with the Hann window w:
//!
//! `P(f_m) = 2 |sum_n w_n x_n exp(-2 pi i m n/L)|^2 / (fs sum_n w_n^2)`, `f_m = m fs/L`,
//!
//! without the factor 2 at `f = 0` and, for even L, at `f = fs/2`. Segments overlap by half. `P` is one-sided, in
//! unit^2/Hz: its integral over f is the mean square of the signal without its mean.
//!
//! The noise bandwidth is B = fs sum w²/(sum w)², 1.5 lines for the Hann window. The power P B in it is that of a sine at f_m with the root
//! mean square sqrt(P B) and the peak amplitude sqrt(2 P B). A sine between two lines reads up to 15 % less; its power is the sum of the
//! powers of the lines around it ([`Spectrum::power`]).
//!
//! Sources: P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70-73, doi:10.1109/TAU.1967.1161901;
//! normalisation as in G. Heinzel, A. Rüdiger, R. Schilling, "Spectrum and spectral density estimation by the DFT",
//! Max-Planck-Institut für Gravitationsphysik (2002), Eqs. (19) to (24).

use realfft::RealFftPlanner;

use crate::tolerance::analysis::{EVEN_SPACING, TIME_ROUNDING};
use crate::trajectory::Trajectory;

/// A one-sided power spectral density.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Frequencies \[Hz\], evenly spaced from 0 to half the sampling rate.
    pub frequency: Vec<f64>,
    /// Density [unit^2/Hz] at each frequency.
    pub density: Vec<f64>,
    /// Number of segments averaged.
    pub segments: usize,
}

impl Spectrum {
    /// Distance of neighbouring frequencies \[Hz\].
    pub fn resolution(&self) -> f64 {
        self.frequency.get(1).copied().unwrap_or(0.0)
    }

    /// The equivalent noise bandwidth of the Hann window \[Hz\].
    pub fn noise_bandwidth(&self) -> f64 {
        1.5 * self.resolution()
    }

    /// The root mean square of a sine at each frequency [unit].
    pub fn rms(&self) -> impl Iterator<Item = f64> + '_ {
        let bandwidth = self.noise_bandwidth();
        self.density.iter().map(move |density| (density * bandwidth).sqrt())
    }

    /// The frequency above which less than a fraction `share` of the power lies \[Hz\].
    pub fn highest(&self, share: f64) -> f64 {
        highest(&self.frequency, self.density.iter().copied(), share)
    }

    /// Power [unit^2] between two frequencies \[Hz\], both included.
    pub fn power(&self, low: f64, high: f64) -> f64 {
        let within = |f: f64| (low..=high).contains(&f);
        let sum: f64 = (self.frequency.iter().zip(&self.density)).filter(|&(&f, _)| within(f)).map(|(_, p)| p).sum();
        sum * self.resolution()
    }
}

/// Why a spectrum cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpectrumError {
    /// Too few samples.
    #[error("a spectrum needs at least 4 samples, there are {samples}; record longer or at a higher rate")]
    TooShort {
        /// Number of samples.
        samples: usize,
    },
    /// Segments longer than the signal, or too short.
    #[error("segments of {segment} samples do not fit a signal of {samples}")]
    BadSegment {
        /// The requested length of the segments.
        segment: usize,
        /// The length of the signal.
        samples: usize,
    },
    /// A sampling rate that is not positive or not finite.
    #[error("the sampling rate must be positive and finite, but is {rate} Hz")]
    BadRate {
        /// The rate \[Hz\].
        rate: f64,
    },
    /// A shaft by whose turns orders cannot be counted.
    #[error("orders cannot be counted by `{shaft}`: it is not recorded, or the shaft stands or turns back")]
    NotTurning {
        /// The output that is its speed.
        shaft: String,
    },
    /// A shaft that turns too little for a spectrum over orders.
    #[error("the shaft makes {turned:.2} of a revolution, and orders need a whole one; let the run last longer")]
    NoRevolution {
        /// The revolutions that it makes \[1\].
        turned: f64,
    },
    /// Samples that are not evenly spaced.
    #[error("samples are not evenly spaced: {step} s instead of {expected} s at t = {t} s")]
    Uneven {
        /// Time of the sample \[s\].
        t: f64,
        /// Distance to the sample before it \[s\].
        step: f64,
        /// Distance between the first two samples \[s\].
        expected: f64,
    },
    /// A value that is not finite.
    #[error("sample {index} is {value}")]
    NotFinite {
        /// Index of the sample, from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
}

/// A signal of fewer samples is one segment: four segments would be too short to resolve anything.
const SHORT: usize = 256;

/// The longest even segment length that gives four segments; the whole length of a signal with fewer than 256 samples.
pub fn segment_length(samples: usize) -> usize {
    // Four segments overlapping by half cover 2.5 of their length.
    if samples < SHORT { samples } else { samples * 2 / 5 / 2 * 2 }
}

/// Power spectral density of `x` [unit], sampled at `rate` \[Hz\], from segments of `segment` samples.
///
/// The end of `x` beyond the last whole segment is not used.
/// Errors: [`SpectrumError::TooShort`], [`SpectrumError::BadSegment`], [`SpectrumError::BadRate`],
/// [`SpectrumError::NotFinite`].
pub fn welch(x: &[f64], rate: f64, segment: usize) -> Result<Spectrum, SpectrumError> {
    if x.len() < 4 {
        return Err(SpectrumError::TooShort { samples: x.len() });
    }
    if segment < 4 || segment > x.len() {
        return Err(SpectrumError::BadSegment { segment, samples: x.len() });
    }
    if !(rate > 0.0 && rate.is_finite()) {
        return Err(SpectrumError::BadRate { rate });
    }
    if let Some(index) = x.iter().position(|v| !v.is_finite()) {
        return Err(SpectrumError::NotFinite { index, value: x[index] });
    }

    let window = hann(segment);
    let scale = 1.0 / (rate * window.iter().map(|w| w * w).sum::<f64>());
    let fft = RealFftPlanner::<f64>::new().plan_fft_forward(segment);
    let mut input = fft.make_input_vec();
    let mut output = fft.make_output_vec();
    let mut density = vec![0.0; output.len()];
    let mut segments = 0;
    for part in x.windows(segment).step_by(segment / 2) {
        let mean = part.iter().sum::<f64>() / segment as f64;
        for ((v, x), w) in input.iter_mut().zip(part).zip(&window) {
            *v = (x - mean) * w;
        }
        // The transform fails only on buffers of the wrong length; these were made for it.
        if fft.process(&mut input, &mut output).is_err() {
            return Err(SpectrumError::BadSegment { segment, samples: x.len() });
        }
        for (p, c) in density.iter_mut().zip(&output) {
            *p += scale * c.norm_sqr();
        }
        segments += 1;
    }

    let nyquist = if segment.is_multiple_of(2) { Some(density.len() - 1) } else { None };
    for (m, p) in density.iter_mut().enumerate() {
        let sides = if m == 0 || Some(m) == nyquist { 1.0 } else { 2.0 };
        *p *= sides / segments as f64;
    }
    Ok(Spectrum { frequency: frequencies(rate, segment), density, segments })
}

/// The frequencies \[Hz\] of the spectra of segments of this length, of samples at a `rate` \[1/s\].
pub fn frequencies(rate: f64, segment: usize) -> Vec<f64> {
    (0..segment / 2 + 1).map(|m| m as f64 * rate / segment as f64).collect()
}

/// The place above which less than a fraction `share` of the power lies; 0 if there are no places.
pub(super) fn highest(places: &[f64], power: impl DoubleEndedIterator<Item = f64> + Clone, share: f64) -> f64 {
    let mut left = share * power.clone().sum::<f64>();
    let above = power.rev().take_while(|p| {
        left -= *p;
        left > 0.0
    });
    let above = above.count();
    places.iter().rev().nth(above).copied().unwrap_or(0.0)
}

/// The periodic Hann window of length `n`.
pub(crate) fn hann(n: usize) -> Vec<f64> {
    (0..n).map(|i| (std::f64::consts::PI * i as f64 / n as f64).sin().powi(2)).collect()
}

/// As [`uniform_samples`], from the time `from` \[s\] on. The rows may then be few.
///
/// # Errors
/// As [`uniform_samples`].
pub fn uniform_samples_from(run: &Trajectory, from: f64) -> Result<(Vec<usize>, f64), SpectrumError> {
    let (mut rows, rate) = uniform_samples(run)?;
    rows.retain(|&row| run.t[row] >= from);
    Ok((rows, rate))
}

/// The rows of `run` that are evenly spaced samples, and their rate \[Hz\].
///
/// The last row is left out if the end of the run is not at a multiple of the sampling interval.
/// Errors: [`SpectrumError::TooShort`], [`SpectrumError::Uneven`].
pub fn uniform_samples(run: &Trajectory) -> Result<(Vec<usize>, f64), SpectrumError> {
    let mut rows: Vec<usize> = run.samples().collect();
    if rows.len() < 4 {
        return Err(SpectrumError::TooShort { samples: rows.len() });
    }
    let expected = run.t[rows[1]] - run.t[rows[0]];
    let step = |pair: &[usize]| run.t[pair[1]] - run.t[pair[0]];
    // The second term allows for the rounding errors of times far from zero, which may exceed a fixed fraction of the interval.
    let even = |step: f64, t: f64| (step - expected).abs() <= EVEN_SPACING * expected + TIME_ROUNDING * t.abs();
    if let [.., a, b] = rows[..]
        && !even(step(&[a, b]), run.t[b])
    {
        rows.pop();
    }
    if let Some(pair) = rows.windows(2).find(|pair| !even(step(pair), run.t[pair[1]])) {
        return Err(SpectrumError::Uneven { t: run.t[pair[1]], step: step(pair), expected });
    }
    let duration = run.t[rows[rows.len() - 1]] - run.t[rows[0]];
    Ok((rows.clone(), (rows.len() - 1) as f64 / duration))
}

#[cfg(test)]
mod tests;
