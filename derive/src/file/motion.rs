//! The equations of motion M q'' = F: M, its inverse if it is known, the derivatives of M q'' by the coordinates if M depends on them,
//! F, and the derivatives of F.

use super::block::Block;
use crate::derivation::Derivation;

/// Writes the blocks `mass`, `mobility`, `inertia`, `force` and `jacobian`.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let (motion, names) = (&d.motion, d.coordinates());
    b.matrix(1, "mass", &names, &motion.mass);
    if let Some(inverse) = &motion.mobility {
        // An entry is not expanded, so that it stays one fraction over the determinant. If no terms of M cancel, no terms of its inverse
        // do.
        b.triangle(1, "mobility", &names, inverse, |b, entry| b.not_expanded(std::slice::from_ref(entry)));
    }
    if let Some(inertia) = &motion.inertia {
        b.braces(1, "inertia", |b| {
            for (name, row) in names.iter().zip(inertia) {
                for (by, entry) in names.iter().zip(row) {
                    b.sum(2, &format!("{name} {by}"), &b.grouped(entry));
                }
            }
        });
    }
    b.rows(1, "force", &names, &motion.force);
    b.braces(1, "jacobian", |b| {
        for (name, row) in names.iter().zip(&d.jacobian) {
            for (by, entry) in row {
                b.sum(2, &format!("{name} {}", d.name(*by)), &b.grouped(entry));
            }
        }
    });
}
