//! The inverse mass matrix of small models, and the constants that a model names after it.

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Kind, number, symbol, symbols};
use crate::lagrange::{Motion, mobility_symbol};
use crate::markers::{all_present, terms};
use crate::model::Model;
use crate::slip::Slip;

/// Largest number of coordinates for which M is inverted symbolically.
const LARGEST: usize = 2;

/// Inverts M where that is small and constant, and works out the constants.
///
/// A constant that is a multiple of one entry W_ij of the inverse (`m.constant("M2", 2 * m.inverse_mass(phi, phi))`)
/// becomes the name under which that entry, and any equal one, appears in the equations.
pub(crate) fn name(model: &Model, motion: &mut Motion) -> Result<(), Slip> {
    let n = model.coordinates.len();
    // An inertia that an effect adds has a marker in it: then M is not one matrix, and is left to the engine.
    let fixed = |m: &Atom| symbols(m).iter().all(|s| !matches!(s.0, Kind::Coordinate | Kind::Marker));
    let constant = motion.mass.iter().flatten().all(fixed);
    let exact = if n <= LARGEST && constant { Some(inverse(model, &motion.mass)?) } else { None };
    let mut named = exact.clone();
    for (name, value) in &model.constants {
        let mut value = value.atom();
        if let (Some(exact), Some(named)) = (&exact, &mut named) {
            for i in 0..n {
                for j in i..n {
                    let w = mobility_symbol(i, j);
                    let ratio = (&value / &w).expand();
                    if symbols(&ratio).is_empty() && !value.is_zero() {
                        let entry = Atom::var(symbol(Kind::Constant, name)) / ratio;
                        substitute(exact, named, (i, j), &entry);
                    }
                    value = value.replace(w.to_pattern()).with(exact[i][j].to_pattern());
                }
            }
        }
        if symbols(&value).iter().any(|s| s.0 == Kind::Mobility) {
            return Err(Slip::InverseMass { model: model.name.clone() });
        }
        motion.constants.push((name.clone(), value.expand()));
    }
    motion.mobility_exact = exact;
    motion.mobility = named;
    Ok(())
}

/// Puts `entry` in place of W_ij and of every entry equal to it.
fn substitute(exact: &[Vec<Atom>], named: &mut [Vec<Atom>], (i, j): (usize, usize), entry: &Atom) {
    for k in 0..exact.len() {
        for l in 0..exact.len() {
            if is_zero(&(&exact[k][l] - &exact[i][j])) {
                named[k][l] = entry.clone();
            }
        }
    }
}

fn inverse(model: &Model, mass: &[Vec<Atom>]) -> Result<Vec<Vec<Atom>>, Slip> {
    let m: Vec<Vec<Atom>> = mass.iter().map(|row| row.iter().map(all_present).collect()).collect();
    let determinant = determinant(&m);
    if determinant.is_zero() {
        let coordinates: Vec<&str> = model.coordinates.iter().map(|c| c.name.as_str()).collect();
        return Err(Slip::Singular { model: model.name.clone(), coordinates: coordinates.join(", ") });
    }
    let entry = |cofactor: Atom| match terms(&determinant).len() {
        1 => (cofactor / &determinant).expand(),
        _ => cofactor / &determinant,
    };
    Ok(match m.len() {
        1 => vec![vec![entry(number(1))]],
        _ => vec![vec![entry(m[1][1].clone()), entry(-&m[0][1])], vec![entry(-&m[1][0]), entry(m[0][0].clone())]],
    })
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
        sum = sum + number(sign) * &m[0][j] * determinant(&minor);
    }
    sum.expand()
}

/// Whether a rational expression is identically zero.
pub(crate) fn is_zero(e: &Atom) -> bool {
    e.expand().is_zero() || e.together().expand().is_zero()
}
