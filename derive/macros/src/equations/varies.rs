//! Which parameters may vary in time in a scene: those on which the generalised forces and the work of the torques depend linearly
//! and nothing else depends.

use syn::{BinOp, Expr, Ident, Member};

use crate::equations::model::*;

/// Whether the parameter may vary in time.
pub fn varies(m: &Model, parameter: &Ident) -> bool {
    let terms = |sums: &[&Sum]| sums.iter().flat_map(|sum| sum.iter().map(|t| t.value.clone())).collect::<Vec<_>>();
    let rows = |rows: &[Row]| terms(&rows.iter().map(|r| &r.sum).collect::<Vec<_>>());
    let entries = |entries: &[Entry]| terms(&entries.iter().map(|e| &e.sum).collect::<Vec<_>>());

    let mut apart = terms(&[&m.kinetic, &m.potential, &m.dissipation]);
    apart.extend(terms(&m.torques.iter().map(|t| &t.power).collect::<Vec<_>>()));
    apart.extend(rows(&m.forces));
    apart.extend(m.constants.iter().chain(&m.deflections).map(|a| a.value.clone()));
    apart.extend(m.functions.iter().map(|f| f.value.clone()));
    apart.extend(m.motions.iter().flat_map(|motion| motion.speeds.iter().map(|s| s.value.clone())));
    for matrix in
        [&m.mass, &m.stiffness, &m.damping].into_iter().chain(&m.mobility).chain([&m.inertia]).chain(&m.jacobian)
    {
        apart.extend(entries(matrix));
    }
    for jump in &m.jumps {
        apart.extend(jump.normal.iter().chain(&jump.direction).flat_map(|r| rows(r)));
        apart.extend(terms(&jump.compliance.iter().chain(&jump.step).collect::<Vec<_>>()));
    }
    let mut forces = terms(&m.torques.iter().map(|t| &t.work).collect::<Vec<_>>());
    for vector in [&m.work, &m.load].into_iter().chain(&m.force) {
        forces.extend(rows(vector));
    }
    let degree = |e: &Expr| degree(e, parameter);
    apart.iter().all(|e| degree(e) == Some(0))
        && forces.iter().all(|e| degree(e).is_some_and(|d| d <= 1))
        && forces.iter().any(|e| degree(e) == Some(1))
}

/// The degree of an expression as a polynomial in a parameter. `None` if it is not a polynomial or the degree is not known.
fn degree(e: &Expr, parameter: &Ident) -> Option<u32> {
    let of = |e: &Expr| degree(e, parameter);
    match e {
        Expr::Paren(e) => of(&e.expr),
        Expr::Group(e) => of(&e.expr),
        Expr::Unary(e) => of(&e.expr),
        Expr::Binary(b) => {
            let (left, right) = (of(&b.left)?, of(&b.right)?);
            match b.op {
                BinOp::Add(_) | BinOp::Sub(_) => Some(left.max(right)),
                BinOp::Mul(_) => Some(left + right),
                BinOp::Div(_) if right == 0 => Some(left),
                _ => None,
            }
        }
        Expr::MethodCall(call) => {
            let constant = of(&call.receiver) == Some(0) && call.args.iter().all(|e| of(e) == Some(0));
            constant.then_some(0)
        }
        Expr::Field(e) => Some(u32::from(matches!(&e.member, Member::Named(name) if name == parameter))),
        Expr::Path(e) => Some(u32::from(e.path.is_ident(parameter))),
        _ => Some(0),
    }
}
