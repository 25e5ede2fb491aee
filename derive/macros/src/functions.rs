//! The functions of `Equations`, in the order of the trait.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Index;

use crate::effects::{self, has};
use crate::jumps::jumps;
use crate::model::*;
use crate::scope::speed;
use crate::sums::{block, body, by_index, matrix, position, vector};

/// The functions of `Equations`.
pub fn functions(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let (kinetic, potential, dissipation) = (body(&m.kinetic), body(&m.potential), body(&m.dissipation));
    let (d, d_dot) = deflections(m);
    let torque_work = by_index("torque", format_ident!("i"), m.torques.iter().map(|t| block(&t.work)));
    let work = body(&work(m));
    let motion = by_index("motion", format_ident!("i"), m.motions.iter().map(|x| motion(m, x)));
    let (mass, damping, stiffness) = (matrix(m, &m.mass), matrix(m, &m.damping), matrix(m, &m.stiffness));
    let load = vector(m, &m.load);
    let force = vector(m, m.force.iter().flatten());
    let acceleration = m.acceleration.as_ref().map(|rows| {
        let a = vector(m, rows);
        let (d, d_dot) = deflections(m);
        quote! {
            #[inline]
            fn acceleration(&self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64]) -> [f64; #n] { #d #d_dot #a }
        }
    });
    let mobility = m.mobility.as_ref().map(|entries| {
        let w = matrix(m, entries);
        quote!(fn mobility(&self) -> [[f64; #n]; #n] { #w })
    });
    let jacobian = jacobian(m);
    let switching = switching(m);
    let jumps = jumps(m);
    quote! {
        #[inline]
        fn kinetic(&self, q_dot: &[f64; #n]) -> f64 { #kinetic }
        #[inline]
        fn potential(&self, q: &[f64; #n], k: &[f64]) -> f64 { #d #potential }
        #[inline]
        fn dissipation(&self, q_dot: &[f64; #n]) -> f64 { #d_dot #dissipation }
        #[inline]
        fn torque_work(&self, i: usize, dq: &[f64; #n]) -> f64 { #torque_work }
        #[inline]
        fn work(&self, dq: &[f64; #n]) -> f64 { #work }
        #[inline]
        fn force(&self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64]) -> [f64; #n] { #d #d_dot #force }
        #acceleration
        fn jacobian(
            &self, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64], dk: &[f64], ddk: &[f64],
        ) -> [[[f64; #n]; #n]; 2] { #d #d_dot #jacobian }
        fn mass(&self) -> [[f64; #n]; #n] { #mass }
        #mobility
        fn damping(&self) -> [[f64; #n]; #n] { #damping }
        fn stiffness(&self, k: &[f64]) -> [[f64; #n]; #n] { #stiffness }
        fn load(&self) -> [f64; #n] { #load }
        fn motion(&self, i: usize) -> [f64; #n] { #motion }
        #[inline]
        fn switching(&self, law: usize) -> equations::Switching { #switching }
        #jumps
    }
}

/// `let d = ..;` and `let d_dot = ..;`: all deflections and their rates; what is not used is not computed.
pub fn deflections(m: &Model) -> (TokenStream, TokenStream) {
    match m.deflections.is_empty() {
        true => (quote!(), quote!()),
        false => (quote!(let d = self.deflections(q);), quote!(let d_dot = self.deflections(q_dot);)),
    }
}

/// The net work: every generalised force times the change of its coordinate.
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

/// The derivatives by coordinates, then those by speeds.
fn jacobian(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = m.jacobian.iter().flatten().map(|e| {
        let by_speed = m.coordinates.iter().position(|c| e.column == speed(&c.name));
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
