//! A pair of involute gears, spur or helical, and its path of contact in the transverse plane.
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
use crate::tolerance::scene::OVERLAP;

/// Data of two gears, as on a drawing. The first gear drives.
#[derive(Debug, Clone, PartialEq)]
pub struct Gears {
    /// Numbers of teeth.
    pub teeth: [f64; 2],
    /// Whether the second gear is a ring with internal teeth.
    pub internal: bool,
    /// Normal module \[m\].
    pub module: f64,
    /// Pressure angle of the basic rack, in the normal section \[rad\].
    pub pressure_angle: f64,
    /// Helix angle at the reference cylinder, 0 of spur gears \[rad\].
    pub helix_angle: f64,
    /// Addendum \[modules\], without the profile shift.
    pub addendum: [f64; 2],
    /// Dedendum \[modules\], without the profile shift.
    pub dedendum: [f64; 2],
    /// Tip radius of the basic rack, which cuts the fillet \[modules\].
    pub fillet: f64,
    /// Profile shift \[modules\].
    pub profile_shift: [f64; 2],
    /// Centre distance \[m\]; `None`: the distance without backlash.
    pub centre_distance: Option<f64>,
    /// Face width \[m\].
    pub face_width: f64,
    /// Material of each gear.
    pub material: [Material; 2],
    /// Radius of the bore \[m\]; `None`: not known.
    pub bore: [Option<f64>; 2],
}

/// An elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E \[Pa\].
    pub young: f64,
    /// Poisson's ratio nu.
    pub poisson: f64,
}

impl Material {
    /// Steel, with the values of ISO 6336-1.
    pub const STEEL: Material = Material { young: 206e9, poisson: 0.3 };
}

/// Why gears do not mesh, or are outside the range of a method; and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what}; {advice}")]
pub struct GearError {
    /// What is wrong, with the numbers.
    pub what: String,
    /// What to do about it.
    pub advice: String,
}

impl GearError {
    pub(super) fn new(what: impl Into<String>, advice: impl Into<String>) -> GearError {
        GearError { what: what.into(), advice: advice.into() }
    }
}

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
    /// Overlap ratio; 0 of spur gears.
    pub overlap: f64,
    /// Length of the path of contact before the pitch point \[m\].
    pub approach: f64,
    /// Length of the path of contact after the pitch point \[m\].
    pub recess: f64,
}

impl Gears {
    /// Two standard external gears of steel: addendum 1, dedendum 1.25, fillet 0.38 (ISO 53, profile A).
    pub fn standard(teeth: [f64; 2], module: f64, pressure_angle: f64, face_width: f64) -> Gears {
        Gears {
            teeth,
            internal: false,
            module,
            pressure_angle,
            helix_angle: 0.0,
            addendum: [1.0; 2],
            dedendum: [1.25; 2],
            fillet: 0.38,
            profile_shift: [0.0; 2],
            centre_distance: None,
            face_width,
            material: [Material::STEEL; 2],
            bore: [None; 2],
        }
    }

    /// Transverse module \[m\] and transverse pressure angle \[rad\].
    pub fn transverse(&self) -> (f64, f64) {
        let cos = self.helix_angle.cos();
        (self.module / cos, (self.pressure_angle.tan() / cos).atan())
    }

    /// The spur gears whose section is the transverse section of these: the same circles and path of contact, heights in transverse modules.
    pub fn transverse_section(&self) -> Gears {
        let ((module, pressure_angle), cos) = (self.transverse(), self.helix_angle.cos());
        Gears {
            module,
            pressure_angle,
            helix_angle: 0.0,
            addendum: self.addendum.map(|x| x * cos),
            dedendum: self.dedendum.map(|x| x * cos),
            fillet: self.fillet * cos,
            profile_shift: self.profile_shift.map(|x| x * cos),
            ..self.clone()
        }
    }

    /// Base helix angle \[rad\]: tan(beta_b) = tan(beta) cos(alpha_t).
    pub fn base_helix_angle(&self) -> f64 {
        let (_, angle) = self.transverse();
        (self.helix_angle.tan() * angle.cos()).atan()
    }

    /// Base radius per tooth, m_t cos(alpha_t)/2 \[m\]: the length along the line of action per radian of the pitch angle, over the teeth.
    pub fn base_radius_per_tooth(&self) -> f64 {
        let (module, angle) = self.transverse();
        module * angle.cos() / 2.0
    }

    /// The contact of the gears.
    ///
    /// # Errors
    /// If the gears do not mesh, touch outside their involutes, or have a contact ratio of at most 1.
    pub fn contact(&self) -> Result<Contact, GearError> {
        let ([z1, z2], m, alpha) = (self.teeth, self.module, self.pressure_angle);
        let sign = if self.internal { -1.0 } else { 1.0 };
        if self.internal && z2 <= z1 {
            let what = format!("a ring of {z2} teeth has no room for a gear of {z1}");
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
                    let what =
                        format!("with the profile shifts {:?} the gears have no pressure angle", self.profile_shift);
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
        let tangent = base.map(|r| r * angle.tan());
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
        self.check(&contact, tangent)?;
        Ok(contact)
    }

    /// Checks that all contact is on involutes, that tips and roots do not overlap, and that the contact ratio is greater than 1.
    fn check(&self, contact: &Contact, tangent: [f64; 2]) -> Result<(), GearError> {
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

    /// The smallest number of pairs in contact, and the fraction of a pitch in which one more is in contact.
    pub fn pairs(&self) -> (usize, f64) {
        let ratio = self.ratio();
        (ratio.floor() as usize, ratio.fract())
    }

    /// Radii on both gears \[m\] at which a pair of external teeth touches, at the distance `x` \[m\] beyond the pitch point.
    pub fn radii(&self, x: f64) -> [f64; 2] {
        let tangent = self.base.map(|r| r * self.angle.tan());
        [(self.base[0], tangent[0] + x), (self.base[1], tangent[1] - x)].map(|(b, t)| b.hypot(t))
    }
}

/// Example 1 of ISO/TR 6336-30 (2017): 17 and 103 teeth, basic rack D of ISO 53, helix angle 15.8 deg.
#[cfg(test)]
pub(super) fn iso_6336_30() -> Gears {
    Gears {
        helix_angle: 15.8f64.to_radians(),
        dedendum: [1.4; 2],
        fillet: 0.39,
        profile_shift: [0.145, 0.0],
        centre_distance: Some(0.5),
        ..Gears::standard([17.0, 103.0], 8e-3, 20f64.to_radians(), 0.1)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn standard(z1: f64, z2: f64) -> Gears {
        Gears::standard([z1, z2], 6.35e-3, 20f64.to_radians(), 7e-3)
    }

    /// The gears of Oh, Grosh & Barber (2005), computed independently: contact ratio 1.72491, one pair over 1.728 rad, two over 4.555 rad.
    #[test]
    fn contact_ratio_of_the_gears_of_oh_2005() {
        let contact = standard(24.0, 96.0).contact().unwrap();
        assert!((contact.ratio() - 1.724_91).abs() < 5e-6, "{}", contact.ratio());
        let (pairs, more) = contact.pairs();
        assert_eq!(pairs, 1);
        assert!(((1.0 - more) * TAU - 1.728).abs() < 5e-4 && (more * TAU - 4.555).abs() < 5e-4);
        assert!((contact.reference[0] - 76.2e-3).abs() < 1e-12 && (contact.centre_distance - 0.381).abs() < 1e-12);
    }

    /// If the gears are exchanged, approach and recess are exchanged. Contact begins at the tip of gear 2 and ends at the tip of gear 1.
    #[test]
    fn the_contact_is_symmetric_in_the_gears() {
        let (one, two) = (standard(24.0, 96.0).contact().unwrap(), standard(96.0, 24.0).contact().unwrap());
        assert!((one.ratio() - two.ratio()).abs() < 1e-14 && (one.approach - two.recess).abs() < 1e-15);
        let (begin, end) = (one.radii(-one.approach), one.radii(one.recess));
        assert!((begin[1] - one.tip[1]).abs() < 1e-15 && (end[0] - one.tip[0]).abs() < 1e-15);
        let pitch = one.radii(0.0);
        assert!((pitch[0] - one.reference[0]).abs() < 1e-15 && (pitch[1] - one.reference[1]).abs() < 1e-15);
    }

    /// Profile shifts with the sum 0 do not change the pressure angle. With another sum the gears still mesh without backlash: the tooth
    /// thicknesses at the working pitch circles add up to the pitch.
    #[test]
    fn shifted_gears_mesh_without_backlash() {
        let shifted = |x: [f64; 2]| Gears { profile_shift: x, ..standard(20.0, 40.0) };
        let zero = shifted([0.3, -0.3]).contact().unwrap();
        assert!((zero.angle - 20f64.to_radians()).abs() < 1e-12);
        let gears = Gears { addendum: [0.95; 2], ..shifted([0.5, 0.2]) };
        let contact = gears.contact().unwrap();
        let thickness = |i: usize| {
            let (z, x, alpha) = (gears.teeth[i], gears.profile_shift[i], gears.pressure_angle);
            let working = contact.base[i] / contact.angle.cos();
            let angle = (PI / 2.0 + 2.0 * x * alpha.tan()) / z + involute(alpha) - involute(contact.angle);
            (2.0 * working * angle, TAU * working / z)
        };
        let ((s1, pitch), (s2, same)) = (thickness(0), thickness(1));
        assert!((pitch - same).abs() < 1e-15 && (s1 + s2 - pitch).abs() < 1e-12, "{s1} {s2} {pitch}");
        // Given this centre distance explicitly, the pair is the same.
        let told = Gears { centre_distance: Some(contact.centre_distance), ..gears }.contact().unwrap();
        assert!((told.ratio() - contact.ratio()).abs() < 1e-9);
    }

    /// A ring with very many teeth is a rack, and so is an external gear: both have the same contact ratio with a planet.
    #[test]
    fn a_ring_with_many_teeth_is_a_rack() {
        let ring = |z2: f64| Gears { internal: true, addendum: [1.0, 0.8], ..standard(36.0, z2) };
        let external = |z2: f64| Gears { addendum: [1.0, 0.8], ..standard(36.0, z2) };
        let (inside, outside) = (ring(1e7).contact().unwrap().ratio(), external(1e7).contact().unwrap().ratio());
        assert!((inside - outside).abs() < 1e-4, "{inside} {outside}");
        let near = ring(99.0).contact().unwrap();
        assert!(near.ratio() > outside && near.tip[1] < near.reference[1] && near.root[1] > near.reference[1]);
        assert!((near.centre_distance - 6.35e-3 * 31.5).abs() < 1e-12);
        assert!(ring(30.0).contact().unwrap_err().what.contains("no room"));
    }

    /// Example 1 of ISO/TR 6336-30: 17 and 103 teeth, 8 mm, helix angle 15.8 deg, face width 100 mm, centre distance 500 mm. The transverse
    /// contact ratio follows from its c_gamma_alpha/c' = 17.46485/12.37047 = 0.75 eps_alpha + 0.25.
    #[test]
    fn contact_of_the_helical_gears_of_iso_6336_30() {
        let contact = iso_6336_30().contact().unwrap();
        assert!((contact.ratio() - 1.549_09).abs() < 2e-3, "{}", contact.ratio());
        assert!((contact.overlap - 100.0 * 15.8f64.to_radians().sin() / (8.0 * PI)).abs() < 1e-14);
        assert!((contact.reference[0] - 17.0 * 8e-3 / 15.8f64.to_radians().cos() / 2.0).abs() < 1e-15);
    }

    /// As the helix angle goes to zero, the gears become spur gears.
    #[test]
    fn a_small_helix_angle_changes_little() {
        let (spur, helical) = (standard(24.0, 96.0), Gears { helix_angle: 1e-6, ..standard(24.0, 96.0) });
        let (spur, helical) = (spur.contact().unwrap(), helical.contact().unwrap());
        assert!((spur.ratio() - helical.ratio()).abs() < 1e-11 && helical.overlap > 0.0 && spur.overlap == 0.0);
    }

    #[test]
    fn gears_that_do_not_mesh_are_refused() {
        let cases = [
            (standard(6.0, 96.0), "below its base circle"),
            (Gears { centre_distance: Some(0.3), ..standard(24.0, 96.0) }, "overlap"),
            (Gears { centre_distance: Some(0.392), ..standard(24.0, 96.0) }, "the contact ratio is"),
            (Gears { addendum: [1.1; 2], dedendum: [1.0; 2], ..standard(60.0, 96.0) }, "tips and roots overlap"),
            (Gears { profile_shift: [-3.0, -3.0], ..standard(24.0, 96.0) }, "no pressure angle"),
            (Gears { addendum: [-4.0, 1.0], ..standard(24.0, 96.0) }, "within its base circle"),
        ];
        for (gears, said) in cases {
            let error = gears.contact().expect_err(said);
            assert!(error.what.contains(said), "{error}");
        }
    }
}
