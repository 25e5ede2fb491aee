//! Named forces: variables in the generated code, each computed once for all rows that contain it.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::{Model, Row, Term};
use crate::sums::{Ask, block};

/// `let F = ..;` for each; zero if its effect is absent.
pub fn of_effects(m: &Model, ask: Ask) -> TokenStream {
    named(&m.forces, ask)
}

/// The same for the forces and their partial derivatives, for the Jacobian.
pub fn with_partials(m: &Model) -> TokenStream {
    let (forces, partials) = (of_effects(m, Ask::Running), named(&m.partials, Ask::Running));
    quote!(#forces #partials)
}

fn named(rows: &[Row], ask: Ask) -> TokenStream {
    let lets = rows.iter().map(|force| {
        let (name, value) = (&force.name, block(&force.sum, ask));
        quote!(let #name: f64 = #value;)
    });
    quote!(#(#lets)*)
}

/// The same for code that does not know the effects: without testing them.
pub fn of_values(m: &Model) -> TokenStream {
    let lets = m.forces.iter().map(|force| {
        let terms = force.sum.iter().map(|Term { value, .. }| value);
        let name = &force.name;
        quote!(let #name: f64 = #(#terms)+*;)
    });
    quote!(#(#lets)*)
}
