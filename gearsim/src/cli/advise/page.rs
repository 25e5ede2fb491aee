//! The parts of the page of `gearsim advise`: its conclusions, its figure and its table.

use std::borrow::Cow;

use super::table;
use crate::analysis::advise::{Apart, LIMITS};
use crate::library::advise::Advice;
use crate::output::table::Values;
use crate::output::{OutputError, Table};
use crate::plot::{Axis, Figure, Marker, Panel, Series, Style};

/// Smallest ratio of a deviation to its limit that is drawn. Smaller ratios, and zero, are drawn at this value of the logarithmic axis.
const LEAST: f64 = 1e-6;

/// Everything that the terminal says besides the table of deviations.
pub(super) fn conclusions(advice: &Advice) -> Vec<(String, String)> {
    let concluded = table::conclusions(advice).into_iter().map(|(name, says)| (name.to_owned(), says));
    concluded.chain(table::groups(advice)).collect()
}

/// The largest deviation of each candidate over its limit: estimated, and between full runs. `None` without any.
pub(super) fn figure(scene: &str, advice: &Advice) -> Option<Figure> {
    let worst = |apart: &Apart| {
        let shares = apart.each().into_iter().zip(LIMITS.each()).map(|(x, limit)| (x / limit).abs());
        shares.filter(|share| share.is_finite()).fold(LEAST, f64::max)
    };
    let series = |index: usize, label: &str, marker: Marker, deviations: Vec<Option<&Apart>>| {
        let points = deviations.into_iter().enumerate().filter_map(|(i, apart)| Some((i as f64, worst(apart?))));
        let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
        let series = Series::new(index, label, x, y);
        Series { style: Style { marker, width: 0.0, ..series.style }, ..series }
    };
    let verdicts = &advice.verdicts;
    let estimates = verdicts.iter().map(|verdict| verdict.estimate.deviation()).collect();
    let truths = verdicts.iter().map(|verdict| verdict.truth.as_ref().ok()).collect();
    let estimates = series(0, "estimate", Marker::Dot, estimates);
    let truths = series(1, "full runs", Marker::Square, truths);
    if estimates.x.is_empty() && truths.x.is_empty() {
        return None;
    }
    let ends = (-0.5, verdicts.len() as f64 - 0.5);
    let limit = Series::new(2, "limit: below it the effect is negligible", vec![ends.0, ends.1], vec![1.0; 2]);
    let names = verdicts.iter().map(|verdict| verdict.candidate.without.clone()).collect();
    Some(Figure {
        title: "Largest deviation without an effect, over its limit".into(),
        subtitle: Some(scene.to_owned()),
        x: Axis::linear("left out", "").between(ends.0, ends.1).named(names),
        panels: vec![Panel { y: Axis::log10("deviation over its limit", ""), series: vec![estimates, truths, limit] }],
    })
}

/// The deviations as a table. Each candidate has two rows: one estimated, one from full runs. The last row has the limits.
pub(super) fn deviations(advice: &Advice) -> Result<Table, OutputError> {
    let mut names: [Vec<Cow<'static, str>>; 4] = Default::default();
    let (mut numbers, mut times) = (vec![], vec![]);
    let mut add = |texts: [&str; 4], apart: Option<&Apart>, time: f64| {
        names.iter_mut().zip(texts).for_each(|(column, text)| column.push(text.to_owned().into()));
        numbers.push(apart.map_or([f64::NAN; 6], Apart::each));
        times.push(time);
    };
    let verdict_in_words = |small: Option<bool>| small.map_or("", |small| if small { "negligible" } else { "needed" });
    for verdict in &advice.verdicts {
        let (without, (estimated, measured)) = (&*verdict.candidate.without, verdict.negligible());
        let why = verdict.estimate.why_not().unwrap_or("");
        let estimate = [without, "estimate", verdict_in_words(estimated), why];
        add(estimate, verdict.estimate.deviation(), f64::NAN);
        let why = verdict.truth.as_ref().err().map_or(&*verdict.candidate.how, |why| why);
        add([without, "full runs", verdict_in_words(measured), why], verdict.truth.as_ref().ok(), verdict.time);
    }
    add(["limits", "", "", ""], Some(&LIMITS), f64::NAN);
    let [without, from, verdicts, remarks] = names;
    let mut table = Table::default();
    table.push("without", "", Values::Text(without))?;
    table.push("from", "", Values::Text(from))?;
    for (i, name) in Apart::NAMES.into_iter().enumerate() {
        let unit = if name == "bands" { "dB" } else { "1" };
        table.push(name, unit, Values::Number(numbers.iter().map(|row| row[i]).collect()))?;
    }
    table.push("time_ratio", "1", Values::Number(times))?;
    table.push("verdict", "", Values::Text(verdicts))?;
    table.push("remark", "", Values::Text(remarks))?;
    Ok(table)
}
