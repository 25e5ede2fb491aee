//! Values that are constant in a cell and exist only with an effect: the symbols of dead bands, transmission errors, and friction
//! laws. The generated code has them as variables.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Ident, Index};

use crate::model::{Law, Model, Role};
use crate::sums::Ask;

/// touch, edge, damp, clip if there is no dead band.
const NEUTRAL: [f64; 4] = [1.0, 0.0, 1.0, 0.0];

/// One such value: its name, its effect, its index in `k`, and its value without the effect.
struct Gated<'a> {
    name: &'a Ident,
    effect: &'a Ident,
    place: Index,
    neutral: f64,
}

/// `let touch = ..;` for each: from `k` if its effect is present, else the neutral value.
pub fn of_effects(m: &Model, ask: Ask) -> TokenStream {
    let lets = all(m).map(|Gated { name, effect, place, neutral }| {
        let (there, neutral) = (ask.tell(effect), Literal::f64_suffixed(neutral));
        quote!(let #name = if #there { k[#place] } else { #neutral.into() };)
    });
    quote!(#(#lets)*)
}

/// The same for code that does not know the effects: always from `k`, which holds the neutral values too.
pub fn of_values(m: &Model) -> TokenStream {
    let lets = all(m).map(|Gated { name, place, .. }| quote!(let #name = k[#place];));
    quote!(#(#lets)*)
}

/// `const VALUES`: the length of `k` that the effects need.
pub fn count(m: &Model) -> TokenStream {
    let stiffnesses = m.stiffnesses().count();
    let more = all(m).map(|Gated { effect, place, .. }| {
        let there = Ask::Compiled.tell(effect);
        quote!(if #there && n <= #place { n = #place + 1; })
    });
    quote! {
        const VALUES: usize = {
            #[allow(unused_mut, reason = "unchanged if all laws are stiffnesses")]
            let mut n = #stiffnesses;
            #(#more)*
            n
        };
    }
}

/// The names of all these values.
pub fn names(m: &Model) -> impl Iterator<Item = &Ident> {
    all(m).map(|gated| gated.name)
}

/// The names of those that occur in deflections, in the order of the arguments of the generated function `deflections`.
pub fn offsets(m: &Model) -> impl Iterator<Item = &Ident> {
    errors(m).map(|(_, law)| &law.name).chain(m.dead_bands.iter().map(|band| &band.symbols[1]))
}

/// The transmission errors, each with its index among the laws.
pub fn errors(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    gated(m).filter(|(_, law)| law.role == Role::Error)
}

fn gated(m: &Model) -> impl Iterator<Item = (usize, &Law)> {
    m.laws.iter().enumerate().filter(|(_, law)| law.with.is_some())
}

fn all(m: &Model) -> impl Iterator<Item = Gated<'_>> {
    let laws = gated(m).filter_map(|(i, law)| {
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
