//! Effects: the admissible sets of them, and the constants and variables by which generated code tests them.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::{Error, Ident};

use crate::check::unique;
use crate::model::Model;

/// Laws switch where the phase reaches a boundary. This effect and the next two have the same meaning in every model.
pub const STIFFNESS_STEP: &str = "stiffness_step";
/// Laws switch where the phase reaches a boundary, without the impulse.
pub const RIGID_KINEMATICS: &str = "rigid_kinematics";
/// Laws switch at the times of a steady rotation.
pub const FROZEN_PHASE: &str = "frozen_phase";

/// Largest number of sets of effects: each is compiled separately.
const MOST_SETS: usize = 1024;
/// Largest number of effects: with more, even counting the sets takes long.
const MOST_EFFECTS: usize = 16;

/// Whether the model offers an effect.
pub fn has(m: &Model, effect: &str) -> bool {
    m.effects.iter().any(|e| e.name == effect)
}

/// Effects and conditions must refer to effects that exist, and there must not be too many sets of effects.
pub fn check(m: &Model, errors: &mut Vec<Error>) {
    let before = errors.len();
    unique(
        "effect or condition",
        m.effects.iter().map(|e| &e.name).chain(m.conditions.iter().map(|c| &c.name)),
        errors,
    );
    let related = m.effects.iter().flat_map(|e| e.requires.iter().chain(&e.excludes));
    let related = related.chain(m.nonlinear_with.iter().map(|n| &n.effect));
    let related = related.chain(m.parameters.iter().filter_map(|p| p.with.as_ref()));
    let related = related.chain(m.laws.iter().filter_map(|l| l.with.as_ref()));
    let related = related.chain(m.dead_bands.iter().map(|band| &band.effect));
    for name in related.chain(m.conditions.iter().flat_map(|c| c.effects.iter().map(|(_, name)| name))) {
        if index(m, name).is_none() {
            errors.push(Error::new(name.span(), format!("there is no effect `{name}`")));
        }
    }
    if errors.len() == before && (m.effects.len() > MOST_EFFECTS || sets(m).nth(MOST_SETS).is_some()) {
        let message = format!(
            "the {} effects have more than {MOST_SETS} admissible sets, each of which is compiled separately: \
             let effects exclude one another, or split the model",
            m.effects.len()
        );
        errors.push(Error::new(m.name.span(), message));
    }
}

/// The admissible sets of effects, by `requires` and `excludes`: bit i stands for effect i.
pub fn sets(m: &Model) -> impl Iterator<Item = u32> {
    let bits = |names: &[Ident]| names.iter().filter_map(|n| index(m, n)).fold(0u32, |bits, i| bits | 1 << i);
    let rules: Vec<_> = m.effects.iter().map(|e| (bits(&e.requires), bits(&e.excludes))).collect();
    (0..1u32 << m.effects.len()).filter(move |set| {
        let holds = |(i, (requires, excludes)): (usize, &(u32, u32))| {
            set & 1 << i == 0 || (set & requires == *requires && set & excludes == 0)
        };
        rules.iter().enumerate().all(holds)
    })
}

/// A set as a literal with one digit for each effect, the last effect first: `0b11001`.
pub fn literal(m: &Model, set: u32) -> TokenStream {
    format!("0b{set:0width$b}", width = m.effects.len().max(1)).parse().expect("digits")
}

/// `const DAMPING: bool = E & 8 != 0;` for each effect, and the conjunction of its effects for each condition.
pub fn constants(m: &Model) -> TokenStream {
    let named = named(m, &quote!(E), &quote!(Self::)).into_iter();
    let named = named.map(|(name, value)| quote!(const #name: bool = #value;));
    quote!(#(#named)*)
}

/// The same as variables, from the set `effects`.
pub fn variables(m: &Model) -> TokenStream {
    let named = named(m, &quote!(effects), &quote!()).into_iter();
    let named = named.map(|(name, value)| quote!(let #name = #value;));
    quote!(#(#named)*)
}

/// Every effect and condition with the boolean expression for it in `set`.
fn named(m: &Model, set: &TokenStream, path: &TokenStream) -> Vec<(Ident, TokenStream)> {
    let effects = m.effects.iter().enumerate().map(|(i, e)| {
        let bit = Literal::u32_unsuffixed(1 << i);
        (constant(&e.name), quote!(#set & #bit != 0))
    });
    let conditions = m.conditions.iter().map(|c| {
        let factors = c.effects.iter().map(|(present, effect)| {
            let (not, effect) = ((!present).then(|| quote!(!)), constant(effect));
            quote!(#not #path #effect)
        });
        (constant(&c.name), quote!(#(#factors)&&*))
    });
    effects.chain(conditions).collect()
}

/// `DAMPING` for `damping`.
pub fn constant(name: &Ident) -> Ident {
    format_ident!("{}", name.to_string().to_uppercase(), span = name.span())
}

fn index(m: &Model, name: &Ident) -> Option<usize> {
    m.effects.iter().position(|e| e.name == *name)
}
