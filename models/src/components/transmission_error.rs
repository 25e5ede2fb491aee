//! Transmission error: the deviation e of the unloaded flanks from their ideal position, in the effect `transmission_error`.

use gearsim_derive::{Expr, Model};

use super::steps::{STIFFNESS_STEP, steps};

/// Declares the law `name` of a transmission error e [unit of the deflection], of any sign and periodic with one `pitch` of `phase`, or with
/// several pitches if the scene says so; the scene gives its values. Subtract it from the deflection of the mesh, V = k (delta - e)^2/2.
/// It is zero in scenes without the effect of this `part`. It steps or varies continuously by the same rules as a stiffness.
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
