//! Tests of Welch's method with signals whose spectrum is known.

use super::*;
use crate::output::fixture::{MODEL, RATE, oscillator};
use crate::trajectory::Moment;

/// Pseudo-random numbers, normally distributed with unit variance (sum of twelve uniform ones).
fn white(n: usize) -> Vec<f64> {
    let mut state = 42_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..n).map(|_| (0..12).map(|_| uniform()).sum::<f64>() - 6.0).collect()
}

#[test]
fn a_sine_has_half_its_amplitude_squared() {
    let (amplitude, rate) = (3.0, 1000.0);
    // A frequency between two of the grid, and an offset, which the subtraction of the mean removes.
    let x: Vec<f64> =
        (0..8192).map(|i| 5.0 + amplitude * (2.0 * std::f64::consts::PI * 123.456 * i as f64 / rate).sin()).collect();
    let spectrum = welch(&x, rate, segment_length(x.len())).unwrap();
    assert_eq!(spectrum.segments, 4);
    let power = spectrum.power(110.0, 137.0);
    assert!((power / (0.5 * amplitude * amplitude) - 1.0).abs() < 0.01, "{power}");
    assert!(spectrum.power(0.0, 50.0) < 1e-4);
}

#[test]
fn white_noise_is_flat_at_twice_its_variance_over_the_rate() {
    let (rate, x) = (500.0, white(1 << 17));
    let spectrum = welch(&x, rate, 512).unwrap();
    for (low, high) in [(10.0, 80.0), (80.0, 160.0), (160.0, 240.0)] {
        let bins = spectrum.frequency.iter().filter(|f| (low..=high).contains(*f)).count();
        let mean = spectrum.power(low, high) / (bins as f64 * spectrum.resolution());
        assert!((mean / (2.0 / rate) - 1.0).abs() < 0.03, "{mean} at {low}..{high} Hz");
    }
}

#[test]
fn the_integral_is_the_mean_square_of_the_windowed_signal() {
    for n in [1000, 1001] {
        let x = white(n);
        let spectrum = welch(&x, 10.0, n).unwrap();
        let (mean, window) = (x.iter().sum::<f64>() / n as f64, hann(n));
        let square = |(x, w): (&f64, &f64)| ((x - mean) * w).powi(2);
        let expected = x.iter().zip(&window).map(square).sum::<f64>() / window.iter().map(|w| w * w).sum::<f64>();
        let power = spectrum.power(0.0, 5.0);
        assert!((power / expected - 1.0).abs() < 1e-12, "{power} {expected}");
    }
}

#[test]
fn a_sine_on_a_line_has_its_amplitude_and_between_lines_its_power() {
    let (amplitude, rate, n) = (3.0, 1000.0, 2000);
    let spectrum = |f: f64| {
        let x: Vec<f64> = (0..n).map(|i| amplitude * (std::f64::consts::TAU * f * i as f64 / rate).sin()).collect();
        welch(&x, rate, n / 4).unwrap()
    };
    // The lines are 2 Hz apart.
    let on = spectrum(100.0);
    let rms: Vec<f64> = on.rms().collect();
    assert!((rms[50] * 2.0_f64.sqrt() / amplitude - 1.0).abs() < 1e-12, "{}", rms[50]);
    // Half-way between two lines each reads the window's 8/(3 pi) of the amplitude; a sine of negative frequency adds 1e-6.
    let between = spectrum(101.0);
    let rms: Vec<f64> = between.rms().collect();
    assert!((rms[50] * 2.0_f64.sqrt() / amplitude / (8.0 / (3.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-5);
    // The main lobe and the next two side lobes of the window hold all of its power but 3e-5.
    let power = between.power(90.0, 112.0);
    assert!(((2.0 * power).sqrt() / amplitude - 1.0).abs() < 1e-4, "{power}");
}

#[test]
fn a_spectrum_reaches_as_far_as_its_content() {
    let x: Vec<f64> = (0..4000)
        .map(|i| i as f64 * std::f64::consts::TAU / 1000.0)
        .map(|t| (35.0 * t).sin() + 0.1 * (180.0 * t).sin())
        .collect();
    let highest = welch(&x, 1000.0, 1000).unwrap().highest(1e-3);
    assert!((180.0..190.0).contains(&highest), "{highest}");
}

#[test]
fn segments_are_as_long_as_four_of_them_allow() {
    for n in [256, 257, 1000, 4099] {
        let length = segment_length(n);
        let count = |length: usize| (n - length) / (length / 2) + 1;
        assert!(count(length) >= 4 && count(length + 2) < 4, "{n}: {length}");
    }
    assert_eq!(segment_length(255), 255);
}

#[test]
fn a_last_row_between_two_samples_is_left_out() {
    let mut run = oscillator(400);
    let whole = uniform_samples(&run).unwrap();
    assert_eq!(whole.0.len(), 400);
    assert!((whole.1 / RATE - 1.0).abs() < 1e-12);
    run.t.push(run.t[run.len() - 1] + 0.3 / RATE);
    run.moment.push(Moment::Sample);
    assert_eq!(uniform_samples(&run).unwrap(), whole);
    let middle = whole.0[200];
    run.t[middle] += 0.1 / RATE;
    assert!(matches!(uniform_samples(&run), Err(SpectrumError::Uneven { .. })));
}

#[test]
fn bad_data_is_an_error() {
    assert!(welch(&[1.0, f64::NAN, 0.0, 0.0], 1.0, 4).is_err());
    assert!(welch(&[0.0; 3], 1.0, 3).is_err());
    assert!(welch(&[0.0; 8], 0.0, 4).is_err());
    assert!(welch(&[0.0; 8], 1.0, 9).is_err());
    assert!(uniform_samples(&Trajectory::new(&MODEL, &[], &[])).is_err());
}
