//! Which parameters may vary in time in a scene: those on which the generalised forces and the work of the torques depend linearly
//! and nothing else depends, in particular no guard of a switch and no output.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{BinOp, Expr, Ident, Member};

use crate::equations::model::*;

/// How the generalised forces depend on a parameter.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Varies {
    /// It may not vary.
    Never,
    /// Linearly, with factors that are the same in every state.
    AsLoad,
    /// Linearly, with factors that depend on the state.
    WithState,
}

impl Varies {
    /// The same as a value of gearsim.
    pub fn tokens(self) -> TokenStream {
        match self {
            Varies::Never => quote!(model::Varies::Never),
            Varies::AsLoad => quote!(model::Varies::AsLoad),
            Varies::WithState => quote!(model::Varies::WithState),
        }
    }
}

/// How the parameter may vary in time.
pub fn varies(m: &Model, parameter: &Ident) -> Varies {
    let mut degrees = Degrees(vec![(parameter, 1)]);
    let apart = apart(m);
    let loads = m.torques.iter().map(|t| &t.work).chain(of_rows(&m.work)).chain(of_rows(&m.load));
    let loads = terms(loads.chain(m.force.iter().flat_map(|rows| of_rows(rows))));
    let mut of_state = vec![];
    for named in m.forces.iter().chain(&m.partials) {
        let values = terms(std::iter::once(&named.sum));
        // A force that is not linear in the parameter makes all that contains it so.
        degrees.0.push((&named.name, degrees.highest(&values).unwrap_or(2)));
        of_state.extend(values);
    }
    of_state.extend(terms(m.torques.iter().map(|t| &t.power)));
    of_state.extend(terms(m.jacobian.iter().flat_map(|entries| of_entries(entries))));
    match [&apart, &of_state, &loads].map(|values| degrees.highest(values)) {
        [Some(0), Some(0), Some(1)] => Varies::AsLoad,
        [Some(0), Some(1), Some(0 | 1)] => Varies::WithState,
        _ => Varies::Never,
    }
}

/// What must not depend on a parameter that varies.
fn apart(m: &Model) -> Vec<&Expr> {
    let mut apart = terms([&m.kinetic, &m.potential, &m.dissipation].into_iter());
    apart.extend(m.constants.iter().chain(&m.deflections).chain(&m.rates).map(|a| &a.value));
    apart.extend(m.functions.iter().map(|f| &f.value));
    apart.extend(m.motions.iter().flat_map(|motion| motion.speeds.iter().map(|s| &s.value)));
    let matrices = [&m.mass, &m.stiffness, &m.damping, &m.inertia].into_iter().chain(&m.mobility);
    apart.extend(terms(matrices.flat_map(|entries| of_entries(entries))));
    for jump in &m.jumps {
        apart.extend(terms(jump.normal.iter().chain(&jump.direction).flat_map(|rows| of_rows(rows))));
        apart.extend(terms(jump.compliance.iter().chain(&jump.step)));
    }
    for switch in &m.switches {
        apart.extend(switch.modes.iter().flat_map(|mode| &mode.values));
        let guards = switch.modes.iter().flat_map(|mode| &mode.exits).map(|exit| &exit.guard);
        apart.extend(terms(guards.chain([&switch.loss]).flat_map(|rows| of_rows(rows))));
    }
    apart.extend(terms(m.outputs.iter().map(|output| &output.value.sum)));
    apart
}

fn terms<'a>(sums: impl Iterator<Item = &'a Sum>) -> Vec<&'a Expr> {
    sums.flatten().map(|term| &term.value).collect()
}

fn of_rows(rows: &[Row]) -> impl Iterator<Item = &Sum> {
    rows.iter().map(|row| &row.sum)
}

fn of_entries(entries: &[Entry]) -> impl Iterator<Item = &Sum> {
    entries.iter().map(|entry| &entry.sum)
}

/// The degree of names as polynomials in a parameter; that of others is 0.
struct Degrees<'a>(Vec<(&'a Ident, u32)>);

impl Degrees<'_> {
    /// The highest degree of the expressions; `None` if one of them is not a polynomial or its degree is not known.
    fn highest(&self, values: &[&Expr]) -> Option<u32> {
        values.iter().try_fold(0, |highest, value| Some(highest.max(self.of(value)?)))
    }

    /// The degree of an expression, as [`Degrees::highest`].
    fn of(&self, e: &Expr) -> Option<u32> {
        match e {
            Expr::Paren(e) => self.of(&e.expr),
            Expr::Group(e) => self.of(&e.expr),
            Expr::Unary(e) => self.of(&e.expr),
            Expr::Binary(b) => {
                let (left, right) = (self.of(&b.left)?, self.of(&b.right)?);
                match b.op {
                    BinOp::Add(_) | BinOp::Sub(_) => Some(left.max(right)),
                    BinOp::Mul(_) => Some(left + right),
                    BinOp::Div(_) if right == 0 => Some(left),
                    _ => None,
                }
            }
            Expr::MethodCall(call) => {
                let constant = self.of(&call.receiver) == Some(0) && call.args.iter().all(|e| self.of(e) == Some(0));
                constant.then_some(0)
            }
            Expr::Field(e) => match &e.member {
                Member::Named(name) => Some(self.named(name)),
                Member::Unnamed(_) => Some(0),
            },
            Expr::Path(e) => Some(e.path.get_ident().map_or(0, |name| self.named(name))),
            _ => Some(0),
        }
    }

    fn named(&self, name: &Ident) -> u32 {
        self.0.iter().find(|(known, _)| *known == name).map_or(0, |(_, degree)| *degree)
    }
}
