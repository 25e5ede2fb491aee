//! The functions that describe the switches of a scene to the engine.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::{ToTokens, TokenStreamExt, quote};
use syn::{Ident, Index};

use crate::equations::cold::{Cold, Returns, Takes, in_any_number};
use crate::equations::effects::is_met;
use crate::equations::gated::{self, Gated, gated};
use crate::equations::lets::{is_bent, names, with_lets};
use crate::equations::model::{Exit, Function, Model, Row, Switch};
use crate::equations::sums::block;

/// The rows of a linear form that are neither a deflection nor a rate.
pub const CONSTANT: &str = "one";
pub const REACTION: &str = "reaction";

/// A match over the switches.
fn of_each(m: &Model, arm: impl Fn(&Switch) -> TokenStream) -> TokenStream {
    let arms = m.switches.iter().enumerate().map(|(i, switch)| {
        let (i, arm) = (Index::from(i), arm(switch));
        quote!(#i => #arm,)
    });
    quote!(match i { #(#arms)* _ => equations::no_such("switch", i) })
}

/// The functions `mode`, `exits`, `switched` and `deflection` of the switches, in any kind of number.
pub fn cells(m: &Model) -> Vec<Cold> {
    let n = Index::from(m.coordinates.len());
    let values = of_each(m, |switch| {
        let mut distinct = Distinct::default();
        let modes = switch.modes.iter().map(|of| {
            let places = of.values.iter().map(|value| distinct.place(quote!(#value)));
            let places: Vec<_> = places.collect();
            quote!(&[#(#places),*])
        });
        let modes: Vec<_> = modes.collect();
        let effect = is_met(&switch.effect);
        quote!(#effect.then(|| equations::mode(&[#(#modes),*], mode, &[#distinct])))
    });
    let exits = of_each(m, |switch| {
        let mut distinct = Distinct::default();
        let modes = switch.modes.iter().map(|of| {
            let exits = of.exits.iter().map(|exit| self::exit(m, switch, exit, &mut distinct));
            let exits: Vec<_> = exits.collect();
            quote!(&[#(#exits),*])
        });
        let modes: Vec<_> = modes.collect();
        quote!(equations::exits(#n, &[#(#modes),*], mode, &[#distinct], of))
    });
    let exits = quote! {
        let of: &dyn Fn(usize) -> equations::Deflection<f64> = &|index| self.deflection(met, index, q, k);
        #exits
    };
    let over = of_each(m, |switch| {
        let d = deflection_index(m, &switch.over);
        quote!(#d)
    });
    let cold = |name, takes: &'static [Takes], returns, body| Cold { name, takes, returns, body };
    vec![
        cold(
            "mode",
            &[Takes::Index("i"), Takes::Index("mode")],
            Returns::In(|r| quote!(Option<Vec<#r>>)),
            in_any_number(values),
        ),
        cold(
            "exits",
            &[Takes::Index("i"), Takes::Index("mode"), Takes::Coordinates("q"), Takes::Values("k")],
            Returns::In(|r| quote!(Vec<equations::Exit<#r>>)),
            in_any_number(with_lets(m, exits)),
        ),
        cold("switched", &[Takes::Index("i")], Returns::Plain(quote!(usize)), over),
        deflection(m),
    ]
}

/// The function `lost` of `Equations`; none if the model has no switch.
pub fn lost(m: &Model) -> Option<Cold> {
    let lost = of_each(m, |switch| {
        let of =
            |name: &str| switch.loss.iter().find(|row| row.name == name).map_or(quote!(0.0), |row| block(&row.sum));
        let (constant, slope) = (of(CONSTANT), of(&switch.over.to_string()));
        quote!([#constant, #slope])
    });
    (!m.switches.is_empty()).then(|| Cold {
        name: "lost",
        takes: &[Takes::Index("i"), Takes::Values("k")],
        returns: Returns::Plain(quote!([f64; 2])),
        body: with_lets(m, lost),
    })
}

/// The distinct values in the modes of a switch. The table of a mode has indices into this list. Tables are data; code for each mode would
/// be larger than all other code of a model.
#[derive(Default)]
struct Distinct(Vec<TokenStream>);

impl Distinct {
    /// The index of a value in the list. Adds the value if it is new.
    fn place(&mut self, value: TokenStream) -> Index {
        let known = self.0.iter().position(|known| known.to_string() == value.to_string());
        Index::from(known.unwrap_or_else(|| {
            self.0.push(value);
            self.0.len() - 1
        }))
    }
}

impl ToTokens for Distinct {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.append_separated(&self.0, quote!(,));
    }
}

/// An exit of a mode: the index of the next mode, and the addends of its guard. The factor of each addend is given by its index in
/// `distinct`.
fn exit(m: &Model, switch: &Switch, Exit { to, sudden, guard }: &Exit, distinct: &mut Distinct) -> TokenStream {
    let beyond = Index::from(switch.modes.iter().position(|mode| mode.name == *to).expect("checked"));
    let addends = guard.iter().map(|Row { name, sum }| {
        let on = match m.rates.iter().position(|rate| rate.name == *name).map(Index::from) {
            _ if name == CONSTANT => quote!(One),
            _ if name == REACTION => quote!(Reaction),
            Some(d) => quote!(Rate(#d)),
            None => {
                let d = deflection_index(m, name);
                quote!(Deflection(#d))
            }
        };
        let factor = distinct.place(block(sum));
        quote!((equations::On::#on, #factor))
    });
    quote!((#beyond, #sudden, &[#(#addends),*]))
}

/// The names of the deflections that a switch, or a guard of one, refers to.
fn referred(m: &Model) -> BTreeSet<String> {
    let guards = m.switches.iter().flat_map(|s| &s.modes).flat_map(|mode| &mode.exits).flat_map(|exit| &exit.guard);
    let overs = m.switches.iter().map(|switch| switch.over.to_string());
    guards.map(|row| row.name.to_string()).chain(overs).collect()
}

/// The function `deflection`. For each deflection that switches refer to, it gives the linear form at the law values `k`; for a bent
/// deflection, its tangent at `q`.
fn deflection(m: &Model) -> Cold {
    let (n, referred) = (Index::from(m.coordinates.len()), referred(m));
    let all = m.deflections.iter().zip(&m.rates).enumerate();
    let used =
        all.filter(|(_, (x, rate))| [&x.name, &rate.name].iter().any(|name| referred.contains(&name.to_string())));
    let arms = used.map(|(d, (deflection, rate))| {
        let (d, value, slope) = (Index::from(d), &deflection.value, &rate.value);
        let used = names(value);
        let lets = |used: &BTreeSet<String>, values: &dyn Fn(&Gated<'_>) -> TokenStream| -> TokenStream {
            let lets = gated(m).filter(|gated| used.contains(&gated.name.to_string())).map(|gated| {
                let (name, value) = (gated.name, values(&gated));
                quote!(let #name = #value;)
            });
            lets.collect()
        };
        let of_mode = |Gated { effect, place, neutral, .. }: &Gated<'_>| {
            let met = is_met(effect);
            quote!(if #met { k[#place] } else { #neutral })
        };
        let with = |values: &dyn Fn(&Gated<'_>) -> TokenStream| {
            let lets = lets(&used, values);
            let functions = m.functions.iter().map(|f| &f.name).filter(|name| used.contains(&name.to_string()));
            quote!({ #lets #(let #functions = 0.0;)* let q = [0.0; #n]; #value })
        };
        let is_error = |name: &Ident| gated::errors(m).any(|(_, law)| law.name == *name);
        if is_bent(m, &deflection.value) {
            return bent(m, d, [&deflection.name, &rate.name], &errors_of(m, &used, &with));
        }
        let constant = with(&|gated| if is_error(gated.name) { quote!(0.0) } else { of_mode(gated) });
        let errors = errors_of(m, &used, &with);
        // The gradient may depend on the mode: each flank of a plane mesh has its own line of action.
        let factors = lets(&names(slope), &of_mode);
        quote! {
            #d => {
                #factors
                let normal: [f64; #n] = equations::gradient(&|q_dot: &[f64; #n]| #slope);
                let mut errors = vec![];
                #errors
                equations::Deflection { normal: R::row(&normal), constant: #constant, errors }
            }
        }
    });
    Cold {
        name: "deflection",
        takes: &[Takes::Index("i"), Takes::Coordinates("q"), Takes::Values("k")],
        returns: Returns::In(|r| quote!(equations::Deflection<#r>)),
        body: in_any_number(quote!(match i { #(#arms)* _ => equations::no_such("deflection", i) })),
    }
}

/// Gives the code for the value of each offset of a deflection.
type Offsets<'a> = &'a dyn Fn(&Gated<'_>) -> TokenStream;

/// The statements that list the transmission errors in a deflection, each with its coefficient. `used` are the names in the deflection;
/// `with` is its value for given offsets.
fn errors_of(m: &Model, used: &BTreeSet<String>, with: &dyn Fn(Offsets<'_>) -> TokenStream) -> TokenStream {
    let each = gated::errors(m).filter(|(_, law)| used.contains(&law.name.to_string())).map(|(i, law)| {
        let (i, met) = (Index::from(i), law.with.as_ref().map(is_met));
        let unit = with(&|gated| if *gated.name == law.name { quote!(1.0) } else { quote!(0.0) });
        quote!(if #met { errors.push((#i, #unit)); })
    });
    each.collect()
}

/// The match arm of a bent deflection: its gradient at `q`, and the constant for which the linear form has the value of the deflection at
/// `q`.
fn bent(m: &Model, d: Index, [name, rate]: [&Ident; 2], errors: &TokenStream) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let (value, slope) = (with_lets(m, quote!(#name)), with_lets(m, quote!(#rate)));
    quote! {
        #d => {
            let normal: [f64; #n] = equations::gradient(&|q_dot: &[f64; #n]| { #slope });
            let mut errors: Vec<(usize, f64)> = vec![];
            { #errors }
            let mut constant: f64 = { #value };
            for j in 0..#n {
                constant = constant - normal[j] * q[j];
            }
            for (law, unit) in &errors {
                constant = constant - *unit * k[*law];
            }
            equations::Deflection { normal: R::row(&normal), constant, errors }
        }
    }
}

/// The function `bends`: whether any deflection bends in a scene. `None` if no deflection of the model bends.
pub fn bends(m: &Model) -> Option<Cold> {
    let functions: Vec<_> = bending(m).collect();
    let always = functions.iter().any(|f| f.with.is_none());
    let present: BTreeSet<_> = functions.iter().filter_map(|f| f.with.clone()).collect();
    let present = present.iter().map(is_met);
    (!functions.is_empty()).then(|| Cold {
        name: "bends",
        takes: &[],
        returns: Returns::Plain(quote!(bool)),
        body: quote!(#always #(|| #present)*),
    })
}

/// The functions of positions that occur in deflections, and so make them bend.
pub fn bending(m: &Model) -> impl Iterator<Item = &Function> {
    let bent: Vec<_> = m.deflections.iter().filter(|d| is_bent(m, &d.value)).collect();
    m.functions.iter().filter(move |f| bent.iter().any(|d| names(&d.value).contains(&f.name.to_string())))
}

/// The index of a deflection; `check` has made sure that it exists.
fn deflection_index(m: &Model, name: &Ident) -> Index {
    Index::from(m.deflections.iter().position(|d| d.name == *name).expect("checked"))
}
