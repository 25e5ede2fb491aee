//! What names stand for: constants, deflections, forces, and the symbols that the engine sets.

use symbolica::atom::Atom;

use super::Writer;
use crate::derivation::Derivation;
use crate::model::{DeadBand, Law, Role};
use crate::print::{Style, print};
use crate::tree::Tree;

/// Constants, deflections and forces, and the symbols that the engine sets.
pub(super) fn write(d: &Derivation, w: &Writer) -> Vec<String> {
    let m = d.model;
    let is = |name: &str, value: &Atom| format!("{} = {}", w.name(name), w.print(value));
    let mut lines: Vec<String> = d.motion.constants.iter().map(|(name, value)| is(name, value)).collect();
    lines.extend(m.deflections.iter().map(|d| is(&d.name, &d.value.atom())));
    for force in &m.forces {
        let effect = force.with.as_ref().filter(|_| w.plain()).map(|effect| format!(" [{}]", effect.replace('_', " ")));
        lines.push(is(&force.name, &force.value.atom()) + effect.as_deref().unwrap_or_default());
    }
    if w.plain() {
        lines.extend(idle_texts(&m.laws));
        lines.extend(m.dead_bands.iter().flat_map(band_text));
    }
    lines
}

/// The values of laws in scenes without their effects, one line for each effect.
fn idle_texts(laws: &[Law]) -> Vec<String> {
    let of = |laws: &[Law]| {
        let names = laws.iter().map(|law| law.name.as_str()).collect::<Vec<_>>().join(", ");
        let without = laws[0].with.as_ref()?.replace('_', " ");
        let rates = match laws[0].role {
            Role::Error => "; the rates of deflections do not contain the rates of these errors",
            _ => "",
        };
        Some(format!("{names} = 0 without {without}{rates}"))
    };
    laws.chunk_by(|a, b| a.with == b.with).filter_map(of).collect()
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
