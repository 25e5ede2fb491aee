//! The functions that are not called at every step.

use std::collections::BTreeSet;

use proc_macro2::{Group, Literal, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::{Index, Lit};

use self::Takes::{Coordinates, Slopes, Values};
use crate::equations::effects::is_met;
use crate::equations::gradients::{self, ByVariable};
use crate::equations::jumps::jumps;
use crate::equations::lets::with_lets;
use crate::equations::model::*;
use crate::equations::scope::speed;
use crate::equations::sums::{block, body, by_index, position};
use crate::equations::switches;
use crate::equations::terms::Terms;

/// A function that is generated twice: for `Numbers`, with `met` as its first argument, and for `Equations`, without it.
pub struct Cold {
    pub name: &'static str,
    pub takes: &'static [Takes],
    pub returns: Returns,
    pub body: TokenStream,
}

/// An argument: its type and its name.
pub enum Takes {
    /// Coordinates or speeds: n numbers.
    Coordinates(&'static str),
    /// Values of the laws and of the symbols of switches.
    Values(&'static str),
    /// Derivatives of the laws.
    Slopes(&'static str),
    /// An index.
    Index(&'static str),
    /// A number.
    Number(&'static str),
    /// Quantities that only the engine knows.
    Known(&'static str),
}

/// The type of a result.
pub enum Returns {
    /// A value of this type, in both functions.
    Plain(TokenStream),
    /// A value of a type that depends on the type of the numbers, in both functions.
    In(fn(&TokenStream) -> TokenStream),
    /// n numbers.
    Vector,
    /// n x n numbers.
    Matrix,
    /// Two matrices.
    Matrices,
}

impl Cold {
    /// The definition of the function, in numbers of type `r`.
    pub fn define(&self, m: &Model, r: &TokenStream) -> TokenStream {
        let (name, body, n) = (format_ident!("{}", self.name), &self.body, Index::from(m.coordinates.len()));
        let (values, laws) = (m.values(), Index::from(m.laws.len()));
        let takes = self.takes.iter().map(|takes| match takes {
            Takes::Coordinates(name) => argument(name, quote!(&[#r; #n])),
            Takes::Values(name) => argument(name, quote!(&[#r; #values])),
            Takes::Slopes(name) => argument(name, quote!(&[#r; #laws])),
            Takes::Index(name) => argument(name, quote!(usize)),
            Takes::Number(name) => argument(name, r.clone()),
            Takes::Known(name) => argument(name, quote!(&equations::Known)),
        });
        let returns = match &self.returns {
            Returns::Plain(plain) => plain.clone(),
            Returns::In(of) => of(r),
            Returns::Vector => quote!([#r; #n]),
            Returns::Matrix => quote!([[#r; #n]; #n]),
            Returns::Matrices => quote!([[[#r; #n]; #n]; 2]),
        };
        quote! {
            #[inline(never)]
            fn #name(&self, met: &Met, #(#takes),*) -> #returns { #body }
        }
    }

    /// The function of `Equations` that calls this one. Its vectors are slices, and its matrices have the matrix type of the engine.
    pub fn call(&self) -> TokenStream {
        let name = format_ident!("{}", self.name);
        let takes = self.takes.iter().map(|takes| match takes {
            Takes::Coordinates(name) | Takes::Values(name) | Takes::Slopes(name) => argument(name, quote!(&[f64])),
            Takes::Index(name) => argument(name, quote!(usize)),
            Takes::Number(name) => argument(name, quote!(f64)),
            Takes::Known(name) => argument(name, quote!(&equations::Known)),
        });
        let given = self.takes.iter().map(|takes| {
            let (Takes::Coordinates(name)
            | Takes::Values(name)
            | Takes::Slopes(name)
            | Takes::Index(name)
            | Takes::Number(name)
            | Takes::Known(name)) = takes;
            let name = format_ident!("{name}");
            match takes {
                Takes::Coordinates(_) => quote!(equations::array(#name)),
                Takes::Values(_) | Takes::Slopes(_) => quote!(equations::values(#name)),
                _ => quote!(#name),
            }
        });
        let value = quote!(self.numbers.#name(&self.met, #(#given),*));
        let (returns, value) = match &self.returns {
            Returns::Plain(plain) => (plain.clone(), value),
            Returns::In(of) => (of(&quote!(f64)), value),
            Returns::Vector => (quote!(Vector), quote!(#value.into())),
            Returns::Matrix => (quote!(Matrix), quote!(equations::matrix(&#value))),
            Returns::Matrices => (quote!([Matrix; 2]), quote!(#value.each_ref().map(equations::matrix))),
        };
        quote!(fn #name(&self, #(#takes),*) -> #returns { #value })
    }
}

/// Converts code in f64 into code in the number type R: float literals become `R::from(..)`, and the type `f64` becomes `R`.
pub fn in_any_number(code: TokenStream) -> TokenStream {
    let each = |token| match token {
        TokenTree::Group(group) => {
            TokenTree::Group(Group::new(group.delimiter(), in_any_number(group.stream()))).into()
        }
        TokenTree::Literal(number) if is_float(&number) => quote!(R::from(#number)),
        TokenTree::Ident(name) if name == "f64" => quote!(R),
        other => other.into(),
    };
    code.into_iter().map(each).collect::<Vec<TokenStream>>().into_iter().collect()
}

/// Whether a literal is a number of type f64. syn reads a literal such as `1f64` as an integer with a suffix.
fn is_float(literal: &Literal) -> bool {
    match syn::parse2(quote!(#literal)) {
        Ok(Lit::Float(_)) => true,
        Ok(Lit::Int(number)) => number.suffix() == "f64",
        _ => false,
    }
}

fn argument(name: &str, of: TokenStream) -> TokenStream {
    let name = format_ident!("{name}");
    quote!(#name: #of)
}

/// The functions in f64. Those that describe a cell, in any kind of number, are in [`crate::equations::cells`].
pub fn cold(m: &Model) -> Vec<Cold> {
    let cold = |name, takes, returns, body| Cold { name, takes, returns, body };
    let number = || Returns::Plain(quote!(f64));

    let kinetic = with_lets(m, body(&m.kinetic));
    let torques = m.torques.iter().map(|t| block(&t.work));
    let work = body(&work(m));
    let motions = m.motions.iter().map(|x| motion(m, x));
    let i = || format_ident!("i");
    let mut all = vec![
        cold("kinetic", &[Coordinates("q"), Coordinates("q_dot")], number(), kinetic),
        cold("torque_work", &[Takes::Index("i"), Coordinates("dq")], number(), by_index("torque", i(), torques)),
        cold("work", &[Coordinates("dq")], number(), work),
        cold(
            "jacobian",
            &[Coordinates("q"), Coordinates("q_dot"), Values("k"), Slopes("dk"), Slopes("ddk")],
            Returns::Matrices,
            jacobian(m),
        ),
        cold("motion", &[Takes::Index("i")], Returns::Vector, by_index("motion", i(), motions)),
        cold("switching", &[Takes::Index("law")], Returns::Plain(quote!(equations::Switching)), switching(m)),
    ];
    all.extend(jumps(m));
    all.extend(powers(m));
    all.extend(moving_inertia(m));
    all.extend(output(m));
    all.extend(switches::lost(m));
    all.extend(switches::bends(m));
    all
}

/// The statements of the function that returns the derivatives of the forces by the coordinates and by the speeds. The derivatives by
/// deflections and their rates are first summed in `by`. The chain rule with the gradients of the deflections then adds them to the
/// derivatives by coordinates and speeds.
fn jacobian(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries: Vec<&Entry> = m.jacobian.iter().flatten().collect();
    let columns: Vec<ByVariable> = entries.iter().map(|e| ByVariable::of(m, &e.column)).collect();
    let through = |d: &usize| columns.contains(&ByVariable::Deflection(*d)) || columns.contains(&ByVariable::Rate(*d));
    let through: Vec<usize> = (0..m.deflections.len()).filter(through).collect();
    let terms = Terms::of_jacobian(m).add(m, |at| {
        let i = position(m, &entries[at].row);
        let by = |d| through.iter().position(|known| *known == d).map(Index::from);
        match columns[at] {
            ByVariable::Coordinate(j) => {
                let j = Index::from(j);
                quote!(v[0][#i][#j])
            }
            ByVariable::Speed(j) => {
                let j = Index::from(j);
                quote!(v[1][#i][#j])
            }
            ByVariable::Deflection(d) => {
                let d = by(d);
                quote!(by[0][#d][#i])
            }
            ByVariable::Rate(d) => {
                let d = by(d);
                quote!(by[1][#d][#i])
            }
        }
    });
    let count = Index::from(through.len());
    let gradients = through.iter().map(|d| gradients::bent(m, *d));
    let add = (!through.is_empty()).then(|| {
        let gradients = with_lets(m, quote!(let gradients: [&[(usize, f64)]; #count] = [#(&#gradients),*];));
        quote!(#gradients equations::add_through(&mut v, &by, &gradients);)
    });
    quote!(let mut v = [[[0.0; #n]; #n]; 2]; let mut by = [[[0.0; #n]; #count]; 2]; #terms #add v)
}

/// The function that computes an output from its number; none if the model has no outputs. The sum with 0.0 turns the -0.0 of a sum
/// without terms into 0.0.
fn output(m: &Model) -> Option<Cold> {
    let outputs = m.outputs.iter().map(|output| with_lets(m, block(&output.value.sum))).map(|value| quote!({ #value }));
    let output = by_index("output", format_ident!("i"), outputs);
    (!m.outputs.is_empty()).then(|| Cold {
        name: "output",
        takes: &[Takes::Index("i"), Coordinates("q"), Coordinates("q_dot"), Values("k"), Takes::Known("known")],
        returns: Returns::Plain(quote!(f64)),
        body: quote!(let output: f64 = #output; output + 0.0),
    })
}

/// Two functions: the power of each torque, and whether the torque depends on the state. No function if all torques of the model are
/// constant.
fn powers(m: &Model) -> Vec<Cold> {
    if m.torques.iter().all(|t| t.power.is_empty()) {
        return vec![];
    }
    let power = by_index("torque", format_ident!("i"), m.torques.iter().map(|t| block(&t.power)));
    let present = m.torques.iter().map(|torque| {
        let always = torque.power.iter().any(|t| t.condition.is_none());
        let present = torque.power.iter().filter_map(|t| t.condition.as_ref()).map(is_met);
        quote!({ #always #(|| #present)* })
    });
    let present = by_index("torque", format_ident!("i"), present);
    vec![
        Cold {
            name: "torque_power",
            takes: &[Takes::Index("i"), Coordinates("q"), Coordinates("q_dot"), Values("k")],
            returns: Returns::Plain(quote!(f64)),
            body: with_lets(m, power),
        },
        Cold { name: "has_power", takes: &[Takes::Index("i")], returns: Returns::Plain(quote!(bool)), body: present },
    ]
}

/// Two functions: the derivatives of M q'' by the coordinates, and whether M is constant. No functions if M is constant with any set of
/// effects.
fn moving_inertia(m: &Model) -> Vec<Cold> {
    let terms: Vec<_> = m.inertia.iter().flat_map(|e| &e.sum).collect();
    if terms.is_empty() {
        return vec![];
    }
    let n = Index::from(m.coordinates.len());
    let entries = m.inertia.iter().map(|e| {
        let (i, j, value) = (position(m, &e.row), position(m, &e.column), block(&e.sum));
        quote!(v[#i][#j] = #value;)
    });
    let always = terms.iter().any(|t| t.condition.is_none());
    let present: BTreeSet<_> = terms.iter().filter_map(|t| t.condition.clone()).collect();
    let present = present.iter().map(is_met);
    vec![
        Cold {
            name: "inertia",
            takes: &[Coordinates("q"), Coordinates("q_ddot")],
            returns: Returns::Matrix,
            body: with_lets(m, quote!(let mut v = [[0.0; #n]; #n]; #(#entries)* v)),
        },
        Cold {
            name: "is_inertia_constant",
            takes: &[],
            returns: Returns::Plain(quote!(bool)),
            body: quote!(!(#always #(|| #present)*)),
        },
    ]
}

/// The work of all constant torques: every generalised force times the change of its coordinate.
fn work(m: &Model) -> Sum {
    let terms = m.work.iter().flat_map(|row| {
        let i = position(m, &row.name);
        row.sum.iter().map(move |t| {
            let force = &t.value;
            Term { condition: t.condition.clone(), value: syn::parse_quote!((#force) * dq[#i]) }
        })
    });
    terms.collect()
}

fn motion(m: &Model, motion: &RigidMotion) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let speeds = motion.speeds.iter().map(|Assignment { name, value }| {
        let i = m.coordinates.iter().position(|c| *name == speed(&c.name)).map(Index::from);
        quote!(q_dot[#i] = #value;)
    });
    quote!({ let mut q_dot = [0.0; #n]; #(#speeds)* q_dot })
}

fn switching(m: &Model) -> TokenStream {
    let Some(step) = m.switching(How::WithJump).map(is_met) else { return quote!(equations::Switching::Never) };
    let otherwise = |how: How| {
        let (met, case) = (m.switching(how).map(is_met)?, format_ident!("{how:?}"));
        Some(quote!(if #met { equations::Switching::#case } else))
    };
    let (by_time, without) = (otherwise(How::ByTime), otherwise(How::WithoutJump));
    // A law whose effect is absent is zero, and never switches.
    let gated = m.laws.iter().enumerate().filter_map(|(i, law)| Some((Index::from(i), is_met(law.with.as_ref()?))));
    let (gated, there): (Vec<_>, Vec<_>) = gated.unzip();
    quote! {
        if !#step #(|| law == #gated && !#there)* { equations::Switching::Never } else #by_time #without { equations::Switching::WithJump }
    }
}
