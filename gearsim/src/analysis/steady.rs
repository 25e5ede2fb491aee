//! Steady rotation: every mesh phase moves on at the speed that the scene starts it with, and its laws are functions of time,
//! k(Omega0 t).

use crate::engine::equations::Switching;
use crate::engine::error::Refusal;
use crate::engine::system::System;
use crate::model::Law;
use crate::profile::Profile;
use crate::scene::Scene;

/// A law in steady rotation.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Name of its law.
    pub name: &'static str,
    /// Its levels, each with the phase at which it ends; the last ends at `period`.
    pub levels: Vec<(f64, f64)>,
    /// One pitch, or as many as a transmission error goes over [unit of the phase].
    pub period: f64,
    /// Phase at t = 0, from the beginning of the first level on.
    pub start: f64,
    /// Speed of the phase [unit of the phase/s].
    pub speed: f64,
    /// Whether it steps at all.
    pub steps: bool,
}

impl Course {
    /// Periods a second [Hz].
    pub fn frequency(&self) -> f64 {
        self.speed.abs() / self.period
    }

    /// Whether it steps as it turns.
    pub fn turns(&self) -> bool {
        self.steps && self.speed != 0.0
    }

    /// Its average over a period.
    pub fn mean(&self) -> f64 {
        let mut begin = 0.0;
        let part = |&(value, end): &(f64, f64)| {
            let width = end - begin;
            begin = end;
            value * width
        };
        self.levels.iter().map(part).sum::<f64>() / self.period
    }
}

/// The speeds q' that a scene starts with: those given, else those of its rigid motions.
pub fn speeds(scene: &Scene, system: &System) -> Vec<f64> {
    let mut speeds = vec![0.0; scene.model.coordinates.len()];
    for (i, size) in scene.start.motions.iter().enumerate() {
        speeds.iter_mut().zip(&*system.motion(i)).for_each(|(speed, unit)| *speed += size * unit);
    }
    for (speed, given) in speeds.iter_mut().zip(&scene.start.q_dot) {
        *speed = given.unwrap_or(*speed);
    }
    speeds
}

/// The stiffnesses of a scene in steady rotation, in the order of the model's laws.
///
/// # Errors
/// Where the start of the scene is not determined.
pub fn courses(scene: &Scene, system: &System) -> Result<Vec<Course>, Refusal> {
    let mut all = all_courses(scene, system)?;
    all.truncate(scene.stiffnesses().count());
    Ok(all)
}

/// All its laws: the stiffnesses, and after them the transmission errors, which a small disturbance does not feel.
///
/// # Errors
/// Where the start of the scene is not determined.
pub fn all_courses(scene: &Scene, system: &System) -> Result<Vec<Course>, Refusal> {
    let (begin, speeds) = (system.start(scene)?, speeds(scene, system));
    let course = |(i, (law, given)): (usize, (&'static Law, &Profile))| {
        let phase = scene.model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
        let steps = system.switching(i) != Switching::Never && given.steps.len() > 1;
        let period = law.period * f64::from(given.pitches);
        let mut end = 0.0;
        let mut levels: Vec<(f64, f64)> = given
            .steps
            .iter()
            .map(|step| {
                end += step.width;
                (step.value, end)
            })
            .collect();
        if !steps {
            levels = vec![(given.mid(), period)];
        } else if let Some(last) = levels.last_mut() {
            last.1 = period;
        }
        let start = (begin[phase] - given.origin).rem_euclid(period);
        Course { name: law.name, levels, period, start, speed: speeds[phase], steps }
    };
    Ok(scene.present().enumerate().map(course).collect())
}
