//! Powers in frequency bands, which can be compared between spectra whose lines lie at different frequencies.

use std::f64::consts::TAU;

use gearsim::analysis::spectrum::{Spectrum, segment_length, welch};

/// Band of the peak that the paper reports, four mesh orders wide at 600 rpm [wd].
pub const PEAK: (f64, f64) = (3.0, 3.4);
/// Bands beside it, equally wide [wd]. A power law has the geometric mean of their powers in the band between them.
pub const BESIDE: [(f64, f64); 2] = [(2.6, 3.0), (3.4, 3.8)];

/// A spectrum of phi over frequency in units of wd.
pub struct Bands {
    /// The spectrum.
    pub spectrum: Spectrum,
    /// wd/(2 pi) [Hz]
    unit: f64,
}

impl Bands {
    /// The spectrum of the first `window` [s] of `phi`, with one Hann window.
    pub fn of(phi: &[f64], rate: f64, window: f64, wd: f64) -> anyhow::Result<Bands> {
        let n = ((window * rate) as usize).min(phi.len());
        Ok(Bands { spectrum: welch(&phi[..n], rate, n)?, unit: wd / TAU })
    }

    /// The spectrum of all of `phi`, averaged over segments, as in the plots of `gearsim run`.
    pub fn averaged(phi: &[f64], rate: f64, wd: f64) -> anyhow::Result<Bands> {
        Ok(Bands { spectrum: welch(phi, rate, segment_length(phi.len()))?, unit: wd / TAU })
    }

    /// Frequencies [wd].
    pub fn frequency(&self) -> Vec<f64> {
        self.spectrum.frequency.iter().map(|f| f / self.unit).collect()
    }

    /// Power between two frequencies [wd], [rad^2].
    pub fn power(&self, (low, high): (f64, f64)) -> f64 {
        self.spectrum.power(low * self.unit, high * self.unit)
    }

    /// Power in the band of the peak over that in the bands beside it.
    pub fn height(&self) -> f64 {
        self.power(PEAK) / (self.power(BESIDE[0]) * self.power(BESIDE[1])).sqrt()
    }

    /// Frequency of the highest density in the band of the peak [wd].
    pub fn highest(&self) -> f64 {
        let frequency = self.frequency();
        let within = (0..frequency.len()).filter(|i| (PEAK.0..=PEAK.1).contains(&frequency[*i]));
        let density = &self.spectrum.density;
        within.max_by(|a, b| density[*a].total_cmp(&density[*b])).map_or(f64::NAN, |i| frequency[i])
    }

    /// Highest density in a band [wd] over the highest of `other` in that band, which may lie at another frequency.
    pub fn peaks(&self, (low, high): (f64, f64), other: &Bands) -> f64 {
        let highest = |bands: &Bands| {
            let densities = bands.frequency().into_iter().zip(&bands.spectrum.density);
            densities.filter(|(w, _)| (low..=high).contains(w)).map(|(_, p)| *p).fold(0.0, f64::max)
        };
        highest(self) / highest(other)
    }

    /// Power in the band of the peak over that of `other`.
    pub fn ratio(&self, other: &Bands) -> f64 {
        self.power(PEAK) / other.power(PEAK)
    }

    /// Largest ratio of the densities at the same frequency in the band of the peak. If the lines lie at different frequencies, this
    /// compares a line with the gap between two lines.
    pub fn ratio_at_one_frequency(&self, other: &Bands) -> f64 {
        let densities = self.frequency().into_iter().zip(self.spectrum.density.iter().zip(&other.spectrum.density));
        densities.filter(|(w, _)| (PEAK.0..=PEAK.1).contains(w)).map(|(_, (a, b))| a / b).fold(0.0, f64::max)
    }

    /// Largest absolute difference of band powers to `other` up to about 4 wd [dB], in bands of `orders` mesh orders; a mesh
    /// order is `mesh` [wd] wide.
    pub fn difference(&self, other: &Bands, mesh: f64, orders: usize) -> f64 {
        let width = mesh * orders as f64;
        let count = (4.0 / width).round() as usize;
        let band = |i: usize| (mesh / 2.0 + width * i as f64, mesh / 2.0 + width * (i + 1) as f64);
        let decibel = |i: usize| 10.0 * (self.power(band(i)) / other.power(band(i))).log10();
        (0..count).map(|i| decibel(i).abs()).fold(0.0, f64::max)
    }
}
