//! `gearsim modes`: natural frequencies, damping, mode shapes and energies of a scene's cells.

mod table;

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::printing::Printing;
use super::report::Linearised;
use super::simulate::Source;
use super::{Verb, files, page, provenance, report, terminal};
use crate::analysis::modes::{self, CellModes, OverATurn, Parts};
use crate::analysis::steady::{self, SteadyLaw};
use crate::engine::system::Steady;
use crate::output::summary::Provenance;
use crate::output::{OutputFolder, document};
use crate::plot;
use crate::scene::Scene;

/// Natural frequencies, damping, mode shapes and energies of a scene's cells
#[derive(Parser)]
#[command(
    name = "modes",
    after_help = "\
A cell is a combination of the levels of the scene's stiffnesses. One cell is shown in full: that of
the mid stiffnesses, (max + min)/2 of each law, or the one chosen by --cell. A table has the natural
frequencies of all others.

Nonlinear equations are linearised: about the equilibrium if nothing turns, else about the steady
motion at the speeds of the start. Where inertias change along the motion, the modes are those of
the place of the start; the range of each natural frequency over a turn follows. They do not tell
whether the motion is stable: see gearsim floquet.

Writes modes.json with all results, a plot of the modes by energy, and, if meshes turn, a Campbell
diagram: natural frequencies and mesh orders over the speed. Modes have the same numbers everywhere:
rigid motions first, from 0, then by ascending frequency.

Examples:
  gearsim modes models/scenes/oh2005/energy_300rpm.toml
  gearsim modes models/scenes/oh2005/energy_300rpm.toml --cell 1 --out out/modes"
)]
pub(super) struct Modes {
    #[command(flatten)]
    source: Source,
    /// The level of each law, counted from 0, e.g. 1 or 0,1 [default: the mid stiffnesses]
    #[arg(long, value_name = "LEVEL,...", value_delimiter = ',')]
    cell: Option<Vec<usize>>,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

/// Version of the format of `modes.json`.
const VERSION: u32 = 3;

/// The content of `modes.json`.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    model: &'a str,
    /// Names of the coordinates, in the order of `shape`.
    coordinates: Vec<&'a str>,
    /// SI units of the coordinates, which are those of the amplitudes in `shape`.
    units: Vec<&'a str>,
    /// Names of the laws, in the order of `levels` and `strain_energy`.
    laws: Vec<&'a str>,
    /// Names of the parameters that are stiffnesses, in the order of `strain_energy_of_springs`.
    springs: Vec<&'a str>,
    /// Names of the parameters that are inertias, in the order of `kinetic_energy`.
    masses: Vec<&'a str>,
    /// The cell chosen by --cell, or that of the mid stiffnesses.
    chosen: CellReport,
    /// Every combination of levels; empty if there are too many.
    cells: Vec<CellReport>,
    /// Mesh frequency of each law at the scene's speed [Hz]; `null` for a law that does not step.
    mesh_frequencies: Vec<Option<f64>>,
    /// Harmonics of a mesh frequency near a damped natural frequency of the chosen cell.
    meetings: Vec<Meeting<'a>>,
    /// Lowest and highest natural frequency of each mode over a turn of the motion [Hz], where the matrices change along it.
    #[serde(skip_serializing_if = "Option::is_none")]
    natural_frequencies_over_a_turn: Option<&'a [[f64; 2]]>,
    /// What the analysis leaves out because it is linear.
    left_out: Vec<&'static str>,
    /// The steady motion about which nonlinear forces are linearised.
    #[serde(skip_serializing_if = "Option::is_none")]
    linearised: Option<Linearised<'a>>,
    /// Names of the other files in the same folder.
    files: &'a [String],
    provenance: Provenance,
}

#[derive(Serialize)]
struct CellReport {
    /// Value of each law [SI].
    levels: Vec<f64>,
    /// Whether damping couples the modes of the undamped system.
    coupled_by_damping: bool,
    modes: Vec<ModeReport>,
}

#[derive(Serialize)]
struct ModeReport {
    /// Undamped natural frequency [Hz]; 0 for a rigid motion.
    natural_frequency: f64,
    /// Damped natural frequency [Hz]; 0 if the mode does not oscillate.
    damped_frequency: f64,
    /// Damping factor zeta; `null` for a rigid motion.
    damping_factor: Option<f64>,
    /// Rate at which a disturbance grows [1/s]; left out if no disturbance grows.
    #[serde(skip_serializing_if = "Option::is_none")]
    growth_rate: Option<f64>,
    /// Mode shape: real and imaginary part for each coordinate.
    shape: Vec<[f64; 2]>,
    /// Share of each law in the strain energy; empty for a rigid motion.
    strain_energy: Vec<f64>,
    /// Share of each spring in the strain energy; empty for a rigid motion.
    strain_energy_of_springs: Vec<f64>,
    /// Share of each inertia in the kinetic energy.
    kinetic_energy: Vec<f64>,
}

#[derive(Serialize)]
struct Meeting<'a> {
    /// Name of the law.
    law: &'a str,
    /// Number of the harmonic, from 1.
    harmonic: usize,
    /// Number of the mode in `chosen`, from 0.
    mode: usize,
    /// Frequency of the harmonic over that of the mode.
    ratio: f64,
}

impl Verb for Modes {
    fn run(self) -> Result<(), Failure> {
        let page = self.html.asked()?;
        let scene = self.source.load()?;
        let refused = |refusal| Failure::Refused { scene: scene.name.clone(), refusal };
        let system = scene.entry()?.about_steady_motion(&scene).map_err(refused)?;
        let courses = steady::courses(&scene, &system).map_err(refused)?;
        let parts = modes::Parts::of(&scene, scene.entry()?, &system, &|| {}).map_err(refused)?;
        let chosen = modes::of(&system, &self.levels(&scene, &courses)?, &parts, &|| {}).map_err(refused)?;
        let cells = modes::combinations(&courses);
        let cells = cells.iter().map(|k| modes::of(&system, k, &parts, &|| {})).collect::<Result<Vec<_>, _>>();
        let cells = cells.map_err(refused)?;
        let moving = scene.entry()?.about_steady_motion(&scene).map_err(refused)?;
        let moves = system.steady().is_some_and(Steady::moves);
        let turn = modes::over_a_turn(&scene, moving, &chosen.levels).map_err(refused)?;
        let path = self.source.folder(&scene, "_modes")?;
        let mut folder = OutputFolder::create(path)?;
        let shapes = plot::modes::draw(&scene, &chosen, &parts);
        let mut figures = vec![files::figure(&mut folder, "shapes", shapes, terminal::warn)?];
        if courses.iter().any(SteadyLaw::turns) {
            let campbell = plot::campbell::draw(&scene, &courses, &chosen);
            figures.push(files::figure(&mut folder, "campbell", campbell, terminal::warn)?);
        }
        if let Some(page) = page {
            let figures: Vec<_> = figures.into_iter().flatten().collect();
            page.modes(&mut folder, &scene, moves, &parts, (&chosen, &cells), &figures)?;
        }
        let linearised = Linearised::of(&scene, system.steady());
        let json = self.json(&scene, &courses, &parts, (&chosen, &cells, linearised, turn.as_ref()), folder.files())?;
        folder.write_bytes("modes.json", json.as_bytes())?;
        folder.commit("modes.json")?;
        let width = terminal::width();
        let text = || {
            let mut text = table::render((&scene, moves), &courses, &parts, &chosen, &cells, width);
            text += &turn.as_ref().map_or(String::new(), table::over_a_turn);
            let written = report::files(folder.path(), folder.files(), width);
            let head = report::scene(&scene, width)
                + "\n"
                + &report::left_out(&scene, width)
                + &report::linearised(&scene, system.steady(), width);
            format!("{head}{text}\n{written}")
        };
        self.printing.print(|| Ok::<_, Failure>(json), text)
    }
}

impl Modes {
    /// The value of each law in the chosen cell.
    fn levels(&self, scene: &Scene, courses: &[SteadyLaw]) -> Result<Vec<f64>, Failure> {
        let Some(cell) = &self.cell else { return Ok(scene.mid_stiffnesses()) };
        let wrong = |what: String| Failure::Impossible {
            what,
            help: "give one number per law, in the order of the model, e.g. --cell 0 or --cell 0,1".into(),
        };
        if cell.len() != courses.len() {
            let what = format!("--cell has {} numbers, but the model has {} laws", cell.len(), courses.len());
            return Err(wrong(what));
        }
        let level = |(&level, course): (&usize, &SteadyLaw)| {
            let found = course.levels.get(level).map(|l| l.0);
            found.ok_or_else(|| {
                let last = course.levels.len() - 1;
                wrong(format!("law `{}` has the levels 0 to {last}, but --cell asks for {level}", course.name))
            })
        };
        cell.iter().zip(courses).map(level).collect()
    }

    fn json(
        &self,
        scene: &Scene,
        courses: &[SteadyLaw],
        parts: &Parts,
        (chosen, cells, linearised, turn): (&CellModes, &[CellModes], Option<Linearised<'_>>, Option<&OverATurn>),
        files: &[String],
    ) -> Result<String, Failure> {
        let meeting = |m: &modes::Meeting| Meeting {
            law: courses[m.law].name,
            harmonic: m.harmonic,
            mode: m.mode,
            ratio: m.ratio,
        };
        let report = Report {
            scene: &scene.name,
            model: scene.model.name,
            coordinates: scene.model.coordinates.iter().map(|c| c.name).collect(),
            units: scene.model.coordinates.iter().map(|c| c.unit).collect(),
            laws: scene.stiffnesses().map(|(law, _)| law.name).collect(),
            springs: parts.springs.iter().map(|spring| spring.name).collect(),
            masses: parts.masses.iter().map(|mass| mass.name).collect(),
            chosen: cell(chosen),
            cells: cells.iter().map(cell).collect(),
            mesh_frequencies: courses.iter().map(|c| c.varies.then(|| c.mesh_frequency())).collect(),
            meetings: modes::meetings(courses, chosen).iter().map(meeting).collect(),
            natural_frequencies_over_a_turn: turn.map(|turn| &turn.natural[..]),
            left_out: scene.left_out_if_linear(),
            linearised,
            files,
            provenance: provenance::of(scene, "modes of linear cells".into()),
        };
        Ok(document::json("modes", VERSION, &report)?)
    }
}

fn cell(cell: &CellModes) -> CellReport {
    let mode = |v: &modes::Vibration| ModeReport {
        natural_frequency: v.natural,
        damped_frequency: v.damped,
        damping_factor: v.zeta,
        growth_rate: (v.growth > 0.0).then_some(v.growth),
        shape: v.shape.iter().map(|z| [z.re, z.im]).collect(),
        strain_energy: v.strain.clone(),
        strain_energy_of_springs: v.springs.clone(),
        kinetic_energy: v.kinetic.clone(),
    };
    CellReport {
        levels: cell.levels.clone(),
        coupled_by_damping: cell.coupled,
        modes: cell.modes.iter().map(mode).collect(),
    }
}
