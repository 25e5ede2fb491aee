//! Results of a run besides its statistics, as text: loads of meshes, lines, load spectra and sounds.

use super::{number::short, report};
use crate::analysis::orders::{Line, Listed, force};
use crate::library::evaluate::Evaluated;
use crate::output::summary::{LoadSpectrum, Sound, Summary};
use crate::output::unit::in_words;
use crate::scene::Scene;

/// Lines of a mesh force that are printed.
const PRINTED: usize = 4;
/// Meshes whose loads and lines are printed.
const MESHES: usize = 3;

/// The largest lines of the first mesh forces, the loads of the meshes, and the sounds, for the terminal.
pub(super) fn text(evaluated: &Evaluated, scene: &Scene, summary: &Summary, width: usize) -> String {
    let mut text = String::new();
    for (mesh, load) in summary.meshes.iter().take(MESHES) {
        let mut says = format!("{} at most", in_words(load.largest.0, &load.unit));
        if load.dynamic_factor.0.is_finite() {
            says += &format!(", {} of {} at rest", short(load.dynamic_factor.0), in_words(load.at_rest.0, &load.unit));
        }
        if load.kv_iso6336.0.is_finite() {
            says += &format!("; K_v of ISO 6336-1, method B: {}", short(load.kv_iso6336.0));
        }
        text += &report::line(&format!("load of {mesh}"), &says, width);
    }
    if let Some(lines) = &evaluated.lines {
        let meshes = scene.model.laws.iter().filter(|law| lines.lines.iter().any(|line| line.mesh == law.name));
        for output in meshes.filter_map(|law| force(scene.model, law.name)).take(MESHES) {
            let line = |Listed { line, with, amplitude }: &Listed| {
                let place = match lines.varying.contains(&line.mesh) {
                    true => format!("order {} of {}", short(line.order), lines.shaft.name),
                    false => format!("{} Hz", short(line.frequency)),
                };
                format!("{} at {place} ({})", in_words(*amplitude, output.unit), words(line, with))
            };
            let all: Vec<String> = lines.largest(output, PRINTED).into_iter().map(line).collect();
            if !all.is_empty() {
                text += &report::line("mesh lines", &format!("{}: {}", output.name, all.join(", ")), width);
            }
        }
    }
    for (signal, spectrum) in &summary.load_spectra {
        let LoadSpectrum { unit, cycles, largest_range } = spectrum;
        let says = format!("{signal}: {} cycles, ranges up to {}", short(cycles.0), in_words(largest_range.0, unit));
        text += &report::line("load spectrum", &says, width);
    }
    for (signal, sound) in &evaluated.sounds {
        let Sound { stretch, unit, full_scale, .. } = sound;
        let speed = played(stretch.0);
        let says = format!("{signal}, {speed}; loudness is relative: full scale is {}", in_words(full_scale.0, unit));
        text += &report::line("sound", &says, width);
    }
    text
}

/// How fast a sound is played whose playing time is `stretch` times the model time.
fn played(stretch: f64) -> String {
    match stretch {
        1.0 => "played at its real speed and pitch".into(),
        slow if slow > 1.0 => {
            let times = short(slow);
            format!("played {times} times slower than it happens, so that each frequency is divided by {times}")
        }
        fast => {
            let times = short(1.0 / fast);
            format!("played {times} times faster than it happens, so that each frequency is multiplied by {times}")
        }
    }
}

#[test]
fn the_playing_speed_of_a_sound_is_stated_with_the_change_of_frequencies() {
    assert_eq!(played(1.0), "played at its real speed and pitch");
    assert_eq!(played(4.0), "played 4 times slower than it happens, so that each frequency is divided by 4");
    assert_eq!(played(0.5), "played 2 times faster than it happens, so that each frequency is multiplied by 2");
}

/// A line and the multiples of mesh orders that are not separated from it, in words.
fn words(line: &Line, with: &[Line]) -> String {
    let with = with.iter().filter(|with| with.rotor.is_none() || line.rotor.is_some());
    [line].into_iter().chain(with).map(Line::words).collect::<Vec<_>>().join(" or ")
}
