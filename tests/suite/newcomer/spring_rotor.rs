//! Equations of motion of `spring_rotor`: a rotor on a spring that another rotor switches.
//!
//! Derived from the energies in `models/src/spring_rotor.rs` by `cargo xtask derive spring_rotor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/spring_rotor.txt`, `latex/spring_rotor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model spring_rotor "a rotor on a spring that another rotor switches";
    source "the guide to models";

    coordinates {
        alpha "rad" start 0.0, "angle of the switching rotor";
        beta "rad" start static, "angle of the sprung rotor";
    }
    parameters {
        J1 "kg*m^2" default 1.0, open 0.0 to inf, "moment of inertia of the switching rotor";
        J2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sprung rotor";
        T1 "N*m" default 0.0, open -inf to inf, "torque on the switching rotor";
    }
    laws { k "N*m" phase alpha period 1.0 rolling, "stiffness of the spring to the ground"; }
    motions { speed "rad/s" { alpha_dot = 1.0; }, "rotational speed of the switching rotor"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        torque "constant torque on the switching rotor";
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
        potential { _ => k*beta.powi(2)/2.0; }
    }
    torques { drive "torque T1 on the switching rotor" { torque => T1*alpha; } }
    work { alpha { torque => T1; } }
    mass {
        alpha alpha { _ => J1; }
        beta beta { _ => J2; }
    }
    mobility {
        alpha alpha { _ => 1.0/J1; }
        beta beta { _ => 1.0/J2; }
    }
    force {
        alpha {
            torque => T1;
            jump_terms => -dk*beta.powi(2)/2.0;
        }
        beta { _ => -k*beta; }
    }
    jacobian {
        alpha alpha { jump_terms => -ddk*beta.powi(2)/2.0; }
        alpha beta { jump_terms => -dk*beta; }
        beta alpha { moving_phase => -dk*beta; }
        beta beta { _ => -k; }
    }
    cell {
        stiffness { beta beta { _ => k; } }
        damping {
        }
        load { alpha { torque => T1; } }
    }
    jump k {
        compliance { _ => 1.0/J1; }
        direction { alpha { _ => 1.0; } }
        step { _ => dk*beta.powi(2)/2.0; }
    }
    outputs { power_drive "W" with torque, "power of the torque T1 on the switching rotor: positive if it drives" { _ => drive_power; } }

    text "text/spring_rotor.txt";
    latex "latex/spring_rotor.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - at a step of k: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission
//   (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - without the jump terms the balance fails: energy is created at the rate dk*beta^2*alpha_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 4 | 0 |
// | acceleration | 0 | 7 | 0 |
// | energy steps, all laws | 0 | 3 | 0 |
