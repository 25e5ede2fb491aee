//! Steady rotation: every mesh phase moves on at the speed that the scene starts it with, and its stiffness is a function
//! of time, k(Omega0 t).

use crate::engine::equations::Switching;
use crate::engine::system::System;
use crate::model::{Law, Start};
use crate::scene::{Scene, Stiffness};

/// A stiffness in steady rotation.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Name of its law.
    pub name: &'static str,
    /// Levels over one pitch, each with the phase at which it ends; the last ends at `period`.
    pub levels: Vec<(f64, f64)>,
    /// One pitch [unit of the phase].
    pub period: f64,
    /// Phase at t = 0, from the beginning of the first level on.
    pub start: f64,
    /// Speed of the phase [unit of the phase/s].
    pub speed: f64,
    /// Whether it steps at all.
    pub steps: bool,
}

impl Course {
    /// Pitches a second [Hz].
    pub fn frequency(&self) -> f64 {
        self.speed.abs() / self.period
    }

    /// Its average over a pitch.
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
pub fn speeds(scene: &Scene, system: &dyn System) -> Vec<f64> {
    let mut speeds = vec![0.0; scene.model.coordinates.len()];
    for (i, size) in scene.start.motions.iter().enumerate() {
        speeds.iter_mut().zip(system.motion(i)).for_each(|(speed, unit)| *speed += size * unit);
    }
    for (speed, given) in speeds.iter_mut().zip(&scene.start.q_dot) {
        *speed = given.unwrap_or(*speed);
    }
    speeds
}

/// The stiffnesses of a scene in steady rotation, in the order of the model's laws. Transmission errors are none: a small
/// disturbance does not feel them.
pub fn courses(scene: &Scene, system: &dyn System) -> Vec<Course> {
    let speeds = speeds(scene, system);
    let course = |(i, (law, given)): (usize, (&'static Law, &Stiffness))| {
        let phase = scene.model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
        let begin = match scene.start.q[phase] {
            Start::At(x) => x,
            Start::Static => 0.0,
        };
        let steps = system.switching(i) != Switching::Never && given.steps.len() > 1;
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
            levels = vec![(given.mid(), law.period)];
        } else if let Some(last) = levels.last_mut() {
            last.1 = law.period;
        }
        Course {
            name: law.name,
            levels,
            period: law.period,
            start: (begin - given.origin).rem_euclid(law.period),
            speed: speeds[phase],
            steps,
        }
    };
    scene.stiffnesses().enumerate().map(course).collect()
}
