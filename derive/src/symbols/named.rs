//! Named deflections and forces, and the derivatives through them.

use std::collections::HashMap;

use symbolica::atom::{Atom, AtomCore, Symbol};

use super::{Partials, Sparse, Symbols, Variable, present};
use crate::expr::{Kind, kind_and_name, number, partial_name, set, speed_name, symbol, total};
use crate::model::{self, Deflection};

/// A named deflection, delta = sum_i slope_i q_i + rest, and its rate, delta' = sum_i slope_i q'_i.
pub(crate) struct Linear {
    pub symbol: Symbol,
    pub rate_symbol: Symbol,
    /// Its derivatives by coordinates.
    pub slopes: Sparse,
    /// Its value at q = 0: minus the offset of a switch, minus transmission errors.
    pub rest: Atom,
    /// Its derivatives by laws.
    pub by_law: Sparse,
    /// The deflection, written in the coordinates.
    value: Atom,
    /// The derivatives of its rate by positions. If the deflection bends, its slopes depend on the positions.
    pub(super) rate_by_positions: Partials,
    /// Whether it contains functions of positions. Its derivatives by the coordinates then depend on the coordinates.
    pub bends: bool,
}

impl Linear {
    pub(super) fn new(d: &Deflection, places: &HashMap<Symbol, Variable>) -> Linear {
        let value = d.value.atom();
        let (mut slopes, mut by_law, mut rest) = (vec![], vec![], value.clone());
        for (symbol, place) in present(&value, places) {
            let slope = value.derivative(symbol).expand();
            match place {
                _ if slope.is_zero() => {}
                Variable::Coordinate(i) => {
                    slopes.push((i, slope));
                    rest = set(&rest, symbol, &number(0));
                }
                Variable::Law(l) => by_law.push((l, slope)),
                _ => {}
            }
        }
        Linear {
            symbol: symbol(Kind::Deflection, &d.name),
            rate_symbol: symbol(Kind::Rate, &speed_name(&d.name)),
            slopes,
            rest: rest.expand(),
            by_law,
            value,
            rate_by_positions: vec![],
            bends: false,
        }
    }

    /// The same deflection with the derivatives through the functions in its `value`; `s` has these functions.
    pub(super) fn bent(&self, value: &Atom, s: &Symbols) -> Linear {
        let functions = s.present(value).into_iter().filter_map(|(symbol, place)| match place {
            Variable::Function(f, which) => Some((value.derivative(symbol), &s.functions[f].by_coordinates[which])),
            _ => None,
        });
        let functions: Vec<_> = functions.collect();
        let through =
            functions.iter().flat_map(|(factor, gradient)| gradient.iter().map(move |(i, by)| (*i, factor * by)));
        let slopes = super::merged(self.slopes.iter().cloned().chain(through));
        let bending = slopes.iter().flat_map(|(i, slope)| {
            let speed = Atom::var(s.v[*i]);
            s.by_positions(slope).into_iter().map(move |(place, by)| (place, by * &speed))
        });
        let rate_by_positions = super::merged(bending);
        let (rest, by_law, value) = (self.rest.clone(), self.by_law.clone(), self.value.clone());
        Linear { slopes, rest, by_law, value, rate_by_positions, bends: !functions.is_empty(), ..*self }
    }

    /// The deflection, written in the coordinates `q`.
    pub fn of(&self, q: &[Symbol]) -> Atom {
        if self.bends { self.value.clone() } else { self.rate(q) + &self.rest }
    }

    /// Its rate, written in the speeds `v`.
    pub fn rate(&self, v: &[Symbol]) -> Atom {
        self.slopes.iter().fold(number(0), |sum, (i, slope)| sum + slope * Atom::var(v[*i]))
    }
}

/// A named force. Its derivatives are written in the names of its partial derivatives.
pub(crate) struct Force {
    /// The partial derivatives: name and value.
    pub partials: Vec<(String, Atom)>,
    pub(super) by_coordinates: Sparse,
    pub(super) by_speeds: Sparse,
    pub(super) by_positions: Partials,
    pub(super) by_motions: Partials,
    pub(super) by_laws: Sparse,
}

impl Force {
    /// The force. It may contain the forces declared before it, which `s` has.
    pub(super) fn new(force: &model::Force, s: &Symbols) -> Force {
        let value = force.value.atom();
        let (mut partials, mut linear) = (vec![], vec![]);
        for (by, _) in s.present(&value) {
            let partial = partial_name(&force.name, &kind_and_name(by).1);
            linear.push(Atom::var(symbol(Kind::Partial, &partial)) * Atom::var(by));
            partials.push((partial, value.derivative(by)));
        }
        // A linear form with the same gradients as the force: the sum of its symbols times its partial derivatives.
        let linear = total(linear);
        Force {
            partials,
            by_coordinates: s.by_coordinates(&linear),
            by_speeds: s.by_speeds(&linear),
            by_positions: s.by_positions(&linear),
            by_motions: s.by_motions(&linear),
            by_laws: s.by_laws(&linear),
        }
    }
}
