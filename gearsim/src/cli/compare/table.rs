//! The comparison as a table for the terminal.

use super::ComparedRun;
use crate::cli::{number, report};
use crate::output::Summary;
use crate::plot::outputs::quantities::quantities;

/// The table: one column per set of equations, one line per quantity.
pub(in crate::cli) fn render(members: &[ComparedRun], summaries: &[Summary]) -> String {
    let mut lines = vec![line("", "", members.iter().map(|m| m.set.label.to_owned()).collect())];
    let mut add = |name: &str, unit: &str, value: &dyn Fn(&Summary) -> String| {
        lines.push(line(name, unit, summaries.iter().map(value).collect()));
    };
    add("simulated", "s", &|s| number::short(s.t_end.0));
    add("cell changes", "", &|s| s.cell_changes.to_string());
    add("reflections", "", &|s| s.reflections.to_string());
    add("energy at start", "J", &|s| number::short(s.energy.at_start.0));
    add("lost to damping", "J", &|s| number::short(s.energy.dissipated.0));
    add("unaccounted for", "J", &|s| number::short(s.energy.residual.0));
    add("  over that at start", "", &|s| match s.energy.at_start.0 {
        0.0 => "-".into(),
        at_start => number::short((s.energy.residual.0 / at_start).abs()),
    });
    let runs: Vec<_> = members.iter().map(ComparedRun::to_draw).collect();
    let number = |x: f64| if x.is_nan() { "-".into() } else { number::short(x) };
    for quantity in quantities(&runs, summaries) {
        lines.push(line(&quantity.name, &quantity.unit, quantity.values.into_iter().map(number).collect()));
    }
    let mut add = |name: &str, value: &dyn Fn(&Summary) -> String| {
        lines.push(line(name, "", summaries.iter().map(value).collect()));
    };
    add("time taken", &|s| number::time(s.cpu_seconds.0));
    add("  per event", &|s| report::per_event(s).unwrap_or("-".into()));
    lines.concat()
}

fn line(name: &str, unit: &str, values: Vec<String>) -> String {
    let name = if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") };
    let values: String = values.iter().map(|value| format!("{value:>18}")).collect();
    format!("{name:<24}{values}\n")
}
