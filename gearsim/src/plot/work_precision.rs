//! Work-precision diagram: error against processor time, one curve per method, one point per setting. One panel shows the error of
//! the motion, the other the energy residual.

use super::figure::{Axis, Figure, Marker, Panel, Series};
use crate::analysis::work_precision::{Errors, MeasuredSetting, WorkPrecision};

/// A relative error above this has no meaning.
const LOST: f64 = 10.0;
/// Settings without a measured error are drawn at LOST * FAILED; larger errors are capped there.
const FAILED: f64 = 10.0;

/// Draws the measurements of a scene.
pub fn draw(measured: &WorkPrecision) -> Figure {
    let times = || measured.curves.iter().flat_map(|c| &c.points).map(|p| p.seconds.0).filter(|t| t.is_finite());
    let (low, high) = super::figure::extremes(times());
    let (low, high) = if low < high { (low / 1.6, high * 1.6) } else { (low / 10.0, low * 10.0) };
    let floor = measured.floor;
    let mut path = panel(measured, "error along the path", |errors| errors.path.max(floor));
    let mut line = Series::new(2, format!("error of the reference, {floor:.0e}"), vec![low, high], vec![floor; 2]);
    (line.style.dashes, line.style.colour, line.style.width) = (&[2.0, 3.0], "#777777", 1.0);
    path.series.push(line);
    let mut energy = panel(measured, "energy unaccounted for", |errors| errors.energy.max(1e-17));
    energy.unnamed();
    Figure {
        title: "Error against processor time".into(),
        subtitle: Some(format!(
            "{}: {} events; one mark per setting; crosses: failed (stopped early, or met other events)",
            measured.scene, measured.events
        )),
        x: Axis::log10("processor time", "s").between(low, high),
        panels: vec![path, energy],
    }
}

/// A panel that shows the error chosen by `of`.
fn panel(measured: &WorkPrecision, label: &str, of: impl Fn(&Errors) -> f64) -> Panel {
    let mut series = vec![];
    for (i, curve) in measured.curves.iter().enumerate() {
        let points = || curve.points.iter().filter(|point| point.tried);
        let failed = |point: &&MeasuredSetting| point.failed();
        let place = |point: &MeasuredSetting| {
            let error = point.errors.as_ref().map_or(LOST * FAILED, |errors| of(errors).min(LOST * FAILED));
            (point.seconds.0, error)
        };
        let mut good: Vec<_> = points().filter(|p| !failed(p)).map(place).collect();
        good.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (x, y) = good.into_iter().unzip();
        let mut line = Series::new(i, curve.label, x, y);
        line.style.marker = Marker::nth(i);
        line.style.width = if curve.points.len() > 1 { 1.2 } else { 0.0 };
        let colour = line.style.colour;
        series.push(line);
        let (x, y) = points().filter(failed).map(place).unzip();
        let mut crosses = Series::new(i, "", x, y);
        (crosses.style.marker, crosses.style.width, crosses.style.colour) = (Marker::Cross, 0.0, colour);
        series.push(crosses);
    }
    Panel { y: Axis::log10(label, ""), series }
}
