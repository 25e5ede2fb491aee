//! The lines of an `equations!` block while it is written.

use std::fmt::Write;

use symbolica::atom::Atom;

use super::wrap::{WIDTH, wrap};
use crate::derivation::Derivation;
use crate::expr::Expr;
use crate::markers::{Group, as_written, grouped};
use crate::print::{Style, print};

/// Lines of a block, and the conditions that its terms need.
pub(super) struct Block {
    text: String,
    /// Effects and conditions in the order in which terms are printed.
    order: Vec<String>,
    /// The conditions of laws: name and effects.
    of_laws: Vec<(&'static str, String)>,
    /// Conditions made of several effects: name and effects, in the order of their first use.
    conditions: Vec<(String, String)>,
}

impl Block {
    pub fn new(d: &Derivation) -> Self {
        Block { text: String::new(), order: d.order(), of_laws: d.model.conditions(), conditions: vec![] }
    }

    pub fn conditions(&self) -> &[(String, String)] {
        &self.conditions
    }

    pub fn text(self) -> String {
        self.text
    }

    /// Adds the lines of another block.
    pub fn append(&mut self, other: Block) {
        self.text.push_str(&other.text);
    }

    pub fn blank(&mut self) {
        self.text.push('\n');
    }

    pub fn line(&mut self, depth: usize, text: &str) {
        let _ = writeln!(self.text, "{}", wrap(&format!("{}{text}", "    ".repeat(depth))));
    }

    /// `name { .. }`, with the lines that `inside` writes; in one line if there is only one, and it fits.
    pub fn braces(&mut self, depth: usize, name: &str, inside: impl FnOnce(&mut Self)) {
        let before = std::mem::take(&mut self.text);
        inside(self);
        let inner = std::mem::replace(&mut self.text, before);
        let alone = format!("{}{name} {{ {} }}", "    ".repeat(depth), inner.trim());
        if inner.lines().count() == 1 && alone.chars().count() <= WIDTH {
            let _ = writeln!(self.text, "{alone}");
            return;
        }
        self.line(depth, &format!("{name} {{"));
        self.text.push_str(&inner);
        self.line(depth, "}");
    }

    /// The expanded sum, grouped by condition.
    pub fn grouped(&self, e: &Atom) -> Vec<Group> {
        grouped(e, &self.order)
    }

    /// Expressions as the author of the model wrote them, grouped by condition.
    pub fn as_written(&self, pieces: &[Expr]) -> Vec<Group> {
        self.not_expanded(&pieces.iter().map(|p| p.atom()).collect::<Vec<_>>())
    }

    /// Terms as they are, grouped by condition.
    pub fn not_expanded(&self, pieces: &[Atom]) -> Vec<Group> {
        as_written(pieces, &self.order)
    }

    /// `name { condition => sum; ... }`; no line if there are no terms.
    pub fn sum(&mut self, depth: usize, name: &str, groups: &[Group]) {
        if groups.is_empty() {
            return;
        }
        self.braces(depth, name, |b| {
            for group in groups {
                let condition = b.condition(&group.effects);
                b.line(depth + 1, &format!("{condition} => {};", print(&group.sum, Style::Rust)));
            }
        });
    }

    /// As [`Block::sum`], but `name {}` if there are no terms: for rows that must not be missing.
    pub fn row(&mut self, depth: usize, name: &str, groups: &[Group]) {
        match groups {
            [] => self.line(depth, &format!("{name} {{}}")),
            groups => self.sum(depth, name, groups),
        }
    }

    /// The sums of those `values` that are not zero, each under its name.
    pub fn sums(&mut self, depth: usize, what: &str, names: &[&str], values: &[Atom]) {
        self.braces(depth, what, |b| {
            for (name, value) in names.iter().zip(values) {
                b.sum(depth + 1, name, &b.grouped(value));
            }
        });
    }

    /// A row for every one of `values`, zero or not.
    pub fn rows(&mut self, depth: usize, what: &str, names: &[&str], values: &[Atom]) {
        self.braces(depth, what, |b| {
            for (name, value) in names.iter().zip(values) {
                b.row(depth + 1, name, &b.grouped(value));
            }
        });
    }

    /// The upper triangle of a symmetric matrix, expanded.
    pub fn matrix(&mut self, depth: usize, what: &str, names: &[&str], values: &[Vec<Atom>]) {
        self.triangle(depth, what, names, values, |b, entry| b.grouped(entry));
    }

    /// The upper triangle of a symmetric matrix, its entries grouped by `group`.
    pub fn triangle(
        &mut self,
        depth: usize,
        what: &str,
        names: &[&str],
        values: &[Vec<Atom>],
        group: impl Fn(&Self, &Atom) -> Vec<Group>,
    ) {
        self.braces(depth, what, |b| {
            for (i, row) in values.iter().enumerate() {
                for (j, entry) in row.iter().enumerate().skip(i) {
                    b.sum(depth + 1, &format!("{} {}", names[i], names[j]), &group(b, entry));
                }
            }
        });
    }

    /// The name of the condition that all of `effects` are present; a new combination is stored, so that it is declared.
    fn condition(&mut self, effects: &[String]) -> String {
        match effects {
            [] => "_".into(),
            [one] => one.clone(),
            many => {
                let name = many.join("_and_");
                let written_out = |effect: &String| {
                    let condition = self.of_laws.iter().find(|(name, _)| name == effect);
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
}
