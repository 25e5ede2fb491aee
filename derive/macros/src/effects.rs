//! Effects: the sets that may be in force, and the constants by which code is in or out.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::{Error, Ident};

use crate::check::unique;
use crate::model::Model;

/// The effects of a mesh that say how a law switches; every model means the same by these names.
pub const STIFFNESS_STEP: &str = "stiffness_step";
/// Switches where the phase says, without the impulse.
pub const RIGID_KINEMATICS: &str = "rigid_kinematics";
/// Switches when the mean rotation says.
pub const FROZEN_PHASE: &str = "frozen_phase";

/// Each set of effects is compiled by itself, so there is a limit to their number.
const MOST_SETS: usize = 1024;
/// Beyond this even counting the sets takes long.
const MOST_EFFECTS: usize = 16;

/// Whether the model offers an effect.
pub fn has(m: &Model, effect: &str) -> bool {
    m.effects.iter().any(|e| e.name == effect)
}

/// Effects and conditions name one another rightly, and are not too many.
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
            errors.push(Error::new(name.span(), format!("no effect is called `{name}`")));
        }
    }
    if errors.len() == before && (m.effects.len() > MOST_EFFECTS || sets(m).nth(MOST_SETS).is_some()) {
        let message = format!(
            "the {} effects combine in more than {MOST_SETS} ways, each compiled by itself: \
             exclude some, or split the model",
            m.effects.len()
        );
        errors.push(Error::new(m.name.span(), message));
    }
}

/// The sets of effects that contradict nothing, as bits.
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

/// `const DAMPING: bool = E & 8 != 0;` for each effect, and for each condition its conjunction.
pub fn constants(m: &Model) -> TokenStream {
    let named = named(m, &quote!(E), &quote!(Self::)).into_iter();
    let named = named.map(|(name, value)| quote!(const #name: bool = #value;));
    quote!(#(#named)*)
}

/// The same as variables, of the set `effects`.
pub fn variables(m: &Model) -> TokenStream {
    let named = named(m, &quote!(effects), &quote!()).into_iter();
    let named = named.map(|(name, value)| quote!(let #name = #value;));
    quote!(#(#named)*)
}

/// Every effect and condition with the expression that tells whether it is in force in `set`.
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
