//! The jump rule of every law: in the speeds of the coordinates if M was inverted, else in the normal speed v.

use symbolica::atom::AtomCore;

use super::Writer;
use crate::derivation::Derivation;
use crate::expr::{Kind, number, speed_name};
use crate::jump::Jump;
use crate::markers::terms;
use crate::model::{Law, Role};
use crate::print::{Style, latex_name, print, symbol_text};
use crate::tree::Tree;

pub(super) fn write(d: &Derivation, w: &Writer) -> Vec<String> {
    let mut lines = vec![];
    for (law, jump) in d.model.laws.iter().zip(&d.jumps) {
        let phase = print(&Tree::new(&law.phase.atom()), Style::Plain);
        let name = &law.name;
        if matches!(law.role, Role::Factor(_)) {
            lines.extend(w.plain().then(|| format!("at a step of {name}: dV = 0, the speeds do not change")));
        } else if jump.direction.is_some() {
            lines.extend(in_speeds(d, w, law, jump, &phase));
        } else if w.plain() {
            lines.push(format!("at a step d{name} of {name} in {phase}: v+^2 = v-^2 - 2*G*({})", w.line(&jump.step)));
        }
    }
    if lines.iter().any(|line| line.contains("v+^2")) && d.motion.mobility.is_none() {
        lines.push(
            "v is the speed of the phase, n its gradient, G = n.M⁻¹n, q'+ = q' + M⁻¹n/G*(v+ - v-); \
             if v+^2 < 0, reflection: v+ = -v-, and nothing steps"
                .into(),
        );
    }
    lines
}

/// The speed of the phase after the step, and then the other speeds.
fn in_speeds(d: &Derivation, w: &Writer, law: &Law, jump: &Jump, phase: &str) -> Vec<String> {
    let (Some(g), Some(direction)) = (&jump.compliance, &jump.direction) else { return vec![] };
    let lost = (number(2) * g * &jump.step).expand();
    let slope = symbol_text(Kind::Slope, &format!("d{}", law.name), w.style);
    // In LaTeX a slope is k', and a step is Delta k.
    let step = if w.plain() { slope.clone() } else { format!("\\Delta {}", latex_name(&law.name)) };
    let text = |e| w.line(e).replace(&slope, &step);
    let speed = |name: &str, side: char| match w.plain() {
        true => format!("{}{side}", speed_name(name)),
        false => format!("\\dot{{{}}}_{side}", latex_name(name)),
    };
    let change = |name: &str| format!("{} - {}", speed(name, '+'), speed(name, '-'));
    let sum = if terms(&lost).len() > 1 { format!("({})", text(&lost)) } else { text(&lost) };
    let mut lines = vec![format!("{}^2 = {}^2 - {sum}", speed(phase, '+'), speed(phase, '-'))];
    for (c, part) in d.model.coordinates.iter().zip(direction).filter(|(c, part)| c.name != phase && !part.is_zero()) {
        lines.push(match w.plain() {
            true => format!("{} = ({})*({})", change(&c.name), text(part), change(phase)),
            false => format!("{} = {} \\left({}\\right)", change(&c.name), text(part), change(phase)),
        });
    }
    if w.plain() {
        let stays = if law.with.is_some() { &law.name } else { "the stiffness" };
        let v = speed(phase, '+');
        lines.insert(0, format!("at a step {step} of {} in {phase}, transmission if {v}^2 >= 0:", law.name));
        lines.push(format!("else reflection: {v} = -{}, and {stays} does not step", speed(phase, '-')));
    }
    lines
}
