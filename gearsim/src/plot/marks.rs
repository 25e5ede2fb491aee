//! Marks of the mesh lines in spectra: a vertical line at each multiple of a mesh frequency, and a symbol at each sideband that is a
//! separate line, as in the table of lines.

use super::{Marker, Note, Series, Style};
use crate::analysis::orders::{APART, Mesh, PROMINENCE, Rotor, in_lobe, stands_out, term};

/// Multiples of a mesh frequency that are marked with their sidebands.
pub(super) const HARMONICS: usize = 4;
/// Most multiples of a mesh order that are marked: more of them would be too close to each other.
pub(crate) const MOST: usize = 60;
/// Greys of the lines of one mesh after the other, and their dashes.
const LINES: [(&str, &[f64]); 3] = [("#8a8a8a", &[]), ("#8a8a8a", &[6.0, 3.0]), ("#8a8a8a", &[2.0, 3.0])];
/// Symbols of the sidebands of one rotor after the other.
const SYMBOLS: [(&str, Marker); 4] = [
    ("#009e73", Marker::Triangle),
    ("#cc79a7", Marker::Diamond),
    ("#e69f00", Marker::Square),
    ("#56b4e9", Marker::Cross),
];

/// The curve of a spectrum on which sidebands are marked.
pub(super) struct MarkedCurve<'a> {
    /// The curve.
    pub series: &'a Series,
    /// Number of its points in the width of a line.
    pub closer: usize,
    /// The least height of a line, from the median of the curve around it.
    pub least: &'a dyn Fn(f64) -> f64,
}

/// The marks of `meshes` in a panel with values between `low` and `high`, on a curve whose abscissa is a frequency over `unit` \[Hz\].
/// `most` multiples of each mesh frequency, and only up to `end`.
pub(super) fn marks(
    meshes: &[Mesh],
    (unit, end, most): (f64, f64, usize),
    (low, high): (f64, f64),
    MarkedCurve { series: curve, closer, least }: MarkedCurve<'_>,
) -> Vec<Series> {
    let step = curve.x.get(1).copied().unwrap_or(f64::INFINITY);
    let line = step * closer as f64;
    let shown = |x: f64| {
        let inside = x > 0.0 && x <= end && !in_lobe(x * unit, meshes, line * unit);
        inside && stands_out(&curve.y, x / step, closer as f64, least)
    };
    // Rotors have the same symbols in all panels.
    let (mut all, mut number) = (vec![], 0);
    for (m, mesh) in meshes.iter().enumerate() {
        let places: Vec<f64> = (1..=most).map(|n| n as f64 * mesh.frequency / unit).filter(|x| *x <= end).collect();
        let (colour, dashes) = LINES[m % LINES.len()];
        all.push(Series {
            label: if places.is_empty() { String::new() } else { format!("1 to {} × {}", places.len(), mesh.name) },
            x: places.iter().flat_map(|x| [*x, *x, *x]).collect(),
            y: places.iter().flat_map(|_| [low, high, f64::NAN]).collect(),
            style: Style { colour, dashes, width: 0.9, marker: Marker::None },
            note: Note::default(),
        });
        for rotor in &mesh.rotors {
            number += 1;
            let apart = rotor.frequency / unit;
            if apart < APART * line {
                continue;
            }
            let sidebands = rotor.sidebands();
            let around = |x: &f64| sidebands.clone().map(|k| x + f64::from(k) * apart).collect::<Vec<_>>();
            let mut x: Vec<f64> = places.iter().take(HARMONICS).flat_map(around).filter(|x| shown(*x)).collect();
            if x.is_empty() {
                continue;
            }
            x.sort_by(f64::total_cmp);
            let y = x.iter().map(|x| value(curve, x / step)).collect();
            let (colour, marker) = SYMBOLS[number % SYMBOLS.len()];
            let label = format!("sidebands ± {}, above {PROMINENCE} × the median about them", distances(rotor));
            let style = Style { colour, dashes: &[], width: 0.0, marker };
            all.push(Series { label, x, y, style, note: Note::default() });
        }
    }
    all
}

/// The distances of the sidebands of a rotor, as text: `rotor_speed_1`; for a gear of a planet set the multiples of its relative speed.
fn distances(rotor: &Rotor) -> String {
    match rotor.sidebands().max() {
        Some(most) if rotor.meets > 1 => format!("1 to {most} × {}", term(rotor.name)),
        _ => rotor.name.to_owned(),
    }
}

/// The largest value of a curve at the point nearest to the place `at`, and at the two points beside it.
fn value(curve: &Series, at: f64) -> f64 {
    let near = (at.round() as usize).saturating_sub(1)..(at.round() as usize + 2).min(curve.y.len());
    curve.y.get(near).map_or(f64::NAN, |y| y.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}
