//! `gearsim sweep`: one scene at many points, on all cores.

mod plots;
mod report;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;

use super::failure::Failure;
use super::progress::PointsBar;
use super::{Verb, known, provenance, terminal};
use crate::output::OutputFolder;
use crate::sweep::folder::{self, Folder};
use crate::sweep::record::GROUPS;
use crate::sweep::{Manifest, Request, Shard, Sweep};
use crate::tolerance::scene::THREADS;
pub(super) use plots::PlotOptions;
pub(super) use report::{Progress, summary_text};

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
    /// Number of random points for every point of the grid of the other axes
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// Seed of random axes
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Groups of quantities to record
    #[arg(long, value_name = "GROUPS", value_delimiter = ',', default_value = "events,state,digits,energy,extremes")]
    record: Vec<String>,
    /// Time from which on extremes and spectra are computed, e.g. after the initial transient
    #[arg(long, value_name = "TIME", default_value = "0 s")]
    from: String,
    #[command(flatten)]
    plots: PlotOptions,
    /// Runs only shard I of N of the points; `gearsim merge` joins the shards. auto: that of
    /// this task in a job array of Slurm; auto/N: in one of Kubernetes
    #[arg(long, value_name = "I/N", default_value_t = Shard::WHOLE)]
    shard: Shard,
    /// Number of threads, at most 1024 [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=THREADS))]
    threads: Option<u16>,
    /// Print nothing but warnings and errors
    #[arg(long, short)]
    quiet: bool,
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
  KEY=uniform:A:B        random values, as many as --samples says; also log-uniform:A:B
Numbers without a unit are in the SI unit of the key. The last of several axes varies fastest.

Writes sweep.parquet with one row per point in this order, sweep.json and plots. A point that cannot
be simulated has a row with the reason. The same command continues an interrupted sweep. The bytes
of the result depend neither on the number of threads nor on interruptions and shards.

Groups that can be recorded:
{groups}extremes, peak and outputs need samples at output.rate, which take longer than the motion itself: a sweep
without them is faster. Each thread then has the rows of one run in memory, by default at most 1 GB.

Examples:
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --vary parameters.T0=1:100:50
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --map first_reflection \\
      --vary parameters.T0=\"log:1 N*m:500 N*m:50\" --vary start.speed=\"100 rpm:6000 rpm:60\"
  gearsim sweep models/scenes/oh2005/energy_300rpm.toml --samples 1000 \\
      --vary start.speed=\"uniform:100 rpm:900 rpm\"
  on the second of eight machines, and at the end on one machine that has all folders:
  gearsim sweep SCENE --vary KEY=A:B:N --shard 2/8 --out shard2
  gearsim merge shard1 shard2 shard3 shard4 shard5 shard6 shard7 shard8 --out whole"
    )
}

impl Verb for SweepCommand {
    fn run(self) -> Result<(), Failure> {
        let from = crate::scene::quantity::parse_time(&self.from).map_err(|why| Failure::Impossible {
            what: format!("--from \"{}\" is not a time: {why}", self.from),
            help: "write for example --from \"0.1 s\"".into(),
        })?;
        let request = Request {
            vary: self.vary.clone(),
            overrides: self.overrides.clone(),
            samples: self.samples,
            seed: self.seed,
            from,
            record: self.record.clone(),
            spectra: self.plots.waterfall,
        };
        let sweep = Sweep::load(&self.scene, known::models(), &request)?;
        let manifest = Manifest::new(&sweep, &request, provenance::COMMIT);
        let layout = manifest.layout(known::models())?;
        self.plots.check(&layout)?;
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
        let mut bar = PointsBar::new(todo.len(), self.quiet);
        let watch = |count| {
            bar.at(count);
            ControlFlow::Continue(())
        };
        sweep.run(&todo, threads, |rows| Ok(folder.keep(&rows)?), watch)?;
        drop(bar);
        let rows = folder.finish()?;

        let mut files = vec![folder::ROWS.to_owned(), crate::sweep::manifest::FILE.to_owned()];
        if rows.len() == sweep.points {
            files.extend(self.plots.draw(&path, &manifest, &layout, &rows)?);
        }
        if !self.quiet {
            let done =
                Progress { before, ran: todo.len(), seconds: begin.elapsed().as_secs_f64(), threads: threads.get() };
            terminal::print_out(&summary_text(&path, &files, &manifest, &rows, Some(done)));
        }
        Failure::of_points(&rows, &path)
    }
}
