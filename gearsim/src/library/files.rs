//! The files of a run.

use std::collections::BTreeMap;

use indexmap::IndexMap;

use crate::analysis::{dynamic_factor, from_teeth, rainflow};
use crate::output::summary::{
    Counts, Digits, Energy, FORMAT, LawFromTeeth, LoadSpectrum, Mesh, Method, Named, Number, Observed, Rows, Summary,
    VERSION,
};
use crate::output::{OutputError, OutputFolder, Table, csv, parquet, remarks};
use crate::plot::{self, Figure, PlotError, Run};
use crate::run::Outcome;
use crate::scene::Scene;
use crate::trajectory::Trajectory;

use super::provenance;

/// Rows converted to CSV at a time.
const ROWS: usize = 1 << 16;

/// Writes the trajectory as `<name>.parquet`, and also as `<name>.csv` if `as_csv`.
pub(crate) fn trajectory(
    folder: &mut OutputFolder,
    name: &str,
    as_csv: bool,
    scene: &Scene,
    outcome: &Outcome,
) -> Result<(), OutputError> {
    let provenance = provenance::pairs(scene, outcome);
    let pairs = || provenance.iter().map(|(name, value)| (*name, value.as_str()));
    folder.write(&format!("{name}.parquet"), |sink| parquet::write_trajectory(&outcome.trajectory, pairs(), sink))?;
    if as_csv {
        folder.write(&format!("{name}.csv"), |sink| csv::write_parts(Table::parts(&outcome.trajectory, ROWS), sink))?;
    }
    Ok(())
}

/// Writes the plots `names` of `runs` as SVG and PNG. A plot that cannot be drawn does not end the command: the return value has a remark
/// for each.
pub(crate) fn plots(folder: &mut OutputFolder, names: &[String], runs: &[Run<'_>]) -> Result<Vec<String>, OutputError> {
    let mut remarks = vec![];
    for name in names {
        match draw(name, runs) {
            Ok((svg, png)) => {
                folder.write_bytes(&format!("{name}.svg"), svg.as_bytes())?;
                folder.write_bytes(&format!("{name}.png"), &png)?;
            }
            Err(error) => remarks.push(format!("no plot `{name}`: {error}")),
        }
    }
    Ok(remarks)
}

/// Writes a figure as SVG and PNG, and returns it. If it cannot be drawn, it only calls `warn`.
pub(crate) fn figure(
    folder: &mut OutputFolder,
    name: &str,
    figure: Result<Figure, PlotError>,
    warn: fn(&str),
) -> Result<Option<Figure>, OutputError> {
    match figure.and_then(|figure| Ok((figure.svg()?, figure.png()?, figure))) {
        Ok((svg, png, figure)) => {
            folder.write_bytes(&format!("{name}.svg"), svg.as_bytes())?;
            folder.write_bytes(&format!("{name}.png"), &png)?;
            Ok(Some(figure))
        }
        Err(error) => {
            warn(&format!("no plot `{name}`: {error}"));
            Ok(None)
        }
    }
}

fn draw(name: &str, runs: &[Run<'_>]) -> Result<(String, Vec<u8>), PlotError> {
    let figure = (plot::find(name)?.draw)(runs)?;
    Ok((figure.svg()?, figure.png()?))
}

/// The share of time in each mode of a switch; empty for a run without time.
fn shares(times: &[(&str, f64)]) -> Named {
    let whole: f64 = times.iter().map(|(_, time)| time).sum();
    times.iter().filter(|_| whole > 0.0).map(|(mode, time)| (*mode, time / whole)).collect()
}

/// The load spectra of the signals that the scene names.
fn load_spectra(scene: &Scene, run: &Trajectory) -> IndexMap<String, LoadSpectrum> {
    let spectrum = |name: &&'static str| {
        let (unit, column) = run.signal(name)?;
        let cycles = rainflow::count(&column[run.row_from(scene.output.from)..]);
        let largest_range = Number(cycles.iter().map(|cycle| cycle.range).fold(0.0, f64::max));
        let cycles = Number(cycles.iter().map(|cycle| cycle.count).sum());
        Some(((*name).to_owned(), LoadSpectrum { unit: unit.into(), cycles, largest_range }))
    };
    scene.output.rainflow.iter().filter_map(spectrum).collect()
}

/// The summary of a run that wrote `files`.
pub(crate) fn summary(scene: &Scene, outcome: &Outcome, files: Vec<String>) -> Summary {
    let run = &outcome.trajectory;
    let meshes =
        crate::known::of(scene).map_or(vec![], |entry| dynamic_factor::of(scene, entry, run, scene.output.from));
    let meshes: Vec<_> = meshes.iter().map(|mesh| (mesh.law.name, Mesh::of(mesh))).collect();
    let mut summary = Summary {
        outputs: Observed::all(run, scene.output.from),
        meshes: meshes.iter().map(|(name, (mesh, _))| ((*name).to_owned(), mesh.clone())).collect(),
        load_spectra: load_spectra(scene, run),
        files,
        ..brief(scene, outcome)
    };
    summary.note_missing();
    for (name, (_, reasons)) in meshes {
        let paths = reasons.into_iter().map(|(what, why)| (format!("meshes.{name}.{what}"), why));
        summary.missing.extend(paths);
    }
    summary
}

/// The summary of a run without statistics of outputs, dynamic factors and load spectra. Computing these from the rows takes as long as a
/// short run.
pub(crate) fn brief(scene: &Scene, outcome: &Outcome) -> Summary {
    let (run, counts) = (&outcome.trajectory, &outcome.counts);
    let none = Number(f64::NAN);
    let no_energy = Energy {
        kinetic: none,
        strain: none,
        work: none,
        dissipated: none,
        residual: none,
        at_start: none,
        largest: none,
    };
    let parameters = scene.model.parameters.iter().map(|p| p.name).zip(scene.parameters.iter().copied());
    Summary {
        format: FORMAT.into(),
        version: VERSION,
        scene: scene.name.clone(),
        model: scene.model.name.into(),
        effects: scene.effects.names(scene.model).into_iter().map(Into::into).collect(),
        t_end: Number(run.t.last().copied().unwrap_or(0.0)),
        state: Named::state(run),
        cell_changes: counts.cell_changes,
        reflections: counts.reflections,
        energy: Energy::at_end(run).unwrap_or(no_energy),
        outputs: IndexMap::new(),
        rows: Rows::of(run),
        meshes: IndexMap::new(),
        laws_from_teeth: from_teeth::of(scene).iter().map(|law| (law.law.name.into(), LawFromTeeth::of(law))).collect(),
        load_spectra: IndexMap::new(),
        sounds: IndexMap::new(),
        modes: outcome.modes.iter().map(|(switch, times)| (switch.to_string(), shares(times))).collect(),
        impacts: outcome.impacts.iter().map(|(kind, impacts)| ((*kind).to_owned(), *impacts)).collect(),
        method: Method {
            name: outcome.solver.method.into(),
            why: outcome.solver.why.clone(),
            steps: outcome.solver.steps,
            rejected: outcome.solver.rejected,
        },
        counts: Counts {
            function_evaluations: counts.cost.evaluations,
            root_steps: counts.cost.steps,
            grazes: counts.cost.grazes,
            holds: counts.holds,
            impacts: counts.impacts,
            sticks: counts.sticks,
            ignored: Number(outcome.ignored),
            ambiguous: counts.ambiguous,
        },
        digits: outcome
            .digits
            .map(|digits| Digits { at_end: Number(digits.at_end), none_from: digits.none_from.map(Number) }),
        remarks: (scene.conversions.iter().chain(&scene.warnings).chain(&outcome.remarks).cloned())
            .chain(remarks::of_precision(scene))
            .chain(remarks::of(scene, run, scene.output.from))
            .collect(),
        cpu_seconds: Number(outcome.cpu_seconds),
        completed: outcome.stopped_by.is_none(),
        stopped_by: outcome.stopped_by.as_ref().map(|stop| stop.to_string()),
        refuted: outcome.refuted.map(|account| account.to_string()),
        parameters: parameters.collect(),
        missing: BTreeMap::new(),
        files: vec![],
        provenance: provenance::of(scene, provenance::solver(scene, outcome)),
    }
}
