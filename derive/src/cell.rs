//! Is a cell linear? Between two steps, M q'' + C q' + K q = f with constant matrices, or the term that breaks it.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Kind, number, symbols};
use crate::lagrange::{Motion, Symbols};
use crate::markers::{all_present, terms};
use crate::print::{Style, print};
use crate::tree::Tree;

/// The matrices of a linear cell.
pub(crate) struct Cell {
    pub stiffness: Vec<Vec<Atom>>,
    pub damping: Vec<Vec<Atom>>,
    pub load: Vec<Atom>,
}

/// The cell matrices, or the terms (as text, with the energy they come from) that make the cell nonlinear.
pub(crate) fn derive(motion: &Motion, s: &Symbols) -> Result<Cell, Vec<String>> {
    let (positions, speeds): (Vec<Symbol>, Vec<Symbol>) = (
        s.q.iter().copied().chain(s.deflections.iter().map(|d| d.symbol)).collect(),
        s.v.iter().copied().chain(s.deflections.iter().map(|d| d.rate)).collect(),
    );
    let culprits: Vec<String> = [
        ("kinetic energy", &motion.kinetic, &speeds),
        ("potential energy", &motion.potential, &positions),
        ("dissipation function", &motion.dissipation, &speeds),
    ]
    .into_iter()
    .flat_map(|(energy, e, by)| curved(e, by).into_iter().map(move |term| format!("{term} in the {energy}")))
    .collect();
    if !culprits.is_empty() {
        return Err(culprits);
    }
    let n = s.q.len();
    let second = |e: &Atom, by: &dyn Fn(&Atom, usize) -> Atom| -> Vec<Vec<Atom>> {
        let slopes: Vec<Atom> = (0..n).map(|i| by(e, i)).collect();
        slopes.iter().map(|slope| (0..n).map(|j| by(slope, j).expand()).collect()).collect()
    };
    let rest = |e: &Atom| {
        positions.iter().fold(e.clone(), |e, q| e.replace(Atom::var(*q).to_pattern()).with(number(0).to_pattern()))
    };
    Ok(Cell {
        stiffness: second(&motion.potential, &|e, i| s.by_coordinate(e, i)),
        damping: second(&motion.dissipation, &|e, i| s.by_speed(e, i)),
        load: (0..n).map(|i| (&motion.external[i] - rest(&s.by_coordinate(&motion.potential, i))).expand()).collect(),
    })
}

/// The terms of an energy, as text, whose second derivatives by what moves still move.
fn curved(e: &Atom, by: &[Symbol]) -> Vec<String> {
    let moves = |e: &Atom| {
        let moving = [Kind::Coordinate, Kind::Speed, Kind::Deflection, Kind::Rate];
        symbols(e).iter().any(|s| moving.contains(&s.0))
    };
    let bends = |term: &Atom| {
        let slopes = by.iter().map(|a| term.derivative(*a)).filter(|slope| !slope.is_zero());
        slopes.into_iter().any(|slope| by.iter().any(|b| moves(&slope.derivative(*b).expand())))
    };
    let text = |term: &Atom| print(&Tree::new(&all_present(term)), Style::Plain);
    terms(&e.expand()).iter().filter(|term| bends(term)).map(text).collect()
}
