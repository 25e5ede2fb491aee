//! Losses by cause: the recorded powers that are lost, integrated over the run.
//!
//! The integrals use the trapezoidal rule between the recorded rows. Both sides of an event are rows at one time, so that no interval
//! contains a jump.

use super::Report;
use crate::output::number::short;
use crate::page::html::{Html, TableCell};
use crate::trajectory::Trajectory;

/// Writes the table; nothing if no loss is recorded.
pub(super) fn table(report: &Report<'_>, html: &mut Html) {
    let run = &report.run.outcome.trajectory;
    let causes = by_cause(run);
    let Some(total) = run.dissipated.last().filter(|_| !causes.is_empty()) else { return };
    let rest = total - causes.iter().map(|(_, _, energy)| energy).sum::<f64>();
    let row = |name: &str, energy: f64, doc: &str| {
        // Without losses there is no share.
        let share = if *total > 0.0 { TableCell::Number(100.0 * energy / total) } else { TableCell::text("-") };
        vec![TableCell::text(name), TableCell::Number(energy), share, TableCell::text(doc)]
    };
    let mut rows: Vec<_> = causes.iter().map(|(name, doc, energy)| row(name, *energy, doc)).collect();
    rows.push(row(
        "rest",
        rest,
        "lost by causes that are not recorded and at events, and the error of this integration",
    ));
    html.table("Losses by cause", &["cause", "lost [J]", "share [%]", "what it is"], &rows);
    html.paragraph(&format!(
        "The power of each cause is integrated between the {} recorded rows. With the rest, the sum is the {} J lost in the account.",
        run.len(),
        short(*total)
    ));
}

/// Name, description and energy \[J\] of each recorded loss.
fn by_cause(run: &Trajectory) -> Vec<(&'static str, &'static str, f64)> {
    let losses = run.outputs.iter().filter(|(output, _)| output.is_loss());
    losses.map(|(output, power)| (output.name, output.doc, integral(&run.t, power))).collect()
}

/// The integral of `x` over `t`, by the trapezoidal rule.
fn integral(t: &[f64], x: &[f64]) -> f64 {
    t.windows(2).zip(x.windows(2)).map(|(t, x)| 0.5 * (t[1] - t[0]) * (x[0] + x[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;

    #[test]
    fn a_jump_between_two_rows_of_one_time_has_no_area() {
        assert_eq!(integral(&[0.0, 1.0, 1.0, 4.0], &[0.0, 2.0, 4.0, 4.0]), 13.0);
    }

    /// The account integrates the loss in the engine; the sum of the causes comes from the recorded powers.
    #[test]
    fn the_causes_sum_to_the_loss_of_the_account() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/gear_pair_teeth.toml");
        let scene = Scene::load(path).unwrap();
        let run = scene.run().unwrap();
        let run = run.trajectory();
        let causes = by_cause(run);
        let (sum, total) = (causes.iter().map(|(_, _, energy)| energy).sum::<f64>(), run.dissipated[run.len() - 1]);
        assert!(!causes.is_empty() && total > 0.0);
        // The error of the trapezoidal rule at this sampling rate.
        assert!((sum / total - 1.0).abs() < 1e-3, "{sum} J of {total} J");
    }
}
