//! Effects: checks of them, and the fields by which generated code tests them.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::{Error, Ident};

use crate::equations::check::unique;
use crate::equations::model::{How, Model};
use crate::equations::variants::drives;

/// Effects and conditions must refer to effects that exist.
pub fn check(m: &Model, errors: &mut Vec<Error>) {
    unique(
        "effect or condition",
        m.effects.iter().map(|e| &e.name).chain(m.conditions.iter().map(|c| &c.name)),
        errors,
    );
    let related = m.effects.iter().flat_map(|e| e.requires.iter().chain(&e.excludes));
    let related = related.chain(m.switching.iter().map(|boundary| &boundary.effect));
    let related = related.chain(m.nonlinear_with.iter().flat_map(|n| &n.effects));
    let related = related.chain(m.parameters.iter().filter_map(|p| p.with.as_ref()));
    let related = related.chain(m.laws.iter().filter_map(|l| l.with.as_ref()));
    let held = |name: &&Ident| index(m, name).is_none() && m.effects.iter().all(|e| e.of.as_ref() != Some(name));
    for name in m.laws.iter().flat_map(|law| &law.held).filter(held) {
        errors.push(Error::new(name.span(), format!("there is no effect `{name}`")));
    }
    let related = related.chain(m.functions.iter().filter_map(|f| f.with.as_ref()));
    let related = related.chain(m.switches.iter().map(|switch| &switch.effect));
    for name in related.chain(m.conditions.iter().flat_map(|c| c.effects.iter().map(|(_, name)| name))) {
        if index(m, name).is_none() {
            errors.push(Error::new(name.span(), format!("there is no effect `{name}`")));
        }
    }
    switching(m, errors);
}

/// A way to switch belongs to one effect at most, and an effect has one way at most. If no effect makes laws switch with a jump, no other
/// way is allowed.
fn switching(m: &Model, errors: &mut Vec<Error>) {
    unique("way to switch of the effect", m.switching.iter().map(|boundary| &boundary.effect), errors);
    for (i, boundary) in m.switching.iter().enumerate() {
        let (effect, span) = (&boundary.effect, boundary.effect.span());
        if let Some(first) = m.switching[..i].iter().find(|first| first.how == boundary.how && first.effect != *effect)
        {
            let message = format!("`{effect}` makes laws switch as `{}` does: one effect can", first.effect);
            errors.push(Error::new(span, message));
        }
        if m.switching(How::WithJump).is_none() {
            let message = format!(
                "`{effect}` changes how laws switch, but no effect makes them switch: write `EFFECT => with_jump;` too"
            );
            errors.push(Error::new(span, message));
        }
    }
}

/// `struct Met`: for each effect and condition whether a scene meets it, and its constructor from a set of effects.
pub fn met(m: &Model) -> TokenStream {
    let effects: Vec<_> = m.effects.iter().map(|e| &e.name).collect();
    let numbers = (0..effects.len()).map(Literal::usize_unsuffixed);
    let (some_drive, drives) = (some_drive(), effects.iter().filter(|effect| drives(m, effect)));
    let conditions: Vec<_> = m.conditions.iter().map(|c| &c.name).collect();
    let factors = m.conditions.iter().map(|c| {
        let factors = c.effects.iter().map(|(present, effect)| {
            let not = (!present).then(|| quote!(!));
            quote!(#not #effect)
        });
        quote!(#(#factors)&&*)
    });
    quote! {
        /// Which effects and conditions a scene meets.
        #[allow(dead_code, reason = "not every effect has its own terms")]
        struct Met { #(#effects: bool,)* #(#conditions: bool,)* #some_drive: bool }

        impl Met {
            /// With these effects.
            #[allow(unused_variables, reason = "a model may have no effects")]
            fn new(effects: &Effects) -> Self {
                #(let #effects = effects.contains(#numbers);)*
                #(let #conditions = #factors;)*
                let #some_drive = false #(|| #drives)*;
                Self { #(#effects,)* #(#conditions,)* #some_drive }
            }
        }
    }
}

/// The field of `Met` for scenes with an effect that [drives].
pub fn some_drive() -> Ident {
    format_ident!("some_drive")
}

/// The boolean expression for an effect or condition, in a function that has `met`.
pub fn is_met(condition: &Ident) -> TokenStream {
    quote!(met.#condition)
}

fn index(m: &Model, name: &Ident) -> Option<usize> {
    m.effects.iter().position(|e| e.name == *name)
}
