//! The motion: every coordinate and its speed against time, in units that suit their size. If a coordinate rotates continuously, only its
//! speed is drawn.

use super::figure::largest;
use super::{
    Axis, Figure, Panel, Plot, PlotError, Run, Series, coordinate_index, first_run, rotates, scene_names, symbol,
    time_axis,
};
use crate::model::Coordinate;
use crate::output::unit::readable;
use crate::trajectory::Trajectory;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "motion", draw };

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let model = first_run(PLOT.name, runs)?.trajectory.model;
    let mut panels = vec![];
    for coordinate in model.coordinates {
        let (name, unit) = (coordinate.name, coordinate.unit);
        if !runs.iter().any(|run| rotates(run.trajectory, name)) {
            let label = (symbol(name), unit.to_owned());
            panels.push(panel(runs, coordinate, coordinate.doc, label, |run, i| &run.q[i]));
        }
        let speed = format!("d{}/dt", symbol(name));
        let words = format!("speed: {}", coordinate.doc);
        panels.push(panel(runs, coordinate, &words, (speed, format!("{unit}/s")), |run, i| &run.q_dot[i]));
    }
    // The legend of the first panel holds for all.
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    Ok(Figure { title: "Motion".into(), subtitle: Some(scene_names(runs)), x: time_axis(runs), panels })
}

/// A panel with one quantity in all runs that have it. The legend names the runs, or shows `words` if there is only one run.
fn panel(
    runs: &[Run<'_>],
    coordinate: &Coordinate,
    words: &str,
    (label, unit): (String, String),
    quantity: impl Fn(&Trajectory, usize) -> &Vec<f64>,
) -> Panel {
    let mut series = vec![];
    for (n, run) in runs.iter().enumerate() {
        let recorded = run.trajectory;
        let Some(i) = coordinate_index(recorded, coordinate.name) else {
            continue;
        };
        let name = if runs.len() > 1 { run.label } else { words };
        series.push(Series::new(n, name, recorded.t.clone(), quantity(recorded, i).clone()));
    }
    let (unit, factor) = suiting(&unit, largest(&series));
    series.iter_mut().flat_map(|s| &mut s.y).for_each(|y| *y *= factor);
    Panel { y: Axis::linear(label, unit), series }
}

/// The unit of the motion whose SI unit is `unit`, for values up to `largest`, and the factor to it.
pub(crate) fn suiting(unit: &str, largest: f64) -> (&str, f64) {
    // Most angles are rotations, and their speeds are not those of rotors.
    if unit.starts_with("rad") { (unit, 1.0) } else { readable(unit, largest) }
}
