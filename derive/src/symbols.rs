//! The symbols of a model, and derivatives by them. A derivative is taken only by symbols that occur in the expression, so that
//! the gradient of one spring costs the same in a model of any size.

use std::collections::{BTreeMap, HashMap};

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Kind, kind_and_name, number, partial_name, speed_name, symbol, total};
use crate::model::{DeadBand, Deflection, Model};

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
}

/// A named force, differentiated by name: its derivatives are written in its partial derivatives.
pub(crate) struct Force {
    /// The partial derivatives: name and value.
    pub partials: Vec<(String, Atom)>,
    by_coordinates: Sparse,
    by_speeds: Sparse,
    by_laws: Sparse,
}

/// A named deflection, delta = sum_i slope_i q_i + rest, and its rate, delta' = sum_i slope_i q'_i.
pub(crate) struct Linear {
    pub symbol: Symbol,
    pub rate_symbol: Symbol,
    /// Its derivatives by coordinates.
    pub slopes: Sparse,
    /// Its value at q = 0: minus the edge of a dead band, minus transmission errors.
    pub rest: Atom,
    /// Its derivatives by laws.
    pub by_law: Sparse,
    /// For a dead band: the symbol `clip` of its damper times the marker of its effect.
    pub clip: Option<Atom>,
}

impl Linear {
    fn new(model: &Model, d: &Deflection, places: &HashMap<Symbol, Place>) -> Linear {
        let value = d.value.atom();
        let (mut slopes, mut by_law, mut rest) = (vec![], vec![], value.clone());
        for (symbol, place) in present(&value, places) {
            let slope = value.derivative(symbol).expand();
            match place {
                Place::Coordinate(i) => {
                    slopes.push((i, slope));
                    rest = rest.replace(Atom::var(symbol).to_pattern()).with(number(0).to_pattern());
                }
                Place::Law(l) => by_law.push((l, slope)),
                _ => {}
            }
        }
        let band: Option<&DeadBand> = model.dead_bands.iter().find(|band| band.over == d.name);
        Linear {
            symbol: symbol(Kind::Deflection, &d.name),
            rate_symbol: symbol(Kind::Rate, &speed_name(&d.name)),
            slopes,
            rest: rest.expand(),
            by_law,
            clip: band
                .map(|band| Atom::var(symbol(Kind::Marker, &band.effect)) * Atom::var(symbol(Kind::Clip, &band.clip))),
        }
    }

    /// The deflection, written in the coordinates `q`.
    pub fn of(&self, q: &[Symbol]) -> Atom {
        self.rate(q) + &self.rest
    }

    /// Its rate, written in the speeds `v`.
    pub fn rate(&self, v: &[Symbol]) -> Atom {
        self.slopes.iter().fold(number(0), |sum, (i, slope)| sum + slope * Atom::var(v[*i]))
    }
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
        let deflections: Vec<Linear> = model.deflections.iter().map(|d| Linear::new(model, d, &places)).collect();
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
            places,
        };
        for (f, force) in model.forces.iter().enumerate() {
            // A force may contain those before it.
            let partials = symbols.force(&force.name, &force.value.atom());
            symbols.forces.push(partials);
            symbols.places.insert(symbol(Kind::Force, &force.name), Place::Force(f));
        }
        symbols.phase = model.laws.iter().map(|law| symbols.by_coordinates(&law.phase.atom())).collect();
        symbols
    }

    /// The partial derivatives of a force, and its gradients in their names.
    fn force(&self, name: &str, value: &Atom) -> Force {
        let mut partials = vec![];
        // The force as a sum of its partial derivatives times its symbols has these gradients.
        let mut linear = vec![];
        for (s, _) in self.present(value) {
            let partial = partial_name(name, &kind_and_name(s).1);
            linear.push(Atom::var(symbol(Kind::Partial, &partial)) * Atom::var(s));
            partials.push((partial, value.derivative(s)));
        }
        let linear = total(linear);
        Force {
            partials,
            by_coordinates: self.by_coordinates(&linear),
            by_speeds: self.by_speeds(&linear),
            by_laws: self.by_laws(&linear),
        }
    }

    /// The symbols of an expression that have a place, by their places.
    pub fn present(&self, e: &Atom) -> Vec<(Symbol, Place)> {
        present(e, &self.places)
    }

    /// Sums the derivatives by the symbols of `e`, each times what `parts` gives for its place.
    fn chain<'a>(&'a self, e: &Atom, parts: impl Fn(Place) -> Option<Part<'a>>) -> Sparse {
        let mut sum: BTreeMap<usize, Atom> = BTreeMap::new();
        let mut add = |i, part: Atom| {
            let entry = sum.entry(i).or_insert_with(|| number(0));
            *entry = &*entry + part;
        };
        for (symbol, place) in self.present(e) {
            match parts(place) {
                Some(Part::Itself(i)) => add(i, e.derivative(symbol)),
                Some(Part::Through(inner)) => {
                    let outer = e.derivative(symbol);
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
            Place::Coordinate(i) => Some(Part::Itself(i)),
            Place::Deflection(d) => Some(Part::Through(&self.deflections[d].slopes)),
            Place::Force(f) => Some(Part::Through(&self.forces[f].by_coordinates)),
            _ => None,
        })
    }

    /// The gradient by the speeds, including the derivatives through the rates of deflections.
    pub fn by_speeds(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Place::Speed(i) => Some(Part::Itself(i)),
            Place::Rate(d) => Some(Part::Through(&self.deflections[d].slopes)),
            Place::Force(f) => Some(Part::Through(&self.forces[f].by_speeds)),
            _ => None,
        })
    }

    /// The derivatives by the values of laws, including those through deflections.
    pub fn by_laws(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Place::Law(l) => Some(Part::Itself(l)),
            Place::Deflection(d) => Some(Part::Through(&self.deflections[d].by_law)),
            Place::Force(f) => Some(Part::Through(&self.forces[f].by_laws)),
            _ => None,
        })
    }

    /// The derivatives by the slopes of laws.
    pub fn slopes(&self, e: &Atom) -> Sparse {
        self.chain(e, |place| match place {
            Place::Slope(l) => Some(Part::Itself(l)),
            _ => None,
        })
    }

    /// The clipped damper forces of dead bands that belong to the potential energy `e`, to be added to its gradient.
    pub fn clipped(&self, e: &Atom) -> Sparse {
        let bands = self.present(e).into_iter().filter_map(|(symbol, place)| match place {
            Place::Deflection(d) => Some((&self.deflections[d], self.deflections[d].clip.as_ref()?, symbol)),
            _ => None,
        });
        let rows = bands.flat_map(|(d, clip, symbol)| {
            let force = clip * e.derivative(symbol);
            d.slopes.iter().map(move |(i, slope)| (*i, &force * slope)).collect::<Sparse>()
        });
        rows.collect()
    }

    /// The expression after law `l` has stepped by an amount written as the symbol of its slope, including the step of
    /// deflections; `None` if the law is not in it.
    pub fn stepped(&self, e: &Atom, l: usize) -> Option<Atom> {
        let step = Atom::var(self.slope[l]);
        let moved = self.present(e).into_iter().filter_map(|(symbol, place)| {
            let by = match place {
                Place::Law(law) if law == l => step.clone(),
                Place::Deflection(d) => &self.deflections[d].by_law.iter().find(|(law, _)| *law == l)?.1 * &step,
                _ => return None,
            };
            Some((symbol, by))
        });
        moved.fold(None, |e_so_far, (symbol, by)| {
            let (e, symbol) = (e_so_far.unwrap_or_else(|| e.clone()), Atom::var(symbol));
            Some(e.replace(symbol.to_pattern()).with((&symbol + by).to_pattern()))
        })
    }
}

/// How an expression depends on what it is differentiated by, through one of its symbols.
enum Part<'a> {
    /// The symbol is what it is differentiated by, with this index.
    Itself(usize),
    /// The symbol depends on it with these derivatives.
    Through(&'a Sparse),
}
