//! Stiffness of a tooth pair from its strain energy, at any point of the path of contact.
//!
//! A force F along the line of action acts on the tooth at the height y_c and half the thickness h_c, at the angle a to the
//! normal of the tooth's centre line. The tooth is a beam that begins at the root circle, with sections of thickness 2 h:
//!
//! ```text
//! bending   1/k = integral (cos(a) (y_c - y) - sin(a) h_c)²/(E I) dy,   I = 2 b h³/3
//! shear     1/k = integral 1.2 cos²(a)/(G A) dy,                        A = 2 b h,  G = E/(2 (1 + nu))
//! axial     1/k = integral sin²(a)/(E A) dy
//! contact   1/k = 2 ((1 - nu1²)/E1 + (1 - nu2²)/E2)/(pi b)
//! ```
//!
//! and the gear body ([`super::foundation`]). The compliances of a pair are in series, the pairs are in parallel. Sources: D. C. H. Yang,
//! J. Y. Lin, J. Mech. Trans. Autom. Des. 109(2), 1987 (bending, axial, contact), after C. Weber (1949); X. Tian, thesis,
//! University of Alberta, 2004 (shear); Sainsot et al. (2004). The outline is that of the cut tooth, including the fillet.
//!
//! Neglected: the coupling of neighbouring tooth pairs through the gear body, profile errors, contact outside the path of contact
//! due to deflection, variation along the face width (plane stress).

use std::f64::consts::PI;

use super::contact::Contact;
use super::foundation::Foundation;
use super::pair::{GearError, Gears};
use super::tooth::Tooth;
use crate::tolerance::scene::FILLET_CONTACT;

/// Bore radius relative to the root radius, if the bore is not given.
const BORE: f64 = 0.5;
/// Number of sections of the fillet, and of the flank. The relative error of the integrals is then about 1e-5.
const SECTIONS: usize = 200;
/// Shear correction factor of a rectangular section.
const SHEAR: f64 = 1.2;

/// A tooth pair, to compute its stiffness.
#[derive(Debug, Clone)]
pub struct ToothPair {
    /// Path of contact.
    pub contact: Contact,
    teeth: [(Tooth, Foundation); 2],
    gears: Gears,
}

impl ToothPair {
    /// The tooth pair of two external gears. For helical gears it is the tooth pair of spur gears with the same transverse section and the
    /// whole face width: a slice of the face, scaled to the face width.
    ///
    /// # Errors
    /// If the gears do not mesh, the second one is a ring, or teeth or gear bodies are outside the range of the formulas.
    pub fn of(gears: &Gears) -> Result<ToothPair, GearError> {
        if gears.internal {
            let what = "the method \"energy\" needs external teeth, and the second gear is a ring";
            return Err(GearError::new(what, "use the method \"iso6336\""));
        }
        let overlap = gears.contact()?.overlap;
        let gears = &gears.transverse_section();
        let contact = Contact { overlap, ..gears.contact()? };
        let begins = [contact.radii(-contact.approach)[0], contact.radii(contact.recess)[1]];
        let tooth = |i: usize| -> Result<_, GearError> {
            let tooth = Tooth::of(gears, &contact, i)?;
            // Contact on the fillet is accepted up to a thousandth of a module: `compliances` then uses the end of the flank.
            if begins[i] < tooth.form - FILLET_CONTACT * gears.module {
                let what = format!("contact on gear {} would extend into its fillet", i + 1);
                return Err(GearError::new(
                    what,
                    "reduce the addendum of the other gear, or increase the dedendum of this one",
                ));
            }
            let bore = gears.bore[i].unwrap_or(BORE * tooth.root);
            let foundation = Foundation::new(tooth.root, bore, tooth.foot(), &format!("gear {}", i + 1))?;
            Ok((tooth, foundation))
        };
        Ok(ToothPair { teeth: [tooth(0)?, tooth(1)?], contact, gears: gears.clone() })
    }

    /// Stiffness along the line of action [N/m] when the pair touches at the distance `x` [m] beyond the pitch point.
    pub fn stiffness(&self, x: f64) -> f64 {
        let radii = self.contact.radii(x);
        let teeth: f64 = (0..2).map(|i| self.compliances(i, radii[i]).iter().sum::<f64>()).sum();
        1.0 / (teeth + self.hertz())
    }

    /// Stiffness of all pairs in contact [N/m] when one of them is at the distance `x` [m] beyond the pitch point.
    #[cfg(test)]
    pub fn mesh(&self, x: f64) -> f64 {
        let (p, c) = (self.contact.base_pitch, &self.contact);
        let first = ((-c.approach - x) / p).ceil() as i64;
        let last = ((c.recess - x) / p).floor() as i64;
        (first..=last).map(|j| self.stiffness(x + j as f64 * p)).sum()
    }

    /// Compliances of gear `i` loaded at `radius` [m]: bending, shear, axial, gear body [m/N].
    fn compliances(&self, i: usize, radius: f64) -> [f64; 4] {
        let ((tooth, body), material) = (&self.teeth[i], self.gears.material[i]);
        let (e, b) = (material.young, self.gears.face_width);
        let radius = radius.max(tooth.form);
        let half = tooth.half_angle(radius);
        let angle = (tooth.base / radius).min(1.0).acos() - half;
        let (height, thickness) = (radius * half.cos(), radius * half.sin());
        let (sin, cos) = angle.sin_cos();
        let at = |(y, h): (f64, f64)| {
            let moment = cos * (height - y) - sin * thickness;
            [1.5 * moment * moment / (h * h * h), 1.0 / (2.0 * h)]
        };
        let mut integrals = [0.0; 2];
        let mut sections = tooth.sections(radius, SECTIONS);
        let mut last = sections.next().map(|s| (s.0, at(s)));
        for section in sections {
            let here = (section.0, at(section));
            if let Some((y, values)) = last {
                for j in 0..2 {
                    integrals[j] += (here.0 - y) * (here.1[j] + values[j]) / 2.0;
                }
            }
            last = Some(here);
        }
        let [bending, area] = integrals;
        let crossing = tooth.base / cos - tooth.root;
        let shear = SHEAR * 2.0 * (1.0 + material.poisson) * cos * cos * area;
        [bending, shear, sin * sin * area, body.compliance(angle, crossing)].map(|c| c / (e * b))
    }

    /// Compliance of the Hertzian contact [m/N].
    fn hertz(&self) -> f64 {
        let plane: f64 = self.gears.material.iter().map(|m| (1.0 - m.poisson * m.poisson) / m.young).sum();
        2.0 * plane / (PI * self.gears.face_width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Iso6336, Material};

    fn gears(z1: f64, z2: f64) -> Gears {
        Gears::standard([z1, z2], 6.35e-3, 20f64.to_radians(), 7e-3)
    }

    fn near(a: f64, b: f64, relative: f64) {
        assert!((a / b - 1.0).abs() < relative, "{a} is not {b}");
    }

    /// The stiffness does not change if the gears are exchanged. It is proportional to face width and Young's modulus, and independent of
    /// the module.
    #[test]
    fn the_stiffness_is_symmetric_and_scales() {
        let pair = ToothPair::of(&gears(24.0, 96.0)).unwrap();
        let mirrored = ToothPair::of(&gears(96.0, 24.0)).unwrap();
        let soft = Material { young: 103e9, ..Material::STEEL };
        let larger = Gears { module: 12.7e-3, face_width: 14e-3, material: [soft; 2], ..gears(24.0, 96.0) };
        let larger = ToothPair::of(&larger).unwrap();
        for part in [-0.8, -0.3, 0.0, 0.5, 0.9] {
            let x = part * if part < 0.0 { pair.contact.approach } else { pair.contact.recess };
            near(pair.stiffness(x), mirrored.stiffness(-x), 1e-12);
            near(pair.stiffness(x), larger.stiffness(2.0 * x), 1e-12);
        }
    }

    /// At the end of contact of a pair, the mesh stiffness steps by the stiffness of this pair. It is periodic with the base pitch.
    #[test]
    fn the_mesh_is_the_sum_of_its_pairs() {
        let pair = ToothPair::of(&gears(24.0, 96.0)).unwrap();
        let c = &pair.contact;
        let (before, after) = (pair.mesh(c.recess - 1e-9), pair.mesh(c.recess + 1e-9));
        near(before - after, pair.stiffness(c.recess), 1e-6);
        near(pair.mesh(1e-3), pair.mesh(1e-3 - 3.0 * c.base_pitch), 1e-12);
        near(pair.mesh(0.0), pair.stiffness(0.0), 1e-15);
    }

    /// Eight times as many sections change the integral of 1/h by less than 1e-5 of it.
    #[test]
    fn the_integrals_converge() {
        let pair = ToothPair::of(&gears(24.0, 96.0)).unwrap();
        let tooth = &pair.teeth[0].0;
        let radius = pair.contact.tip[0];
        let area = |n: usize| {
            let s: Vec<_> = tooth.sections(radius, n).collect();
            s.windows(2).map(|s| (s[1].0 - s[0].0) * (0.5 / s[0].1 + 0.5 / s[1].1) / 2.0).sum::<f64>()
        };
        near(area(SECTIONS), area(8 * SECTIONS), 1e-5);
    }

    /// Greatest stiffness of a pair and mean stiffness of the mesh agree within 20 % with ISO 6336-1, which was fitted to measurements.
    #[test]
    fn the_stiffness_agrees_with_iso_6336() {
        for (z1, z2) in [(24.0, 96.0), (30.0, 30.0), (40.0, 60.0), (18.0, 50.0)] {
            let gears = gears(z1, z2);
            let (pair, iso) = (ToothPair::of(&gears).unwrap(), Iso6336::of(&gears, None).unwrap());
            let (c, n) = (&pair.contact, 400);
            let at = |i: usize| -c.approach + (c.approach + c.recess) * (i as f64 + 0.5) / n as f64;
            let greatest = (0..n).map(|i| pair.stiffness(at(i))).fold(0.0, f64::max) / gears.face_width;
            let mean = (0..n).map(|i| pair.mesh(c.base_pitch * i as f64 / n as f64)).sum::<f64>()
                / n as f64
                / gears.face_width;
            near(greatest, iso.single, 0.2);
            near(mean, iso.mean, 0.2);
        }
    }

    #[test]
    fn gears_outside_the_range_are_refused() {
        let cases = [
            (Gears { internal: true, ..gears(24.0, 96.0) }, "a ring"),
            (Gears { addendum: [1.0, 0.6], ..gears(14.0, 96.0) }, "undercut"),
            (Gears { bore: [Some(60e-3), None], ..gears(24.0, 96.0) }, "1.138 times"),
            (Gears { fillet: 0.9, ..gears(24.0, 96.0) }, "cannot cut gear 1"),
        ];
        for (gears, said) in cases {
            let error = ToothPair::of(&gears).expect_err(said);
            assert!(error.what.contains(said), "{error}");
        }
    }
}
