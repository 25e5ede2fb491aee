//! Results of a run besides its statistics, as files: lines, load spectra and sounds.

use crate::analysis::{rainflow, sound};
use crate::output::lines::Lines;
use crate::output::summary::{Number, Sound};
use crate::output::{OutputError, OutputFolder, csv, load_spectrum, wav};
use crate::run::Outcome;
use crate::scene::Scene;

/// Writes `lines.csv`, the load spectra and the sounds that the scene asks for. Returns the lines and the sounds, and a remark for each
/// file that cannot be made.
pub(crate) fn write(folder: &mut OutputFolder, scene: &Scene, outcome: &Outcome) -> Result<Evaluated, OutputError> {
    let (run, asked) = (&outcome.trajectory, &scene.output);
    let mut done = Evaluated::default();
    match Lines::of(run, &asked.spectrum) {
        Ok(Some(lines)) => {
            folder.write("lines.csv", |sink| csv::write(&lines.table(&asked.spectrum)?, sink))?;
            done.remarks.extend(lines.remark());
            done.lines = Some(lines);
        }
        Ok(None) => {}
        Err(error) => done.remarks.push(format!("no table of lines: {error}")),
    }
    for &name in &asked.rainflow {
        let Some((unit, column)) = run.signal(name) else { continue };
        let cycles = rainflow::count(&column[run.row_from(scene.output.from)..]);
        folder.write(&format!("rainflow_{name}.csv"), |sink| {
            csv::write(&load_spectrum::rainflow(&cycles, unit)?, sink)
        })?;
        folder.write(&format!("load_duration_{name}.csv"), |sink| {
            csv::write(&load_spectrum::durations(run, scene.output.from, column, unit)?, sink)
        })?;
    }
    let Some(of) = &asked.sound else { return Ok(done) };
    for &name in &of.of {
        let Some((unit, column)) = run.signal(name) else { continue };
        match sound::of(run, column, of.stretch) {
            Ok(sound) => {
                let file = format!("sound_{name}.wav");
                let mut bytes = std::io::Cursor::new(vec![]);
                wav::write(&sound, &mut bytes)?;
                folder.write_bytes(&file, &bytes.into_inner())?;
                let (full_scale, mean) = (Number(sound.full_scale), Number(sound.mean));
                let entry = Sound { file, stretch: Number(of.stretch), unit: unit.into(), full_scale, mean };
                done.sounds.push((name.to_owned(), entry));
            }
            Err(error) => done.remarks.push(format!("no sound of `{name}`: {error}")),
        }
    }
    Ok(done)
}

/// What [`write()`] made.
#[derive(Default)]
pub(crate) struct Evaluated {
    /// The lines; `None` if there are none.
    pub(crate) lines: Option<Lines>,
    /// The sounds, each with its signal.
    pub(crate) sounds: Vec<(String, Sound)>,
    /// Why a file that was asked for could not be made.
    pub(crate) remarks: Vec<String>,
}
