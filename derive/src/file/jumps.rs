//! The jump rule of every law.

use super::block::Block;
use crate::derivation::Derivation;

/// Writes a block `jump` for each law. n is the unit vector of the phase, and is not written. G and M⁻¹n/G are written only if they are
/// known and V steps.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let names = d.coordinates();
    for (law, jump) in d.model.laws.iter().zip(&d.jumps) {
        b.braces(1, &format!("jump {}", law.name), |b| {
            if let (Some(g), Some(direction), false) = (&jump.compliance, &jump.direction, jump.step.is_zero()) {
                b.sum(2, "compliance", &b.grouped(g));
                b.sums(2, "direction", &names, direction);
            }
            b.row(2, "step", &b.grouped(&jump.step));
        });
    }
}
