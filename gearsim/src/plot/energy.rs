//! The energy U = T + V - W, which only damping may change, its parts, and the residual of the energy balance.
//!
//! In the form of Oh, Grosh and Barber (2005), Fig. 3. Where energy is conserved, U is constant or falls by the dissipated energy;
//! a step up is energy that the equations created. For a single run, U is drawn together with U(0) minus the dissipated energy. The
//! two curves coincide where the residual is zero. A panel with its own scale shows the residual.

use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, Style, first_run, scene_names, time_axis};

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "energy", draw };

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let run = first_run(PLOT.name, runs)?;
    let panels = if runs.len() == 1 { single(run) } else { overlaid(runs) };
    Ok(Figure { title: "Energy".into(), subtitle: Some(scene_names(runs)), x: time_axis(runs), panels })
}

/// The panels of one run: U together with U(0) minus the dissipated energy; the changes of T, V and W; the residual.
fn single(run: &Run<'_>) -> Vec<Panel> {
    let recorded = run.trajectory;
    let series = |index, label: &str, value: &dyn Fn(usize) -> f64| {
        let y = (0..recorded.len()).map(value).collect();
        Series::new(index, label, recorded.t.clone(), y)
    };
    let start = recorded.energy(0);
    let (kinetic, strain) = (recorded.kinetic[0], recorded.strain[0]);
    vec![
        Panel {
            y: Axis::linear("energy", "J"),
            series: vec![
                series(0, "U = T + V − W", &|i| recorded.energy(i)),
                series(1, "U(0) − dissipated", &|i| start - recorded.dissipated[i]),
            ],
        },
        Panel {
            y: Axis::linear("change", "J"),
            series: vec![
                series(0, "T − T(0), kinetic", &|i| recorded.kinetic[i] - kinetic),
                series(1, "V − V(0), strain", &|i| recorded.strain[i] - strain),
                series(2, "W, work of the torques", &|i| recorded.work[i]),
            ],
        },
        Panel {
            y: Axis::linear("residual", "J"),
            series: vec![Series { style: Style::PLAIN, ..series(0, "", &|i| recorded.residual[i]) }],
        },
    ]
}

/// The panels of several runs: U of each; the residual of each.
fn overlaid(runs: &[Run<'_>]) -> Vec<Panel> {
    let panel = |label: &str, value: &dyn Fn(&Run<'_>, usize) -> f64| Panel {
        y: Axis::linear(label, "J"),
        series: (runs.iter().enumerate())
            .map(|(n, run)| {
                let y = (0..run.trajectory.len()).map(|i| value(run, i)).collect();
                Series::new(n, run.label, run.trajectory.t.clone(), y)
            })
            .collect(),
    };
    let mut residual = panel("residual", &|run, i| run.trajectory.residual[i]);
    // The legend of the panel above holds for both.
    residual.unnamed();
    vec![panel("energy U = T + V − W", &|run, i| run.trajectory.energy(i)), residual]
}
