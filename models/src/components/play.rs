//! Backlash: a deflection causes a force only while flanks are in contact, in the effect `backlash`.

use gearsim_derive::{Expr, Model, Play, Range, half};

use super::named;

/// Play of the deflection `delta` [unit], which is linear in the coordinates: free between -b/2 and b/2. Declares its size `b`
/// [unit], which scenes with the effect must give. [`Model::dead_band`] says how V and D are written in the result.
pub fn play(m: &mut Model, part: &str, what: &str, unit: &str, delta: Expr) -> Play {
    let mut size = Expr::from(0);
    m.effect("backlash", "play between the flanks: contact on the drive or coast flank, free motion between", |m| {
        let doc = format!("backlash of the {what}: no contact within b/2 to either side");
        size = m.parameter(&named("b", part), unit, None, Range::Positive, &doc);
    });
    m.dead_band(part, unit, delta, half(size), "backlash", &format!("play of the {what}"))
}
