//! The derived equations for reading, as plain text or in LaTeX: one section after another, each group of terms in its own line,
//! with the effects that it needs.

mod jumps;
mod names;

use symbolica::atom::Atom;

use crate::derivation::Derivation;
use crate::file::wrap::wrap;
use crate::markers::{Group, as_written, grouped};
use crate::print::{Style, latex_name, print};
use crate::tree::Tree;

/// Left sides shorter than this are followed by the first terms of the right side in the same line.
const SHORT: usize = 40;

/// The text of a derivation in a style. LaTeX has the equations only; plain text has explanations too.
pub(crate) fn write(d: &Derivation, style: Style) -> String {
    let w = Writer { order: d.order(), style };
    let sections = [energies(d, &w), names::write(d, &w), motion(d, &w), jumps::write(d, &w), cells(d, &w)];
    let text = |lines: Vec<String>| lines.iter().map(|line| wrap(line) + "\n").collect::<String>();
    let sections = sections.into_iter().filter(|lines| !lines.is_empty()).map(text);
    sections.collect::<Vec<_>>().join("\n")
}

struct Writer {
    /// Effects and conditions in the order in which terms are written.
    order: Vec<String>,
    style: Style,
}

impl Writer {
    fn plain(&self) -> bool {
        self.style != Style::Latex
    }

    fn name(&self, name: &str) -> String {
        if self.plain() { name.into() } else { latex_name(name) }
    }

    fn print(&self, e: &Atom) -> String {
        print(&Tree::new(e), self.style)
    }

    fn grouped(&self, e: &Atom) -> Vec<Group> {
        grouped(e, &self.order)
    }

    /// `left = a` and one more line for each further group of terms: `    + b [torques]`.
    fn equation(&self, left: &str, groups: &[Group]) -> Vec<String> {
        let mut lines = vec![];
        for group in groups {
            let text = print(&group.sum, self.style);
            let line = match (lines.len(), text.strip_prefix('-')) {
                (0, _) => format!("{left} = {text}"),
                (_, Some(rest)) => format!("    - {rest}"),
                (_, None) => format!("    + {text}"),
            };
            let effects = group.effects.join(", ").replace('_', " ");
            lines.push(match (effects.as_str(), self.style) {
                ("", _) => line,
                (effects, Style::Latex) => format!("{line}\\ [\\text{{{effects}}}]"),
                (effects, _) => format!("{line} [{effects}]"),
            });
        }
        if lines.is_empty() { vec![format!("{left} = 0")] } else { lines }
    }

    /// The groups of terms in one line.
    fn line(&self, e: &Atom) -> String {
        let lines = self.equation("", &self.grouped(e));
        lines.iter().map(|line| line.trim_start_matches(" = ").trim_start()).collect::<Vec<_>>().join(" ")
    }
}

fn energies(d: &Derivation, w: &Writer) -> Vec<String> {
    let m = d.model;
    let mut lines = vec![];
    for (name, pieces) in [("T", &m.kinetic), ("V", &m.potential), ("D", &m.dissipation)] {
        let pieces: Vec<Atom> = pieces.iter().map(|p| p.atom()).collect();
        lines.extend(w.equation(name, &as_written(&pieces, &w.order)));
    }
    for (c, q) in m.coordinates.iter().zip(&d.motion.external).filter(|(_, q)| !q.is_zero()) {
        let left = if w.plain() { format!("Q_{}", c.name) } else { format!("Q_{{{}}}", latex_name(&c.name)) };
        lines.extend(w.equation(&left, &w.grouped(q)));
    }
    lines
}

/// The accelerations if M was inverted, else the rows of M q'' = F.
fn motion(d: &Derivation, w: &Writer) -> Vec<String> {
    let (m, motion) = (d.model, &d.motion);
    let twice = |name: &str| if w.plain() { format!("{name}''") } else { format!("\\ddot{{{}}}", latex_name(name)) };
    let row = |i: usize| match &motion.acceleration {
        Some(a) => w.equation(&twice(&m.coordinates[i].name), &w.grouped(&a[i])),
        None => {
            let entries = motion.mass[i].iter().zip(&m.coordinates).filter(|(entry, _)| !entry.is_zero());
            let inertia = entries.map(|(entry, c)| match w.line(entry) {
                sum if sum.contains(' ') || sum.starts_with('-') => format!("({sum}) {}", twice(&c.name)),
                one => format!("{one} {}", twice(&c.name)),
            });
            let inertia = inertia.collect::<Vec<_>>().join(" + ");
            let mut force =
                w.equation("", &w.grouped(&motion.force[i])).into_iter().map(|line| line.trim().to_string());
            let mut lines = vec![inertia];
            if lines[0].len() < SHORT {
                lines[0] += &force.next().map_or(String::new(), |first| format!(" {first}"));
            }
            lines.extend(force.map(|line| format!("    {line}")));
            lines
        }
    };
    (0..m.coordinates.len()).flat_map(row).collect()
}

fn cells(d: &Derivation, w: &Writer) -> Vec<String> {
    match &d.cell.nonlinear[..] {
        _ if !w.plain() => vec![],
        [] => vec!["between two steps M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly".into()],
        culprits => culprits.iter().map(|c| format!("nonlinear: {c}")).collect(),
    }
}
