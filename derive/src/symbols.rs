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
    /// The gradients of the named functions and of their derivatives by the coordinates; empty for the highest ones.
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
    /// Index of a named function, and which of it and its derivatives.
    Function(usize, usize),
}

/// The symbols of an expression that have a place, by their places.
fn present(e: &Atom, places: &HashMap<Symbol, Place>) -> Vec<(Symbol, Place)> {
    let mut all: Vec<_> =
        e.get_all_symbols(false).into_iter().filter_map(|symbol| Some((symbol, *places.get(&symbol)?))).collect();
    all.sort_by_key(|(_, place)| *place);
    all
}

/// The sums of parts of a vector, by rising index.
fn merged(parts: impl Iterator<Item = (usize, Atom)>) -> Sparse {
    let mut sums = BTreeMap::new();
    for (i, part) in parts {
        let sum = sums.entry(i).or_insert_with(|| number(0));
        *sum = &*sum + part;
    }
    sums.into_iter().collect()
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
            let all = function.derivatives();
            let name = |i: usize| symbol(Kind::Function, &all[i].name);
            symbols.places.extend((0..all.len()).map(|i| (name(i), Place::Function(f, i))));
            let slopes: Vec<Sparse> = function.of.iter().map(|of| symbols.by_coordinates(&of.atom())).collect();
            let present = gate(&function.with);
            let gradient = |d: &Derivative| {
                let parts = d.next.iter().zip(&slopes).flat_map(|(next, slopes)| {
                    let next = &present * Atom::var(name(*next));
                    slopes.iter().map(move |(i, slope)| (*i, &next * slope))
                });
                merged(parts)
            };
            symbols.functions.push(all.iter().map(gradient).collect());
        }
        let bent: Vec<Linear> = (model.deflections.iter().zip(&symbols.deflections))
            .map(|(deflection, straight)| straight.bent(&deflection.value.atom(), &symbols))
            .collect();
        symbols.deflections = bent;
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
