//! The symbols of a model, and derivatives by them. A derivative is taken only by symbols that occur in the expression, so that
//! the gradient of one spring costs the same in a model of any size.

mod derivatives;
mod named;

use std::collections::{BTreeMap, HashMap};

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Kind, number, symbol};
use crate::model::{Derivative, Model};
pub(crate) use named::{Force, Linear};

/// Nonzero entries of a vector: index and entry, by rising index.
pub(crate) type Sparse = Vec<(usize, Atom)>;

/// Nonzero derivatives: the variable of each, and the derivative, in the order of the variables.
pub(crate) type Partials = Vec<(Variable, Atom)>;

/// The symbols of one model; entry i belongs to coordinate i, or law i.
pub(crate) struct Symbols {
    pub q: Vec<Symbol>,
    pub v: Vec<Symbol>,
    /// The marker of the effect without which the law is zero; 1 for a stiffness.
    pub gate: Vec<Atom>,
    pub slope: Vec<Symbol>,
    pub curvature: Vec<Symbol>,
    /// The gradient of the phase of each law.
    pub phase: Vec<Sparse>,
    pub deflections: Vec<Linear>,
    pub forces: Vec<Force>,
    functions: Vec<Function>,
    /// The variable that each symbol stands for.
    places: HashMap<Symbol, Variable>,
}

/// The derivatives of a named function, and of its derivatives; empty for the highest ones.
struct Function {
    by_coordinates: Vec<Sparse>,
    /// The derivatives by coordinates and deflections, each with all others constant.
    by_positions: Vec<Partials>,
}

/// The variable that a symbol stands for, with its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Variable {
    Coordinate(usize),
    Speed(usize),
    Deflection(usize),
    Rate(usize),
    Law(usize),
    Slope(usize),
    Force(usize),
    /// Index of a named function, and index in the list of the function and its derivatives.
    Function(usize, usize),
}

impl Variable {
    /// For a speed its coordinate, for a rate its deflection, for others the variable itself.
    pub fn position(self) -> Self {
        match self {
            Variable::Speed(i) => Variable::Coordinate(i),
            Variable::Rate(d) => Variable::Deflection(d),
            other => other,
        }
    }
}

/// The symbols of an expression that have a place, by their places.
fn present(e: &Atom, places: &HashMap<Symbol, Variable>) -> Vec<(Symbol, Variable)> {
    let mut all: Vec<_> =
        e.get_all_symbols(false).into_iter().filter_map(|symbol| Some((symbol, *places.get(&symbol)?))).collect();
    all.sort_by_key(|(_, place)| *place);
    all
}

/// The sums of parts of a vector, by rising index or place.
pub(crate) fn merged<I: Ord>(parts: impl Iterator<Item = (I, Atom)>) -> Vec<(I, Atom)> {
    let mut sums = BTreeMap::new();
    for (i, part) in parts {
        let sum = sums.entry(i).or_insert_with(|| number(0));
        *sum = &*sum + part;
    }
    sums.into_iter().collect()
}

/// The sums of the parts of each variable, expanded, without those that are zero.
pub(crate) fn expanded(parts: impl Iterator<Item = (Variable, Atom)>) -> Partials {
    let sums = merged(parts).into_iter().map(|(place, sum)| (place, sum.expand()));
    sums.filter(|(_, sum)| !sum.is_zero()).collect()
}

/// The derivatives of functions by the chain rule. `next` has the derivatives of each function by its arguments, `slopes` the derivatives
/// of each argument.
fn chained<I: Ord + Copy>(next: &[Vec<Atom>], slopes: &[Vec<(I, Atom)>]) -> Vec<Vec<(I, Atom)>> {
    let through = |next: &Vec<Atom>| {
        let parts = next.iter().zip(slopes);
        merged(parts.flat_map(|(next, slopes)| slopes.iter().map(move |(i, slope)| (*i, next * slope))))
    };
    next.iter().map(through).collect()
}

impl Symbols {
    pub fn new(model: &Model) -> Self {
        let laws =
            |kind, prefix: &str| model.laws.iter().map(|l| symbol(kind, &format!("{prefix}{}", l.name))).collect();
        let q: Vec<Symbol> = model.coordinates.iter().map(|c| symbol(Kind::Coordinate, &c.name)).collect();
        let v: Vec<Symbol> = model.speeds().iter().map(|s| symbol(Kind::Speed, s)).collect();
        let law: Vec<Symbol> = model.laws.iter().map(|l| symbol(l.kind(), &l.name)).collect();
        let slope: Vec<Symbol> = laws(Kind::Slope, "d");
        let gate =
            |with: &Option<String>| with.as_ref().map_or(number(1), |effect| Atom::var(symbol(Kind::Marker, effect)));
        let mut places = HashMap::new();
        let mut put = |symbols: &[Symbol], place: fn(usize) -> Variable| {
            places.extend(symbols.iter().enumerate().map(|(i, symbol)| (*symbol, place(i))));
        };
        put(&q, Variable::Coordinate);
        put(&v, Variable::Speed);
        put(&law, Variable::Law);
        put(&slope, Variable::Slope);
        let deflections: Vec<Linear> = model.deflections.iter().map(|d| Linear::new(d, &places)).collect();
        for (d, linear) in deflections.iter().enumerate() {
            places.extend([(linear.symbol, Variable::Deflection(d)), (linear.rate_symbol, Variable::Rate(d))]);
        }
        let mut symbols = Symbols {
            q,
            v,
            gate: model.laws.iter().map(|l| gate(&l.with)).collect(),
            slope,
            curvature: laws(Kind::Curvature, "dd"),
            phase: vec![],
            deflections,
            forces: vec![],
            functions: vec![],
            places,
        };
        for (f, function) in model.functions.iter().enumerate() {
            let all = function.derivatives();
            let name = |i: usize| symbol(Kind::Function, &all[i].name);
            symbols.places.extend((0..all.len()).map(|i| (name(i), Variable::Function(f, i))));
            let next: Vec<Vec<Atom>> = {
                let present = gate(&function.with);
                let next = |d: &Derivative| d.next.iter().map(|next| &present * Atom::var(name(*next))).collect();
                all.iter().map(next).collect()
            };
            let of = || function.of.iter().map(|of| of.atom());
            let by_coordinates = chained(&next, &of().map(|of| symbols.by_coordinates(&of)).collect::<Vec<_>>());
            let by_positions = chained(&next, &of().map(|of| symbols.by_positions(&of)).collect::<Vec<_>>());
            symbols.functions.push(Function { by_coordinates, by_positions });
        }
        let bent: Vec<Linear> = (model.deflections.iter().zip(&symbols.deflections))
            .map(|(deflection, straight)| straight.bent(&deflection.value.atom(), &symbols))
            .collect();
        symbols.deflections = bent;
        for (f, force) in model.forces.iter().enumerate() {
            symbols.forces.push(Force::new(force, &symbols));
            symbols.places.insert(symbol(Kind::Force, &force.name), Variable::Force(f));
        }
        symbols.phase = model.laws.iter().map(|law| symbols.by_coordinates(&law.phase.atom())).collect();
        symbols
    }

    /// The symbols of an expression that have a place, by their places.
    pub fn present(&self, e: &Atom) -> Vec<(Symbol, Variable)> {
        present(e, &self.places)
    }
}
