//! The declarations at the head of the block: the model, coordinates, parameters, laws, motions, effects, conditions.

use super::block::Block;
use crate::derivation::Derivation;
use crate::model::{Boundary, Effect, Factor, GearData, Law, Model, Parameter, Range, RigidMotion, Role, Start};
use crate::print::{Style, print};
use crate::tree::Tree;

/// Writes the declarations. `conditions` are those that the equations need in addition to the conditions of laws.
pub(super) fn write(b: &mut Block, d: &Derivation, conditions: &[(String, String)]) {
    let m = d.model;
    b.line(1, &format!("model {} {:?};", m.name, m.title));
    b.line(1, &format!("source {:?};", m.source));
    b.blank();
    coordinates(b, m);
    b.braces(1, "parameters", |b| m.parameters.iter().for_each(|p| parameter(b, p)));
    b.braces(1, "laws", |b| m.laws.iter().zip(d.rolling()).for_each(|(l, rolling)| law(b, l, rolling)));
    b.braces(1, "motions", |b| m.motions.iter().for_each(|x| motion(b, x)));
    b.braces(1, "effects", |b| m.effects.iter().for_each(|e| effect(b, e)));
    if !m.switching.is_empty() {
        b.braces(1, "switching", |b| Boundary::ALL.into_iter().for_each(|how| switching(b, m, how)));
    }
    b.braces(1, "conditions", |b| {
        for (name, effects) in m.conditions() {
            b.line(2, &format!("{name} = {effects};"));
        }
        for (name, effects) in conditions {
            b.line(2, &format!("{name} = {effects};"));
        }
    });
}

/// Writes the effect with which laws switch in the way `how`, if there is one.
fn switching(b: &mut Block, m: &Model, how: Boundary) {
    if let Some(effect) = m.switching(how) {
        b.line(2, &format!("{effect} => {};", how.word()));
    }
}

fn coordinates(b: &mut Block, m: &Model) {
    b.braces(1, "coordinates", |b| {
        for c in &m.coordinates {
            let start = match c.start {
                Start::At(x) => format!("{x:?}"),
                Start::Static => "static".into(),
            };
            b.line(2, &format!("{} {:?} start {start}, {:?};", c.name, c.unit, c.doc));
        }
    });
}

fn parameter(b: &mut Block, p: &Parameter) {
    let default = p.default.map_or("required".into(), |x| format!("default {x:?}"));
    let with = p.with.as_ref().map_or(String::new(), |effect| format!(" with {effect}"));
    let range = match p.range {
        Range::Any => "open -inf to inf",
        Range::Positive | Range::Above(_) => "open 0.0 to inf",
        Range::NotNegative => "from 0.0 to inf",
    };
    let above = p.range.above().map_or(String::new(), |lesser| format!(" above {lesser}"));
    let gear_data = p.gear_data.map_or("", |gear_data| match gear_data {
        GearData::Teeth => " teeth",
        GearData::BaseRadius => " base_radius",
        GearData::PressureAngle => " pressure_angle",
        GearData::Support => " support",
    });
    b.line(2, &format!("{} {:?}{gear_data} {default}{with}, {range}{above}, {:?};", p.name, p.unit, p.doc));
}

fn law(b: &mut Block, law: &Law, rolling: Option<Vec<String>>) {
    let phase = print(&Tree::new(&law.phase.atom()), Style::Rust);
    let rolling = match rolling.as_deref() {
        None => String::new(),
        Some([]) => " rolling".into(),
        Some(effects) => format!(" rolling unless({})", effects.join(", ")),
    };
    let with = law.with.as_ref().map_or(String::new(), |effect| format!(" with {effect}{}", role(law.role)));
    let Law { name, unit, period, doc, .. } = law;
    b.line(2, &format!("{name} {unit:?} phase {phase} period {period:?}{rolling}{with}, {doc:?};"));
}

/// The words for the role of a law. A stiffness and an offset need none.
fn role(role: Role) -> &'static str {
    match role {
        Role::Factor(Factor::Side) => " as side",
        Role::Factor(Factor::Arm) => " as arm",
        Role::Stiffness | Role::Offset => "",
    }
}

fn motion(b: &mut Block, motion: &RigidMotion) {
    let rust = |e: crate::Expr| print(&Tree::new(&e.atom()), Style::Rust);
    let speeds: String = motion.speeds.iter().map(|(q, v)| format!("{}_dot = {}; ", rust(*q), rust(*v))).collect();
    b.line(2, &format!("{} {:?} {{ {speeds}}}, {:?};", motion.name, motion.unit, motion.doc));
}

fn effect(b: &mut Block, e: &Effect) {
    let list = |word: &str, names: &[String]| {
        if names.is_empty() { String::new() } else { format!("{word}({}) ", names.join(", ")) }
    };
    let (requires, excludes) = (list("requires", &e.requires), list("excludes", &e.excludes));
    let of = e.of.as_ref().map_or(String::new(), |of| format!("of {of} "));
    b.line(2, &format!("{} {of}{requires}{excludes}{:?};", e.name, e.doc));
}
