//! A recorded signal as sound: at 48 kHz, in true or stretched time, without its mean, scaled to its largest value.
//!
//! The samples x_n at the rate f are interpolated by a sinc with a Hann window over 2 L of its zeros. With the cut-off f_c, half the lower
//! of f and 48 kHz times the stretch, the value at the time t is
//!
//! ```text
//! y(t) = sum_n x_n s sinc(s (f t - n)) (1 + cos(pi s (f t - n)/L))/2,    s = 2 f_c/f,  |s (f t - n)| < L
//! ```
//!
//! Source: J. O. Smith, Digital Audio Resampling (CCRMA, Stanford, 2002).

use std::f64::consts::PI;

use crate::analysis::spectrum::{SpectrumError, uniform_samples};
use crate::trajectory::Trajectory;

/// Samples a second of the sound \[Hz\].
pub const RATE: u32 = 48_000;
/// Zeros of the sinc on either side.
const ZEROS: f64 = 32.0;
/// The largest value of the sound; full scale is 1.
const LARGEST: f64 = 0.9;
/// Longest sound \[s\].
const LONGEST: f64 = 600.0;

/// A sound.
#[derive(Debug, Clone, PartialEq)]
pub struct Sound {
    /// Values from -1 to 1 at [`RATE`].
    pub values: Vec<f64>,
    /// The deviation of the signal from its mean that corresponds to 1, full scale [unit of the signal].
    pub full_scale: f64,
    /// The mean that was subtracted [unit of the signal].
    pub mean: f64,
}

/// Why a signal cannot be written as sound.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SoundError {
    /// It has no evenly spaced samples.
    #[error(transparent)]
    Samples(#[from] SpectrumError),
    /// A signal that does not vary.
    #[error("it does not vary")]
    Silent,
    /// Too long.
    #[error("it would last {seconds:.0} s, and may last {LONGEST} s: lower `stretch`, or end the run earlier")]
    Long {
        /// Its duration \[s\].
        seconds: f64,
    },
}

/// A column of a run as sound, played `stretch` times as slowly.
///
/// # Errors
/// [`SoundError`].
pub fn of(run: &Trajectory, column: &[f64], stretch: f64) -> Result<Sound, SoundError> {
    let (rows, rate) = uniform_samples(run)?;
    let x: Vec<f64> = rows.iter().map(|&row| column[row]).collect();
    if let Some(index) = x.iter().position(|x| !x.is_finite()) {
        return Err(SpectrumError::NotFinite { index, value: x[index] }.into());
    }
    let seconds = (x.len() - 1) as f64 / rate * stretch;
    if seconds > LONGEST {
        return Err(SoundError::Long { seconds });
    }
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    let x: Vec<f64> = x.iter().map(|x| x - mean).collect();
    // Distance of two samples of the sound, in samples of the signal.
    let step = rate / (stretch * f64::from(RATE));
    let mut values = resampled(&x, step);
    let largest = values.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    if largest <= f64::EPSILON * mean.abs() {
        return Err(SoundError::Silent);
    }
    let full_scale = largest / LARGEST;
    values.iter_mut().for_each(|x| *x /= full_scale);
    Ok(Sound { values, full_scale, mean })
}

/// `x` at the places 0, `step`, .., without frequencies above half the lower rate. Beyond its ends `x` counts as zero.
fn resampled(x: &[f64], step: f64) -> Vec<f64> {
    let s = (1.0 / step).min(1.0);
    let reach = ZEROS / s;
    let count = ((x.len() - 1) as f64 / step).floor() as usize + 1;
    let value = |i: usize| {
        let at = i as f64 * step;
        let first = (at - reach).ceil().max(0.0) as usize;
        let last = ((at + reach).floor() as usize).min(x.len() - 1);
        let weight = |n: usize| {
            let u = s * (at - n as f64);
            let sinc = if u == 0.0 { 1.0 } else { (PI * u).sin() / (PI * u) };
            s * sinc * 0.5 * (1.0 + (PI * u / ZEROS).cos())
        };
        (first..=last).map(|n| x[n] * weight(n)).sum()
    };
    (0..count).map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::spectrum::welch;
    use crate::output::fixture::MODEL;
    use crate::trajectory::Moment;
    use std::f64::consts::TAU;

    fn sine(rate: f64, frequency: f64, seconds: f64) -> (Trajectory, Vec<f64>) {
        let mut run = Trajectory::new(&MODEL, &[], &[]);
        run.t = (0..=(seconds * rate) as usize).map(|i| i as f64 / rate).collect();
        run.moment = vec![Moment::Sample; run.t.len()];
        let x = run.t.iter().map(|t| 7.0 + 2.5 * (TAU * frequency * t).sin()).collect();
        (run, x)
    }

    #[test]
    fn a_sine_keeps_its_frequency_and_stretched_time_divides_it() {
        for (rate, frequency, stretch) in
            [(20e3, 1000.0, 1.0), (44.1e3, 3000.0, 1.0), (200e3, 15e3, 10.0), (96e3, 440.0, 0.5)]
        {
            let (run, x) = sine(rate, frequency, 0.5);
            let sound = of(&run, &x, stretch).unwrap();
            let length = 8192.min(sound.values.len());
            let spectrum = welch(&sound.values, f64::from(RATE), length).unwrap();
            let top = (1..spectrum.density.len()).max_by(|&a, &b| spectrum.density[a].total_cmp(&spectrum.density[b]));
            let found = spectrum.frequency[top.unwrap()];
            assert!((found - frequency / stretch).abs() <= spectrum.resolution(), "{rate} {frequency}: {found}");
            assert!((sound.full_scale * LARGEST / 2.5 - 1.0).abs() < 0.01, "{}", sound.full_scale);
        }
    }

    #[test]
    fn between_samples_the_sine_is_exact() {
        let (_, x) = sine(20e3, 1000.0, 0.2);
        let x: Vec<f64> = x.iter().map(|x| x - 7.0).collect();
        let step = 20.0 / 48.0;
        let found = resampled(&x, step);
        // Compare away from the ends. The window passes 1e-4 of the content near half the rate; the sine is far below it.
        let middle = 200..found.len() - 200;
        let error = middle.map(|i| (found[i] - 2.5 * (TAU * 0.05 * i as f64 * step).sin()).abs()).fold(0.0, f64::max);
        assert!(error < 2e-4, "{error}");
    }

    #[test]
    fn frequencies_above_half_the_sound_rate_are_removed_without_aliases() {
        let (run, _) = sine(200e3, 0.0, 0.2);
        let x: Vec<f64> = run.t.iter().map(|t| (TAU * 1000.0 * t).sin() + (TAU * 40e3 * t).sin()).collect();
        let sound = of(&run, &x, 1.0).unwrap();
        let spectrum = welch(&sound.values, f64::from(RATE), 4800).unwrap();
        // The alias of 40 kHz is at 8 kHz.
        assert!(spectrum.power(7.5e3, 8.5e3) < 1e-6 * spectrum.power(900.0, 1100.0));
    }

    #[test]
    fn silent_and_too_long_sounds_are_refused() {
        let (run, x) = sine(1e3, 0.0, 1.0);
        assert_eq!(of(&run, &x, 1.0), Err(SoundError::Silent));
        let (run, x) = sine(1e3, 50.0, 1.0);
        assert!(matches!(of(&run, &x, 1e4), Err(SoundError::Long { .. })));
    }
}
