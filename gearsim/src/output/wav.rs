//! A sound as WAV: one channel, 16 bits, 48 kHz.

use std::io::{Seek, Write};

use hound::{SampleFormat, WavSpec, WavWriter};

use super::OutputError;
use crate::analysis::sound::{RATE, Sound};

/// Writes a sound. Errors: [`OutputError::Sink`], [`OutputError::Format`].
pub fn write(sound: &Sound, sink: impl Write + Seek) -> Result<(), OutputError> {
    let spec = WavSpec { channels: 1, sample_rate: RATE, bits_per_sample: 16, sample_format: SampleFormat::Int };
    let mut writer = WavWriter::new(sink, spec).map_err(failed)?;
    for value in &sound.values {
        writer.write_sample((value * f64::from(i16::MAX)).round() as i16).map_err(failed)?;
    }
    writer.finalize().map_err(failed)
}

/// A full disk is reported as such, not as a bad format.
fn failed(error: hound::Error) -> OutputError {
    match error {
        hound::Error::IoError(error) => OutputError::Sink(error),
        other => OutputError::format("WAV", other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sound_reads_back() {
        let sound = Sound { values: vec![0.0, 0.9, -0.9, 0.5], full_scale: 1.0, mean: 0.0 };
        let mut file = std::io::Cursor::new(vec![]);
        write(&sound, &mut file).unwrap();
        file.set_position(0);
        let mut reader = hound::WavReader::new(file).unwrap();
        assert_eq!((reader.spec().sample_rate, reader.spec().channels), (48_000, 1));
        let read: Vec<i16> = reader.samples().map(Result::unwrap).collect();
        assert_eq!(read, [0, 29490, -29490, 16384]);
    }
}
