//! Which parameters may vary in time in a scene: those on which the generalised forces depend linearly and energies and inertias do not.
//! Guards of switches, losses and outputs may also be linear in them. Then only methods by steps can compute the motion.

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
    /// Linearly, with factors that depend on the state; or outputs depend on it too.
    WithState,
    /// Guards or losses of switches depend on it too.
    WithGuards,
}

impl Varies {
    /// The same as a value of gearsim.
    pub fn tokens(self) -> TokenStream {
        match self {
            Varies::Never => quote!(model::Varies::Never),
            Varies::AsLoad => quote!(model::Varies::AsLoad),
            Varies::WithState => quote!(model::Varies::WithState),
            Varies::WithGuards => quote!(model::Varies::WithGuards),
        }
    }
}

/// How each parameter of the model may vary in time, in their order.
pub fn varies(m: &Model) -> Vec<Varies> {
    let parameters: Vec<&Ident> = m.parameters.iter().map(|p| &p.name).collect();
    let mut all: Vec<Varies> = parameters.iter().map(|p| of(m, &[*p])).collect();
    // The engine adds the changes by each: forces must not contain a product of two of them.
    let by_steps = |varies: &Varies| matches!(varies, Varies::WithState | Varies::WithGuards);
    let together: Vec<&Ident> =
        parameters.iter().zip(&all).filter(|(_, varies)| by_steps(varies)).map(|(p, _)| *p).collect();
    if !together.is_empty() && of(m, &together) == Varies::Never {
        all.iter_mut().filter(|varies| by_steps(varies)).for_each(|varies| *varies = Varies::Never);
    }
    all
}

/// How parameters may vary in time together.
fn of(m: &Model, parameters: &[&Ident]) -> Varies {
    let mut degrees = Degrees(parameters.iter().map(|parameter| (*parameter, 1)).collect());
    let loads = terms(of_rows(&m.work).chain(m.torques.iter().map(|t| &t.work)));
    let forces = terms(of_rows(&m.load).chain(m.force.iter().flat_map(|rows| of_rows(rows))));
    let mut of_state = vec![];
    for named in m.forces.iter().chain(&m.partials) {
        let values = terms(std::iter::once(&named.sum));
        // A force that is not linear in the parameter makes all that contains it so.
        degrees.0.push((&named.name, degrees.highest(&values).unwrap_or(2)));
        of_state.extend(values);
    }
    of_state.extend(terms(m.torques.iter().map(|t| &t.power)));
    of_state.extend(terms(m.jacobian.iter().flat_map(|entries| of_entries(entries))));
    of_state.extend(terms(m.outputs.iter().map(|output| &output.value.sum)));
    match [&apart(m), &of_state, &of_switches(m), &loads, &forces].map(|values| degrees.highest(values)) {
        [Some(0), Some(0), Some(0), Some(0 | 1), Some(1)] => Varies::AsLoad,
        [Some(0), Some(1), Some(0), Some(0), Some(1)] => Varies::WithState,
        [Some(0), Some(0 | 1), Some(1), Some(0), Some(1)] => Varies::WithGuards,
        _ => Varies::Never,
    }
}

/// Guards and losses of switches.
fn of_switches(m: &Model) -> Vec<&Expr> {
    let guards = m.switches.iter().flat_map(|switch| &switch.modes).flat_map(|mode| &mode.exits);
    let guards = guards.map(|exit| &exit.guard).chain(m.switches.iter().map(|switch| &switch.loss));
    terms(guards.flat_map(|rows| of_rows(rows)))
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
    apart.extend(m.switches.iter().flat_map(|switch| &switch.modes).flat_map(|mode| &mode.values));
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
    /// The highest degree of the expressions. `None` if one of them is not a polynomial, or if its degree is not known.
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
