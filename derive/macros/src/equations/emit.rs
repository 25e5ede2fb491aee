//! Writes the code of a checked model.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Ident, Index};

use crate::equations::cells::{any_number, cells, matrices};
use crate::equations::cold::{Cold, cold};
use crate::equations::describe::describe;
use crate::equations::effects;
use crate::equations::hoist::hoist;
use crate::equations::model::*;
use crate::equations::terms::{Terms, functions};
use crate::equations::variants::Variants;

/// All items that the macro defines for a model.
pub fn emit(mut m: Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let name = camel_case(&m.name);
    let doc = format!("The model `{}`: {}.", m.name, m.title.value());
    let describe = describe(&m);
    let (mut force, mut dissipation) = (Terms::of_force(&m), Terms::of_dissipation(&m));
    let terms = force.values().chain(dissipation.values());
    let of_positions = m.functions.iter_mut().map(|f| &mut f.value);
    let variables = m.deflections.iter_mut().chain(&mut m.rates).map(|d| &mut d.value).chain(of_positions);
    let forces = m.forces.iter_mut().flat_map(|force| force.sum.iter_mut().map(|term| &mut term.value));
    let coefficients = hoist(variables.chain(forces).chain(terms).collect());
    // Hoisting has changed the names in the values of variables, so the stored names are discarded.
    m.variables.take();
    let m = &m;
    let cells = cells(m);
    let numbers = numbers(m, &coefficients, &cells);
    let variants = Variants::of(m);
    let functions = functions(m, &variants, &force, &dissipation);
    let cold = cold(m);
    let calls = cells.iter().chain(&cold).map(Cold::call).collect::<Vec<_>>();
    let cold = cold.iter().map(|f| f.define(m, &quote!(f64)));
    let met = effects::met(m);
    let equations = equations(&variants);
    let exactly = exactly(m);
    quote! {
        use ::gearsim::__private::{Effects, Matrix, Vector, equations, model, real};

        #[doc = #doc]
        #[derive(Debug, Clone, Copy)]
        pub struct #name;

        #[allow(clippy::all, reason = "numbers and code are written as derived")]
        impl equations::Derived for #name {
            const MODEL: model::Model = #describe;

            fn equations(effects: &Effects, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn equations::Equations>> {
                let equations = || Equations::new(Numbers::new(parameters, mids), Met::new(effects));
                effects.agree(&Self::MODEL).then(|| Box::new(equations()) as Box<dyn equations::Equations>)
            }

            fn matrices<R: real::Real>(effects: &Effects, parameters: &[R], mids: &[R], k: &[R]) -> equations::Matrices<R> {
                Numbers::<R>::new(parameters, mids).matrices(&Met::new(effects), equations::values(k))
            }

            fn exactly(
                effects: &Effects, parameters: &[real::Df64], mids: &[real::Df64],
            ) -> Box<dyn equations::ExactCells> {
                let numbers = Numbers::new(&equations::numbers(parameters), &equations::numbers(mids));
                Box::new(Exactly { numbers, met: Met::new(effects) })
            }
        }

        #numbers

        #met

        #exactly

        #equations

        #[allow(
            non_snake_case, unused_variables, clippy::all,
            reason = "code is written as derived, and most terms use few of the variables",
        )]
        impl Numbers<f64> {
            #functions
            #(#cold)*
        }

        impl equations::Equations for Equations {
            fn coordinates(&self) -> usize { #n }
            fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
                (self.force)(self, q, q_dot, k, dk, force);
            }
            fn dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
                (self.dissipation)(self, q, q_dot, k)
            }
            #(#calls)*
        }
    }
}

/// `struct Equations`. It holds the functions that are called at every step, in the variant of the scene.
fn equations(variants: &Variants) -> TokenStream {
    let (parameters, arguments) = (variants.parameters(), variants.arguments());
    let choice = variants.choice(|variant| quote!((Self::force_in::<#variant>, Self::dissipation_in::<#variant>)));
    quote! {
        /// The equations of a scene.
        struct Equations {
            numbers: Numbers<f64>,
            met: Met,
            force: Force,
            dissipation: Dissipation,
        }

        type Force = fn(&Equations, &[f64], &[f64], &[f64], &[f64], &mut [f64]);
        type Dissipation = fn(&Equations, &[f64], &[f64], &[f64]) -> f64;

        impl Equations {
            fn new(numbers: Numbers<f64>, met: Met) -> Self {
                let (force, dissipation): (Force, Dissipation) = #choice;
                Self { numbers, met, force, dissipation }
            }

            fn force_in<#parameters>(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
                let (q, q_dot, force) = (equations::array(q), equations::array(q_dot), equations::array_mut(force));
                self.numbers.force::<#arguments>(&self.met, q, q_dot, equations::values(k), equations::values(dk), force);
            }

            fn dissipation_in<#parameters>(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
                let (q, q_dot, k) = (equations::array(q), equations::array(q_dot), equations::values(k));
                self.numbers.dissipation::<#arguments>(&self.met, q, q_dot, k)
            }
        }
    }
}

/// The cells of a scene in double-double numbers.
fn exactly(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let switches = (!m.switches.is_empty()).then(|| {
        quote! {
            fn mode(&self, i: usize, mode: usize) -> Option<Vec<real::Df64>> {
                self.numbers.mode(&self.met, i, mode).as_deref().map(equations::numbers)
            }
            fn exits(&self, i: usize, mode: usize, k: &[real::Df64]) -> Vec<equations::Exit<real::Df64>> {
                let at = [real::Double::from(0.0); #n];
                let exits = self.numbers.exits(&self.met, i, mode, &at, equations::values(&equations::numbers(k)));
                exits.iter().map(equations::Exit::in_numbers).collect()
            }
            fn switched(&self, i: usize, k: &[real::Df64]) -> equations::Deflection<real::Df64> {
                let at = [real::Double::from(0.0); #n];
                let switched = self.numbers.switched(&self.met, i);
                self.numbers.deflection(&self.met, switched, &at, equations::values(&equations::numbers(k))).in_numbers()
            }
        }
    });
    quote! {
        /// The cells of a scene in double-double numbers.
        struct Exactly {
            numbers: Numbers<real::Double>,
            met: Met,
        }

        impl equations::ExactCells for Exactly {
            fn matrices(&self, k: &[real::Df64]) -> equations::Matrices<real::Df64> {
                self.numbers.matrices(&self.met, equations::values(&equations::numbers(k))).in_numbers()
            }
            fn potential(&self, q: &[real::Df64], k: &[real::Df64]) -> real::Df64 {
                let (q, k) = (equations::numbers(q), equations::numbers(k));
                self.numbers.potential(&self.met, equations::array(&q), equations::values(&k)).into()
            }
            fn step(&self, law: usize, q: &[real::Df64], k: &[real::Df64], dk: real::Df64) -> real::Df64 {
                let (q, k) = (equations::numbers(q), equations::numbers(k));
                self.numbers.step(&self.met, law, equations::array(&q), equations::values(&k), dk.into()).into()
            }
            #switches
        }
    }
}

/// `struct Numbers<R>`, of numbers of type R.
fn numbers(m: &Model, coefficients: &[Expr], cells: &[Cold]) -> TokenStream {
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
    let matrices = matrices(m, cells);
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
