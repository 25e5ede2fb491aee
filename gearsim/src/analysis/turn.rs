//! The turn of a motion along which M and F change: the smallest shift of the turning coordinates after which the equations are the same.
//!
//! The shifts of the coordinates have the ratios of their speeds at the start. A turn is a whole number of periods of every law that turns.
//! If no law turns, the shift of the reference coordinate is a whole multiple or a whole part of 2 pi. The turn is found by comparing the
//! equations at shifted places.

use std::f64::consts::TAU;

use crate::analysis::steady::{self, SteadyLaw};
use crate::engine::Refusal;
use crate::engine::system::{Steady, System, are_same};
use crate::engine::vector::Vector;
use crate::scene::Scene;
use crate::tolerance::analysis::{FREQUENCY_RATIO, TURN_PITCHES};

/// A turn.
#[derive(Debug, Clone)]
pub struct Turn {
    /// Index of the coordinate by which it is counted: the phase of the first law that varies and turns, else the first coordinate that
    /// turns.
    pub reference: usize,
    /// Advance of every coordinate (n) \[SI\].
    pub shift: Vector,
    /// How long it takes at the speeds of the start \[s\].
    pub time: f64,
}

/// Parts of 2 pi that are tried where no law has a pitch.
const PARTS: [f64; 6] = [12.0, 6.0, 4.0, 3.0, 2.0, 1.0];

impl Turn {
    /// The turn of the motion of a scene; `None` if nothing turns, or if there is no turn after which the equations are the same.
    ///
    /// # Errors
    /// If the start of the scene cannot be determined.
    pub fn of(scene: &Scene, system: &System) -> Result<Option<Turn>, Refusal> {
        let Some(about) = system.steady() else { return Ok(None) };
        let courses: Vec<SteadyLaw> =
            steady::all_courses(scene, system)?.into_iter().filter(SteadyLaw::turns).collect();
        let first = scene.model.laws.iter().find(|law| courses.first().is_some_and(|course| course.name == law.name));
        let phase = first.and_then(|law| scene.model.coordinates.iter().position(|c| c.name == law.phase));
        let Some(reference) = phase.or_else(|| about.q_dot.iter().position(|v| *v != 0.0)) else { return Ok(None) };
        let speed = about.q_dot[reference];
        let sizes: Vec<f64> = match courses.first() {
            Some(course) => (1..=TURN_PITCHES).map(|m| f64::from(m) * course.period).collect(),
            None if scene.model.coordinates[reference].unit != "rad" => return Ok(None),
            None => {
                let whole = (2..=TURN_PITCHES).map(|m| f64::from(m) * TAU);
                PARTS.iter().map(|part| TAU / part).chain(whole).collect()
            }
        };
        let turn = |size: &f64| Turn { reference, shift: &about.q_dot * (size / speed), time: size / speed.abs() };
        let is_whole = |turn: &Turn| {
            courses.iter().all(|course| {
                let periods = turn.time * course.frequency();
                (periods - periods.round()).abs() <= FREQUENCY_RATIO * periods && periods.round() >= 1.0
            })
        };
        let flat = vec![0.0; scene.model.laws.len()];
        let k = scene.model.in_contact(about.means.iter().copied());
        Ok(sizes.iter().map(turn).find(|turn| is_whole(turn) && turn.returns(system, about, (&k, &flat))))
    }

    /// Whether the equations are the same after the turn, from several places.
    fn returns(&self, system: &System, about: &Steady, laws: (&[f64], &[f64])) -> bool {
        // Fractions of a turn at which symmetric equations have no zeros: at a zero only rounding errors would be compared.
        const PLACES: [f64; 3] = [0.137_035_999, 0.360_679_774, 0.618_033_988_7];
        PLACES.iter().all(|part| {
            let one = &about.q + &(&self.shift * *part);
            are_same(system.equations(), [&one, &(&one + &self.shift)], &about.q_dot, laws)
        })
    }
}
