//! Resolves the names in every block: a block may use the arguments of its generated function and the numbers of the scene.

use quote::format_ident;
use syn::{Error, Expr, parse_quote};

use crate::equations::deflections::addends;
use crate::equations::lets::names;
use crate::equations::model::{Assignment, Entry, Model, Row};
use crate::equations::scope::{Scope, speed};

/// Resolves every expression of the model in place.
pub fn resolve(m: &mut Model, errors: &mut Vec<Error>) {
    let mut constants = Scope::of_constants(m);
    for c in &mut m.constants {
        constants.expression(&mut c.value, errors);
        constants.declare(&c.name);
    }

    // Deflections are linear in the coordinates. Speeds in place of the coordinates give their rates; edges and transmission errors are
    // dropped. Unknown names are reported only once, with the deflections. The file gives the rates of bent deflections.
    let mut given = std::mem::take(&mut m.rates);
    let bent = Scope::of(m, "rates").coordinates(m, "q").speeds(m).functions(m).gated(m);
    given.iter_mut().for_each(|rate| bent.expression(&mut rate.value, errors));
    let rates = Scope::of(m, "deflections").coordinates(m, "q_dot").gated(m);
    for d in &m.deflections {
        let name = format_ident!("{}", speed(&d.name));
        m.rates.push(match given.iter().position(|rate| rate.name == name) {
            Some(i) => given.swap_remove(i),
            None => {
                let mut value = moving(m, &d.value);
                rates.expression(&mut value, &mut vec![]);
                Assignment { name, value }
            }
        });
    }
    for rate in given {
        errors.push(Error::new(rate.name.span(), format!("`{}` is not the rate of a deflection", rate.name)));
    }
    let deflections = Scope::of(m, "deflections").coordinates(m, "q").functions(m).gated(m);
    m.deflections.iter_mut().for_each(|d| deflections.expression(&mut d.value, errors));
    let (constants, moving) = (Scope::of(m, "the values of a mode"), Scope::of(m, "switches").laws(m, 0).gated(m));
    for switch in &mut m.switches {
        switch.modes.iter_mut().flat_map(|mode| &mut mode.values).for_each(|value| constants.expression(value, errors));
        let guards = switch.modes.iter_mut().flat_map(|mode| &mut mode.exits).flat_map(|exit| &mut exit.guard);
        rows(guards.chain(&mut switch.loss), &moving, errors);
    }

    let functions = Scope::of(m, "functions").coordinates(m, "q").deflections(m);
    m.functions.iter_mut().for_each(|f| functions.expression(&mut f.value, errors));
    let kinetic = Scope::of(m, "kinetic").coordinates(m, "q").speeds(m).functions(m);
    kinetic.sum(&mut m.kinetic, errors);
    let potential = Scope::of(m, "potential").coordinates(m, "q").deflections(m).functions(m).laws(m, 0).gated(m);
    potential.sum(&mut m.potential, errors);
    let dissipation = Scope::of(m, "dissipation").coordinates(m, "q").speeds(m).rates(m).functions(m).gated(m);
    dissipation.sum(&mut m.dissipation, errors);

    // In the work of a constant torque the coordinates stand for their changes.
    let torques = Scope::of(m, "torques").coordinates(m, "dq");
    m.torques.iter_mut().for_each(|t| torques.sum(&mut t.work, errors));
    let mut forces = Scope::of(m, "forces").coordinates(m, "q").speeds(m).deflections(m).rates(m).laws(m, 0).gated(m);
    for force in &mut m.forces {
        forces.sum(&mut force.sum, errors);
        forces.declare(&force.name);
    }
    let powers = forces.within("power").functions(m);
    m.torques.iter_mut().for_each(|t| powers.sum(&mut t.power, errors));
    rows(&mut m.partials, &powers.within("partials"), errors);
    let work = Scope::of(m, "work");
    rows(&mut m.work, &work, errors);
    let motions = Scope::of(m, "motions");
    m.motions.iter_mut().flat_map(|x| &mut x.speeds).for_each(|s| motions.expression(&mut s.value, errors));

    let mut outputs = powers.within("outputs").known(m);
    for output in &mut m.outputs {
        outputs.sum(&mut output.value.sum, errors);
        outputs.declare(&output.value.name);
    }

    let mass = Scope::of(m, "mass").coordinates(m, "q").functions(m);
    entries(&mut m.mass, &mass, errors);
    let inertia = Scope::of(m, "inertia").coordinates(m, "q").accelerations(m).functions(m);
    entries(&mut m.inertia, &inertia, errors);
    let mobility = Scope::of(m, "mobility").coordinates(m, "q").functions(m);
    entries(m.mobility.iter_mut().flatten(), &mobility, errors);
    let moving = |block: &str, order| {
        let scope = Scope::of(m, block).coordinates(m, "q").speeds(m).deflections(m).rates(m).functions(m);
        scope.laws(m, order).gated(m)
    };
    let (force, jacobian) = (moving("force", 1).forces(m), moving("jacobian", 2).forces(m).partials(m));
    rows(m.force.iter_mut().flatten(), &force, errors);
    entries(m.jacobian.iter_mut().flatten(), &jacobian, errors);

    let stiffness = Scope::of(m, "cell stiffness").laws(m, 0).gated(m);
    entries(&mut m.stiffness, &stiffness, errors);
    let damping = Scope::of(m, "cell damping").gated(m);
    entries(&mut m.damping, &damping, errors);
    let load = Scope::of(m, "cell load").laws(m, 0).gated(m);
    rows(&mut m.load, &load, errors);

    let impulse = Scope::of(m, "the impulse of a jump");
    let steps: Vec<_> = m
        .jumps
        .iter()
        .map(|j| Scope::of(m, "step").coordinates(m, "q").deflections(m).functions(m).laws(m, 0).gated(m).step(&j.law))
        .collect();
    for (j, step) in m.jumps.iter_mut().zip(steps) {
        rows(j.normal.iter_mut().flatten(), &impulse, errors);
        j.compliance.iter_mut().for_each(|sum| impulse.sum(sum, errors));
        rows(j.direction.iter_mut().flatten(), &impulse, errors);
        j.step.iter_mut().for_each(|sum| step.sum(sum, errors));
    }
}

fn rows<'a>(rows: impl IntoIterator<Item = &'a mut Row>, scope: &Scope, errors: &mut Vec<Error>) {
    rows.into_iter().for_each(|r| scope.sum(&mut r.sum, errors));
}

fn entries<'a>(entries: impl IntoIterator<Item = &'a mut Entry>, scope: &Scope, errors: &mut Vec<Error>) {
    entries.into_iter().for_each(|e| scope.sum(&mut e.sum, errors));
}

/// The sum of the addends of a deflection that depend on coordinates.
fn moving(m: &Model, value: &Expr) -> Expr {
    let moves = |addend: &Expr| m.coordinates.iter().any(|c| names(addend).contains(&c.name.to_string()));
    let all = addends(value, false).into_iter().filter(|(_, addend)| moves(addend));
    let sum = all.fold(None, |sum: Option<Expr>, (minus, addend)| {
        Some(match (sum, minus) {
            (None, false) => addend.clone(),
            (None, true) => parse_quote!(-#addend),
            (Some(sum), false) => parse_quote!(#sum + #addend),
            (Some(sum), true) => parse_quote!(#sum - #addend),
        })
    });
    sum.unwrap_or_else(|| parse_quote!(0.0))
}
