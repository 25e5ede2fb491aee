//! The macro as a plain function: parse, check, emit. Tests and fuzz targets include this folder and call the function, because a
//! proc-macro crate can export only its macros.

mod cells;
pub mod check;
mod cold;
mod deflections;
mod describe;
mod effects;
pub mod emit;
mod gated;
mod gradients;
mod hoist;
mod items;
mod jumps;
mod lets;
pub mod model;
mod parse;
mod resolve;
mod scope;
mod sums;
mod switches;
mod terms;
mod tokens;
mod variants;
mod varies;

use proc_macro2::TokenStream;

use crate::equations::model::Model;

/// The code for a file of derived equations, or all its errors as `compile_error!`.
pub fn expand(input: TokenStream) -> TokenStream {
    let model = syn::parse2::<Model>(input).and_then(|mut model| {
        crate::equations::check::check(&mut model)?;
        Ok(model)
    });
    model.map_or_else(|e| e.to_compile_error(), crate::equations::emit::emit)
}
