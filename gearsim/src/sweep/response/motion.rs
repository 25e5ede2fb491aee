//! The rigid motion whose speed a response curve varies or keeps constant.

use super::super::{Error, Sweep};
use super::span::Span;
use crate::engine::equations::Equations;
use crate::engine::vector::{Vector, dot};
use crate::model::Start;
use crate::scene::Scene;
use crate::tolerance::analysis::HELD_PART;
use crate::trajectory::{Trajectory, value_at};

/// A rigid motion of the model. `unit` has the speeds of the coordinates at unit speed of the motion. `by` is the coordinate by which the
/// speed is measured.
pub(super) struct UnitMotion {
    pub unit: Vector,
    by: usize,
    /// Index of the motion, if its speed is varied.
    pub varied: Option<usize>,
}

impl UnitMotion {
    /// The motion whose speed is varied, else the first one of the model.
    pub(super) fn of(scene: &Scene, key: &str, sweep: &Sweep) -> Result<UnitMotion, Error> {
        let named = |name: &str| key.strip_prefix("start.") == Some(name);
        let varied = scene.model.motions.iter().position(|motion| named(motion.name));
        let equations = sweep
            .entry
            .equations(scene)
            .map_err(|refusal| Error::Impossible { what: refusal.to_string(), help: "choose other effects".into() })?;
        let unit = match scene.model.motions.is_empty() {
            true => Vector::zeros(equations.coordinates()),
            false => equations.motion(varied.unwrap_or(0)),
        };
        let by = (0..unit.len()).max_by(|&i, &j| unit[i].abs().total_cmp(&unit[j].abs())).unwrap_or(0);
        Ok(UnitMotion { unit, by, varied })
    }

    /// The speed that a scene states for it \[SI\]; 0 if it states none.
    pub(super) fn stated(&self, scene: &Scene) -> f64 {
        scene.start.motions.get(self.varied.unwrap_or(0)).copied().unwrap_or(0.0)
    }

    /// Its mean speed over the measured time of a run.
    pub(super) fn mean_speed(&self, run: &Trajectory, span: &Span) -> f64 {
        let place = &run.q[self.by];
        let last = run.row_from(span.end).min(run.len() - 1);
        (place[last] - value_at(&run.t, place, span.begin)) / span.time() / self.unit[self.by]
    }

    /// The time from the start of a run until less than [`HELD_PART`] of the speed `wanted` is left; `None` if the run keeps more.
    pub(super) fn until_lost(&self, run: &Trajectory, wanted: f64) -> Option<Span> {
        let speeds = run.q_dot[self.by].iter().map(|speed| speed / self.unit[self.by]);
        let lost = speeds.take(run.len()).position(|speed| speed / wanted < HELD_PART)?;
        let (begin, end) = (run.t[0], run.t[lost]);
        (end > begin).then_some(Span { begin, end, periods: 0, of: "" })
    }

    /// The generalised force on the motion at the speed `speed`, with all deflections zero and the mid stiffnesses.
    pub(super) fn force(&self, scene: &Scene, equations: &dyn Equations, speed: f64) -> f64 {
        let still = Vector::zeros(self.unit.len());
        let q_dot = &self.unit * speed;
        let (k, flat) = (scene.model.in_contact(scene.mids()), vec![0.0; scene.model.laws.len()]);
        dot(&self.unit, &equations.force(&still, &q_dot, &k, &flat))
    }

    /// Sets the start of a scene to the end of the run `before`, with the speed of the motion higher by `more`.
    pub(super) fn go_on(&self, scene: &mut Scene, before: &Trajectory, more: f64) {
        let last = |column: &Vec<f64>| column[column.len() - 1];
        scene.start.q = before.q.iter().map(|column| Start::At(last(column))).collect();
        scene.start.q_dot = before.q_dot.iter().zip(&*self.unit).map(|(v, unit)| Some(last(v) + more * unit)).collect();
    }

    /// Raises the start speed that a scene states by `more`.
    pub(super) fn faster(&self, scene: &mut Scene, more: f64) {
        if let Some(speed) = scene.start.motions.get_mut(self.varied.unwrap_or(0)) {
            *speed += more;
        }
    }
}
