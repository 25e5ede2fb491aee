//! The linear cell, M q'' + C q' + K q = f, and the terms that make it nonlinear.

use super::block::Block;
use crate::derivation::Derivation;

/// Writes the blocks `cell`, `nonlinear` and `nonlinear_with`, those that are not empty.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let (names, cell) = (d.coordinates(), &d.cell);
    b.braces(1, "cell", |b| {
        b.matrix(2, "stiffness", &names, &cell.stiffness);
        b.matrix(2, "damping", &names, &cell.damping);
        b.sums(2, "load", &names, &cell.load);
    });
    if !cell.nonlinear.is_empty() {
        b.line(1, &format!("nonlinear {:?};", cell.nonlinear.join("; ")));
    }
    if !cell.nonlinear_with.is_empty() {
        b.braces(1, "nonlinear_with", |b| {
            for (effect, text) in &cell.nonlinear_with {
                b.line(2, &format!("{effect} {text:?};"));
            }
        });
    }
}
