//! Writes the code of a checked model.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Ident, Index};

use crate::cells::{any_number, matrices};
use crate::cold::cold;
use crate::describe::describe;
use crate::effects;
use crate::functions::functions;
use crate::gated;
use crate::hoist::hoist;
use crate::model::*;

/// All items that the macro defines for a model.
pub fn emit(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let name = camel_case(&m.name);
    let doc = format!("The model `{}`: {}.", m.name, m.title.value());
    let describe = describe(m);
    let sets = effects::sets(m).map(|set| effects::literal(m, set));
    let sets = quote!(#(#sets => Some(Box::new(With::<#sets>(numbers))),)*);
    let cold = cold(m);
    let mut hot = m.clone();
    let coefficients = hoist(&mut hot);
    let with = with(m, &coefficients);
    let (functions, shared) = functions(&hot, &cold);
    let conditions = effects::variables(m);
    let cold = cold.iter().map(|f| f.define(&conditions));
    let (constants, values) = (effects::constants(m), gated::count(m));
    let deflections = (!m.deflections.is_empty()).then(|| {
        let count = Index::from(m.deflections.len());
        let (values, rates) = (hot.deflections.iter().map(|d| &d.value), hot.rates.iter().map(|d| &d.value));
        let offsets = gated::offsets(m);
        quote! {
            #[inline]
            fn deflections(&self, q: &[f64; #n], #(#offsets: f64),*) -> [f64; #count] { [#(#values),*] }
            #[inline]
            fn rates(&self, q_dot: &[f64; #n]) -> [f64; #count] { [#(#rates),*] }
        }
    });
    quote! {
        use crate::engine::{equations, real};
        use crate::model;

        #[doc = #doc]
        #[derive(Debug, Clone, Copy)]
        pub struct #name;

        #[allow(clippy::all, reason = "numbers and code are written as derived")]
        impl equations::Derived<#n> for #name {
            const MODEL: model::Model = #describe;

            fn equations(effects: u32, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn equations::Equations<#n>>> {
                let numbers = Numbers::<f64>::new(parameters, mids);
                match effects {
                    #sets
                    _ => None,
                }
            }

            fn matrices<R: real::Real>(
                effects: u32, parameters: &[R], mids: &[R], k: &[R],
            ) -> equations::Matrices<#n, R> {
                Numbers::<R>::new(parameters, mids).matrices(effects, k)
            }
        }

        #with

        #[allow(dead_code, reason = "not every effect has its own terms")]
        impl<const E: u32> With<E> {
            #constants
            #values
        }

        #[allow(
            non_snake_case, unused_variables, clippy::all,
            reason = "code is written as derived, and most terms use few of the variables",
        )]
        impl Numbers<f64> {
            #deflections
            #(#shared)*
            #(#cold)*
        }

        #[allow(
            non_snake_case, unused_variables, clippy::all,
            reason = "code is written as derived, and most terms use few of the variables",
        )]
        impl<const E: u32> equations::Equations<#n> for With<E> {
            #functions
        }
    }
}

/// `struct Numbers<R>`, the numbers of a scene as type R, and `struct With<E>`, these numbers with the effects E as a type parameter.
fn with(m: &Model, coefficients: &[Expr]) -> TokenStream {
    let (fields, values) = (m.numbers(), m.numbers());
    let parameters = m.parameters.iter().enumerate().map(|(i, p)| {
        let (name, i) = (&p.name, Index::from(i));
        quote!(let #name = parameters[#i];)
    });
    let mids = m.stiffnesses().enumerate().map(|(i, law)| {
        let (name, i) = (law.mid(), Index::from(i));
        quote!(let #name = mids[#i];)
    });
    let constants = m.constants.iter().map(|Assignment { name, value }| {
        let value = any_number(value);
        quote!(let #name = #value;)
    });
    let matrices = matrices(m);
    let count = coefficients.len();
    let coefficients = coefficients.iter().map(any_number);
    quote! {
        /// The constant numbers in the equations, of type R: parameters, mid values, constants.
        #[allow(non_snake_case, dead_code, reason = "symbols of the source, some are unused")]
        struct Numbers<R> {
            #(#fields: R,)*
            /// Constant factors in the functions that are called at every step.
            coefficients: [R; #count],
            kind: std::marker::PhantomData<R>,
        }

        /// The equations with the effects E.
        struct With<const E: u32>(Numbers<f64>);

        impl<const E: u32> std::ops::Deref for With<E> {
            type Target = Numbers<f64>;

            #[inline(always)]
            fn deref(&self) -> &Numbers<f64> {
                &self.0
            }
        }

        #[allow(
            non_snake_case, unused_variables, unused_mut, clippy::all, reason = "symbols and constants of the source, some are unused",
        )]
        impl<R: real::Real> Numbers<R> {
            fn new(parameters: &[R], mids: &[R]) -> Self {
                #(#parameters)*
                #(#mids)*
                #(#constants)*
                let coefficients = [#(#coefficients),*];
                Self { #(#values,)* coefficients, kind: std::marker::PhantomData }
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
