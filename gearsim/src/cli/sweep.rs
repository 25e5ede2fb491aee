//! `gearsim sweep`: one scene at many points, on all cores.

mod evaluation;
mod json;
mod plots;
mod report;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::progress::PointsBar;
use super::{Verb, known, provenance};
use crate::output::OutputFolder;
use crate::sweep::folder::Folder;
use crate::sweep::record::GROUPS;
use crate::sweep::{Design, Manifest, Request, Shard, Sweep};
use crate::tolerance::scene::THREADS;
pub(super) use evaluation::Evaluation;
pub(super) use report::Progress;

/// Run a scene at many points, and write a table with one row per point
#[derive(Parser)]
#[command(name = "sweep", after_help = after_help())]
pub(super) struct SweepCommand {
    /// The scene: a TOML file, or - for the standard input
    scene: PathBuf,
    /// A key of the scene and its values, e.g. --vary parameters.T0="1 N*m:100 N*m:50"; may be repeated
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    vary: Vec<String>,
    /// Folder for the results; created if missing, continued if it holds a part of this sweep
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Sets a value of the scene at all points; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Number N of samples for every point of the grid of the other axes
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// How the samples are chosen: random, latin-hypercube, sobol, saltelli
    #[arg(long, value_name = "DESIGN", default_value = Design::Random.name(), hide_default_value = false)]
    design: Design,
    /// Seed of random axes
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Groups of quantities to record
    #[arg(long, value_name = "GROUPS", value_delimiter = ',', default_value = "events,state,digits,energy,extremes")]
    record: Vec<String>,
    /// Time from which on extremes and spectra are computed, e.g. after the initial transient
    /// [default: output.from of the scene]
    #[arg(long, value_name = "TIME")]
    from: Option<String>,
    #[command(flatten)]
    evaluation: Evaluation,
    /// Runs only shard I of N of the points; `gearsim merge` joins the shards. auto: that of
    /// this task in a job array of Slurm whose tasks are submitted together; auto/N: in one of
    /// N tasks, from 1 to N of Slurm or indexed by Kubernetes
    #[arg(long, value_name = "I/N", default_value_t = Shard::WHOLE)]
    shard: Shard,
    /// Number of threads, at most 1024 [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=THREADS))]
    threads: Option<u16>,
    #[command(flatten)]
    printing: Printing,
}

/// The help text below the options. The description of each group comes from the group.
fn after_help() -> String {
    let groups = GROUPS.iter().map(|group| format!("  {:<10}{}\n", group.name, group.doc)).collect::<String>();
    format!(
        "\
Values of an axis:
  KEY=A:B:N              N values from A to B in equal steps, both included
  KEY=log:A:B:N          N values from A to B in equal ratios, both included
  KEY=V1,V2,V3           a list of values
  KEY=uniform:A:B        random values between A and B; also log-uniform:A:B
  KEY=normal:M:S         normally distributed: mean M, standard deviation S
  KEY=normal:M:S:A:B     the same, but only between A and B
Numbers have units, as in a scene. The last of several axes varies fastest.

Designs of --samples N with random axes:
  random                 N independent points
  latin-hypercube        on each axis one point in each of N equal intervals
  sobol                  N points of a Sobol' sequence; best if N is a power of two
  saltelli               N (d + 2) points for d random axes: sensitivity.csv then says which share
                         of the variance of each quantity each axis causes

Writes sweep.parquet with one row per point in this order, sweep.json and plots. With random axes
also statistics.csv, and limits.csv with --limit. A point that cannot be simulated has a row with
the reason. The same command continues an interrupted sweep. The bytes of the result depend neither
on the number of threads nor on interruptions and shards.

Groups that can be recorded:
{groups}extremes, peak, outputs and meshes need samples at output.rate, which take longer than the motion
itself: a sweep without them is faster. Each thread then has the rows of one run in memory, by
default at most 1 GB.

Examples:
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --vary parameters.T0=\"1 N*m:100 N*m:50\"
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --map first_reflection \\
      --vary parameters.T0=\"log:1 N*m:500 N*m:50\" --vary start.speed=\"100 rpm:6000 rpm:60\"
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --samples 1000 \\
      --vary start.speed=\"uniform:100 rpm:900 rpm\" --limit \"first_reflection >= 50 ms\"
  gearsim sweep models/scenes/response.toml --samples 256 --design saltelli --record outputs \\
      --vary parameters.b12=\"normal:100 um:10 um\" --vary parameters.beta_K=\"uniform:2 us:4 us\"
  on the second of eight machines, and at the end on one machine that has all folders:
  gearsim sweep SCENE --vary KEY=A:B:N --shard 2/8 --out shard2
  gearsim merge shard1 shard2 shard3 shard4 shard5 shard6 shard7 shard8 --out whole"
    )
}

impl Verb for SweepCommand {
    fn run(self) -> Result<(), Failure> {
        let time = |from: &String| {
            crate::scene::quantity::parse_time(from).map_err(|why| Failure::Impossible {
                what: format!("--from \"{from}\" is not a time: {why}"),
                help: "write for example --from \"0.1 s\"".into(),
            })
        };
        let from = self.from.as_ref().map(time).transpose()?;
        let request = Request {
            vary: self.vary.clone(),
            overrides: self.overrides.clone(),
            samples: self.samples,
            design: self.design,
            seed: self.seed,
            from,
            record: self.record.clone(),
            spectra: self.evaluation.plots.waterfall,
        };
        let sweep = Sweep::load(&self.scene, known::models(), &request)?;
        let manifest = Manifest::new(&sweep, &request, provenance::COMMIT);
        let layout = manifest.layout(known::models())?;
        self.evaluation.check(&layout)?;
        let default = || Path::new("out").join(format!("{}_sweep", sweep.scene()));
        let path = self.out.clone().unwrap_or_else(default);
        OutputFolder::probe(&path)?;

        let begin = Instant::now();
        let mut folder = Folder::open(&path, manifest.clone(), layout.clone())?;
        let there = folder.rows()?;
        let mine = |point: &usize| self.shard.has(*point);
        let todo: Vec<usize> = (0..sweep.points).filter(|point| mine(point) && !there.contains_key(point)).collect();
        let before = there.len();
        drop(there);
        let threads = self.threads.and_then(|n| NonZeroUsize::new(n.into()));
        let threads = threads.unwrap_or_else(|| std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN));
        let mut bar = PointsBar::new(todo.len(), self.printing.quiet());
        let watch = |count| {
            bar.at(count);
            ControlFlow::Continue(())
        };
        sweep.run(&todo, threads, |rows| Ok(folder.keep(&rows)?), watch)?;
        drop(bar);
        let (rows, _) = folder.finish()?;

        let threads = threads.get();
        let done = Progress {
            before,
            ran: todo.len(),
            seconds: begin.elapsed().as_secs_f64(),
            threads,
            text: sweep.text().to_owned(),
        };
        self.evaluation.finish(&path, &manifest, &layout, &rows, Some(done), &self.printing)?;
        Failure::of_points(&rows, &path)
    }
}
