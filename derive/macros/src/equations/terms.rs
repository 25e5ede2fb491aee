//! The functions that are called at every step, and the Jacobian. All terms of an effect or condition are in one block of code, behind one
//! test. So code grows with the number of effects, not with the number of their combinations, and a scene executes no terms of absent
//! effects. The functions that are called at every step also have variants without some of these blocks.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Ident, Index};

use crate::equations::effects::{is_met, some_drive};
use crate::equations::lets::lets;
use crate::equations::model::{Model, Sum};
use crate::equations::sums::position;
use crate::equations::variants::{Variants, drives};

/// The terms of a sum or of a vector of sums.
pub struct Terms {
    /// Blocks by condition; terms that are always present come first. The terms of each sum keep their order in the file.
    blocks: Vec<(Option<Ident>, Vec<Addend>)>,
}

/// A term: the index of its sum, and its value.
type Addend = (usize, Expr);

impl Terms {
    /// The terms of the generalised forces.
    pub fn of_force(m: &Model) -> Self {
        Self::of(m.force.iter().flatten().map(|row| (place(m, &row.name), &row.sum)))
    }

    /// The terms of Rayleigh's dissipation function.
    pub fn of_dissipation(m: &Model) -> Self {
        Self::of([(0, &m.dissipation)])
    }

    /// The terms of the entries of the Jacobian, in the order of the entries.
    pub fn of_jacobian(m: &Model) -> Self {
        Self::of(m.jacobian.iter().flatten().map(|e| &e.sum).enumerate())
    }

    fn of<'a>(sums: impl IntoIterator<Item = (usize, &'a Sum)>) -> Self {
        let mut blocks: Vec<(Option<Ident>, Vec<Addend>)> = vec![(None, vec![])];
        for (i, sum) in sums {
            let mut before = 0;
            for term in sum {
                let block = blocks.iter().position(|(condition, _)| *condition == term.condition);
                before = block.unwrap_or_else(|| {
                    blocks.insert(before + 1, (term.condition.clone(), vec![]));
                    before + 1
                });
                blocks[before].1.push((i, term.value.clone()));
            }
        }
        Self { blocks }
    }

    /// The values of all terms.
    pub fn values(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.blocks.iter_mut().flat_map(|(_, addends)| addends).map(|(_, value)| value)
    }

    /// The statements that add up the terms. `at` gives the variable of each sum.
    pub fn add(&self, m: &Model, at: impl Fn(usize) -> TokenStream) -> TokenStream {
        let add = |addends: &[Addend]| -> TokenStream {
            let add = addends.iter().map(|(i, value)| {
                let at = at(*i);
                quote!(#at += #value;)
            });
            add.collect()
        };
        // The variables of the terms that are always present are defined once, for all blocks. Each block defines the other variables that
        // it needs.
        let always = add(&self.blocks[0].1);
        let code = |(condition, addends): &(Option<Ident>, Vec<Addend>)| match condition.as_ref().map(is_met) {
            None => {
                let lets = lets(m, &always, &quote!());
                quote!(#lets #always)
            }
            Some(met) => {
                let add = add(addends);
                let lets = lets(m, &add, &always);
                quote!(if #met { #lets #add })
            }
        };
        // Few scenes have a motor or a fan, so one test skips all of their blocks.
        let drives = |(condition, _): &(Option<Ident>, Vec<Addend>)| condition.as_ref().is_some_and(|c| drives(m, c));
        let groups = self.blocks.chunk_by(|a, b| drives(a) && drives(b)).map(|group| {
            let blocks: TokenStream = group.iter().map(code).collect();
            let some = some_drive();
            if group.len() > 1 { quote!(if met.#some { #blocks }) } else { blocks }
        });
        groups.collect()
    }
}

fn place(m: &Model, name: &Ident) -> usize {
    position(m, name).index as usize
}

/// The functions `force` and `dissipation` of `Numbers`, with these terms.
pub fn functions(m: &Model, variants: &Variants, force: &Terms, dissipation: &Terms) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let (values, laws) = (m.values(), Index::from(m.laws.len()));
    let force = force.add(m, |i| {
        let i = Index::from(i);
        quote!(v[#i])
    });
    let dissipation = dissipation.add(m, |_| quote!(v));
    let (force, dissipation, parameters) =
        (variants.tested(force), variants.tested(dissipation), variants.parameters());
    quote! {
        #[inline(always)]
        fn force<#parameters>(&self, met: &Met, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64; #values], dk: &[f64; #laws], force: &mut [f64; #n]) {
            // -0.0 + x is x for every x, so the compiler drops the addition. 0.0 + x is not x for x = -0.0.
            let mut v = [-0.0; #n];
            #force
            *force = v;
        }

        #[inline(always)]
        fn dissipation<#parameters>(&self, met: &Met, q: &[f64; #n], q_dot: &[f64; #n], k: &[f64; #values]) -> f64 {
            let mut v = 0.0;
            #dissipation
            v
        }
    }
}
