//! Is the model what it must be before anything is derived from it? Every symbol declared, every function smooth,
//! every name its own.

use std::collections::BTreeMap;

use symbolica::atom::{Atom, AtomCore, AtomView};
use symbolica::coefficient::CoefficientView;

use crate::expr::{Kind, is_word, symbol, symbols};
use crate::markers::{all_present, terms};
use crate::model::{CONDITIONS, Model, Range, mid_name};
use crate::print::{Style, print};
use crate::slip::Slip;
use crate::tree::Tree;

const SMOOTH: [&str; 4] = ["sin", "cos", "exp", "log"];
/// Words that generated code cannot have as names: keywords of Rust, and two names of that code itself.
const RUST: [&str; 54] = [
    "Self",
    "abstract",
    "as",
    "async",
    "await",
    "become",
    "box",
    "break",
    "const",
    "continue",
    "crate",
    "do",
    "dyn",
    "else",
    "enum",
    "extern",
    "false",
    "final",
    "fn",
    "for",
    "gen",
    "if",
    "impl",
    "in",
    "let",
    "loop",
    "macro",
    "match",
    "mids",
    "mod",
    "move",
    "mut",
    "override",
    "parameters",
    "priv",
    "pub",
    "ref",
    "return",
    "self",
    "static",
    "struct",
    "super",
    "trait",
    "true",
    "try",
    "type",
    "typeof",
    "unsafe",
    "unsized",
    "use",
    "virtual",
    "where",
    "while",
    "yield",
];

/// Checks a whole model; the first slip found ends it.
pub(crate) fn check(model: &Model) -> Result<(), Slip> {
    if model.coordinates.is_empty() {
        return Err(Slip::Empty { model: model.name.clone() });
    }
    let declared = names(model)?;
    let place = |e: &Atom, place: &str, allowed: &[Kind], why: &'static str| -> Result<(), Slip> {
        functions(model, e.as_view(), place)?;
        for (kind, name) in symbols(e) {
            let derived = matches!(kind, Kind::Marker | Kind::Mobility);
            match declared.get(&name) {
                _ if derived => {}
                Some(what) if *what == what_it_is(kind) => {}
                Some(_) if kind != Kind::Free => {
                    let why = "here the name stands for something else; was it declared in another model?";
                    return Err(Slip::Misplaced { model: model.name.clone(), symbol: name, place: place.into(), why });
                }
                _ => {
                    let usable = |what: &str| USABLE.iter().any(|kind| what_it_is(*kind) == what);
                    let declared = declared.iter().filter(|(_, what)| usable(what)).map(|(name, _)| name.as_str());
                    let declared = declared.collect::<Vec<_>>().join(", ");
                    let (model, place) = (model.name.clone(), place.to_string());
                    return Err(Slip::Undeclared { model, symbol: name, place, declared });
                }
            }
            if kind != Kind::Marker && !allowed.contains(&kind) {
                return Err(Slip::Misplaced { model: model.name.clone(), symbol: name, place: place.into(), why });
            }
        }
        Ok(())
    };
    use Kind::*;
    let each = |pieces: &[crate::Expr], what: &str, allowed: &[Kind], why| -> Result<(), Slip> {
        pieces.iter().try_for_each(|piece| place(&piece.atom(), what, allowed, why))
    };
    let constant = &[Constant, Parameter, Mid, Mobility];
    for (name, value) in &model.constants {
        place(
            &value.atom(),
            &format!("the constant `{name}`"),
            constant,
            "a constant may depend on parameters, constants and mid values only",
        )?;
    }
    for parts in &model.motions {
        for (q, speed) in &parts.speeds {
            place(&q.atom(), "a motion", &[Coordinate], "a motion gives speeds to coordinates")?;
            place(
                &speed.atom(),
                "a motion",
                constant,
                "the speeds of a motion may depend on parameters and constants only",
            )?;
        }
    }
    each(
        &model.kinetic,
        "the kinetic energy",
        &[Constant, Parameter, Mid, Coordinate, Speed],
        "T depends on coordinates and speeds, not on the mesh",
    )?;
    each(
        &model.potential,
        "the potential energy",
        &[Constant, Parameter, Mid, Law, Coordinate],
        "V depends on positions, never on speeds",
    )?;
    each(
        &model.dissipation,
        "the dissipation function",
        &[Constant, Parameter, Mid, Coordinate, Speed],
        "D depends on coordinates and speeds, not on the mesh",
    )?;
    for torque in &model.torques {
        place(
            &torque.value.atom(),
            &format!("the torque `{}`", torque.name),
            &[Constant, Parameter, Mid],
            "torques are constant",
        )?;
        place(
            &torque.through.atom(),
            &format!("the displacement of the torque `{}`", torque.name),
            &[Constant, Parameter, Coordinate],
            "a displacement depends on coordinates",
        )?;
    }
    for law in &model.laws {
        if !(law.period.is_finite() && law.period > 0.0) {
            return Err(Slip::Pitch { model: model.name.clone(), law: law.name.clone(), pitch: law.period });
        }
        let phase = law.phase.atom();
        let coordinate = matches!(symbols(&phase).as_slice(), [(Kind::Coordinate, name)] if phase == Atom::var(symbol(Kind::Coordinate, name)));
        if !coordinate {
            return Err(Slip::Phase { model: model.name.clone(), law: law.name.clone(), phase: phase.to_string() });
        }
    }
    for p in &model.parameters {
        let admissible = |x: f64| match p.range {
            Range::Any => true,
            Range::Positive => x > 0.0,
            Range::NotNegative => x >= 0.0,
        };
        if let Some(default) = p.default.filter(|x| !(x.is_finite() && admissible(*x))) {
            return Err(Slip::Default { model: model.name.clone(), parameter: p.name.clone(), default });
        }
    }
    quadratic(model)?;
    dissipative(model)
}

/// What energies are written in.
const USABLE: [Kind; 6] = [Kind::Constant, Kind::Parameter, Kind::Mid, Kind::Law, Kind::Coordinate, Kind::Speed];

/// What a symbol of a kind is declared as.
fn what_it_is(kind: Kind) -> &'static str {
    match kind {
        Kind::Coordinate => "a coordinate",
        Kind::Speed => "a speed",
        Kind::Parameter => "a parameter",
        Kind::Constant => "a constant",
        Kind::Law => "a law",
        Kind::Mid => "the mid value of a law",
        Kind::Slope => "the slope of a law",
        Kind::Curvature => "the curvature of a law",
        Kind::Marker | Kind::Mobility | Kind::Free => "nothing that is declared",
    }
}

/// Every declared name, once, with what it is.
fn names(model: &Model) -> Result<BTreeMap<String, &'static str>, Slip> {
    let mut all = BTreeMap::new();
    let mut declare = |name: &str, what: &'static str, derived: bool| -> Result<(), Slip> {
        let allowed =
            is_word(name) && !RUST.contains(&name) && (derived || !(name.ends_with("_dot") || name.ends_with("_mid")));
        if !allowed {
            return Err(Slip::Name { model: model.name.clone(), name: name.into() });
        }
        match all.insert(name.to_string(), what) {
            None => Ok(()),
            Some(first) => Err(Slip::Twice { model: model.name.clone(), name: name.into(), first, second: what }),
        }
    };
    use Kind::*;
    let known = what_it_is;
    declare(&model.name, "the model", false)?;
    model.coordinates.iter().try_for_each(|c| declare(&c.name, known(Coordinate), false))?;
    model.speeds().iter().try_for_each(|s| declare(s, known(Speed), true))?;
    model.parameters.iter().try_for_each(|p| declare(&p.name, known(Parameter), false))?;
    model.constants.iter().try_for_each(|(name, _)| declare(name, known(Constant), false))?;
    for law in &model.laws {
        declare(&law.name, known(Law), false)?;
        declare(&mid_name(&law.name), known(Mid), true)?;
        declare(&format!("d{}", law.name), known(Slope), true)?;
        declare(&format!("dd{}", law.name), known(Curvature), true)?;
    }
    model.motions.iter().try_for_each(|m| declare(&m.name, "a motion", false))?;
    model.effects.iter().try_for_each(|e| declare(&e.name, "an effect", false))?;
    CONDITIONS.iter().try_for_each(|(name, _)| declare(name, "a condition", true))?;
    model.torques.iter().try_for_each(|t| declare(&t.name, "a torque", false))?;
    Ok(all)
}

fn functions(model: &Model, e: AtomView, place: &str) -> Result<(), Slip> {
    match e {
        AtomView::Num(_) => numbers(model, e, place),
        AtomView::Var(_) => Ok(()),
        AtomView::Fun(f) => {
            let symbol = f.get_symbol();
            let name = symbol.get_stripped_name();
            if !SMOOTH.contains(&name) {
                let (model, place) = (model.name.clone(), place.to_string());
                return Err(Slip::Function { model, function: name.to_string(), place });
            }
            f.iter().try_for_each(|a| functions(model, a, place))
        }
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            functions(model, base, place)?;
            functions(model, exponent, place)
        }
        AtomView::Mul(m) => m.iter().try_for_each(|a| functions(model, a, place)),
        AtomView::Add(a) => a.iter().try_for_each(|a| functions(model, a, place)),
    }
}

/// Integers up to here have an f64 of their own.
const EXACT: u64 = 1 << 53;

/// Every number must be rational, finite, and exact in code: a division by zero, say, has left something else.
pub(crate) fn numbers(model: &Model, e: AtomView, place: &str) -> Result<(), Slip> {
    match e {
        AtomView::Num(n) => match n.get_coeff_view() {
            CoefficientView::Natural(n, d, 0, _) if n.unsigned_abs() <= EXACT && d.unsigned_abs() <= EXACT => Ok(()),
            _ => Err(Slip::Number { model: model.name.clone(), number: e.to_canonical_string(), place: place.into() }),
        },
        AtomView::Var(_) => Ok(()),
        AtomView::Fun(f) => f.iter().try_for_each(|a| numbers(model, a, place)),
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            numbers(model, base, place)?;
            numbers(model, exponent, place)
        }
        AtomView::Mul(m) => m.iter().try_for_each(|a| numbers(model, a, place)),
        AtomView::Add(a) => a.iter().try_for_each(|a| numbers(model, a, place)),
    }
}

/// T must be homogeneous of degree two in the speeds: scaled speeds scale it by the square.
fn quadratic(model: &Model) -> Result<(), Slip> {
    let stretch = Atom::var(symbol(Kind::Free, "stretch"));
    for piece in &model.kinetic {
        for term in terms(&piece.atom().expand()) {
            let scaled = model.speeds().iter().fold(term.clone(), |t, name| {
                let speed = Atom::var(symbol(Kind::Speed, name));
                t.replace(speed.to_pattern()).with((&stretch * &speed).to_pattern())
            });
            if !(scaled - &term * &stretch * &stretch).expand().is_zero() {
                let term = print(&Tree::new(&all_present(&term)), Style::Plain);
                return Err(Slip::NotQuadratic { model: model.name.clone(), term });
            }
        }
    }
    Ok(())
}

/// Every piece of D must be a square with a factor that is never negative; anything else is refused by name. (A sum
/// of products that happens to be positive can be written as squares.)
fn dissipative(model: &Model) -> Result<(), Slip> {
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

/// Whether an expression is >= 0 for all admissible values, by its form.
fn never_negative(model: &Model, e: &Atom) -> bool {
    sign(model, e, false)
}

/// Whether an expression is > 0 for all admissible values, by its form.
pub(crate) fn positive(model: &Model, e: &Atom) -> bool {
    sign(model, e, true)
}

fn sign(model: &Model, e: &Atom, strictly: bool) -> bool {
    let admissible = |range: Range| match range {
        Range::Any => false,
        Range::Positive => true,
        Range::NotNegative => !strictly,
    };
    match e.as_view() {
        AtomView::Num(_) => matches!(Tree::new(e), Tree::Number(n, _) if n > 0 || (n == 0 && !strictly)),
        AtomView::Var(_) => match symbols(e).as_slice() {
            [(Kind::Parameter, name)] => model.parameters.iter().any(|p| p.name == *name && admissible(p.range)),
            [(Kind::Constant, name)] => {
                model.constants.iter().any(|(c, value)| c == name && sign(model, &value.atom(), strictly))
            }
            // A scene's law values are >= 0; W_ii > 0 since M is positive definite.
            [(Kind::Mid | Kind::Law, _)] => !strictly,
            [(Kind::Mobility, name)] => name[1..].split_once('_').is_some_and(|(i, j)| i == j),
            _ => false,
        },
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            let base = base.to_owned();
            match Tree::new(&exponent.to_owned()) {
                Tree::Number(n, 1) if n % 2 == 0 && !strictly => true,
                Tree::Number(_, 2) if !strictly => true,
                _ => sign(model, &base, strictly),
            }
        }
        AtomView::Mul(m) => m.iter().all(|f| sign(model, &f.to_owned(), strictly)),
        AtomView::Add(a) => a.iter().all(|t| sign(model, &t.to_owned(), strictly)),
        AtomView::Fun(_) => false,
    }
}
