//! Order spectra and order cuts of a run-up: amplitudes over the speed, from overlapping windows of whole revolutions. The windows of cuts
//! are closer to each other, so that a narrow resonance has many points.

use super::{Orders, Turning};
use crate::analysis::spectrum::SpectrumError;

/// The amplitudes in one window.
#[derive(Debug, Clone, PartialEq)]
pub struct Cut {
    /// Speed of the shaft in the middle of the window \[rad/s\].
    pub speed: f64,
    /// Peak amplitude at each order asked for ([`Orders::at`]) [unit of the signal]; NaN beyond the last order.
    pub amplitude: Vec<f64>,
}

/// Distance from one cut to the next, minimum and maximum [relative to the length of a window].
const APART: [f64; 2] = [0.125, 0.5];
/// Maximum number of cuts, unless windows would then overlap by less than half.
const MOST: f64 = 400.0;

/// The amplitudes of `orders` of a column in windows of `revolutions`. The distance from one window to the next is an eighth of a window,
/// in long runs up to half a window.
///
/// # Errors
/// Those of [`Turning::orders`].
pub fn cuts(turning: &Turning, column: &[f64], orders: &[f64], revolutions: usize) -> Result<Vec<Cut>, SpectrumError> {
    let cut = |window: Window| {
        let amplitude = orders.iter().map(|order| window.orders.at(*order).unwrap_or(f64::NAN)).collect();
        Cut { speed: window.speed, amplitude }
    };
    let width = revolutions as f64;
    let apart = (turning.angle[turning.angle.len() - 1] / MOST).clamp(APART[0] * width, APART[1] * width);
    Ok(windows(turning, column, revolutions, apart)?.into_iter().map(cut).collect())
}

/// The order spectrum in one window.
#[derive(Debug, Clone, PartialEq)]
pub struct Window {
    /// Speed of the shaft in the middle of the window \[rad/s\].
    pub speed: f64,
    /// Time of the middle, from the first sample \[s\].
    pub time: f64,
    /// The spectrum.
    pub orders: Orders,
}

/// The order spectra of a column in windows of `revolutions`, each `apart` \[revolutions\] from the one before.
///
/// # Errors
/// Those of [`Turning::orders`].
pub fn windows(
    turning: &Turning,
    column: &[f64],
    revolutions: usize,
    apart: f64,
) -> Result<Vec<Window>, SpectrumError> {
    let mut all = vec![];
    let mut begin = 0.0;
    while begin + revolutions as f64 <= turning.angle[turning.angle.len() - 1] {
        let from = turning.angle.partition_point(|&angle| angle < begin);
        // One sample more, so that the revolutions are whole.
        let end = begin + revolutions as f64;
        let to = (turning.angle.partition_point(|&angle| angle <= end) + 2).min(turning.angle.len());
        begin += apart;
        if to - from < 4 {
            continue;
        }
        let angle: Vec<f64> = turning.angle[from..to].iter().map(|angle| angle - turning.angle[from]).collect();
        // The window has most weight in its middle: the amplitude belongs to the speed there.
        let half = 0.5 * angle[angle.len() - 1];
        let middle = angle.partition_point(|&angle| angle < half).clamp(1, angle.len() - 2);
        let speed = 0.5 * (angle[middle + 1] - angle[middle - 1]) * turning.rate * std::f64::consts::TAU;
        let window = Turning { rows: turning.rows[from..to].to_vec(), angle, rate: turning.rate };
        if window.revolutions() < 1 {
            continue;
        }
        let time = (from + middle) as f64 / turning.rate;
        all.push(Window { speed, time, orders: window.orders(column)? });
    }
    Ok(all)
}
