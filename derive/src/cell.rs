//! The equations between two steps of the laws: M q'' + C q' + K q = f with constant M, C, K and f if the cell is linear, and the terms
//! that make it nonlinear.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Expr, Kind, kind_and_name, number, symbol, symbols, total};
use crate::lagrange::{self, Motion, external, hessian, rows};
use crate::markers::{all_present, markers, optional, terms, without};
use crate::model::Model;
use crate::print::{Style, print};
use crate::symbols::{Place, Symbols};
use crate::tree::Tree;

/// The matrices of a cell, of its terms that are linear.
pub(crate) struct Cell {
    pub stiffness: Vec<Vec<Atom>>,
    pub damping: Vec<Vec<Atom>>,
    pub load: Vec<Atom>,
    /// The terms that make the cell nonlinear in every scene, as text, each with the energy or torque it comes from. The matrices are
    /// without them.
    pub nonlinear: Vec<String>,
    /// Terms that make the cell nonlinear in scenes with an effect: the effect, and the term as text. The matrices are without them.
    pub nonlinear_with: Vec<(String, String)>,
}

/// The matrices of a cell.
pub(crate) fn derive(model: &Model, s: &Symbols, motion: &Motion) -> Cell {
    let mut culprits = inertias(model, s, motion);
    for (energy, pieces) in [("potential energy", &model.potential), ("dissipation function", &model.dissipation)] {
        culprits
            .extend(not_quadratic(pieces).into_iter().map(|(marks, term)| (marks, format!("{term} in the {energy}"))));
    }
    for torque in model.torques.iter().filter(|t| model.varies(t)) {
        // Effects that only change the torque do not count.
        let unchanged = |e: Atom| optional(&e).iter().fold(e, |e, effect| without(&e, effect));
        let value = torque.value.atom();
        let marks = markers(&unchanged(model.written_out(&value)));
        let value_text = print(&Tree::new(&all_present(&unchanged(value))), Style::Plain);
        let how = if torque.is_linear() { "" } else { ", whose displacement is not linear" };
        culprits.push((marks, format!("{value_text} in the torque `{}`{how}", torque.name)));
    }
    let bends = Bends::of(model, s);
    culprits.extend(bends.culprits.iter().cloned());
    let (mut nonlinear, mut nonlinear_with) = (vec![], vec![]);
    for (marks, text) in culprits {
        match &marks[..] {
            [effect] => nonlinear_with.push((effect.clone(), text)),
            _ => nonlinear.push(text),
        }
    }
    let n = s.q.len();
    let constant = external(model, s, |torque| !model.varies(torque));
    let linear = |pieces: &[Expr]| -> Vec<Expr> {
        let of_one = |piece: &Expr| not_quadratic(std::slice::from_ref(piece)).is_empty();
        pieces.iter().copied().filter(of_one).collect()
    };
    let (potential, dissipation) = (linear(&model.potential), linear(&model.dissipation));
    let restoring = rows(n, lagrange::restoring(model, s, &potential, |v| s.by_coordinates(v)));
    let restoring: Vec<Atom> = restoring.iter().map(|row| bends.straight(row)).collect();
    let second = |row: &Atom| rows(n, s.by_coordinates(row).into_iter()).iter().map(|k| bends.straight(k)).collect();
    let stiffness = restoring.iter().map(second).collect();
    let damping = hessian(n, &dissipation, |d| s.by_speeds(d));
    let damping = damping.iter().map(|row| row.iter().map(|c| bends.straight(c)).collect()).collect();
    let load = constant
        .iter()
        .zip(&restoring)
        .map(|(constant, row)| (constant - bends.straight(&at_rest(s, row))).expand())
        .collect();
    Cell { stiffness, damping, load, nonlinear, nonlinear_with }
}

/// The functions of positions by which deflections bend.
struct Bends {
    /// The functions and the effects without which they are zero.
    zero: Vec<Symbol>,
    /// What makes cells nonlinear, with the effects that it needs.
    culprits: Vec<(Vec<String>, String)>,
}

impl Bends {
    fn of(model: &Model, s: &Symbols) -> Self {
        let (mut zero, mut culprits) = (vec![], vec![]);
        for (deflection, _) in model.deflections.iter().zip(&s.deflections).filter(|(_, linear)| linear.bends) {
            let named = symbols(&deflection.value.atom());
            let functions = model.functions.iter().filter(|f| named.contains(&(Kind::Function, f.name.clone())));
            for function in functions {
                zero.extend(function.derivatives().iter().map(|d| symbol(Kind::Function, &d.name)));
                zero.extend(function.with.iter().map(|effect| symbol(Kind::Marker, effect)));
                let culprit =
                    (function.with.iter().cloned().collect(), format!("the deflection {} bends", deflection.name));
                if !culprits.contains(&culprit) {
                    culprits.push(culprit);
                }
            }
        }
        Bends { zero, culprits }
    }

    /// The expression with straight deflections.
    fn straight(&self, e: &Atom) -> Atom {
        let straight =
            self.zero.iter().fold(e.clone(), |e, s| e.replace(Atom::var(*s).to_pattern()).with(number(0).to_pattern()));
        straight.expand()
    }
}

/// The inertias that depend on the coordinates, as text, each with the effects that it needs.
fn inertias(model: &Model, s: &Symbols, motion: &Motion) -> Vec<(Vec<String>, String)> {
    let mut found: Vec<(Vec<String>, String)> = vec![];
    for term in motion.inertia.iter().flatten().flatten().flat_map(terms) {
        let coordinates = model.coordinates.iter().map(|c| c.name.as_str());
        let moving: Vec<&str> = coordinates.filter(|name| depends(s, &motion.mass, name)).collect();
        let (marks, text) = (markers(&term), format!("M({}) in the kinetic energy", moving.join(", ")));
        if !found.iter().any(|(known, _)| *known == marks) {
            found.push((marks, text));
        }
    }
    // The order of terms depends on earlier derivations in this process; the order of the effects does not.
    let declared = |name: &String| model.effects.iter().position(|effect| effect.name == *name);
    found.sort_by_key(|(marks, _)| marks.iter().map(declared).collect::<Vec<_>>());
    found
}

/// Whether M depends on a coordinate.
fn depends(s: &Symbols, mass: &[Vec<Atom>], coordinate: &str) -> bool {
    let q = symbol(Kind::Coordinate, coordinate);
    let by = mass.iter().flatten().flat_map(|entry| s.by_coordinates(entry));
    by.into_iter().any(|(i, by)| s.q[i] == q && !by.expand().is_zero())
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

/// The terms of an energy that are not quadratic in positions and speeds, as text, each with the effects that it needs: their second
/// derivatives depend on the state.
fn not_quadratic(pieces: &[Expr]) -> Vec<(Vec<String>, String)> {
    let moving = |e: &Atom| -> Vec<Symbol> {
        let moves = |symbol: &Symbol| {
            matches!(
                kind_and_name(*symbol).0,
                Kind::Coordinate | Kind::Speed | Kind::Deflection | Kind::Rate | Kind::Function
            )
        };
        e.get_all_symbols(false).into_iter().filter(moves).collect()
    };
    let varying = |term: &Atom| {
        if moving(term).iter().any(|symbol| kind_and_name(*symbol).0 == Kind::Function) {
            return true;
        }
        moving(term).into_iter().any(|a| {
            let slope = term.derivative(a);
            moving(&slope).into_iter().any(|b| !moving(&slope.derivative(b).expand()).is_empty())
        })
    };
    let text = |term: &Atom| (markers(term), print(&Tree::new(&all_present(term)), Style::Plain));
    let terms = terms(&total(pieces.iter().map(|piece| piece.atom().expand()).collect()));
    terms.iter().filter(|term| varying(term)).map(text).collect()
}
