//! Equations of motion of `cracked_rotor`: a rotor on a spring that another rotor switches, with a cracked tooth.
//!
//! Derived from the energies in `models/src/cracked_rotor.rs` by `cargo xtask derive cracked_rotor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/cracked_rotor.txt`, `latex/cracked_rotor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model cracked_rotor "a rotor on a spring that another rotor switches, with a cracked tooth";
    source "the guide to models";

    coordinates {
        alpha "rad" start 0.0, "angle of the switching rotor";
        beta "rad" start static, "angle of the sprung rotor";
    }
    parameters {
        J1 "kg*m^2" default 1.0, open 0.0 to inf, "moment of inertia of the switching rotor";
        J2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sprung rotor";
    }
    laws {
        c "N*m" phase alpha period 3.0 rolling, "stiffness that the crack takes, once in three pitches";
        k "N*m" phase alpha period 1.0 rolling, "stiffness of the spring to the ground";
        g "N*m" phase alpha period 0.75 rolling, "stiffness of a second mesh";
    }
    motions { speed "rad/s" { alpha_dot = 1.0; }, "rotational speed of the switching rotor"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
    }
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
    }

    energies {
        kinetic { _ => (J1*alpha_dot.powi(2) + J2*beta_dot.powi(2))/2.0; }
        potential { _ => beta.powi(2)*(g - c + k)/2.0; }
    }
    torques {
    }
    work {
    }
    mass {
        alpha alpha { _ => J1; }
        beta beta { _ => J2; }
    }
    mobility {
        alpha alpha { _ => 1.0/J1; }
        beta beta { _ => 1.0/J2; }
    }
    force {
        alpha { jump_terms => (dc*beta.powi(2) - dg*beta.powi(2) - dk*beta.powi(2))/2.0; }
        beta { _ => c*beta - g*beta - k*beta; }
    }
    jacobian {
        alpha alpha { jump_terms => (ddc*beta.powi(2) - ddg*beta.powi(2) - ddk*beta.powi(2))/2.0; }
        alpha beta { jump_terms => dc*beta - dg*beta - dk*beta; }
        beta alpha { moving_phase => dc*beta - dg*beta - dk*beta; }
        beta beta { _ => c - g - k; }
    }
    cell {
        stiffness { beta beta { _ => g - c + k; } }
        damping {
        }
        load {
        }
    }
    jump c {
        compliance { _ => 1.0/J1; }
        direction { alpha { _ => 1.0; } }
        step { _ => -dc*beta.powi(2)/2.0; }
    }
    jump k {
        compliance { _ => 1.0/J1; }
        direction { alpha { _ => 1.0; } }
        step { _ => dk*beta.powi(2)/2.0; }
    }
    jump g {
        compliance { _ => 1.0/J1; }
        direction { alpha { _ => 1.0; } }
        step { _ => dg*beta.powi(2)/2.0; }
    }

    text "text/cracked_rotor.txt";
    latex "latex/cracked_rotor.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - at a step of c, k, g: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - without the jump terms the balance fails: energy is created at the rate (dg*beta^2*alpha_dot - dc*beta^2*alpha_dot +
//   dk*beta^2*alpha_dot)/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 4 | 12 | 0 |
// | acceleration | 4 | 18 | 0 |
// | energy steps, all laws | 0 | 9 | 0 |
