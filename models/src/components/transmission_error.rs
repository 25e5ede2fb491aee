//! Transmission error: the deviation e of the unloaded flanks from their ideal position, in the effect `transmission_error`.

use gearsim_derive::{Expr, Model};

use super::steps::{STIFFNESS_STEP, steps};

/// Declares the transmission error e of a mesh as the law `name` [unit of the deflection]. A scene gives its values, of any sign. Its period is
/// one `pitch` of `phase`; a scene may state several pitches. Subtract e from the deflection of the mesh: V = k (delta - e)^2/2. In scenes
/// without the effect `transmission_error` of this `part`, e is zero. The values may have steps or follow a curve, as those of a stiffness.
pub fn transmission_error(
    m: &mut Model,
    [name, part]: [&str; 2],
    unit: &str,
    phase: Expr,
    pitch: f64,
    what: &str,
) -> Expr {
    steps(m);
    let doc =
        "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
    let mut error = Expr::from(0);
    let effect = m.part_effect("transmission_error", part, doc, |m| {
        error = m.offset_law(name, unit, phase, pitch, what);
    });
    m.require(&effect, &[STIFFNESS_STEP]);
    error
}
