//! The outcome of a sweep as text for the terminal.

use std::collections::BTreeMap;
use std::path::Path;

use crate::cli::report::{files as written, line};
use crate::cli::{number, terminal};
use crate::output::remarks;
use crate::sweep::Manifest;
use crate::sweep::folder::Rows;
use crate::sweep::row::Status;

/// Maximum number of reasons of failure that are listed.
const LISTED: usize = 3;

/// What this command added to the sweep.
pub(in crate::cli) struct Progress {
    /// Number of points that were finished before.
    pub(super) before: usize,
    /// Number of points that ran.
    pub(super) ran: usize,
    /// Elapsed time [s].
    pub(super) seconds: f64,
    /// Number of threads.
    pub(super) threads: usize,
    /// The text of the scene.
    pub(super) text: String,
}

/// The outcome of a sweep: its points, the time taken, the failures, the answers and the files. `done` is `None` for a merged sweep.
pub(super) fn summary_text(
    path: &Path,
    files: &[String],
    manifest: &Manifest,
    rows: &Rows,
    done: Option<Progress>,
    answers: &str,
) -> String {
    let width = terminal::width();
    let mut text = line("scene", &manifest.scene, width);
    text += &line("varied", &manifest.vary.join(", "), width);
    let points = match rows.len() == manifest.points {
        true => format!("{}", manifest.points),
        false => format!("{} of {}: `gearsim merge` joins them with the others", rows.len(), manifest.points),
    };
    text += &line("points", &points, width);
    if let Some(done) = done {
        text += &line("time taken", &time(&done), width);
    }
    for (status, what) in
        [(Status::Stopped, "stopped early"), (Status::Refuted, "energy not closed"), (Status::Refused, "refused")]
    {
        let reasons = rows.values().filter(|row| row.status == status).map(|row| row.reason.as_str());
        text += &failed(what, reasons, width);
    }
    text.extend(remarks(rows).iter().map(|remark| line("note", remark, width)));
    text + answers + "\n" + &written(path, files, width)
}

/// The remarks of the points: for each finding the number of points, and the remark of the first one.
pub(super) fn remarks(rows: &Rows) -> Vec<String> {
    remarks::counted("points", rows.values().map(|row| &row.remarks[..]))
}

fn time(done: &Progress) -> String {
    let took = number::time(done.seconds);
    let before = match done.before {
        0 => String::new(),
        n => format!("; {n} points were finished before"),
    };
    match done.ran {
        0 => format!("{took}, no points were left to run{before}"),
        ran => {
            let rate = number::short(ran as f64 / done.seconds);
            let threads = if done.threads == 1 { "1 thread".into() } else { format!("{} threads", done.threads) };
            format!("{took} for {ran} points on {threads}: {rate} per second{before}")
        }
    }
}

/// The number of points that failed in one way, and the most frequent reasons.
fn failed<'a>(what: &str, reasons: impl Iterator<Item = &'a str>, width: usize) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    reasons.for_each(|reason| *counts.entry(reason).or_default() += 1);
    let all: usize = counts.values().sum();
    if all == 0 {
        return String::new();
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    let mut text = format!("{all}:");
    for (reason, n) in counts.iter().take(LISTED) {
        text += &format!("\n{n} x {reason}");
    }
    if counts.len() > LISTED {
        text += "\nand others; the column `reason` has all";
    }
    line(what, &text, width)
}
