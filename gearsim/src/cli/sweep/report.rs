//! What a sweep came to, as text for the terminal.

use std::collections::BTreeMap;
use std::path::Path;

use crate::cli::report::{files as written, line};
use crate::cli::{number, terminal};
use crate::sweep::Manifest;
use crate::sweep::folder::Rows;
use crate::sweep::row::Status;

/// Reasons that are listed before they are only counted.
const LISTED: usize = 3;

/// What was done in this run.
pub(in crate::cli) struct Done {
    /// Points that were there before.
    pub(in crate::cli) before: usize,
    /// Points that ran.
    pub(in crate::cli) ran: usize,
    /// Time that it took [s].
    pub(in crate::cli) seconds: f64,
    /// Threads that it had.
    pub(in crate::cli) threads: usize,
}

/// What a sweep came to.
pub(in crate::cli) fn said(
    path: &Path,
    files: &[String],
    manifest: &Manifest,
    rows: &Rows,
    done: Option<Done>,
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
    for (status, what) in [
        (Status::Stopped, "stopped early"),
        (Status::Refuted, "refuted by their energy account"),
        (Status::Refused, "refused"),
    ] {
        let reasons = rows.values().filter(|row| row.status == status).map(|row| row.reason.as_str());
        text += &failed(what, reasons, width);
    }
    text + "\n" + &written(path, files, width)
}

fn time(done: &Done) -> String {
    let took = number::time(done.seconds);
    let before = match done.before {
        0 => String::new(),
        n => format!("; {n} were there already"),
    };
    match done.ran {
        0 => format!("{took}, nothing was left to run{before}"),
        ran => {
            let rate = number::short(ran as f64 / done.seconds);
            let threads = if done.threads == 1 { "1 thread".into() } else { format!("{} threads", done.threads) };
            format!("{took} for {ran} on {threads}: {rate} a second{before}")
        }
    }
}

/// How many points failed in a way, and the most frequent reasons.
fn failed<'a>(what: &str, reasons: impl Iterator<Item = &'a str>, width: usize) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    reasons.for_each(|reason| *counts.entry(reason).or_default() += 1);
    let all: usize = counts.values().sum();
    if all == 0 {
        return String::new();
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    let mut says = format!("{all}:");
    for (reason, n) in counts.iter().take(LISTED) {
        says += &format!("\n{n} x {reason}");
    }
    if counts.len() > LISTED {
        says += "\nand others; the column `reason` has them";
    }
    line(what, &says, width)
}
