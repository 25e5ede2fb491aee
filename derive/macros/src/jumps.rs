//! What a jump of a law needs: n, G, M⁻¹n/G and dV.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Index;

use crate::functions::deflections;
use crate::model::{Jump, Law, Model};
use crate::sums::{block, position, vector};

/// The functions of `Equations` about jumps; what the file leaves out is computed from M and n.
pub fn jumps(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let normal = by_law(m, quote!(equations::no_such("law", law)), |law, jump| {
        Some(match jump.and_then(|j| j.normal.as_ref()) {
            Some(rows) => vector(m, rows),
            None => unit(m, law),
        })
    });
    let numeric = quote!(equations::compliance(&self.mass(), &self.normal(law)));
    let compliance = by_law(m, numeric, |_, jump| jump?.compliance.as_ref().map(block));
    let numeric = quote!(equations::direction(&self.mass(), &self.normal(law)));
    let direction = by_law(m, numeric, |_, jump| jump?.direction.as_ref().map(|rows| vector(m, rows)));
    let step = by_law(m, quote!(equations::no_such("jump", law)), |_, jump| jump?.step.as_ref().map(block));
    let (d, _) = deflections(m);
    quote! {
        fn normal(&self, law: usize) -> [f64; #n] { #normal }
        fn compliance(&self, law: usize) -> f64 { #compliance }
        fn direction(&self, law: usize) -> [f64; #n] { #direction }
        #[inline]
        fn step(&self, law: usize, q: &[f64; #n], dk: f64) -> f64 { #d #step }
    }
}

/// A match over the laws, with an arm for each law of which the file says something.
fn by_law(m: &Model, otherwise: TokenStream, arm: impl Fn(&Law, Option<&Jump>) -> Option<TokenStream>) -> TokenStream {
    let arms = m.laws.iter().enumerate().filter_map(|(i, law)| {
        let (i, arm) = (Index::from(i), arm(law, m.jumps.iter().find(|j| j.law == law.name))?);
        Some(quote!(#i => { #arm }))
    });
    quote!(match law { #(#arms)* _ => #otherwise })
}

/// The gradient of a phase that is a coordinate.
fn unit(m: &Model, law: &Law) -> TokenStream {
    let (n, i) = (Index::from(m.coordinates.len()), position(m, &law.phase));
    quote!(let mut v = [0.0; #n]; v[#i] = 1.0; v)
}
