//! Mode shapes by energy: for each vibrating mode the share of every inertia in the kinetic energy, with the sign of its motion, and
//! the share of every mesh and spring in the strain energy. Shares have no unit, so that rotations and displacements stand on one axis.

use super::{Axis, Figure, Panel, PlotError, Series, Style, symbol};
use crate::analysis::modes::masses::{Body, bodies};
use crate::analysis::modes::{CellModes, Parts, Vibration};
use crate::scene::Scene;

/// Maximum number of panels; the lowest modes are shown.
const MOST: usize = 6;
/// Most levels of laws that the subtitle has room for.
const LEVELS: usize = 3;
/// Width of a stem [SVG units].
const STEM: f64 = 9.0;
/// Springs and inertias with a smaller share of the energy in each of the modes are left out.
const LEAST: f64 = 0.01;

/// The mode shapes of a cell of `scene`. Modes have the same numbers as in `cell`.
///
/// # Errors
/// [`PlotError::Nothing`] if no mode vibrates.
pub fn draw(scene: &Scene, cell: &CellModes, parts: &Parts) -> Result<Figure, PlotError> {
    let Parts { springs, masses } = parts;
    let vibrating: Vec<_> = cell.modes.iter().enumerate().filter(|(_, mode)| mode.natural > 0.0).collect();
    if vibrating.is_empty() {
        return Err(PlotError::Nothing { plot: "shapes", why: "every motion is rigid".into() });
    }
    let shown = &vibrating[..vibrating.len().min(MOST)];
    let large = |share: &dyn Fn(&Vibration) -> f64| shown.iter().any(|(_, mode)| share(mode).abs() >= LEAST);
    let kinetic =
        |body: &Body<'_>, mode: &Vibration| body.share(&mode.shape, mode.kinetic[body.mass], &masses[body.mass]);
    let mut heavy = bodies(masses);
    heavy.retain(|body| large(&|mode: &Vibration| kinetic(body, mode)));
    let laws: Vec<&str> = scene.stiffnesses().map(|(law, _)| law.name).collect();
    let elastic: Vec<usize> =
        (0..laws.len() + springs.len()).filter(|&i| large(&|mode: &Vibration| strain(mode, i))).collect();
    let names = heavy.iter().map(|body| match body.coordinate {
        None => symbol(body.name),
        Some(own) => format!("{}: {}", symbol(body.name), symbol(own)),
    });
    let names = names.chain(
        elastic.iter().map(|&i| laws.get(i).copied().unwrap_or_else(|| springs[i - laws.len()].name).to_owned()),
    );
    let names: Vec<String> = names.collect();
    let end = names.len() as f64 - 0.4;
    let panels = shown.iter().map(|(number, mode)| {
        let head = if mode.damped > 0.0 { format!("{} Hz", significant(mode.natural)) } else { "overdamped".into() };
        let kinetic = heavy.iter().map(|body| 100.0 * kinetic(body, mode));
        let elastic = elastic.iter().map(|&i| 100.0 * strain(mode, i));
        let first = format!("mode {number}, {head}: kinetic energy, with the sign of the motion");
        let series = vec![
            Series {
                style: Style { colour: "#777777", ..Style::PLAIN },
                ..Series::new(0, "", vec![-0.6, end], vec![0.0, 0.0])
            },
            stems(0, first, 0, kinetic),
            stems(1, "strain energy".into(), heavy.len(), elastic),
        ];
        Panel { y: Axis::linear("share", "%").between(-105.0, 105.0), series }
    });
    let x = Axis::linear("inertias, meshes and springs", "").between(-0.6, end).named(names);
    let left = vibrating.len().saturating_sub(MOST);
    let more = if left > 0 { format!("; {left} higher modes are in modes.json") } else { String::new() };
    let levels = scene.model.laws.iter().zip(&cell.levels);
    let levels = levels.map(|(law, k)| format!("{} = {} {}", law.name, significant(*k), law.unit));
    let levels: Vec<String> = levels.take(LEVELS + 1).collect();
    let levels = if levels.len() > LEVELS { "levels in modes.json".into() } else { levels.join(", ") };
    Ok(Figure {
        title: "Modes by energy".into(),
        subtitle: Some(format!("{}; {levels}{more}", scene.name)),
        x,
        panels: panels.collect(),
    })
}

/// Share of the part `i` in the strain energy. The parts are the laws, then the springs.
fn strain(mode: &Vibration, i: usize) -> f64 {
    mode.strain.iter().chain(&mode.springs).nth(i).copied().unwrap_or(0.0)
}

/// A stem for each value, from the place `first` on.
fn stems(index: usize, label: String, first: usize, values: impl Iterator<Item = f64>) -> Series {
    let mut series = Series::new(index, label, vec![], vec![]);
    for (i, value) in values.enumerate() {
        let x = (first + i) as f64;
        series.x.extend([x, x, x]);
        series.y.extend([0.0, value, f64::NAN]);
    }
    series.style = Style { dashes: &[], width: STEM, ..series.style };
    series
}

/// `x` rounded to five significant digits.
fn significant(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}
