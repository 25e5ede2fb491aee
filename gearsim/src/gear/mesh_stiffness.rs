//! The mesh stiffness as a law over the phase, computed from tooth data.
//!
//! One period of the phase is one base pitch along the line of action. The phase is 0 where a pair touches at the pitch point, and
//! increases as the first gear drives. The first cell of the law is the one with the fewest pairs. It begins where a pair ends
//! contact, at the phase 2 pi g_a/p_b.
//!
//! Helical gears touch along lines that are inclined across the face. The section at the distance x from the middle of the face is a spur
//! gear whose phase is ahead by eps_beta x/b pitches. The stiffness is the mean over the sections, so its steps become ramps of the width
//! of eps_beta pitches. It is constant if eps_beta is a whole number; with levels, also if eps_alpha is a whole number. The phase is 0 when
//! a pair touches at the pitch point in the middle of the face. With the method "energy", the sections have the teeth of the transverse
//! section, and they are independent: the elastic coupling of neighbouring slices is neglected, as in the sum of slices of Wan et al.
//! (2015), Mech. Mach. Theory 84.

use super::contact::Contact;
use super::energy::ToothPair;
use super::iso6336::Iso6336;
use super::pair::{GearError, Gears};
use crate::profile::{Curve, Profile, Step};
use crate::tolerance::scene::SLOPE_STEP;

/// How the stiffness is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StiffnessMethod {
    /// ISO 6336-1, method B, under a line load (tangential force per face width) [N/m], if it is given.
    Iso6336(Option<f64>),
    /// Strain energy of the teeth, see [`ToothPair`].
    Energy,
}

/// The stiffness within a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellShape {
    /// Constant: the mean over the cell.
    Levels,
    /// Cubic curves that follow the computed stiffness.
    Curves,
}

/// Number of cubic curves in a cell. Their relative error is then at most 1e-4.
const PIECES: usize = 4;
/// Number of intervals of Simpson's rule for the mean over a cell.
const INTERVALS: usize = 64;

/// The mesh stiffness of `gears` over a phase of the given period, times `scale`, which is 1 for a law in N/m.
///
/// # Errors
/// Those of [`of_section`].
pub fn stiffness(
    gears: &Gears,
    method: StiffnessMethod,
    shape: CellShape,
    period: f64,
    scale: f64,
) -> Result<Profile, GearError> {
    of_section(gears, method, shape, period, scale).map(|(law, window)| law.averaged(window))
}

/// The law of one transverse section, and the width of the window [unit of the phase] over which [`stiffness`] averages this law. The
/// sections along the face of helical gears have this law at different phases. For spur gears the width is zero.
///
/// # Errors
/// If the gears do not mesh or are outside the range of the method, or for curves of spur gears with [`StiffnessMethod::Iso6336`].
pub fn of_section(
    gears: &Gears,
    method: StiffnessMethod,
    shape: CellShape,
    period: f64,
    scale: f64,
) -> Result<(Profile, f64), GearError> {
    match method {
        StiffnessMethod::Iso6336(_) if shape == CellShape::Curves && gears.helix_angle == 0.0 => {
            let what = "ISO 6336-1 gives one stiffness for each number of pairs, and no curves between the steps";
            Err(GearError::new(what, "use the method \"energy\" for curves"))
        }
        StiffnessMethod::Iso6336(load) => {
            let (iso, contact) = (Iso6336::of(gears, load)?, gears.contact()?);
            let width = scale * gears.face_width;
            let cells = cells(&contact)
                .into_iter()
                .map(|cell| Step { value: iso.pairs(cell.pairs) * width, width: cell.width(&contact, method, period) });
            let section = from_pitch_point(Profile::stepping(cells.collect()), &contact, period);
            Ok((section, contact.overlap * period))
        }
        StiffnessMethod::Energy => {
            let pair = ToothPair::of(gears)?;
            let curves =
                cells(&pair.contact).into_iter().flat_map(|cell| curves_of_cell(&pair, &cell, shape, period, scale));
            let curves: Vec<_> = curves.collect();
            let stiffness = match shape {
                CellShape::Curves => Profile::curved(curves),
                CellShape::Levels => {
                    let step = |(curve, width): (Curve, f64)| Step { value: curve.mean(width), width };
                    Profile::stepping(curves.into_iter().map(step).collect())
                }
            };
            Ok((from_pitch_point(stiffness, &pair.contact, period), pair.contact.overlap * period))
        }
    }
}

/// A part of a pitch in which the same pairs are in contact.
pub(super) struct ContactInterval {
    pub(super) pairs: usize,
    /// Ends of the cell, as positions of a pair along the path of contact [m].
    pub(super) begin: f64,
    pub(super) end: f64,
}

impl ContactInterval {
    /// Width [unit of the phase]. Stiffness and friction laws use this function, so that their widths are bit-identical.
    pub(super) fn width(&self, contact: &Contact, method: StiffnessMethod, period: f64) -> f64 {
        let length = self.end - self.begin;
        match method {
            StiffnessMethod::Iso6336(_) => length / contact.base_pitch * period,
            StiffnessMethod::Energy => length * (period / contact.base_pitch),
        }
    }
}

/// The cells of a pitch. The first one begins where a pair ends contact.
pub(super) fn cells(contact: &Contact) -> Vec<ContactInterval> {
    let ((pairs, more), pitch) = (contact.pairs(), contact.base_pitch);
    let (begin, middle) = (contact.recess, contact.recess + (1.0 - more) * pitch);
    let few = ContactInterval { pairs, begin, end: middle };
    match more > 0.0 {
        true => vec![few, ContactInterval { pairs: pairs + 1, begin: middle, end: begin + pitch }],
        false => vec![few],
    }
}

/// Sets the origin of a law so that the phase is 0 at the pitch point. The first cell of the law must begin where a pair ends contact.
pub(super) fn from_pitch_point(stiffness: Profile, contact: &Contact, period: f64) -> Profile {
    stiffness.with_origin((contact.recess / contact.base_pitch).fract() * period)
}

/// The curves of a cell with the stiffness of `pair`, with their widths [unit of the phase].
fn curves_of_cell(
    pair: &ToothPair,
    cell: &ContactInterval,
    shape: CellShape,
    period: f64,
    scale: f64,
) -> Vec<(Curve, f64)> {
    let pitch = pair.contact.base_pitch;
    // At the ends of a cell a pair begins or ends contact. So the pairs at its middle are summed throughout.
    let middle = 0.5 * (cell.begin + cell.end);
    let first = ((-pair.contact.approach - middle) / pitch).ceil() as i64;
    let k =
        |x: f64| (first..first + cell.pairs as i64).map(|j| pair.stiffness(x + j as f64 * pitch)).sum::<f64>() * scale;
    let width = (cell.end - cell.begin) * (period / pitch);
    match shape {
        CellShape::Curves => curves(k, [cell.begin, cell.end], width),
        CellShape::Levels => {
            let h = (cell.end - cell.begin) / INTERVALS as f64;
            let weight = |i: usize| if i == 0 || i == INTERVALS { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
            let sum: f64 = (0..=INTERVALS).map(|i| weight(i) * k(cell.begin + h * i as f64)).sum();
            let mean = sum / (3.0 * INTERVALS as f64);
            vec![(Curve::Cubic([mean, 0.0, 0.0, 0.0]), width)]
        }
    }
}

/// Cubic Hermite curves, with their widths, that interpolate `value`, a function of the position along the path of contact [m], from
/// `begin` to `end`. Together they cover `width` [unit of the phase].
pub(super) fn curves(value: impl Fn(f64) -> f64, [begin, end]: [f64; 2], width: f64) -> Vec<(Curve, f64)> {
    let (length, w) = ((end - begin) / PIECES as f64, width / PIECES as f64);
    // Slopes by central differences.
    let h = SLOPE_STEP * length;
    let slope = |x: f64| (value(x + h) - value(x - h)) / (2.0 * h) * length / w;
    let piece = |i: usize| {
        let (a, b) = (begin + length * i as f64, begin + length * (i + 1) as f64);
        (Curve::hermite([value(a), value(b)], [slope(a), slope(b)], w), w)
    };
    (0..PIECES).map(piece).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn gears() -> Gears {
        Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3)
    }

    /// The gears of Oh, Grosh & Barber (2005). The widths agree with the paper. The ratio of the levels does not: it is 1.944 in the paper,
    /// but 1.744 here and 1.75 in ISO 6336-1. When two tooth pairs are in contact, they touch nearer to tips and roots, so together they
    /// are less than twice as stiff as one pair.
    #[test]
    fn levels_and_widths_of_the_gears_of_oh_2005() {
        let law = stiffness(&gears(), StiffnessMethod::Energy, CellShape::Levels, TAU, 1.0).unwrap();
        let [one, two] = law.steps[..] else { panic!("{law:?}") };
        assert!((one.width - 1.728).abs() < 1e-3 && (one.width + two.width - TAU).abs() < 1e-14);
        assert!((two.value / one.value - 1.744).abs() < 1e-3, "{}", two.value / one.value);
        assert!((one.value / 1.018e8 - 1.0).abs() < 1e-3, "{:e}", one.value);
    }

    /// The curves follow the stiffness with a relative error of 1e-4, and their means are the levels.
    #[test]
    fn curves_follow_the_stiffness() {
        let pair = ToothPair::of(&gears()).unwrap();
        let law = stiffness(&gears(), StiffnessMethod::Energy, CellShape::Curves, TAU, 1.0).unwrap();
        let levels = stiffness(&gears(), StiffnessMethod::Energy, CellShape::Levels, TAU, 1.0).unwrap();
        let mut begin = law.origin;
        for (curve, step) in law.curves.iter().zip(&law.steps) {
            for part in [0.01, 0.3, 0.5, 0.9] {
                let s = begin + part * step.width;
                let k = pair.mesh(s / TAU * pair.contact.base_pitch);
                assert!((curve.at(part * step.width)[0] / k - 1.0).abs() < 1e-4, "{s}: {k}");
            }
            begin += step.width;
        }
        assert_eq!(law.origin, levels.origin);
        assert!((law.mean() / levels.mean() - 1.0).abs() < 1e-5);
    }

    /// The law of helical gears is the mean over 2,000 sections of the face, each a spur gear with its own phase. It is continuous, its
    /// mean is c_gamma b, and with a whole overlap ratio it is constant.
    #[test]
    fn helical_stiffness_is_the_mean_over_the_face() {
        let gears = crate::gear::pair::iso_6336_30();
        let law =
            |gears: &Gears| stiffness(gears, StiffnessMethod::Iso6336(None), CellShape::Levels, TAU, 1.0).unwrap();
        let (iso, contact) = (Iso6336::of(&gears, None).unwrap(), gears.contact().unwrap());
        let helical = law(&gears);
        let pairs = |s: f64| {
            let x = s / TAU * contact.base_pitch;
            let j = |end: f64| ((end - x) / contact.base_pitch).floor();
            (j(contact.recess) - j(-contact.approach)) as usize
        };
        let n = 2000;
        for s in [0.1, 1.0, 2.0, 3.5, 5.0, 6.0] {
            let section = |i: usize| s + TAU * contact.overlap * ((i as f64 + 0.5) / n as f64 - 0.5);
            let mean = (0..n).map(|i| iso.pairs(pairs(section(i)))).sum::<f64>() / n as f64 * gears.face_width;
            assert!((value(&helical, s) / mean - 1.0).abs() < 2e-3, "{s}: {:e} {mean:e}", value(&helical, s));
        }
        assert!((helical.mean() / (iso.mean * gears.face_width) - 1.0).abs() < 1e-12);
        let (low, high) = law(&Gears { face_width: 2.0 * gears.face_width / contact.overlap, ..gears }).extremes();
        assert!((high / low - 1.0).abs() < 1e-12);
    }

    /// With the method "energy", the stiffness of helical gears is the mean over 4,000 slices, each with the teeth of the transverse
    /// section and its own phase. For a helix angle near zero it is the stiffness of spur gears. With a whole overlap ratio it is constant.
    #[test]
    fn helical_stiffness_by_energy_is_the_mean_of_slices() {
        let gears = crate::gear::pair::iso_6336_30();
        let law = |gears: &Gears, shape| stiffness(gears, StiffnessMethod::Energy, shape, TAU, 1.0).unwrap();
        let (pair, contact) = (ToothPair::of(&gears).unwrap(), gears.contact().unwrap());
        let helical = law(&gears, CellShape::Curves);
        let n = 4000;
        for s in [0.1, 1.0, 2.0, 3.5, 5.0, 6.0] {
            let x = |i: usize| (s / TAU + contact.overlap * ((i as f64 + 0.5) / n as f64 - 0.5)) * contact.base_pitch;
            let mean = (0..n).map(|i| pair.mesh(x(i))).sum::<f64>() / n as f64;
            assert!((value(&helical, s) / mean - 1.0).abs() < 1e-3, "{s}: {:e} {mean:e}", value(&helical, s));
        }
        let levels = law(&gears, CellShape::Levels);
        assert!((helical.mean() / levels.mean() - 1.0).abs() < 1e-3);
        let iso = stiffness(&gears, StiffnessMethod::Iso6336(None), CellShape::Levels, TAU, 1.0).unwrap();
        assert!((helical.mean() / iso.mean() - 1.0).abs() < 0.2, "{:e} {:e}", helical.mean(), iso.mean());
        let (low, high) =
            law(&Gears { face_width: 2.0 * gears.face_width / contact.overlap, ..gears.clone() }, CellShape::Curves)
                .extremes();
        assert!((high / low - 1.0).abs() < 1e-9, "{low:e} {high:e}");
        let spur = Gears { helix_angle: 0.0, centre_distance: None, ..gears };
        let (almost, spur) =
            (law(&Gears { helix_angle: 1e-6, ..spur.clone() }, CellShape::Curves), law(&spur, CellShape::Curves));
        for s in [0.1, 1.0, 2.0, 3.5, 5.0, 6.0] {
            assert!((value(&almost, s) / value(&spur, s) - 1.0).abs() < 1e-4, "{s}");
        }
    }

    /// The value of a law with curves at a phase.
    fn value(law: &Profile, s: f64) -> f64 {
        let mut rest = (s - law.origin).rem_euclid(TAU);
        for (curve, step) in law.curves.iter().zip(&law.steps) {
            if rest <= step.width {
                return curve.at(rest)[0];
            }
            rest -= step.width;
        }
        law.curves[0].at(0.0)[0]
    }

    /// At the phase 0 a pair is at the pitch point. With these gears it is the only pair in contact there.
    #[test]
    fn the_phase_is_zero_at_the_pitch_point() {
        let law = stiffness(&gears(), StiffnessMethod::Iso6336(None), CellShape::Levels, TAU, 1.0).unwrap();
        let contact = gears().contact().unwrap();
        let ends = (law.origin + law.steps[0].width).rem_euclid(TAU);
        assert!((law.origin.rem_euclid(TAU) - contact.recess / contact.base_pitch * TAU).abs() < 1e-12);
        assert!((ends - (TAU - contact.approach / contact.base_pitch * TAU).rem_euclid(TAU)).abs() < 1e-12);
        let mean = Iso6336::of(&gears(), None).unwrap().mean * 7e-3;
        assert!((law.mean() / mean - 1.0).abs() < 1e-14);
        assert!(stiffness(&gears(), StiffnessMethod::Iso6336(None), CellShape::Curves, TAU, 1.0).is_err());
    }
}
