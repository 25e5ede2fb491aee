//! Terms and the effects they belong to. An effect multiplies its energies by a marker, 0 or 1; the marker follows
//! them through the derivation.

use symbolica::atom::{Atom, AtomCore, AtomView};

use crate::expr::{Kind, number, symbol, symbols};
use crate::model::{JUMP_TERMS, MOVING_PHASE};
use crate::tree::Tree;

/// Terms that share a condition: the effects all of which they need (none: always there).
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub effects: Vec<String>,
    pub sum: Tree,
}

/// The sum with every marker set to 1: all effects present.
pub(crate) fn all_present(e: &Atom) -> Atom {
    set(e, &markers(e), 1)
}

/// The expanded sum, grouped by condition; `order` gives the order of effects.
pub(crate) fn grouped(e: &Atom, order: &[String]) -> Vec<Group> {
    collect(terms(&e.expand()), order)
}

/// The pieces as they were written, grouped by condition.
pub(crate) fn as_written(pieces: &[Atom], order: &[String]) -> Vec<Group> {
    collect(pieces.to_vec(), order)
}

fn collect(pieces: Vec<Atom>, order: &[String]) -> Vec<Group> {
    let mut groups: Vec<(Vec<usize>, Atom)> = vec![];
    for piece in pieces {
        let mut marks = markers(&piece);
        let bare = set(&piece, &marks, 1);
        if marks.iter().any(|m| m == JUMP_TERMS) {
            marks.retain(|m| m != MOVING_PHASE); // implied
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
    symbols(e).into_iter().filter(|s| s.0 == Kind::Marker).map(|s| s.1).collect()
}

fn set(e: &Atom, names: &[String], value: i64) -> Atom {
    names.iter().fold(e.clone(), |e, name| {
        e.replace(Atom::var(symbol(Kind::Marker, name)).to_pattern()).with(number(value).to_pattern())
    })
}
