//! The table of lines, `lines.csv`: amplitudes of the recorded forces and transmission errors at mesh orders, and at those of their
//! sidebands that stand out in the spectrum.

use std::borrow::Cow;

use super::OutputError;
use super::table::{Table, Values};
use crate::analysis::orders::{Line, Turning, lines, meshes, reference_shaft};
use crate::analysis::spectrum::SpectrumError;
use crate::model::Output;
use crate::scene::Spectrum;
use crate::trajectory::Trajectory;

/// Units of the outputs in the table: forces, torques, transmission errors and twists.
const UNITS: [&str; 4] = ["N", "m", "N*m", "rad"];

/// Orders with a smaller relative difference count as the same: they are means over a run, in which shafts twist.
const SAME: f64 = 1e-4;

/// The lines of a run.
#[derive(Debug, Clone)]
pub struct Lines {
    /// The shaft to whose turns the orders refer.
    pub shaft: &'static Output,
    /// The lines.
    pub lines: Vec<Line>,
    /// The meshes whose speeds vary. Their lines have no fixed frequency.
    pub varying: Vec<&'static str>,
    /// The outputs in the table.
    pub outputs: Vec<&'static Output>,
    /// Peak amplitudes (lines, outputs) [units of the outputs].
    pub amplitudes: Vec<Vec<f64>>,
    /// Whether an output has a line (outputs, lines). It has a sideband only if that stands out in its spectrum.
    pub has: Vec<Vec<bool>>,
}

impl Lines {
    /// The lines of the outputs that a run recorded; `None` if no mesh turns, or nothing is recorded by which to find them.
    ///
    /// # Errors
    /// Those of [`Turning::of`].
    pub fn of(run: &Trajectory, settings: &Spectrum) -> Result<Option<Lines>, SpectrumError> {
        let columns = run.outputs.iter().filter(|(output, _)| UNITS.contains(&output.unit));
        let varying = columns.filter(|(_, column)| column.iter().any(|x| *x != column[0]));
        let (outputs, columns): (Vec<_>, Vec<&[f64]>) = varying.map(|(o, column)| (*o, &column[..])).unzip();
        let meshes = meshes(run, settings.from);
        let Some(shaft) = reference_shaft(run, settings.shaft).filter(|_| !meshes.is_empty() && !outputs.is_empty())
        else {
            return Ok(None);
        };
        let turning = Turning::of(run, shaft.name, settings.from)?;
        let lines = lines(&turning, &meshes);
        let amplitudes = turning.amplitudes(&columns, &lines);
        let has = columns.iter().map(|column| turning.has(column, &lines)).collect();
        let varying = meshes.iter().filter(|mesh| !mesh.steady).map(|mesh| mesh.name).collect();
        Ok(Some(Lines { shaft, lines, varying, outputs, amplitudes, has }))
    }

    /// The lines of the output number `o`, each with its peak amplitude.
    fn of_output(&self, o: usize) -> impl Iterator<Item = (&Line, f64)> {
        let all = self.lines.iter().zip(&self.amplitudes).zip(&self.has[o]);
        all.filter(|(_, has)| **has).map(move |((line, amplitudes), _)| (line, amplitudes[o]))
    }

    /// The table, a row for each output and line; the frequency is NaN where the speed of the mesh varies. Errors: [`OutputError::Ragged`].
    pub fn table(&self, settings: &Spectrum) -> Result<Table, OutputError> {
        let (mut words, mut numbers) = ([(); 5].map(|()| vec![]), [(); 6].map(|()| vec![]));
        for (o, output) in self.outputs.iter().enumerate() {
            let (reference, value) = settings.reference(output.unit);
            for (line, amplitude) in self.of_output(o) {
                let rotor = line.rotor.unwrap_or_default();
                let texts = [output.name, output.unit, line.mesh, rotor].map(Cow::Borrowed);
                let texts = texts.into_iter().chain([Cow::Owned(reference.clone())]);
                words.iter_mut().zip(texts).for_each(|(column, text)| column.push(text));
                let level = 20.0 * (amplitude / value).log10();
                let (harmonic, sideband) = (line.harmonic as f64, f64::from(line.sideband));
                // A line that moves with the speed has no fixed frequency.
                let frequency = if self.varying.contains(&line.mesh) { f64::NAN } else { line.frequency };
                let row = [harmonic, sideband, line.order, frequency, amplitude, level];
                numbers.iter_mut().zip(row).for_each(|(column, number)| column.push(number));
            }
        }
        let [signal, unit, mesh, rotor, reference] = words.map(Values::Text);
        let [harmonic, sideband, order, frequency, amplitude, level] = numbers.map(Values::Number);
        let mut table = Table::default();
        table.push("signal", "", signal)?;
        table.push("mesh", "", mesh)?;
        table.push("harmonic", "1", harmonic)?;
        table.push("rotor", "", rotor)?;
        table.push("sideband", "1", sideband)?;
        table.push(&format!("order_of_{}", self.shaft.name), "1", order)?;
        table.push("frequency", "Hz", frequency)?;
        table.push("peak_amplitude", "1", amplitude)?;
        table.push("unit", "", unit)?;
        table.push("level", "dB", level)?;
        table.push("level_re", "", reference)?;
        Ok(table)
    }

    /// The largest lines of an output, the largest first: each with its peak amplitude [unit of the output]. Only one of several
    /// lines at the same order is kept, a multiple of a mesh order if there is one.
    pub fn largest(&self, output: &Output, most: usize) -> Vec<(Line, f64)> {
        let Some(o) = self.outputs.iter().position(|known| known.name == output.name) else { return vec![] };
        let mut all: Vec<_> = self.of_output(o).map(|(line, amplitude)| (*line, amplitude)).collect();
        all.sort_by_key(|(line, _)| line.rotor.is_some());
        let mut apart: Vec<(Line, f64)> = vec![];
        for (line, amplitude) in all {
            if apart.iter().all(|(other, _)| (other.order - line.order).abs() > SAME * line.order) {
                apart.push((line, amplitude));
            }
        }
        apart.sort_by(|a, b| b.1.total_cmp(&a.1));
        apart.truncate(most);
        apart
    }
}

#[cfg(test)]
mod tests;
