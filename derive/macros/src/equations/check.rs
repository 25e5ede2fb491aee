//! Checks a parsed model before code is written for it, and reports all errors at once.

use std::collections::HashMap;

use syn::{Error, Ident};

use crate::equations::effects;
use crate::equations::lets;
use crate::equations::model::*;
use crate::equations::resolve::resolve;
use crate::equations::scope::speed;
use crate::equations::switches::{CONSTANT, REACTION};

/// Checks the model and resolves the names in its expressions.
pub fn check(model: &mut Model) -> syn::Result<()> {
    let mut errors = vec![];
    names(model, &mut errors);
    numbers(model, &mut errors);
    effects::check(model, &mut errors);
    blocks(model, &mut errors);
    resolve(model, &mut errors);
    match errors.into_iter().reduce(|mut all, e| {
        all.combine(e);
        all
    }) {
        Some(errors) => Err(errors),
        None => Ok(()),
    }
}

/// Every name must have one meaning.
fn names(m: &Model, errors: &mut Vec<Error>) {
    // The generated function `new` has these variables, besides one for each parameter and constant.
    let mut taken = HashMap::from(
        ["parameters", "mids", "coefficients"].map(|n| (n.to_string(), "the generated code".to_string())),
    );
    let mut claim = |kind: &str, name: &Ident, derived: Vec<String>| {
        let all = std::iter::once(name.to_string()).chain(derived);
        for one in all {
            if let Some(owner) = taken.get(&one) {
                errors.push(Error::new(name.span(), format!("{kind} `{name}`: `{one}` already belongs to {owner}")));
                return;
            }
            taken.insert(one, format!("the {kind} `{name}`"));
        }
    };
    m.coordinates.iter().for_each(|c| claim("coordinate", &c.name, vec![speed(&c.name)]));
    m.parameters.iter().for_each(|p| claim("parameter", &p.name, vec![]));
    for law in &m.laws {
        let name = &law.name;
        let mid = law.with.is_none().then(|| format!("{name}_mid"));
        claim("law", name, [format!("d{name}"), format!("dd{name}")].into_iter().chain(mid).collect());
    }
    m.constants.iter().for_each(|c| claim("constant", &c.name, vec![]));
    m.deflections.iter().for_each(|d| claim("deflection", &d.name, vec![speed(&d.name)]));
    m.functions.iter().for_each(|f| claim("function", &f.name, vec![]));
    m.forces.iter().for_each(|f| claim("force", &f.name, vec![]));
    m.partials.iter().for_each(|f| claim("partial derivative", &f.name, vec![]));
    for switch in &m.switches {
        switch.symbols.iter().for_each(|(s, _)| claim("symbol of a switch", s, vec![]));
    }
    m.outputs.iter().for_each(|output| claim("output", &output.value.name, vec![]));
    unique("motion", m.motions.iter().map(|x| &x.name), errors);
    unique("torque", m.torques.iter().map(|x| &x.name), errors);
    unique("jump", m.jumps.iter().map(|x| &x.law), errors);
}

/// Reports names that are in a list twice.
pub fn unique<'a>(kind: &str, names: impl Iterator<Item = &'a Ident>, errors: &mut Vec<Error>) {
    let mut seen = vec![];
    for name in names {
        if seen.contains(&name) {
            errors.push(Error::new(name.span(), format!("a second {kind} `{name}`")));
        }
        seen.push(name);
    }
}

/// Ranges must not be empty and must contain the defaults; periods must be positive.
fn numbers(m: &Model, errors: &mut Vec<Error>) {
    for p in &m.parameters {
        let above = |x: f64| {
            if p.low_included { x >= p.low } else { x > p.low }
        };
        let below = |x: f64| {
            if p.high_included { x <= p.high } else { x < p.high }
        };
        if let Some(lesser) = p.above.as_ref().filter(|above| !m.parameters.iter().any(|other| other.name == **above)) {
            errors.push(Error::new(lesser.span(), format!("there is no parameter `{lesser}`")));
        }
        if p.low >= p.high {
            errors.push(Error::new(p.name.span(), format!("parameter `{}`: its range is empty", p.name)));
        } else if !p.default.is_none_or(|x| x.is_finite() && above(x) && below(x)) {
            errors.push(Error::new(p.name.span(), format!("parameter `{}`: its default is out of range", p.name)));
        }
    }
    for l in &m.laws {
        if !(l.period.is_finite() && l.period > 0.0) {
            errors.push(Error::new(l.name.span(), format!("law `{}`: its period is not positive", l.name)));
        }
    }
}

/// Rows, columns and blocks must name coordinates and laws that exist, and required rows and blocks must be present.
fn blocks(m: &Model, errors: &mut Vec<Error>) {
    let q: Vec<String> = m.coordinates.iter().map(|c| c.name.to_string()).collect();
    let q_dot: Vec<String> = m.coordinates.iter().map(|c| speed(&c.name)).collect();
    if q.is_empty() {
        errors.push(Error::new(m.name.span(), "no coordinates"));
    }

    // A scene has the laws up to the last law that belongs to one of its effects. Therefore laws with effects must come last, grouped by
    // effect.
    let effects: Vec<_> = m.laws.iter().map(|l| l.with.as_ref()).collect();
    for (i, l) in m.laws.iter().enumerate().skip(1) {
        let apart = effects[..i].contains(&effects[i]) && effects[i - 1] != effects[i];
        if apart || (effects[i].is_none() && effects[i - 1].is_some()) {
            let message = format!("law `{}`: laws with an effect must come last, those of one effect together", l.name);
            errors.push(Error::new(l.name.span(), message));
        }
    }
    for l in &m.laws {
        known("a coordinate", &l.phase, &q, errors);
        if m.switching(How::WithJump).is_some() && !m.jumps.iter().any(|j| j.law == l.name) {
            let message = format!("law `{0}` can step, but there is no `jump {0}`", l.name);
            errors.push(Error::new(l.name.span(), message));
        }
    }
    for motion in &m.motions {
        motion.speeds.iter().for_each(|s| known("a speed", &s.name, &q_dot, errors));
        unique("speed", motion.speeds.iter().map(|s| &s.name), errors);
    }
    let deflections: Vec<String> = m.deflections.iter().map(|d| d.name.to_string()).collect();
    let rates = m.deflections.iter().map(|d| speed(&d.name));
    let linear: Vec<String> = deflections.iter().cloned().chain(rates).collect();
    let states = [&q[..], &q_dot[..], &linear[..]].concat();
    m.switches.iter().for_each(|s| switch(s, &deflections, &linear, errors));
    let laws: Vec<String> = m.laws.iter().map(|l| l.name.to_string()).collect();
    for j in &m.jumps {
        known("a law", &j.law, &laws, errors);
        rows(j.normal.iter().flatten(), &q, errors);
        rows(j.direction.iter().flatten(), &q, errors);
        if j.step.is_none() {
            errors.push(Error::new(j.law.span(), format!("jump {}: no block `step`", j.law)));
        }
    }

    rows(&m.work, &q, errors);
    let positions = [&q[..], &deflections[..]].concat();
    rows(&m.load, &positions, errors);
    match &m.force {
        Some(force) => {
            rows(force, &q, errors);
            let missing = m.coordinates.iter().filter(|c| !force.iter().any(|r| r.name == c.name));
            for c in missing {
                let message =
                    format!("force: no row for the coordinate `{0}`; if it is zero, write `{0} {{}}`", c.name);
                errors.push(Error::new(c.name.span(), message));
            }
        }
        None => errors.push(Error::new(m.name.span(), "no block `force`")),
    }

    for (name, matrix) in [("mass", Some(&m.mass)), ("mobility", m.mobility.as_ref())] {
        // M and its inverse are positive definite: no entry on the diagonal can be zero.
        let given = |c: &Coordinate, e: &Entry| e.row == c.name && e.column == c.name && !e.sum.is_empty();
        for c in m.coordinates.iter().filter(|c| matrix.is_some_and(|matrix| !matrix.iter().any(|e| given(c, e)))) {
            let message = format!("{name}: no row for the coordinate `{0}` (at least `{0} {0} {{ .. }}`)", c.name);
            errors.push(Error::new(c.name.span(), message));
        }
    }
    for matrix in std::iter::once(&m.mass).chain(&m.mobility) {
        entries(matrix, &q, &q, true, errors);
    }
    for matrix in [&m.stiffness, &m.damping] {
        entries(matrix, &positions, &positions, true, errors);
    }
    entries(&m.inertia, &q, &q, false, errors);
    let moving: Vec<String> = q.iter().cloned().chain(m.functions.iter().map(|f| f.name.to_string())).collect();
    let mentioned = |e: &&Entry| e.sum.iter().any(|t| moving.iter().any(|name| lets::names(&t.value).contains(name)));
    if let Some(e) = m.mass.iter().find(mentioned).filter(|_| m.inertia.is_empty()) {
        errors.push(Error::new(e.row.span(), "mass: depends on the coordinates, but there is no block `inertia`"));
    }
    match &m.jacobian {
        Some(jacobian) => entries(jacobian, &q, &states, false, errors),
        None => errors.push(Error::new(m.name.span(), "no block `jacobian`")),
    }
}

/// A switch names a known deflection. Each of its modes gives one value for each symbol. Each exit leads to a mode of the same switch.
fn switch(s: &Switch, deflections: &[String], linear: &[String], errors: &mut Vec<Error>) {
    known("a deflection", &s.over, deflections, errors);
    let modes: Vec<String> = s.modes.iter().map(|mode| mode.name.to_string()).collect();
    unique("mode", s.modes.iter().map(|mode| &mode.name), errors);
    let constant = CONSTANT.to_string();
    for mode in &s.modes {
        if mode.values.len() != s.symbols.len() {
            let message = format!("mode `{}`: {} values for {} symbols", mode.name, mode.values.len(), s.symbols.len());
            errors.push(Error::new(mode.name.span(), message));
        }
        let reaction = mode.held.then(|| REACTION.to_string());
        let allowed: Vec<String> = linear.iter().chain([&constant]).chain(&reaction).cloned().collect();
        for exit in &mode.exits {
            known("a mode", &exit.to, &modes, errors);
            exit.guard.iter().for_each(|row| known("in a guard", &row.name, &allowed, errors));
        }
    }
    s.loss.iter().for_each(|row| known("in a loss", &row.name, &[s.over.to_string(), constant.clone()], errors));
}

fn known(what: &str, name: &Ident, names: &[String], errors: &mut Vec<Error>) {
    if !names.iter().any(|n| name == n) {
        let message = format!("`{name}` is not {what}; there are: {}", names.join(", "));
        errors.push(Error::new(name.span(), message));
    }
}

fn rows<'a>(rows: impl IntoIterator<Item = &'a Row>, q: &[String], errors: &mut Vec<Error>) {
    let names: Vec<_> = rows.into_iter().map(|r| &r.name).collect();
    names.iter().for_each(|name| known("a coordinate", name, q, errors));
    unique("row", names.into_iter(), errors);
}

fn entries(entries: &[Entry], rows: &[String], columns: &[String], symmetric: bool, errors: &mut Vec<Error>) {
    for (i, e) in entries.iter().enumerate() {
        known("a row", &e.row, rows, errors);
        known("a column", &e.column, columns, errors);
        let same = |f: &Entry| {
            (f.row == e.row && f.column == e.column) || (symmetric && f.row == e.column && f.column == e.row)
        };
        if entries[..i].iter().any(same) {
            errors.push(Error::new(e.row.span(), format!("a second entry `{} {}`", e.row, e.column)));
        }
    }
}
