//! The linear cell, M q'' + C q' + K q = f, and the terms that make it nonlinear.

use super::block::Block;
use crate::derivation::Derivation;
use crate::symbols::Variable;

/// Writes the blocks `cell`, `nonlinear` and `nonlinear_with`, those that are not empty.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let cell = &d.cell;
    b.braces(1, "cell", |b| {
        for (what, entries) in [("stiffness", &cell.stiffness), ("damping", &cell.damping)] {
            b.braces(2, what, |b| {
                for (row, column, entry) in entries {
                    // Entries of C belong to speeds and rates; they have the names of the coordinates and deflections.
                    let name = |place: Variable| d.name(place.position());
                    b.sum(3, &format!("{} {}", name(*row), name(*column)), &b.grouped(entry));
                }
            });
        }
        b.braces(2, "load", |b| {
            for (place, entry) in &cell.load {
                b.sum(3, &d.name(*place), &b.grouped(entry));
            }
        });
    });
    if !cell.nonlinear.is_empty() {
        b.line(1, &format!("nonlinear {:?};", cell.nonlinear.join("; ")));
    }
    if !cell.nonlinear_with.is_empty() {
        b.braces(1, "nonlinear_with", |b| {
            for (effects, text) in &cell.nonlinear_with {
                b.line(2, &format!("{} {text:?};", effects.join(", ")));
            }
        });
    }
}
