//! A mesh stiffness law out of tooth data.
//!
//! One pitch of the law's phase is one base pitch along the line of action. The phase is 0 where a pair touches at the
//! pitch point, and grows as the first gear drives. The law's first cell is that with the fewest pairs: it begins where a pair
//! parts, the phase 2 pi g_a/p_b.

use super::energy::ToothPair;
use super::iso6336::Iso6336;
use super::pair::{Contact, GearError, Gears};
use crate::profile::{Curve, Profile, Step};

/// Where the stiffness is from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StiffnessMethod {
    /// ISO 6336-1, method B, under a tangential load per width [N/m] if it is known.
    Iso6336(Option<f64>),
    /// The strain energy of the teeth.
    Energy,
}

/// What it is between two steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellShape {
    /// Its mean.
    Levels,
    /// What it is: cubic curves.
    Curves,
}

/// Cubic curves in a cell; they are then within 1e-4 of the stiffness.
const PIECES: usize = 4;
/// Points of a cell whose mean is taken, by Simpson's rule.
const POINTS: usize = 64;

/// The stiffness of the mesh of `gears` over a phase of the given period, times `scale`, which is 1 for a law in N/m.
///
/// # Errors
/// Where the gears do not mesh, or the method is not for them.
pub fn stiffness(
    gears: &Gears,
    method: StiffnessMethod,
    shape: CellShape,
    period: f64,
    scale: f64,
) -> Result<Profile, GearError> {
    match method {
        StiffnessMethod::Iso6336(_) if shape == CellShape::Curves => {
            let what = "ISO 6336-1 gives a stiffness for each number of pairs, and no course between the steps";
            Err(GearError::new(what, "take the method \"energy\" for curves"))
        }
        StiffnessMethod::Iso6336(load) => {
            let (iso, contact) = (Iso6336::of(gears, load)?, gears.contact()?);
            let width = scale * gears.face_width;
            let cells = cells(&contact)
                .into_iter()
                .map(|cell| Step { value: iso.pairs(cell.pairs) * width, width: cell.width(&contact, method, period) });
            Ok(at_its_place(Profile::stepping(cells.collect()), &contact, period))
        }
        StiffnessMethod::Energy => {
            let pair = ToothPair::of(gears)?;
            let curves = cells(&pair.contact).into_iter().flat_map(|cell| along(&pair, &cell, shape, period, scale));
            let curves: Vec<_> = curves.collect();
            let stiffness = match shape {
                CellShape::Curves => Profile::curved(curves),
                CellShape::Levels => {
                    let step = |(curve, width): (Curve, f64)| Step { value: curve.mean(width), width };
                    Profile::stepping(curves.into_iter().map(step).collect())
                }
            };
            Ok(at_its_place(stiffness, &pair.contact, period))
        }
    }
}

/// A part of a pitch over which the same pairs touch.
pub(super) struct Cell {
    pub(super) pairs: usize,
    /// Where it begins and ends, as places of a pair along the path of contact [m].
    pub(super) begin: f64,
    pub(super) end: f64,
}

impl Cell {
    /// The phase over which it goes, rounded as that of the stiffness.
    pub(super) fn width(&self, contact: &Contact, method: StiffnessMethod, period: f64) -> f64 {
        let length = self.end - self.begin;
        match method {
            StiffnessMethod::Iso6336(_) => length / contact.base_pitch * period,
            StiffnessMethod::Energy => length * (period / contact.base_pitch),
        }
    }
}

/// The cells of a pitch, from where a pair parts.
pub(super) fn cells(contact: &Contact) -> Vec<Cell> {
    let ((pairs, more), pitch) = (contact.pairs(), contact.base_pitch);
    let (begin, middle) = (contact.recess, contact.recess + (1.0 - more) * pitch);
    let few = Cell { pairs, begin, end: middle };
    match more > 0.0 {
        true => vec![few, Cell { pairs: pairs + 1, begin: middle, end: begin + pitch }],
        false => vec![few],
    }
}

/// Puts the first cell where it begins in the pitch, which itself begins at the pitch point.
pub(super) fn at_its_place(stiffness: Profile, contact: &Contact, period: f64) -> Profile {
    stiffness.with_origin((contact.recess / contact.base_pitch).fract() * period)
}

/// The curves of a cell, with their widths.
fn along(pair: &ToothPair, cell: &Cell, shape: CellShape, period: f64, scale: f64) -> Vec<(Curve, f64)> {
    let pitch = pair.contact.base_pitch;
    // Pairs at the ends of the cell come and go: those of its middle are summed, all the way.
    let middle = 0.5 * (cell.begin + cell.end);
    let first = ((-pair.contact.approach - middle) / pitch).ceil() as i64;
    let k =
        |x: f64| (first..first + cell.pairs as i64).map(|j| pair.stiffness(x + j as f64 * pitch)).sum::<f64>() * scale;
    let width = (cell.end - cell.begin) * (period / pitch);
    match shape {
        CellShape::Curves => curves(k, [cell.begin, cell.end], width),
        CellShape::Levels => {
            let h = (cell.end - cell.begin) / POINTS as f64;
            let weight = |i: usize| if i == 0 || i == POINTS { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
            let sum: f64 = (0..=POINTS).map(|i| weight(i) * k(cell.begin + h * i as f64)).sum();
            let mean = sum / (3.0 * POINTS as f64);
            vec![(Curve::Cubic([mean, 0.0, 0.0, 0.0]), width)]
        }
    }
}

/// Cubic curves, with their widths, that follow `value` of a place along the path of contact [m] from the one end to the other, over a
/// phase of `width`.
pub(super) fn curves(value: impl Fn(f64) -> f64, [begin, end]: [f64; 2], width: f64) -> Vec<(Curve, f64)> {
    let (length, w) = ((end - begin) / PIECES as f64, width / PIECES as f64);
    let h = 1e-4 * length;
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

    /// The gears of Oh, Grosh & Barber (2005). Their widths are met; the ratio of their levels, 1.944, is not: two pairs of teeth,
    /// touching nearer to tips and roots, are less than twice as stiff as one, by energies as by the standard (1.75).
    #[test]
    fn levels_of_the_founding_pair() {
        let law = stiffness(&gears(), StiffnessMethod::Energy, CellShape::Levels, TAU, 1.0).unwrap();
        let [one, two] = law.steps[..] else { panic!("{law:?}") };
        assert!((one.width - 1.728).abs() < 1e-3 && (one.width + two.width - TAU).abs() < 1e-14);
        assert!((two.value / one.value - 1.744).abs() < 1e-3, "{}", two.value / one.value);
        assert!((one.value / 1.018e8 - 1.0).abs() < 1e-3, "{:e}", one.value);
    }

    /// The curves are the stiffness: in the middle of every piece to 1e-4, and their means are the levels.
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

    /// At the phase 0 a pair is at the pitch point, alone with these gears.
    #[test]
    fn the_phase_begins_at_the_pitch_point() {
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
