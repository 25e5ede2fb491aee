//! The highest spectral line of each coordinate that does not rotate continuously: its frequency and its density.

use super::{Column, Ended, Group, column, elastic};
use crate::model::Model;
use crate::sweep::spectra;

pub(super) const GROUP: Group = Group {
    name: "peak",
    doc: "highest line of each spectrum after --from: phi_peak_frequency, phi_peak_density",
    samples: true,
    limits: false,
    digits: false,
    outputs: false,
    columns,
    values,
};

fn columns(model: &Model, _: &[usize]) -> Vec<Column> {
    let both = |i: usize| {
        let (name, unit) = (model.coordinates[i].name, model.coordinates[i].unit);
        [column(format!("{name}_peak_frequency"), "Hz"), column(format!("{name}_peak_density"), format!("{unit}^2/Hz"))]
    };
    elastic(model).into_iter().flat_map(both).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let (outcome, from) = (ended.outcome, ended.from);
    let run = &outcome.trajectory;
    elastic(run.model)
        .into_iter()
        .flat_map(|i| {
            let Some(spectrum) = spectra::of(run, i, from) else { return [f64::NAN; 2] };
            // Skip the line at zero frequency: it is the remainder of the mean.
            let lines = spectrum.frequency.iter().zip(&spectrum.density).skip(1);
            lines.max_by(|a, b| a.1.total_cmp(b.1)).map_or([f64::NAN; 2], |(f, p)| [*f, *p])
        })
        .collect()
}
