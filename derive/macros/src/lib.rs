//! Macros.

mod check;
mod describe;
mod effects;
mod emit;
mod expand;
mod jumps;
mod model;
mod parse;
mod resolve;
mod scope;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Derived equations.
#[proc_macro]
pub fn equations(input: TokenStream) -> TokenStream {
    expand::expand(input.into()).into()
}
