//! The table of lines, `lines.csv`: amplitudes of the recorded forces and transmission errors at mesh orders, and at those of their
//! sidebands that stand out in the spectrum.

use std::borrow::Cow;

use super::OutputError;
use super::number::short;
use super::table::{Table, Values};
use crate::analysis::orders::{Line, Listed, Turning, lines, meshes, reference_shaft};
use crate::analysis::spectrum::SpectrumError;
use crate::model::Output;
use crate::scene::Spectrum;
use crate::trajectory::Trajectory;

/// Units of the outputs in the table: forces, torques, transmission errors and twists.
const UNITS: [&str; 4] = ["N", "m", "N*m", "rad"];

/// Lines of a mesh force among which a remark looks for lines that are not separated, and most pairs that it names.
const LARGEST: usize = 4;
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
    /// The lines of each output [unit of the output], by ascending order.
    pub listed: Vec<Vec<Listed>>,
    /// Length of the record \[s\].
    pub duration: f64,
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
        let listed = turning.listed(&columns, &lines);
        let duration = turning.duration();
        let varying = meshes.iter().filter(|mesh| !mesh.steady).map(|mesh| mesh.name).collect();
        Ok(Some(Lines { shaft, lines, varying, outputs, listed, duration }))
    }

    /// The table, a row for each output and line; the frequency is NaN where the speed of the mesh varies. Errors: [`OutputError::Ragged`].
    pub fn table(&self, settings: &Spectrum) -> Result<Table, OutputError> {
        let (mut words, mut numbers) = ([(); 6].map(|()| vec![]), [(); 6].map(|()| vec![]));
        for (output, listed) in self.outputs.iter().zip(&self.listed) {
            let (reference, value) = settings.reference(output.unit);
            for Listed { line, with, amplitude } in listed {
                let rotor = line.rotor.unwrap_or_default();
                let texts = [output.name, output.unit, line.mesh, rotor].map(Cow::Borrowed);
                let with = with.iter().map(Line::words).collect::<Vec<_>>().join(", ");
                let texts = texts.into_iter().chain([reference.clone(), with].map(Cow::Owned));
                words.iter_mut().zip(texts).for_each(|(column, text)| column.push(text));
                let level = 20.0 * (amplitude / value).log10();
                let (harmonic, sideband) = (line.harmonic as f64, f64::from(line.sideband));
                // A line that moves with the speed has no fixed frequency.
                let frequency = if self.varying.contains(&line.mesh) { f64::NAN } else { line.frequency };
                let row = [harmonic, sideband, line.order, frequency, *amplitude, level];
                numbers.iter_mut().zip(row).for_each(|(column, number)| column.push(number));
            }
        }
        let [signal, unit, mesh, rotor, reference, with] = words.map(Values::Text);
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
        table.push("not_separated_from", "", with)?;
        Ok(table)
    }

    /// The largest lines of an output, the largest first.
    pub fn largest(&self, output: &Output, most: usize) -> Vec<&Listed> {
        let Some(o) = self.outputs.iter().position(|known| known.name == output.name) else { return vec![] };
        let mut all: Vec<_> = self.listed[o].iter().collect();
        all.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        all.truncate(most);
        all
    }

    /// The largest lines of mesh forces that the record does not separate from others, as a remark; `None` if there are none.
    pub fn remark(&self) -> Option<String> {
        let forces = self.outputs.iter().filter(|output| output.name.starts_with("mesh_"));
        let largest = forces.flat_map(|output| self.largest(output, LARGEST));
        let pairs = largest.flat_map(|of| of.with.iter().map(move |with| (of.line, *with)));
        let mut pairs: Vec<_> = pairs.filter(|(a, b)| (a.order - b.order).abs() > SAME * a.order).collect();
        pairs.sort_by(|x, y| distance(x).total_cmp(&distance(y)));
        let mut named: Vec<String> = vec![];
        for (a, b) in &pairs {
            let [first, second] = if a.frequency < b.frequency { [a, b] } else { [b, a] };
            let says = format!("{} and {} ({} Hz apart)", first.words(), second.words(), short(distance(&(*a, *b))));
            if !named.contains(&says) {
                named.push(says);
            }
        }
        let longer = 2.0 / distance(pairs.first()?);
        named.truncate(LARGEST);
        Some(format!(
            "lines not separated: in a record of {} s lines closer than {} Hz are one line: {}. Record {} s to separate them",
            short(self.duration),
            short(2.0 / self.duration),
            named.join(", "),
            short(longer)
        ))
    }
}

/// The distance of two lines \[Hz\].
fn distance((a, b): &(Line, Line)) -> f64 {
    (a.frequency - b.frequency).abs()
}

#[cfg(test)]
mod tests;
