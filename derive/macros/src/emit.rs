//! Writes the code of a checked model.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Ident, Index};

use crate::cells::{any_number, cells, matrices};
use crate::cold::{Cold, cold};
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
    let cold = cold(m);
    let mut hot = m.clone();
    let coefficients = hoist(&mut hot);
    let numbers = numbers(m, &coefficients);
    let functions = functions(&hot);
    let calls = cells(m).iter().chain(&cold).map(Cold::call).collect::<Vec<_>>();
    let cold = cold.iter().map(|f| f.define(m, &quote!(f64)));
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
        use crate::engine::{equations, real, vector::{Matrix, Vector}};
        use crate::model;

        #[doc = #doc]
        #[derive(Debug, Clone, Copy)]
        pub struct #name;

        #[allow(clippy::all, reason = "numbers and code are written as derived")]
        impl equations::Derived for #name {
            const MODEL: model::Model = #describe;

            fn equations(effects: u32, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn equations::Equations>> {
                let with = match effects {
                    #(#sets => With::<#sets>::equations,)*
                    _ => return None,
                };
                Some(Box::new(with(Numbers::<f64>::new(parameters, mids))))
            }

            fn matrices<R: real::Real>(effects: u32, parameters: &[R], mids: &[R], k: &[R]) -> equations::Matrices<R> {
                Numbers::<R>::new(parameters, mids).matrices(effects, k)
            }
        }

        #numbers

        /// The equations with a set of effects.
        struct Equations {
            numbers: Numbers<f64>,
            effects: u32,
            force: fn(&Numbers<f64>, &[f64; #n], &[f64; #n], &[f64], &[f64], &mut [f64; #n]),
            dissipation: fn(&Numbers<f64>, &[f64; #n], &[f64]) -> f64,
            step: fn(&Numbers<f64>, usize, &[f64; #n], &[f64], f64) -> f64,
        }

        /// The set of effects E.
        struct With<const E: u32>;

        #[allow(dead_code, reason = "not every effect has its own terms")]
        impl<const E: u32> With<E> {
            #constants
            #values

            fn equations(numbers: Numbers<f64>) -> Equations {
                Equations {
                    numbers,
                    effects: E,
                    force: Numbers::force::<E>,
                    dissipation: Numbers::dissipation::<E>,
                    step: Numbers::step::<E>,
                }
            }
        }

        #[allow(
            non_snake_case, unused_variables, clippy::all,
            reason = "code is written as derived, and most terms use few of the variables",
        )]
        impl Numbers<f64> {
            #deflections
            #functions
            #(#cold)*
        }

        impl equations::Equations for Equations {
            fn coordinates(&self) -> usize { #n }
            fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
                let (q, q_dot) = (equations::array(q), equations::array(q_dot));
                (self.force)(&self.numbers, q, q_dot, k, dk, equations::array_mut(force));
            }
            fn dissipation(&self, q_dot: &[f64], k: &[f64]) -> f64 {
                (self.dissipation)(&self.numbers, equations::array(q_dot), k)
            }
            fn step(&self, law: usize, q: &[f64], k: &[f64], dk: f64) -> f64 {
                (self.step)(&self.numbers, law, equations::array(q), k, dk)
            }
            #(#calls)*
        }
    }
}

/// `struct Numbers<R>`, of numbers of type R.
fn numbers(m: &Model, coefficients: &[Expr]) -> TokenStream {
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
