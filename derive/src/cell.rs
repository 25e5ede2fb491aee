//! The equations between two steps of the laws: M q'' + C q' + K q = f with constant M, C, K and f if the cell is linear, and the terms
//! that make it nonlinear.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Expr, Kind, kind_and_name, number, set, symbol, symbols, total};
use crate::lagrange::{EquationsOfMotion, external};
use crate::markers::{all_present, markers, optional, terms, without};
use crate::model::{Model, Switch};
use crate::print::{Style, print};
use crate::symbols::{Partials, Symbols, Variable, expanded};
use crate::tree::Tree;

/// The matrices of the linear terms of a cell. Their entries are given in coordinates and deflections: an entry k of the deflections d and
/// e stands for the matrix k g_d g_eᵀ, where g_d and g_e are the gradients of the deflections.
pub(crate) struct Cell {
    /// The nonzero entries of K. K is symmetric: only one of two mirrored entries is given.
    pub stiffness: Vec<(Variable, Variable, Atom)>,
    /// The nonzero entries of C, given in the same way.
    pub damping: Vec<(Variable, Variable, Atom)>,
    /// The nonzero entries of f: forces along coordinates and deflections.
    pub load: Partials,
    /// The terms that make the cell nonlinear in every scene, as text, each with the energy or torque it comes from. The matrices do not
    /// contain them.
    pub nonlinear: Vec<String>,
    /// Terms that make the cell nonlinear in scenes with some effects: these effects, and the term as text. The matrices do not contain the
    /// terms.
    pub nonlinear_with: Vec<(Vec<String>, String)>,
}

/// Derives the matrices of a cell, and the terms that make it nonlinear.
pub(crate) fn derive(model: &Model, s: &Symbols, motion: &EquationsOfMotion) -> Cell {
    let mut culprits = inertias(model, s, motion);
    for (energy, pieces) in [("potential energy", &model.potential), ("dissipation function", &model.dissipation)] {
        culprits
            .extend(not_quadratic(pieces).into_iter().map(|(marks, term)| (marks, format!("{term} in the {energy}"))));
    }
    for torque in model.torques.iter().filter(|t| model.varies(t)) {
        // Effects without which the torque changes but does not vanish do not count.
        let unchanged = |e: Atom| optional(&e).iter().fold(e, |e, effect| without(&e, effect));
        let value = torque.value.atom();
        let marks = markers(&unchanged(model.written_out(&value)));
        let value_text = print(&Tree::new(&all_present(&unchanged(value))), Style::Plain);
        let how = if torque.is_linear() { "" } else { ", whose displacement is not linear" };
        culprits.push((marks, format!("{value_text} in the torque `{}`{how}", torque.name)));
    }
    let bends = Bends::of(model, s);
    culprits.extend(bends.culprits.iter().cloned());
    let (always, nonlinear_with): (Vec<_>, Vec<_>) = culprits.into_iter().partition(|(marks, _)| marks.is_empty());
    let nonlinear = always.into_iter().map(|(_, text)| text).collect();
    let constant = external(model, s, |torque| !model.varies(torque));
    let linear = |pieces: &[Expr]| -> Vec<Expr> {
        let of_one = |piece: &Expr| not_quadratic(std::slice::from_ref(piece)).is_empty();
        pieces.iter().copied().filter(of_one).collect()
    };
    let (potential, dissipation) = (linear(&model.potential), linear(&model.dissipation));
    let straight = |(place, e): (Variable, Atom)| (place, bends.straight(&e));
    let restoring = potential.iter().flat_map(|v| s.by_positions(&v.atom())).chain(lost(model, s));
    let restoring: Partials = expanded(restoring.map(straight));
    let stiffness = second(&restoring, |force| s.by_positions(force));
    let damping = expanded(dissipation.iter().flat_map(|d| s.by_motions(&d.atom())).map(straight));
    let damping = second(&damping, |force| s.by_motions(force));
    let constant = constant.into_iter().enumerate().map(|(i, force)| (Variable::Coordinate(i), force));
    let at_rest = restoring.iter().map(|(place, force)| (*place, -at_rest(s, force)));
    let load = expanded(constant.chain(at_rest).map(straight));
    Cell { stiffness, damping, load, nonlinear, nonlinear_with }
}

/// The nonzero derivatives of `forces`. They form a symmetric matrix: only one of two mirrored entries is returned.
fn second(forces: &[(Variable, Atom)], by: impl Fn(&Atom) -> Partials) -> Vec<(Variable, Variable, Atom)> {
    let row = |(place, force): &(Variable, Atom)| {
        let place = *place;
        let entries = expanded(by(force).into_iter()).into_iter().filter(move |(other, _)| *other >= place);
        entries.map(move |(other, entry)| (place, other, entry)).collect::<Vec<_>>()
    };
    forces.iter().flat_map(row).collect()
}

/// The dissipative forces of switches, each along its deflection.
fn lost(model: &Model, s: &Symbols) -> Partials {
    let lossy = model.switches.iter().filter(|switch| !switch.loss.atom().is_zero());
    let along = |switch: &Switch| {
        let over = symbol(Kind::Deflection, &switch.over);
        s.deflections.iter().position(|d| d.symbol == over).map(Variable::Deflection)
    };
    lossy.filter_map(|switch| Some((along(switch)?, switch.lost()))).collect()
}

/// The functions of positions in deflections. With such a function a deflection bends: it is not linear in the coordinates.
struct Bends {
    /// The functions with their derivatives, and the markers of their effects. If all are set to zero, every deflection is linear.
    zero: Vec<Symbol>,
    /// The deflections that bend, as text, each with the effects that it needs. They make cells nonlinear.
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

    /// The expression with all deflections linear: without the functions by which they bend.
    fn straight(&self, e: &Atom) -> Atom {
        self.zero.iter().fold(e.clone(), |e, s| set(&e, *s, &number(0))).expand()
    }
}

/// The inertias that depend on the coordinates, as text, each with the effects that it needs.
fn inertias(model: &Model, s: &Symbols, motion: &EquationsOfMotion) -> Vec<(Vec<String>, String)> {
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
            Variable::Coordinate(_) => number(0),
            Variable::Deflection(d) => s.deflections[d].rest.clone(),
            _ => return e,
        };
        set(&e, symbol, &rest)
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
