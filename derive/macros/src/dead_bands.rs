//! The function `dead_band`, which describes a dead band to the engine.

use quote::quote;
use syn::Index;

use crate::cold::{Cold, Returns, Takes};
use crate::effects::is_met;
use crate::gated;
use crate::model::Model;

/// The function `dead_band` of `Equations`.
pub fn cold(m: &Model) -> Cold {
    let n = Index::from(m.coordinates.len());
    let arms = m.dead_bands.iter().enumerate().map(|(b, band)| {
        let (b, effect, half) = (Index::from(b), is_met(&band.effect), &band.half);
        let d = m.deflections.iter().position(|d| d.name == band.over).expect("checked");
        let (deflection, rate) = (&m.deflections[d].value, &m.rates[d].value);
        let errors = gated::errors(m).map(|(i, law)| {
            let units = gated::offsets(m).map(|name| {
                let unit = if *name == law.name { 1.0 } else { 0.0 };
                quote!(let #name = #unit;)
            });
            let law = Index::from(i);
            quote!((#law, { let q = [0.0; #n]; #(#units)* #deflection }),)
        });
        quote! {
            #b if #effect => {
                let normal: [f64; #n] = std::array::from_fn(|j| {
                    let q_dot: [f64; #n] = std::array::from_fn(|i| if i == j { 1.0 } else { 0.0 });
                    #rate
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
