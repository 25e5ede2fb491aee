//! The macro as a plain function: parse, check, emit.

use proc_macro2::TokenStream;

use crate::model::Model;

/// The code for a file of derived equations, or all its errors as `compile_error!`.
pub fn expand(input: TokenStream) -> TokenStream {
    let model = syn::parse2::<Model>(input).and_then(|mut model| {
        crate::check::check(&mut model)?;
        Ok(model)
    });
    model.map_or_else(|e| e.to_compile_error(), crate::emit::emit)
}
