//! The functions of the jump rule of each law: n (the gradient of its phase), G = n.M⁻¹n, M⁻¹n/G, and dV (the step of the potential
//! energy).

use proc_macro2::TokenStream;
use quote::quote;
use syn::Index;

use crate::equations::cold::{Cold, Returns, Takes, in_any_number};
use crate::equations::lets::with_lets;
use crate::equations::model::{Jump, Law, Model};
use crate::equations::sums::{block, position, vector};

/// n, G and M⁻¹n/G. If the file does not give G or M⁻¹n/G, they are computed from M and n at run time.
pub fn jumps(m: &Model) -> [Cold; 3] {
    let normal = by_law(m, quote!(equations::no_such("law", law)), |law, jump| {
        Some(match jump.and_then(|j| j.normal.as_ref()) {
            Some(rows) => vector(m, rows),
            None => unit(m, law),
        })
    });
    let numeric = quote!(equations::compliance(&equations::matrix(&self.mass(met, q)), &self.normal(met, law).into()));
    let compliance = by_law(m, numeric, |_, jump| jump?.compliance.as_ref().map(block));
    let numeric = quote!(*equations::array(&equations::direction(
        &equations::matrix(&self.mass(met, q)),
        &self.normal(met, law).into()
    )));
    let direction = by_law(m, numeric, |_, jump| jump?.direction.as_ref().map(|rows| vector(m, rows)));
    let of_law = |name, returns, body| Cold { name, takes: &[Takes::Index("law")], returns, body };
    let at = |cold: Cold| Cold { takes: &[Takes::Index("law"), Takes::Coordinates("q")], ..cold };
    [
        of_law("normal", Returns::Vector, normal),
        at(of_law("compliance", Returns::Plain(quote!(f64)), compliance)),
        at(of_law("direction", Returns::Vector, direction)),
    ]
}

/// dV, in any kind of number.
pub fn step(m: &Model) -> Cold {
    let otherwise = quote!(equations::no_such("jump", law));
    let step = by_law(m, otherwise, |_, jump| jump?.step.as_ref().map(|sum| with_lets(m, block(sum))));
    Cold {
        name: "step",
        takes: &[Takes::Index("law"), Takes::Coordinates("q"), Takes::Values("k"), Takes::Number("dk")],
        returns: Returns::In(Clone::clone),
        body: in_any_number(step),
    }
}

/// A match over the laws, with an arm for each law for which `arm` gives code.
fn by_law(m: &Model, otherwise: TokenStream, arm: impl Fn(&Law, Option<&Jump>) -> Option<TokenStream>) -> TokenStream {
    let arms = m.laws.iter().enumerate().filter_map(|(i, law)| {
        let (i, arm) = (Index::from(i), arm(law, m.jumps.iter().find(|j| j.law == law.name))?);
        Some(quote!(#i => { #arm }))
    });
    quote!(match law { #(#arms)* _ => #otherwise })
}

/// The gradient of a phase, which is a coordinate: a unit vector.
fn unit(m: &Model, law: &Law) -> TokenStream {
    let (n, i) = (Index::from(m.coordinates.len()), position(m, &law.phase));
    quote!(let mut v = [0.0; #n]; v[#i] = 1.0; v)
}
