//! Checks that T is quadratic in the speeds, that D is a sum of squares, and that deflections and the speeds along which torques work are
//! linear.

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};

use super::sign::never_negative;
use crate::expr::{Kind, number, set, symbol, symbols};
use crate::markers::{all_present, terms};
use crate::mobility::is_zero;
use crate::model::{Model, Role};
use crate::print::{Style, print};
use crate::slip::Slip;
use crate::tree::Tree;

/// T must be homogeneous of degree two in the speeds: scaling the speeds by a factor scales T by its square.
pub(super) fn quadratic(model: &Model) -> Result<(), Slip> {
    let stretch = Atom::var(symbol(Kind::Free, "stretch"));
    for piece in &model.kinetic {
        for term in terms(&piece.atom().expand()) {
            let scaled = model.speeds().iter().fold(term.clone(), |t, name| {
                let speed = symbol(Kind::Speed, name);
                set(&t, speed, &(&stretch * Atom::var(speed)))
            });
            if !(scaled - &term * &stretch * &stretch).expand().is_zero() {
                let term = print(&Tree::new(&all_present(&term)), Style::Plain);
                return Err(Slip::NotQuadratic { model: model.name.clone(), term });
            }
        }
    }
    Ok(())
}

/// Every piece of D must be a square times factors that are never negative. A positive sum of products that is not written
/// in squares is refused too; it can be rewritten.
pub(super) fn dissipative(model: &Model) -> Result<(), Slip> {
    for piece in &model.dissipation {
        let bare = all_present(&piece.atom());
        let factors: Vec<Atom> = match bare.as_view() {
            AtomView::Mul(m) => m.iter().map(|f| f.to_owned()).collect(),
            _ => vec![bare.clone()],
        };
        if !factors.iter().all(|f| never_negative(model, f)) {
            let term = print(&Tree::new(&bare), Style::Plain);
            return Err(Slip::NegativeDissipation { model: model.name.clone(), term });
        }
    }
    Ok(())
}

/// The speed along which a torque works must be linear in the speeds: otherwise the torque has no generalised forces. A deflection without
/// its edges, transmission errors and functions of positions must be a linear form without a constant term: only then is its rate the same
/// form in the speeds.
pub(super) fn linear(model: &Model) -> Result<(), Slip> {
    let moves = |e: &Atom| symbols(e).iter().any(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
    let slopes = |e: &Atom| -> Vec<(Atom, Atom)> {
        let coordinates = model.coordinates.iter().map(|c| symbol(Kind::Coordinate, &c.name));
        coordinates.map(|q| (Atom::var(q), e.derivative(q).expand())).collect()
    };
    for torque in &model.torques {
        let Some(along) = torque.along.map(|along| along.atom()) else { continue };
        let speeds = model.speeds().into_iter().map(|v| symbol(Kind::Speed, &v));
        let parts = speeds.map(|v| along.derivative(v) * Atom::var(v));
        let rest = parts.fold(along.clone(), |rest, part| rest - part);
        let fast = |v: &String| along.derivative(symbol(Kind::Speed, v));
        let curved = model.speeds().iter().any(|v| symbols(&fast(v)).iter().any(|s| s.0 == Kind::Speed));
        if curved || !is_zero(&rest) {
            let (torque, speed) = (torque.name.clone(), print(&Tree::new(&along), Style::Plain));
            return Err(Slip::NotLinear { model: model.name.clone(), torque, speed });
        }
    }
    for d in &model.deflections {
        // Offsets of switches and transmission errors are not part of the form; their coefficients must be constant.
        let offsets = model.switches.iter().flat_map(|switch| &switch.symbols).filter(|s| s.kind == Kind::Edge);
        let edges = offsets.map(|s| (Kind::Edge, &s.name));
        let errors = model.laws.iter().filter(|law| law.role == Role::Offset).map(|law| (law.kind(), &law.name));
        let offsets: Vec<Symbol> = edges.chain(errors).map(|(kind, name)| symbol(kind, name)).collect();
        // Functions of positions are not part of the form either; the factor of each must be constant in a mode.
        let functions: Vec<_> = symbols(&d.value.atom()).into_iter().filter(|s| s.0 == Kind::Function).collect();
        let factor = |(kind, name): &(Kind, String)| d.value.atom().derivative(symbol(*kind, name)).expand();
        let may_be_a_factor = |s: &(Kind, String)| matches!(s.0, Kind::Constant | Kind::Parameter | Kind::Switched);
        let bends = functions.iter().all(|f| symbols(&factor(f)).iter().all(may_be_a_factor));
        let parts = functions.iter().map(|f| factor(f) * Atom::var(symbol(f.0, &f.1)));
        let straight = parts.fold(d.value.atom(), |value, part| value - part).expand();
        let curved = symbols(&straight).iter().any(|s| s.0 == Kind::Function);
        let value = offsets.iter().fold(straight.clone(), |value, offset| set(&value, *offset, &number(0)));
        let offset = (&straight - &value).expand();
        let scaled = offsets.iter().fold(offset.clone(), |e, o| set(&e, *o, &(Atom::var(*o) * number(2))));
        let rest = slopes(&value).into_iter().fold(value.clone(), |rest, (q, slope)| rest - slope * q);
        if !bends
            || curved
            || slopes(&value).iter().any(|(_, slope)| moves(slope))
            || !is_zero(&rest)
            || moves(&offset)
            || !is_zero(&(scaled - offset * number(2)))
        {
            let (deflection, value) = (d.name.clone(), print(&Tree::new(&d.value.atom()), Style::Plain));
            return Err(Slip::NotADeflection { model: model.name.clone(), deflection, value });
        }
    }
    Ok(())
}
