//! Runs of the references' gear pair in the engine, with their events in the form that the references use.

use std::sync::OnceLock;

use gearsim::__private::equations::{DerivedModel, Equations};
use gearsim::__private::models;
use gearsim::model::Start;
use gearsim::run::Outcome;
use gearsim::scene::{InitialState, Scene, Step};
use gearsim::trajectory::Moment;
use gearsim_tests::oh2005::{Event, GearPair, Kind, PITCH, State};

use crate::case::largest;
use crate::common;

/// A run of the engine: its events, with cells counted as in the references, its end, and its outcome.
pub struct Run {
    pub events: Vec<Event>,
    pub end: State,
    pub outcome: Outcome,
}

/// The scene of a gear pair from `start` to `t_end` \[s\].
pub fn scene(pair: &GearPair, start: &State, t_end: f64) -> Scene {
    static SCENE: OnceLock<Scene> = OnceLock::new();
    let mut scene = SCENE.get_or_init(|| common::scene("oh2005/energy_300rpm", &[])).clone();
    scene.parameters[..6].copy_from_slice(&[pair.n1, pair.n2, pair.i1, pair.i2, pair.zeta, pair.t0]);
    let steps = [(pair.k1, pair.width1), (pair.k2, PITCH - pair.width1)];
    scene.laws[0].steps = steps.map(|(value, width)| Step { value, width }).into();
    scene.start = InitialState {
        q: vec![Start::At(start.theta), Start::At(start.phi)],
        q_dot: vec![Some(start.theta_dot), Some(start.phi_dot)],
        motions: vec![0.0],
    };
    scene.t_end = t_end;
    scene.output.rate = 1.0 / t_end;
    scene
}

/// The equations of a gear pair with the effects of [`scene`].
pub fn equations(pair: &GearPair) -> Box<dyn Equations> {
    DerivedModel::of::<models::GearPair>()
        .equations(&scene(pair, &pair.start(0.0), 1.0))
        .expect("effects that go together")
}

/// The values of the laws and switches of the gear pair in a cell of stiffness `k` \[N m\]. All other values are not read and are NaN.
pub fn values(k: f64) -> [f64; 9] {
    std::array::from_fn(|i| if i == 0 { k } else { f64::NAN })
}

/// Runs a gear pair in the engine. A run that stops early has the events until then.
pub fn run(pair: &GearPair, start: &State, t_end: f64) -> Run {
    of(&scene(pair, start, t_end))
}

/// Runs a scene with two steps per pitch.
pub fn of(scene: &Scene) -> Run {
    let outcome = common::model(scene.model.name).run(scene, &mut |_| {}).unwrap_or_else(|e| panic!("{e}"));
    let t = &outcome.trajectory;
    let width = scene.laws[0].steps[0].width;
    let befores = (0..t.len()).filter(|&i| t.moment[i] == Moment::Before);
    let events = befores.map(|i| {
        // Boundary 2 n is at n pitches, 2 n + 1 one width beyond.
        let pitches = t.q[0][i] / PITCH;
        let (whole, odd) = (pitches.round(), (t.q[0][i] - width) / PITCH);
        let boundary = match (pitches - whole).abs() <= (odd - odd.round()).abs() {
            true => 2 * whole as i64,
            false => 2 * odd.round() as i64 + 1,
        };
        let (before, after) = (t.q_dot[0][i], t.q_dot[0][i + 1]);
        // A reflection reverses the speed. A phase that comes to rest on the step counts as transmitted.
        let kind = if before * after < 0.0 { Kind::Reflect } else { Kind::Transmit };
        let (from, beyond) = if before > 0.0 { (boundary - 1, boundary) } else { (boundary, boundary - 1) };
        Event { t: t.t[i], kind, cell_from: from, cell_to: if kind == Kind::Reflect { from } else { beyond } }
    });
    let last = t.len() - 1;
    let end = State { theta: t.q[0][last], theta_dot: t.q_dot[0][last], phi: t.q[1][last], phi_dot: t.q_dot[1][last] };
    Run { events: events.collect(), end, outcome }
}

/// The largest difference of two states, each component relative to its size in this motion.
pub fn distance(a: &State, b: &State, pair: &GearPair, speed: f64) -> f64 {
    let phi = pair.t0.abs().max(1.0) / pair.k1;
    let speeds = speed.abs().max(phi * pair.w0());
    let parts = [(a.theta, b.theta, 1.0), (a.phi, b.phi, phi)];
    let rates = [(a.theta_dot, b.theta_dot, speeds), (a.phi_dot, b.phi_dot, speeds)];
    largest(parts.into_iter().chain(rates).map(|(a, b, size)| (a - b).abs() / size))
}
