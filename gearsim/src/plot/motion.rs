//! The motion: every coordinate against time, with its speed; of one that rolls on, its speed only.

use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, column, first, rolls, scenes, symbol, time};
use crate::model::Coordinate;
use crate::trajectory::Trajectory;

/// Its entry in the registry.
pub const PLOT: Plot = Plot {
    name: "motion",
    doc: "every coordinate and speed against time; of coordinates that roll on, the speed only",
    draw,
};

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let model = first(PLOT.name, runs)?.trajectory.model;
    let mut panels = vec![];
    for coordinate in model.coordinates {
        let (name, unit) = (coordinate.name, coordinate.unit);
        if !runs.iter().any(|run| rolls(run.trajectory, name)) {
            let y = Axis::linear(symbol(name), unit);
            panels.push(panel(runs, coordinate, coordinate.doc, y, |run, i| &run.q[i]));
        }
        let speed = format!("d{}/dt", symbol(name));
        let y = Axis::linear(speed, format!("{unit}/s"));
        let words = format!("speed: {}", coordinate.doc);
        panels.push(panel(runs, coordinate, &words, y, |run, i| &run.q_dot[i]));
    }
    // The names of the runs hold for all panels.
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    Ok(Figure { title: "Motion".into(), subtitle: Some(scenes(runs)), x: time(runs), panels })
}

/// The curves of one quantity in all runs that have it: named by run, or by `words` if there is one run only.
fn panel(
    runs: &[Run<'_>],
    coordinate: &Coordinate,
    words: &str,
    y: Axis,
    quantity: impl Fn(&Trajectory, usize) -> &Vec<f64>,
) -> Panel {
    let mut series = vec![];
    for (n, run) in runs.iter().enumerate() {
        let recorded = run.trajectory;
        let Some(i) = column(recorded, coordinate.name) else {
            continue;
        };
        let label = if runs.len() > 1 { run.label } else { words };
        series.push(Series::new(n, label, recorded.t.clone(), quantity(recorded, i).clone()));
    }
    Panel { y, series }
}
