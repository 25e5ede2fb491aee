//! Range of coordinates and speeds: minimum and maximum over samples and both sides of events; mean, and root mean square about the
//! mean, over the evenly spaced samples. Only the speeds of coordinates that rotate continuously.

use super::{Column, Group, column, row_from, with_rotation};
use crate::model::Model;
use crate::run::Outcome;
use crate::trajectory::Moment;

pub(super) const GROUP: Group = Group {
    name: "extremes",
    doc: "of every coordinate and speed after --from: phi_min, phi_max, phi_mean, phi_rms",
    samples: true,
    limits: true,
    digits: false,
    columns,
    values,
};

fn columns(model: &Model) -> Vec<Column> {
    let four = |name: String, unit: String| {
        ["min", "max", "mean", "rms"].map(|what| column(format!("{name}_{what}"), unit.clone()))
    };
    let mut columns = vec![];
    for (c, rotates) in with_rotation(model) {
        if !rotates {
            columns.extend(four(c.name.to_owned(), c.unit.to_owned()));
        }
        columns.extend(four(format!("{}_dot", c.name), format!("{}/s", c.unit)));
    }
    columns
}

fn values(outcome: &Outcome, from: f64) -> Vec<f64> {
    let run = &outcome.trajectory;
    let begin = row_from(run, from);
    let mut values = vec![];
    for ((_, rotates), (q, v)) in with_rotation(run.model).zip(run.q.iter().zip(&run.q_dot)) {
        if !rotates {
            values.extend(statistics(&q[begin..], &run.moment[begin..]));
        }
        values.extend(statistics(&v[begin..], &run.moment[begin..]));
    }
    values
}

/// Minimum, maximum, mean, and root mean square about the mean.
fn statistics(x: &[f64], moments: &[Moment]) -> [f64; 4] {
    let samples = || x.iter().zip(moments).filter(|(_, m)| **m == Moment::Sample).map(|(x, _)| x);
    let n = samples().count() as f64;
    if n == 0.0 {
        return [f64::NAN; 4];
    }
    let least = x.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mean = samples().sum::<f64>() / n;
    let square = samples().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n;
    [least, greatest, mean, square.sqrt()]
}

#[test]
fn the_statistics_of_an_offset_sine_are_exact() {
    let n = 1000;
    let x: Vec<f64> = (0..n).map(|i| 3.0 + 2.0 * (std::f64::consts::TAU * i as f64 / n as f64).sin()).collect();
    let [least, greatest, mean, rms] = statistics(&x, &vec![Moment::Sample; n]);
    // The tolerance allows for the rounding of a sum of 1000 terms.
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
    assert!(near(least, 1.0) && near(greatest, 5.0) && near(mean, 3.0) && near(rms, 2.0_f64.sqrt()));
}
