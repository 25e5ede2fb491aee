//! What a run can record besides the coordinates.

use super::block::Block;
use crate::derivation::Derivation;
use crate::model::Output;

/// Writes the block `outputs`, if there are any.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    if d.model.outputs.is_empty() {
        return;
    }
    b.braces(1, "outputs", |b| {
        for output in &d.model.outputs {
            let Output { name, unit, doc, .. } = output;
            let with = output.with.as_ref().map_or(String::new(), |effect| format!(" with {effect}"));
            let title = format!("{name} {unit:?}{with}, {doc:?}");
            b.row(2, &title, &b.not_expanded(&output.terms()));
        }
    });
}
