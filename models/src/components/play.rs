//! Backlash: a deflection causes a force only while flanks are in contact, in the effect `backlash`.
//!
//! Contact never pulls. At the depth x >= 0 beyond an edge the spring has the force F_s = dV/dx and the damper would have F_d =
//! dD/dx'. The damper is limited to plus or minus the spring's force, as in
//! Modelica.Mechanics.Rotational.Components.ElastoBacklash2: each mode is then a linear cell.
//!
//! | mode | while | force of the contact |
//! | --- | --- | --- |
//! | upper, lower | -F_s <= F_d <= F_s | F_s + F_d |
//! | upper_hit, lower_hit | F_d > F_s | 2 F_s |
//! | upper_loose, lower_loose | F_d < -F_s | 0 |
//! | free | within the play | 0 |

use gearsim_derive::{Describing, Expr, Model, Range, half};

use super::{Flanks, named, observed};

/// The symbols of a play.
#[derive(Clone, Copy)]
pub struct Play {
    /// The deflection minus the edge that is in contact: positive beyond the upper edge, negative beyond the lower one.
    pub over: Expr,
    /// 1 in contact, 0 inside the band.
    pub touch: Expr,
    /// 1 while the damper of the contact acts, 0 while its force is clipped and inside the band.
    pub damp: Expr,
    /// 1 while the force of the damper is clipped at the force F_s of the spring, -1 while it is clipped at -F_s, else 0.
    pub clip: Expr,
    /// 1 while the drive flanks are in contact, -1 while the coast flanks are, else 0; `None` if both have the same deflection.
    pub flank: Option<Expr>,
}

/// Play of the deflection `delta` [unit], which is linear in the coordinates: free between -b/2 and b/2. Declares its size `b`
/// [unit], which scenes with the effect must give. Write V as `k * gap.touch * gap.over.sq()`, and the dissipation function of a
/// damper in the contact as `gap.damp * gap.over.dot().sq()`. Declares the names `over`, `touch`, `edge`, `damp` and `clip`, each
/// followed by `part`.
pub fn play(m: &mut Model, part: &str, what: &str, unit: &str, delta: Expr) -> Play {
    play_of(m, part, what, unit, Flanks::alike(delta))
}

/// The play of a mesh whose centres move, as a length \[m\]; otherwise as [`play`]. Each flank has its own line of action. The play grows with
/// the distance of the centres. Also declares the names `flank`, `drive`, `coast` and `opening`. If no play is left, one flank at a time bears the load.
pub fn play_in_plane(m: &mut Model, part: &str, what: &str, flanks: Flanks) -> Play {
    play_of(m, part, what, "m", flanks)
}

fn play_of(m: &mut Model, part: &str, what: &str, unit: &str, flanks: Flanks) -> Play {
    let mut size = Expr::from(0);
    let doc = "play between the flanks: contact on the drive or coast flank, free motion between";
    let effect = m.part_effect("backlash", part, doc, |m| {
        let doc = format!("backlash of the {what}: no contact within b/2 to either side");
        size = m.parameter(&named("b", part), unit, None, Range::Positive, &doc);
    });
    let gap = band(m, part, unit, flanks, half(size), [&effect, &format!("play of the {what}")]);
    // 1 in contact, 0 within the play. Also 0 while the damper cancels the spring's force (`loose`, clip = -1).
    let clip = gap.clip;
    let pressed = gap.touch * (1 + half(clip * (1 - clip)));
    // Some descriptions state units after a comma: they are left out.
    let short = what.split(',').next().unwrap_or(what);
    let doc = format!("1 while no force passes the {short}, else 0: its mean is the share of time without contact");
    m.output_with(&effect, &observed::of_part("contact_loss", part), "1", 1 - pressed, &doc);
    gap
}

/// A dead band of the deflection `delta` [unit], in an effect: there is no force while it is between `-edge` and `edge` [unit].
pub fn dead_band(m: &mut Model, part: &str, unit: &str, delta: Expr, edge: Expr, effect: &str, doc: &str) -> Play {
    band(m, part, unit, Flanks::alike(delta), edge, [effect, doc])
}

fn band(m: &mut Model, part: &str, unit: &str, flanks: Flanks, edge: Expr, [effect, doc]: [&str; 2]) -> Play {
    let name = |what: &str| format!("{what}{part}");
    let Flanks { mean, open } = flanks;
    // The deflections of both flanks without play. Contact begins where they reach the edges.
    let sides = open.map(|open| {
        [("drive", mean - open), ("coast", mean + open), ("opening", open)].map(|(of, x)| m.deflection(&name(of), x))
    });
    let mut gap = m.switch(&name("over"), unit, mean, effect, doc);
    let touch = gap.factor(&name("touch"), 1);
    gap.offset(&name("edge"));
    let damp = gap.factor(&name("damp"), 1);
    let clip = gap.factor(&name("clip"), 0);
    gap.damped(&name("touch"), &name("damp"));
    // The flanks in contact decide the line of action: 1 drive, -1 coast, 0 none. Without play the drive flanks are in contact.
    let flank = open.map(|open| {
        let flank = gap.factor(&name("flank"), 1);
        gap.bend(flank * open);
        flank
    });
    let (over, spring, damper) = (gap.over(), gap.spring(), gap.damper());

    let [zero, one] = [0, 1].map(Expr::from);
    let contacts = [("upper", one, "lower"), ("lower", -one, "upper")];
    let [drive, coast, _] = sides.unwrap_or([over; 3]);
    // If the centres come so close that no play is left, both flanks are pressed. Only the flank that is pressed deeper then bears the
    // load. The load passes to the other flank where both are pressed equally deep, so V is the same on both sides.
    let or_wedged = |contact: Describing<'_>, side: Expr, other: &str| {
        if let Some([.., opening]) = sides {
            contact.until(other, side * over + opening + edge);
        }
    };
    let values = |of: [Expr; 4], value: Expr| of.into_iter().chain(flank.map(|_| value)).collect::<Vec<_>>();
    for (mode, side, other) in contacts {
        let contact = gap.mode(mode, &values([one, side * edge, one, zero], side)).rests().counts("flanks met");
        let contact = contact.unless("free", side * over).until(&format!("{mode}_loose"), side * (spring + damper));
        or_wedged(contact.until(&format!("{mode}_hit"), side * (spring - damper)), side, other);
    }
    gap.mode("free", &values([zero; 4], zero)).rests().until("upper", edge - drive).until("lower", edge + coast);
    for (mode, side, other) in contacts {
        let hit = gap.mode(&format!("{mode}_hit"), &values([one, side * edge, zero, one], side)).counts("flanks met");
        or_wedged(hit.unless("free", side * over).until(mode, side * (damper - spring)), side, other);
    }
    for (mode, side, other) in contacts {
        let loose = gap.mode(&format!("{mode}_loose"), &values([one, side * edge, zero, -one], side));
        let loose = loose.counts("flanks met").until("free", side * over);
        or_wedged(loose.until(mode, -side * (spring + damper)), side, other);
    }
    gap.loss(clip * spring);
    Play { over, touch, damp, clip, flank }
}
