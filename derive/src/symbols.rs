//! The symbols of a model, and derivatives by them. A derivative is taken only by symbols that occur in the expression, so that
//! the gradient of one spring costs the same in a model of any size.

mod derivatives;
mod named;

use std::collections::HashMap;

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Kind, number, symbol};
use crate::model::{Function, Model};
pub(crate) use named::{Force, Linear};

/// Nonzero entries of a vector: index and entry, by rising index.
pub(crate) type Sparse = Vec<(usize, Atom)>;

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
    /// The gradients of the named functions by the coordinates, and those of their derivatives up to the second.
    functions: Vec<Vec<Sparse>>,
    /// What each symbol is.
    places: HashMap<Symbol, Place>,
}

/// What a symbol is, with its index.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Place {
    Coordinate(usize),
    Speed(usize),
    Deflection(usize),
    Rate(usize),
    Law(usize),
    Slope(usize),
    Force(usize),
    /// Index of a named function, and the order of a derivative of it.
    Function(usize, usize),
}

/// The symbols of an expression that have a place, by their places.
fn present(e: &Atom, places: &HashMap<Symbol, Place>) -> Vec<(Symbol, Place)> {
    let mut all: Vec<_> =
        e.get_all_symbols(false).into_iter().filter_map(|symbol| Some((symbol, *places.get(&symbol)?))).collect();
    all.sort_by_key(|(_, place)| *place);
    all
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
        let mut put = |symbols: &[Symbol], place: fn(usize) -> Place| {
            places.extend(symbols.iter().enumerate().map(|(i, symbol)| (*symbol, place(i))));
        };
        put(&q, Place::Coordinate);
        put(&v, Place::Speed);
        put(&law, Place::Law);
        put(&slope, Place::Slope);
        let deflections: Vec<Linear> = model.deflections.iter().map(|d| Linear::new(d, &places)).collect();
        for (d, linear) in deflections.iter().enumerate() {
            places.extend([(linear.symbol, Place::Deflection(d)), (linear.rate_symbol, Place::Rate(d))]);
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
            let name = |order: usize| symbol(Kind::Function, &function.derivative(order));
            symbols.places.extend((0..Function::ORDERS).map(|order| (name(order), Place::Function(f, order))));
            let slopes = symbols.by_coordinates(&function.of.atom());
            let gradient = |order: usize| {
                let next = Atom::var(name(order + 1));
                slopes.iter().map(|(i, slope)| (*i, &next * slope)).collect()
            };
            symbols.functions.push((0..Function::ORDERS - 1).map(gradient).collect());
        }
        for (f, force) in model.forces.iter().enumerate() {
            symbols.forces.push(Force::new(force, &symbols));
            symbols.places.insert(symbol(Kind::Force, &force.name), Place::Force(f));
        }
        symbols.phase = model.laws.iter().map(|law| symbols.by_coordinates(&law.phase.atom())).collect();
        symbols
    }

    /// The symbols of an expression that have a place, by their places.
    pub fn present(&self, e: &Atom) -> Vec<(Symbol, Place)> {
        present(e, &self.places)
    }
}
