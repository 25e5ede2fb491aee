//! The text of a generated file, `gearsim/src/generated/<model>.rs`: a comment at the head, then the `equations!` block.
//!
//! The block starts with the declarations, goes on with the equations, one file here for each part, and ends with the
//! texts for people. Its grammar is documented at the head of the crate `gearsim-macros`.

mod block;
mod cell;
mod declarations;
mod energies;
mod head;
mod jumps;
mod motion;
mod names;
mod operations;

use crate::derivation::Derivation;
use crate::text;
use block::Block;

/// The whole text of the generated file.
pub(crate) fn write(d: &Derivation) -> String {
    let texts = text::write(d);
    let mut equations = Block::new(d.order());
    names::write(&mut equations, d);
    energies::write(&mut equations, d);
    motion::write(&mut equations, d);
    cell::write(&mut equations, d);
    jumps::write(&mut equations, d);

    let mut block = Block::new(d.order());
    // After the equations: only they show which combinations of effects need a condition.
    declarations::write(&mut block, d, equations.conditions());
    block.blank();
    block.append(equations);
    block.blank();
    block.strings("text", texts.plain());
    block.strings("latex", &texts.latex);

    let (head, block) = (head::write(d, &texts), block.text());
    format!("{head}\n\nuse gearsim_macros::equations;\n\nequations! {{\n{block}}}\n")
}
