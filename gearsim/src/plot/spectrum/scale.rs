//! The values of a spectrum as the scene asks for them: density or amplitude, plain or as a level in dB, and their axis.
//!
//! Level of an amplitude A: 20 lg(A/A0) dB re A0. Level of a density P: 10 lg(P/(A0²/Hz)) dB re A0²/Hz.

use crate::analysis::orders::PROMINENCE;
use crate::analysis::spectrum::Spectrum;
use crate::plot::figure::{Axis, Series, extremes};
use crate::plot::outputs::{engineering, sized};
use crate::plot::{Run, symbol};
use crate::scene::{self, SpectrumKind};

/// Decades of amplitude shown below the highest line: what is lower is rounding errors and leakage.
const DECADES: i32 = 6;
/// Room above the highest line, as a factor of amplitude.
const ROOM: f64 = 1.7;

/// A signal and the scale of its spectrum.
pub(super) struct Shown {
    /// What it is, for the legend.
    pub doc: &'static str,
    name: String,
    unit: &'static str,
    /// From SI to the unit that is shown.
    factor: f64,
    kind: SpectrumKind,
    /// The reference of levels \[SI\].
    reference: Option<(String, f64)>,
}

impl Shown {
    /// The signal `name` of a run, with its spectra in all runs.
    pub(super) fn of(run: &Run<'_>, name: &'static str, spectra: &[Spectrum]) -> Shown {
        let output = run.trajectory.outputs.iter().map(|(output, _)| *output).find(|output| output.name == name);
        let coordinate = run.trajectory.model.coordinates.iter().find(|c| c.name == name);
        let (si, doc) = output.map(|o| (o.unit, o.doc)).or(coordinate.map(|c| (c.unit, c.doc))).unwrap_or(("1", ""));
        let (unit, factor) = match run.asked.spectrum.kind {
            SpectrumKind::Psd => engineering(si),
            _ => sized(si, spectra.iter().flat_map(Spectrum::rms).fold(0.0, f64::max)),
        };
        let reference = run.asked.spectrum.decibels.then(|| run.asked.spectrum.reference(si));
        let name = if output.is_some() { name.to_owned() } else { symbol(name) };
        // A legend has room for the first part of a description.
        let doc = doc.split([',', ':']).next().unwrap_or(doc);
        Shown { doc, name, unit, factor, kind: run.asked.spectrum.kind, reference }
    }

    /// Its values over frequency.
    pub(super) fn values(&self, spectrum: &Spectrum) -> Vec<f64> {
        let amplitude = |rms: f64| if self.kind == SpectrumKind::Amplitude { rms * 2.0_f64.sqrt() } else { rms };
        let density = self.kind == SpectrumKind::Psd;
        match (&self.reference, density) {
            (Some((_, a0)), true) => spectrum.density.iter().map(|p| 10.0 * (p / (a0 * a0)).log10()).collect(),
            (Some((_, a0)), false) => spectrum.rms().map(|rms| 20.0 * (amplitude(rms) / a0).log10()).collect(),
            (None, true) => spectrum.density.iter().map(|p| p * self.factor * self.factor).collect(),
            (None, false) => spectrum.rms().map(|rms| amplitude(rms) * self.factor).collect(),
        }
    }

    /// The value of a line whose amplitude is [`PROMINENCE`] times that of the value `median`.
    pub(super) fn prominent(&self, median: f64) -> f64 {
        match (&self.reference, self.kind == SpectrumKind::Psd) {
            (Some(_), _) => median + 20.0 * PROMINENCE.log10(),
            (None, true) => PROMINENCE * PROMINENCE * median,
            (None, false) => PROMINENCE * median,
        }
    }

    /// The axis of values up to the abscissa `end`, and its limits.
    pub(super) fn axis(&self, series: &[Series], end: f64) -> (Axis, (f64, f64)) {
        let shown = || series.iter().flat_map(|s| s.x.iter().zip(&s.y)).filter(|&(&x, _)| x > 0.0 && x <= end);
        let power = if self.kind == SpectrumKind::Psd { 2 } else { 1 };
        let label = match self.kind {
            SpectrumKind::Psd => format!("PSD of {}", self.name),
            SpectrumKind::Amplitude => format!("peak of {}", self.name),
            SpectrumKind::Rms => format!("rms of {}", self.name),
        };
        if let Some((reference, _)) = &self.reference {
            let (lowest, peak) = extremes(shown().map(|(_, &y)| y));
            let range = (lowest.max(peak - 20.0 * f64::from(DECADES)), peak + 20.0 * ROOM.log10());
            let unit = if power == 2 { format!("dB re ({reference})^2/Hz") } else { format!("dB re {reference}") };
            let axis = Axis::linear(label, unit);
            return if range.0 < range.1 { (axis.between(range.0, range.1), range) } else { (axis, range) };
        }
        let (lowest, peak) = extremes(shown().map(|(_, &y)| y).filter(|&y| y > 0.0));
        let range = (lowest.max(0.1_f64.powi(DECADES * power) * peak), ROOM.powi(power) * peak);
        let unit = match self.unit {
            unit if power == 1 => unit.to_owned(),
            unit if unit.contains(['*', '/']) => format!("({unit})^2/Hz"),
            unit => format!("{unit}^2/Hz"),
        };
        let axis = Axis::log10(label, unit);
        if range.0 < range.1 { (axis.between(range.0, range.1), range) } else { (axis, range) }
    }
}

/// The title of the figure.
pub(super) fn title(settings: &scene::Spectrum) -> &'static str {
    match settings.kind {
        SpectrumKind::Psd => "Power spectral density",
        SpectrumKind::Amplitude => "Amplitude spectrum",
        SpectrumKind::Rms => "Spectrum of rms amplitudes",
    }
}

/// How the values are scaled, in words.
pub(super) fn words(settings: &scene::Spectrum) -> &'static str {
    match settings.kind {
        SpectrumKind::Psd => "Welch, per Hz",
        SpectrumKind::Amplitude => "Welch, peak amplitude of a sine on a line",
        SpectrumKind::Rms => "Welch, rms of a sine on a line",
    }
}
