//! Which parameters may vary in time in a scene. The generalised forces must be linear in such a parameter, and energies and inertias must
//! not depend on it. Outputs, and guards and losses of switches, may be linear in it too. In that case, and if factors in the forces depend
//! on the state, only methods by steps can compute the motion.

use std::collections::{BTreeMap, HashMap};

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
    /// The code of the corresponding variant of `model::Varies`.
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
    let mut all = of(m, Some);
    // The engine adds the changes of the forces by each parameter, so forces must not contain a product of two such parameters.
    let by_steps = |varies: &Varies| matches!(varies, Varies::WithState | Varies::WithGuards);
    let together = of(m, |i| by_steps(&all[i]).then_some(0));
    if all.iter().any(by_steps) && together[0] == Varies::Never {
        all.iter_mut().filter(|varies| by_steps(varies)).for_each(|varies| *varies = Varies::Never);
    }
    all
}

/// How the parameters may vary in time. `place` gives each parameter an index of the result, or `None`: then it is constant. Parameters with
/// the same index vary together.
fn of(m: &Model, place: impl Fn(usize) -> Option<usize>) -> Vec<Varies> {
    let parameters = m.parameters.iter().enumerate();
    let placed = parameters.filter_map(|(i, p)| Some((p.name.to_string(), Degrees::from([(place(i)?, 1)]))));
    let mut names = Names(placed.collect());
    let loads = terms(of_rows(&m.work).chain(m.torques.iter().map(|t| &t.work)));
    let forces = terms(of_rows(&m.load).chain(m.force.iter().flat_map(|rows| of_rows(rows))));
    let mut of_state = Degrees::new();
    for named in m.forces.iter().chain(&m.partials) {
        let degrees = names.highest(&terms(std::iter::once(&named.sum)));
        merge(&mut of_state, &degrees, u32::max);
        names.0.insert(named.name.to_string(), degrees);
    }
    let powers = m.torques.iter().map(|t| &t.power);
    let outputs = m.outputs.iter().map(|output| &output.value.sum);
    let others = powers.chain(m.jacobian.iter().flat_map(|entries| of_entries(entries))).chain(outputs);
    merge(&mut of_state, &names.highest(&terms(others)), u32::max);
    let [apart, switches, loads, forces] =
        [&apart(m), &of_switches(m), &loads, &forces].map(|values| names.highest(values));
    let varies = |i: usize| match [&apart, &of_state, &switches, &loads, &forces].map(|d| d.get(&i).map_or(0, |d| *d)) {
        [0, 0, 0, 0 | 1, 1] => Varies::AsLoad,
        [0, 1, 0, 0, 1] => Varies::WithState,
        [0, 0 | 1, 1, 0, 1] => Varies::WithGuards,
        _ => Varies::Never,
    };
    (0..m.parameters.len()).map(varies).collect()
}

/// Guards and losses of switches.
fn of_switches(m: &Model) -> Vec<&Expr> {
    let guards = m.switches.iter().flat_map(|switch| &switch.modes).flat_map(|mode| &mode.exits);
    let guards = guards.map(|exit| &exit.guard).chain(m.switches.iter().map(|switch| &switch.loss));
    terms(guards.flat_map(|rows| of_rows(rows)))
}

/// The expressions that must not depend on a parameter that varies.
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

/// The degree of an expression in each parameter, by the index of the parameter. Parameters that are not in the expression are left out.
/// [`NOT_LINEAR`] stands for any degree above 1, and for an expression that is not a polynomial in the parameter.
type Degrees = BTreeMap<usize, u32>;

const NOT_LINEAR: u32 = 2;

/// Combines the degrees of two expressions.
fn merge(degrees: &mut Degrees, others: &Degrees, with: impl Fn(u32, u32) -> u32) {
    for (&i, &other) in others {
        let degree = degrees.entry(i).or_insert(0);
        *degree = with(*degree, other).min(NOT_LINEAR);
    }
}

/// The degrees of names: parameters and named forces. Other names are constant.
struct Names(HashMap<String, Degrees>);

impl Names {
    /// The highest degrees of the expressions.
    fn highest(&self, values: &[&Expr]) -> Degrees {
        let mut highest = Degrees::new();
        values.iter().for_each(|value| merge(&mut highest, &self.of(value), u32::max));
        highest
    }

    fn of(&self, e: &Expr) -> Degrees {
        match e {
            Expr::Paren(e) => self.of(&e.expr),
            Expr::Group(e) => self.of(&e.expr),
            Expr::Unary(e) => self.of(&e.expr),
            Expr::Binary(b) => {
                let (mut degrees, right) = (self.of(&b.left), self.of(&b.right));
                match b.op {
                    BinOp::Add(_) | BinOp::Sub(_) => merge(&mut degrees, &right, u32::max),
                    BinOp::Mul(_) => merge(&mut degrees, &right, |a, b| a + b),
                    // A quotient: the grammar has no other operators.
                    _ => merge(&mut degrees, &right, |_, _| NOT_LINEAR),
                }
                degrees
            }
            Expr::MethodCall(call) => {
                let mut degrees = self.of(&call.receiver);
                call.args.iter().for_each(|e| merge(&mut degrees, &self.of(e), u32::max));
                degrees.values_mut().for_each(|degree| *degree = NOT_LINEAR);
                degrees
            }
            Expr::Field(e) => match &e.member {
                Member::Named(name) => self.named(name),
                Member::Unnamed(_) => Degrees::new(),
            },
            Expr::Path(e) => e.path.get_ident().map_or_else(Degrees::new, |name| self.named(name)),
            _ => Degrees::new(),
        }
    }

    fn named(&self, name: &Ident) -> Degrees {
        self.0.get(&name.to_string()).cloned().unwrap_or_default()
    }
}
