//! The functions of `Equations`, in the order of the trait.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Index;

use crate::effects::{self, has};
use crate::jumps::jumps;
use crate::model::*;
use crate::scope::speed;
use crate::share::{Function, LARGE, Place};
use crate::sums::{self, block, body, by_index, position};

/// The functions of `Equations`, and those of the numbers that they call.
pub fn functions(m: &Model) -> (TokenStream, Vec<TokenStream>) {
    let n = Index::from(m.coordinates.len());
    let (vector, matrix) = (quote!([f64; #n]), quote!([[f64; #n]; #n]));
    let (no_vector, no_matrix) = (quote!([0.0; #n]), quote!([[0.0; #n]; #n]));
    let (d, d_dot) = deflections(m);
    let none = || quote!();
    let q_dot = || (quote!(q_dot: &#vector,), quote!(q_dot,));
    let k = || (quote!(k: &[f64],), quote!(k,));
    let state = || (quote!(q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64],), quote!(q, q_dot, k, dk,));
    let mut shared = vec![];

    let mut scalar = |name, (takes, given), first, sum: &Sum| {
        let (returns, zero) = (quote!(f64), quote!(0.0));
        match sum.len() {
            0..=LARGE => {
                let body = body(sum);
                quote!(#first #body)
            }
            _ => Function { name, takes, given, returns, zero, first }
                .body(&[Place { at: quote!(*v), mirror: None, sum }], &mut shared),
        }
    };
    let kinetic = scalar("kinetic", q_dot(), none(), &m.kinetic);
    let q_and_k = (quote!(q: &#vector, k: &[f64],), quote!(q, k,));
    let potential = scalar("potential", q_and_k, d.clone(), &m.potential);
    let dissipation = scalar("dissipation", q_dot(), d_dot.clone(), &m.dissipation);

    let mut of_rows = |name, rows: &mut dyn Iterator<Item = &Row>| {
        let places: Vec<Place> = rows
            .map(|r| {
                let i = position(m, &r.name);
                Place { at: quote!(v[#i]), mirror: None, sum: &r.sum }
            })
            .collect();
        let ((takes, given), first) = (state(), quote!(#d #d_dot));
        Function { name, takes, given, returns: vector.clone(), zero: no_vector.clone(), first }
            .body(&places, &mut shared)
    };
    let force = of_rows("force", &mut m.force.iter().flatten());
    let acceleration = m.acceleration.as_ref().map(|rows| of_rows("acceleration", &mut rows.iter()));

    let mut of_entries = |name, (takes, given), entries: &[Entry]| {
        let places: Vec<Place> = entries
            .iter()
            .map(|e| {
                let (i, j) = (position(m, &e.row), position(m, &e.column));
                let mirror = (i != j).then(|| quote!(v[#j][#i] = v[#i][#j];));
                Place { at: quote!(v[#i][#j]), mirror, sum: &e.sum }
            })
            .collect();
        let (returns, zero) = (matrix.clone(), no_matrix.clone());
        Function { name, takes, given, returns, zero, first: none() }.body(&places, &mut shared)
    };
    let mass = of_entries("mass", (none(), none()), &m.mass);
    let mobility = m.mobility.as_ref().map(|entries| of_entries("mobility", (none(), none()), entries));
    let damping = of_entries("damping", (none(), none()), &m.damping);
    let stiffness = of_entries("stiffness", k(), &m.stiffness);

    let places: Vec<Place> = m.jacobian.iter().flatten().map(|e| jacobian(m, e)).collect();
    let (takes, given) = state();
    let jacobian = Function {
        name: "jacobian",
        takes: quote!(#takes ddk: &[f64],),
        given: quote!(#given ddk,),
        returns: quote!([#matrix; 2]),
        zero: quote!([#no_matrix; 2]),
        first: quote!(#d #d_dot),
    }
    .body(&places, &mut shared);

    let torque_work = by_index("torque", format_ident!("i"), m.torques.iter().map(|t| block(&t.work)));
    let work = body(&work(m));
    let motion = by_index("motion", format_ident!("i"), m.motions.iter().map(|x| motion(m, x)));
    let load = sums::vector(m, &m.load);
    let switching = switching(m);
    let jumps = jumps(m);
    let acceleration = acceleration.map(|a| {
        quote! {
            #[inline]
            fn acceleration(&self, q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64]) -> #vector { #a }
        }
    });
    let mobility = mobility.map(|w| quote!(fn mobility(&self) -> #matrix { #w }));
    let functions = quote! {
        #[inline]
        fn kinetic(&self, q_dot: &#vector) -> f64 { #kinetic }
        #[inline]
        fn potential(&self, q: &#vector, k: &[f64]) -> f64 { #potential }
        #[inline]
        fn dissipation(&self, q_dot: &#vector) -> f64 { #dissipation }
        #[inline]
        fn torque_work(&self, i: usize, dq: &#vector) -> f64 { #torque_work }
        #[inline]
        fn work(&self, dq: &#vector) -> f64 { #work }
        #[inline]
        fn force(&self, q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64]) -> #vector { #force }
        #acceleration
        fn jacobian(
            &self, q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64], ddk: &[f64],
        ) -> [#matrix; 2] { #jacobian }
        fn mass(&self) -> #matrix { #mass }
        #mobility
        fn damping(&self) -> #matrix { #damping }
        fn stiffness(&self, k: &[f64]) -> #matrix { #stiffness }
        fn load(&self) -> #vector { #load }
        fn motion(&self, i: usize) -> #vector { #motion }
        #[inline]
        fn switching(&self, law: usize) -> equations::Switching { #switching }
        #jumps
    };
    (functions, shared)
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

/// An entry of the derivatives by coordinates, or of those by speeds.
fn jacobian<'a>(m: &Model, e: &'a Entry) -> Place<'a> {
    let by_speed = m.coordinates.iter().position(|c| e.column == speed(&c.name));
    let (which, j) = match by_speed {
        Some(j) => (Index::from(1), Index::from(j)),
        None => (Index::from(0), position(m, &e.column)),
    };
    let i = position(m, &e.row);
    Place { at: quote!(v[#which][#i][#j]), mirror: None, sum: &e.sum }
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
