//! The panels of several runs, one for each output, in the order in which engineers look at them: forces of meshes, transmission errors,
//! speeds, then the first other output of each unit.

use super::{POWER, Panel, Run, Series, UNITS, acts, of_unit, scale};
use crate::model::Output;
use crate::plot::Axis;

/// Most panels of one kind.
const MOST: usize = 3;

/// Whether an output is of a kind, and most panels of this kind.
type Kind = (fn(&Output) -> bool, usize);

/// The panels, and how many outputs they leave out.
pub fn panels(runs: &[Run<'_>]) -> (Vec<Panel>, usize) {
    let Some(run) = runs.first() else { return (vec![], 0) };
    let units = UNITS.iter().filter(|(_, quantity, ..)| *quantity != POWER).map(|(unit, ..)| *unit);
    let mut all: Vec<&Output> = units.flat_map(|unit| of_unit(run.trajectory, unit)).collect();
    all.retain(|output| runs.iter().any(|run| acts(run, output)));
    let mut shown = first(&all);
    let lengths = all.iter().any(|output| output.unit == "m");
    for output in &all {
        // Angles, such as twists, are drawn only if no output is a length, which would show the same.
        let told = output.unit == "rad" && lengths;
        if !told && !shown.iter().any(|other| (other.unit, other.is_power()) == (output.unit, output.is_power())) {
            shown.push(output);
        }
    }
    (shown.iter().map(|output| panel(runs, output)).collect(), all.len() - shown.len())
}

/// Those of the outputs `all` at which engineers look first, in this order: forces of meshes, transmission errors, a speed.
pub fn first<'a>(all: &[&'a Output]) -> Vec<&'a Output> {
    let kinds: [Kind; 3] = [(is_mesh_force, MOST), (is_error, MOST), (|output| output.unit == "rad/s", 1)];
    kinds.iter().flat_map(|(kind, most)| all.iter().filter(|output| kind(output)).take(*most)).copied().collect()
}

fn is_mesh_force(output: &Output) -> bool {
    output.name.starts_with("mesh_force") || output.name.starts_with("mesh_torque")
}

fn is_error(output: &Output) -> bool {
    output.name.starts_with("dte")
}

/// One output in all runs that recorded it.
fn panel(runs: &[Run<'_>], output: &Output) -> Panel {
    let curve = |(i, run): (usize, &Run<'_>)| {
        let column = run.trajectory.output(output.name)?;
        Some(Series::new(i, run.label, run.trajectory.t.clone(), column.to_vec()))
    };
    let mut series: Vec<Series> = runs.iter().enumerate().filter_map(curve).collect();
    let unit = scale(&mut series, output.unit);
    Panel { y: Axis::linear(output.name, unit), series }
}
