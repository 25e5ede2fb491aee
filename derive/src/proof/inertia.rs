//! Proofs about M: it is symmetric and positive definite, T is its quadratic form, and M⁻¹, if it is written, is its inverse.

use symbolica::atom::Atom;

use super::{Proof, exact};
use crate::check::positive;
use crate::expr::{number, total};
use crate::markers::{all_present, terms};
use crate::mobility::{LARGEST_DETERMINANT, determinant};
use crate::model::Model;
use crate::slip::Slip;
use crate::squares::{self, Squares};
use crate::symbols::Symbols;
use crate::trigonometry::simplified;

/// Proves what the file says about M.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    let (mass, n) = (&p.motion.mass, p.s.q.len());
    let pairs = || (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    let asymmetry = pairs().map(|(i, j)| &mass[i][j] - &mass[j][i]).filter(|d| !d.is_zero());
    p.claim("M is symmetric", std::iter::once(number(0)).chain(asymmetry))?;
    let form = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| !mass[i][j].is_zero());
    let form = form.map(|(i, j)| &mass[i][j] * Atom::var(p.s.v[i]) * Atom::var(p.s.v[j]) / number(2));
    let kinetic = p.model.kinetic.iter().map(|t| -t.atom());
    p.claim("T = q'.M q'/2, with M as written", [total(form.chain(kinetic).collect())])?;
    let definite = definiteness(p.model, p.s, mass)?;
    p.proved.push(definite);
    centrifugal(p)?;
    if let Some(w) = &p.motion.mobility {
        let w_exact: Vec<Vec<Atom>> =
            w.iter().map(|row| row.iter().map(|entry| exact(p.motion, entry)).collect()).collect();
        let m_exact: Vec<Vec<Atom>> =
            mass.iter().map(|row| row.iter().map(|entry| exact(p.motion, entry)).collect()).collect();
        let product = |i: usize, j: usize| (0..n).fold(number(0), |sum, k| sum + &m_exact[i][k] * &w_exact[k][j]);
        let unit = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let inverse = unit.map(|(i, j)| product(i, j) - number(i64::from(i == j)));
        // M q'' = F follows from q'' = M⁻¹F, which needs no fractions.
        let force = &p.motion.force;
        let row = |i: usize, a: &Atom| (0..n).fold(-a, |sum, j| sum + &w[i][j] * &force[j]);
        let motion = p.motion.acceleration.iter().flat_map(|a| a.iter().enumerate().map(|(i, a)| row(i, a)));
        let rests: Vec<Atom> = inverse.chain(motion).collect();
        let accelerations = p.motion.acceleration.is_some();
        let what = match accelerations {
            true => "M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written",
            false => "M M⁻¹ = 1 for M⁻¹ as written, at every q",
        };
        p.claim(what, rests)?;
    }
    Ok(())
}

/// Proves that the centrifugal and gyroscopic forces in F follow from M with Christoffel's symbols. The balance of power alone does not
/// prove this, because gyroscopic forces do no work.
fn centrifugal(p: &mut Proof) -> Result<(), Slip> {
    if p.motion.inertia.is_none() {
        return Ok(());
    }
    let (mass, s, n) = (&p.motion.mass, p.s, p.s.q.len());
    let by = |i: usize, j: usize, k: usize| {
        let gradient = s.by_coordinates(&mass[i][j]);
        gradient.into_iter().find(|(at, _)| *at == k).map_or_else(|| number(0), |(_, by)| by)
    };
    let symbol =
        |i, j, k| (by(i, j, k) + by(i, k, j) - by(j, k, i)) / number(2) * Atom::var(s.v[j]) * Atom::var(s.v[k]);
    let rest = |i: usize| {
        let symbols = (0..n).flat_map(|j| (0..n).map(move |k| (j, k))).map(|(j, k)| symbol(i, j, k));
        total(symbols.collect()) + &p.motion.force[i] - &p.motion.applied[i]
    };
    let rests: Vec<Atom> = (0..n).map(rest).collect();
    let what =
        "d/dt dT/dq' - dT/dq = M q'' + c, where F has -c_i = -sum (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)/2 q'_j q'_k";
    p.claim(what, rests)
}

/// Decides whether M is positive definite, and returns the statement. It uses Sylvester's criterion if every leading minor is a sum of
/// products of positive quantities, and otherwise T as a sum of squares.
fn definiteness(model: &Model, s: &Symbols, mass: &[Vec<Atom>]) -> Result<String, Slip> {
    let n = mass.len();
    let minor = |k: usize| simplified(&determinant(&mass[..k].iter().map(|row| row[..k].to_vec()).collect::<Vec<_>>()));
    let posynomial = |e: Atom| !e.is_zero() && terms(&all_present(&e)).iter().all(|t| positive(model, t));
    if n <= LARGEST_DETERMINANT && (1..=n).all(|k| posynomial(minor(k))) {
        return Ok("M is positive definite: every leading minor is a sum of products of positive quantities".into());
    }
    match squares::decide(model, s) {
        Squares::Definite => {
            Ok("M is positive definite: T is a sum of squares that vanish together only at rest".into())
        }
        Squares::Free(left) => {
            let names: Vec<&str> = left.iter().map(|&i| model.coordinates[i].name.as_str()).collect();
            Err(Slip::Singular { model: model.name.clone(), coordinates: names.join(", ") })
        }
        Squares::Undecided => {
            Ok("M is positive definite: not decided symbolically; checked for the numbers of every scene".into())
        }
    }
}
