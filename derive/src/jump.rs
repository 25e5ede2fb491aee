//! Jump rules: how the speeds change where a law steps by dk at the surface s(q) = const.
//!
//! With n = grad s, G = n.M⁻¹n, v = n.q' and dV = V(k + dk) - V(k) at the same q (for a transmission error, V(e + de) - V(e)):
//! v+² = v² - 2 G dV if that is >= 0 (transmission), else v+ = -v (reflection, the cell does not change);
//! q'+ = q' + (M⁻¹n/G)(v+ - v).

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{number, total};
use crate::lagrange::{EquationsOfMotion, rows};
use crate::model::Model;
use crate::symbols::Symbols;

/// The jump rule of one law.
pub(crate) struct Jump {
    /// n = grad s.
    pub normal: Vec<Atom>,
    /// G = n.M⁻¹n, if M was inverted.
    pub compliance: Option<Atom>,
    /// M⁻¹n/G, if M was inverted.
    pub direction: Option<Vec<Atom>>,
    /// dV for a step dk.
    pub step: Atom,
}

/// The jump rule of every law.
pub(crate) fn derive(model: &Model, motion: &EquationsOfMotion, s: &Symbols) -> Vec<Jump> {
    model
        .laws
        .iter()
        .enumerate()
        .map(|(l, _)| {
            let normal = rows(s.q.len(), s.phase[l].iter().cloned());
            let energies = model.potential.iter().map(|v| v.atom());
            let steps = energies.filter_map(|v| Some((s.stepped(&v, l)? - v).expand()));
            // Where M depends on the coordinates, so do G and M⁻¹n: they are computed at the event.
            let (compliance, direction) = match motion.mobility.as_ref().filter(|_| motion.inertia.is_none()) {
                Some(w) => {
                    let (g, d) = response(w, &normal);
                    (Some(g), Some(d))
                }
                None => (None, None),
            };
            Jump { normal, compliance, direction, step: total(steps.collect()) }
        })
        .collect()
}

/// G and M⁻¹n/G for a given M⁻¹.
pub(crate) fn response(w: &[Vec<Atom>], normal: &[Atom]) -> (Atom, Vec<Atom>) {
    let wn: Vec<Atom> = w.iter().map(|row| row.iter().zip(normal).fold(number(0), |sum, (w, n)| sum + w * n)).collect();
    let g = normal.iter().zip(&wn).fold(number(0), |sum, (n, wn)| sum + n * wn).expand();
    let direction = wn.iter().map(|wn| wn.expand() / &g).collect();
    (g, direction)
}
