//! Backlash: a deflection that is felt only where flanks are in contact, in the effect `backlash`.

use gearsim_derive::{Expr, Model, Play, Range, half};

use super::named;

/// Play of what is deflected by `delta` [unit], linear in the coordinates, half of it to either side. Declares its
/// size `b`, which scenes with the effect must give. See [`Model::dead_band`] for how V and D are then written.
pub fn play(m: &mut Model, part: &str, what: &str, unit: &str, delta: Expr) -> Play {
    let mut size = Expr::from(0);
    m.effect("backlash", "flanks with play: drive and coast flank, and free flight between", |m| {
        let doc = format!("backlash of the {what}: it is free within b/2 to either side");
        size = m.parameter(&named("b", part), unit, None, Range::Positive, &doc);
    });
    m.dead_band(part, unit, delta, half(size), "backlash", &format!("play of the {what}"))
}
