//! Transmission errors, V = k (phi - e)²: compared with closed forms, with equations by hand and with another method; the phases of
//! planets; the energy account.

#[path = "transmission_error/by_hand.rs"]
mod by_hand;
mod common;
#[path = "transmission_error/planets.rs"]
mod planets;
#[path = "transmission_error/smooth.rs"]
mod smooth;
#[path = "transmission_error/steps.rs"]
mod steps;

use gearsim::run::Outcome;

/// Runs the gear pair of the paper with transmission errors and `overrides`.
fn run(overrides: &[&str]) -> Outcome {
    let mut all = vec![r#"effects=["stiffness_step", "transmission_error", "torques"]"#];
    all.extend(overrides);
    common::run(&common::scene("oh2005/energy_300rpm", &all.iter().map(|s| s.to_string()).collect::<Vec<_>>()))
}

/// The largest residual of the energy account T + V - W + D, relative to the energy at the start.
fn unaccounted(outcome: &Outcome) -> f64 {
    outcome.trajectory.residual.iter().fold(0.0f64, |m, r| m.max(r.abs())) / outcome.energy_at_start
}

/// M1 and M2 of the gear pair [1/(kg m²)].
fn mobilities() -> (f64, f64) {
    let (a, b) = (24f64.powi(2) / 2890e-6, 96f64.powi(2) / 740200e-6);
    ((a - b) / 2.0, (a + b) / 2.0)
}
