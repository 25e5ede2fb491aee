//! The expansion of the sample, and the errors.

use proc_macro2::TokenStream;

use crate::expand::expand;

/// What stands between the braces of `equations! { .. }` in the generated file.
fn sample() -> TokenStream {
    let file =
        syn::parse_file(include_str!("../../../gearsim/src/generated/gear_pair.rs")).unwrap();
    let tokens = file.items.into_iter().find_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac.tokens),
        _ => None,
    });
    tokens.unwrap()
}

#[test]
fn gear_pair() {
    let code = syn::parse2(expand(sample())).unwrap();
    insta::assert_snapshot!(prettyplease::unparse(&code));
}
