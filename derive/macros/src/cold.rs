//! The functions that are not called at every step. Each is compiled once for a model and tests the effects at run time, so that the
//! code for a set of effects only calls it.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Ident, Index};

use crate::effects::{self, has};
use crate::forces;
use crate::functions::deflections;
use crate::gated;
use crate::jumps::jumps;
use crate::model::*;
use crate::scope::speed;
use crate::sums::{Ask, block, body, by_index, position};

/// A function of `Numbers` with the effects as its first argument, and without it a function of `Equations`.
pub struct Cold {
    pub name: &'static str,
    /// Its parameters, `k: &[f64]`.
    pub takes: TokenStream,
    /// Its arguments, `k`.
    pub given: TokenStream,
    pub returns: TokenStream,
    pub body: TokenStream,
}

impl Cold {
    /// The definition in `Numbers`; `conditions` defines the effects and conditions as variables.
    pub fn define(&self, conditions: &TokenStream) -> TokenStream {
        let Cold { takes, returns, body, .. } = self;
        let name = self.ident();
        quote! {
            #[inline(never)]
            fn #name(&self, effects: u32, #takes) -> #returns { #conditions #body }
        }
    }

    /// The function of `Equations` that calls it with the effects E.
    pub fn call(&self) -> TokenStream {
        let Cold { takes, given, returns, .. } = self;
        let name = self.ident();
        quote!(fn #name(&self, #takes) -> #returns { self.0.#name(E, #given) })
    }

    fn ident(&self) -> Ident {
        format_ident!("{}", self.name)
    }
}

/// The functions in f64. Those that give the matrices of a cell, in any kind of number, are in [`crate::cells`].
pub fn cold(m: &Model) -> Vec<Cold> {
    let n = Index::from(m.coordinates.len());
    let (q, q_dot, k) = (quote!(q: &[f64; #n]), quote!(q_dot: &[f64; #n]), quote!(k: &[f64]));
    let (d, d_dot) = deflections(m);
    let cold = |name, takes, given, returns, body| Cold { name, takes, given, returns, body };
    let number = || quote!(f64);

    let kinetic = body(&m.kinetic, Ask::Running);
    let potential = body(&m.potential, Ask::Running);
    let torques = m.torques.iter().map(|t| block(&t.work, Ask::Running));
    let work = body(&work(m), Ask::Running);
    let entries = m.jacobian.iter().flatten().map(|e| jacobian(m, e));
    let bands = gated::of_effects(m, Ask::Running);
    let jacobian = quote!(#bands #d #d_dot let mut v = [[[0.0; #n]; #n]; 2]; #(#entries)* v);
    let motions = m.motions.iter().map(|x| motion(m, x));
    let mut all = vec![
        cold("kinetic", q_dot.clone(), quote!(q_dot), number(), kinetic),
        cold("potential", quote!(#q, #k), quote!(q, k), number(), quote!(#bands #d #potential)),
        cold(
            "torque_work",
            quote!(i: usize, dq: &[f64; #n]),
            quote!(i, dq),
            number(),
            by_index("torque", format_ident!("i"), torques),
        ),
        cold("work", quote!(dq: &[f64; #n]), quote!(dq), number(), work),
        cold(
            "jacobian",
            quote!(#q, #q_dot, #k, dk: &[f64], ddk: &[f64]),
            quote!(q, q_dot, k, dk, ddk),
            quote!([[[f64; #n]; #n]; 2]),
            jacobian,
        ),
        cold("motion", quote!(i: usize), quote!(i), quote!([f64; #n]), by_index("motion", format_ident!("i"), motions)),
        cold("switching", quote!(law: usize), quote!(law), quote!(equations::Switching), switching(m)),
    ];
    all.extend(jumps(m));
    let forces = forces::of_effects(m, Ask::Running);
    all.extend(powers(m, &quote!(#bands #d #d_dot #forces)));
    all
}

/// The power of each torque that is not constant, and whether such a torque is present; nothing if the model has none.
fn powers(m: &Model, first: &TokenStream) -> Vec<Cold> {
    let terms: Vec<_> = m.torques.iter().flat_map(|t| &t.power).collect();
    if terms.is_empty() {
        return vec![];
    }
    let n = Index::from(m.coordinates.len());
    let power = by_index("torque", format_ident!("i"), m.torques.iter().map(|t| block(&t.power, Ask::Running)));
    let always = terms.iter().any(|t| t.condition.is_none());
    let present = terms.iter().filter_map(|t| t.condition.as_ref()).map(effects::constant);
    vec![
        Cold {
            name: "torque_power",
            takes: quote!(i: usize, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64]),
            given: quote!(i, q, q_dot, k),
            returns: quote!(f64),
            body: quote!(#first #power),
        },
        Cold {
            name: "has_powers",
            takes: quote!(),
            given: quote!(),
            returns: quote!(bool),
            body: quote!(#always #(|| #present)*),
        },
    ]
}

/// The work of all constant torques: every generalised force times the change of its coordinate.
fn work(m: &Model) -> Sum {
    let terms = m.work.iter().flat_map(|row| {
        let i = position(m, &row.name);
        row.sum.iter().map(move |t| {
            let force = &t.value;
            Term { condition: t.condition.clone(), value: syn::parse_quote!((#force) * dq[#i]) }
        })
    });
    terms.collect()
}

fn motion(m: &Model, motion: &Motion) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let speeds = motion.speeds.iter().map(|Assignment { name, value }| {
        let i = m.coordinates.iter().position(|c| *name == speed(&c.name)).map(Index::from);
        quote!(q_dot[#i] = #value;)
    });
    quote!({ let mut q_dot = [0.0; #n]; #(#speeds)* q_dot })
}

/// Sets one entry of the derivatives by coordinates, v[0], or by speeds, v[1].
fn jacobian(m: &Model, e: &Entry) -> TokenStream {
    let by_speed = m.coordinates.iter().position(|c| e.column == speed(&c.name));
    let (which, j) = match by_speed {
        Some(j) => (Index::from(1), Index::from(j)),
        None => (Index::from(0), position(m, &e.column)),
    };
    let (i, value) = (position(m, &e.row), block(&e.sum, Ask::Running));
    quote!(v[#which][#i][#j] = #value;)
}

fn switching(m: &Model) -> TokenStream {
    let otherwise = |effect: &str, case: TokenStream| {
        has(m, effect).then(|| {
            let name = format_ident!("{}", effect.to_uppercase());
            quote!(if #name { equations::Switching::#case } else)
        })
    };
    if !has(m, effects::STIFFNESS_STEP) {
        return quote!(equations::Switching::Never);
    }
    let step = format_ident!("{}", effects::STIFFNESS_STEP.to_uppercase());
    let by_time = otherwise(effects::FROZEN_PHASE, quote!(ByTime));
    let without = otherwise(effects::RIGID_KINEMATICS, quote!(WithoutJump));
    // A law whose effect is absent is zero, and never switches.
    let gated =
        m.laws.iter().enumerate().filter_map(|(i, law)| Some((Index::from(i), effects::constant(law.with.as_ref()?))));
    let (gated, there): (Vec<_>, Vec<_>) = gated.unzip();
    quote! {
        if !#step #(|| law == #gated && !#there)* { equations::Switching::Never } else #by_time #without { equations::Switching::WithJump }
    }
}
