//! Load duration: a load over the share of time in which it is exceeded.

use super::outputs::scale;
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names};

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "load_duration", draw };

/// Most points of a curve: more would not be visible.
const POINTS: usize = 2000;

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let mut panels = vec![];
    for &name in &first.asked.rainflow {
        let mut series = vec![];
        let mut si = "";
        for (n, run) in runs.iter().enumerate() {
            let Some((unit, column)) = run.trajectory.signal(name) else { continue };
            si = unit;
            let begin = run.trajectory.row_from(run.asked.from);
            let rows = run.trajectory.samples().filter(|row| *row >= begin);
            let mut samples: Vec<f64> = rows.map(|row| column[row]).collect();
            samples.retain(|x| x.is_finite());
            samples.sort_by(|a, b| b.total_cmp(a));
            let last = samples.len().saturating_sub(1);
            let points = last.clamp(1, POINTS);
            let place = |i: usize| i * last / points;
            let x = (0..=points).map(|i| 100.0 * place(i) as f64 / last.max(1) as f64).collect();
            let y = (0..=points).map(|i| samples.get(place(i)).copied().unwrap_or(f64::NAN)).collect();
            let label = if runs.len() > 1 { run.label } else { name };
            series.push(Series::new(n, label, x, y));
        }
        let shown = scale(&mut series, si);
        panels.push(Panel { y: Axis::linear(name, shown), series });
    }
    if panels.is_empty() {
        let why = "the scene names no signal in `[output] rainflow`".into();
        return Err(PlotError::Nothing { plot: PLOT.name, why });
    }
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    let x = Axis::linear("share of time in which it is exceeded", "%").between(0.0, 100.0);
    Ok(Figure { title: "Load duration".into(), subtitle: Some(scene_names(runs)), x, panels })
}
