//! The equations between two steps of the laws: M q'' + C q' + K q = f with constant M, C, K and f if the cell is linear,
//! otherwise the terms that make it nonlinear.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Expr, Kind, kind_and_name, number, total};
use crate::lagrange::{self, external, hessian, rows};
use crate::markers::{all_present, markers, terms};
use crate::model::Model;
use crate::print::{Style, print};
use crate::symbols::{Place, Symbols};
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
pub(crate) fn derive(model: &Model, s: &Symbols) -> Result<Cell, Vec<String>> {
    let mut culprits: Vec<String> = [
        ("kinetic energy", &model.kinetic),
        ("potential energy", &model.potential),
        ("dissipation function", &model.dissipation),
    ]
    .into_iter()
    .flat_map(|(energy, pieces)| not_quadratic(pieces).into_iter().map(move |term| format!("{term} in the {energy}")))
    .collect();
    let mut nonlinear_with = vec![];
    for torque in model.torques.iter().filter(|t| model.varies(t)) {
        let value = model.written_out(&torque.value.atom());
        let value_text = print(&Tree::new(&all_present(&torque.value.atom())), Style::Plain);
        let text = format!("{value_text} in the torque `{}`", torque.name);
        match &markers(&value)[..] {
            [effect] => nonlinear_with.push((effect.clone(), text)),
            _ => culprits.push(text),
        }
    }
    if !culprits.is_empty() {
        return Err(culprits);
    }
    let n = s.q.len();
    let constant = external(model, s, |torque| !model.varies(torque));
    let restoring = rows(n, lagrange::restoring(model, s, |v| s.by_coordinates(v)));
    let stiffness = restoring.iter().map(|row| rows(n, s.by_coordinates(row).into_iter())).collect();
    let load = constant.iter().zip(&restoring).map(|(constant, row)| (constant - at_rest(s, row)).expand()).collect();
    Ok(Cell { stiffness, damping: hessian(n, &model.dissipation, |d| s.by_speeds(d)), load, nonlinear_with })
}

/// The value at q = 0.
fn at_rest(s: &Symbols, e: &Atom) -> Atom {
    s.present(e).into_iter().fold(e.clone(), |e, (symbol, place)| {
        let rest = match place {
            Place::Coordinate(_) => number(0),
            Place::Deflection(d) => s.deflections[d].rest.clone(),
            _ => return e,
        };
        e.replace(Atom::var(symbol).to_pattern()).with(rest.to_pattern())
    })
}

/// The terms of an energy, as text, that are not quadratic in positions and speeds: their second derivatives depend on the state.
fn not_quadratic(pieces: &[Expr]) -> Vec<String> {
    let moving = |e: &Atom| -> Vec<Symbol> {
        let moves = |symbol: &Symbol| {
            matches!(kind_and_name(*symbol).0, Kind::Coordinate | Kind::Speed | Kind::Deflection | Kind::Rate)
        };
        e.get_all_symbols(false).into_iter().filter(moves).collect()
    };
    let varying = |term: &Atom| {
        moving(term).into_iter().any(|a| {
            let slope = term.derivative(a);
            moving(&slope).into_iter().any(|b| !moving(&slope.derivative(b).expand()).is_empty())
        })
    };
    let text = |term: &Atom| print(&Tree::new(&all_present(term)), Style::Plain);
    let terms = terms(&total(pieces.iter().map(|piece| piece.atom().expand()).collect()));
    terms.iter().filter(|term| varying(term)).map(text).collect()
}
