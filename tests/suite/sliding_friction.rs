//! Sliding friction between flanks: compared with a computation tooth pair by tooth pair, with forces as vectors and with a closed form
//! of the mean loss; symmetries and the energy account.

#[path = "sliding_friction/account.rs"]
mod account;
#[path = "sliding_friction/by_hand.rs"]
mod by_hand;
mod common;
#[path = "sliding_friction/everywhere.rs"]
mod everywhere;
#[path = "sliding_friction/forces.rs"]
mod forces;
#[path = "sliding_friction/loss.rs"]
mod loss;
#[path = "sliding_friction/standstill.rs"]
mod standstill;
#[path = "sliding_friction/steady.rs"]
mod steady;
#[path = "sliding_friction/sticking.rs"]
mod sticking;

use std::f64::consts::{PI, TAU};

use gearsim::run::Outcome;

/// Runs the gear pair given by its teeth, with friction and `overrides`.
fn run(overrides: &[&str]) -> Outcome {
    let mut all = vec![
        r#"effects=["stiffness_step", "sliding_friction", "torques"]"#,
        "parameters.mu=0.1",
        r#"laws.side={teeth_of="k"}"#,
        r#"laws.arm={teeth_of="k"}"#,
        "run.tolerance=1e-12",
        "output.rate=\"20 kHz\"",
    ];
    all.extend(overrides);
    common::run(&common::scene("gear_pair_teeth", &all.iter().map(|s| s.to_string()).collect::<Vec<_>>()))
}

/// The largest residual of the energy account T + V - W + D, relative to the energy at the start.
fn unaccounted(outcome: &Outcome) -> f64 {
    outcome.trajectory.residual.iter().fold(0.0f64, |m, r| m.max(r.abs())) / outcome.energy_at_start
}

/// The work of a torque at every row [J].
fn work<'a>(outcome: &'a Outcome, torque: &str) -> &'a [f64] {
    outcome.trajectory.work_of(torque).expect("a torque of the scene")
}

/// For each mesh the share of the run in modes in which its flanks stick.
fn stuck(outcome: &Outcome) -> Vec<f64> {
    let of = |times: &[(&str, f64)]| {
        let all: f64 = times.iter().map(|(_, time)| time).sum();
        times.iter().filter(|(mode, _)| mode.starts_with("stuck")).map(|(_, time)| time).sum::<f64>() / all
    };
    outcome.modes.iter().map(|(_, times)| of(times)).collect()
}

/// theta, phi and their speeds at a row.
fn state(outcome: &Outcome, row: usize) -> [f64; 4] {
    let t = &outcome.trajectory;
    [t.q[0][row], t.q[1][row], t.q_dot[0][row], t.q_dot[1][row]]
}

/// Standard involute gears with a pressure angle of 20 degrees: numbers of teeth and module [m].
struct Teeth {
    z: [f64; 2],
    module: f64,
}

impl Teeth {
    /// The gears of the scene `gear_pair_teeth`.
    const SCENE: Teeth = Teeth { z: [24.0, 96.0], module: 6.35e-3 };

    fn alpha(&self) -> f64 {
        20f64.to_radians()
    }

    /// Base radii [m].
    fn base(&self) -> [f64; 2] {
        self.z.map(|z| self.module * z / 2.0 * self.alpha().cos())
    }

    fn base_pitch(&self) -> f64 {
        PI * self.module * self.alpha().cos()
    }

    /// Lengths of the path of contact before and after the pitch point [m]. The tip of gear 2 limits the first, the tip of gear 1 the
    /// second.
    fn paths(&self) -> [f64; 2] {
        let path = |i: usize| {
            let (rb, ra) = (self.base()[i], self.module * (self.z[i] / 2.0 + 1.0));
            (ra * ra - rb * rb).sqrt() - rb * self.alpha().tan()
        };
        [path(1), path(0)]
    }

    /// The tooth pairs in contact at a phase [rad]; each is given by the number of pitches by which it is ahead of the phase.
    fn pairs(&self, phase: f64) -> Vec<f64> {
        let (p, [before, after]) = (self.base_pitch(), self.paths());
        let turns = (phase / TAU).round();
        let ahead = (-3..=3).map(|j| f64::from(j) - turns);
        ahead.filter(|j| (-before..after).contains(&((phase / TAU + j) * p))).collect()
    }
}
