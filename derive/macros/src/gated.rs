//! Values that are constant in a cell and exist only with an effect: the symbols of dead bands, transmission errors, and friction
//! laws. The generated code has them as variables.

use syn::{Ident, Index};

use crate::model::{Law, Model, Role};

/// touch, edge, damp, clip if there is no dead band.
const NEUTRAL: [f64; 4] = [1.0, 0.0, 1.0, 0.0];

/// One such value: its name, its effect, its index in `k`, and its value without the effect.
pub struct Gated<'a> {
    pub name: &'a Ident,
    pub effect: &'a Ident,
    pub place: Index,
    pub neutral: f64,
}

/// All these values.
pub fn gated(m: &Model) -> impl Iterator<Item = Gated<'_>> {
    let laws = laws(m).filter_map(|(i, law)| {
        Some(Gated { name: &law.name, effect: law.with.as_ref()?, place: Index::from(i), neutral: 0.0 })
    });
    let bands = m.dead_bands.iter().enumerate().flat_map(move |(b, band)| {
        let first = m.laws.len() + 4 * b;
        band.symbols.iter().zip(NEUTRAL).enumerate().map(move |(s, (name, neutral))| Gated {
            name,
            effect: &band.effect,
            place: Index::from(first + s),
            neutral,
        })
    });
    laws.chain(bands)
}

/// The names of those that occur in deflections.
pub fn offsets(m: &Model) -> impl Iterator<Item = &Ident> {
    errors(m).map(|(_, law)| &law.name).chain(m.dead_bands.iter().map(|band| &band.symbols[1]))
}

/// The transmission errors, each with its index among the laws.
pub fn errors(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    laws(m).filter(|(_, law)| law.role == Role::Error)
}

fn laws(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    m.laws.iter().enumerate().filter(|(_, law)| law.with.is_some())
}
