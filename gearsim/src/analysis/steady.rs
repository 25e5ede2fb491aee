//! Steady rotation: every mesh phase has the constant speed of the scene's start, so that its laws are periodic functions of time,
//! k(Omega0 t).

use crate::engine::equations::Switching;
use crate::engine::error::Refusal;
use crate::engine::start::rigid_speeds;
use crate::engine::system::System;
use crate::model::{Law, Role};
use crate::profile::{Curve, Profile};
use crate::scene::Scene;
use crate::tolerance::analysis::STRAINED;

/// A law in steady rotation.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyLaw {
    /// Name of the law.
    pub name: &'static str,
    /// Its levels [SI unit of the law], each with the phase at which it ends; the last ends at `period`.
    pub levels: Vec<(f64, f64)>,
    /// Period of the law [unit of the phase]: one pitch, or several for a transmission error.
    pub period: f64,
    /// Pitches in a period: more than one for a transmission error, or with damaged teeth.
    pub pitches: u32,
    /// Phase at t = 0, counted from the beginning of the first level [unit of the phase].
    pub start: f64,
    /// Speed of the phase [unit of the phase/s].
    pub speed: f64,
    /// Whether it varies with its phase in the scene's equations; else it is constant at its mid value.
    pub varies: bool,
    /// The curve of each level; empty if the law is constant in each.
    pub curves: Vec<Curve>,
}

impl SteadyLaw {
    /// Pitches per second [Hz].
    pub fn mesh_frequency(&self) -> f64 {
        self.frequency() * f64::from(self.pitches)
    }

    /// Periods per second [Hz].
    pub fn frequency(&self) -> f64 {
        self.speed.abs() / self.period
    }

    /// Whether it varies and its phase moves.
    pub fn turns(&self) -> bool {
        self.varies && self.speed != 0.0
    }

    /// The index of its cell at the time `t` [s], and the phase there.
    fn cell(&self, t: f64) -> (usize, f64) {
        let phase = (self.start + self.speed * t).rem_euclid(self.period);
        (self.levels.iter().position(|(_, end)| phase < *end).unwrap_or(self.levels.len() - 1), phase)
    }

    /// The level of its cell at the time `t` [s]; of a curve the mean in the cell [SI unit of the law].
    pub fn level(&self, t: f64) -> f64 {
        self.levels[self.cell(t).0].0
    }

    /// Its value at the time `t` [s] [SI unit of the law].
    pub fn at(&self, t: f64) -> f64 {
        let (here, phase) = self.cell(t);
        let begin = if here == 0 { 0.0 } else { self.levels[here - 1].1 };
        self.curves.get(here).map_or(self.levels[here].0, |curve| curve.at(phase - begin)[0])
    }

    /// Its smallest and its largest value [SI unit of the law].
    pub fn extremes(&self) -> (f64, f64) {
        let mut begin = 0.0;
        let cells = self.levels.iter().enumerate().map(|(i, &(value, end))| {
            let width = end - begin;
            begin = end;
            self.curves.get(i).map_or((value, value), |curve| curve.extremes(width))
        });
        cells.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (a, b)| (low.min(a), high.max(b)))
    }

    /// The highest harmonic of its curves; 0 if it has none.
    pub fn highest_order(&self) -> f64 {
        self.curves.iter().map(Curve::highest_order).fold(0.0, f64::max)
    }

    /// Its mean over a period [SI unit of the law].
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

/// The speeds q' at the start of a scene (n) [SI]: those given, else those of its rigid motions.
pub fn speeds(scene: &Scene, system: &System) -> Vec<f64> {
    let mut speeds = rigid_speeds(system.equations(), scene).to_vec();
    for (speed, given) in speeds.iter_mut().zip(&scene.start.q_dot) {
        *speed = given.unwrap_or(*speed);
    }
    speeds
}

/// Whether springs act against the rigid motions at the speeds of the scene, e.g. a spring to the ground. `k` are the law values \[SI\].
///
/// # Errors
/// [`Refusal`] if the cell has no matrices.
pub fn is_held(scene: &Scene, system: &System, k: &[f64]) -> Result<bool, Refusal> {
    let stiffness = system.matrices(k)?.stiffness;
    let speeds = rigid_speeds(system.equations(), scene);
    let held = |i: usize| {
        let terms = speeds.iter().enumerate().map(|(j, speed)| stiffness[(i, j)] * speed);
        let (force, size) = terms.fold((0.0, 0.0f64), |(sum, size), term| (sum + term, size + term.abs()));
        f64::abs(force) > STRAINED * size
    };
    Ok((0..speeds.len()).any(held))
}

/// The stiffnesses of a scene in steady rotation, in the order of the model's laws.
///
/// # Errors
/// [`Refusal`] if the start of the scene cannot be determined.
pub fn courses(scene: &Scene, system: &System) -> Result<Vec<SteadyLaw>, Refusal> {
    let mut all = all_courses(scene, system)?;
    all.truncate(scene.stiffnesses().count());
    Ok(all)
}

/// The laws that act on small disturbances: the stiffnesses and, if the equations are linearised about a steady motion, the laws of
/// friction. Transmission errors are set to zero in that case.
///
/// # Errors
/// [`Refusal`] if the start of the scene cannot be determined.
pub fn acting(scene: &Scene, system: &System) -> Result<Vec<SteadyLaw>, Refusal> {
    if system.steady().is_none() {
        return courses(scene, system);
    }
    let mut all = all_courses(scene, system)?;
    for (course, _) in all.iter_mut().zip(scene.present()).filter(|(_, (law, _))| law.role == Role::Error) {
        *course = SteadyLaw { levels: vec![(0.0, course.period)], varies: false, curves: vec![], ..course.clone() };
    }
    Ok(all)
}

/// All laws of a scene in steady rotation, the stiffnesses first. Transmission errors do not act on small disturbances.
///
/// # Errors
/// [`Refusal`] if the start of the scene cannot be determined.
pub fn all_courses(scene: &Scene, system: &System) -> Result<Vec<SteadyLaw>, Refusal> {
    let (begin, speeds) = (system.start(scene)?, speeds(scene, system));
    let course = |(i, (law, given)): (usize, (&'static Law, &Profile))| {
        let phase = scene.model.coordinates.iter().position(|c| c.name == law.phase).unwrap_or(0);
        let varies = system.switching(i) != Switching::Never && (given.steps.len() > 1 || !given.steps_only());
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
        if !varies {
            levels = vec![(given.mid(), period)];
        } else if let Some(last) = levels.last_mut() {
            last.1 = period;
        }
        let start = (begin[phase] - given.origin).rem_euclid(period);
        let curves = if varies { given.curves.clone() } else { vec![] };
        SteadyLaw {
            name: law.name,
            levels,
            period,
            pitches: given.pitches,
            start,
            speed: speeds[phase],
            varies,
            curves,
        }
    };
    Ok(scene.present().enumerate().map(course).collect())
}
