//! The turn of a coordinate: the length in which its whole revolutions are counted, common to all laws with this phase.
//!
//! Laws of different periods may share a phase, e.g. a mesh stiffness and its reduction by a cracked tooth once per revolution.
//! Counting is exact for all of them only in a common unit. The turn is the longest length of which each period is a whole
//! multiple.

use num_integer::Integer;

use crate::tolerance::phases::{TURN_RATIO, TURNS};

/// The turn, and the number of turns in each of the `periods`; `None` if they have no common measure.
pub fn common(periods: &[f64]) -> Option<(f64, Vec<u32>)> {
    let shortest = periods.iter().copied().reduce(f64::min)?;
    let parts = periods.iter().map(|period| denominator(period / shortest)).collect::<Option<Vec<u32>>>()?;
    let parts = parts.into_iter().try_fold(1u32, |all, part| all.checked_mul(part / all.gcd(&part)))?;
    if parts > TURNS {
        return None;
    }
    let turns = periods.iter().map(|period| (period / shortest * f64::from(parts)).round() as u32).collect();
    Some((shortest / f64::from(parts), turns))
}

/// The smallest denominator for which `ratio` is a fraction, to within rounding.
fn denominator(ratio: f64) -> Option<u32> {
    (1..=TURNS).find(|&q| {
        let p = ratio * f64::from(q);
        (p - p.round()).abs() <= TURN_RATIO * p
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn periods_have_the_longest_common_measure() {
        assert_eq!(common(&[TAU]), Some((TAU, vec![1])));
        assert_eq!(common(&[TAU, 24.0 * TAU]), Some((TAU, vec![1, 24])));
        assert_eq!(common(&[24.0 * TAU, TAU, 7.0 * TAU]), Some((TAU, vec![24, 1, 7])));
        assert_eq!(common(&[1.5, 1.0]), Some((0.5, vec![3, 2])));
        assert_eq!(common(&[1.0 / 3.0, 1.0 / 7.0]).unwrap().1, [7, 3]);
    }

    #[test]
    fn periods_without_a_common_measure_have_none() {
        assert_eq!(common(&[TAU, 5.0]), None);
        assert_eq!(common(&[]), None);
    }
}
