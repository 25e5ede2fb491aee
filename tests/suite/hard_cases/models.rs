//! Small models with closed forms, written by hand in the form of derived files.

use gearsim::run::{Entry, Outcome};
use gearsim::scene::Scene;

/// Runs a scene of one of these models to its end.
pub fn run(entry: &Entry, text: &str) -> Outcome {
    let scene = Scene::parse("case", "case.toml", text, &[], &[entry.model])
        .unwrap_or_else(|errors| panic!("{}", errors.render(100, false)));
    let outcome = entry.run(&scene, &mut |_| {}).expect("a scene that can be simulated");
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// q and q' at the end.
pub fn end(outcome: &Outcome) -> (Vec<f64>, Vec<f64>) {
    let last = |columns: &[Vec<f64>]| columns.iter().map(|c| *c.last().expect("a run has an end")).collect();
    (last(&outcome.trajectory.q), last(&outcome.trajectory.q_dot))
}

/// The largest residual of the energy account, relative to the energy at the start.
pub fn residual(outcome: &Outcome) -> f64 {
    crate::case::largest(outcome.trajectory.residual.iter().map(|r| r.abs())) / outcome.energy_at_start
}

/// A damped rotor under a torque. The spring of a second, loaded rotor becomes stiffer at a step in the angle of the first. The torque
/// presses the first rotor against this step, which reflects it.
pub mod pressed {
    gearsim::equations! {
        model pressed "a rotor pressed against a step";
        coordinates { alpha "rad" start 0.0, "switching rotor"; beta "rad" start static, "sprung rotor"; }
        parameters {
            T "N*m" required, open -inf to inf, "torque on the switching rotor";
            load "N*m" required, open -inf to inf, "torque on the sprung rotor";
            c "N*m*s" default 0.0, from 0.0 to inf, "damping of the switching rotor";
        }
        laws { k "N*m" phase alpha period 1.0 rolling, "spring"; }
        effects { stiffness_step "steps"; }
        switching { stiffness_step => with_jump; }
        energies {
            kinetic { _ => (alpha_dot.powi(2) + beta_dot.powi(2))/2.0; }
            potential { _ => k*beta.powi(2)/2.0; }
            dissipation { _ => c*alpha_dot.powi(2)/2.0; }
        }
        torques { drive "drive" { _ => T*alpha; } pull "pull" { _ => load*beta; } }
        work { alpha { _ => T; } beta { _ => load; } }
        mass { alpha alpha { _ => 1.0; } beta beta { _ => 1.0; } }
        force { alpha { _ => T - c*alpha_dot; } beta { _ => load - k*beta; } }
        jacobian {}
        cell {
            stiffness { beta beta { _ => k; } }
            damping { alpha alpha { _ => c; } }
            load { alpha { _ => T; } beta { _ => load; } }
        }
        jump k { normal { alpha { _ => 1.0; } } step { _ => dk*beta.powi(2)/2.0; } }
    }
}

/// As `pressed`, without a load. The zero of the spring steps too, with a longer period: at some steps of the spring both step, at
/// others the spring alone.
pub mod shifted {
    gearsim::equations! {
        model shifted "a rotor pressed against steps of a spring and of its zero";
        coordinates { alpha "rad" start 0.0, "switching rotor"; beta "rad" start 0.5, "sprung rotor"; }
        parameters {
            T "N*m" required, open -inf to inf, "torque on the switching rotor";
            c "N*m*s" default 0.0, from 0.0 to inf, "damping of the switching rotor";
        }
        laws {
            k "N*m" phase alpha period 1.0, "spring";
            e "rad" phase alpha period 2.0 with uneven, "zero of the spring";
        }
        effects { stiffness_step "steps of the spring"; uneven requires(stiffness_step) "steps of its zero"; }
        switching { stiffness_step => with_jump; }
        energies {
            kinetic { _ => (alpha_dot.powi(2) + beta_dot.powi(2))/2.0; }
            potential { _ => k*(beta - e).powi(2)/2.0; }
            dissipation { _ => c*alpha_dot.powi(2)/2.0; }
        }
        torques { drive "drive" { _ => T*alpha; } }
        work { alpha { _ => T; } }
        mass { alpha alpha { _ => 1.0; } beta beta { _ => 1.0; } }
        force { alpha { _ => T - c*alpha_dot; } beta { _ => -k*(beta - e); } }
        jacobian {}
        cell {
            stiffness { beta beta { _ => k; } }
            damping { alpha alpha { _ => c; } }
            load { alpha { _ => T; } beta { _ => k*e; } }
        }
        jump k { normal { alpha { _ => 1.0; } } step { _ => dk*(beta - e).powi(2)/2.0; } }
        jump e { normal { alpha { _ => 1.0; } } step { _ => k*(de.powi(2)/2.0 - de*(beta - e)); } }
    }
}

/// Two springs on one rotor; both step with the same angle.
pub mod twice {
    gearsim::equations! {
        model twice "two springs that step together";
        coordinates { alpha "rad" start 0.0, "switching rotor"; beta "rad" start 0.3, "sprung rotor"; }
        laws {
            k "N*m" phase alpha period 1.0 rolling, "first spring";
            l "N*m" phase alpha period 1.0 rolling, "second spring";
        }
        effects { stiffness_step "steps"; }
        switching { stiffness_step => with_jump; }
        energies {
            kinetic { _ => (alpha_dot.powi(2) + beta_dot.powi(2))/2.0; }
            potential { _ => (k + l)*beta.powi(2)/2.0; }
        }
        mass { alpha alpha { _ => 1.0; } beta beta { _ => 1.0; } }
        force { alpha {} beta { _ => -(k + l)*beta; } }
        jacobian {}
        cell { stiffness { beta beta { _ => k + l; } } }
        jump k { normal { alpha { _ => 1.0; } } step { _ => dk*beta.powi(2)/2.0; } }
        jump l { normal { alpha { _ => 1.0; } } step { _ => dl*beta.powi(2)/2.0; } }
    }
}

/// Two switching rotors, coupled by inertia, and a third rotor on two springs. Each spring steps with the angle of one switching rotor.
pub mod meshes {
    gearsim::equations! {
        model meshes "two meshes on one spring";
        coordinates {
            alpha "rad" start 0.0, "first switching rotor";
            gamma "rad" start 0.0, "second switching rotor";
            beta "rad" start 0.3, "sprung rotor";
        }
        parameters { mu "kg*m^2" required, open -1.0 to 1.0, "inertia that couples the switching rotors"; }
        laws {
            k "N*m" phase alpha period 1.0 rolling, "first mesh";
            l "N*m" phase gamma period 1.0 rolling, "second mesh";
        }
        effects { stiffness_step "steps"; }
        switching { stiffness_step => with_jump; }
        energies {
            kinetic { _ => (alpha_dot.powi(2) + gamma_dot.powi(2) + beta_dot.powi(2))/2.0 + mu*alpha_dot*gamma_dot; }
            potential { _ => (k + l)*beta.powi(2)/2.0; }
        }
        mass {
            alpha alpha { _ => 1.0; }
            gamma gamma { _ => 1.0; }
            alpha gamma { _ => mu; }
            beta beta { _ => 1.0; }
        }
        force { alpha {} gamma {} beta { _ => -(k + l)*beta; } }
        jacobian {}
        cell { stiffness { beta beta { _ => k + l; } } }
        jump k { normal { alpha { _ => 1.0; } } step { _ => dk*beta.powi(2)/2.0; } }
        jump l { normal { gamma { _ => 1.0; } } step { _ => dl*beta.powi(2)/2.0; } }
    }
}
