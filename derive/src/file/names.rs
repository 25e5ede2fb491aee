//! The names in which the equations are written: constants, deflections, forces, and the symbols of dead bands.

use super::block::Block;
use crate::derivation::Derivation;
use crate::model::DeadBand;
use crate::print::{Style, print};
use crate::tree::Tree;

/// Writes the blocks `constants`, `deflections`, `forces`, `partials` and `dead_bands`, those that are not empty.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let (m, constants) = (d.model, &d.motion.constants);
    if !constants.is_empty() {
        b.braces(1, "constants", |b| {
            for (name, value) in constants {
                b.line(2, &format!("{name} = {};", print(&Tree::new(value), Style::Rust)));
            }
        });
    }
    if !m.deflections.is_empty() {
        b.braces(1, "deflections", |b| {
            for deflection in &m.deflections {
                let value = Tree::new(&deflection.value.atom());
                b.line(2, &format!("{} = {};", deflection.name, print(&value, Style::Rust)));
            }
        });
    }
    if !m.forces.is_empty() {
        b.braces(1, "forces", |b| {
            for force in &m.forces {
                let condition = force.with.as_deref().unwrap_or("_");
                let value = print(&Tree::new(&force.value.atom()), Style::Rust);
                b.braces(2, &force.name, |b| b.line(3, &format!("{condition} => {value};")));
            }
        });
    }
    if !d.partials.is_empty() {
        b.braces(1, "partials", |b| {
            for (name, effect, value) in &d.partials {
                let condition = effect.as_deref().unwrap_or("_");
                let value = print(&Tree::new(value), Style::Rust);
                b.braces(2, name, |b| b.line(3, &format!("{condition} => {value};")));
            }
        });
    }
    if !m.dead_bands.is_empty() {
        b.braces(1, "dead_bands", |b| m.dead_bands.iter().for_each(|band| dead_band(b, band)));
    }
}

fn dead_band(b: &mut Block, band: &DeadBand) {
    let DeadBand { over, touch, edge, damp, clip, unit, half, effect, doc } = band;
    let half = print(&Tree::new(&half.atom()), Style::Rust);
    let symbols = format!("{touch}, {edge}, {damp}, {clip}");
    b.line(2, &format!("{over} {unit:?} ({symbols}) half {half} with {effect}, {doc:?};"));
}
