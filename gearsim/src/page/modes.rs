//! The page of `gearsim modes`: shapes by energy, the Campbell diagram, the modes of the chosen cell and the frequencies of all cells.

use super::Page;
use super::html::{Html, TableCell};
use super::shared::{self, Made, figure};
use crate::analysis::modes::masses::bodies;
use crate::analysis::modes::{AT_A_PLACE, CellModes, Parts, Vibration};
use crate::output::OutputError;
use crate::plot::Figure;
use crate::scene::Scene;

/// The modes of a scene.
pub struct Modes<'a> {
    /// Whether coefficients change along the motion, so that these are the modes at one position.
    pub moves: bool,
    /// Its springs and inertias.
    pub parts: &'a Parts,
    /// The cell shown in full.
    pub chosen: &'a CellModes,
    /// All cells; empty if there are too many.
    pub cells: &'a [CellModes],
    /// The figures.
    pub figures: &'a [Figure],
}

/// The page of the modes of a scene. Errors: none.
pub fn page(made: &Made<'_>, modes: &Modes<'_>) -> Result<Page, OutputError> {
    let mut page = shared::begin(made.scene);
    page.section("modes", "Modes", |html| {
        let left_out = made.scene.left_out_if_linear();
        if !left_out.is_empty() {
            html.note(&format!("Left out, because modes are linear: {}.", left_out.join(", ")));
        }
        if modes.moves {
            html.note(AT_A_PLACE);
        }
        frequencies(html, made.scene, modes);
    });
    page.section("plots", "Plots", |html| {
        for (drawn, group) in modes.figures.iter().zip(["first", "second"]) {
            figure::fill(html, group, drawn);
        }
    });
    page.section("energies", "Energies and shapes", |html| energies(html, made.scene, modes));
    page.section("cells", "Cells", |html| cells(html, made.scene, modes.cells));
    shared::end(&mut page, made);
    Ok(page)
}

/// The names of the laws with their units.
fn laws(scene: &Scene) -> Vec<String> {
    scene.stiffnesses().map(|(law, _)| format!("{} [{}]", law.name, law.unit)).collect()
}

fn frequencies(html: &mut Html, scene: &Scene, Modes { moves, chosen: cell, .. }: &Modes<'_>) {
    let levels = laws(scene).into_iter().zip(&cell.levels);
    html.pairs(levels.map(|(law, level)| (law, crate::output::number::short(*level))));
    if cell.coupled {
        html.paragraph("Damping couples the modes of the undamped system: shapes are complex.");
    }
    let row = |(i, mode): (usize, &Vibration)| {
        let numbers = [i as f64, mode.natural, mode.damped, mode.zeta.unwrap_or(f64::NAN)];
        let kind = match (mode.natural > 0.0, mode.damped > 0.0) {
            (false, _) if mode.growth > 0.0 && *moves => "grows at this position",
            (false, _) if mode.growth > 0.0 => "unstable",
            (false, _) => "rigid motion",
            (true, true) => "vibrates",
            (true, false) => "overdamped",
        };
        numbers.into_iter().map(TableCell::Number).chain([TableCell::text(kind)]).collect()
    };
    let rows: Vec<Vec<TableCell>> = cell.modes.iter().enumerate().map(row).collect();
    html.table("Modes of this cell", &["mode", "natural [Hz]", "damped [Hz]", "damping factor", "kind"], &rows);
}

fn energies(html: &mut Html, scene: &Scene, modes: &Modes<'_>) {
    let mut rows = vec![];
    let elastic: Vec<&str> = scene.stiffnesses().map(|(law, _)| law.name).collect();
    let elastic: Vec<&str> = elastic.into_iter().chain(modes.parts.springs.iter().map(|spring| spring.name)).collect();
    for (i, mode) in modes.chosen.modes.iter().enumerate() {
        let masses = &modes.parts.masses;
        let kinetic = bodies(masses).into_iter().map(|body| {
            let share = body.share(&mode.shape, mode.kinetic[body.mass], &masses[body.mass]);
            let name = body.coordinate.map_or(body.name.to_owned(), |own| format!("{}: {own}", body.name));
            (name, "kinetic", share.abs())
        });
        let strain = elastic.iter().zip(mode.strain.iter().chain(&mode.springs));
        for (name, energy, share) in kinetic.chain(strain.map(|(name, share)| ((*name).to_owned(), "strain", *share))) {
            let names = [TableCell::Number(i as f64), TableCell::text(name), TableCell::text(energy)];
            rows.push(names.into_iter().chain([TableCell::Number(100.0 * share)]).collect());
        }
    }
    html.table("Shares of the energies", &["mode", "inertia, mesh or spring", "energy", "share [%]"], &rows);
    let mut rows = vec![];
    for (i, mode) in modes.chosen.modes.iter().enumerate() {
        for (coordinate, shape) in scene.model.coordinates.iter().zip(&mode.shape) {
            let names =
                [TableCell::Number(i as f64), TableCell::text(coordinate.name), TableCell::text(coordinate.unit)];
            rows.push(names.into_iter().chain([shape.re, shape.im].map(TableCell::Number)).collect());
        }
    }
    html.table("Shapes", &["mode", "coordinate", "unit", "real", "imaginary"], &rows);
}

fn cells(html: &mut Html, scene: &Scene, cells: &[CellModes]) {
    let Some(first) = cells.first() else { return };
    let head = laws(scene).into_iter().chain((0..first.modes.len()).map(|i| format!("mode {i} [Hz]")));
    let head: Vec<String> = head.collect();
    let row = |cell: &CellModes| {
        let numbers = cell.levels.iter().copied().chain(cell.modes.iter().map(|mode| mode.natural));
        numbers.map(TableCell::Number).collect()
    };
    let rows: Vec<Vec<TableCell>> = cells.iter().map(row).collect();
    html.table("Natural frequencies of every cell", &head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
}
