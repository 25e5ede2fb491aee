//! Parsers for small parts of the grammar: lists in braces, numbers, keywords of this grammar.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Lit, LitStr, Result, Token, braced};

/// `{ ITEM ITEM .. }`
pub fn list<T: Parse>(input: ParseStream) -> Result<Vec<T>> {
    let inner;
    braced!(inner in input);
    let mut items = vec![];
    while !inner.is_empty() {
        items.push(inner.parse()?);
    }
    Ok(items)
}

/// `{ NAME {..} NAME {..} }`, each name one of `names` and at most once; `store` parses what follows the name with this index.
pub fn parts(
    input: ParseStream,
    names: &[&str],
    mut store: impl FnMut(usize, ParseStream) -> Result<()>,
) -> Result<()> {
    let inner;
    braced!(inner in input);
    let mut seen = vec![];
    while !inner.is_empty() {
        let span = inner.span();
        let part = choice(&inner, names)?;
        if seen.contains(&part) {
            return Err(Error::new(span, format!("a second `{}`", names[part])));
        }
        seen.push(part);
        store(part, &inner)?;
    }
    Ok(())
}

/// `, "doc";`
pub fn doc(input: ParseStream) -> Result<LitStr> {
    input.parse::<Token![,]>()?;
    let doc = input.parse()?;
    input.parse::<Token![;]>()?;
    Ok(doc)
}

/// `with EFFECT`, or nothing.
pub fn with(input: ParseStream) -> Result<Option<Ident>> {
    if !input.peek(Ident) {
        return Ok(None);
    }
    word(input, "with")?;
    input.parse().map(Some)
}

/// A number or `inf`, either with or without a minus.
pub fn number(input: ParseStream) -> Result<f64> {
    let sign = if input.parse::<Option<Token![-]>>()?.is_some() { -1.0 } else { 1.0 };
    if peek_word(input, "inf") {
        word(input, "inf")?;
        return Ok(sign * f64::INFINITY);
    }
    match input.parse()? {
        Lit::Float(x) => Ok(sign * x.base10_parse::<f64>()?),
        Lit::Int(x) => Ok(sign * x.base10_parse::<f64>()?),
        other => Err(Error::new(other.span(), "expected a number or `inf`")),
    }
}

/// The word `expected`, which need not be a keyword of Rust.
pub fn word(input: ParseStream, expected: &str) -> Result<()> {
    choice(input, &[expected]).map(drop)
}

/// Parses one of `words` and returns its index.
pub fn choice(input: ParseStream, words: &[&str]) -> Result<usize> {
    let expected = || format!("expected `{}`", words.join("` or `"));
    let found = input.call(Ident::parse_any).map_err(|e| Error::new(e.span(), expected()))?;
    words.iter().position(|w| found == w).ok_or_else(|| Error::new(found.span(), expected()))
}

/// Whether the next token is the word `expected`.
pub fn peek_word(input: ParseStream, expected: &str) -> bool {
    input.fork().parse::<Ident>().is_ok_and(|found| found == expected)
}
