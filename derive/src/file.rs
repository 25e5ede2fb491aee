//! The generated file: what it says at its head, and the `equations!` block below it.

use std::fmt::Write;

use symbolica::atom::Atom;

use crate::derivation::Derivation;
use crate::expr::Expr;
use crate::lagrange;
use crate::markers::{Group, as_written, grouped};
use crate::model::{CONDITIONS, DeadBand, Friction, Range, Role, Start};
use crate::print::{Style, print};
use crate::text::{self, Texts};
use crate::tree::Tree;

/// The whole text of `gearsim/src/generated/<model>.rs`.
pub(crate) fn write(d: &Derivation) -> String {
    let texts = text::write(d);
    let mut block = Block { out: String::new(), order: d.order(), conditions: vec![] };
    block.body(d);
    let body = block.finish(d, &texts);
    format!("{}\n\nuse gearsim_macros::equations;\n\nequations! {{\n{body}}}\n", head(d, &texts, &body_operations(d)))
}

fn head(d: &Derivation, texts: &Texts, operations: &[(String, [usize; 3])]) -> String {
    let m = d.model;
    let mut lines = vec![
        format!("Equations of motion of `{}`: {}.", m.name, one_line(&m.title)),
        String::new(),
        format!(
            "Derived from the energies in `models/src/{}.rs` by `cargo xtask derive {}`. Do not edit: change the",
            described_in(&m.name),
            m.name
        ),
        "energies and derive again.".into(),
        format!("Source: {}", one_line(&m.source)),
    ];
    let mut section = |title: &str, fence: &str, content: &[String]| {
        lines.extend([String::new(), format!("# {title}"), String::new(), format!("```{fence}")]);
        lines.extend(content.iter().cloned());
        lines.push("```".into());
    };
    section("Energies", "text", &texts.energies);
    if !texts.constants.is_empty() {
        section("Constants", "text", &texts.constants);
    }
    if !texts.deflections.is_empty() {
        section("Deflections", "text", &texts.deflections);
    }
    if !texts.forces.is_empty() {
        section("Forces", "text", &texts.forces);
    }
    section("Equations of motion", "text", &texts.motion);
    if !texts.jump.is_empty() {
        let errors = m.laws.iter().any(|law| law.role == Role::Error);
        let title =
            if errors { "At a step of a stiffness or a transmission error" } else { "At a step of a stiffness" };
        section(title, "text", &texts.jump);
    }
    section("Between two steps", "text", &texts.cell);
    section("LaTeX", "latex", &texts.latex);
    lines.extend([String::new(), "# Proved".into(), String::new()]);
    lines.extend(d.proofs.iter().map(|p| format!("- {p}")));
    lines.extend([String::new(), "# Operations, all effects present".into(), String::new()]);
    lines.push("| output | sums | products, quotients | functions, roots |".into());
    lines.push("| --- | --- | --- | --- |".into());
    lines.extend(operations.iter().map(|(name, [a, m, f])| format!("| {name} | {a} | {m} | {f} |")));
    lines.iter().map(|l| format!("//! {l}").trim_end().to_string()).collect::<Vec<_>>().join("\n")
}

/// The file of a model: `planetary_3`, with the number of its parts, is described in `planetary.rs`.
fn described_in(name: &str) -> &str {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.len() < name.len() { stem.strip_suffix('_').unwrap_or(name) } else { name }
}

/// What a law with an effect is, where it is no offset of deflections.
fn role(role: Role) -> &'static str {
    match role {
        Role::Friction(Friction::Side) => " as side",
        Role::Friction(Friction::Arm) => " as arm",
        Role::Stiffness | Role::Error => "",
    }
}

/// A text that cannot end the comment it stands in.
fn one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}

fn body_operations(d: &Derivation) -> Vec<(String, [usize; 3])> {
    let count = |atoms: &[Atom]| {
        atoms.iter().flat_map(|a| grouped(a, &d.order())).fold([0; 3], |sum, group| {
            let n = group.sum.operations();
            [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]
        })
    };
    let constants: Vec<Atom> = d.motion.constants.iter().map(|c| c.1.clone()).collect();
    let mut rows = vec![];
    if !constants.is_empty() {
        rows.push(("constants (once a scene)".to_string(), count(&constants)));
    }
    let forces: Vec<Atom> = d.model.forces.iter().map(|force| force.value.atom()).collect();
    if !forces.is_empty() {
        rows.push(("named forces".into(), count(&forces)));
    }
    rows.push(("force".into(), count(&d.motion.force)));
    if let Some(a) = &d.motion.acceleration {
        rows.push(("acceleration".into(), count(a)));
    }
    for (law, jump) in d.model.laws.iter().zip(&d.jumps) {
        rows.push((format!("energy step of {}", law.name), count(std::slice::from_ref(&jump.step))));
    }
    rows
}

struct Block {
    out: String,
    order: Vec<String>,
    /// Conditions that several effects must meet together, named as they come up.
    conditions: Vec<(String, String)>,
}

impl Block {
    fn line(&mut self, depth: usize, text: &str) {
        let _ = writeln!(self.out, "{}{text}", "    ".repeat(depth));
    }

    /// `name { condition => sum; ... }`, nothing where there are no terms.
    fn groups(&mut self, depth: usize, name: &str, groups: &[Group]) {
        if groups.is_empty() {
            return;
        }
        self.line(depth, &format!("{name} {{"));
        for group in groups {
            let condition = self.condition(&group.effects);
            self.line(depth + 1, &format!("{condition} => {};", print(&group.sum, Style::Rust)));
        }
        self.line(depth, "}");
    }

    /// As `groups`, but `name {}` where there are no terms.
    fn row(&mut self, depth: usize, name: &str, groups: &[Group]) {
        match groups {
            [] => self.line(depth, &format!("{name} {{}}")),
            groups => self.groups(depth, name, groups),
        }
    }

    fn condition(&mut self, effects: &[String]) -> String {
        match effects {
            [] => "_".into(),
            [one] => one.clone(),
            many => {
                let name = many.join("_and_");
                let written_out = |effect: &String| {
                    let condition = CONDITIONS.iter().find(|(name, _)| name == effect);
                    condition.map_or(effect.clone(), |(_, effects)| effects.to_string())
                };
                let entry = (name.clone(), many.iter().map(written_out).collect::<Vec<_>>().join(", "));
                if !self.conditions.contains(&entry) {
                    self.conditions.push(entry);
                }
                name
            }
        }
    }

    fn body(&mut self, d: &Derivation) {
        let (m, motion) = (d.model, &d.motion);
        let names: Vec<&str> = m.coordinates.iter().map(|c| c.name.as_str()).collect();
        let group = |a: &Atom| grouped(a, &d.order());
        let written = |pieces: &[Expr]| as_written(&pieces.iter().map(|p| p.atom()).collect::<Vec<_>>(), &d.order());

        if !motion.constants.is_empty() {
            self.line(1, "constants {");
            for (name, value) in &motion.constants {
                self.line(2, &format!("{name} = {};", print(&Tree::new(value), Style::Rust)));
            }
            self.line(1, "}");
        }
        if !m.deflections.is_empty() {
            self.line(1, "deflections {");
            for deflection in &m.deflections {
                let value = Tree::new(&deflection.value.atom());
                self.line(2, &format!("{} = {};", deflection.name, print(&value, Style::Rust)));
            }
            self.line(1, "}");
        }
        if !m.forces.is_empty() {
            self.line(1, "forces {");
            for force in &m.forces {
                let condition = force.with.as_deref().unwrap_or("_");
                let value = print(&Tree::new(&force.value.atom()), Style::Rust);
                self.line(2, &format!("{} {{ {condition} => {value}; }}", force.name));
            }
            self.line(1, "}");
        }
        if !m.dead_bands.is_empty() {
            self.line(1, "dead_bands {");
            for DeadBand { over, touch, edge, damp, clip, unit, half, effect, doc } in &m.dead_bands {
                let half = print(&Tree::new(&half.atom()), Style::Rust);
                let symbols = format!("{touch}, {edge}, {damp}, {clip}");
                self.line(2, &format!("{over} {unit:?} ({symbols}) half {half} with {effect}, {doc:?};"));
            }
            self.line(1, "}");
        }
        self.line(1, "energies {");
        self.groups(2, "kinetic", &written(&m.kinetic));
        self.groups(2, "potential", &written(&m.potential));
        self.groups(2, "dissipation", &written(&m.dissipation));
        self.line(1, "}");
        let s = lagrange::Symbols::new(m);
        self.line(1, "torques {");
        for t in &m.torques {
            let title = format!("{} {:?}", t.name, t.doc);
            if m.varies(t) {
                let power = as_written(&[t.power()], &d.order());
                self.row(2, &title, &[]);
                self.groups(2, "power", &power);
            } else {
                let work = as_written(&[t.value.atom() * lagrange::displacement(&s, t)], &d.order());
                self.row(2, &title, &work);
            }
        }
        self.line(1, "}");
        let constant = lagrange::external(m, &s, |t| !m.varies(t));
        self.vector("work", &names, &constant, &group);
        self.matrix("mass", &names, &motion.mass, &group, 1, true);
        if let Some(w) = &motion.mobility {
            // Not expanded: a sum over the determinant stays one fraction, without cancellation where M is without.
            let fraction = |a: &Atom| as_written(std::slice::from_ref(a), &d.order());
            self.matrix("mobility", &names, w, &fraction, 1, true);
        }
        self.vector("force", &names, &motion.force, &group);
        self.line(1, "jacobian {");
        for (i, row) in d.jacobian.iter().enumerate() {
            for (by, entry) in d.states().iter().zip(row) {
                self.groups(2, &format!("{} {by}", names[i]), &group(entry));
            }
        }
        self.line(1, "}");
        match &d.cell {
            Ok(cell) => {
                self.line(1, "cell {");
                self.matrix("stiffness", &names, &cell.stiffness, &group, 2, true);
                self.matrix("damping", &names, &cell.damping, &group, 2, true);
                self.line(2, "load {");
                for (name, load) in names.iter().zip(&cell.load) {
                    self.groups(3, name, &group(load));
                }
                self.line(2, "}");
                self.line(1, "}");
                if !cell.nonlinear_with.is_empty() {
                    self.line(1, "nonlinear_with {");
                    for (effect, text) in &cell.nonlinear_with {
                        self.line(2, &format!("{effect} {text:?};"));
                    }
                    self.line(1, "}");
                }
            }
            Err(culprits) => self.line(1, &format!("nonlinear {:?};", culprits.join("; "))),
        }
        for (law, jump) in m.laws.iter().zip(&d.jumps) {
            self.line(1, &format!("jump {} {{", law.name));
            self.line(2, "normal {");
            for (name, n) in names.iter().zip(&jump.normal) {
                self.groups(3, name, &group(n));
            }
            self.line(2, "}");
            if let (Some(g), Some(direction)) = (&jump.compliance, &jump.direction) {
                self.groups(2, "compliance", &group(g));
                self.line(2, "direction {");
                for (name, part) in names.iter().zip(direction) {
                    self.groups(3, name, &group(part));
                }
                self.line(2, "}");
            }
            self.row(2, "step", &group(&jump.step));
            self.line(1, "}");
        }
    }

    fn vector(&mut self, what: &str, names: &[&str], values: &[Atom], group: &dyn Fn(&Atom) -> Vec<Group>) {
        self.line(1, &format!("{what} {{"));
        for (name, value) in names.iter().zip(values) {
            self.row(2, name, &group(value));
        }
        self.line(1, "}");
    }

    #[allow(clippy::needless_range_loop)] // rows and columns by index, as matrices are written
    fn matrix(
        &mut self,
        what: &str,
        names: &[&str],
        values: &[Vec<Atom>],
        group: &dyn Fn(&Atom) -> Vec<Group>,
        depth: usize,
        symmetric: bool,
    ) {
        self.line(depth, &format!("{what} {{"));
        for i in 0..names.len() {
            for j in if symmetric { i } else { 0 }..names.len() {
                self.groups(depth + 1, &format!("{} {}", names[i], names[j]), &group(&values[i][j]));
            }
        }
        self.line(depth, "}");
    }

    /// Declarations in front, texts behind.
    fn finish(self, d: &Derivation, texts: &Texts) -> String {
        let mut b = Block { out: String::new(), order: self.order.clone(), conditions: vec![] };
        let m = d.model;
        b.line(1, &format!("model {} {:?};", m.name, m.title));
        b.line(1, &format!("source {:?};", m.source));
        b.line(0, "");
        b.line(1, "coordinates {");
        for c in &m.coordinates {
            let start = match c.start {
                Start::At(x) => format!("{x:?}"),
                Start::Static => "static".into(),
            };
            b.line(2, &format!("{} {:?} start {start}, {:?};", c.name, c.unit, c.doc));
        }
        b.line(1, "}");
        b.line(1, "parameters {");
        for p in &m.parameters {
            let default = match (p.default, &p.with) {
                (Some(x), _) => format!("default {x:?}"),
                (None, Some(effect)) => format!("required with {effect}"),
                (None, None) => "required".into(),
            };
            let range = match p.range {
                Range::Any => "open -inf to inf",
                Range::Positive => "open 0.0 to inf",
                Range::NotNegative => "from 0.0 to inf",
            };
            b.line(2, &format!("{} {:?} {default}, {range}, {:?};", p.name, p.unit, p.doc));
        }
        b.line(1, "}");
        b.line(1, "laws {");
        for law in &m.laws {
            let phase = print(&Tree::new(&law.phase.atom()), Style::Rust);
            b.line(
                2,
                &format!(
                    "{} {:?} phase {phase} period {:?}{}{}, {:?};",
                    law.name,
                    law.unit,
                    law.period,
                    if d.rolling(law) { " rolling" } else { "" },
                    law.with.as_ref().map_or(String::new(), |effect| format!(" with {effect}{}", role(law.role))),
                    law.doc
                ),
            );
        }
        b.line(1, "}");
        b.line(1, "motions {");
        for motion in &m.motions {
            let speeds: String = motion
                .speeds
                .iter()
                .map(|(q, v)| {
                    format!(
                        "{}_dot = {}; ",
                        print(&Tree::new(&q.atom()), Style::Rust),
                        print(&Tree::new(&v.atom()), Style::Rust)
                    )
                })
                .collect();
            b.line(2, &format!("{} {:?} {{ {speeds}}}, {:?};", motion.name, motion.unit, motion.doc));
        }
        b.line(1, "}");
        b.line(1, "effects {");
        for e in &m.effects {
            let list = |word: &str, names: &[String]| {
                if names.is_empty() { String::new() } else { format!("{word}({}) ", names.join(", ")) }
            };
            b.line(
                2,
                &format!("{} {}{}{:?};", e.name, list("requires", &e.requires), list("excludes", &e.excludes), e.doc),
            );
        }
        b.line(1, "}");
        b.line(1, "conditions {");
        if !m.laws.is_empty() {
            for (name, condition) in CONDITIONS {
                b.line(2, &format!("{name} = {condition};"));
            }
        }
        for (name, effects) in &self.conditions {
            b.line(2, &format!("{name} = {effects};"));
        }
        b.line(1, "}");
        b.line(0, "");
        b.out.push_str(&self.out);
        b.line(0, "");
        b.line(1, "text {");
        for line in texts.plain() {
            b.line(2, &format!("{line:?};"));
        }
        b.line(1, "}");
        b.line(1, "latex {");
        for line in &texts.latex {
            b.line(2, &format!("{line:?};"));
        }
        b.line(1, "}");
        b.out
    }
}
