//! `gearsim floquet`: stability of steady rotation by Floquet multipliers.

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::number::short;
use super::printing::Printing;
use super::report::Linearised;
use super::simulate::Source;
use super::{Verb, files, page, provenance, report, terminal};
use crate::analysis::floquet::{Chart, Floquet, Orbit, Spot, Varied, Verdict};
use crate::known;
use crate::library::Error;
use crate::output::summary::Provenance;
use crate::output::{OutputError, OutputFolder, Table, csv, document, table::Values};
use crate::plot;
use crate::scene::{Scene, Template};
use crate::sweep::axis::{self, Axis};

/// Most values along an axis of a chart: a plot does not show more.
const MOST: usize = 5000;

/// Stability of steady rotation: Floquet multipliers, and charts of them
#[derive(Parser)]
#[command(
    name = "floquet",
    after_help = "\
Every mesh turns at the constant speed with which the scene starts it, so that the stiffnesses are
periodic in time, k(Omega0 t). The monodromy matrix is the product of the exact propagators of the
cells of a period. Its eigenvalues, the Floquet multipliers, say by which factor a small disturbance
grows per period. Rigid motions always have the multiplier 1 and are left out.

Friction of the flanks and torques that depend on the speed are linearised about the steady
motion, whose speeds and mean forces are printed. Where inertias change along the motion (a crank, a
universal joint), no motion is steady: the equations are linearised about the one that repeats after
a turn at the mean speed of the start.

--vary varies a quantity of the scene, by values as of `gearsim sweep`. Given twice, the first
quantity is the x axis and the second the y axis of a stability chart. Writes floquet.json; with
--vary also stability.csv and its plot.

Examples:
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml \\
      --vary start.speed=\"4000 rpm:14000 rpm:400\"
  gearsim floquet models/scenes/oh2005/energy_300rpm.toml \\
      --vary start.speed=\"4000 rpm:14000 rpm:400\" --vary parameters.zeta=0:0.15:60"
)]
pub(super) struct FloquetCommand {
    #[command(flatten)]
    source: Source,
    /// A key of the scene and its rising values, e.g. --vary start.speed="300 rpm:9000 rpm:400"; may be given twice
    #[arg(long, value_name = "KEY=VALUES")]
    vary: Vec<String>,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

/// Version of the format of `floquet.json`.
const VERSION: u32 = 3;

/// The content of `floquet.json`: the results for the scene itself, without --vary.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    model: &'a str,
    /// Common period of all stiffnesses [s].
    period: f64,
    /// Frequency of the first mesh whose stiffness varies [Hz].
    mesh_frequency: f64,
    /// Lowest natural frequency at the mean stiffness [Hz].
    natural_frequency: f64,
    /// Real and imaginary parts of the Floquet multipliers, the largest first, without those of rigid motions and those smaller than the
    /// rounding error.
    multipliers: Vec<[f64; 2]>,
    /// Number of multipliers smaller than the rounding error.
    unresolved_multipliers: usize,
    /// Rounding error of a multiplier.
    rounding_error: f64,
    /// Number of rigid motions.
    rigid_motions: usize,
    /// What the analysis leaves out because it is linear.
    left_out: Vec<&'static str>,
    /// The steady motion about which nonlinear forces are linearised.
    #[serde(skip_serializing_if = "Option::is_none")]
    linearised: Option<Linearised<'a>>,
    /// The periodic motion about which the equations are linearised, if inertias change along the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    orbit: Option<Repeats<'a>>,
    verdict: &'static str,
    /// Natural logarithm of the largest absolute value of a multiplier. If all multipliers are smaller than the rounding error: the
    /// logarithm of the rounding error, an upper bound.
    growth_per_period: f64,
    /// Names of the other files in the same folder.
    files: Vec<String>,
    provenance: Provenance,
}

/// A motion that repeats after a turn.
#[derive(Serialize)]
struct Repeats<'a> {
    /// Coordinate by which turns are counted.
    reference: &'a str,
    /// Change of the reference coordinate in a turn [SI].
    turn: f64,
    /// Coordinates and speeds at the start of the turn [SI], in the order of the model.
    q: &'a [f64],
    q_dot: &'a [f64],
    /// Relative change of the speed of the reference in a turn.
    drift: f64,
    /// Residual of the periodicity of the motion over a turn [relative to the rotation].
    gap: f64,
    /// Real and imaginary part of the Floquet multiplier of a change of the rotational speed.
    speed_multiplier: [f64; 2],
}

impl<'a> Repeats<'a> {
    fn of(orbit: &'a Orbit) -> Self {
        let Orbit { reference, turn, start: [q, q_dot], drift, gap, speed } = orbit;
        let (turn, drift, gap) = (*turn, *drift, *gap);
        Repeats { reference, turn, q, q_dot, drift, gap, speed_multiplier: [speed.re, speed.im] }
    }
}

impl Verb for FloquetCommand {
    fn run(self) -> Result<(), Failure> {
        let page = self.html.asked()?;
        let scene = self.source.load()?;
        let floquet = scene.floquet()?;
        let chart = self.chart(&scene)?;
        let path = self.source.folder(&scene, "_floquet")?;
        let mut folder = OutputFolder::create(path)?;
        let points = chart.as_ref().map(table).transpose()?;
        let charted = chart.as_ref().zip(points.as_ref());
        if let Some((chart, table)) = charted {
            folder.write("stability.csv", |sink| csv::write(table, sink))?;
            let figure = plot::floquet::draw(&chart.clone().by_ratio());
            files::figure(&mut folder, "stability", figure, terminal::warn)?;
        }
        let words = || describe(&floquet) + &chart.as_ref().map_or(String::new(), unstable_share);
        if let Some(page) = page {
            page.floquet(&mut folder, &scene, &words(), &floquet, charted)?;
        }
        let report = Report {
            scene: &scene.name,
            model: scene.model.name,
            period: floquet.period,
            mesh_frequency: floquet.mesh,
            natural_frequency: floquet.natural,
            multipliers: floquet.multipliers.iter().map(|z| [z.re, z.im]).collect(),
            unresolved_multipliers: floquet.unresolved,
            rounding_error: floquet.rounding,
            rigid_motions: floquet.rigid,
            left_out: scene.left_out_if_linear(),
            linearised: Linearised::of(&scene, floquet.steady.as_ref()),
            orbit: floquet.orbit.as_ref().map(Repeats::of),
            verdict: word(floquet.verdict),
            growth_per_period: floquet.growth(),
            files: folder.files().to_vec(),
            provenance: provenance::of(&scene, floquet.method().into()),
        };
        let json = document::json("floquet", VERSION, &report)?;
        folder.write_bytes("floquet.json", json.as_bytes())?;
        folder.commit("floquet.json")?;
        let width = terminal::width();
        let text = || {
            let written = report::files(folder.path(), folder.files(), width);
            let head = report::scene(&scene, width)
                + "\n"
                + &report::left_out(&scene, width)
                + &report::linearised(&scene, floquet.steady.as_ref(), width);
            format!("{head}{}\n{written}", terminal::wrap(&words(), width))
        };
        self.printing.print(|| Ok::<_, Failure>(json), text)
    }
}

impl FloquetCommand {
    /// The stability chart over the axes of --vary; `None` without --vary.
    fn chart(&self, scene: &Scene) -> Result<Option<Chart>, Failure> {
        let template = Template::again(scene, &scene.overrides).map_err(Error::from)?;
        let axes = crate::sweep::axes(&template, scene.model, &self.vary).map_err(Error::from)?;
        if axes.len() > 2 {
            let (what, help) = ("--vary is given more than twice".into(), "a chart has two axes".into());
            return Err(Failure::Impossible { what, help });
        }
        let values = axes.iter().map(rising).collect::<Result<Vec<_>, _>>()?;
        let Some((along, x)) = axes.first().zip(values.first()) else { return Ok(None) };
        let up = axes.get(1).zip(values.get(1));
        let models = known::descriptions();
        let spot = |values: &[String]| -> Result<Option<Spot>, Failure> {
            let varied = template.scene(values, &models).map_err(Error::from)?;
            // A point that has no multipliers, e.g. because nothing turns, is left blank in the chart.
            Ok(varied.floquet().ok().map(|f| Spot::from(&f)))
        };
        let set = |axis: &Axis, i: usize| format!("{}={}", axis.key, axis.value(i));
        let row = |fixed: Option<String>| -> Result<Vec<Option<Spot>>, Failure> {
            let at = |i| spot(&[set(along, i)].into_iter().chain(fixed.clone()).collect::<Vec<_>>());
            (0..x.len()).map(at).collect()
        };
        let rows = match up {
            None => vec![row(None)?],
            Some((axis, y)) => (0..y.len()).map(|i| row(Some(set(axis, i)))).collect::<Result<_, _>>()?,
        };
        let varied = |(axis, values): (&Axis, &Vec<f64>)| Varied {
            name: axis.key.clone(),
            unit: axis.unit.clone(),
            values: values.clone(),
        };
        Ok(Some(Chart { scene: scene.name.clone(), x: varied((along, x)), y: up.map(varied), rows }))
    }
}

/// The values of an axis of a chart, in its unit.
fn rising(axis: &Axis) -> Result<Vec<f64>, Failure> {
    let count = axis.count().unwrap_or(0);
    // A range has one unit. The values of a list may have different units, so that a list is read in SI units.
    let number = if axis.unit.is_empty() { axis::si } else { axis::number };
    let values: Vec<f64> = (0..count).map(|i| number(&axis.value(i))).collect();
    match (2..=MOST).contains(&count) && values.windows(2).all(|pair| pair[0] < pair[1]) {
        true => Ok(values),
        false => Err(Failure::Impossible {
            what: format!("a chart needs 2 to {MOST} rising numbers of `{}`", axis.key),
            help: "for example --vary start.speed=\"300 rpm:9000 rpm:400\"".into(),
        }),
    }
}

/// The chart as a table: one row per point, in the units given to --vary.
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

/// The stability of the scene in words, with its multipliers.
fn describe(f: &Floquet) -> String {
    let z = |z: &nalgebra::Complex<f64>| match z.im == 0.0 {
        true => short(z.re),
        false => format!("{} {} {}i", short(z.re), if z.im < 0.0 { "-" } else { "+" }, short(z.im.abs())),
    };
    let (factor, is_bound) = (short(f.growth().exp()), f.multipliers.is_empty());
    let below = |less: &'static str| if is_bound { less } else { "" };
    let verdict = match f.verdict {
        Verdict::Stable => {
            format!("stable: a disturbance decays to {}{factor} times its size in a period", below("less than "))
        }
        Verdict::Neutral => "neutral: there is no damping, and a disturbance keeps its size".into(),
        Verdict::Border => {
            "on the border of stability: two multipliers coincide on the unit circle (for a single vibration, trace = +-2), so \
             that a disturbance keeps its size or grows linearly"
                .into()
        }
        Verdict::Growing => format!("unstable: a disturbance grows by the factor {factor} in a period"),
        Verdict::Alternating => {
            format!("unstable: a disturbance changes its sign and grows by the factor {factor} in a period")
        }
        Verdict::Combination => {
            format!("unstable: two vibrations grow together, by the factor {factor} in a period (combination resonance)")
        }
    };
    let mut text = format!("{verdict}\n");
    let rate = short(f.growth() / f.period);
    text += &format!("period {} s, growth rate {}{rate} 1/s\n", short(f.period), below("below "));
    let ratio = f.mesh / f.natural;
    let mesh = format!(
        "mesh frequency {} Hz, {} times the lowest natural frequency {} Hz at the mean stiffness\n",
        short(f.mesh),
        short(ratio),
        short(f.natural)
    );
    text += &if f.mesh > 0.0 { mesh } else { format!("lowest natural frequency {} Hz\n", short(f.natural)) };
    let mut all: Vec<String> = f.multipliers.iter().take(12).map(z).collect();
    all.extend((f.multipliers.len() > 12).then(|| "...".into()));
    all.extend((f.unresolved > 0).then(|| format!("{} smaller than {}", f.unresolved, short(f.rounding))));
    text += &format!("multipliers {}\n", all.join(", "));
    if let Some(Orbit { reference, turn, drift, gap, speed, .. }) = &f.orbit {
        text += &format!(
            "about the motion that repeats after {reference} has moved on by {} (to {} of the rotation); its speed changes by {} % in a \
             turn\nmultiplier of a change of the speed of the rotation, not in the verdict: {}\n",
            short(*turn),
            short(*gap),
            short(100.0 * drift),
            z(speed)
        );
    }
    text + &format!("rigid motions left out: {}\n", f.rigid)
}

/// The number of unstable points of a chart, and of those without a result.
fn unstable_share(chart: &Chart) -> String {
    let spots: Vec<&Option<Spot>> = chart.rows.iter().flatten().collect();
    let unstable = spots.iter().filter(|s| s.is_some_and(|s| s.unstable)).count();
    let refused = spots.iter().filter(|s| s.is_none()).count();
    let mut text = format!("chart of {} points: {unstable} unstable", spots.len());
    if refused > 0 {
        text += &format!(", {refused} without multipliers and left blank");
    }
    text + "\n"
}
