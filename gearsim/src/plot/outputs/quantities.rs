//! Runs side by side in numbers, in the units of their plots.

use super::compared::first;
use super::sized;
use crate::model::Output;
use crate::output::Summary;
use crate::output::summary::{Number, Observed};
use crate::plot::{Run, coordinate_index, motion};

/// A quantity of several runs.
pub struct Quantity {
    /// Its name, e.g. `mesh_force_12 mean`.
    pub name: String,
    /// The unit of the numbers.
    pub unit: String,
    /// Its value in each run; NaN where the run did not record it.
    pub values: Vec<f64>,
}

/// Mean and rms of the outputs at which engineers look first, then each coordinate and its speed at the end. Each number has the unit of
/// its plot, which suits the largest value of all runs.
pub fn quantities(runs: &[Run<'_>], summaries: &[Summary]) -> Vec<Quantity> {
    let Some(run) = runs.first() else { return vec![] };
    let mut all = vec![];
    let mut add = |name: String, (unit, factor): (&str, f64), value: &dyn Fn(&Summary) -> Option<f64>| {
        let values = summaries.iter().map(|summary| value(summary).map_or(f64::NAN, |x| factor * x)).collect();
        all.push(Quantity { name, unit: unit.to_owned(), values });
    };
    let outputs: Vec<&Output> = run.trajectory.outputs.iter().map(|(output, _)| *output).collect();
    for output in first(&outputs) {
        let unit = sized(output.unit, largest(runs.iter().filter_map(|run| run.trajectory.output(output.name))));
        let of = |s: &Summary, value: fn(&Observed) -> Number| Some(value(s.outputs.get(output.name)?).0);
        add(format!("{} mean", output.name), unit, &|s| of(s, |observed| observed.mean));
        add(format!("{} rms", output.name), unit, &|s| of(s, |observed| observed.rms));
    }
    for coordinate in run.trajectory.model.coordinates {
        let speed = format!("{}_dot", coordinate.name);
        let recorded = runs.iter().filter_map(|run| {
            let i = coordinate_index(run.trajectory, coordinate.name)?;
            Some([run.trajectory.q[i].as_slice(), run.trajectory.q_dot[i].as_slice()])
        });
        let [of, of_speed] = [0, 1].map(|n| largest(recorded.clone().map(|columns| columns[n])));
        let unit = motion::suiting(coordinate.unit, of);
        add(format!("{} at end", coordinate.name), unit, &|s| s.state.get(coordinate.name));
        let per_second = format!("{}/s", coordinate.unit);
        let unit = motion::suiting(&per_second, of_speed);
        add(format!("{speed} at end"), unit, &|s| s.state.get(&speed));
    }
    all
}

/// The largest magnitude in some columns.
fn largest<'a>(columns: impl Iterator<Item = &'a [f64]>) -> f64 {
    columns.flatten().filter(|x| x.is_finite()).fold(0.0, |most: f64, x| most.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot;
    use crate::scene::Scene;

    /// Units of the table are those of the panels, and its numbers those of the summary in them.
    #[test]
    fn numbers_have_the_units_of_the_plots() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/two_stage.toml");
        let results = Scene::load(path).unwrap().with("run.t_end", "20 ms").unwrap().run().unwrap();
        let (runs, summary) = ([results.drawn()], results.summary());
        let all = quantities(&runs, std::slice::from_ref(&summary));
        let panels = |name: &str| (plot::find(name).unwrap().draw)(&runs).unwrap().panels;
        let found = |name: &str| all.iter().find(|quantity| quantity.name == name).unwrap();
        let force = found("mesh_force_12 mean");
        let (drawn, factor) = sized("N", summary.outputs["mesh_force_12"].max.0);
        assert_eq!((&*force.unit, force.values[0]), (drawn, factor * summary.outputs["mesh_force_12"].mean.0));
        // The deflection s1 is drawn in micrometres, the rotation and its speed in rad and rad/s.
        let motion = panels("motion");
        let unit = |label: &str| {
            motion.iter().find(|panel| panel.y.label.starts_with(label)).map(|panel| panel.y.unit.to_string())
        };
        assert_eq!(
            Some(found("s1 at end").unit.clone()),
            unit("s"),
            "{:?}",
            motion.iter().map(|p| (&p.y.label, &p.y.unit)).collect::<Vec<_>>()
        );
        assert_eq!(found("s1 at end").unit, "um");
    }
}
