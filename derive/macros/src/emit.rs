//! From a checked model to code: the items of a generated file.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Ident, Index};

use crate::describe::describe;
use crate::effects;
use crate::functions::functions;
use crate::matrices::{any_number, matrices};
use crate::model::*;

/// Everything that a generated file holds.
pub fn emit(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let name = camel_case(&m.name);
    let doc = format!("The model `{}`: {}.", m.name, m.title.value());
    let describe = describe(m);
    let sets = effects::sets(m).map(|set| effects::literal(m, set));
    let sets = quote!(#(#sets => Some(Box::new(With::<#sets, f64>::new(parameters, mids))),)*);
    let with = with(m);
    let functions = functions(m);
    let constants = effects::constants(m);
    quote! {
        use crate::engine::{equations, real};
        use crate::model;

        #[doc = #doc]
        #[derive(Debug, Clone, Copy)]
        pub struct #name;

        #[allow(clippy::all, reason = "numbers and code as the derivation wrote them")]
        impl equations::Derived<#n> for #name {
            const MODEL: model::Model = #describe;

            fn equations(effects: u32, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn equations::Equations<#n>>> {
                match effects {
                    #sets
                    _ => None,
                }
            }

            fn matrices<R: real::Real>(
                effects: u32, parameters: &[R], mids: &[R], k: &[R],
            ) -> equations::Matrices<#n, R> {
                With::<0, R>::new(parameters, mids).matrices(effects, k)
            }
        }

        #with

        #[allow(dead_code, reason = "not every effect has a term of its own")]
        impl<const E: u32, R> With<E, R> {
            #constants
        }

        #[allow(unused_variables, clippy::all, reason = "code as the derivation wrote it; many a term uses little")]
        impl<const E: u32> equations::Equations<#n> for With<E, f64> {
            #functions
        }
    }
}

/// `struct With<E, R>`: the numbers of the equations with the effects E.
fn with(m: &Model) -> TokenStream {
    let names = || m.parameters.iter().map(|p| &p.name).chain(m.constants.iter().map(|c| &c.name));
    let (fields, values) = (names(), names());
    let parameters = m.parameters.iter().enumerate().map(|(i, p)| {
        let (name, i) = (&p.name, Index::from(i));
        quote!(let #name = parameters[#i];)
    });
    let constants = m.constants.iter().map(|Assignment { name, value }| {
        let value = any_number(value);
        quote!(let #name = #value;)
    });
    let matrices = matrices(m);
    quote! {
        /// The equations with the effects E, in numbers of the kind R.
        #[allow(non_snake_case, dead_code, reason = "the symbols of the source, used or not")]
        struct With<const E: u32, R> {
            #(#fields: R,)*
            kind: std::marker::PhantomData<R>,
        }

        #[allow(
            non_snake_case, unused_variables, unused_mut, clippy::all, reason = "the symbols and constants of the source",
        )]
        impl<const E: u32, R: real::Real> With<E, R> {
            fn new(parameters: &[R], mids: &[R]) -> Self {
                #(#parameters)*
                #(#constants)*
                Self { #(#values,)* kind: std::marker::PhantomData }
            }

            #matrices
        }
    }
}

/// `GearPair` for `gear_pair`.
fn camel_case(name: &Ident) -> Ident {
    let upper = |word: &str| word[..1].to_uppercase() + &word[1..];
    let name_in_camel_case: String = name.to_string().split('_').filter(|w| !w.is_empty()).map(upper).collect();
    Ident::new(&name_in_camel_case, name.span())
}
