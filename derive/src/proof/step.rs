//! Energy where a law steps: T + V is the same before and after, for any number of coordinates.
//!
//! The rule is q'+ = q' + w d with w = v+ - v and d = M⁻¹n/G. No inverse is needed: d is any solution of M d = n/G with
//! n.d = 1. The energy gained is then T(q' + w d) - T(q') = (v+² - v²)/(2 G) = w (2 v + w)/(2 G), since
//!
//! ```text
//! T(q' + w d) - T(q') - w (2 v + w)/(2 G) = (w q' + w² d/2).(M d - n/G) + w²/(2 G) (n.d - 1)
//! ```
//!
//! is an identity in q', d, G and w, if M is the matrix of T and v = n.q' the speed of the phase. This identity is proved with the derived
//! T, M, n and v. If the file has d, M d = n/G is proved too.

use symbolica::atom::{Atom, AtomCore, Symbol};

use super::Proof;
use crate::expr::{Kind, number, set, symbol, total};
use crate::jump::Jump;
use crate::model::{Law, Model, Role};
use crate::slip::Slip;
use crate::symbols::Variable;

/// Proves the step of every law.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    let all: Vec<(&Law, &Jump)> = p.model.laws.iter().zip(p.jumps).collect();
    let (smooth, stepping): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|(law, _)| matches!(law.role, Role::Factor(_)));
    let names = |laws: &[(&Law, &Jump)]| laws.iter().map(|(law, _)| law.name.as_str()).collect::<Vec<_>>().join(", ");

    let mut rests = vec![];
    let mut known: Vec<(Atom, &Jump)> = vec![];
    for (law, jump) in &stepping {
        let phase = law.phase.atom();
        // Laws of one phase have the same n, G and d.
        let same = |other: &Jump| {
            (&other.normal, &other.compliance, &other.direction) == (&jump.normal, &jump.compliance, &jump.direction)
        };
        if !known.iter().any(|(other, of)| *other == phase && same(of)) {
            rests.push(kinetic(p, law, jump));
            rests.extend(direction(p, jump));
            known.push((phase, jump));
        }
        rests.push(potential(p.model, law) - &jump.step);
    }
    p.claim(
        &format!(
            "at a step of {}: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is \
             unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)",
            names(&stepping)
        ),
        rests,
    )?;
    p.claim(
        &format!("V is the same on both sides of a step of {}: no impulse there", names(&smooth)),
        smooth.iter().map(|(law, jump)| potential(p.model, law) + &jump.step),
    )?;
    Ok(())
}

/// The identity at the head of this file: left side minus right side.
fn kinetic(p: &Proof, law: &Law, jump: &Jump) -> Atom {
    let free = |name: &str| Atom::var(symbol(Kind::Free, name));
    let (n, mass) = (&jump.normal, &p.motion.mass);
    let (w, g, v) = (free("w"), free("G"), law.phase.dot().atom());
    let d: Vec<Atom> = (0..n.len()).map(|i| free(&format!("d{i}"))).collect();
    let gained = p.model.kinetic.iter().map(|piece| {
        let before = piece.atom();
        let after = p.s.present(&before).into_iter().fold(before.clone(), |t, (symbol, place)| match place {
            Variable::Speed(i) => set(&t, symbol, &(Atom::var(symbol) + &w * &d[i])),
            _ => t,
        });
        after - before
    });
    let equations = (0..n.len()).map(|i| {
        let row = (0..n.len()).filter(|&j| !mass[i][j].is_zero()).map(|j| &mass[i][j] * &d[j]);
        let rest = total(row.collect()) - &n[i] / &g;
        -(&w * Atom::var(p.s.v[i]) + &w * &w * &d[i] / number(2)) * rest
    });
    let unit = n.iter().zip(&d).filter(|(n, _)| !n.is_zero()).map(|(n, d)| n * d);
    let normed = -(&w * &w) / (number(2) * &g) * (total(unit.collect()) - number(1));
    let rule = -(&w * (number(2) * v + &w)) / (number(2) * &g);
    total(gained.chain(equations).chain([normed, rule]).collect())
}

/// d G - M⁻¹n and G - n.M⁻¹n for d and G as written; empty if they are not written. Since M M⁻¹ = 1 is proved, M d = n/G follows from the
/// first and n.d = 1 from both.
fn direction(p: &Proof, jump: &Jump) -> Vec<Atom> {
    let (Some(w), Some(g), Some(d)) = (&p.motion.mobility, &jump.compliance, &jump.direction) else { return vec![] };
    let dot = |row: &[Atom]| row.iter().zip(&jump.normal).fold(number(0), |sum, (w, n)| sum + w * n);
    let response: Vec<Atom> = w.iter().map(|row| dot(row)).collect();
    let compliance = g - dot(&response);
    d.iter().zip(response).map(|(d, response)| d * g - response).chain([compliance]).collect()
}

/// V beyond a step of a law minus V before it, with the deflections that contain the law written out where it steps.
fn potential(model: &Model, law: &Law) -> Atom {
    let (value, step) = (symbol(law.kind(), &law.name), symbol(Kind::Slope, &format!("d{}", law.name)));
    let beyond = |e: &Atom| set(e, value, &(Atom::var(value) + Atom::var(step)));
    let deflections = model.deflections.iter().map(|d| (symbol(Kind::Deflection, &d.name), d.value.atom()));
    let steps = deflections.filter(|(_, near)| near.contains_symbol(value));
    // A deflection stays a name, because V is written in it. Its step is added to it.
    let moved: Vec<(Symbol, Atom)> = steps.map(|(name, near)| (name, Atom::var(name) + beyond(&near) - near)).collect();
    let parts = model.potential.iter().map(|v| {
        let v = v.atom();
        let far = moved.iter().fold(beyond(&v), |e, (name, moved)| set(&e, *name, moved));
        far - v
    });
    total(parts.collect())
}
