//! The function `dead_band`, which describes a dead band to the engine.

use quote::quote;
use syn::Index;

use crate::cold::{Cold, Returns, Takes};
use crate::gated;
use crate::model::Model;
use crate::sums::Ask;

/// The function `dead_band` of `Equations`.
pub fn cold(m: &Model) -> Cold {
    let n = Index::from(m.coordinates.len());
    let arms = m.dead_bands.iter().enumerate().map(|(b, band)| {
        let (b, effect, half) = (Index::from(b), Ask::Running.tell(&band.effect), &band.half);
        let d = Index::from(m.deflections.iter().position(|d| d.name == band.over).expect("checked"));
        let errors = gated::errors(m).map(|(i, law)| {
            let units = gated::offsets(m).map(|name| if *name == law.name { quote!(1.0) } else { quote!(0.0) });
            let law = Index::from(i);
            quote!((#law, self.deflections(&[0.0; #n], #(#units),*)[#d]),)
        });
        quote! {
            #b if #effect => {
                let normal: [f64; #n] = std::array::from_fn(|j| {
                    self.rates(&std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 }))[#d]
                });
                Some(equations::DeadBand { normal: normal.into(), half: #half, errors: vec![#(#errors)*] })
            }
        }
    });
    Cold {
        name: "dead_band",
        takes: &[Takes::Index("i")],
        returns: Returns::Plain(quote!(Option<equations::DeadBand>)),
        body: quote!(match i { #(#arms)* _ => None }),
    }
}
