//! The path of contact of a pair of involute gears in the transverse plane.
//!
//! With the helix angle beta at the reference cylinder, the transverse module m_t = m/cos(beta) and the transverse pressure angle
//! tan(alpha_t) = tan(alpha)/cos(beta), the base radii are r_b = m_t z cos(alpha_t)/2, the tip radii r_a = m_t z/2 + m (h_a + x) and the
//! base pitch p_b = pi m_t cos(alpha_t). The path of contact lies on the common tangent of the base circles, from the tip of the driven
//! gear to the tip of the driving gear. With the working pressure angle alpha_w, its lengths from the pitch point are
//!
//! ```text
//! approach   g_f = sqrt(r_a2² - r_b2²) - r_b2 tan(alpha_w)          of an internal gear: r_b2 tan(alpha_w) - sqrt(r_a2² - r_b2²)
//! recess     g_a = sqrt(r_a1² - r_b1²) - r_b1 tan(alpha_w)
//! contact ratio  eps_alpha = (g_f + g_a)/p_b
//! overlap ratio  eps_beta = b sin(beta)/(pi m)                      pitches by which the contact at one face is ahead of the other
//! ```
//!
//! If no centre distance is given, the gears mesh without backlash: inv(alpha_w) = inv(alpha_t) + 2 tan(alpha) (x_1 + x_2)/(z_1 + z_2).
//! For an internal gear, z_2 + z_1 and x_2 + x_1 become z_2 - z_1 and x_2 - x_1, with x_2 positive if the teeth are shifted outwards,
//! away from the centre of the ring. Source: ISO 21771-1:2024; G. Niemann, H. Winter, Maschinenelemente II.

use std::f64::consts::PI;

use super::involute::{inverse, involute};
use super::pair::{GearError, Gears};
use crate::tolerance::scene::OVERLAP;

/// Geometry of the contact of two gears.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Reference radii \[m\].
    pub reference: [f64; 2],
    /// Base radii \[m\].
    pub base: [f64; 2],
    /// Tip radii \[m\].
    pub tip: [f64; 2],
    /// Root radii \[m\].
    pub root: [f64; 2],
    /// Working pressure angle \[rad\].
    pub angle: f64,
    /// Centre distance \[m\].
    pub centre_distance: f64,
    /// Transverse pressure angle at the reference circle \[rad\].
    pub transverse_angle: f64,
    /// Base pitch, in the transverse plane \[m\].
    pub base_pitch: f64,
    /// Overlap ratio; 0 for spur gears.
    pub overlap: f64,
    /// Length of the path of contact before the pitch point \[m\].
    pub approach: f64,
    /// Length of the path of contact after the pitch point \[m\].
    pub recess: f64,
}

impl Gears {
    /// The contact of the gears.
    ///
    /// # Errors
    /// If the gears do not mesh, touch outside their involutes, or have a contact ratio of at most 1.
    pub fn contact(&self) -> Result<Contact, GearError> {
        let ([z1, z2], m, alpha) = (self.teeth, self.module, self.pressure_angle);
        let sign = if self.internal { -1.0 } else { 1.0 };
        if self.internal && z2 <= z1 {
            let what = format!("a ring of {z2} teeth is too small for a gear of {z1} teeth");
            return Err(GearError::new(what, "the second gear is the ring: give it more teeth"));
        }
        let (transverse_module, transverse_angle) = self.transverse();
        let reference = self.teeth.map(|z| transverse_module * z / 2.0);
        let base = reference.map(|r| r * transverse_angle.cos());
        let difference = base[1] + sign * base[0];
        let angle = match self.centre_distance {
            None => {
                let shift = self.profile_shift[1] + sign * self.profile_shift[0];
                let inv = involute(transverse_angle) + 2.0 * alpha.tan() * shift / (z2 + sign * z1);
                inverse(inv).ok_or_else(|| {
                    let what = format!(
                        "with the profile shifts {:?} the gears have no working pressure angle",
                        self.profile_shift
                    );
                    GearError::new(what, "increase their sum; with a ring, the second minus the first")
                })?
            }
            Some(a) if a > difference => (difference / a).acos(),
            Some(a) => {
                let what =
                    format!("the centre distance {a} m is not greater than {difference} m: the base circles overlap");
                return Err(GearError::new(what, "increase centre_distance, or leave it out"));
            }
        };
        let centre_distance = self.centre_distance.unwrap_or(difference / angle.cos());
        let outwards = [1.0, sign];
        let at = |i: usize, height: f64| reference[i] + m * (self.profile_shift[i] + outwards[i] * height);
        let tip = [at(0, self.addendum[0]), at(1, self.addendum[1])];
        let root = [at(0, -self.dedendum[0]), at(1, -self.dedendum[1])];
        let mut along = [0.0; 2];
        for i in 0..2 {
            if tip[i] <= base[i] {
                let what = format!("the tips of gear {} lie within its base circle, where there is no involute", i + 1);
                return Err(GearError::new(what, "change its addendum or its profile shift"));
            }
            along[i] = (tip[i] * tip[i] - base[i] * base[i]).sqrt();
        }
        let tangent = tangents(base, angle);
        let (approach, recess) = (sign * (along[1] - tangent[1]), along[0] - tangent[0]);
        let base_pitch = PI * transverse_module * transverse_angle.cos();
        let overlap = self.face_width * self.helix_angle.sin() / (PI * m);
        let contact = Contact {
            reference,
            base,
            tip,
            root,
            angle,
            centre_distance,
            transverse_angle,
            base_pitch,
            overlap,
            approach,
            recess,
        };
        self.check(&contact)?;
        Ok(contact)
    }

    /// Checks that all contact is on involutes, that tips and roots do not overlap, and that the contact ratio is greater than 1.
    fn check(&self, contact: &Contact) -> Result<(), GearError> {
        let tangent = tangents(contact.base, contact.angle);
        let advice = |gear: &str, other: &str| {
            format!("give {gear} more teeth or a positive profile shift, or {other} a smaller addendum")
        };
        if contact.approach > tangent[0] {
            let what = "the tips of gear 2 meet gear 1 below its base circle, where there is no involute";
            return Err(GearError::new(what, advice("gear 1", "gear 2")));
        }
        if !self.internal && contact.recess > tangent[1] {
            let what = "the tips of gear 1 meet gear 2 below its base circle, where there is no involute";
            return Err(GearError::new(what, advice("gear 2", "gear 1")));
        }
        // Overlap of the tip circle of one gear with the root circle of the other.
        let (a, tip, root) = (contact.centre_distance, contact.tip, contact.root);
        let overlap = match self.internal {
            true => (a + tip[0] - root[1]).max(a + root[0] - tip[1]),
            false => (tip[0] + root[1] - a).max(tip[1] + root[0] - a),
        };
        if overlap > OVERLAP * self.module {
            let what = format!("tips and roots overlap by {:.3} modules", overlap / self.module);
            return Err(GearError::new(
                what,
                "reduce the addendum, increase the dedendum, or increase the centre distance",
            ));
        }
        let ratio = contact.ratio();
        if ratio <= 1.0 {
            let what = format!(
                "the contact ratio is {ratio:.4}: a tooth pair loses contact before the next one makes contact"
            );
            return Err(GearError::new(what, "increase the addendum, use more teeth, or reduce the centre distance"));
        }
        Ok(())
    }
}

impl Contact {
    /// Transverse contact ratio: the mean number of tooth pairs in contact in a transverse plane.
    pub fn ratio(&self) -> f64 {
        (self.approach + self.recess) / self.base_pitch
    }

    /// The smallest number of pairs in contact, and the fraction of a pitch during which one more pair is in contact.
    pub fn pairs(&self) -> (usize, f64) {
        let ratio = self.ratio();
        (ratio.floor() as usize, ratio.fract())
    }

    /// Radii on both gears \[m\] at which a pair of external teeth touches, at the distance `x` \[m\] beyond the pitch point.
    pub fn radii(&self, x: f64) -> [f64; 2] {
        let tangent = tangents(self.base, self.angle);
        [(self.base[0], tangent[0] + x), (self.base[1], tangent[1] - x)].map(|(b, t)| b.hypot(t))
    }
}

/// Distances of the pitch point from the base circles of radii `base` \[m\], along the common tangent, at the working pressure angle
/// `angle` \[rad\].
fn tangents(base: [f64; 2], angle: f64) -> [f64; 2] {
    base.map(|r| r * angle.tan())
}

#[cfg(test)]
mod tests;
