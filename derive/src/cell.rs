//! The equations between two steps of the laws: M q'' + C q' + K q = f with constant M, C, K and f if the cell is linear,
//! otherwise the terms that make it nonlinear.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Kind, number, symbols};
use crate::lagrange::{Motion, Symbols, external};
use crate::markers::{all_present, markers, terms};
use crate::model::Model;
use crate::print::{Style, print};
use crate::tree::Tree;

/// The matrices of a linear cell.
pub(crate) struct Cell {
    pub stiffness: Vec<Vec<Atom>>,
    pub damping: Vec<Vec<Atom>>,
    pub load: Vec<Atom>,
    /// Torques that make the cell nonlinear in scenes with an effect: the effect, and the term as text. The matrices are
    /// without them.
    pub nonlinear_with: Vec<(String, String)>,
}

/// The matrices of a linear cell.
///
/// # Errors
/// The terms that make the cell nonlinear in every scene, as text, each with the energy or torque it comes from.
pub(crate) fn derive(model: &Model, motion: &Motion, s: &Symbols) -> Result<Cell, Vec<String>> {
    let (positions, speeds): (Vec<Symbol>, Vec<Symbol>) = (
        s.q.iter().copied().chain(s.deflections.iter().map(|d| d.symbol)).collect(),
        s.v.iter().copied().chain(s.deflections.iter().map(|d| d.rate_symbol)).collect(),
    );
    let mut culprits: Vec<String> = [
        ("kinetic energy", &motion.kinetic, &speeds),
        ("potential energy", &motion.potential, &positions),
        ("dissipation function", &motion.dissipation, &speeds),
    ]
    .into_iter()
    .flat_map(|(energy, e, by)| not_quadratic(e, by).into_iter().map(move |term| format!("{term} in the {energy}")))
    .collect();
    let mut nonlinear_with = vec![];
    for torque in model.torques.iter().filter(|t| model.varies(t)) {
        let value = model.written_out(&torque.value.atom());
        let value_text = print(&Tree::new(&all_present(&value)), Style::Plain);
        let text = format!("{value_text} in the torque `{}`", torque.name);
        match &markers(&value)[..] {
            [effect] => nonlinear_with.push((effect.clone(), text)),
            _ => culprits.push(text),
        }
    }
    let constant = external(model, s, |torque| !model.varies(torque));
    if !culprits.is_empty() {
        return Err(culprits);
    }
    let n = s.q.len();
    let second = |e: &Atom, by: &dyn Fn(&Atom, usize) -> Atom| -> Vec<Vec<Atom>> {
        let slopes: Vec<Atom> = (0..n).map(|i| by(e, i)).collect();
        slopes.iter().map(|slope| (0..n).map(|j| by(slope, j).expand()).collect()).collect()
    };
    // The value at q = 0.
    let rest = |e: &Atom| {
        let at_rest = s
            .deflections
            .iter()
            .fold(e.clone(), |e, d| e.replace(Atom::var(d.symbol).to_pattern()).with(d.rest.to_pattern()));
        s.q.iter().fold(at_rest, |e, q| e.replace(Atom::var(*q).to_pattern()).with(number(0).to_pattern()))
    };
    let restoring = |i: usize| s.by_coordinate(&motion.potential, i) + s.clipped(&motion.potential, i);
    Ok(Cell {
        stiffness: (0..n).map(|i| (0..n).map(|j| s.by_coordinate(&restoring(i), j).expand()).collect()).collect(),
        damping: second(&motion.dissipation, &|e, i| s.by_speed(e, i)),
        load: (0..n).map(|i| (&constant[i] - rest(&restoring(i))).expand()).collect(),
        nonlinear_with,
    })
}

/// The terms of an energy, as text, that are not quadratic in `by`: their second derivatives depend on the state.
fn not_quadratic(e: &Atom, by: &[Symbol]) -> Vec<String> {
    let moves = |e: &Atom| {
        let moving = [Kind::Coordinate, Kind::Speed, Kind::Deflection, Kind::Rate];
        symbols(e).iter().any(|s| moving.contains(&s.0))
    };
    let varying = |term: &Atom| {
        let slopes = by.iter().map(|a| term.derivative(*a)).filter(|slope| !slope.is_zero());
        slopes.into_iter().any(|slope| by.iter().any(|b| moves(&slope.derivative(*b).expand())))
    };
    let text = |term: &Atom| print(&Tree::new(&all_present(term)), Style::Plain);
    terms(&e.expand()).iter().filter(|term| varying(term)).map(text).collect()
}
