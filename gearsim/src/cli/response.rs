//! `gearsim response`: response curves over a varied value, upward and downward.

use std::path::{Path, PathBuf};

use clap::Parser;
use serde::Serialize;
use serde_json::{Map, Value};

use super::failure::Failure;
use super::printing::Printing;
use super::progress::PointsBar;
use super::{Verb, files, known, number, page, report, terminal};
use crate::output::unit::in_words;
use crate::output::{OutputFolder, csv, document, parquet};
use crate::plot;
use crate::scene::Scene;
use crate::sweep::response::{Hold, MEASURES, Measure, ResponseCurve, measure};
use crate::sweep::{Request, Status, Sweep};

/// Response curves: outputs over a speed or another value, each point from the settled state before it
#[derive(Parser)]
#[command(
    name = "response",
    after_help = "\
The scene runs at the first value, then at the next one from the state in which it has settled, up
to the last value and down again. Where two steady motions exist, the two ways differ.

A varied speed is held by the scene itself: by the set point of its governor, else by a torque,
which is found for each point so that the mean speed stays (--hold). The column mean_speed says
which speed the train really had, speed_drift by which part it changed. Each point is
measured over whole periods of the slowest excitation; the columns periods and period_of say which.
The dynamic factor of a mesh is its largest force over the static one; K_v of ISO 6336-1 is beside
it if the scene gives the teeth. The force of the mesh must be one of the observed outputs.

Writes response.parquet, response.csv and the plot.

Examples:
  gearsim response models/scenes/response.toml \\
      --over start.speed=\"2200 rpm:4200 rpm:51\" --output dte_12 --settle \"0.1 s\"
  gearsim response models/scenes/two_stage.toml --over start.speed=\"500 rpm:3000 rpm:50\" \\
      --output dte_12,mesh_force_34 --measure peak_to_peak --settle \"0.2 s\""
)]
pub(super) struct ResponseCommand {
    /// The scene: a TOML file, or - for the standard input
    scene: PathBuf,
    /// A key of the scene and its rising values, e.g. --over start.speed="1000 rpm:5000 rpm:81"
    #[arg(long, value_name = "KEY=VALUES")]
    over: String,
    /// The outputs to observe, by name [default: those that the scene records]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    output: Vec<String>,
    /// The measure that is drawn
    #[arg(long, default_value = "rms", value_parser = MEASURES.map(|measure| measure.name))]
    measure: String,
    /// Time of each point before it counts as settled; the rest of the run is measured
    #[arg(long, value_name = "TIME")]
    settle: String,
    /// The parameter that holds the speed, or "nothing" [default: if a speed is varied, the set point of a governor, else a torque
    /// that drives]
    #[arg(long, value_name = "PARAMETER")]
    hold: Option<String>,
    /// Only upward
    #[arg(long)]
    up: bool,
    /// Folder for the results; created if missing, older results in it are replaced
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Sets a value of the scene at all points; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

/// Version of the format of --json.
const VERSION: u32 = 3;

/// What --json prints.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    /// The varied key.
    key: &'a str,
    unit: &'a str,
    /// What a reader of the numbers must know: for each finding the number of points, and the remark of the first one.
    remarks: Vec<String>,
    /// The rows of `response.csv`.
    points: Vec<Map<String, Value>>,
    /// Names of the files in the folder.
    files: &'a [String],
}

impl Verb for ResponseCommand {
    fn run(self) -> Result<(), Failure> {
        let page = self.html.asked()?;
        let settle = crate::scene::quantity::parse_time(&self.settle).map_err(|why| Failure::Impossible {
            what: format!("--settle \"{}\" is not a time: {why}", self.settle),
            help: "write for example --settle \"0.1 s\"".into(),
        })?;
        let mut overrides = self.overrides.clone();
        if !self.output.is_empty() {
            overrides.push(format!("output.record={:?}", self.output));
        }
        let vary = vec![self.over.clone()];
        let request = Request { vary, overrides, from: Some(settle), ..Request::default() };
        let sweep = Sweep::load(&self.scene, known::models(), &request)?;
        let measure = self.measure_of(&sweep.first()?)?;
        let path = self.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{}_response", sweep.scene())));
        OutputFolder::probe(&path)?;

        let mut bar = PointsBar::new(sweep.points * if self.up { 1 } else { 2 }, self.printing.quiet());
        let response = sweep.response(!self.up, &Hold::named(self.hold.as_deref()), &mut |done| bar.at(done))?;
        drop(bar);
        let mut folder = OutputFolder::create(path)?;
        let table = response.table()?;
        let provenance = [("scene", sweep.scene().to_owned()), ("scene_sha256", sweep.hash())];
        let pairs = provenance.iter().map(|(name, value)| (*name, value.as_str()));
        folder.write("response.parquet", |sink| parquet::write(&table, pairs, sink))?;
        let figure = plot::response::figure(sweep.scene(), &response, measure);
        let figure = files::figure(&mut folder, "response", Ok(figure), terminal::warn)?;
        folder.write("response.csv", |sink| csv::write(&table, sink))?;
        if let Some(page) = page {
            page.response(&mut folder, &sweep.first()?, &facts(&response, measure), figure.as_ref(), &table)?;
        }
        folder.commit("response.csv")?;
        let width = terminal::width();
        let text = || {
            let facts = facts(&response, measure);
            let facts: String = facts.iter().map(|(name, says)| report::line(name, says, width)).collect();
            facts + "\n" + &report::files(folder.path(), folder.files(), width)
        };
        let json = || {
            let report = Report {
                scene: sweep.scene(),
                key: &response.key,
                unit: &response.unit,
                remarks: response.remarks(),
                points: document::records(&table),
                files: folder.files(),
            };
            document::json("response", VERSION, &report)
        };
        self.printing.warn(response.remarks().iter());
        self.printing.print(json, text)?;
        failure(&response, folder.path())
    }
}

impl ResponseCommand {
    /// The measure that is drawn, if one of the observed outputs of the scene has it.
    fn measure_of(&self, scene: &Scene) -> Result<Measure, Failure> {
        let mut outputs = scene.output.record.iter().map(|&i| &scene.model.outputs[i]);
        let has = |measure: &Measure| outputs.any(|output| (measure.is_of)(scene.model, output));
        measure(&self.measure).filter(has).ok_or_else(|| Failure::Impossible {
            what: format!("no observed output has a {}", self.measure.replace('_', " ")),
            help: "observe the force of a mesh, for example --output mesh_force_12".into(),
        })
    }
}

/// What holds the speed, what was measured, and the largest value of each output on each way with its place on the axis. Each is a name
/// and a text.
fn facts(response: &ResponseCurve, measure: Measure) -> Vec<(String, String)> {
    let mut facts = vec![("speed".into(), response.holding.clone()), ("measured".into(), measured(response))];
    let words = measure.name.replace('_', " ");
    let (unit, scale) = response.shown_unit();
    for (i, output) in response.outputs.iter().enumerate() {
        if !(measure.is_of)(response.model, output) {
            continue;
        }
        for (way, upward) in [("up", true), ("down", false)] {
            let points = response.points.iter().filter(|point| point.upward == upward && point.status == Status::Done);
            let values =
                points.map(|point| ((measure.value)(point, i), point.value)).filter(|(value, _)| !value.is_nan());
            if let Some((value, at)) = values.max_by(|a, b| a.0.total_cmp(&b.0)) {
                let (value, at) = (in_words(value, measure.unit(output)), number::short(scale * at));
                let says = format!("largest {words} on the way {way}: {value} at {at} {unit}");
                facts.push((output.name.into(), says.trim_end().into()));
            }
        }
        let why = response.points.iter().find_map(|point| (measure.lacks)(point, i));
        facts.extend(why.map(|why| (output.name.into(), format!("no {words} at some points: {why}"))));
    }
    facts.extend(response.remarks().into_iter().map(|remark| ("note".into(), remark)));
    facts
}

/// What the points were measured over, in words.
fn measured(response: &ResponseCurve) -> String {
    let spans: Vec<_> = response.points.iter().filter_map(|point| point.span).collect();
    let Some(first) = spans.first() else { return "nothing: no point has a result".into() };
    let (least, most) = spans.iter().fold((u32::MAX, 0), |(a, b), span| (a.min(span.periods), b.max(span.periods)));
    let short = spans.iter().filter(|span| span.periods == 0 && !span.of.is_empty()).count();
    let of = if spans.iter().all(|span| span.of == first.of) { first.of } else { "the slowest excitation of each" };
    match (first.of, short) {
        ("", _) => "all of the settled time: nothing excites the scene periodically".into(),
        (_, 0) if least == most => format!("{least} whole periods of {of}"),
        (_, 0) => format!("{least} to {most} whole periods of {of}"),
        _ => format!(
            "{short} of {} points are shorter than a period of {of}, and measured over all of their settled time: lengthen run.t_end",
            spans.len()
        ),
    }
}

/// A failure if a point was not run to its end, or not at its speed.
fn failure(response: &ResponseCurve, folder: &Path) -> Result<(), Failure> {
    let wrong: Vec<_> = response.points.iter().filter(|point| point.status != Status::Done).collect();
    match wrong.first() {
        None => Ok(()),
        Some(first) => Err(Failure::Points {
            what: format!(
                "{} of {} points of the response have no valid result; the first is {} = {} {}: {}",
                wrong.len(),
                response.points.len(),
                response.key,
                number::short(first.value),
                response.unit,
                first.reason
            ),
            folder: folder.to_owned(),
        }),
    }
}
