//! The outline of an external tooth cut by the basic rack: involute flank, trochoid fillet, root.
//!
//! The pitch line of the rack rolls on the reference circle. The tip of the rack is rounded by a circle of radius rho. Its centre is
//! b = (h_f - rho - x) m below the pitch line and e = m (pi/4 - h_f tan(alpha) - rho (1 - sin(alpha))/cos(alpha)) from the middle of
//! the rack's tooth. This circle touches the gear where its normal passes through the pitch point. With u the angle of that normal
//! from the radius, 0 <= u <= pi/2 - alpha, the point of the fillet is
//!
//! ```text
//! F = (b tan(u) + rho sin(u), r - b - rho cos(u)),   at the angle atan(F_x/F_y) - (b tan(u) - e)/r from the middle of the space
//! ```
//!
//! Source: ISO 6336-3:2019, clause 6 (the same fillet); F. L. Litvin, A. Fuentes, Gear Geometry and Applied Theory (2004).

use std::f64::consts::PI;

use super::contact::Contact;
use super::involute::involute;
use super::pair::{GearError, Gears};
use crate::tolerance::scene::UNDERCUT;

/// A tooth. Heights are measured along its centre line from the centre of the gear [m].
#[derive(Debug, Clone)]
pub(super) struct Tooth {
    /// Base radius [m].
    pub(super) base: f64,
    /// Root radius [m].
    pub(super) root: f64,
    /// Reference radius [m].
    reference: f64,
    /// Half the angular pitch, pi/z [rad].
    half_pitch: f64,
    /// Half angle of the tooth at its base circle [rad].
    at_base: f64,
    /// b, e and rho [m].
    cutter: [f64; 3],
    /// The parameter u at which fillet and flank meet [rad].
    join: f64,
    /// Radius at which fillet and flank meet [m].
    pub(super) form: f64,
}

impl Tooth {
    /// The tooth of gear `i`.
    ///
    /// # Errors
    /// If the rack undercuts the tooth, or has no room for its tip radius.
    pub(super) fn of(gears: &Gears, contact: &Contact, i: usize) -> Result<Tooth, GearError> {
        let (m, alpha, z) = (gears.module, gears.pressure_angle, gears.teeth[i]);
        let (x, dedendum, rho) = (gears.profile_shift[i], gears.dedendum[i], gears.fillet);
        let (sin, cos, tan) = (alpha.sin(), alpha.cos(), alpha.tan());
        let b = dedendum - rho - x;
        let e = PI / 4.0 - dedendum * tan - rho * (1.0 - sin) / cos;
        if b <= 0.0 || e < 0.0 {
            let what =
                format!("a rack of dedendum {dedendum} with a fillet of {rho} modules cannot cut gear {}", i + 1);
            return Err(GearError::new(what, "reduce the fillet or the profile shift"));
        }
        let straight = dedendum - rho * (1.0 - sin) - x;
        let undercut = straight - z * sin * sin / 2.0;
        if undercut > UNDERCUT {
            let what = format!("the teeth of gear {} are undercut by {undercut:.3} modules", i + 1);
            return Err(GearError::new(
                what,
                "give it more teeth or a positive profile shift, or use the method \"iso6336\"",
            ));
        }
        let at_base = (PI / 2.0 + 2.0 * x * tan) / z + involute(alpha);
        let (base, reference, root) = (contact.base[i], contact.reference[i], contact.root[i]);
        let cutter = [b * m, e * m, rho * m];
        let mut tooth =
            Tooth { base, root, reference, half_pitch: PI / z, at_base, cutter, join: PI / 2.0 - alpha, form: 0.0 };
        tooth.form = tooth.fillet(tooth.join).0;
        if undercut > 0.0 {
            // The end of the rack's flank sweeps below the base circle. The fillet then ends at the base circle.
            let (mut low, mut high) = (0.0, tooth.join);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                *(if tooth.fillet(middle).0 < base { &mut low } else { &mut high }) = middle;
            }
            (tooth.join, tooth.form) = (low, base);
        }
        Ok(tooth)
    }

    /// Half angle of the tooth at a radius of its flank [rad].
    pub(super) fn half_angle(&self, radius: f64) -> f64 {
        self.at_base - involute((self.base / radius).min(1.0).acos())
    }

    /// Radius [m] and half angle of the tooth [rad] at the point of the fillet with the parameter `u` [rad].
    pub(super) fn fillet(&self, u: f64) -> (f64, f64) {
        let [b, e, rho] = self.cutter;
        let (x, y) = (b * u.tan() + rho * u.sin(), self.reference - b - rho * u.cos());
        (x.hypot(y), self.half_pitch - (x.atan2(y) - (b * u.tan() - e) / self.reference))
    }

    /// Half angle of the tooth where its fillets meet the root circle [rad].
    pub(super) fn foot(&self) -> f64 {
        self.fillet(0.0).1
    }

    /// `n` points of the fillet, beginning at the root circle, without the point where the flank begins: radius [m] and half angle [rad].
    pub(super) fn fillet_points(&self, n: usize) -> impl Iterator<Item = (f64, f64)> + '_ {
        (0..n).map(move |i| self.fillet(self.join * i as f64 / n as f64))
    }

    /// Sections (height, half the thickness) [m] from the root to the radius `load` on the flank: `n` on the fillet, `n` + 1 on the flank.
    pub(super) fn sections(&self, load: f64, n: usize) -> impl Iterator<Item = (f64, f64)> + '_ {
        let part = move |i: usize| i as f64 / n as f64;
        let fillet = self.fillet_points(n);
        let flank = (0..=n).map(move |i| self.form + (load - self.form) * part(i));
        let flank = flank.map(|radius| (radius, self.half_angle(radius)));
        fillet.chain(flank).map(|(radius, angle)| (radius * angle.cos(), radius * angle.sin()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tooth(z: f64, x: f64) -> Result<Tooth, GearError> {
        // The other gear has a short addendum, so that its tips do not reach the fillet of this one.
        let gears = Gears::standard([z, 96.0], 2e-3, 20f64.to_radians(), 1e-2);
        let gears = Gears { profile_shift: [x, -x], addendum: [1.0, 0.6], ..gears };
        Tooth::of(&gears, &gears.contact().unwrap(), 0)
    }

    /// Fillet and flank meet with a common tangent; the fillet begins at the root circle, tangent to it.
    #[test]
    fn the_fillet_joins_flank_and_root() {
        for (z, x) in [(24.0, 0.0), (40.0, 0.2), (60.0, -0.3), (18.0, 0.1)] {
            let t = tooth(z, x).unwrap();
            let (radius, angle) = t.fillet(t.join);
            assert!((angle - t.half_angle(radius)).abs() < 1e-12, "{z} {x}");
            let slope = |f: &dyn Fn(f64) -> (f64, f64), h: f64| {
                let ((r0, a0), (r1, a1)) = (f(-h), f(h));
                (a1 - a0) / (r1 - r0)
            };
            let of_fillet = slope(&|h| t.fillet(t.join + h), 1e-6);
            let of_flank = slope(&|h| (radius + h, t.half_angle(radius + h)), 1e-8);
            assert!((of_fillet / of_flank - 1.0).abs() < 1e-3, "{z} {x}: {of_fillet} {of_flank}");
            assert!((t.fillet(0.0).0 - t.root).abs() < 1e-15);
            assert!((t.fillet(1e-4).0 - t.root).abs() < 1e-7 * t.root, "tangent to the root circle");
        }
    }

    /// The tooth takes half a pitch at the reference circle, and its thickness increases towards the root everywhere.
    #[test]
    fn the_thickness_increases_towards_the_root() {
        let t = tooth(24.0, 0.0).unwrap();
        assert!((t.half_angle(24e-3) - PI / 48.0).abs() < 1e-14);
        let sections: Vec<_> = t.sections(26e-3, 50).collect();
        assert!(sections.windows(2).all(|s| s[1].0 > s[0].0 && s[1].1 < s[0].1));
    }

    #[test]
    fn undercut_teeth_are_refused_beyond_the_limit() {
        assert!(tooth(14.0, 0.0).unwrap_err().what.contains("undercut by 0.18"));
        let seventeen = tooth(17.0, 0.0).unwrap();
        assert_eq!(seventeen.form, seventeen.base);
        assert!(tooth(14.0, 0.3).is_ok());
    }
}
