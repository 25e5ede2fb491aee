//! Decides whether T is positive definite, for any number of coordinates, if it is a sum of squares:
//! T = sum_i c_i (l_i.q')²/2 with c_i > 0. T is zero only if every l_i.q' is; Gaussian elimination shows whether q' = 0 follows.

use symbolica::atom::{Atom, AtomCore, AtomView};

use crate::check::{never_negative, positive};
use crate::expr::{Kind, symbols};
use crate::markers::all_present;
use crate::mobility::is_zero;
use crate::model::Model;
use crate::symbols::Symbols;
use crate::tree::Tree;

/// The result of [`decide`].
pub(crate) enum Squares {
    /// T is positive definite.
    Definite,
    /// M is singular: the squares do not determine the speeds of these coordinates (by index).
    Free(Vec<usize>),
    /// T is not written as a sum of squares, or the sign of a coefficient is not known.
    Undecided,
}

/// Eliminates one speed after another with the forms l_i, until no speed or no usable pivot is left.
pub(crate) fn decide(model: &Model, s: &Symbols) -> Squares {
    let Some(Forms { mut rows, complete }) = forms(model, s) else { return Squares::Undecided };
    let mut left: Vec<usize> = (0..s.q.len()).collect();
    loop {
        rows.retain(|row| row.iter().any(|c| !c.is_zero()));
        // The simplest pivot first: the other rows then stay so simple that the form of an entry shows its sign.
        let entries = rows.iter().enumerate().flat_map(|(r, row)| {
            let size = row.iter().filter(|c| !c.is_zero()).count();
            let places = row.iter().enumerate().filter(|(_, c)| !c.is_zero());
            places.map(move |(column, c)| (size, Tree::new(c).operations(), r, column))
        });
        let pivot = entries.filter(|&(.., r, column)| not_zero(model, &rows[r][column])).min();
        let Some((.., r, column)) = pivot else { break };
        left.retain(|i| *i != column);
        let row = rows.remove(r);
        for other in rows.iter_mut().filter(|other| !other[column].is_zero()) {
            let factor = &other[column] / &row[column];
            for (c, of_row) in other.iter_mut().zip(&row).filter(|(_, of_row)| !of_row.is_zero()) {
                let rest = (&*c - &factor * of_row).expand();
                *c = if is_zero(&rest) { Atom::Zero } else { rest };
            }
            other[column] = Atom::Zero;
        }
    }
    match (left.is_empty(), rows.is_empty() && complete) {
        (true, _) => Squares::Definite,
        (false, true) => Squares::Free(left),
        (false, false) => Squares::Undecided,
    }
}

/// Whether the form of an expression shows that it is never zero. An inverse is never zero where it is finite.
fn not_zero(model: &Model, e: &Atom) -> bool {
    match e.as_view() {
        AtomView::Mul(m) => m.iter().all(|f| not_zero(model, &f.to_owned())),
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            positive(model, &-exponent.to_owned()) || not_zero(model, &base.to_owned())
        }
        _ => positive(model, e) || positive(model, &-e),
    }
}

/// The forms l_i: one row each, one coefficient for each coordinate.
struct Forms {
    rows: Vec<Vec<Atom>>,
    /// Whether T has no other squares. Squares that may be zero (of an effect, or with c_i = 0 allowed) are left out.
    complete: bool,
}

/// The forms of T; `None` if it is not written as a sum of squares.
fn forms(model: &Model, s: &Symbols) -> Option<Forms> {
    let (mut rows, mut complete) = (vec![], true);
    for piece in &model.kinetic {
        let piece = piece.atom();
        let of_effect = symbols(&piece).iter().any(|s| s.0 == Kind::Marker);
        let (factor, form) = square(&all_present(&piece))?;
        if !of_effect && positive(model, &factor) {
            rows.push(s.v.iter().map(|v| form.derivative(*v).expand()).collect());
        } else if never_negative(model, &factor) {
            complete = false;
        } else {
            return None;
        }
    }
    Some(Forms { rows, complete })
}

/// c and l of a piece c l^2 in which only l contains speeds.
fn square(piece: &Atom) -> Option<(Atom, Atom)> {
    let moves = |e: &Atom| symbols(e).iter().any(|s| s.0 == Kind::Speed);
    let factors: Vec<Atom> = match piece.as_view() {
        AtomView::Mul(m) => m.iter().map(|f| f.to_owned()).collect(),
        _ => vec![piece.clone()],
    };
    let (moving, still): (Vec<Atom>, Vec<Atom>) = factors.into_iter().partition(moves);
    let [square] = moving.as_slice() else { return None };
    let AtomView::Pow(power) = square.as_view() else { return None };
    let (base, exponent) = power.get_base_exp();
    let factor = still.iter().fold(Atom::num(1), |product, f| product * f);
    (exponent.to_owned() == Atom::num(2)).then(|| (factor, base.to_owned()))
}
