//! The outcome of a sweep as JSON.

use serde::Serialize;
use serde_json::{Map, Value};

use super::report::remarks;
use crate::output::{OutputError, Table, document};
use crate::sweep::folder::Rows;
use crate::sweep::{Manifest, Status};

/// Version of the format.
const VERSION: u32 = 4;

#[derive(Serialize)]
struct Report<'a> {
    /// The content of `sweep.json`.
    sweep: &'a Manifest,
    /// Number of finished points by the way they ended.
    points: Map<String, Value>,
    /// What a reader of the numbers must know: for each finding the number of points, and the remark of the first one.
    remarks: Vec<String>,
    /// Rows of the tables of answers, by their files without `.csv`; empty until all points are finished.
    answers: Map<String, Value>,
    /// Names of the files in the folder.
    files: &'a [String],
}

/// The text of the JSON document. `answers` are tables by their file names.
///
/// # Errors
/// [`OutputError::Format`].
pub(super) fn json(
    manifest: &Manifest,
    rows: &Rows,
    answers: &[(&str, Table)],
    files: &[String],
) -> Result<String, OutputError> {
    let count = |status: Status| rows.values().filter(|row| row.status == status).count();
    let report = Report {
        sweep: manifest,
        points: Status::ALL.map(|status| (status.name().to_owned(), count(status).into())).into_iter().collect(),
        remarks: remarks(rows),
        answers: answers.iter().map(|(file, table)| (stem(file), document::records(table).into())).collect(),
        files,
    };
    document::json("sweep", VERSION, &report)
}

fn stem(file: &str) -> String {
    file.strip_suffix(".csv").unwrap_or(file).to_owned()
}
