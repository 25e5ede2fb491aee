//! The derived equations in readable form, as plain text and in LaTeX.

use symbolica::atom::{Atom, AtomCore};

use crate::derivation::Derivation;
use crate::expr::{Kind, number, speed_name};
use crate::markers::{self, Group, as_written, grouped};
use crate::model::{DeadBand, Law, Role};
use crate::print::{Style, latex_name, print, symbol_text};
use crate::tree::Tree;

/// Lines of text, by section.
#[derive(Default)]
pub(crate) struct Texts {
    pub energies: Vec<String>,
    pub constants: Vec<String>,
    pub deflections: Vec<String>,
    pub forces: Vec<String>,
    pub motion: Vec<String>,
    pub jump: Vec<String>,
    pub cell: Vec<String>,
    pub latex: Vec<String>,
}

impl Texts {
    /// All plain lines.
    pub fn plain(&self) -> impl Iterator<Item = &String> {
        let equations = [&self.forces, &self.motion, &self.jump, &self.cell];
        [&self.energies, &self.constants, &self.deflections].into_iter().chain(equations).flatten()
    }
}

/// `a [torques] + b [jump terms]`: the sum, each group followed by the effects that it needs.
fn sum(groups: &[Group], style: Style) -> String {
    if groups.is_empty() {
        return "0".into();
    }
    let mut out = String::new();
    for (i, group) in groups.iter().enumerate() {
        let text = print(&group.sum, style);
        match (i, text.strip_prefix('-')) {
            (0, _) => out.push_str(&text),
            (_, Some(rest)) => out.push_str(&format!(" - {rest}")),
            (_, None) => out.push_str(&format!(" + {text}")),
        }
        if !group.effects.is_empty() {
            let names = group.effects.join(", ").replace('_', " ");
            match style {
                Style::Latex => out.push_str(&format!("\\ [\\text{{{}}}]", names)),
                _ => out.push_str(&format!(" [{names}]")),
            }
        }
    }
    out
}

/// The texts of a derivation.
pub(crate) fn write(d: &Derivation) -> Texts {
    let (m, motion) = (d.model, &d.motion);
    let order = d.order();
    let whole = |a: &Atom, style| sum(&grouped(a, &order), style);
    let written = |pieces: &[crate::Expr], style| {
        sum(&as_written(&pieces.iter().map(|p| p.atom()).collect::<Vec<_>>(), &order), style)
    };
    let mut t = Texts::default();

    for (name, pieces) in [("T", &m.kinetic), ("V", &m.potential), ("D", &m.dissipation)] {
        t.energies.push(format!("{name} = {}", written(pieces, Style::Plain)));
        t.latex.push(format!("{name} = {}", written(pieces, Style::Latex)));
    }
    for (c, q) in m.coordinates.iter().zip(&motion.external) {
        t.energies.push(format!("Q_{} = {}", c.name, whole(q, Style::Plain)));
        t.latex.push(format!("Q_{{{}}} = {}", latex_name(&c.name), whole(q, Style::Latex)));
    }
    for (name, value) in &motion.constants {
        let value = Tree::new(value);
        t.constants.push(format!("{name} = {}", print(&value, Style::Plain)));
        t.latex.push(format!("{} = {}", latex_name(name), print(&value, Style::Latex)));
    }
    for d in &m.deflections {
        let value = Tree::new(&d.value.atom());
        t.deflections.push(format!("{} = {}", d.name, print(&value, Style::Plain)));
        t.latex.push(format!("{} = {}", latex_name(&d.name), print(&value, Style::Latex)));
    }
    t.deflections.extend(m.laws.iter().filter_map(idle_text));
    t.deflections.extend(m.dead_bands.iter().flat_map(band_text));
    for force in &m.forces {
        let value = Tree::new(&force.value.atom());
        let with = force.with.as_ref().map_or(String::new(), |effect| format!(" [{}]", effect.replace('_', " ")));
        t.forces.push(format!("{} = {}{with}", force.name, print(&value, Style::Plain)));
        t.latex.push(format!("{} = {}", latex_name(&force.name), print(&value, Style::Latex)));
    }
    for i in 0..m.coordinates.len() {
        let left = |j: usize, style| match style {
            Style::Latex => format!("\\ddot{{{}}}", latex_name(&m.coordinates[j].name)),
            _ => format!("{}''", m.coordinates[j].name),
        };
        for style in [Style::Plain, Style::Latex] {
            let line = match &motion.acceleration {
                Some(a) => format!("{} = {}", left(i, style), whole(&a[i], style)),
                None => {
                    let inertia: Vec<String> = (0..m.coordinates.len())
                        .filter(|&j| !motion.mass[i][j].is_zero())
                        .map(|j| format!("({}) {}", whole(&motion.mass[i][j], style), left(j, style)))
                        .collect();
                    format!("{} = {}", inertia.join(" + "), whole(&motion.force[i], style))
                }
            };
            if style == Style::Latex { t.latex.push(line) } else { t.motion.push(line) }
        }
    }
    jumps(d, &mut t);
    match &d.cell {
        Ok(cell) => {
            t.cell.push("M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly".into());
            t.cell.extend(cell.nonlinear_with.iter().map(|(effect, c)| format!("nonlinear with {effect}: {c}")));
        }
        Err(culprits) => t.cell.extend(culprits.iter().map(|c| format!("nonlinear: {c}"))),
    }
    t
}

/// The value of a law in scenes without its effect.
fn idle_text(law: &Law) -> Option<String> {
    let (name, without) = (&law.name, law.with.as_ref()?.replace('_', " "));
    let rates = match law.role {
        Role::Error => format!("; the rates of deflections do not contain that of {name}"),
        _ => String::new(),
    };
    Some(format!("{name} = 0 without {without}{rates}"))
}

/// The values of the symbols of a dead band in each of its cells.
fn band_text(band: &DeadBand) -> [String; 4] {
    let DeadBand { touch, edge, damp, clip, effect, .. } = band;
    let half = print(&Tree::new(&band.half.atom()), Style::Plain);
    let side = format!("{half} or -{half}");
    let without = effect.replace('_', " ");
    [
        format!(
            "{touch} = 1 in contact, beyond {edge} = {side}; {touch} = 0 between the edges; \
             without {without} {touch} = 1 and {edge} = 0"
        ),
        format!(
            "{damp} = 1 and {clip} = 0 in contact while the damper force is less than the spring force, else {damp} = 0:"
        ),
        format!("  {clip} = 1 if the damper would push more than the spring: its force is limited to the spring force"),
        format!("  {clip} = -1 if the damper would pull more than the spring pushes: the contact force is zero"),
    ]
}

/// The jump rule of every law: in the speeds of the coordinates if M was inverted, else in the normal speed v.
fn jumps(d: &Derivation, t: &mut Texts) {
    let order = d.order();
    for (law, jump) in d.model.laws.iter().zip(&d.jumps) {
        if matches!(law.role, Role::Friction(_)) {
            t.jump.push(format!("at a step of {}: dV = 0, the speeds do not change", law.name));
            continue;
        }
        let phase = print(&Tree::new(&law.phase.atom()), Style::Plain);
        let (Some(g), Some(direction)) = (&jump.compliance, &jump.direction) else {
            t.jump.push(format!(
                "at a step d{} of {} in {phase}: v+^2 = v-^2 - 2*G*({})",
                law.name,
                law.name,
                sum(&grouped(&jump.step, &order), Style::Plain)
            ));
            continue;
        };
        let lost = (number(2) * g * &jump.step).expand();
        let slope = symbol_text(Kind::Slope, &format!("d{}", law.name), Style::Plain);
        let speed = speed_name(&phase);
        let step = format!("\\Delta {}", latex_name(&law.name));
        t.jump.push(format!("at a step {slope} of {} in {phase}, transmission if {speed}+^2 >= 0:", law.name));
        let whole = |text: String| if markers::terms(&lost).len() > 1 { format!("({text})") } else { text };
        t.jump.push(format!("{speed}+^2 = {speed}-^2 - {}", whole(sum(&grouped(&lost, &order), Style::Plain))));
        let tex = |a: &Atom| {
            sum(&grouped(a, &order), Style::Latex).replace(&symbol_text(Kind::Slope, &slope, Style::Latex), &step)
        };
        let dot = |name: &str, side: char| format!("\\dot{{{}}}_{side}", latex_name(name));
        t.latex.push(format!("{}^2 = {}^2 - {}", dot(&phase, '+'), dot(&phase, '-'), whole(tex(&lost))));
        for (c, part) in d.model.coordinates.iter().zip(direction) {
            if c.name == phase || part.is_zero() {
                continue;
            }
            let other = speed_name(&c.name);
            t.jump.push(format!(
                "{other}+ - {other}- = ({})*({speed}+ - {speed}-)",
                sum(&grouped(part, &order), Style::Plain)
            ));
            t.latex.push(format!(
                "{} - {} = {} \\left({} - {}\\right)",
                dot(&c.name, '+'),
                dot(&c.name, '-'),
                tex(part),
                dot(&phase, '+'),
                dot(&phase, '-')
            ));
        }
        let stays = if law.with.is_some() { &law.name } else { "the stiffness" };
        t.jump.push(format!("else reflection: {speed}+ = -{speed}-, and {stays} does not step"));
    }
}
