//! The plots of a sweep.

use std::path::Path;

use clap::Args;

use crate::cli::failure::Failure;
use crate::cli::terminal;
use crate::output::{OutputError, OutputFolder};
use crate::plot::{self, Study};
use crate::sweep::Manifest;
use crate::sweep::folder::Rows;
use crate::sweep::manifest::Layout;
use crate::sweep::plan::Plan;
use crate::sweep::record;

/// Which plots to draw.
#[derive(Args)]
pub(in crate::cli) struct Pictures {
    /// Draws a recorded quantity over the varied ones: a map over two, a curve over one; may be repeated
    /// [default: the maximum of the first coordinate that does not roll on, where it is recorded]
    #[arg(long, value_name = "QUANTITY")]
    map: Vec<String>,
    /// Keeps the spectra at all points, and draws them over the one quantity that is varied
    #[arg(long)]
    pub(super) waterfall: bool,
}

impl Pictures {
    /// Whether they can be drawn, as far as is known before anything runs.
    ///
    /// # Errors
    /// [`Failure::Impossible`].
    pub(in crate::cli) fn check(&self, layout: &Layout) -> Result<(), Failure> {
        let impossible = |what: String, help: String| Err(Failure::Impossible { what, help });
        let names: Vec<&str> = layout.columns.iter().map(|(name, _)| name.as_str()).collect();
        if let Some(unknown) = self.map.iter().find(|name| !names.contains(&name.as_str())) {
            let meant = crate::scene::did_you_mean(unknown, names.iter().copied());
            let meant = meant.map_or(String::new(), |near| format!("did you mean `{near}`? "));
            let help = format!("{meant}there are {}", names.join(", "));
            return impossible(format!("no quantity `{unknown}` is recorded"), help);
        }
        let axes = layout.plan.axes.len();
        if self.waterfall && !(axes == 1 && drawable(&layout.plan)) {
            let what = format!("a waterfall is over one varied number, and there are {axes} varied quantities");
            return impossible(what, "vary one, or leave out --waterfall".into());
        }
        if !self.map.is_empty() && !drawable(&layout.plan) {
            let what = "a map is over one or two varied numbers, and that is not what is varied here";
            return impossible(what.into(), "leave out --map; the table has everything".into());
        }
        Ok(())
    }

    /// Draws them into the folder at `path`; their names. A plot that cannot be drawn costs no sweep its results.
    ///
    /// # Errors
    /// [`OutputError`].
    pub(in crate::cli) fn draw(
        &self,
        path: &Path,
        manifest: &Manifest,
        layout: &Layout,
        rows: &Rows,
    ) -> Result<Vec<String>, OutputError> {
        let mut folder = OutputFolder::create(path)?;
        let mut jobs: Vec<(&plot::SweepPlot, String)> = vec![];
        if drawable(&layout.plan) {
            let maps = if self.map.is_empty() { default(layout).into_iter().collect() } else { self.map.clone() };
            jobs.extend(maps.into_iter().map(|name| (&plot::map::PLOT, name)));
        }
        if self.waterfall {
            let mut lines = rows.values().flat_map(|row| &row.spectra).map(|line| line.coordinate.to_string());
            let first = lines.next();
            let others = lines.skip_while(|name| Some(name) == first.as_ref());
            let mut coordinates: Vec<String> = first.iter().cloned().chain(others).collect();
            coordinates.sort();
            coordinates.dedup();
            jobs.extend(coordinates.into_iter().map(|name| (&plot::waterfall::PLOT, name)));
        }
        for (plot, quantity) in jobs {
            let name = format!("{}_{quantity}", plot.name);
            let study = Study { scene: &manifest.scene, layout, rows, quantity: &quantity };
            match (plot.draw)(&study).and_then(|picture| Ok((picture.png()?, picture))) {
                Ok((png, picture)) => {
                    folder.write_bytes(&format!("{name}.svg"), picture.svg().as_bytes())?;
                    folder.write_bytes(&format!("{name}.png"), &png)?;
                }
                Err(error) => {
                    let warning = format!("warning: no plot `{name}`: {error}");
                    terminal::complain(&terminal::wrap(&warning, terminal::width()));
                }
            }
        }
        Ok(folder.files().to_vec())
    }
}

/// What is drawn if nobody says what: the greatest value of the first coordinate that does not roll on.
fn default(layout: &Layout) -> Option<String> {
    let coordinate = record::elastic(layout.model).into_iter().next()?;
    let name = format!("{}_max", layout.model.coordinates[coordinate].name);
    layout.columns.iter().any(|(column, _)| *column == name).then_some(name)
}

/// Whether the plan is one that can be drawn: one or two axes of numbers.
fn drawable(plan: &Plan) -> bool {
    (1..=2).contains(&plan.axes.len()) && plan.axes.iter().all(|axis| axis.is_numeric())
}
