//! The generated files of a model: `<model>.rs`, which is compiled, and `text/<model>.txt` and `latex/<model>.tex`, which are for reading.
//!
//! The first has the `equations!` block: the declarations, then the equations. Each part is written by one file of this folder. The grammar
//! of the block is documented at the head of the crate `gearsim-macros`.

mod block;
mod cell;
mod declarations;
mod energies;
mod head;
mod jumps;
mod motion;
mod names;
mod operations;
mod outputs;
pub(crate) mod wrap;

use crate::Home;
use crate::derivation::Derivation;
use block::Block;

/// The text of `<model>.rs`.
pub(crate) fn write(d: &Derivation, home: Home<'_>) -> String {
    let mut equations = Block::new(d);
    names::write(&mut equations, d);
    energies::write(&mut equations, d);
    motion::write(&mut equations, d);
    cell::write(&mut equations, d);
    jumps::write(&mut equations, d);
    outputs::write(&mut equations, d);

    let mut block = Block::new(d);
    // Written after the equations, because these determine which combinations of effects need a condition.
    declarations::write(&mut block, d, equations.conditions());
    block.blank();
    block.append(equations);
    block.blank();
    let [_, text, latex] = paths(&d.model.name);
    block.line(1, &format!("text {text:?};"));
    block.line(1, &format!("latex {latex:?};"));
    let (head, block, end) = (head::head(d, home), block.text(), head::end(d));
    format!("{head}\n\nuse gearsim::equations;\n\nequations! {{\n{block}}}\n\n{end}\n")
}

/// Where the files of a model are, beside each other.
pub(crate) fn paths(model: &str) -> [String; 3] {
    [format!("{model}.rs"), format!("text/{model}.txt"), format!("latex/{model}.tex")]
}
