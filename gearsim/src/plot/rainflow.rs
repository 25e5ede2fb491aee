//! Load spectra: the ranges of a load over the number of cycles in which they are exceeded, by rainflow counting.

use super::outputs::scale;
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names};
use crate::analysis::rainflow;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "rainflow", draw };

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let mut panels = vec![];
    for &name in &first.asked.rainflow {
        let mut series = vec![];
        let mut si = "";
        for (n, run) in runs.iter().enumerate() {
            let Some((unit, column)) = run.trajectory.signal(name) else { continue };
            si = unit;
            let mut cycles = rainflow::count(&column[run.trajectory.row_from(run.asked.from)..]);
            cycles.sort_by(|a, b| b.range.total_cmp(&a.range));
            // A staircase from the largest range down: each range is reached in so many cycles.
            let (mut x, mut y, mut sum) = (vec![], vec![], 0.0);
            for cycle in cycles.iter().filter(|cycle| cycle.range > 0.0) {
                x.extend([if sum == 0.0 { 0.5 * cycle.count } else { sum }, sum + cycle.count]);
                y.extend([cycle.range; 2]);
                sum += cycle.count;
            }
            let label = if runs.len() > 1 { run.label } else { name };
            series.push(Series::new(n, label, x, y));
        }
        let shown = scale(&mut series, si);
        if series.iter().any(|series| !series.x.is_empty()) {
            panels.push(Panel { y: Axis::linear(format!("range of {name}"), shown), series });
        }
    }
    if panels.is_empty() {
        let why = "the scene names no signal that varies in `[output] rainflow`".into();
        return Err(PlotError::Nothing { plot: PLOT.name, why });
    }
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    let subtitle = format!("{}; rainflow counts by ASTM E1049, half cycles as 0.5", scene_names(runs));
    let x = Axis::log10("cycles with at least this range", "");
    Ok(Figure { title: "Load spectrum".into(), subtitle: Some(subtitle), x, panels })
}
