//! The page of `gearsim work-precision`: error against processor time, times at equal error, all settings.

use super::Page;
use super::html::{Html, TableCell};
use super::shared::{self, Made, figure};
use crate::analysis::work_precision::table::{self, Price, TARGETS};
use crate::analysis::work_precision::{MeasuredFamily, MeasuredSetting, WorkPrecision};
use crate::output::OutputError;
use crate::output::number::short;
use crate::plot;

/// The page of the measurements of a scene. Errors: none.
pub fn page(made: &Made<'_>, measured: &WorkPrecision) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("result", "Result", |html| {
        html.paragraph(&table::words(measured));
        figure::fill(html, "errors", &plot::work_precision::draw(measured));
    });
    page.section("times", "Times at equal error", |html| prices(html, measured));
    page.section("settings", "Settings", |html| settings(html, measured));
    shared::end(&mut page, made);
    Ok(page)
}

fn prices(html: &mut Html, measured: &WorkPrecision) {
    let cell = |curve: &MeasuredFamily, target| match curve.price(target, measured.floor) {
        Price::Seconds(seconds) => TableCell::Number(seconds),
        Price::Never => TableCell::text("never"),
        Price::Over(seconds) => TableCell::text(format!("> {}", short(seconds))),
        Price::Unknown => TableCell::text("?"),
    };
    let row = |curve: &MeasuredFamily| {
        let times = TARGETS.map(|target| cell(curve, target));
        let failures = [curve.failures(), curve.points.len()].map(|n| TableCell::Number(n as f64));
        [TableCell::text(curve.label)].into_iter().chain(times).chain(failures).collect()
    };
    let heads = TARGETS.map(|target| format!("time [s] at error {target:e}"));
    let head = ["method"].into_iter().chain(heads.iter().map(String::as_str)).chain(["failed settings", "settings"]);
    let rows: Vec<Vec<TableCell>> = measured.curves.iter().map(row).collect();
    html.table("Processor time at equal error", &head.collect::<Vec<_>>(), &rows);
    html.paragraph("never: no setting is accurate enough. ?: the error is below that of the reference.");
}

fn settings(html: &mut Html, measured: &WorkPrecision) {
    let row = |curve: &MeasuredFamily, point: &MeasuredSetting| {
        let errors = point.errors.as_ref();
        let errors = errors.map_or([f64::NAN; 3], |errors| [errors.end, errors.path, errors.energy]);
        let counts = [point.evaluations, point.steps, point.events].map(|n| n as f64);
        let numbers = [point.seconds.0, point.seconds.1].into_iter().chain(counts).chain(errors).map(TableCell::Number);
        let remark = match &point.errors {
            Err(why) if !point.tried => why.clone(),
            Err(why) => format!("failed: {why}"),
            Ok(errors) if !point.right_events => format!("failed: {:+} events", errors.events),
            Ok(_) => String::new(),
        };
        let names = [TableCell::text(curve.label), TableCell::text(&point.setting)];
        names.into_iter().chain(numbers).chain([TableCell::text(remark)]).collect()
    };
    let rows = measured.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| row(curve, point)));
    let head = [
        "method",
        "setting",
        "time, least [s]",
        "median [s]",
        "evaluations",
        "steps",
        "events",
        "error at the end",
        "along the path",
        "energy unaccounted for",
        "remarks",
    ];
    html.table("All settings", &head, &rows.collect::<Vec<Vec<TableCell>>>());
    html.paragraph(&format!(
        "Errors are relative to the size of each coordinate and speed; that of a rotating coordinate is one pitch. The error of the \
         reference is {}. Times are those of one core without recording.",
        short(measured.floor)
    ));
}
