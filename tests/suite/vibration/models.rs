//! A small model whose damping couples its modes, written by hand in the form of a derived file.

use gearsim::run::Entry;
use gearsim::scene::Scene;

/// A rotor under a torque. Its angle switches the spring of a second, loaded rotor, to which a third is coupled by a spring. One
/// damper is between the first two rotors, one between the third and the ground.
mod dampers {
    gearsim::equations! {
        model dampers "three rotors on springs and dampers";
        coordinates {
            alpha "rad" start 0.0, "switching rotor";
            beta "rad" start 0.3, "sprung rotor";
            gamma "rad" start 0.1, "rotor on it";
        }
        parameters {
            J "kg*m^2" default 0.5, open 0.0 to inf, "inertia of the third rotor";
            K "N*m" default 20.0, open 0.0 to inf, "spring between second and third";
            T "N*m" default 0.0, open -inf to inf, "torque on the first";
            load "N*m" default 0.0, open -inf to inf, "torque on the second";
            c1 "N*m*s" default 0.0, from 0.0 to inf, "damper between first and second";
            c2 "N*m*s" default 0.0, from 0.0 to inf, "damper from third to ground";
        }
        laws { k "N*m" phase alpha period 1.0 rolling, "spring of the second"; }
        motions { speed "rad/s" { alpha_dot = 1.0; }, "speed of the first rotor"; }
        effects { stiffness_step "steps"; }
        switching { stiffness_step => with_jump; }
        energies {
            kinetic { _ => (alpha_dot.powi(2) + beta_dot.powi(2) + J*gamma_dot.powi(2))/2.0; }
            potential { _ => (k*beta.powi(2) + K*(gamma - beta).powi(2))/2.0; }
            dissipation { _ => (c1*(alpha_dot - beta_dot).powi(2) + c2*gamma_dot.powi(2))/2.0; }
        }
        torques { drive "drive" { _ => T*alpha; } pull "pull" { _ => load*beta; } }
        work { alpha { _ => T; } beta { _ => load; } gamma {} }
        mass { alpha alpha { _ => 1.0; } beta beta { _ => 1.0; } gamma gamma { _ => J; } }
        force {
            alpha { _ => T - c1*(alpha_dot - beta_dot); }
            beta { _ => load - k*beta + K*(gamma - beta) + c1*(alpha_dot - beta_dot); }
            gamma { _ => -K*(gamma - beta) - c2*gamma_dot; }
        }
        jacobian {}
        cell {
            stiffness { beta beta { _ => k + K; } beta gamma { _ => -K; } gamma gamma { _ => K; } }
            damping {
                alpha alpha { _ => c1; }
                alpha beta { _ => -c1; }
                beta beta { _ => c1; }
                gamma gamma { _ => c2; }
            }
            load { alpha { _ => T; } beta { _ => load; } }
        }
        jump k { normal { alpha { _ => 1.0; } } step { _ => dk*beta.powi(2)/2.0; } }
    }
}

pub const DAMPERS: Entry = Entry::new::<dampers::Dampers>();

/// The stiffness levels [N m] over one period of alpha, which is 1 rad, and the alpha at which the first ends [rad].
pub const LEVELS: [f64; 2] = [5.0, 50.0];
pub const FIRST_ENDS: f64 = 0.4;

/// A scene of the model; `more` sets parameters, start and run.
pub fn scene(more: &str) -> Scene {
    let text = format!(
        "model = \"dampers\"\neffects = [\"stiffness_step\"]\n\
         laws.k.steps = [{{ value = \"{:?} N*m\", width = \"{FIRST_ENDS} rad\" }}, {{ value = \"{:?} N*m\" }}]\n{more}\n",
        LEVELS[0], LEVELS[1]
    );
    Scene::parse("dampers", "dampers.toml", &text, &[], &[DAMPERS.model])
        .unwrap_or_else(|errors| panic!("{}", errors.render(100, false)))
}
