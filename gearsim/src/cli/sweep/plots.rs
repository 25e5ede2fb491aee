//! The plots of a sweep.

use std::path::Path;

use clap::Args;

use crate::cli::failure::Failure;
use crate::cli::terminal;
use crate::output::{OutputError, WholeFiles};
use crate::plot::{self, Drawn, SweepResults};
use crate::sweep::Manifest;
use crate::sweep::folder::Rows;
use crate::sweep::manifest::Layout;
use crate::sweep::plan::Plan;
use crate::sweep::record;

/// The options that choose plots.
#[derive(Args)]
pub(super) struct PlotOptions {
    /// Draws a recorded quantity over the varied ones: a map over two, a curve over one; may be repeated
    /// [default: the dynamic factor of the first mesh, else the maximum of the first coordinate that does not rotate continuously, if one
    /// of them is recorded]
    #[arg(long, value_name = "QUANTITY")]
    map: Vec<String>,
    /// Stores the spectra of all points, and draws them over the one varied quantity
    #[arg(long)]
    pub(super) waterfall: bool,
}

impl PlotOptions {
    /// Whether a recorded quantity is drawn on request.
    pub(super) fn draws(&self, quantity: &str) -> bool {
        self.map.iter().any(|name| name == quantity)
    }

    /// Checks, before anything runs, that the plots can be drawn.
    ///
    /// # Errors
    /// [`Failure::Impossible`].
    pub(super) fn check(&self, layout: &Layout) -> Result<(), Failure> {
        let impossible = |what: String, help: String| Err(Failure::Impossible { what, help });
        for name in &self.map {
            layout.column(name)?;
        }
        let axes = layout.plan.axes.len();
        if self.waterfall && !(axes == 1 && drawable(&layout.plan)) {
            let what = format!("a waterfall needs exactly one --vary, with numbers as values; there are {axes}");
            return impossible(what, "vary one quantity, or leave out --waterfall".into());
        }
        if !self.map.is_empty() && !drawable(&layout.plan) {
            let what = "a map needs one or two --vary, with numbers as values";
            return impossible(what.into(), "leave out --map; the table has all results".into());
        }
        Ok(())
    }

    /// Draws the plots into the folder at `path`, and returns them and the names of the files. A plot that cannot be drawn gives a warning only.
    ///
    /// # Errors
    /// [`OutputError`].
    pub(super) fn draw(
        &self,
        path: &Path,
        manifest: &Manifest,
        layout: &Layout,
        rows: &Rows,
    ) -> Result<(Vec<String>, Vec<Drawn>), OutputError> {
        let (mut folder, mut done) = (WholeFiles::create(path)?, vec![]);
        let mut jobs: Vec<(&plot::SweepPlot, String)> = vec![];
        if drawable(&layout.plan) {
            let maps = if self.map.is_empty() { default(layout).into_iter().collect() } else { self.map.clone() };
            jobs.extend(maps.into_iter().map(|name| (&plot::map::PLOT, name)));
        }
        if self.waterfall {
            let mut names = rows.values().flat_map(|row| &row.spectra).map(|spectrum| spectrum.coordinate.to_string());
            let first = names.next();
            let others = names.skip_while(|name| Some(name) == first.as_ref());
            let mut coordinates: Vec<String> = first.iter().cloned().chain(others).collect();
            coordinates.sort();
            coordinates.dedup();
            jobs.extend(coordinates.into_iter().map(|name| (&plot::waterfall::PLOT, name)));
        }
        for (plot, quantity) in jobs {
            let name = format!("{}_{quantity}", plot.name);
            let results = SweepResults { scene: &manifest.scene, layout, rows, quantity: &quantity };
            let pictured = |drawn: Drawn| drawn.picture().and_then(|picture| Ok((picture.png()?, picture, drawn)));
            match (plot.draw)(&results).and_then(pictured) {
                Ok((png, picture, drawn)) => {
                    folder.write_bytes(&format!("{name}.svg"), picture.svg().as_bytes())?;
                    folder.write_bytes(&format!("{name}.png"), &png)?;
                    done.push(drawn);
                }
                Err(error) => {
                    terminal::warn(&format!("no plot `{name}`: {error}"));
                }
            }
        }
        Ok((folder.files().to_vec(), done))
    }
}

/// The map drawn if no --map is given: the dynamic factor of the first mesh if it is recorded, else the maximum of the first coordinate that
/// does not rotate continuously.
fn default(layout: &Layout) -> Option<String> {
    let factor = layout.columns.iter().find(|(column, _)| column.ends_with("_dynamic_factor"));
    if let Some((name, _)) = factor {
        return Some(name.clone());
    }
    let coordinate = record::elastic(layout.model).into_iter().next()?;
    let name = format!("{}_max", layout.model.coordinates[coordinate].name);
    layout.columns.iter().any(|(column, _)| *column == name).then_some(name)
}

/// Whether a map can be drawn: there are one or two axes, and all their values are numbers.
fn drawable(plan: &Plan) -> bool {
    (1..=2).contains(&plan.axes.len()) && plan.axes.iter().all(|axis| axis.is_numeric())
}
