//! The results of a run: named columns, events, summary, plots and files.

use std::path::{Path, PathBuf};

use super::evaluate::{self, Evaluated};
use super::{Error, files};
use crate::analysis::digits;
use crate::known;
use crate::output::summary::Observed;
#[cfg(feature = "html")]
use crate::output::{OutputError, PAGE};
use crate::output::{OutputFolder, Summary, Table};
#[cfg(feature = "html")]
use crate::page;
use crate::plot::{self, Figure};
use crate::run::{Entry, Outcome, Prospect};
use crate::scene::Scene;
use crate::trajectory::Trajectory;

/// The file of a result that names all others.
const INDEX: &str = "summary.json";

impl Scene {
    /// The entry of its model.
    pub(crate) fn entry(&self) -> Result<&'static Entry, Error> {
        known::of(self).ok_or_else(|| {
            let what = format!("this program does not have the model `{}`", self.model.name);
            Error::impossible(what, "add it with `gearsim::add_models`, or see `gearsim models` for those that it has")
        })
    }

    /// Finds the start of the scene and chooses its method, without running it.
    ///
    /// # Errors
    /// If it cannot be run.
    pub fn check(&self) -> Result<Prospect, Error> {
        self.entry()?.check(self).map_err(|refusal| self.refused(refusal))
    }

    /// Runs the scene to its end.
    ///
    /// # Errors
    /// If it cannot be run. A run that stops early, or whose energy account does not close, is not an error here:
    /// [`Results::check`] returns one.
    pub fn run(&self) -> Result<Results, Error> {
        self.run_watched(&mut |_| {})
    }

    /// As [`Scene::run`]; `watch` is called during the run with the time reached \[s\].
    ///
    /// # Errors
    /// As [`Scene::run`].
    pub fn run_watched(&self, watch: &mut dyn FnMut(f64)) -> Result<Results, Error> {
        let entry = self.entry()?;
        let Results { scene, outcome } = self.run_alone(watch)?;
        let mut outcome = digits::noted(self, outcome, &|companion| entry.run(companion, &mut |_| {}));
        outcome.remarks.splice(0..0, self.other_equilibria());
        Ok(Results { scene, outcome })
    }

    /// Describes the static equilibria other than the one at which the scene starts. `None` if there are none, or if the scene has no start.
    pub(crate) fn other_equilibria(&self) -> Option<String> {
        self.entry().ok()?.other_equilibria(self).ok()?
    }

    /// Runs the scene without the companion run, so that the number of digits left is unknown. Other equilibria are not searched.
    pub(crate) fn run_alone(&self, watch: &mut dyn FnMut(f64)) -> Result<Results, Error> {
        let outcome = self.entry()?.run(self, watch).map_err(|refusal| self.refused(refusal))?;
        Ok(Results { scene: self.clone(), outcome })
    }
}

/// A run of a scene with its results.
#[derive(Debug, Clone)]
pub struct Results {
    /// The scene that was run.
    pub scene: Scene,
    /// The recorded rows, counts, energy account and end of the run.
    pub outcome: Outcome,
}

impl Results {
    /// The recorded rows.
    pub fn trajectory(&self) -> &Trajectory {
        &self.outcome.trajectory
    }

    /// A recorded column by the name that it has in files, e.g. `t`, `theta1_dot`, `mesh_force_12`, `kinetic` \[SI\]; one number a row.
    ///
    /// # Errors
    /// If there is no such column; the text names those that there are.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Error> {
        self.trajectory().column(name).map(|column| column.into_owned()).ok_or_else(|| {
            let names: Vec<_> = self.trajectory().columns().map(|column| column.name.into_owned()).collect();
            Error::impossible(format!("there is no column `{name}`"), format!("the columns are {}", names.join(", ")))
        })
    }

    /// Extremes, mean, rms and percentiles of a recorded output.
    ///
    /// # Errors
    /// If it is not recorded; the text names those that are.
    pub fn observed(&self, output: &str) -> Result<Observed, Error> {
        let mut all = Observed::all(self.trajectory(), self.scene.output.from);
        all.swap_remove(output).ok_or_else(|| {
            let names: Vec<_> = self.trajectory().outputs.iter().map(|(output, _)| output.name).collect();
            Error::impossible(format!("no output `{output}` is recorded"), format!("recorded are {}", names.join(", ")))
        })
    }

    /// The recorded columns with their units. The files `trajectory.parquet` and `trajectory.csv` have the same columns.
    pub fn table(&self) -> Table {
        // The columns of a run have the same length, so that this cannot fail.
        Table::of_trajectory(self.trajectory()).unwrap_or_default()
    }

    /// For each recorded event, its row before and its row after.
    pub fn events(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.trajectory().events()
    }

    /// End state, energy account, statistics of the outputs, method and provenance: what the file `summary.json` contains.
    pub fn summary(&self) -> Summary {
        files::summary(&self.scene, &self.outcome, vec![])
    }

    /// Its summary without statistics, dynamic factors and load spectra.
    #[cfg(feature = "html")]
    pub(crate) fn brief(&self) -> Summary {
        files::brief(&self.scene, &self.outcome)
    }

    /// Draws a plot by its name, e.g. `outputs`, `orders`, `energy`.
    ///
    /// # Errors
    /// If there is no such plot, or the run has nothing to show in it.
    pub fn plot(&self, name: &str) -> Result<Figure, Error> {
        Ok((plot::find(name)?.draw)(&[self.drawn()])?)
    }

    /// The run in the form that plots need.
    pub(crate) fn drawn(&self) -> plot::Run<'_> {
        plot::Run::of(&self.scene, &self.outcome)
    }

    /// Writes the files of `gearsim run` to a folder, and returns their paths. An earlier result in the folder is replaced after the
    /// last file is written.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, Error> {
        self.written(folder.as_ref(), |_, _| Ok(()))
    }

    /// The files of `gearsim run --html`: the same and `page.html`, an interactive page that needs no other file and no network.
    ///
    /// # Errors
    /// If a file cannot be written.
    #[cfg(feature = "html")]
    pub fn write_with_page(&self, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, Error> {
        self.written(folder.as_ref(), |folder, summary| self.write_page(folder, summary))
    }

    /// The interactive page of the run in HTML: one file that needs no other and no network.
    ///
    /// # Errors
    /// If it cannot be made.
    #[cfg(feature = "html")]
    pub fn page(&self) -> Result<String, Error> {
        let mut bytes = vec![];
        self.page_of(&self.summary())?.write(&mut bytes).map_err(OutputError::from)?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    #[cfg(feature = "html")]
    fn page_of(&self, summary: &Summary) -> Result<page::Page, OutputError> {
        page::run::page(&page::run::Run { scene: &self.scene, outcome: &self.outcome, summary })
    }

    /// Writes the page into the folder of the result, and its name into the summary.
    #[cfg(feature = "html")]
    pub(crate) fn write_page(&self, folder: &mut OutputFolder, summary: &mut Summary) -> Result<(), Error> {
        let page = self.page_of(summary)?.of(INDEX);
        folder.write(PAGE, |sink| Ok(page.write(sink)?))?;
        summary.files = folder.files().to_vec();
        Ok(())
    }

    /// Writes the files of `gearsim run` and, before the summary, what `more` writes.
    fn written(
        &self,
        folder: &Path,
        more: impl FnOnce(&mut OutputFolder, &mut Summary) -> Result<(), Error>,
    ) -> Result<Vec<PathBuf>, Error> {
        let mut folder = OutputFolder::create(folder)?;
        let evaluated = self.write_to(&mut folder, self.scene.output.csv)?;
        let mut summary = self.summed(&folder, &evaluated);
        more(&mut folder, &mut summary)?;
        finish(&mut folder, &summary)?;
        Ok(folder.files().iter().map(|name| folder.path().join(name)).collect())
    }

    /// Writes the trajectory, the plots, the lines, the load spectra and the sounds.
    pub(crate) fn write_to(&self, folder: &mut OutputFolder, csv: bool) -> Result<Evaluated, Error> {
        let Results { scene, outcome } = self;
        files::trajectory(folder, "trajectory", csv, scene, outcome)?;
        let runs = [self.drawn()];
        let no_plots = files::plots(folder, &plot::chosen(&runs), &runs)?;
        let mut evaluated = evaluate::write(folder, scene, outcome)?;
        evaluated.remarks.splice(0..0, no_plots);
        Ok(evaluated)
    }

    /// The summary of the run, with its files so far and what was evaluated.
    pub(crate) fn summed(&self, folder: &OutputFolder, evaluated: &Evaluated) -> Summary {
        let mut summary = self.summary();
        summary.remarks.extend_from_slice(&evaluated.remarks);
        summary.sounds.extend(evaluated.sounds.iter().cloned());
        summary.files = folder.files().to_vec();
        summary
    }

    /// Whether the run reached its end and its energy account closes.
    ///
    /// # Errors
    /// Why not.
    pub fn check(&self) -> Result<(), Error> {
        let what = match (&self.outcome.stopped_by, &self.outcome.refuted) {
            (Some(stop), _) => format!("the run of scene {} stopped early: {stop}", self.scene.name),
            (None, Some(account)) => format!("the result of scene {} is wrong: {account}", self.scene.name),
            (None, None) => return Ok(()),
        };
        Err(Error::impossible(what, "the rows until then are in the results"))
    }
}

/// Writes the summary, which names all other files, and puts the result in its place.
pub(crate) fn finish(folder: &mut OutputFolder, summary: &Summary) -> Result<(), Error> {
    folder.write_bytes(INDEX, summary.json()?.as_bytes())?;
    Ok(folder.commit(INDEX)?)
}
