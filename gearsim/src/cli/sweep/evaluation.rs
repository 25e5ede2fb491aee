//! The evaluation of a finished sweep: plots, statistics, limits and indices of sensitivity.

use std::path::Path;

use clap::Args;

use super::json::json;
use super::plots::PlotOptions;
use super::report::{Progress, remarks, summary_text};
use crate::cli::failure::Failure;
use crate::cli::number::short;
use crate::cli::page;
use crate::cli::printing::Printing;
use crate::cli::report::line;
use crate::cli::terminal;
use crate::output::{OutputError, Table, WholeFiles, csv, marker};
use crate::sweep::answers::{Block, limit, limit::Limit, sensitivity, statistics};
use crate::sweep::folder::{self, Rows};
use crate::sweep::manifest::{self, Layout};
use crate::sweep::{Design, Manifest, row};

/// Maximum number of quantities and of grid points that are listed on the terminal.
const LISTED: (usize, usize) = (8, 4);
/// File name of the table of points in CSV.
const POINTS: &str = "sweep.csv";

/// The options of the evaluation.
#[derive(Args)]
pub(in crate::cli) struct Evaluation {
    #[command(flatten)]
    pub(super) plots: PlotOptions,
    /// A limit of a recorded quantity, e.g. "mesh_force_12_max <= 5 kN": gives the probability that it is broken; may be repeated
    #[arg(long, value_name = "LIMIT")]
    limit: Vec<String>,
    /// Also writes the table of the points as sweep.csv
    #[arg(long)]
    csv: bool,
    #[command(flatten)]
    html: page::Html,
}

impl Evaluation {
    /// Checks, before anything runs, that the evaluation is possible.
    ///
    /// # Errors
    /// [`Failure::Impossible`].
    pub(in crate::cli) fn check(&self, layout: &Layout) -> Result<(), Failure> {
        self.html.asked()?;
        self.plots.check(layout)?;
        self.limits(layout)?;
        Ok(())
    }

    /// Evaluates the sweep in the folder at `path`, if it is complete, and prints the outcome.
    /// `done` is `None` for a merged sweep.
    ///
    /// # Errors
    /// [`Failure::Output`].
    pub(in crate::cli) fn finish(
        &self,
        path: &Path,
        manifest: &Manifest,
        layout: &Layout,
        rows: &Rows,
        done: Option<Progress>,
        printing: &Printing,
    ) -> Result<(), Failure> {
        let mut files = vec![folder::ROWS.to_owned(), manifest::FILE.to_owned()];
        let (mut answers, mut said) = (vec![], String::new());
        let width = terminal::width();
        if rows.len() == manifest.points {
            let blocks = Block::all(layout, rows);
            answers = self.answers(layout, &blocks)?;
            files.extend(self.write(path, layout, rows, &answers)?);
            let (names, drawn) = self.plots.draw(path, manifest, layout, rows)?;
            files.extend(names);
            said = self.text(layout, &blocks, width);
            if let Some(page) = self.html.asked()? {
                let text = done.as_ref().map(|done| &*done.text).or(manifest.scene_text.as_deref());
                let points = points(layout, rows)?;
                let mut folder = WholeFiles::create(path)?;
                page.sweep(
                    &mut folder,
                    (manifest, layout.model, text),
                    &drawn,
                    (said.as_str(), answers.as_slice(), remarks(rows).as_slice()),
                    &points,
                    &files,
                )?;
                files.extend_from_slice(folder.files());
            }
        }
        if !files.iter().any(|file| file == page::FILE) {
            // A page of an earlier command does not belong to this result.
            let _ = std::fs::remove_file(path.join(page::FILE));
        }
        folder::end(path)?;
        let text = || summary_text(path, &files, manifest, rows, done, &said);
        printing.warn(remarks(rows).iter());
        printing.print(|| json(manifest, rows, &answers, &files), text)
    }

    /// The tables of answers, by the names of their files.
    fn answers(&self, layout: &Layout, blocks: &[Block<'_>]) -> Result<Vec<(&'static str, Table)>, Failure> {
        let (limits, mut answers) = (self.limits(layout)?, vec![]);
        if layout.plan.is_random() {
            answers.push((statistics::FILE, statistics::table(layout, blocks)?));
        }
        if !limits.is_empty() {
            answers.push((limit::FILE, limit::table(layout, blocks, &limits)?));
        }
        if layout.plan.sampler.design == Design::Saltelli {
            answers.push((sensitivity::FILE, sensitivity::table(layout, blocks)?));
        }
        Ok(answers)
    }

    /// Writes the tables into the folder, and returns their names.
    fn write(
        &self,
        path: &Path,
        layout: &Layout,
        rows: &Rows,
        answers: &[(&'static str, Table)],
    ) -> Result<Vec<String>, OutputError> {
        let mut folder = WholeFiles::create(path)?;
        if self.csv {
            let table = points(layout, rows)?;
            folder.write(POINTS, |sink| csv::write(&table, sink))?;
        }
        for (name, table) in answers {
            folder.write(name, |sink| csv::write(table, sink))?;
        }
        // Tables of an earlier command with other options do not belong to this result.
        for name in [POINTS, statistics::FILE, limit::FILE, sensitivity::FILE] {
            if !folder.files().iter().any(|file| file == name) {
                marker::remove(&path.join(name))?;
            }
        }
        Ok(folder.files().to_vec())
    }

    /// The answers for the terminal; empty if there are none.
    fn text(&self, layout: &Layout, blocks: &[Block<'_>], width: usize) -> String {
        let (limits, mut text) = (self.limits(layout).unwrap_or_default(), String::new());
        for block in blocks.iter().take(LISTED.1) {
            let mut said = String::new();
            if layout.plan.is_random() {
                said += &self.statistics(layout, block, width);
            }
            for limit in &limits {
                said += &line("limit", &broken(layout, limit, block), width);
            }
            if layout.plan.sampler.design == Design::Saltelli {
                said += &self.sensitivities(layout, block, width);
            }
            let at = block.name(layout);
            if !said.is_empty() && !at.is_empty() {
                text += &line("at", &at, width);
            }
            text += &said;
        }
        if let (false, Some(more)) = (text.is_empty(), blocks.len().checked_sub(LISTED.1).filter(|more| *more > 0)) {
            text += &line("further", &format!("{more} points of the grid, in the tables"), width);
        }
        text
    }

    fn limits(&self, layout: &Layout) -> Result<Vec<Limit>, crate::sweep::Error> {
        self.limit.iter().map(|text| Limit::read(text, layout)).collect()
    }

    /// The quantities that are listed: those that are drawn or limited; without any, all.
    fn quantities(&self, layout: &Layout) -> Vec<usize> {
        let asked =
            |name: &str| self.plots.draws(name) || self.limit.iter().any(|limit| limit.trim_start().starts_with(name));
        let all = || 0..layout.columns.len();
        let some: Vec<usize> = all().filter(|&i| asked(&layout.columns[i].0)).collect();
        if some.is_empty() { all().collect() } else { some }
    }

    fn statistics(&self, layout: &Layout, block: &Block<'_>, width: usize) -> String {
        let spreads = self.quantities(layout).into_iter().filter_map(|i| Some((i, statistics::of(block, i)?)));
        let varied: Vec<_> = spreads.filter(|(_, spread)| spread.min < spread.max).collect();
        let mut text = String::new();
        for (i, spread) in varied.iter().take(LISTED.0) {
            let (name, unit) = &layout.columns[*i];
            let [_, p05, _, median, _, p95, _] = spread.percentiles.map(short);
            let (mean, deviation) = (short(spread.mean), short(spread.deviation));
            let unit = if unit == "1" { "" } else { unit };
            let says =
                format!("{mean} {unit} in the mean, deviation {deviation}; 5 %, 50 %, 95 %: {p05}, {median}, {p95}");
            text += &line(name, &says.replace("  ", " "), width);
        }
        if let Some(more) = varied.len().checked_sub(LISTED.0).filter(|more| *more > 0) {
            text += &line("further", &format!("{more} quantities, in {}", statistics::FILE), width);
        }
        text
    }

    fn sensitivities(&self, layout: &Layout, block: &Block<'_>, width: usize) -> String {
        let found = self.quantities(layout).into_iter().filter_map(|i| Some((i, sensitivity::of(layout, block, i)?.0)));
        let found: Vec<_> = found.collect();
        let mut text = String::new();
        for (i, indices) in found.iter().take(LISTED.0) {
            // The sum with 0.0 turns -0.0 into 0.0.
            let rounded = |x: f64| (100.0 * x).round() / 100.0 + 0.0;
            let index = |index: sensitivity::Index| format!("{:.2} ± {:.2}", rounded(index.value), index.bound);
            let one = |one: &sensitivity::Indices| {
                format!("{} alone {}, in all {}", one.key, index(one.first), index(one.total))
            };
            let says: Vec<String> = indices.iter().map(one).collect();
            text += &line(&layout.columns[*i].0, &format!("share of its variance:\n{}", says.join("\n")), width);
        }
        if let Some(more) = found.len().checked_sub(LISTED.0).filter(|more| *more > 0) {
            text += &line("further", &format!("{more} quantities, in {}", sensitivity::FILE), width);
        }
        text
    }
}

/// The table of the points.
fn points(layout: &Layout, rows: &Rows) -> Result<Table, OutputError> {
    let rows: Vec<_> = rows.values().collect();
    row::table(&layout.plan, &layout.columns, &layout.units, &rows)
}

/// How often a limit is broken, in words.
fn broken(layout: &Layout, limit: &Limit, block: &Block<'_>) -> String {
    let count = limit.count(layout, block);
    if count.points == 0 {
        return format!("{}: no point has the quantity", limit.text);
    }
    let ((low, high), percent) = (count.interval(), |share: f64| short(100.0 * share));
    let unknown = match count.unknown {
        0 => String::new(),
        n => format!("; {n} points without a result count neither way"),
    };
    let counted = format!("{} is broken at {} of {} points", limit.text, count.broken, count.points);
    if !count.drawn {
        return counted + &unknown;
    }
    let probability = percent(count.probability());
    format!(
        "{counted}: {probability} %, with 95 % confidence between {} % and {} %{unknown}",
        percent(low),
        percent(high)
    )
}
