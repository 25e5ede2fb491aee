//! Values that are constant in a cell and exist only with an effect: the symbols of switches, transmission errors, and friction
//! laws. The generated code has them as variables.

use syn::{Ident, Index};

use crate::equations::model::{Law, Model, Role};

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
    let symbols = m.switches.iter().flat_map(|switch| switch.symbols.iter().map(move |symbol| (switch, symbol)));
    let switched = symbols.enumerate().map(move |(s, (switch, (name, neutral)))| Gated {
        name,
        effect: &switch.effect,
        place: Index::from(m.laws.len() + s),
        neutral: *neutral,
    });
    laws.chain(switched)
}

/// The transmission errors, each with its index among the laws.
pub fn errors(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    laws(m).filter(|(_, law)| law.role == Role::Error)
}

fn laws(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    m.laws.iter().enumerate().filter(|(_, law)| law.with.is_some())
}
