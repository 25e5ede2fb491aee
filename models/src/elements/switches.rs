//! Elements with modes: switches.

use gearsim_derive::Model;

use super::coordinate;
use crate::components;

/// Dry friction of a bearing or a brake.
pub fn dry_friction(m: &mut Model) {
    m.title("dry friction");
    m.source("an element of trains");
    let theta = coordinate(m, "theta", "rad", "rotation");
    components::dry_friction(m, "x", "bearing {}", ["rad", "N*m"], theta);
}

/// End stops of a rotor, or of a rotor relative to another one.
pub fn end_stop(m: &mut Model) {
    m.title("end stops");
    m.source("an element of trains");
    let theta = coordinate(m, "theta", "rad", "rotation of the first rotor relative to the second");
    components::end_stop(m, "x", "rotation {}", ["rad", "N*m"], theta);
}

/// An overrunning clutch.
pub fn clutch(m: &mut Model) {
    m.title("an overrunning clutch");
    m.source("an element of trains");
    let theta = coordinate(m, "theta", "rad", "rotation of the driving side relative to the driven one");
    components::overrunning_clutch(m, "x", "clutch {}", theta);
}
