//! Dead bands: their constants in a cell, as variables, and what the engine asks of them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Index;

use crate::effects::constant;
use crate::model::{DeadBand, Model};
use crate::sums::Ask;

/// touch, edge, damp, clip where a dead band is not there.
const NEUTRAL: [f64; 4] = [1.0, 0.0, 1.0, 0.0];

/// `let touch = ..;` for each symbol: from behind the laws in `k` where its effect is there, else what it then is.
pub fn of_effects(m: &Model, ask: Ask) -> TokenStream {
    let lets = symbols(m).map(|(band, symbol, i, neutral)| {
        let (there, name) = (ask.tell(&band.effect), &band.symbols[symbol]);
        quote!(let #name = if #there { k[#i] } else { #neutral.into() };)
    });
    quote!(#(#lets)*)
}

/// The same where the effects are not known: `k` holds what the symbols are then, too.
pub fn of_values(m: &Model) -> TokenStream {
    let lets = symbols(m).map(|(band, symbol, i, _)| {
        let name = &band.symbols[symbol];
        quote!(let #name = k[#i];)
    });
    quote!(#(#lets)*)
}

/// Every symbol of every band with its place in `k`.
fn symbols(m: &Model) -> impl Iterator<Item = (&DeadBand, usize, Index, Literal)> {
    m.dead_bands.iter().enumerate().flat_map(move |(b, band)| {
        let place = move |s: usize| (band, s, Index::from(m.laws.len() + 4 * b + s), Literal::f64_suffixed(NEUTRAL[s]));
        (0..4).map(place)
    })
}

/// The edges, to be handed to `deflections`.
pub fn edges(m: &Model) -> impl Iterator<Item = &syn::Ident> {
    m.dead_bands.iter().map(|band| &band.symbols[1])
}

/// The function `dead_band` of `Equations`.
pub fn function(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let arms = m.dead_bands.iter().enumerate().map(|(b, band)| {
        let (b, effect, half) = (Index::from(b), constant(&band.effect), &band.half);
        let d = Index::from(m.deflections.iter().position(|d| d.name == band.over).expect("checked"));
        quote! {
            #b if Self::#effect => {
                let normal = std::array::from_fn(|j| {
                    self.rates(&std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 }))[#d]
                });
                Some(equations::DeadBand { normal, half: #half })
            }
        }
    });
    quote! {
        fn dead_band(&self, i: usize) -> Option<equations::DeadBand<#n>> {
            match i { #(#arms)* _ => None }
        }
    }
}
