//! Is a cell linear? Between two steps, M q'' + C q' + K q = f with constant matrices, or the term that breaks it.

use symbolica::atom::{Atom, AtomCore};

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
    let n = s.q.len();
    let moves = |e: &Atom| symbols(e).iter().any(|k| matches!(k.0, Kind::Coordinate | Kind::Speed));
    let mut culprits = vec![];
    let mut blame = |energy: &str, e: &Atom, curved: &dyn Fn(&Atom) -> bool| {
        for term in terms(&e.expand()) {
            if curved(&term) {
                culprits.push(format!("{} in the {energy}", print(&Tree::new(&all_present(&term)), Style::Plain)));
            }
        }
    };
    let second = |e: &Atom, by: &[symbolica::atom::Symbol]| -> Vec<Vec<Atom>> {
        (0..n).map(|i| (0..n).map(|j| e.derivative(by[i]).derivative(by[j]).expand()).collect()).collect()
    };
    let curved_by = |by: &[symbolica::atom::Symbol]| {
        let by = by.to_vec();
        move |term: &Atom| by.iter().any(|a| by.iter().any(|b| moves(&term.derivative(*a).derivative(*b).expand())))
    };
    blame("kinetic energy", &motion.kinetic, &curved_by(&s.v));
    blame("potential energy", &motion.potential, &curved_by(&s.q));
    blame("dissipation function", &motion.dissipation, &curved_by(&s.v));
    if !culprits.is_empty() {
        return Err(culprits);
    }
    let rest = |e: &Atom| {
        s.q.iter().fold(e.clone(), |e, q| e.replace(Atom::var(*q).to_pattern()).with(number(0).to_pattern()))
    };
    Ok(Cell {
        stiffness: second(&motion.potential, &s.q),
        damping: second(&motion.dissipation, &s.v),
        load: (0..n).map(|i| (&motion.external[i] - rest(&motion.potential.derivative(s.q[i]))).expand()).collect(),
    })
}
