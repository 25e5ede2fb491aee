//! Figures: those of [`Results::plot`](crate::Results::plot), and those that a program draws of its own data.

// Each plot of a run or of a sweep has one file; those of runs have an entry in `PLOTS`.

pub(crate) mod campbell;
mod canvas;
mod cascade;
mod decimate;
mod energy;
pub(crate) mod figure;
pub(crate) mod floquet;
pub(crate) mod heat;
mod load_duration;
pub(crate) mod map;
pub(crate) mod marks;
pub(crate) mod modes;
mod motion;
mod notes;
mod order_cuts;
mod order_waterfall;
pub(crate) mod orders;
pub(crate) mod outputs;
mod picture;
mod rainflow;
mod reduced;
pub(crate) mod response;
mod run_up;
pub(crate) mod spectrum;
mod text;
mod ticks;
pub(crate) mod waterfall;
pub(crate) mod work_precision;

pub use figure::{Axis, Figure, Marker, Note, NotePlace, Panel, Scale, Series, Style};
use heat::HeatMap;
pub use picture::Picture;

use crate::analysis::spectrum::SpectrumError;
use crate::run::Outcome;
use crate::scene::{Output, Scene};
use crate::sweep::folder::Rows;
use crate::sweep::manifest::Layout;
use crate::trajectory::Trajectory;

/// All plots, in the order in which they are listed.
pub(crate) const PLOTS: &[Plot] = &[
    outputs::PLOT,
    orders::PLOT,
    energy::PLOT,
    spectrum::PLOT,
    motion::PLOT,
    order_cuts::PLOT,
    order_waterfall::PLOT,
    run_up::PLOT,
    rainflow::PLOT,
    load_duration::PLOT,
];

/// A plot of the results of a sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SweepPlot {
    /// Name; also the first part of the file name.
    pub name: &'static str,
    /// Draws it.
    pub draw: fn(&SweepResults<'_>) -> Result<Drawn, PlotError>,
}

/// What a plot of a sweep has drawn.
#[derive(Debug, Clone)]
pub(crate) enum Drawn {
    /// Curves.
    Curves(Figure),
    /// A map.
    Map(Box<HeatMap>),
}

impl Drawn {
    /// The plot as a picture. Errors: [`PlotError::Ragged`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        match self {
            Drawn::Curves(figure) => figure.picture(),
            Drawn::Map(map) => Ok(map.picture()),
        }
    }
}

/// The results of a sweep, and the quantity to draw.
#[derive(Clone, Copy)]
pub(crate) struct SweepResults<'a> {
    /// Name of the scene, for the title.
    pub scene: &'a str,
    /// The varied quantities and the recorded columns.
    pub layout: &'a Layout,
    /// The results, one row per point.
    pub rows: &'a Rows,
    /// What to draw: the name of a recorded column for a map, the name of a coordinate for a waterfall.
    pub quantity: &'a str,
}

/// A plot that a scene can ask for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plot {
    /// Name in scenes and on the command line.
    pub name: &'static str,
    /// Draws the plot. The curves of several runs are drawn over each other.
    pub draw: fn(&[Run<'_>]) -> Result<Figure, PlotError>,
}

/// A run to draw.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Run<'a> {
    /// Name in the legend of a plot with several runs, e.g. `exact`.
    pub label: &'a str,
    /// The recorded rows.
    pub trajectory: &'a Trajectory,
    /// Damped natural angular frequency of the elastic mode at the mean stiffness, wd [rad/s].
    pub reference_frequency: Option<f64>,
    /// Name of the scene, for the title.
    pub scene: &'a str,
    /// What the scene asks to be evaluated, and how.
    pub asked: &'a Output,
    /// Time from which on no digit of the state is left \[s\]; `None` if some are left to the end.
    pub none_from: Option<f64>,
}

impl<'a> Run<'a> {
    /// A run of a scene.
    pub fn of(scene: &'a Scene, outcome: &'a Outcome) -> Run<'a> {
        Run {
            label: &scene.name,
            trajectory: &outcome.trajectory,
            reference_frequency: outcome.reference_frequency,
            scene: &scene.name,
            asked: &scene.output,
            none_from: outcome.digits.and_then(|digits| digits.none_from),
        }
    }
}

/// The time axis of `runs`. Panels are shaded from the earliest time at which one of the runs has no digits left.
fn time_axis(runs: &[Run<'_>]) -> Axis {
    Axis::linear("time t", "s").shaded(runs.iter().filter_map(|run| run.none_from).reduce(f64::min))
}

/// Why a plot could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// There is no plot of that name.
    #[error("there is no plot `{name}`; there are {}", names())]
    Unknown {
        /// The name asked for.
        name: String,
    },
    /// There is nothing to draw: no run, no rows, or none of the coordinates that the plot shows.
    #[error("plot `{plot}` has nothing to show: {why}")]
    Nothing {
        /// The plot.
        plot: &'static str,
        /// What is missing.
        why: String,
    },
    /// A spectrum could not be computed.
    #[error("no spectrum of `{signal}` in run `{run}`: {source}")]
    Spectrum {
        /// The output or coordinate.
        signal: &'static str,
        /// The run's label.
        run: String,
        /// The cause.
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
    /// The SVG could not be rendered as PNG.
    #[error("cannot draw the figure `{title}`: {why}")]
    Render {
        /// The figure's title.
        title: String,
        /// The cause.
        why: String,
    },
}

/// The names of the plots of `runs`. Order cuts replace the spectrum over frequency if the plots are the default ones, the speed of a mesh
/// varies and the run has enough revolutions: in a spectrum over frequency the mesh lines would be smeared.
pub(crate) fn chosen(runs: &[Run<'_>]) -> Vec<String> {
    let Some(first) = runs.first() else { return vec![] };
    let mut plots = first.asked.plots.clone();
    let cuts = order_cuts::PLOT.name.to_owned();
    if first.asked.default_plots && runs.iter().all(order_cuts::suits) && !plots.contains(&cuts) {
        plots.iter_mut().filter(|name| **name == spectrum::PLOT.name).for_each(|name| *name = cuts.clone());
    }
    plots
}

/// The names of the plots of runs that are compared: the recorded outputs first, whatever plots the scene asks for.
pub(crate) fn compared(runs: &[Run<'_>]) -> Vec<String> {
    let (mut plots, outputs) = (chosen(runs), outputs::PLOT.name);
    if runs.iter().any(|run| !run.trajectory.outputs.is_empty()) {
        plots.retain(|name| name != outputs);
        plots.insert(0, outputs.to_owned());
    }
    plots
}

/// The plot called `name`. Errors: [`PlotError::Unknown`].
pub(crate) fn find(name: &str) -> Result<&'static Plot, PlotError> {
    let unknown = || PlotError::Unknown { name: name.to_owned() };
    PLOTS.iter().find(|p| p.name == name).ok_or_else(unknown)
}

fn names() -> String {
    PLOTS.iter().map(|p| format!("`{}`", p.name)).collect::<Vec<_>>().join(", ")
}

/// The first of `runs`. Errors: [`PlotError::Nothing`] for `plot` if there is no run, or if a run has no rows or columns of
/// different lengths.
fn first_run<'a, 'r>(plot: &'static str, runs: &'r [Run<'a>]) -> Result<&'r Run<'a>, PlotError> {
    let nothing = |why: String| PlotError::Nothing { plot, why };
    for run in runs {
        if run.trajectory.is_empty() {
            return Err(nothing(format!("run `{}` recorded nothing", run.label)));
        }
        if !has_full_columns(run.trajectory) {
            return Err(nothing(format!("the columns of run `{}` differ in length", run.label)));
        }
    }
    runs.first().ok_or_else(|| nothing("there is no run".into()))
}

/// Whether every column has exactly one entry per row.
fn has_full_columns(run: &Trajectory) -> bool {
    let single = [&run.kinetic, &run.strain, &run.work, &run.dissipated, &run.residual];
    let columns = single.into_iter().chain(&run.q).chain(&run.q_dot);
    let coordinates = run.model.coordinates.len();
    run.moment.len() == run.len()
        && run.q.len() == coordinates
        && run.q_dot.len() == coordinates
        && run.outputs.iter().all(|(_, column)| column.len() == run.len())
        && run.torque_work.iter().all(|(_, column)| column.len() == run.len())
        && columns.into_iter().all(|column| column.len() == run.len())
}

/// The names of the scenes of `runs` for the subtitle; runs of the same scene in a row name it once.
fn scene_names(runs: &[Run<'_>]) -> String {
    let mut scenes: Vec<&str> = runs.iter().map(|run| run.scene).collect();
    scenes.dedup();
    scenes.join(", ")
}

/// Index of the coordinate `name` of `run`.
fn coordinate_index(run: &Trajectory, name: &str) -> Option<usize> {
    run.model.coordinates.iter().position(|c| c.name == name)
}

/// Whether the coordinate `name` of `run` rotates continuously, so that its speed says more than its value. The criterion: its
/// range in the run exceeds 2 pi, one tooth pitch or one turn. A coordinate in other units is compared with the same number.
pub(crate) fn rotates(run: &Trajectory, name: &str) -> bool {
    let Some(i) = coordinate_index(run, name) else {
        return false;
    };
    let (low, high) = figure::extremes(run.q[i].iter().copied());
    high - low > std::f64::consts::TAU
}

/// The symbol of a coordinate as in formulas: `phi` gives φ, `theta_1` gives θ with the subscript 1.
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
