//! Campbell diagram: natural frequencies and harmonics of the mesh frequencies against the speed, given as a mesh frequency.

use super::{Axis, Figure, Marker, Panel, PlotError, Series, Style};
use crate::analysis::modes::CellModes;
use crate::analysis::steady::SteadyLaw;
use crate::scene::Scene;

/// Number of harmonics drawn of each mesh frequency.
const HARMONICS: usize = 5;

/// The Campbell diagram of a scene. `cell` has its natural frequencies, `courses` the periodic laws of its meshes.
///
/// # Errors
/// [`PlotError::Nothing`] if no mode vibrates, or if no mesh both turns and has a stiffness that steps.
pub fn draw(scene: &Scene, courses: &[SteadyLaw], cell: &CellModes) -> Result<Figure, PlotError> {
    let nothing = |why: &str| PlotError::Nothing { plot: "campbell", why: why.into() };
    let moving: Vec<&SteadyLaw> = courses.iter().filter(|c| c.turns()).collect();
    let first = moving.first().ok_or_else(|| nothing("no mesh of the scene turns and steps"))?;
    let frequencies: Vec<f64> = cell.modes.iter().map(|m| m.damped).filter(|f| *f > 0.0).collect();
    let (Some(lowest), Some(highest)) = (frequencies.first(), frequencies.last()) else {
        return Err(nothing("nothing vibrates"));
    };
    // The abscissa is the mesh frequency of the first law. Both axes end above the highest natural frequency, or above ten times
    // the lowest if that is less; the abscissa at least includes the mesh frequency of the scene.
    let top = 1.2 * highest.min(10.0 * lowest);
    let longest = top.max(1.1 * first.mesh_frequency());
    let mut series = vec![];
    for (i, f) in frequencies.iter().filter(|f| **f <= top).enumerate() {
        let label = if i == 0 { "damped natural frequencies" } else { "" };
        let style = Style { width: 1.7, ..Style::PLAIN };
        series.push(Series { style, ..Series::new(0, label, vec![0.0, longest], vec![*f, *f]) });
    }
    for (l, course) in moving.iter().enumerate() {
        let ratio = course.mesh_frequency() / first.mesh_frequency();
        for harmonic in 1..=HARMONICS {
            let label = if harmonic == 1 {
                format!("harmonics 1 to {HARMONICS} of the mesh {}", course.name)
            } else {
                String::new()
            };
            let end = longest.min(top / (ratio * harmonic as f64));
            let mut line = Series::new(l, label, vec![0.0, end], vec![0.0, ratio * harmonic as f64 * end]);
            line.style = Style { dashes: &[], width: if harmonic == 1 { 1.5 } else { 0.9 }, ..line.style };
            series.push(line);
        }
    }
    let now = first.mesh_frequency();
    let style = Style { colour: "#d55e00", dashes: &[7.0, 3.0], width: 1.3, marker: Marker::None };
    series.push(Series { style, ..Series::new(0, "speed of the scene", vec![now, now], vec![0.0, top]) });
    Ok(Figure {
        title: "Natural frequencies and mesh harmonics".into(),
        subtitle: Some(scene.name.clone()),
        x: Axis::linear(format!("mesh frequency of {}", first.name), "Hz").between(0.0, longest),
        panels: vec![Panel { y: Axis::linear("frequency", "Hz").between(0.0, top), series }],
    })
}
