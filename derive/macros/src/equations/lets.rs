//! The variables in which equations are written: values that exist only with an effect, deflections, their rates, functions of
//! positions, named forces, their partial derivatives, and outputs.
//! A piece of code defines the variables that it names, and no others.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::Ident;

use crate::equations::cells::any_number;
use crate::equations::deflections::{Offsets, addends, deflection, offset};
use crate::equations::effects::is_met;
use crate::equations::gated::{Gated, gated};
use crate::equations::model::{Assignment, Function, Model, Row};
use crate::equations::sums::block;

/// `let NAME = ..;` for each variable that `code` names, and before it for the variables in its value. Variables that [`lets`] defines for
/// the code `before` are left out.
pub fn lets(m: &Model, code: &TokenStream, before: &TokenStream) -> TokenStream {
    let known = used(m, before);
    let known: BTreeSet<_> = known.iter().map(Variable::name).collect();
    let (mut values, mut offsets, mut functions, mut bent, mut forces) =
        (quote!(), Offsets::new(), quote!(), quote!(), quote!());
    for variable in used(m, code).into_iter().filter(|variable| !known.contains(variable.name())) {
        match variable {
            Variable::Gated(Gated { name, effect, place, neutral }) => {
                let (met, neutral) = (is_met(effect), Literal::f64_suffixed(neutral));
                values.extend(quote!(let #name = if #met { k[#place] } else { #neutral.into() };));
            }
            Variable::Linear(linear) => values.extend(deflection(m, linear, &mut offsets)),
            Variable::Function(Function { name, with, value }) => functions.extend(match with.as_ref().map(is_met) {
                Some(met) => quote!(let #name: f64 = if #met { #value } else { 0.0 };),
                None => quote!(let #name: f64 = #value;),
            }),
            Variable::Bent(deflected) => {
                let mut offsets = Offsets::new();
                bent.extend(deflection(m, deflected, &mut offsets));
                bent.extend(with_effects(offsets));
            }
            Variable::Force(Row { name, sum }) => {
                let value = block(sum);
                forces.extend(quote!(let #name: f64 = #value;));
            }
        }
    }
    let offsets = with_effects(offsets);
    quote!(#values #offsets #functions #bent #forces)
}

/// The statements of offsets, each behind a test of its effect.
fn with_effects(offsets: Offsets) -> TokenStream {
    let each = offsets.into_iter().map(|(effect, add)| {
        let met = is_met(&effect);
        quote!(if #met { #add })
    });
    each.collect()
}

/// The definitions of the functions of positions that `code` names, and of their positions, in the number type R.
pub fn positions(m: &Model, code: &TokenStream) -> TokenStream {
    let plain = used(m, code).into_iter().filter_map(|variable| match variable {
        Variable::Linear(Assignment { name, value }) | Variable::Function(Function { name, value, .. }) => {
            Some((name, value))
        }
        _ => None,
    });
    let each = plain.map(|(name, value)| {
        let value = any_number(value);
        quote!(let #name: R = #value;)
    });
    quote!(#(#each)*)
}

/// `code` after the variables that it names.
pub fn with_lets(m: &Model, code: TokenStream) -> TokenStream {
    let lets = lets(m, &code, &quote!());
    quote!(#lets #code)
}

/// A variable in which equations are written.
enum Variable<'a> {
    Gated(Gated<'a>),
    /// A deflection that is linear, or its rate.
    Linear(&'a Assignment),
    /// A function of positions, or a derivative of it.
    Function(&'a Function),
    /// A deflection with functions in it, or its rate.
    Bent(&'a Assignment),
    /// A named force, a partial derivative of one, or an output.
    Force(&'a Row),
}

/// The variables that `code` names and the variables in their values, in the order in which they are defined.
fn used<'a>(m: &'a Model, code: &TokenStream) -> Vec<Variable<'a>> {
    let Variables { bent, names } = m.variables.get_or_init(|| Variables::of(m));
    let (mut named, mut used) = (self::names(code), vec![]);
    for (variable, (name, written)) in all(m, bent).into_iter().zip(names).rev() {
        if named.contains(name) {
            named.extend(written.iter().cloned());
            used.push(variable);
        }
    }
    used.reverse();
    used
}

/// All variables of a model, in the order of their definition. `bent`: whether each deflection bends.
fn all<'a>(m: &'a Model, bent: &[bool]) -> Vec<Variable<'a>> {
    let linear = |which: fn(&'a Assignment) -> Variable<'a>, these: bool| {
        let of = |all: &'a [Assignment]| all.iter().zip(bent).filter(move |(_, is)| **is == these).map(|(x, _)| x);
        of(&m.deflections).chain(of(&m.rates)).map(which)
    };
    let functions = m.functions.iter().map(Variable::Function);
    let outputs = m.outputs.iter().map(|output| &output.value);
    let forces = m.forces.iter().chain(&m.partials).chain(outputs).map(Variable::Force);
    let all = gated(m).map(Variable::Gated).chain(linear(Variable::Linear, false)).chain(functions);
    all.chain(linear(Variable::Bent, true)).chain(forces).collect()
}

/// Properties of the variables of a model. They are computed once, because the code of each function needs them.
#[derive(Debug)]
pub struct Variables {
    /// Whether each deflection bends.
    bent: Vec<bool>,
    /// For each variable its name, and the names in its value.
    names: Vec<(String, BTreeSet<String>)>,
}

impl Variables {
    fn of(m: &Model) -> Variables {
        let bent: Vec<bool> = m.deflections.iter().map(|d| is_bent(m, &d.value)).collect();
        let of = |variable: Variable<'_>| (variable.name().to_string(), names(variable.written(m)));
        let names = all(m, &bent).into_iter().map(of).collect();
        Variables { bent, names }
    }
}

/// Whether a deflection bends: its value contains functions of positions, so it is not linear in the coordinates.
pub fn is_bent(m: &Model, value: &syn::Expr) -> bool {
    if m.functions.is_empty() {
        return false;
    }
    let names = names(value);
    m.functions.iter().any(|f| names.contains(&f.name.to_string()))
}

/// All names in a piece of code.
pub fn names(code: impl ToTokens) -> BTreeSet<String> {
    fn add(code: TokenStream, names: &mut BTreeSet<String>) {
        for token in code {
            match token {
                TokenTree::Ident(name) => {
                    names.insert(name.to_string());
                }
                TokenTree::Group(group) => add(group.stream(), names),
                _ => {}
            }
        }
    }
    let mut names = BTreeSet::new();
    add(code.into_token_stream(), &mut names);
    names
}

impl Variable<'_> {
    fn name(&self) -> &Ident {
        match self {
            Variable::Gated(gated) => gated.name,
            Variable::Linear(Assignment { name, .. }) | Variable::Bent(Assignment { name, .. }) => name,
            Variable::Function(Function { name, .. }) => name,
            Variable::Force(Row { name, .. }) => name,
        }
    }

    /// The expressions of its value.
    fn written(&self, m: &Model) -> TokenStream {
        match self {
            Variable::Gated(_) => quote!(),
            // The offsets are left out: the statements of the deflection add them.
            Variable::Linear(linear) => {
                let lasting =
                    addends(&linear.value, false).into_iter().filter(|(_, addend)| offset(m, addend).is_none());
                lasting.map(|(_, addend)| addend.to_token_stream()).collect()
            }
            Variable::Bent(bent) => bent.value.to_token_stream(),
            Variable::Function(function) => function.value.to_token_stream(),
            Variable::Force(row) => row.sum.iter().map(|term| term.value.to_token_stream()).collect(),
        }
    }
}
