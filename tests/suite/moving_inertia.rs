//! Inertia that depends on the coordinates, against closed forms and equations written by hand: a pendulum, a double pendulum, a
//! slider-crank and a universal joint; and the jump rule, held contact and derivatives with M(q).
mod common;
#[path = "moving_inertia/derivatives.rs"]
mod derivatives;
#[path = "moving_inertia/gears.rs"]
mod gears;
#[path = "moving_inertia/linearised.rs"]
mod linearised;
#[path = "moving_inertia/linkage.rs"]
mod linkages;
#[path = "moving_inertia/pendulums.rs"]
mod pendulums;

#[rustfmt::skip]
#[path = "newcomer/double_pendulum.rs"]
mod double_pendulum;
#[rustfmt::skip]
#[path = "newcomer/linkage.rs"]
mod linkage;
#[rustfmt::skip]
#[path = "newcomer/pendulum.rs"]
mod pendulum;

use gearsim::run::{Entry, Outcome};
use gearsim::scene::Scene;

/// A scene of one of the models of these tests.
fn scene(entry: &Entry, text: &str, overrides: &[&str]) -> Scene {
    let overrides: Vec<String> = overrides.iter().map(|s| s.to_string()).collect();
    Scene::parse("moving_inertia", "moving_inertia.toml", text, &overrides, &[entry.model])
        .unwrap_or_else(|errors| panic!("{}", errors.render(100, false)))
}

/// Runs such a scene; the run must reach its end.
fn run(entry: &Entry, text: &str, overrides: &[&str]) -> Outcome {
    let outcome = entry.run(&scene(entry, text, overrides), &mut |_| {}).expect("a scene that can be simulated");
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// The largest absolute value.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}
