//! Deflections and their rates as variables. A deflection `q - edge - e` is `q` at first; `edge` and `e` are subtracted only with
//! their effects, so that scenes without them do not compute with zeros.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{BinOp, Expr, Ident};

use crate::equations::gated::{Gated, gated};
use crate::equations::lets::names;
use crate::equations::model::{Assignment, Model};

/// The statements that complete deflections, for each effect.
pub type Offsets = Vec<(Ident, TokenStream)>;

/// `let NAME = ..;` without the addends that exist only with an effect. The statements that add these addends go to `offsets`.
pub fn deflection(m: &Model, Assignment { name, value }: &Assignment, offsets: &mut Offsets) -> TokenStream {
    let (mut always, mut mutable) = (quote!(), quote!());
    for (minus, addend) in addends(value, false) {
        let sign = if minus { quote!(-) } else { quote!(+) };
        let named = names(addend);
        if let Some(effect) =
            m.functions.iter().find_map(|f| f.with.as_ref().filter(|_| named.contains(&f.name.to_string())))
        {
            // The functions and symbols in this addend are variables already.
            mutable = quote!(mut);
            let add = quote!(#name = #name #sign #addend;);
            match offsets.iter_mut().find(|(known, _)| known == effect) {
                Some((_, adds)) => adds.extend(add),
                None => offsets.push((effect.clone(), add)),
            }
            continue;
        }
        match offset(m, addend) {
            Some(Gated { name: symbol, effect, place, .. }) => {
                mutable = quote!(mut);
                let add = quote!(let #symbol = k[#place]; #name = #name #sign #addend;);
                match offsets.iter_mut().find(|(known, _)| known == effect) {
                    Some((_, adds)) => adds.extend(add),
                    None => offsets.push((effect.clone(), add)),
                }
            }
            None if always.is_empty() && !minus => always = quote!(#addend),
            None => always.extend(quote!(#sign #addend)),
        }
    }
    quote!(let #mutable #name = #always;)
}

/// The edge or transmission error in an addend, which is zero without its effect. A factor whose value without its effect is 1 is not an
/// offset.
pub fn offset<'a>(m: &'a Model, addend: &Expr) -> Option<Gated<'a>> {
    let named = names(addend);
    gated(m).find(|value| value.neutral == 0.0 && named.contains(&value.name.to_string()))
}

/// The addends of a sum, each with whether it is subtracted.
pub fn addends(e: &Expr, minus: bool) -> Vec<(bool, &Expr)> {
    match e {
        Expr::Binary(e) if matches!(e.op, BinOp::Add(_) | BinOp::Sub(_)) => {
            let right = minus ^ matches!(e.op, BinOp::Sub(_));
            [addends(&e.left, minus), addends(&e.right, right)].concat()
        }
        e => vec![(minus, e)],
    }
}
