//! The jump rule of every law.

use super::block::Block;
use crate::derivation::Derivation;

/// Writes a block `jump` for each law.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let names = d.coordinates();
    for (law, jump) in d.model.laws.iter().zip(&d.jumps) {
        b.braces(1, &format!("jump {}", law.name), |b| {
            b.sums(2, "normal", &names, &jump.normal);
            if let (Some(g), Some(direction)) = (&jump.compliance, &jump.direction) {
                b.sum(2, "compliance", &b.grouped(g));
                b.sums(2, "direction", &names, direction);
            }
            b.row(2, "step", &b.grouped(&jump.step));
        });
    }
}
