//! The friction laws of a mesh, computed from the points of contact and the shares of the force.
//!
//! Pair i touches at the distance xi_i from the pitch point along the line of action, and carries the share s_i of the force:
//!
//! ```text
//! side = sum s_i sgn(xi_i),    arm = sum s_i |xi_i|
//! ```
//!
//! The shares are equal, or proportional to the stiffnesses of the pairs. Helical gears touch along lines across the face. Each pair has a
//! share in each slice of the face ([`super::mesh_stiffness`]): equal per length of contact line, or proportional to the stiffness. Both
//! laws then become continuous. In a ring the rolling speed is the difference of the speeds of the gears. The laws are the same sums over
//! its path of contact. The flanks of gears on parallel axes slide in the transverse plane. The force normal to a helical flank is the
//! force in that plane divided by cos(beta_b). Therefore both laws are divided by cos(beta_b).
//!
//! For spur gears, the boundaries of the cells are bit-identical to those of the stiffness. There is one more boundary where a pair passes
//! the pitch point: there the side steps, and the arm has a kink.

use super::contact::Contact;
use super::energy::ToothPair;
use super::mesh_stiffness::{ContactInterval, StiffnessMethod, cells, curves, from_pitch_point};
use super::pair::{GearError, Gears};
use crate::profile::{Curve, Profile, Step};
use crate::tolerance::scene::PITCH_POINT;

/// The quantity of the pairs that is summed, weighted with their shares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrictionLaw {
    /// Side of the pitch point: 1 after it, -1 before it.
    Side,
    /// Distance from the pitch point [m].
    Arm,
}

/// The friction law `what` of `gears` over a phase of the given period, times `scale`. The stiffness method decides the shares: equal
/// for [`StiffnessMethod::Iso6336`], proportional to the stiffnesses of the pairs for [`StiffnessMethod::Energy`].
///
/// # Errors
/// If the gears do not mesh, or are outside the range of the method: the method "energy" needs external teeth.
pub fn friction(
    gears: &Gears,
    method: StiffnessMethod,
    what: FrictionLaw,
    period: f64,
    scale: f64,
) -> Result<Profile, GearError> {
    let pairs = Pairs {
        contact: gears.contact()?,
        teeth: match method {
            StiffnessMethod::Iso6336(_) => None,
            StiffnessMethod::Energy => Some(ToothPair::of(gears)?),
        },
    };
    let cells = cells(&pairs.contact);
    let parts: Vec<CellPart> = cells.iter().flat_map(|cell| parts(cell, &pairs.contact, method, period)).collect();
    let window = pairs.contact.overlap * period;
    if window > 0.0 {
        let law = |of: Option<FrictionLaw>, scale: f64| {
            let pieces = parts
                .iter()
                .flat_map(|part| curves(|x| scale * pairs.weighted(of, part, x), [part.begin, part.end], part.width));
            from_pitch_point(Profile::curved(pieces.collect()), &pairs.contact, period)
        };
        return Ok(law(Some(what), scale / gears.base_helix_angle().cos()).averaged_by(&law(None, 1.0), window));
    }
    let law = match (what, &pairs.teeth) {
        (FrictionLaw::Side, None) => {
            let step = |part: &CellPart| Step { value: scale * pairs.sum(what, part, part.begin), width: part.width };
            Profile::stepping(parts.iter().map(step).collect())
        }
        _ => Profile::curved(parts.iter().flat_map(|part| pairs.curves(what, part, scale)).collect()),
    };
    Ok(from_pitch_point(law, &pairs.contact, period))
}

/// A part of a cell in which no pair passes the pitch point.
struct CellPart {
    pairs: usize,
    /// Ends of the part, as positions of a pair along the path of contact [m].
    begin: f64,
    end: f64,
    /// Width [unit of the phase].
    width: f64,
}

/// The parts of a cell. Their widths add up to that of the cell without rounding error.
fn parts(cell: &ContactInterval, contact: &Contact, method: StiffnessMethod, period: f64) -> Vec<CellPart> {
    let (pitch, whole) = (contact.base_pitch, cell.width(contact, method, period));
    let part = |begin, end, width| CellPart { pairs: cell.pairs, begin, end, width };
    let passes = (cell.begin / pitch + PITCH_POINT).ceil() * pitch;
    if passes >= cell.end - PITCH_POINT * pitch {
        return vec![part(cell.begin, cell.end, whole)];
    }
    let first = (passes - cell.begin) / (cell.end - cell.begin) * whole;
    // `whole - first` is exact if `first` is at least half of `whole`. Otherwise `first` is rounded so that it is exact.
    let first = if first >= whole / 2.0 { first } else { whole - (whole - first) };
    vec![part(cell.begin, passes, first), part(passes, cell.end, whole - first)]
}

/// The tooth pairs; with their stiffnesses if the shares are proportional to them.
struct Pairs {
    contact: Contact,
    teeth: Option<ToothPair>,
}

impl Pairs {
    /// The weighted sum over the pairs of a part when one of them is at `x` [m].
    fn sum(&self, what: FrictionLaw, part: &CellPart, x: f64) -> f64 {
        let pitch = self.contact.base_pitch;
        // At the ends of a part a pair begins or ends contact, or changes sides. So the pairs and sides at its middle are used throughout.
        let middle = 0.5 * (part.begin + part.end);
        let first = ((-self.contact.approach - middle) / pitch).ceil() as i64;
        let pairs = || (first..first + part.pairs as i64).map(|j| j as f64 * pitch);
        let weight = |ahead: f64| self.teeth.as_ref().map_or(1.0, |teeth| teeth.stiffness(x + ahead));
        let all: f64 = pairs().map(weight).sum();
        let each = |ahead: f64| {
            let side = if middle + ahead > 0.0 { 1.0 } else { -1.0 };
            weight(ahead) / all * if what == FrictionLaw::Side { side } else { side * (x + ahead) }
        };
        pairs().map(each).sum()
    }

    /// The sum over the pairs of a part when one of them is at `x` [m]: of their weights times their sides or their distances from the
    /// pitch point. For `None`, the sum of their weights.
    fn weighted(&self, what: Option<FrictionLaw>, part: &CellPart, x: f64) -> f64 {
        let pitch = self.contact.base_pitch;
        let middle = 0.5 * (part.begin + part.end);
        let first = ((-self.contact.approach - middle) / pitch).ceil() as i64;
        let each = |ahead: f64| {
            let side = if middle + ahead > 0.0 { 1.0 } else { -1.0 };
            let of = match what {
                None => 1.0,
                Some(FrictionLaw::Side) => side,
                Some(FrictionLaw::Arm) => side * (x + ahead),
            };
            self.teeth.as_ref().map_or(1.0, |teeth| teeth.stiffness(x + ahead)) * of
        };
        (first..first + part.pairs as i64).map(|j| each(j as f64 * pitch)).sum()
    }

    /// The curves of a part, with their widths [unit of the phase]. Their error is at most 2e-5: absolute for the side, in base pitches for
    /// the arm.
    fn curves(&self, what: FrictionLaw, part: &CellPart, scale: f64) -> Vec<(Curve, f64)> {
        let value = |x: f64| scale * self.sum(what, part, x);
        if self.teeth.is_none() {
            let (a, b) = (value(part.begin), value(part.end));
            return vec![(Curve::Cubic([a, (b - a) / part.width, 0.0, 0.0]), part.width)];
        }
        curves(value, [part.begin, part.end], part.width)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::engine::crossing::Side;
    use crate::engine::phase::Pitch;
    use crate::gear::{CellShape, stiffness};

    fn gears() -> Gears {
        Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3)
    }

    fn law(method: StiffnessMethod, what: FrictionLaw, scale: f64) -> Profile {
        friction(&gears(), method, what, TAU, scale).unwrap()
    }

    /// Value of the law at a phase.
    fn at(law: &Profile, s: f64) -> f64 {
        let pitch = Pitch::new(law, TAU);
        let (_, rest, cell) = pitch.locate(s, 1.0);
        pitch.course(cell, rest - pitch.bounds(cell).0)[0]
    }

    /// The laws equal the sums over all pairs in contact, computed one by one.
    #[test]
    fn laws_are_the_sums_over_the_pairs() {
        let pair = ToothPair::of(&gears()).unwrap();
        let contact = &pair.contact;
        for (method, bound) in [(StiffnessMethod::Iso6336(None), 1e-12), (StiffnessMethod::Energy, 2e-5)] {
            let (side, arm) = (law(method, FrictionLaw::Side, 1.0), law(method, FrictionLaw::Arm, 1.0));
            let mut worst = [0.0f64; 2];
            for s in (0..200).map(|i| 0.013 + TAU * f64::from(i) / 200.0) {
                let places = (-3..=3).map(|j| (s / TAU + f64::from(j)) * contact.base_pitch);
                let touching: Vec<f64> = places.filter(|xi| (-contact.approach..contact.recess).contains(xi)).collect();
                let weight = |xi: f64| if method == StiffnessMethod::Energy { pair.stiffness(xi) } else { 1.0 };
                let all: f64 = touching.iter().map(|xi| weight(*xi)).sum();
                let sum = |f: fn(f64) -> f64| touching.iter().map(|xi| weight(*xi) / all * f(*xi)).sum::<f64>();
                let off = [at(&side, s) - sum(f64::signum), (at(&arm, s) - sum(f64::abs)) / contact.base_pitch];
                worst = [0, 1].map(|i| worst[i].max(off[i].abs()));
            }
            println!("{method:?}: off by {worst:?}");
            assert!(worst[0] < bound && worst[1] < bound, "{method:?}: {worst:?}");
        }
    }

    /// The boundaries are bit-identical to those of the stiffness, and there is one more, where a pair is at the pitch point. The arm is
    /// continuous there.
    #[test]
    fn boundaries_are_those_of_the_stiffness_and_the_pitch_point() {
        let ends = |law: &Profile| {
            let pitch = Pitch::new(law, TAU);
            (0..pitch.cells()).map(|cell| pitch.bounds(cell).0).collect::<Vec<_>>()
        };
        for z in [[24.0, 96.0], [31.0, 40.0], [20.0, 77.0]] {
            let gears = Gears::standard(z, 6.35e-3, 20f64.to_radians(), 7e-3);
            for method in [StiffnessMethod::Iso6336(None), StiffnessMethod::Energy] {
                let k = stiffness(&gears, method, CellShape::Levels, TAU, 1.0).unwrap();
                let [side, arm] =
                    [FrictionLaw::Side, FrictionLaw::Arm].map(|what| friction(&gears, method, what, TAU, 1.0).unwrap());
                let (k, side_ends, arm_ends) = (ends(&k), ends(&side), ends(&arm));
                assert!(k.iter().all(|b| side_ends.contains(b) && arm_ends.contains(b)), "{k:?} {side_ends:?}");
                let at_pitch_point = |b: &&f64| b.abs() < 1e-12 || (*b - TAU).abs() < 1e-12;
                assert_eq!(side_ends.iter().filter(at_pitch_point).count(), 1, "{side_ends:?}");
                let arm = Pitch::new(&arm, TAU);
                let cell = (0..arm.cells()).find(|c| at_pitch_point(&&arm.bounds(*c).1)).unwrap();
                assert_eq!(arm.step(cell, Side::Upper), 0.0);
            }
        }
    }

    /// In units of the phase, the arm of a single pair is the absolute value of the phase.
    #[test]
    fn the_arm_of_a_single_pair_is_its_distance_from_the_pitch_point() {
        let base_pitch = gears().contact().unwrap().base_pitch;
        let arm = law(StiffnessMethod::Iso6336(None), FrictionLaw::Arm, TAU / base_pitch);
        for s in [-0.3, -0.1, 0.2] {
            assert!((at(&arm, s) - f64::abs(s)).abs() < 1e-12);
        }
    }

    /// Both laws of helical gears are sums over 4,000 slices of the face, with shares in proportion to the weights of pairs and slices, and
    /// continuous. For a helix angle near zero they are the laws of spur gears.
    #[test]
    fn laws_of_helical_gears_are_sums_over_slices() {
        let gears = crate::gear::pair::iso_6336_30();
        let pair = ToothPair::of(&gears).unwrap();
        let (contact, cos) = (gears.contact().unwrap(), gears.base_helix_angle().cos());
        assert!((pair.contact.ratio() / contact.ratio() - 1.0).abs() < 1e-12);
        for method in [StiffnessMethod::Iso6336(None), StiffnessMethod::Energy] {
            let [side, arm] =
                [FrictionLaw::Side, FrictionLaw::Arm].map(|what| friction(&gears, method, what, TAU, 1.0).unwrap());
            for s in (0..23).map(|i| 0.1 + TAU * f64::from(i) / 23.0) {
                let (n, mut sums) = (4000, [0.0; 3]);
                for i in 0..n {
                    let ahead = contact.overlap * ((f64::from(i) + 0.5) / f64::from(n) - 0.5);
                    let places = (-4..=4).map(|j| (s / TAU + ahead + f64::from(j)) * contact.base_pitch);
                    for xi in places.filter(|xi| (-contact.approach..contact.recess).contains(xi)) {
                        let w = if method == StiffnessMethod::Energy { pair.stiffness(xi) } else { 1.0 };
                        sums = [sums[0] + w, sums[1] + w * xi.signum(), sums[2] + w * xi.abs()];
                    }
                }
                let [all, sides, arms] = sums;
                let off = [at(&side, s) - sides / all / cos, (at(&arm, s) - arms / all / cos) / contact.base_pitch];
                assert!(off[0].abs() < 2e-3 && off[1].abs() < 1e-3, "{method:?} at {s}: {off:?}");
            }
            let pitch = Pitch::new(&arm, TAU);
            assert!((0..pitch.cells()).all(|cell| pitch.step(cell, Side::Upper).abs() < 1e-12 * contact.base_pitch));
        }
        let small = Gears { helix_angle: 1e-5, ..self::gears() };
        for what in [FrictionLaw::Side, FrictionLaw::Arm] {
            let spur = law(StiffnessMethod::Energy, what, 1.0);
            let helical = friction(&small, StiffnessMethod::Energy, what, TAU, 1.0).unwrap();
            for s in [0.3, 1.1, 2.5, 5.9] {
                assert!((at(&helical, s) / at(&spur, s) - 1.0).abs() < 1e-4, "{what:?} at {s}");
            }
        }
    }

    /// The mean arm of spur gears, also with a ring, against the loss factor of a mesh whose pairs have equal shares, for 1 < eps < 2: H_V
    /// = pi (1/z_1 +- 1/z_2) (1 - eps + eps_f^2 + eps_a^2), with - for a ring (H. Ohlendorf, thesis, TH Munich, 1958; G. Niemann, H.
    /// Winter, Maschinenelemente II). It is the mean arm divided by the base radius, times the rolling speed divided by the speed of the
    /// first gear.
    #[test]
    fn the_mean_arm_gives_the_loss_factor_of_a_mesh() {
        let ring = Gears {
            internal: true,
            addendum: [1.0, 0.8],
            ..Gears::standard([36.0, 99.0], 3e-3, 20f64.to_radians(), 25e-3)
        };
        for (gears, sign) in [(gears(), 1.0), (ring, -1.0)] {
            let ([z1, z2], contact) = (gears.teeth, gears.contact().unwrap());
            let arm = friction(&gears, StiffnessMethod::Iso6336(None), FrictionLaw::Arm, TAU, 1.0).unwrap();
            // The arm steps where a pair enters contact, so that the mean over n points has an error of the order 1/n.
            let n = 20_000;
            let mean = (0..n).map(|i| at(&arm, TAU * (f64::from(i) + 0.5) / f64::from(n))).sum::<f64>() / f64::from(n);
            let [eps, before, after] =
                [contact.ratio(), contact.approach / contact.base_pitch, contact.recess / contact.base_pitch];
            let factor = std::f64::consts::PI * (1.0 / z1 + sign / z2) * (1.0 - eps + before * before + after * after);
            let computed = mean / contact.base[0] * (1.0 + sign * z1 / z2);
            assert!((1.0..2.0).contains(&eps) && (computed / factor - 1.0).abs() < 1e-4, "{computed} {factor}");
        }
    }
}
