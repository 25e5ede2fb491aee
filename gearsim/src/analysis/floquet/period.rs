//! The common period of all stiffnesses, divided into stretches. In a stretch no stiffness steps, but a stiffness may follow a curve.

use num_integer::Integer;

use crate::analysis::steady::SteadyLaw;
use crate::tolerance::analysis;

/// Why the laws have no common period.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Aperiodic {
    #[error(
        "no stiffness of the scene varies, so nothing is periodic: this needs a law with two levels or a curve, and the effect \
         `stiffness_step`; a model without this effect has nothing that varies"
    )]
    Constant,
    #[error("the phase of `{law}` does not move: give the scene a speed in [start]")]
    Still { law: &'static str },
    #[error("springs to the ground stop the rotation that [start] gives, so that there is no steady rotation")]
    Held,
    #[error(
        "the meshes `{first}` and `{second}` have no common period: the ratio of their frequencies, {ratio}, is not one of whole numbers up to {most}"
    )]
    Incommensurate { first: &'static str, second: &'static str, ratio: f64, most: u64 },
    #[error(
        "the equations change along the motion and do not repeat after any number of turns: give the coordinates that turn speeds in whole ratios"
    )]
    NoTurn,
    #[error("a common period of all meshes has more than {most} steps")]
    Long { most: usize },
}

/// A part of the period in which no stiffness steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// The value of each law; for a curve its mean in the cell \[SI\].
    pub levels: Vec<f64>,
    /// When it begins \[s\].
    pub begin: f64,
    /// Its duration \[s\].
    pub time: f64,
}

/// The common period \[s\] of the laws, and its stretches in order of time.
///
/// # Errors
/// [`Aperiodic`] if there is none.
pub fn stretches(courses: &[SteadyLaw]) -> Result<(f64, Vec<Stretch>), Aperiodic> {
    let varying: Vec<&SteadyLaw> = courses.iter().filter(|c| c.varies).collect();
    let first = *varying.first().ok_or(Aperiodic::Constant)?;
    if let Some(still) = varying.iter().find(|c| c.speed == 0.0 || !c.frequency().is_normal()) {
        return Err(Aperiodic::Still { law: still.name });
    }
    // Number of pitches of the first mesh in the period.
    let mut pitches = 1u64;
    for course in &varying {
        let ratio = course.frequency() / first.frequency();
        let whole = (1..=analysis::COMMON_PITCHES).find(|&p| {
            let other = ratio * p as f64;
            other.round() >= 1.0 && (other - other.round()).abs() <= analysis::FREQUENCY_RATIO * other
        });
        let Some(whole) = whole else {
            return Err(Aperiodic::Incommensurate {
                first: first.name,
                second: course.name,
                ratio,
                most: analysis::COMMON_PITCHES,
            });
        };
        let common = pitches.checked_mul(whole / pitches.gcd(&whole));
        pitches = common.ok_or(Aperiodic::Long { most: analysis::PERIOD_STEPS })?;
    }
    let period = pitches as f64 / first.frequency();
    let count = varying.iter().map(|c| c.frequency() * period * c.levels.len() as f64).sum::<f64>();
    if count > analysis::PERIOD_STEPS as f64 {
        return Err(Aperiodic::Long { most: analysis::PERIOD_STEPS });
    }
    let mut cuts: Vec<f64> = varying.iter().flat_map(|c| steps(c, period)).chain([0.0, period]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|later, earlier| *later - *earlier <= analysis::SAME_TIME * period);
    let stretch = |pair: &[f64]| {
        let middle = 0.5 * (pair[0] + pair[1]);
        let levels = courses.iter().map(|c| c.level(middle)).collect();
        Stretch { levels, begin: pair[0], time: pair[1] - pair[0] }
    };
    Ok((period, cuts.windows(2).map(stretch).collect()))
}

/// The times within the period at which a law steps [s].
fn steps(course: &SteadyLaw, period: f64) -> Vec<f64> {
    let pitches = (course.frequency() * period).round() as u64;
    let one = course.period / course.speed.abs();
    // Time until the phase first reaches the end of a level.
    let way = |end: f64| {
        let forward = if course.speed > 0.0 { end - course.start } else { course.start - end };
        forward.rem_euclid(course.period) / course.speed.abs()
    };
    (0..pitches).flat_map(|p| course.levels.iter().map(move |&(_, end)| way(end) + p as f64 * one)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn course(name: &'static str, speed: f64, start: f64) -> SteadyLaw {
        let levels = vec![(1.0, 0.25), (2.0, 1.0)];
        SteadyLaw { name, levels, period: 1.0, pitches: 1, start, speed, varies: true, curves: vec![] }
    }

    #[test]
    fn meshes_of_whole_tooth_numbers_have_a_common_period() {
        let (period, stretches) = stretches(&[course("a", 24.0, 0.0), course("b", -36.0, 0.5)]).unwrap();
        assert!((period - 2.0 / 24.0).abs() < 1e-15);
        let time = |which: usize| stretches.iter().filter(|s| s.levels[which] == 1.0).map(|s| s.time).sum::<f64>();
        let whole: f64 = stretches.iter().map(|s| s.time).sum();
        for part in [time(0), time(1)] {
            assert!((part - 0.25 * period).abs() < 1e-15, "a quarter of the time at the first level");
        }
        assert!((whole - period).abs() < 1e-15);
        // Two pitches of a and three of b have ten steps. One step of a coincides with one of b.
        assert_eq!(stretches.len(), 9);
    }

    #[test]
    fn incommensurate_periods_have_no_common_period() {
        let wrong = stretches(&[course("a", 1.0, 0.0), course("b", 2f64.sqrt(), 0.0)]).unwrap_err();
        assert!(matches!(wrong, Aperiodic::Incommensurate { first: "a", second: "b", .. }), "{wrong}");
    }
}
