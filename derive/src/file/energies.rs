//! Energies, torques, and the net generalised forces of the constant torques.

use super::block::Block;
use crate::derivation::Derivation;
use crate::lagrange;

/// Writes the blocks `energies`, `torques` and `work`.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let (m, s) = (d.model, &d.symbols);
    b.braces(1, "energies", |b| {
        b.sum(2, "kinetic", &b.as_written(&m.kinetic));
        b.sum(2, "potential", &b.as_written(&m.potential));
        b.sum(2, "dissipation", &b.as_written(&m.dissipation));
    });
    b.braces(1, "torques", |b| {
        for t in &m.torques {
            let title = format!("{} {:?}", t.name, t.doc);
            if m.varies(t) {
                b.row(2, &title, &[]);
                b.sum(2, "power", &b.not_expanded(&t.powers()));
            } else {
                b.row(2, &title, &b.not_expanded(&[t.value.atom() * lagrange::displacement(s, t)]));
            }
        }
    });
    let constant = lagrange::external(m, s, |t| !m.varies(t));
    b.sums(1, "work", &d.coordinates(), &constant);
}
