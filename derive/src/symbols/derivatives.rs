//! Derivatives by the symbols that occur in an expression.

use std::collections::BTreeMap;

use symbolica::atom::Atom;

use super::{Partials, Sparse, Symbols, Variable};
use crate::expr::{derivative, number, set};

impl Symbols {
    /// The chain rule: sums the derivatives by the symbols of `e`, each times the derivatives of the symbol that `parts` gives.
    fn chain<'a, I: Ord + Copy + 'a>(
        &'a self,
        e: &Atom,
        parts: impl Fn(Variable) -> Option<Dependence<'a, I>>,
    ) -> Vec<(I, Atom)> {
        let mut sum: BTreeMap<I, Atom> = BTreeMap::new();
        let mut add = |i, part: Atom| {
            let entry = sum.entry(i).or_insert_with(|| number(0));
            *entry = &*entry + part;
        };
        for (symbol, place) in self.present(e) {
            match parts(place) {
                Some(Dependence::Itself(i)) => add(i, derivative(e, symbol)),
                Some(Dependence::Through(inner)) => {
                    let outer = derivative(e, symbol);
                    inner.iter().for_each(|(i, inner)| add(*i, inner * &outer));
                }
                None => {}
            }
        }
        sum.into_iter().filter(|(_, part)| !part.is_zero()).collect()
    }

    /// The gradient by the coordinates, including the derivatives through deflections, with the laws held constant.
    pub fn by_coordinates(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Variable::Coordinate(i) => Some(Dependence::Itself(i)),
            Variable::Deflection(d) => Some(Dependence::Through(&self.deflections[d].slopes)),
            Variable::Force(f) => Some(Dependence::Through(&self.forces[f].by_coordinates)),
            Variable::Function(f, order) => {
                self.functions[f].by_coordinates.get(order).map(|by| Dependence::Through(by))
            }
            _ => None,
        })
    }

    /// The gradient by the speeds, including the derivatives through the rates of deflections.
    pub fn by_speeds(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Variable::Speed(i) => Some(Dependence::Itself(i)),
            Variable::Rate(d) => Some(Dependence::Through(&self.deflections[d].slopes)),
            Variable::Force(f) => Some(Dependence::Through(&self.forces[f].by_speeds)),
            _ => None,
        })
    }

    /// The derivatives by the coordinates and by the deflections, each with all others constant. Together with the derivatives of the
    /// deflections by the coordinates they give the gradient. Laws are constant.
    pub fn by_positions(&self, e: &Atom) -> Partials {
        self.chain(e, |place| match place {
            Variable::Coordinate(_) | Variable::Deflection(_) => Some(Dependence::Itself(place)),
            Variable::Force(f) => Some(Dependence::Through(&self.forces[f].by_positions)),
            Variable::Rate(d) => Some(Dependence::Through(&self.deflections[d].rate_by_positions)),
            Variable::Function(f, order) => self.functions[f].by_positions.get(order).map(|by| Dependence::Through(by)),
            _ => None,
        })
    }

    /// The derivatives by the speeds and by the rates of deflections, each with all others constant.
    pub fn by_motions(&self, e: &Atom) -> Partials {
        self.chain(e, |place| match place {
            Variable::Speed(_) | Variable::Rate(_) => Some(Dependence::Itself(place)),
            Variable::Force(f) => Some(Dependence::Through(&self.forces[f].by_motions)),
            _ => None,
        })
    }

    /// The derivatives by the values of laws, including those through deflections.
    pub fn by_laws(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Variable::Law(l) => Some(Dependence::Itself(l)),
            Variable::Deflection(d) => Some(Dependence::Through(&self.deflections[d].by_law)),
            Variable::Force(f) => Some(Dependence::Through(&self.forces[f].by_laws)),
            _ => None,
        })
    }

    /// The derivatives by the slopes of laws.
    pub fn slopes(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Variable::Slope(l) => Some(Dependence::Itself(l)),
            _ => None,
        })
    }

    /// The expression after law `l` has stepped by an amount written as the symbol of its slope, including the step of
    /// deflections; `None` if the law is not in it.
    pub fn stepped(&self, e: &Atom, l: usize) -> Option<Atom> {
        let step = Atom::var(self.slope[l]);
        let moved = self.present(e).into_iter().filter_map(|(symbol, place)| {
            let by = match place {
                Variable::Law(law) if law == l => step.clone(),
                Variable::Deflection(d) => &self.deflections[d].by_law.iter().find(|(law, _)| *law == l)?.1 * &step,
                _ => return None,
            };
            Some((symbol, by))
        });
        moved.fold(None, |e_so_far, (symbol, by)| {
            Some(set(e_so_far.as_ref().unwrap_or(e), symbol, &(Atom::var(symbol) + by)))
        })
    }
}

/// How an expression depends on the variable of differentiation through one of its symbols.
enum Dependence<'a, I> {
    /// The symbol is the variable of this index.
    Itself(I),
    /// The symbol depends on the variables with these derivatives.
    Through(&'a [(I, Atom)]),
}
