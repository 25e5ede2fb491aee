//! `gearsim floquet`: stability of steady rotation.

mod vary;

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::number::short;
use super::simulate::{Source, entry};
use super::{Verb, files, provenance, report, terminal};
use crate::analysis::floquet::{Chart, Floquet, FloquetError, Spot, Varied, Verdict};
use crate::output::summary::Provenance;
use crate::output::{OutputError, OutputFolder, Table, csv, table::Values};
use crate::plot;
use crate::scene::Scene;
use vary::Vary;

/// Stability of steady rotation: Floquet multipliers, and charts of them
#[derive(Parser)]
#[command(
    name = "floquet",
    after_help = "\
Every mesh turns on at the speed that the scene starts it with, so that the stiffnesses are
periodic in time, k(Omega0 t). The product of the exact propagators of a period's cells gives
the multipliers by which a small disturbance grows. Rigid motions, which always have the
multiplier 1, are left out.

--vary goes along a range of one quantity of the scene; given twice, the first along x and the
second along y of a chart. Writes floquet.json; with --vary also stability.csv and the plot of
it.

Examples:
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml --vary start.speed=\"4000..14000 rpm\"
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml --vary start.speed=\"4000..14000 rpm\" \\
      --vary parameters.zeta=0..0.15 --points 400,60"
)]
pub(super) struct Floquets {
    #[command(flatten)]
    source: Source,
    /// Goes along a range of a quantity of the scene; once or twice
    #[arg(long, value_name = "KEY=LOW..HIGH UNIT")]
    vary: Vec<Vary>,
    /// Points along each range
    #[arg(long, value_name = "X,Y", value_delimiter = ',', default_values_t = [400, 60])]
    points: Vec<usize>,
}

/// The content of `floquet.json`: the scene as it is.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    model: &'a str,
    /// Common period of all stiffnesses [s].
    period: f64,
    /// Frequency of the first mesh that steps [Hz].
    mesh_frequency: f64,
    /// Lowest natural frequency at the mean stiffness [Hz].
    natural_frequency: f64,
    /// Real and imaginary parts, largest first, rigid motions left out.
    multipliers: Vec<[f64; 2]>,
    rigid_motions: usize,
    verdict: &'static str,
    /// Logarithm of the largest multiplier.
    growth_per_period: f64,
    /// Files written beside this one.
    files: Vec<String>,
    provenance: Provenance,
}

impl Verb for Floquets {
    fn run(self) -> Result<(), Failure> {
        let scene = self.source.load()?;
        let floquet = self.of(&scene)?;
        let chart = self.chart(&scene)?;
        let path = self.source.folder(&scene, "_floquet")?;
        let mut folder = OutputFolder::create(path)?;
        if let Some(chart) = &chart {
            let table = table(chart)?;
            folder.write("stability.csv", |sink| csv::write(&table, sink))?;
            let figure = plot::floquet::draw(&chart.clone().by_ratio());
            files::figure(&mut folder, "stability", figure, terminal::warn)?;
        }
        let report = Report {
            scene: &scene.name,
            model: scene.model.name,
            period: floquet.period,
            mesh_frequency: floquet.mesh,
            natural_frequency: floquet.natural,
            multipliers: floquet.multipliers.iter().map(|z| [z.re, z.im]).collect(),
            rigid_motions: floquet.rigid,
            verdict: word(floquet.verdict),
            growth_per_period: floquet.growth(),
            files: folder.files().to_vec(),
            provenance: provenance::of(&scene, &self.source.overrides, "product of exact cell propagators".into()),
        };
        let json = serde_json::to_string_pretty(&report).map_err(|e| OutputError::format("JSON", e))?;
        folder.write_bytes("floquet.json", (json + "\n").as_bytes())?;
        let width = terminal::width();
        let told = tell(&floquet) + &chart.as_ref().map_or(String::new(), share);
        let written = report::files(folder.path(), folder.files(), width);
        terminal::say(&format!("{}\n{}\n{written}", report::scene(&scene, width), terminal::wrap(&told, width)));
        Ok(())
    }
}

impl Floquets {
    fn of(&self, scene: &Scene) -> Result<Floquet, Failure> {
        let refused = |refusal| Failure::Refused { scene: scene.name.clone(), refusal };
        let system = entry(scene)?.system(scene).map_err(refused)?;
        Floquet::of(scene, &system).map_err(|error| match error {
            FloquetError::Refused(refusal) => refused(refusal),
            other => Failure::Impossible {
                what: format!("scene {} has no Floquet multipliers", scene.name),
                help: other.to_string(),
            },
        })
    }

    /// The chart that --vary asks for.
    fn chart(&self, scene: &Scene) -> Result<Option<Chart>, Failure> {
        let wrong = |what: &str, help: &str| Failure::Impossible { what: what.into(), help: help.into() };
        if self.vary.len() > 2 {
            return Err(wrong("--vary is given more than twice", "a chart has two axes"));
        }
        if self.points.len() > 2 || self.points.iter().any(|n| !(2..=5000).contains(n)) {
            return Err(wrong("--points takes one or two numbers from 2 to 5000", "for example --points 400,60"));
        }
        let Some(along) = self.vary.first() else { return Ok(None) };
        let points = |i: usize| self.points.get(i).copied().unwrap_or(60);
        let (x, y) = (along.values(points(0)), self.vary.get(1).map(|v| (v, v.values(points(1)))));
        let spot = |overrides: &[String]| -> Result<Option<Spot>, Failure> {
            let varied = self.source.load_with(overrides)?;
            // What is refused at one place, a rigid pair at rest for one, leaves a gap in the chart.
            Ok(self.of(&varied).ok().map(|f| Spot::from(&f)))
        };
        let row = |fixed: Option<String>| -> Result<Vec<Option<Spot>>, Failure> {
            x.iter().map(|x| spot(&[along.set(*x)].into_iter().chain(fixed.clone()).collect::<Vec<_>>())).collect()
        };
        let rows = match &y {
            None => vec![row(None)?],
            Some((vary, values)) => values.iter().map(|y| row(Some(vary.set(*y)))).collect::<Result<_, _>>()?,
        };
        let varied = |vary: &Vary, values: &[f64]| Varied {
            name: vary.key.clone(),
            unit: vary.unit.clone(),
            values: values.to_vec(),
        };
        Ok(Some(Chart {
            scene: scene.name.clone(),
            x: varied(along, &x),
            y: y.as_ref().map(|(vary, values)| varied(vary, values)),
            rows,
        }))
    }
}

/// The chart as a table: one row a spot, in the units that --vary was given.
fn table(chart: &Chart) -> Result<Table, OutputError> {
    let mut table = Table::default();
    let ys: Vec<f64> = chart.y.as_ref().map_or(vec![0.0], |y| y.values.clone());
    let each = |of: &dyn Fn(f64, f64, Option<Spot>) -> f64| {
        let rows = chart.rows.iter().zip(&ys);
        rows.flat_map(|(row, y)| row.iter().zip(&chart.x.values).map(|(s, x)| of(*x, *y, *s)).collect::<Vec<_>>())
            .collect()
    };
    let known = |spot: Option<Spot>, of: fn(Spot) -> f64| spot.map_or(f64::NAN, of);
    table.push(&chart.x.name, &chart.x.unit, Values::Number(each(&|x, _, _| x)))?;
    if let Some(y) = &chart.y {
        table.push(&y.name, &y.unit, Values::Number(each(&|_, y, _| y)))?;
    }
    table.push("frequency_ratio", "1", Values::Number(each(&|_, _, s| known(s, |s| s.ratio))))?;
    table.push("growth_per_period", "1", Values::Number(each(&|_, _, s| known(s, |s| s.growth))))?;
    table.push("unstable", "1", Values::Number(each(&|_, _, s| known(s, |s| f64::from(u8::from(s.unstable))))))?;
    Ok(table)
}

fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Stable => "stable",
        Verdict::Neutral => "neutral",
        Verdict::Border => "border",
        Verdict::Growing => "unstable, growing",
        Verdict::Alternating => "unstable, alternating",
        Verdict::Combination => "unstable, combination",
    }
}

/// What the multipliers of the scene say.
fn tell(f: &Floquet) -> String {
    let z = |z: &nalgebra::Complex<f64>| match z.im == 0.0 {
        true => short(z.re),
        false => format!("{} {} {}i", short(z.re), if z.im < 0.0 { "-" } else { "+" }, short(z.im.abs())),
    };
    let verdict = match f.verdict {
        Verdict::Stable => format!("stable: a disturbance falls to {} of itself a period", short(f.growth().exp())),
        Verdict::Neutral => "neutral: undamped, a disturbance stays as it is".into(),
        Verdict::Border => {
            "on the border: two multipliers meet on the unit circle (for one vibration, trace = +-2), so that a disturbance \
             stays or grows linearly"
                .into()
        }
        Verdict::Growing => format!("unstable: a disturbance grows {}-fold a period", short(f.growth().exp())),
        Verdict::Alternating => {
            format!("unstable: a disturbance changes its sign and grows {}-fold a period", short(f.growth().exp()))
        }
        Verdict::Combination => {
            format!("unstable: two vibrations grow together, {}-fold a period", short(f.growth().exp()))
        }
    };
    let mut text = format!("{verdict}\n");
    text += &format!("period {} s, growth rate {} 1/s\n", short(f.period), short(f.growth() / f.period));
    let ratio = f.mesh / f.natural;
    text += &format!(
        "mesh frequency {} Hz, {} of the lowest natural frequency {} Hz at the mean stiffness\n",
        short(f.mesh),
        short(ratio),
        short(f.natural)
    );
    let all: Vec<String> = f.multipliers.iter().take(12).map(z).collect();
    let more = if f.multipliers.len() > 12 { ", ..." } else { "" };
    text += &format!("multipliers {}{more}\n", all.join(", "));
    text + &format!("rigid motions left out: {}\n", f.rigid)
}

/// How much of a chart is unstable.
fn share(chart: &Chart) -> String {
    let spots: Vec<&Option<Spot>> = chart.rows.iter().flatten().collect();
    let unstable = spots.iter().filter(|s| s.is_some_and(|s| s.unstable)).count();
    let refused = spots.iter().filter(|s| s.is_none()).count();
    let mut text = format!("chart of {} points: {unstable} unstable", spots.len());
    if refused > 0 {
        text += &format!(", {refused} refused and left blank");
    }
    text + "\n"
}
