//! The recorded outputs against time, in the units of engineers: a panel for each unit, or for each output if several runs are compared.

pub(crate) mod compared;

use super::figure::largest;
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names, time_axis};
use crate::model::Output;
use crate::output::unit::readable;
use crate::trajectory::Trajectory;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "outputs", draw };

/// The units in the order of their panels, each with the quantity, the unit that engineers use, and the factor to it.
const UNITS: [(&str, &str, &str, f64); 7] = [
    ("rad/s", "speed", "rpm", 30.0 / std::f64::consts::PI),
    ("N", "force", "N", 1.0),
    ("N*m", "torque", "N*m", 1.0),
    ("m", "transmission error", "um", 1e6),
    ("rad", "angle", "rad", 1.0),
    ("W", "loss", "W", 1.0),
    ("W", POWER, "W", 1.0),
];
/// What is drawn apart from the losses, which it would hide: the power through parts and of torques.
const POWER: &str = "power";
/// Most curves in a panel; the others would hide them.
const MOST: usize = 6;

/// The unit that engineers use for the SI unit `unit`, and the factor to it.
pub fn engineering(unit: &'static str) -> (&'static str, f64) {
    UNITS.iter().find(|known| known.0 == unit).map_or((unit, 1.0), |known| (known.2, known.3))
}

/// Forces and torques from this size on are in kN or MN \[N\], \[N m\].
const LARGE: f64 = 1e4;

/// The same for values up to `largest`: powers are in W, kW or MW, large forces and torques in kN or MN.
pub(super) fn sized(unit: &'static str, largest: f64) -> (&'static str, f64) {
    match unit {
        "W" => readable(unit, largest),
        "N" | "N*m" if largest >= LARGE => readable(unit, largest),
        _ => engineering(unit),
    }
}

/// Brings curves in the SI unit `unit` to the unit that suits their size, and returns it.
pub(super) fn scale(series: &mut [Series], unit: &'static str) -> &'static str {
    let (shown, factor) = sized(unit, largest(series));
    series.iter_mut().flat_map(|series| &mut series.y).for_each(|y| *y *= factor);
    shown
}

/// The recorded outputs with the SI unit `unit`: those of meshes first, components of forces last.
pub(super) fn of_unit(run: &Trajectory, unit: &str) -> Vec<&'static Output> {
    let mut all: Vec<&'static Output> = run.outputs.iter().map(|(output, _)| *output).collect();
    all.retain(|output| output.unit == unit);
    let component = |name: &str| ["_x", "_y", "_radial", "_tangential"].iter().any(|axis| name.ends_with(axis));
    all.sort_by_key(|output| (!is_first(output.name), component(output.name)));
    all
}

/// Whether engineers look at an output before the others: the force and the transmission error of a mesh. Its deflection comes later.
pub fn is_first(output: &str) -> bool {
    output.starts_with("mesh") && !output.starts_with("mesh_deflection")
}

/// Whether an output is not zero throughout. One that is belongs to an effect that the scene does not have, or to a damper without damping.
fn acts(run: &Run<'_>, output: &Output) -> bool {
    run.trajectory.output(output.name).is_some_and(|column| column.iter().any(|x| *x != 0.0))
}

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let (mut panels, left_out) = if runs.len() > 1 { compared::panels(runs) } else { of_one(first) };
    // The legend of the first panel holds for all.
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    if panels.is_empty() {
        return Err(PlotError::Nothing {
            plot: PLOT.name,
            why: "the run recorded no outputs that differ from zero".into(),
        });
    }
    let mut subtitle = scene_names(runs);
    if left_out > 0 {
        subtitle += &format!("; {left_out} more in the table of results");
    }
    Ok(Figure { title: "Outputs".into(), subtitle: Some(subtitle), x: time_axis(runs), panels })
}

/// The panels of one run, one for each unit, and how many outputs they leave out.
fn of_one(run: &Run<'_>) -> (Vec<Panel>, usize) {
    let (mut panels, mut left_out) = (vec![], 0);
    for (unit, quantity, ..) in UNITS {
        let mut of_unit = of_unit(run.trajectory, unit);
        of_unit.retain(|output| output.is_power() == (quantity == POWER) && acts(run, output));
        left_out += of_unit.len().saturating_sub(MOST);
        let mut series = vec![];
        for output in of_unit.iter().take(MOST) {
            let Some(column) = run.trajectory.output(output.name) else { continue };
            series.push(Series::new(series.len(), output.name, run.trajectory.t.clone(), column.to_vec()));
        }
        let shown = scale(&mut series, unit);
        // Angles, such as twists, only where no length tells as much.
        let told = unit == "rad" && run.trajectory.outputs.iter().any(|(output, _)| output.unit == "m");
        if !series.is_empty() && !told {
            panels.push(Panel { y: Axis::linear(quantity, shown), series });
        }
    }
    (panels, left_out)
}

#[test]
fn large_forces_and_torques_are_in_kn_or_mn() {
    let cases = [("N", 9.9e3, "N"), ("N", 1e4, "kN"), ("N*m", 2e6, "MN*m"), ("W", 3e3, "kW"), ("m", 1e-5, "um")];
    for (unit, largest, shown) in cases {
        assert_eq!(sized(unit, largest).0, shown, "{largest} {unit}");
    }
    let mut series = [Series::new(0, "force", vec![0.0, 1.0], vec![-2e5, 1e5])];
    assert_eq!((scale(&mut series, "N"), &series[0].y[..]), ("kN", &[-200.0, 100.0][..]));
}
