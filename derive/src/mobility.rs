//! The inverse mass matrix of small models, which may depend on the coordinates, and the constants that a model defines by its entries.

use symbolica::atom::{Atom, AtomCore, AtomView};

use crate::expr::{Kind, number, set, symbol, symbols};
use crate::lagrange::{EquationsOfMotion, mobility_symbol};
use crate::markers::{all_present, terms};
use crate::model::Model;
use crate::refute::is_somewhere_nonzero;
use crate::slip::Slip;
use crate::tree::Tree;
use crate::trigonometry::{simplified, without_squared_cosines};

/// Largest number of coordinates for which M is inverted symbolically.
const LARGEST: usize = 2;
/// Largest number of coordinates for which the determinant of M is expanded.
pub(crate) const LARGEST_DETERMINANT: usize = 4;

/// Inverts M if it is small and the same in every scene, and evaluates the constants of the model.
///
/// If a constant is a multiple of one entry W_ij of the inverse, as in `m.constant("M2", 2 * m.inverse_mass(phi, phi))`, that
/// entry and all equal ones are written in this constant in the equations.
pub(crate) fn name(model: &Model, motion: &mut EquationsOfMotion) -> Result<(), Slip> {
    let n = model.coordinates.len();
    // If an effect adds inertia, M contains its marker and differs between sets of effects: the engine inverts it numerically.
    let of_effect = motion.mass.iter().flatten().any(|m| symbols(m).iter().any(|s| s.0 == Kind::Marker));
    if n <= LARGEST_DETERMINANT {
        refuse_singular(model, &motion.mass)?;
    }
    let exact = if n <= LARGEST && !of_effect { Some(inverse(&motion.mass)) } else { None };
    // A constant must not depend on the coordinates, so it may contain entries of M⁻¹ only if M is constant.
    let constant = motion.inertia.is_none();
    let mut named = exact.clone();
    for (name, value) in &model.constants {
        let mut value = value.atom();
        if let (Some(exact), Some(named), true) = (&exact, &mut named, constant) {
            for i in 0..n {
                for j in i..n {
                    let w = mobility_symbol(i, j);
                    let ratio = (&value / Atom::var(w)).expand();
                    if symbols(&ratio).is_empty() && !value.is_zero() {
                        let entry = Atom::var(symbol(Kind::Constant, name)) / ratio;
                        substitute(exact, named, (i, j), &entry);
                    }
                    value = set(&value, w, &exact[i][j]);
                }
            }
        }
        if symbols(&value).iter().any(|s| s.0 == Kind::Mobility) {
            return Err(Slip::InverseMass { model: model.name.clone() });
        }
        motion.constants.push((name.clone(), value.expand()));
    }
    motion.mobility = named;
    Ok(())
}

/// Replaces W_ij and every entry equal to it by `entry`.
fn substitute(exact: &[Vec<Atom>], named: &mut [Vec<Atom>], (i, j): (usize, usize), entry: &Atom) {
    for k in 0..exact.len() {
        for l in 0..exact.len() {
            if exact[k][l] == exact[i][j] || is_zero(&(&exact[k][l] - &exact[i][j])) {
                named[k][l] = entry.clone();
            }
        }
    }
}

/// Refuses an M whose determinant is zero with every effect present: some combination of coordinates has no inertia.
fn refuse_singular(model: &Model, mass: &[Vec<Atom>]) -> Result<(), Slip> {
    let m: Vec<Vec<Atom>> = mass.iter().map(|row| row.iter().map(all_present).collect()).collect();
    if !is_zero(&determinant(&m)) {
        return Ok(());
    }
    let coordinates: Vec<&str> = model.coordinates.iter().map(|c| c.name.as_str()).collect();
    Err(Slip::Singular { model: model.name.clone(), coordinates: coordinates.join(", ") })
}

/// The inverse of a regular matrix with one or two rows.
fn inverse(m: &[Vec<Atom>]) -> Vec<Vec<Atom>> {
    let determinant = simplified(&determinant(m));
    let entry = |cofactor: Atom| match terms(&determinant).len() {
        1 => (cofactor / &determinant).expand(),
        _ => cofactor / &determinant,
    };
    match m.len() {
        1 => vec![vec![entry(number(1))]],
        _ => vec![vec![entry(m[1][1].clone()), entry(-&m[0][1])], vec![entry(-&m[1][0]), entry(m[0][0].clone())]],
    }
}

/// The determinant of a small matrix, expanded along the first row.
pub(crate) fn determinant(m: &[Vec<Atom>]) -> Atom {
    if m.len() == 1 {
        return m[0][0].clone();
    }
    let mut sum = number(0);
    for j in (0..m.len()).filter(|&j| !m[0][j].is_zero()) {
        let minor: Vec<Vec<Atom>> = m[1..]
            .iter()
            .map(|row| row.iter().enumerate().filter(|(c, _)| *c != j).map(|(_, a)| a.clone()).collect())
            .collect();
        let sign = if j % 2 == 0 { 1 } else { -1 };
        sum += number(sign) * &m[0][j] * determinant(&minor);
    }
    sum.expand()
}

/// Whether an expression is identically zero, decided for rational functions of symbols, of roots of rational functions, and of sines
/// and cosines.
pub(crate) fn is_zero(e: &Atom) -> bool {
    if is_somewhere_nonzero(e) {
        return false;
    }
    e.expand().is_zero() || e.together().expand().is_zero() || {
        let e = without_squared_cosines(roots_of_fractions(e.as_view()).as_view());
        let numerator = e.together().expand();
        numerator.is_zero() || without_squared_cosines(numerator.as_view()).expand().is_zero()
    }
}

/// The expression with the base of every root as one fraction, so that equal roots look alike: sqrt(k/(m/2)), sqrt(2*k/m).
fn roots_of_fractions(e: AtomView) -> Atom {
    match e {
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            let base = roots_of_fractions(base);
            let exponent = exponent.to_owned();
            if matches!(Tree::new(&exponent), Tree::Number(_, 1)) { base } else { base.together() }.pow(&exponent)
        }
        AtomView::Mul(m) => m.iter().fold(number(1), |product, factor| product * roots_of_fractions(factor)),
        AtomView::Add(a) => a.iter().fold(number(0), |sum, term| sum + roots_of_fractions(term)),
        AtomView::Num(_) | AtomView::Var(_) | AtomView::Fun(_) => e.to_owned(),
    }
}
