//! The description of a model, `gearsim::model::Model`: scenes are checked against it, and the command line prints it.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Ident, LitStr};

use crate::equations::lets::{names, with_lets};
use crate::equations::model::*;
use crate::equations::sums::block;
use crate::equations::switches::bending;
use crate::equations::varies::{Varies, varies};

/// The expression of type `gearsim::model::Model`.
pub fn describe(m: &Model) -> TokenStream {
    let (name, title) = (m.name.to_string(), &m.title);
    let source = m.source.as_ref().map_or_else(String::new, LitStr::value);
    let coordinates = m.coordinates.iter().map(coordinate);
    let parameters = m.parameters.iter().zip(varies(m)).map(|(p, varies)| parameter(p, varies));
    let laws = m.laws.iter().map(|Law { name, unit, phase, period, rolling, held, with, role, doc }| {
        let (name, phase, with) = (name.to_string(), phase.to_string(), option(with));
        let (role, held) = (format_ident!("{role:?}"), strings(held));
        quote!(model::Law {
            name: #name, unit: #unit, phase: #phase, period: #period, rolling: #rolling, held: #held, with: #with,
            role: model::Role::#role, doc: #doc
        })
    });
    let motions = m.motions.iter().map(|RigidMotion { name, unit, doc, .. }| {
        let name = name.to_string();
        quote!(model::RigidMotion { name: #name, unit: #unit, doc: #doc })
    });
    let effects = m.effects.iter().map(|e| {
        let (name, doc, requires, excludes) = (e.name.to_string(), &e.doc, strings(&e.requires), strings(&e.excludes));
        let (of, bends) = (option(&e.of), bending(m).any(|function| function.with.as_ref() == Some(&e.name)));
        let switching = match m.switching.iter().find(|boundary| boundary.effect == e.name) {
            Some(Boundary { how, .. }) => {
                let how = format_ident!("{how:?}");
                quote!(Some(model::Switching::#how))
            }
            None => quote!(None),
        };
        quote!(model::Effect {
            name: #name, of: #of, doc: #doc, requires: #requires, excludes: #excludes, switching: #switching, bends: #bends
        })
    });
    let torques = m.torques.iter().map(|torque| {
        let (name, with, doc) = (torque.name.to_string(), strings(&needs(m, torque)), &torque.doc);
        quote!(model::Torque { name: #name, with: #with, doc: #doc })
    });
    let outputs = m.outputs.iter().map(|Output { unit, with, doc, value }| {
        let (name, with) = (value.name.to_string(), option(with));
        let known = names(with_lets(m, block(&value.sum))).contains("known");
        quote!(model::Output { name: #name, unit: #unit, with: #with, known: #known, doc: #doc })
    });
    let switches = m.switches.iter().map(switch);
    let nonlinear = m.nonlinear.as_ref().map_or_else(String::new, LitStr::value);
    let nonlinear_with = m.nonlinear_with.iter().map(|NonlinearWith { effects, text }| {
        let effects = effects.iter().map(Ident::to_string);
        quote!((&[#(#effects),*], #text))
    });
    let (equations, latex) = (included(&m.text), included(&m.latex));
    quote! {
        model::Model {
            name: #name,
            title: #title,
            source: #source,
            coordinates: &[#(#coordinates),*],
            parameters: &[#(#parameters),*],
            laws: &[#(#laws),*],
            motions: &[#(#motions),*],
            effects: &[#(#effects),*],
            torques: &[#(#torques),*],
            outputs: &[#(#outputs),*],
            switches: &[#(#switches),*],
            nonlinear: #nonlinear,
            nonlinear_with: &[#(#nonlinear_with),*],
            equations: #equations,
            latex: #latex,
            elements: &[],
            relative: &[],
        }
    }
}

/// The effects that all terms of a torque need. The torque is zero if any one of them is absent.
fn needs(m: &Model, torque: &Torque) -> Vec<Ident> {
    let active = |term: &Term| -> Vec<Ident> {
        let condition = m.conditions.iter().find(|condition| Some(&condition.name) == term.condition.as_ref());
        match condition {
            Some(condition) => {
                condition.effects.iter().filter(|(present, _)| *present).map(|(_, e)| e.clone()).collect()
            }
            None => term.condition.iter().cloned().collect(),
        }
    };
    let needs = torque.work.iter().chain(&torque.power).map(active);
    needs.reduce(|all, more| all.into_iter().filter(|effect| more.contains(effect)).collect()).unwrap_or_default()
}

fn switch(Switch { over, unit, symbols, effect, doc, modes, .. }: &Switch) -> TokenStream {
    let (name, with) = (over.to_string(), effect.to_string());
    let neutral = symbols.iter().map(|(_, neutral)| number(*neutral));
    let modes = modes.iter().map(|SwitchMode { name, held, rests, counts, .. }| {
        let name = name.to_string();
        let counts = counts.as_ref().map_or(quote!(None), |counts| quote!(Some(#counts)));
        quote!(model::SwitchMode { name: #name, held: #held, rests: #rests, counts: #counts })
    });
    quote!(model::Switch {
        name: #name, unit: #unit, with: #with, neutral: &[#(#neutral),*], modes: &[#(#modes),*], doc: #doc
    })
}

fn coordinate(c: &Coordinate) -> TokenStream {
    let (name, unit, doc) = (c.name.to_string(), &c.unit, &c.doc);
    let start = match c.start {
        Some(x) => {
            let x = number(x);
            quote!(model::Start::At(#x))
        }
        None => quote!(model::Start::Static),
    };
    quote!(model::Coordinate { name: #name, unit: #unit, doc: #doc, start: #start })
}

fn parameter(p: &Parameter, varies: Varies) -> TokenStream {
    let Parameter { unit, low_included, high_included, doc, .. } = p;
    let (name, low, high) = (p.name.to_string(), number(p.low), number(p.high));
    let default = match p.default.map(number) {
        Some(x) => quote!(Some(#x)),
        None => quote!(None),
    };
    let gear_data = p.gear_data.map_or(quote!(None), |gear_data| {
        let variant = Ident::new(GEAR_DATA[gear_data].1, p.name.span());
        quote!(Some(model::GearData::#variant))
    });
    let (with, above, varies) = (option(&p.with), option(&p.above), varies.tokens());
    quote! {
        model::Parameter {
            name: #name,
            unit: #unit,
            default: #default,
            with: #with,
            gear_data: #gear_data,
            varies: #varies,
            range: model::Range {
                low: #low,
                high: #high,
                low_included: #low_included,
                high_included: #high_included,
            },
            above: #above,
            doc: #doc,
        }
    }
}

/// A number as tokens. Infinities have no literal, and a negative number is two tokens.
fn number(x: f64) -> TokenStream {
    let (minus, size) = (x.is_sign_negative().then(|| quote!(-)), x.abs());
    if size.is_infinite() { quote!(#minus f64::INFINITY) } else { quote!(#minus #size) }
}

fn option(name: &Option<Ident>) -> TokenStream {
    match name.as_ref().map(Ident::to_string) {
        Some(name) => quote!(Some(#name)),
        None => quote!(None),
    }
}

fn strings(names: &[Ident]) -> TokenStream {
    let names = names.iter().map(Ident::to_string);
    quote!(&[#(#names),*])
}

/// The contents of a file, given by its path relative to the file of the model.
fn included(path: &Option<LitStr>) -> TokenStream {
    path.as_ref().map_or(quote!(""), |path| quote!(include_str!(#path)))
}
