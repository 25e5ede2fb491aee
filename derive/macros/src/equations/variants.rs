//! Variants of the functions that are called at every step. Some effects need further values: laws, the symbols of switches, functions of
//! positions. Others add torques that depend on the speed: motors and fans. [`Kind`] lists these kinds. A variant is compiled without the
//! terms of some kinds. A scene without these kinds uses the variant, and does not even test whether the terms are present. There are at
//! most five variants for any number of effects, so code still grows in proportion to the number of effects. The variant of a scene is
//! chosen when its equations are made.

use std::collections::BTreeSet;

use proc_macro2::{Group, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::Ident;

use crate::equations::model::{Model, Role, Sum};

/// A kind of values or terms that an effect adds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// Offsets of deflections that are laws.
    Errors,
    /// The symbols of switches.
    Switches,
    /// Factors of torques that are laws, functions of positions, and torques that depend on the speed.
    Others,
}

use Kind::{Errors, Others, Switches};

/// The kinds of each variant. Variants with a kind that the model does not have are left out. A scene uses the first variant that contains
/// all its kinds.
const VARIANTS: [&[Kind]; 5] = [&[], &[Errors], &[Switches], &[Errors, Switches], &[Errors, Switches, Others]];

/// The variants of a model, the last one with all its kinds.
pub struct Variants<'a> {
    model: &'a Model,
    each: Vec<BTreeSet<Kind>>,
}

impl<'a> Variants<'a> {
    pub fn of(model: &'a Model) -> Self {
        let all: BTreeSet<Kind> = model.effects.iter().flat_map(|e| kinds(model, &e.name)).collect();
        let each = VARIANTS.iter().filter(|kinds| kinds.iter().all(|kind| all.contains(kind)));
        let mut each: Vec<BTreeSet<Kind>> = each.map(|kinds| kinds.iter().copied().collect()).collect();
        if each.last() != Some(&all) {
            each.push(all);
        }
        Self { model, each }
    }

    /// The kinds of the model.
    fn kinds(&self) -> impl Iterator<Item = Kind> {
        self.each.iter().flatten().copied().collect::<BTreeSet<_>>().into_iter()
    }

    /// The const generic parameters of a function that has variants.
    pub fn parameters(&self) -> TokenStream {
        let names = self.kinds().map(|kind| kind.parameter());
        quote!(#(const #names: bool),*)
    }

    /// The same parameters as arguments, for a call of another function that has variants.
    pub fn arguments(&self) -> TokenStream {
        let names = self.kinds().map(|kind| kind.parameter());
        quote!(#(#names),*)
    }

    /// The code that selects the variant of a scene, in a function that has `met`. `of` gives the expression for the const generic
    /// arguments of a variant.
    pub fn choice(&self, of: impl Fn(&TokenStream) -> TokenStream) -> TokenStream {
        let has = |kind: Kind| {
            let effects = self.model.effects.iter().map(|e| &e.name);
            let effects = effects.filter(|effect| kinds(self.model, effect).contains(&kind));
            quote!((#(met.#effects)||*))
        };
        let mut choice = quote!();
        for variant in &self.each {
            let absent: Vec<_> = self.kinds().filter(|kind| !variant.contains(kind)).map(has).collect();
            let arguments = self.kinds().map(|kind| variant.contains(&kind));
            let variant = of(&quote!(#(#arguments),*));
            choice.extend(if absent.is_empty() {
                quote!({ #variant })
            } else {
                quote!(if #(!#absent)&&* { #variant } else)
            });
        }
        choice
    }

    /// The code of a function in which each test of an effect also tests the const generic parameters of the kinds that the effect needs.
    pub fn tested(&self, code: TokenStream) -> TokenStream {
        let (mut tested, mut before) = (quote!(), [String::new(), String::new()]);
        for token in code {
            let text = token.to_string();
            if let (["met", "."], TokenTree::Ident(condition)) = (before.each_ref().map(String::as_str), &token) {
                let named = self.model.conditions.iter().find(|c| c.name == *condition);
                let effects = named.map_or(vec![condition], |c| {
                    c.effects.iter().filter(|(present, _)| *present).map(|(_, effect)| effect).collect()
                });
                let needed: BTreeSet<Kind> = effects.iter().flat_map(|effect| kinds(self.model, effect)).collect();
                let needed = needed.iter().map(Kind::parameter);
                tested.extend(quote!(#condition #(&& #needed)*));
            } else if let TokenTree::Group(group) = token {
                tested.extend([TokenTree::Group(Group::new(group.delimiter(), self.tested(group.stream())))]);
            } else {
                tested.extend([token]);
            }
            before = [std::mem::take(&mut before[1]), text];
        }
        tested
    }
}

impl Kind {
    /// The const generic parameter that is `true` in variants with this kind.
    fn parameter(&self) -> Ident {
        format_ident!("{}", format!("{self:?}").to_uppercase())
    }
}

/// The kinds of values and terms that exist only with an effect.
fn kinds(m: &Model, effect: &Ident) -> BTreeSet<Kind> {
    let with = |with: &Option<Ident>| with.as_ref() == Some(effect);
    let laws = m.laws.iter().filter(|law| with(&law.with));
    let laws = laws.map(|law| if law.role == Role::Error { Errors } else { Others });
    let switches = m.switches.iter().filter(|switch| switch.effect == *effect).map(|_| Switches);
    let functions = m.functions.iter().filter(|function| with(&function.with)).map(|_| Others);
    laws.chain(switches).chain(functions).chain(drives(m, effect).then_some(Others)).collect()
}

/// Whether an effect adds a torque that depends on the speed, as a motor or a fan does. Such a torque has a power that is not linear, or a
/// constant part and a term of D. Effects with laws, such as friction, do not count.
pub fn drives(m: &Model, effect: &Ident) -> bool {
    if m.laws.iter().any(|law| law.with.as_ref() == Some(effect)) {
        return false;
    }
    let has = |sum: &Sum| sum.iter().any(|term| term.condition.as_ref() == Some(effect));
    if m.torques.iter().any(|torque| has(&torque.work)) {
        has(&m.dissipation)
    } else {
        m.torques.iter().any(|torque| has(&torque.power))
    }
}
