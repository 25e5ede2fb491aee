//! Plots of recordings: one file and one line of [`PLOTS`] each.

pub mod campbell;
mod canvas;
mod decimate;
mod energy;
pub mod figure;
pub mod floquet;
mod heat;
pub mod map;
pub mod modes;
mod motion;
mod picture;
mod spectrum;
mod text;
mod ticks;
pub mod waterfall;
pub mod work_precision;

pub use figure::{Axis, Figure, Marker, Panel, Scale, Series, Style};
pub use picture::Picture;

use crate::analysis::spectrum::SpectrumError;
use crate::sweep::folder::Rows;
use crate::sweep::manifest::Layout;
use crate::trajectory::Trajectory;

/// All plots, in the order in which they are listed.
pub const PLOTS: &[Plot] = &[energy::PLOT, motion::PLOT, spectrum::PLOT];

/// All plots of sweeps.
pub const SWEEP_PLOTS: &[SweepPlot] = &[map::PLOT, waterfall::PLOT];

/// A plot of the results of a sweep.
#[derive(Debug, Clone, Copy)]
pub struct SweepPlot {
    /// Name, with which its file begins.
    pub name: &'static str,
    /// One line saying what it shows.
    pub doc: &'static str,
    /// Draws it.
    pub draw: fn(&Study<'_>) -> Result<Picture, PlotError>,
}

/// The results of a sweep, to draw a quantity of.
#[derive(Clone, Copy)]
pub struct Study<'a> {
    /// Name of the scene, for the title.
    pub scene: &'a str,
    /// What was varied, and what recorded.
    pub layout: &'a Layout,
    /// What came of it.
    pub rows: &'a Rows,
    /// The recorded column to draw, or the coordinate whose spectra.
    pub quantity: &'a str,
}

/// A plot that a scene can ask for.
#[derive(Debug, Clone, Copy)]
pub struct Plot {
    /// Name in scenes and on the command line.
    pub name: &'static str,
    /// One line saying what it shows.
    pub doc: &'static str,
    /// Draws it; several runs are overlaid.
    pub draw: fn(&[Run<'_>]) -> Result<Figure, PlotError>,
}

/// A run to draw.
#[derive(Debug, Clone, Copy)]
pub struct Run<'a> {
    /// What the legend calls it where several are overlaid, e.g. `exact`.
    pub label: &'a str,
    /// What it recorded.
    pub trajectory: &'a Trajectory,
    /// Damped natural angular frequency of the elastic mode at the mean stiffness, wd [rad/s].
    pub reference_frequency: Option<f64>,
    /// Name of the scene, for the title.
    pub scene: &'a str,
    /// Time from which on no digit of its state is left \[s\].
    pub none_from: Option<f64>,
}

/// The time axis of `runs`, shaded from where on the state of one of them is not determined.
fn time(runs: &[Run<'_>]) -> Axis {
    Axis::linear("time t", "s").shaded(runs.iter().filter_map(|run| run.none_from).reduce(f64::min))
}

/// Why a plot could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// There is no such plot.
    #[error("there is no plot `{name}`; there are {}", names())]
    Unknown {
        /// The name asked for.
        name: String,
    },
    /// Nothing to draw: no run, no rows, or no coordinate that the plot is about.
    #[error("plot `{plot}` has nothing to show: {why}")]
    Nothing {
        /// The plot.
        plot: &'static str,
        /// What is missing.
        why: String,
    },
    /// There is no spectrum to draw.
    #[error("no spectrum of `{coordinate}` in run `{run}`: {source}")]
    Spectrum {
        /// The coordinate.
        coordinate: &'static str,
        /// The run's label.
        run: String,
        /// Why not.
        source: SpectrumError,
    },
    /// A series whose x and y have different lengths.
    #[error("series `{series}` has {x} abscissae and {y} ordinates")]
    Ragged {
        /// Its label.
        series: String,
        /// Number of abscissae.
        x: usize,
        /// Number of ordinates.
        y: usize,
    },
    /// The picture could not be turned into pixels.
    #[error("cannot draw the figure `{title}`: {why}")]
    Render {
        /// The figure's title.
        title: String,
        /// Why not.
        why: String,
    },
}

/// The plot called `name`. Errors: [`PlotError::Unknown`].
pub fn find(name: &str) -> Result<&'static Plot, PlotError> {
    let unknown = || PlotError::Unknown { name: name.to_owned() };
    PLOTS.iter().find(|p| p.name == name).ok_or_else(unknown)
}

fn names() -> String {
    PLOTS.iter().map(|p| format!("`{}`", p.name)).collect::<Vec<_>>().join(", ")
}

/// The first of `runs`, all of which recorded something; else why plot `plot` has nothing to show.
fn first<'a, 'r>(plot: &'static str, runs: &'r [Run<'a>]) -> Result<&'r Run<'a>, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot, why };
    for run in runs {
        if run.trajectory.is_empty() {
            return Err(nothing(format!("run `{}` recorded nothing", run.label)));
        }
        if !whole(run.trajectory) {
            return Err(nothing(format!("the columns of run `{}` differ in length", run.label)));
        }
    }
    runs.first().ok_or_else(|| nothing("there is no run".into()))
}

/// Whether every column has one entry a row.
fn whole(run: &Trajectory) -> bool {
    let single = [&run.kinetic, &run.strain, &run.work, &run.dissipated, &run.residual];
    let columns = single.into_iter().chain(&run.q).chain(&run.q_dot).chain(&run.torque_work);
    let coordinates = run.model.coordinates.len();
    run.moment.len() == run.len()
        && run.q.len() == coordinates
        && run.q_dot.len() == coordinates
        && columns.into_iter().all(|column| column.len() == run.len())
}

/// The scenes of `runs`, each named once: what a subtitle says.
fn scenes(runs: &[Run<'_>]) -> String {
    let mut scenes: Vec<&str> = runs.iter().map(|run| run.scene).collect();
    scenes.dedup();
    scenes.join(", ")
}

/// Which coordinate of `run` is called `name`.
fn column(run: &Trajectory, name: &str) -> Option<usize> {
    run.model.coordinates.iter().position(|c| c.name == name)
}

/// Whether the coordinate `name` of `run` rolls on, so that its speed says more than its value: it moves over more
/// than 2 pi (one tooth pitch, or one turn; the same number in other units).
fn rolls(run: &Trajectory, name: &str) -> bool {
    let Some(i) = column(run, name) else {
        return false;
    };
    let (low, high) = figure::extremes(run.q[i].iter().copied());
    high - low > std::f64::consts::TAU
}

/// The name of a coordinate as it stands in formulas: `phi` is φ, `theta_1` is θ with the index 1.
fn symbol(name: &str) -> String {
    let (stem, index) = name.split_once('_').unwrap_or((name, ""));
    let greek = match stem {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "theta" => "θ",
        "phi" => "φ",
        "psi" => "ψ",
        latin => latin,
    };
    if index.is_empty() { greek.to_owned() } else { format!("{greek}_{{{index}}}") }
}

#[cfg(test)]
mod tests;
