//! The outlines of the teeth of two gears, and where each lies when they touch: for drawings.
//!
//! A tooth is symmetric about its centre line. With the angles psi from it, its flank is
//!
//! ```text
//! psi(r) = (pi/2 + 2 x tan(alpha))/z + inv(alpha) - inv(alpha_r),    cos(alpha_r) = r_b/r
//! ```
//!
//! Below the flank is the fillet that the basic rack cuts. On helical gears and on teeth whose fillet is not known, e.g. undercut ones, a
//! straight radial line to the root circle replaces it. The spaces of a ring have the shape of the teeth of an external gear with the same
//! z and x. The outline of a ring is therefore that of one space, without fillets.
//!
//! The driving gear turns counterclockwise about the origin. The centre of the other gear is on the x axis. X is the distance of the
//! contact point of a pair from the pitch point, in the direction of motion along the line of action. At this contact, the centre lines of
//! the tooth of gear 1 and of the tooth of gear 2 (of a ring: the space) are at the angles
//!
//! ```text
//! c_1 = X/r_b1 - psi_1(r_w1),    c_2 = X/r_b2 + psi_2(r_w2)    of a ring: - psi_2(r_w2)
//! ```
//!
//! from the line through both centres. r_w are the working pitch radii. c_2 is positive in the direction in which the second gear turns.
//! This follows from psi + inv(alpha_r) = const along a flank. Source: ISO 21771-1:2024.

use std::f64::consts::PI;

use super::contact::Contact;
use super::involute::involute;
use super::pair::{GearError, Gears};
use super::tooth::Tooth;

/// Number of intervals of a flank, and of points of a fillet.
const FLANK: usize = 12;
const FILLET: usize = 6;

/// The outline of one gear.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Points of half a tooth, from root to tip; of a ring, of half a space, from the tips of the teeth outwards. Each point has a radius
    /// \[m\] and an angle from the centre line \[rad\].
    pub half: Vec<[f64; 2]>,
    /// Angle of the centre line from the line through both centres when the pair touches at the pitch point \[rad\].
    pub place: f64,
}

/// The outlines of two gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlines {
    /// The outlines of the driving and of the driven gear.
    pub gears: [Outline; 2],
    /// Their contact.
    pub contact: Contact,
    /// Backlash along the line of action at the centre distance of the gears \[m\].
    pub clearance: f64,
}

impl Outlines {
    /// The outlines of `gears`.
    ///
    /// # Errors
    /// If the gears do not mesh.
    pub fn of(gears: &Gears) -> Result<Outlines, GearError> {
        let contact = gears.contact()?;
        let working = contact.base.map(|base| base / contact.angle.cos());
        let at_pitch_point = [0, 1].map(|i| half_angle(gears, &contact, i, working[i]));
        let side = [-1.0, if gears.internal { -1.0 } else { 1.0 }];
        let outline = |i: usize| Outline { half: half(gears, &contact, i), place: side[i] * at_pitch_point[i] };
        // Angles of tooth and space at the working pitch circles. For a ring, the outline is that of the space.
        let space = match gears.internal {
            true => 2.0 * at_pitch_point[1],
            false => 2.0 * (PI / gears.teeth[1] - at_pitch_point[1]),
        };
        let clearance = (space * working[1] - 2.0 * at_pitch_point[0] * working[0]) * contact.angle.cos();
        Ok(Outlines { gears: [outline(0), outline(1)], contact, clearance })
    }
}

/// Half the angle of a tooth of gear `i`, or of a space of a ring, at the radius `r` of its flank \[rad\].
fn half_angle(gears: &Gears, contact: &Contact, i: usize, r: f64) -> f64 {
    let (z, x, alpha) = (gears.teeth[i], gears.profile_shift[i], gears.pressure_angle);
    let at_base = (PI / 2.0 + 2.0 * x * alpha.tan()) / z + involute(contact.transverse_angle);
    at_base - involute((contact.base[i] / r).min(1.0).acos())
}

fn half(gears: &Gears, contact: &Contact, i: usize) -> Vec<[f64; 2]> {
    let (base, tip, root) = (contact.base[i], contact.tip[i], contact.root[i]);
    let ring = gears.internal && i == 1;
    let mut points = vec![];
    // The fillet is computed for spur gears only.
    let tooth = (gears.helix_angle == 0.0).then(|| Tooth::of(gears, contact, i).ok()).flatten();
    let begin = match tooth {
        _ if ring => tip,
        Some(tooth) => {
            points.extend(tooth.fillet_points(FILLET).map(|(radius, angle)| [radius, angle]));
            tooth.form
        }
        None => {
            let begin = base.max(root);
            points.extend((root < begin).then(|| [root, half_angle(gears, contact, i, begin)]));
            begin
        }
    };
    // The points of the flank are evenly spaced in t, the length along the line of action: r² = r_b² + t².
    let [from, to] = [begin, if ring { root } else { tip }].map(|r| (r * r - base * base).max(0.0).sqrt());
    for k in 0..=FLANK {
        let radius = base.hypot(from + (to - from) * k as f64 / FLANK as f64);
        // Flanks that would cross beyond a pointed tip end on the centre line.
        points.push([radius, half_angle(gears, contact, i, radius).max(0.0)]);
    }
    points
}

#[cfg(test)]
mod tests;
