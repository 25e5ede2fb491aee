//! Proofs: identities that the derived equations must satisfy, decided symbolically.

use symbolica::atom::{Atom, AtomCore};

use crate::check::{never_negative, positive};
use crate::expr::{Kind, number, symbol, symbols};
use crate::jump::{Jump, response};
use crate::lagrange::{Motion, Symbols, gradient};
use crate::markers::{all_present, terms};
use crate::mobility::{LARGEST_DETERMINANT, determinant, is_zero};
use crate::model::{Friction, JUMP_TERMS, Model, Role, Torque};
use crate::print::{Style, print};
use crate::slip::Slip;
use crate::squares::{self, Squares};
use crate::tree::Tree;

/// Proves all identities. Each line returned states what was proved.
///
/// # Errors
/// [`Slip::Unproved`] with the first identity that fails and its remainder; [`Slip::Singular`] if M is singular.
#[allow(clippy::needless_range_loop)] // rows and columns by index, as matrices are written
pub(crate) fn prove(model: &Model, s: &Symbols, motion: &Motion, jumps: &[Jump]) -> Result<Vec<String>, Slip> {
    let mut proved = vec![];
    let mut claim = |what: &str, rest: Atom| -> Result<(), Slip> {
        if is_zero(&rest) {
            proved.push(what.to_string());
            return Ok(());
        }
        let rest = print(&Tree::new(&rest.expand()), Style::Plain);
        Err(Slip::Unproved { model: model.name.clone(), what: what.into(), rest })
    };
    let n = model.coordinates.len();
    let clipped =
        if model.dead_bands.is_empty() { "" } else { "; q'.dD/dq' includes the power of clipped damper forces" };
    claim(
        &format!(
            "d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, \
             with any set of the additive effects{clipped}"
        ),
        balance(model, s, motion),
    )?;
    if let (Some(a), Some(w)) = (&motion.acceleration, &motion.mobility) {
        let mut rest = number(0);
        for i in 0..n {
            for j in 0..n {
                let one = number(i64::from(i == j));
                let product = (0..n).fold(number(0), |sum, k| sum + &motion.mass[i][k] * exact(motion, &w[k][j]));
                rest += tag("m", i, j) * (product - one);
            }
            let inertia = (0..n).fold(number(0), |sum, j| sum + &motion.mass[i][j] * exact(motion, &a[j]));
            rest += tag("a", i, 0) * (inertia - exact(motion, &motion.force[i]));
        }
        claim("M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as printed", rest)?;
    }
    for (law, jump) in model.laws.iter().zip(jumps) {
        if matches!(law.role, Role::Friction(_)) {
            claim(
                &format!("V is the same on both sides of a step of {}: no impulse there", law.name),
                jump.step.clone(),
            )?;
            continue;
        }
        let rest = kinetic_change(motion, s, jump);
        if let Some(rest) = rest {
            claim(
                &format!(
                    "at a step of {}: T+ - T- = (v+² - v²)/(2 G) for any v+, so T + V is unchanged in transmission \
                     (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)",
                    law.name
                ),
                rest,
            )?;
        }
    }
    for band in &model.dead_bands {
        let at = |symbol: Atom| motion.potential.replace(symbol.to_pattern()).with(number(0).to_pattern());
        let (over, touch) = (symbol(Kind::Deflection, &band.over), symbol(Kind::Touch, &band.touch));
        claim(
            &format!("V is the same on both sides of the edges of {}: no impulse there", band.over),
            at(Atom::var(over)) - at(Atom::var(touch)),
        )?;
    }
    for torque in model.torques.iter().filter(|torque| rolls(model, torque)) {
        let power = all_present(&model.written_out(&torque.power()));
        // Decided by its form: minus a sum of products of factors that are never negative.
        let rest = if never_negative(model, &-power.clone()) { number(0) } else { power };
        claim(&format!("the friction `{}` never feeds energy: its power is never positive", torque.name), rest)?;
    }
    let asymmetry = (0..n).fold(number(0), |sum, i| {
        (0..i).fold(sum, |sum, j| sum + tag("m", i, j) * (&motion.mass[i][j] - &motion.mass[j][i]))
    });
    claim("M is symmetric", asymmetry)?;
    if !s.deflections.is_empty() {
        let rest = model
            .deflections
            .iter()
            .zip(&s.deflections)
            .enumerate()
            .fold(number(0), |sum, (i, (d, linear))| sum + tag("d", i, 0) * (d.value.atom() - linear.of(&s.q)));
        claim("every deflection equals the linear form by which the equations differentiate it", rest)?;
    }
    proved.push(definiteness(model, s, motion)?);
    if let Some(note) = without_jump_terms(model, s, motion) {
        proved.push(note);
    }
    Ok(proved)
}

/// Whether a torque is rolling friction, with a law `arm` as a factor. It must dissipate energy in either direction of rotation.
fn rolls(model: &Model, torque: &Torque) -> bool {
    let arm = |name: &str| model.laws.iter().any(|law| law.name == name && law.role == Role::Friction(Friction::Arm));
    symbols(&model.written_out(&torque.value.atom())).iter().any(|(kind, name)| *kind == Kind::Friction && arm(name))
}

/// A different symbol for every entry: a sum of entries times these symbols is zero only if each entry is.
fn tag(what: &str, i: usize, j: usize) -> Atom {
    Atom::var(symbol(Kind::Free, &format!("{what}{i}_{j}")))
}

/// Replaces the names of constants by their definitions in parameters.
pub(crate) fn exact(motion: &Motion, e: &Atom) -> Atom {
    motion.constants.iter().rev().fold(e.clone(), |e, (name, value)| {
        e.replace(Atom::var(symbol(Kind::Constant, name)).to_pattern()).with(value.to_pattern())
    })
}

/// dE/dt - (Q.q' - q'.dD/dq') after M q'' = F is inserted, where d(q'.p - T)/dt = q'.(M q'') + terms without q''.
fn balance(model: &Model, s: &Symbols, motion: &Motion) -> Atom {
    let n = s.q.len();
    let jump = |e: Atom| with_jump_terms(&e);
    let hamiltonian = (0..n).fold(-&motion.kinetic, |h, i| h + Atom::var(s.v[i]) * motion.kinetic.derivative(s.v[i]));
    let mut rate = number(0);
    for i in 0..n {
        let v = Atom::var(s.v[i]);
        rate = rate + &v * hamiltonian.derivative(s.q[i]) + &v * motion.potential.derivative(s.q[i]);
        rate += &v * jump(motion.force[i].clone());
        rate = rate - &v * &motion.external[i] + &v * motion.dissipation.derivative(s.v[i]);
        rate += &v * s.clipped(&motion.potential, i);
    }
    // V and D also change through deflections, and V through the laws. Differentiated here anew, not with the gradients from
    // which F was made, so that the proof does not repeat their errors.
    for d in &s.deflections {
        rate += d.rate(&s.v) * (motion.potential.derivative(d.symbol) + motion.dissipation.derivative(d.rate_symbol));
    }
    for (l, law) in model.laws.iter().enumerate() {
        rate += &s.gate[l] * s.by_law(&motion.potential, l) * Atom::var(s.slope[l]) * law.phase.dot().atom();
    }
    rate.expand()
}

/// The expression with the jump terms present and other effects unchanged.
fn with_jump_terms(e: &Atom) -> Atom {
    let marker = Atom::var(symbol(Kind::Marker, JUMP_TERMS));
    e.replace(marker.to_pattern()).with(number(1).to_pattern())
}

/// T(q' + d (u - v)) - T(q') - (u² - v²)/(2 G) for any u = v+, with the inverse mass matrix written in parameters. `None` if M
/// was not inverted.
fn kinetic_change(motion: &Motion, s: &Symbols, jump: &Jump) -> Option<Atom> {
    let w = motion.mobility_exact.as_ref()?;
    let (g, direction) = response(w, &jump.normal);
    let speeds = || s.v.iter().map(|v| Atom::var(*v));
    let v = jump.normal.iter().zip(speeds()).fold(number(0), |sum, (n, v)| sum + n * v);
    let u = Atom::var(symbol(Kind::Free, "u"));
    let mut after = motion.kinetic.clone();
    let held: Vec<Atom> = (0..s.v.len()).map(|i| tag("after", i, 0)).collect();
    for (v_i, held) in speeds().zip(&held) {
        after = after.replace(v_i.to_pattern()).with(held.to_pattern());
    }
    for ((v_i, held), d) in speeds().zip(&held).zip(&direction) {
        after = after.replace(held.to_pattern()).with((v_i + d * (&u - &v)).to_pattern());
    }
    let gained = (&u * &u - &v * &v) / (number(2) * g);
    Some(after - &motion.kinetic - gained)
}

/// Whether M is positive definite: by Sylvester's criterion, if every leading minor is a sum of products of positive
/// quantities, else by T as a sum of squares.
fn definiteness(model: &Model, s: &Symbols, motion: &Motion) -> Result<String, Slip> {
    let n = motion.mass.len();
    let minor = |k: usize| determinant(&motion.mass[..k].iter().map(|row| row[..k].to_vec()).collect::<Vec<_>>());
    let posynomial = |e: Atom| !e.is_zero() && terms(&all_present(&e)).iter().all(|t| positive(model, t));
    if n <= LARGEST_DETERMINANT && (1..=n).all(|k| posynomial(minor(k))) {
        return Ok("M is positive definite: every leading minor is a sum of products of positive quantities".into());
    }
    match squares::decide(model, s) {
        Squares::Definite => {
            Ok("M is positive definite: T is a sum of squares that vanish together only at rest".into())
        }
        Squares::Free(left) => {
            let names: Vec<&str> = left.iter().map(|&i| model.coordinates[i].name.as_str()).collect();
            Err(Slip::Singular { model: model.name.clone(), coordinates: names.join(", ") })
        }
        Squares::Undecided => {
            Ok("M is positive definite: not decided symbolically; checked for the numbers of every scene".into())
        }
    }
}

/// The error of the power balance without the jump terms, as a warning to the reader.
fn without_jump_terms(model: &Model, s: &Symbols, motion: &Motion) -> Option<String> {
    let marker = Atom::var(symbol(Kind::Marker, JUMP_TERMS));
    let missing = (0..s.q.len()).fold(number(0), |sum, i| {
        let full = gradient(model, s, &motion.potential, i, JUMP_TERMS);
        let without = full.replace(marker.to_pattern()).with(number(0).to_pattern());
        sum + Atom::var(s.v[i]) * (with_jump_terms(&full) - without)
    });
    let missing = missing.expand();
    (!missing.is_zero()).then(|| {
        format!(
            "without the jump terms the balance fails: energy is created at the rate {}",
            print(&Tree::new(&all_present(&missing)), Style::Plain)
        )
    })
}
