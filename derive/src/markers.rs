//! Terms and the effects that they belong to. The energies of an effect are multiplied by a marker, a symbol that is 0 or 1
//! and is carried through the derivation.

use symbolica::atom::{Atom, AtomCore, AtomView};

use crate::expr::{Kind, kind_and_name, number, set, symbol};
use crate::model::{JUMP_TERMS, MOVING_PHASE};
use crate::tree::Tree;

/// Terms with the same condition: all of `effects` must be present (none: the terms are always present).
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub effects: Vec<String>,
    pub sum: Tree,
}

/// The sum with every marker set to 1: all effects present.
pub(crate) fn all_present(e: &Atom) -> Atom {
    markers(e).iter().fold(e.clone(), |e, name| set(&e, symbol(Kind::Marker, name), &number(1)))
}

/// The sum without the terms of an effect, expanded.
pub(crate) fn without(e: &Atom, effect: &str) -> Atom {
    set(e, symbol(Kind::Marker, effect), &number(0)).expand()
}

/// The effects that only some terms of a sum need: without such an effect the sum changes, but is not zero.
pub(crate) fn optional(e: &Atom) -> Vec<String> {
    markers(e).into_iter().filter(|effect| !without(e, effect).is_zero()).collect()
}

/// The terms of the expanded sum, grouped by condition; `order` gives the order of effects.
pub(crate) fn grouped(e: &Atom, order: &[String]) -> Vec<Group> {
    collect(terms(&e.expand()), order)
}

/// The pieces without expansion, grouped by condition.
pub(crate) fn as_written(pieces: &[Atom], order: &[String]) -> Vec<Group> {
    collect(pieces.to_vec(), order)
}

fn collect(pieces: Vec<Atom>, order: &[String]) -> Vec<Group> {
    let mut groups: Vec<(Vec<usize>, Atom)> = vec![];
    for piece in pieces {
        let mut marks = markers(&piece);
        let bare = if marks.is_empty() { piece } else { bare(&piece) };
        if marks.iter().any(|m| m == JUMP_TERMS) {
            marks.retain(|m| m != MOVING_PHASE); // implied by the jump terms
        }
        let mut key: Vec<usize> =
            marks.iter().map(|m| order.iter().position(|o| o == m).unwrap_or(order.len())).collect();
        key.sort();
        match groups.iter_mut().find(|g| g.0 == key) {
            Some(group) => group.1 = &group.1 + &bare,
            None => groups.push((key, bare)),
        }
    }
    groups.retain(|g| !g.1.is_zero());
    groups.sort_by(|a, b| a.0.cmp(&b.0));
    groups
        .into_iter()
        .map(|(key, sum)| Group { effects: key.iter().map(|&i| order[i].clone()).collect(), sum: Tree::new(&sum) })
        .collect()
}

/// The terms of a sum.
pub(crate) fn terms(e: &Atom) -> Vec<Atom> {
    match e.as_view() {
        AtomView::Add(sum) => sum.iter().map(|t| t.to_owned()).collect(),
        _ if e.is_zero() => vec![],
        _ => vec![e.clone()],
    }
}

/// The effects that a term needs.
pub(crate) fn markers(e: &Atom) -> Vec<String> {
    let all = e.get_all_symbols(false).into_iter().map(kind_and_name).filter(|(kind, _)| *kind == Kind::Marker);
    let mut names: Vec<String> = all.map(|(_, name)| name).collect();
    names.sort();
    names
}

/// The term with every marker 1.
fn bare(term: &Atom) -> Atom {
    let is_marker =
        |factor: AtomView| matches!(factor, AtomView::Var(x) if kind_and_name(x.get_symbol()).0 == Kind::Marker);
    let AtomView::Mul(product) = term.as_view() else { return all_present(term) };
    let rest = product.iter().filter(|factor| !is_marker(*factor));
    let rest = rest.fold(number(1), |product, factor| product * factor);
    // A marker may also be within a factor that is a sum.
    all_present(&rest)
}
