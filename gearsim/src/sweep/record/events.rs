//! The time reached, and the numbers of events.

use super::{Column, Ended, Group, column, last};
use crate::model::Model;
use crate::run::Outcome;
use crate::trajectory::Moment;

pub(super) const GROUP: Group = Group {
    name: "events",
    doc: "t_end, cell_changes, reflections, holds, impacts, grazes, ambiguous, first_reflection",
    samples: false,
    limits: true,
    digits: false,
    outputs: false,
    columns,
    values,
};

fn columns(_: &Model, _: &[usize]) -> Vec<Column> {
    let counts = ["cell_changes", "reflections", "holds", "impacts", "grazes", "ambiguous"];
    let mut columns = vec![column("t_end", "s")];
    columns.extend(counts.map(|name| column(name, "1")));
    columns.push(column("first_reflection", "s"));
    columns
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let outcome = ended.outcome;
    let counts = &outcome.counts;
    let counted =
        [counts.cell_changes, counts.reflections, counts.holds, counts.impacts, counts.cost.grazes, counts.ambiguous];
    let mut values = vec![last(&outcome.trajectory.t)];
    values.extend(counted.map(|n| n as f64));
    values.push(first_reflection(outcome));
    values
}

/// Time of the first reflection, where a phase speed changes its sign at an event [s]; NaN if there is none.
fn first_reflection(outcome: &Outcome) -> f64 {
    let run = &outcome.trajectory;
    let phases: Vec<&Vec<f64>> = (run.model.coordinates.iter().zip(&run.q_dot))
        .filter(|(c, _)| run.model.laws.iter().any(|law| law.phase == c.name))
        .map(|(_, speed)| speed)
        .collect();
    let back = |i: usize| phases.iter().any(|v| (v[i - 1] < 0.0) != (v[i] < 0.0));
    let turns = |i: &usize| run.moment[*i] == Moment::After && back(*i);
    match outcome.counts.reflections {
        0 => f64::NAN,
        _ => (1..run.len()).find(turns).map_or(f64::NAN, |i| run.t[i]),
    }
}
