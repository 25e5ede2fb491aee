//! The recorded outputs against time, in the units of engineers: a panel for each unit, or for each output if several runs are compared.

pub(crate) mod compared;
pub(crate) mod quantities;

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
/// The power through parts and of torques. It is drawn in its own panel, because it would hide the losses.
const POWER: &str = "power";
/// Maximum number of curves in a panel. More would hide each other.
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

/// The recorded outputs with the SI unit `unit`. Those of meshes come first. Within these and within the others, components of forces come
/// last, and before them the outputs of all planets but the first.
pub(super) fn of_unit(run: &Trajectory, unit: &str) -> Vec<&'static Output> {
    let mut all: Vec<&'static Output> = run.outputs.iter().map(|(output, _)| *output).collect();
    all.retain(|output| output.unit == unit);
    let component = |name: &str| ["_x", "_y", "_radial", "_tangential"].iter().any(|axis| name.ends_with(axis));
    all.sort_by_key(|output| (!is_first(output.name), component(output.name), is_further_planet(output.name)));
    all
}

/// Whether engineers look at an output before the others: the force and the transmission error of a mesh. Its deflection comes later.
pub fn is_first(output: &str) -> bool {
    output.starts_with("mesh") && !output.starts_with("mesh_deflection")
}

/// Whether an output is ever different from zero. An output that is always zero belongs to an effect that the scene does not have, or to a
/// damper without damping.
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
        let apart = apart(run.trajectory, &of_unit);
        left_out += apart.iter().skip(MOST).map(|(names, _)| names.len()).sum::<usize>();
        let curve = |(i, (names, column)): (usize, &(Vec<&str>, &[f64]))| {
            Series::new(i, names.join(" = "), run.trajectory.t.clone(), column.to_vec())
        };
        let mut series: Vec<Series> = apart.iter().take(MOST).enumerate().map(curve).collect();
        let shown = scale(&mut series, unit);
        // Angles, such as twists, are drawn only if no output is a length, which would show the same.
        let told = unit == "rad" && run.trajectory.outputs.iter().any(|(output, _)| output.unit == "m");
        if !series.is_empty() && !told {
            panels.push(Panel { y: Axis::linear(quantity, shown), series });
        }
    }
    (panels, left_out)
}

/// Columns that differ by less than this part of their largest value are drawn as one curve: it is a fraction of a line width.
const SAME: f64 = 1e-3;

/// Whether two columns are the same curve in a plot.
pub(crate) fn same(a: &[f64], b: &[f64]) -> bool {
    let largest = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * largest)
}

/// The curves of some outputs, each with the names of those that are the same curve.
fn apart<'a>(run: &'a Trajectory, outputs: &[&'static Output]) -> Vec<(Vec<&'static str>, &'a [f64])> {
    let mut apart: Vec<(Vec<&'static str>, &'a [f64])> = vec![];
    for output in outputs {
        let Some(column) = run.output(output.name) else { continue };
        match apart.iter_mut().find(|(_, known)| same(known, column)) {
            Some((names, _)) => names.push(output.name),
            None => apart.push((vec![output.name], column)),
        }
    }
    apart
}

/// Whether an output is that of a planet's mesh, but not of the first planet: `mesh_force_s2`. The first stands for all.
pub(crate) fn is_further_planet(output: &str) -> bool {
    let part = output.rsplit('_').next().unwrap_or_default();
    let number = part.strip_prefix(['s', 'r']).and_then(|number| number.parse::<usize>().ok());
    number.is_some_and(|number| number > 1)
}

#[test]
fn further_planets_come_after_all_other_meshes() {
    for (output, further) in
        [("mesh_force_s1", false), ("dte_p_r12", true), ("mesh_force_12", false), ("speed_s", false)]
    {
        assert_eq!(is_further_planet(output), further, "{output}");
    }
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
