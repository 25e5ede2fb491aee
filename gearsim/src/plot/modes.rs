//! Mode shapes: one panel per vibrating mode, one stem per coordinate.

use super::{Axis, Figure, Panel, PlotError, Series, Style, symbol};
use crate::analysis::modes::CellModes;
use crate::scene::Scene;

/// Maximum number of panels; the lowest modes are shown.
const MOST: usize = 6;
/// Width of a stem [SVG units].
const STEM: f64 = 7.0;

/// The mode shapes of a cell of `scene`.
///
/// # Errors
/// [`PlotError::Nothing`] if no mode vibrates.
pub fn draw(scene: &Scene, cell: &CellModes) -> Result<Figure, PlotError> {
    let coordinates = scene.model.coordinates;
    let vibrating: Vec<_> = cell.modes.iter().enumerate().filter(|(_, mode)| mode.natural > 0.0).collect();
    if vibrating.is_empty() {
        return Err(PlotError::Nothing { plot: "shapes", why: "every motion is rigid".into() });
    }
    let panels = vibrating.iter().take(MOST).map(|(_, mode)| {
        let complex = mode.shape.iter().any(|z| z.im.abs() > 1e-6);
        let size = mode.shape.iter().map(|z| z.norm()).fold(0.0, f64::max);
        let part = |index: usize, shift: f64, of: &dyn Fn(usize) -> f64, label: &str| {
            let mut series = Series::new(index, label, vec![], vec![]);
            for i in 0..coordinates.len() {
                let x = i as f64 + shift;
                series.x.extend([x, x, x]);
                series.y.extend([0.0, of(i), f64::NAN]);
            }
            series.style = Style { dashes: &[], width: STEM, ..series.style };
            series
        };
        let head = if mode.damped > 0.0 { format!("{} Hz", significant(mode.natural)) } else { "overdamped".into() };
        let mut series = vec![Series {
            style: Style { colour: "#777777", ..Style::PLAIN },
            ..Series::new(0, "", vec![-0.6, coordinates.len() as f64 - 0.4], vec![0.0, 0.0])
        }];
        // q = Re(z e^(i w t)) = Re(z) cos(w t) + Im(z) cos(w t + pi/2): the imaginary part leads.
        if complex {
            series.push(part(0, -0.06, &|i| mode.shape[i].re, &format!("{head}, in phase")));
            series.push(part(1, 0.06, &|i| mode.shape[i].im, "a quarter of a period ahead"));
        } else {
            series.push(part(0, 0.0, &|i| mode.shape[i].re, &head));
        }
        Panel { y: Axis::linear("amplitude", "").between(-1.15 * size, 1.15 * size), series }
    });
    let names = coordinates.iter().map(|c| symbol(c.name)).collect();
    let x = Axis::linear("coordinate", "").between(-0.6, coordinates.len() as f64 - 0.4).named(names);
    let left = vibrating.len().saturating_sub(MOST);
    let more = if left > 0 { format!("; {left} higher modes are in modes.json") } else { String::new() };
    let levels = scene
        .model
        .laws
        .iter()
        .zip(&cell.levels)
        .map(|(law, k)| format!("{} = {} {}", law.name, significant(*k), law.unit));
    let levels: Vec<String> = levels.collect();
    Ok(Figure {
        title: "Mode shapes".into(),
        subtitle: Some(format!("{}; {}{more}", scene.name, levels.join(", "))),
        x,
        panels: panels.collect(),
    })
}

/// `x` rounded to five significant digits.
fn significant(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}
