//! Coordinates without inertia: their values follow from the balance of the forces of their springs.
//!
//! Where only springs with constant stiffness act on such a coordinate x, V is quadratic in it, and 0 = dV/dx gives x as a linear form of the other
//! coordinates (static condensation: R. J. Guyan, AIAA J. 3(2), 1965). The coordinate is replaced by this form, so that the equations
//! of motion do not have it. It becomes an output. Dampers may act on the coordinate only if their forces balance at the same linear form,
//! as those in proportion to the stiffness do.

use std::collections::HashSet;

use symbolica::atom::{Atom, AtomCore};

use super::{Model, Output};
use crate::expr::{Expr, Kind, number, set, speed_name, symbol, symbols, total};
use crate::mobility::is_zero;

/// A coordinate as a linear form of others: their names and factors.
type Form = Vec<(String, Atom)>;

/// Replaces each coordinate without inertia whose value follows from its springs. The derivation refuses the others, with the reason that
/// [`why_not`] gives.
pub(super) fn eliminate(model: &mut Model) {
    let mut left = without_inertia(model);
    let next = |model: &Model, left: &[String]| {
        left.iter().enumerate().find_map(|(i, name)| placed(model, name).ok().map(|form| (i, form)))
    };
    while let Some((i, form)) = next(model, &left) {
        replace(model, &left.remove(i), &form);
    }
}

/// The coordinates whose speeds are not in the kinetic energy. Only these are examined further: most models have none.
fn without_inertia(model: &Model) -> Vec<String> {
    let mut moving: HashSet<String> = HashSet::new();
    for (kind, name) in model.kinetic.iter().flat_map(|t| symbols(&t.atom())) {
        match kind {
            Kind::Speed => moving.extend([name]),
            Kind::Rate => {
                let deflection = model.deflections.iter().find(|d| speed_name(&d.name) == name);
                let of = deflection.map_or(vec![], |d| symbols(&d.value.dot().atom()));
                moving.extend(of.into_iter().filter(|s| s.0 == Kind::Speed).map(|s| s.1));
            }
            _ => {}
        }
    }
    let names = model.coordinates.iter().map(|c| c.name.clone());
    names.filter(|name| !moving.contains(&speed_name(name))).collect()
}

/// Why a coordinate without inertia cannot be eliminated.
pub(crate) fn why_not(model: &Model, name: &str) -> String {
    placed(model, name).err().unwrap_or_default()
}

/// The linear form of the other coordinates at which the springs of the coordinate `name` balance.
///
/// # Errors
/// The reason why there is no such form.
fn placed(model: &Model, name: &str) -> Result<Form, String> {
    let (x, rate) = (symbol(Kind::Coordinate, name), symbol(Kind::Speed, &speed_name(name)));
    let has = |e: &Atom| e.contains_symbol(x) || e.contains_symbol(rate);
    let written_out = |e: &Expr| in_coordinates(model, e.atom());
    let acts = |e: &Expr| has(&written_out(e));
    if model.kinetic.iter().any(acts) {
        return Err("the kinetic energy contains it".into());
    }
    if let Some(law) = model.laws.iter().find(|law| acts(&law.phase)) {
        return Err(format!("it is the phase of `{}`", law.name));
    }
    let turned = |t: &super::Torque| acts(&t.value) || acts(&t.through) || t.along.is_some_and(|along| acts(&along));
    if let Some(torque) = model.torques.iter().find(|torque| turned(torque)) {
        return Err(format!("the torque `{}` acts on it", torque.name));
    }
    if let Some(function) = model.functions.iter().find(|function| function.of.iter().any(acts)) {
        return Err(format!("the function `{}` depends on it", function.name));
    }
    let of_switch = |over: &str| acts(&Expr::var(Kind::Deflection, over));
    if let Some(switch) = model.switches.iter().find(|switch| of_switch(&switch.over)) {
        return Err(format!("the switch of `{}` depends on it", switch.over));
    }
    if model.constants.iter().any(|(_, value)| symbols(&value.atom()).iter().any(|s| s.0 == Kind::Mobility)) {
        return Err("the model has entries of the inverse mass matrix".into());
    }
    let slope = |pieces: &[Expr], by| total(pieces.iter().map(|e| written_out(e).derivative(by)).collect()).expand();
    let force = slope(&model.potential, x);
    let constant = [Kind::Parameter, Kind::Constant];
    if let Some((_, varies)) = symbols(&force).iter().find(|s| s.0 != Kind::Coordinate && !constant.contains(&s.0)) {
        return Err(format!("the force of its springs depends on `{varies}`"));
    }
    let of_parameters = |e: &Atom| symbols(e).iter().all(|s| constant.contains(&s.0));
    let stiffness = force.derivative(x).expand();
    if stiffness.is_zero() {
        return Err("no spring holds it".into());
    }
    let others = model.coordinates.iter().filter(|c| c.name != name);
    let slopes: Form = others
        .map(|c| (c.name.clone(), force.derivative(symbol(Kind::Coordinate, &c.name)).expand()))
        .filter(|(_, slope)| !slope.is_zero())
        .collect();
    let moving = slopes.iter().map(|(other, slope)| slope * Atom::var(symbol(Kind::Coordinate, other)));
    let linear = total(moving.chain([&stiffness * Atom::var(x)]).collect());
    if !of_parameters(&stiffness) || !slopes.iter().all(|s| of_parameters(&s.1)) || !is_zero(&(force - linear)) {
        return Err("the force of its springs is not proportional to their deflections".into());
    }
    let form: Form = slopes.into_iter().map(|(other, slope)| (other, (-slope / &stiffness).together())).collect();
    let damping = set(&slope(&model.dissipation, rate), rate, &sum(&form, Kind::Speed));
    if !is_zero(&damping) {
        return Err("it has a damper: its speed, too, would follow from a balance".into());
    }
    Ok(form)
}

/// An expression in the coordinates and speeds, without named deflections.
fn in_coordinates(model: &Model, e: Atom) -> Atom {
    model.deflections.iter().rev().fold(e, |e, d| {
        let rate = (Kind::Rate, speed_name(&d.name));
        let e = set(&e, symbol(rate.0, &rate.1), &d.value.dot().atom());
        set(&e, symbol(Kind::Deflection, &d.name), &d.value.atom())
    })
}

/// The linear form of coordinates, or of their speeds.
fn sum(form: &Form, kind: Kind) -> Atom {
    let of = |name: &str| if kind == Kind::Speed { speed_name(name) } else { name.into() };
    let parts = form.iter().map(|(name, factor)| factor * Atom::var(symbol(kind, &of(name))));
    total(parts.collect())
}

/// Replaces the coordinate `name` by a linear form of the others, whose factors become constants of the model.
fn replace(model: &mut Model, name: &str, form: &Form) {
    let (x, rate) = (symbol(Kind::Coordinate, name), symbol(Kind::Speed, &speed_name(name)));
    let mut named: Form = vec![];
    for i in 0..model.deflections.len() {
        let before = model.deflections[i].value.atom();
        if before.contains_symbol(x) {
            let of = model.deflections[i].name.clone();
            let after = set(&before, x, &sum(form, Kind::Coordinate));
            let mut straight = vec![];
            for (other, _) in form {
                let other_symbol = symbol(Kind::Coordinate, other);
                let factor = after.derivative(other_symbol).together();
                straight
                    .push((other.clone(), constant(model, (&mut named, name), &format!("{of}_per_{other}"), factor)));
            }
            let rest = form.iter().fold(set(&before, x, &number(0)), |rest, (other, _)| {
                set(&rest, symbol(Kind::Coordinate, other), &number(0))
            });
            model.deflections[i].value = Expr::new((rest + sum(&straight, Kind::Coordinate)).expand());
        }
    }
    let form: Form = form
        .iter()
        .map(|(other, factor)| {
            (other.clone(), constant(model, (&mut named, name), &format!("{name}_per_{other}"), factor.clone()))
        })
        .collect();
    let place = Expr::new(sum(&form, Kind::Coordinate));
    let replaced = |e: &mut Expr| {
        *e = Expr::new(set(&set(&e.atom(), x, &place.atom()), rate, &sum(&form, Kind::Speed)));
    };
    model.potential.iter_mut().chain(&mut model.dissipation).for_each(replaced);
    model.forces.iter_mut().for_each(|force| replaced(&mut force.value));
    model.outputs.iter_mut().for_each(|output| replaced(&mut output.value));
    for motion in &mut model.motions {
        motion.speeds.retain(|(coordinate, _)| coordinate.atom() != Atom::var(x));
    }
    let at = model.coordinates.iter().position(|c| c.name == name).expect("a coordinate of the model");
    let gone = model.coordinates.remove(at);
    model.outputs.push(Output { name: gone.name, unit: gone.unit, value: place, with: None, doc: gone.doc });
}

/// The factor as a constant of the model; a number stays as it is. A factor that is known up to its sign is written in the known constant,
/// so that equal factors cancel exactly. A new constant has the name `wanted`; if that is taken, the name of the eliminated coordinate,
/// `gone`, is appended.
fn constant(model: &mut Model, (named, gone): (&mut Form, &str), wanted: &str, factor: Atom) -> Atom {
    if symbols(&factor).is_empty() {
        return factor;
    }
    for (name, known) in &*named {
        for sign in [1, -1] {
            if is_zero(&(known * number(sign) - &factor)) {
                return Atom::var(symbol(Kind::Constant, name)) * number(sign);
            }
        }
    }
    // The same deflection may be rewritten again when another coordinate is eliminated.
    let taken = |name: &str| model.constants.iter().any(|constant| constant.0 == name);
    let mut new = wanted.to_string();
    while taken(&new) {
        new += "_";
        new += gone;
    }
    named.push((new.clone(), factor.clone()));
    model.constant(&new, Expr::new(factor)).atom()
}
