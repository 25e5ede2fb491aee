//! Any text as a file of derived equations: the macro gives code, or errors at places in the text. It never panics.

use std::str::FromStr;

use crate::equations::expand;

/// The text is the content of the braces of `equations! { .. }`.
pub fn check(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    // Text that is not made of Rust tokens is refused by the compiler, before the macro. Text with very many opening brackets is skipped,
    // because the parsers of proc_macro2 and syn recurse and could overflow the stack.
    let deepest = text.bytes().filter(|byte| b"([{".contains(byte)).count();
    let Some(tokens) = (deepest < 500).then(|| proc_macro2::TokenStream::from_str(&text).ok()).flatten() else {
        return;
    };
    let code = expand(tokens);
    assert!(!code.is_empty(), "neither code nor an error");
    let items = syn::parse2::<syn::File>(code).expect("the code is not Rust");
    assert!(!items.items.is_empty(), "neither code nor an error");
}
