//! From a checked model to code.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Ident, Index};

use crate::describe::describe;
use crate::effects::{self, constant, has};
use crate::model::*;
use crate::scope::speed;

/// Everything that a generated file holds.
pub fn emit(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let name = camel_case(&m.name);
    let doc = format!("The model `{}`: {}.", m.name, m.title.value());
    let describe = describe(m);
    let sets = effects::sets(m).map(|set| effects::literal(m, set));
    let sets = quote!(#(#sets => Some(Box::new(With::<#sets>::new(parameters, mids))),)*);
    let with = with(m);
    let functions = functions(m);
    let constants = effects::constants(m);
    quote! {
        use crate::engine::equations;
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
        }

        #with

        #[allow(dead_code, reason = "not every effect has a term of its own")]
        impl<const E: u32> With<E> {
            #constants
        }

        #[allow(unused_variables, clippy::all, reason = "code as the derivation wrote it; many a term uses little")]
        impl<const E: u32> equations::Equations<#n> for With<E> {
            #functions
        }
    }
}

/// `struct With<E>`: the numbers of the equations with the effects E.
fn with(m: &Model) -> TokenStream {
    let names = || {
        m.parameters
            .iter()
            .map(|p| &p.name)
            .chain(m.constants.iter().map(|c| &c.name))
    };
    let (fields, values) = (names(), names());
    let parameters = m.parameters.iter().enumerate().map(|(i, p)| {
        let (name, i) = (&p.name, Index::from(i));
        quote!(let #name = parameters[#i];)
    });
    let constants = m
        .constants
        .iter()
        .map(|Assignment { name, value }| quote!(let #name = #value;));
    quote! {
        /// The equations with the effects E.
        #[allow(non_snake_case, dead_code, reason = "the symbols of the source, used or not")]
        struct With<const E: u32> {
            #(#fields: f64,)*
        }

        #[allow(non_snake_case, unused_variables, clippy::all, reason = "the symbols and constants of the source")]
        impl<const E: u32> With<E> {
            fn new(parameters: &[f64], mids: &[f64]) -> Self {
                #(#parameters)*
                #(#constants)*
                Self { #(#values),* }
            }
        }
    }
}

/// The functions of `Equations`.
fn functions(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let (kinetic, potential, dissipation) =
        (body(&m.kinetic), body(&m.potential), body(&m.dissipation));
    let torque_work = by_index(
        "torque",
        format_ident!("i"),
        m.torques.iter().map(|t| block(&t.work)),
    );
    let work = body(&work(m));
    let motion = by_index(
        "motion",
        format_ident!("i"),
        m.motions.iter().map(|x| motion(m, x)),
    );
    let (mass, damping, stiffness) = (
        matrix(m, &m.mass),
        matrix(m, &m.damping),
        matrix(m, &m.stiffness),
    );
    let load = vector(m, &m.load);
    let force = vector(m, m.force.iter().flatten());
    let acceleration = m.acceleration.as_ref().map(|rows| {
        let a = vector(m, rows);
        quote! {
            #[inline]
            fn acceleration(&self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64]) -> [f64; #n] { #a }
        }
    });
    let jacobian = jacobian(m);
    let switching = switching(m);
    let jumps = crate::jumps::jumps(m);
    quote! {
        #[inline]
        fn kinetic(&self, q_dot: &[f64; #n]) -> f64 { #kinetic }
        #[inline]
        fn potential(&self, q: &[f64; #n], k: &[f64]) -> f64 { #potential }
        #[inline]
        fn dissipation(&self, q_dot: &[f64; #n]) -> f64 { #dissipation }
        #[inline]
        fn torque_work(&self, i: usize, dq: &[f64; #n]) -> f64 { #torque_work }
        #[inline]
        fn work(&self, dq: &[f64; #n]) -> f64 { #work }
        #[inline]
        fn force(&self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64]) -> [f64; #n] { #force }
        #acceleration
        fn jacobian(
            &self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64], ddk: &[f64],
        ) -> [[[f64; #n]; #n]; 2] { #jacobian }
        fn mass(&self) -> [[f64; #n]; #n] { #mass }
        fn damping(&self) -> [[f64; #n]; #n] { #damping }
        fn stiffness(&self, k: &[f64]) -> [[f64; #n]; #n] { #stiffness }
        fn load(&self) -> [f64; #n] { #load }
        fn motion(&self, i: usize) -> [f64; #n] { #motion }
        #[inline]
        fn switching(&self, law: usize) -> equations::Switching { #switching }
        #jumps
    }
}

/// The net work: every generalised force times the change of its coordinate.
fn work(m: &Model) -> Sum {
    let terms = m.work.iter().flat_map(|row| {
        let i = position(m, &row.name);
        row.sum.iter().map(move |t| {
            let force = &t.value;
            Term {
                condition: t.condition.clone(),
                value: syn::parse_quote!((#force) * dq[#i]),
            }
        })
    });
    terms.collect()
}

fn motion(m: &Model, motion: &Motion) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let speeds = motion.speeds.iter().map(|Assignment { name, value }| {
        let i = m
            .coordinates
            .iter()
            .position(|c| speed(&c.name) == name.to_string())
            .map(Index::from);
        quote!(q_dot[#i] = #value;)
    });
    quote!({ let mut q_dot = [0.0; #n]; #(#speeds)* q_dot })
}

/// The derivatives by coordinates, then those by speeds.
fn jacobian(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = m.jacobian.iter().flatten().map(|e| {
        let by_speed = m
            .coordinates
            .iter()
            .position(|c| speed(&c.name) == e.column.to_string());
        let (which, j) = match by_speed {
            Some(j) => (Index::from(1), Index::from(j)),
            None => (Index::from(0), position(m, &e.column)),
        };
        let (i, value) = (position(m, &e.row), block(&e.sum));
        quote!(j[#which][#i][#j] = #value;)
    });
    quote!(let mut j = [[[0.0; #n]; #n]; 2]; #(#entries)* j)
}

fn switching(m: &Model) -> TokenStream {
    let otherwise = |effect: &str, case: TokenStream| {
        has(m, effect).then(|| {
            let name = format_ident!("{}", effect.to_uppercase());
            quote!(if Self::#name { equations::Switching::#case } else)
        })
    };
    if !has(m, effects::STIFFNESS_STEP) {
        return quote!(equations::Switching::Never);
    }
    let step = format_ident!("{}", effects::STIFFNESS_STEP.to_uppercase());
    let by_time = otherwise(effects::FROZEN_PHASE, quote!(ByTime));
    let without = otherwise(effects::RIGID_KINEMATICS, quote!(WithoutJump));
    quote! {
        if !Self::#step { equations::Switching::Never } else #by_time #without { equations::Switching::WithJump }
    }
}

/// The statements of a function that returns a vector: what has no row is zero.
pub fn vector<'a>(m: &Model, rows: impl IntoIterator<Item = &'a Row>) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let rows = rows.into_iter().filter(|r| !r.sum.is_empty()).map(|r| {
        let (i, value) = (position(m, &r.name), block(&r.sum));
        quote!(v[#i] = #value;)
    });
    quote!(let mut v = [0.0; #n]; #(#rows)* v)
}

/// The statements of a function that returns a symmetric matrix, given by one of its triangles.
fn matrix(m: &Model, entries: &[Entry]) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = entries.iter().map(|e| {
        let (i, j, value) = (position(m, &e.row), position(m, &e.column), block(&e.sum));
        let mirror = (i != j).then(|| quote!(m[#j][#i] = m[#i][#j];));
        quote!(m[#i][#j] = #value; #mirror)
    });
    quote!(let mut m = [[0.0; #n]; #n]; #(#entries)* m)
}

/// The statements of a function that returns a sum; a term whose effect is absent is absent from the code.
pub fn body(sum: &Sum) -> TokenStream {
    let (first, rest) = match &sum[..] {
        [] => return quote!(0.0),
        [
            Term {
                condition: None,
                value,
            },
        ] => return quote!(#value),
        [
            Term {
                condition: None,
                value,
            },
            rest @ ..,
        ] => (quote!(#value), rest),
        all => (quote!(0.0), all),
    };
    let terms =
        rest.iter().map(
            |Term { condition, value }| match condition.as_ref().map(constant) {
                Some(condition) => quote!(if Self::#condition { sum += #value; }),
                None => quote!(sum += #value;),
            },
        );
    quote!(let mut sum = #first; #(#terms)* sum)
}

/// A sum as an expression.
pub fn block(sum: &Sum) -> TokenStream {
    let body = body(sum);
    if matches!(
        &sum[..],
        [] | [Term {
            condition: None,
            ..
        }]
    ) {
        body
    } else {
        quote!({ #body })
    }
}

/// `match i { 0 => .., 1 => .., _ => no_such("torque", i) }`
pub fn by_index(kind: &str, i: Ident, arms: impl Iterator<Item = TokenStream>) -> TokenStream {
    let arms = arms.enumerate().map(|(at, arm)| {
        let at = Index::from(at);
        quote!(#at => #arm,)
    });
    quote!(match #i { #(#arms)* _ => equations::no_such(#kind, #i) })
}

/// The index of a coordinate; `check` has seen to it that there is one.
pub fn position(m: &Model, name: &Ident) -> Index {
    Index::from(
        m.coordinates
            .iter()
            .position(|c| c.name == *name)
            .expect("checked"),
    )
}

/// `GearPair` for `gear_pair`.
fn camel_case(name: &Ident) -> Ident {
    let upper = |word: &str| word[..1].to_uppercase() + &word[1..];
    let name_in_camel_case: String = name
        .to_string()
        .split('_')
        .filter(|w| !w.is_empty())
        .map(upper)
        .collect();
    Ident::new(&name_in_camel_case, name.span())
}
