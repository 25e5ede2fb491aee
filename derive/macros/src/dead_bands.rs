//! The function `dead_band`, which describes a dead band to the engine.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Index;

use crate::effects::constant;
use crate::gated;
use crate::model::Model;

/// The function `dead_band` of `Equations`: the normal, half the width, and the derivatives by transmission errors.
pub fn function(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let arms = m.dead_bands.iter().enumerate().map(|(b, band)| {
        let (b, effect, half) = (Index::from(b), constant(&band.effect), &band.half);
        let d = Index::from(m.deflections.iter().position(|d| d.name == band.over).expect("checked"));
        let errors = gated::errors(m).map(|(i, law)| {
            let units = gated::offsets(m).map(|name| if *name == law.name { quote!(1.0) } else { quote!(0.0) });
            let law = Index::from(i);
            quote!((#law, self.deflections(&[0.0; #n], #(#units),*)[#d]),)
        });
        quote! {
            #b if Self::#effect => {
                let normal = std::array::from_fn(|j| {
                    self.rates(&std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 }))[#d]
                });
                Some(equations::DeadBand { normal, half: #half, errors: vec![#(#errors)*] })
            }
        }
    });
    quote! {
        fn dead_band(&self, i: usize) -> Option<equations::DeadBand<#n>> {
            match i { #(#arms)* _ => None }
        }
    }
}
