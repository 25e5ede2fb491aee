//! A model with nonlinear cells, Duffing's oscillator, against its closed form.

use std::f64::consts::PI;

use crate::run::{Entry, Outcome};
use crate::scene::Scene;

mod duffing {
    gearsim::equations! {
        model duffing "a mass on a hardening spring, x + x^3 [N]";
        coordinates { x "m" start static, "deflection"; }
        parameters {
            m "kg" required, open 0.0 to inf, "mass";
            F "N" required, open -inf to inf, "pull";
        }
        energies {
            kinetic { _ => m*x_dot.powi(2)/2.0; }
            potential { _ => x.powi(2)/2.0; _ => x.powi(4)/4.0; }
        }
        torques { pull "the pull" { _ => F*x; } }
        work { x { _ => F; } }
        mass { x x { _ => m; } }
        force { x { _ => F - x; _ => -x.powi(3); } }
        jacobian { x x { _ => -1.0/m; _ => -3.0*x.powi(2)/m; } }
        nonlinear "x^4/4 in the potential energy";
    }
}

const ENTRY: Entry = Entry::new::<duffing::Duffing>();

fn run(method: &str, pull: f64, start: &str, t_end: f64) -> Outcome {
    let text = format!(
        "model = \"duffing\"\neffects = []\nparameters = {{ m = \"1 kg\", F = \"{pull:?} N\" }}\n{start}\n\
         [run]\nt_end = \"{t_end:?} s\"\ntolerance = 1e-12\n{method}"
    );
    let scene =
        Scene::parse("test", "test", &text, &[], &[ENTRY.model]).unwrap_or_else(|e| panic!("{}", e.render(100, false)));
    let outcome = ENTRY.run(&scene, &mut |_| {}).unwrap();
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// Its period at the amplitude a is 4 K(a²/(2 + 2 a²))/sqrt(1 + a²), with K computed by the arithmetic-geometric mean (Abramowitz
/// & Stegun 17.6). After three periods it is at its start again, without loss of energy, with every method.
#[test]
fn the_oscillator_returns_to_its_start_after_a_period() {
    for a in [0.1f64, 1.0, 3.0] {
        let m = a * a / (2.0 + 2.0 * a * a);
        let (mut x, mut y) = (1.0f64, (1.0 - m).sqrt());
        for _ in 0..6 {
            (x, y) = ((x + y) / 2.0, (x * y).sqrt());
        }
        let period = 4.0 * PI / (2.0 * x) / (1.0 + a * a).sqrt();
        for method in ["", "method = \"dopri5\"", "method = \"radau\""] {
            let outcome = run(method, 0.0, &format!("start.x = \"{a:?} m\""), 3.0 * period);
            let t = &outcome.trajectory;
            let (x, v) = (t.q[0][t.len() - 1], t.q_dot[0][t.len() - 1]);
            // Three periods have a few dozen steps each, at a tolerance of 1e-12.
            assert!((x - a).abs() < 1e-9 * a && v.abs() < 1e-9 * a * (1.0 + a), "{method} {a}: {x} {v}");
            let lost = t.residual.iter().fold(0.0f64, |m, r| m.max(r.abs()));
            assert!(lost < 1e-9 * outcome.energy_at_start, "{method} {a}: {lost}");
        }
    }
}

/// Static equilibrium under a force of 2 N: x + x³ = 2 at x = 1. It stays there, and the summary names the nonlinear term.
#[test]
fn the_oscillator_rests_in_static_equilibrium() {
    let outcome = run("", 2.0, "", 1.0);
    let t = &outcome.trajectory;
    assert!((t.q[0][0] - 1.0).abs() < 1e-14 && (t.q[0][t.len() - 1] - 1.0).abs() < 1e-12);
    assert_eq!(outcome.solver.method, "dop853");
    assert_eq!(outcome.solver.why, "cells are not linear: x^4/4 in the potential energy");
}
