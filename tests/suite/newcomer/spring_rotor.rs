//! Equations of motion of `spring_rotor`: a rotor on a spring that another rotor switches.
//!
//! Derived from the energies in `models/src/spring_rotor.rs` by `cargo xtask derive spring_rotor`. Do not edit: change the
//! energies and derive again.
//! Source: the guide to models
//!
//! # Energies
//!
//! ```text
//! T = (J1*alpha_dot^2 + J2*beta_dot^2)/2
//! V = k*beta^2/2
//! D = 0
//! Q_alpha = T1 [torque]
//! Q_beta = 0
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! alpha'' = T1/J1 [torque] - dk*beta^2/(2*J1) [jump terms]
//! beta'' = -k*beta/J2
//! ```
//!
//! # At a step of a stiffness
//!
//! ```text
//! at a step dk of k in alpha, transmission if alpha_dot+^2 >= 0:
//! alpha_dot+^2 = alpha_dot-^2 - dk*beta^2/J1
//! else reflection: alpha_dot+ = -alpha_dot-, and the stiffness does not step
//! ```
//!
//! # Between two steps
//!
//! ```text
//! M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly
//! ```
//!
//! # LaTeX
//!
//! ```latex
//! T = \frac{1}{2} (J_{1}\, \dot{\alpha}^{2} + J_{2}\, \dot{\beta}^{2})
//! V = \frac{k\, \beta^{2}}{2}
//! D = 0
//! Q_{\alpha} = T_{1}\ [\text{torque}]
//! Q_{\beta} = 0
//! \ddot{\alpha} = \frac{T_{1}}{J_{1}}\ [\text{torque}] - \frac{k'\, \beta^{2}}{2\, J_{1}}\ [\text{jump terms}]
//! \ddot{\beta} = -\frac{k\, \beta}{J_{2}}
//! \dot{\alpha}_+^2 = \dot{\alpha}_-^2 - \frac{\Delta k\, \beta^{2}}{J_{1}}
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: every leading minor is a sum of products of positive quantities
//! - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
//! - at a step of k: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
//! - without the jump terms the balance fails: energy is created at the rate dk*beta^2*alpha_dot/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | force | 0 | 4 | 0 |
//! | acceleration | 0 | 7 | 0 |
//! | energy step of k | 0 | 3 | 0 |

use gearsim_macros::equations;

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
    laws {
        k "N*m" phase alpha period 1.0 rolling, "stiffness of the spring to the ground";
    }
    motions {
        speed "rad/s" { alpha_dot = 1.0; }, "rotational speed of the switching rotor";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        torque "constant torque on the switching rotor";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
    }

    energies {
        kinetic {
            _ => (J1*alpha_dot.powi(2) + J2*beta_dot.powi(2))/2.0;
        }
        potential {
            _ => k*beta.powi(2)/2.0;
        }
    }
    torques {
        drive "torque T1 on the switching rotor" {
            torque => T1*alpha;
        }
    }
    work {
        alpha {
            torque => T1;
        }
        beta {}
    }
    mass {
        alpha alpha {
            _ => J1;
        }
        beta beta {
            _ => J2;
        }
    }
    mobility {
        alpha alpha {
            _ => 1.0/J1;
        }
        beta beta {
            _ => 1.0/J2;
        }
    }
    force {
        alpha {
            torque => T1;
            jump_terms => -dk*beta.powi(2)/2.0;
        }
        beta {
            _ => -k*beta;
        }
    }
    jacobian {
        alpha alpha {
            jump_terms => -ddk*beta.powi(2)/2.0;
        }
        alpha beta {
            jump_terms => -dk*beta;
        }
        beta alpha {
            moving_phase => -dk*beta;
        }
        beta beta {
            _ => -k;
        }
    }
    cell {
        stiffness {
            beta beta {
                _ => k;
            }
        }
        damping {
        }
        load {
            alpha {
                torque => T1;
            }
        }
    }
    jump k {
        normal {
            alpha {
                _ => 1.0;
            }
        }
        compliance {
            _ => 1.0/J1;
        }
        direction {
            alpha {
                _ => 1.0;
            }
        }
        step {
            _ => dk*beta.powi(2)/2.0;
        }
    }

    text {
        "T = (J1*alpha_dot^2 + J2*beta_dot^2)/2";
        "V = k*beta^2/2";
        "D = 0";
        "Q_alpha = T1 [torque]";
        "Q_beta = 0";
        "alpha'' = T1/J1 [torque] - dk*beta^2/(2*J1) [jump terms]";
        "beta'' = -k*beta/J2";
        "at a step dk of k in alpha, transmission if alpha_dot+^2 >= 0:";
        "alpha_dot+^2 = alpha_dot-^2 - dk*beta^2/J1";
        "else reflection: alpha_dot+ = -alpha_dot-, and the stiffness does not step";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{1}{2} (J_{1}\\, \\dot{\\alpha}^{2} + J_{2}\\, \\dot{\\beta}^{2})";
        "V = \\frac{k\\, \\beta^{2}}{2}";
        "D = 0";
        "Q_{\\alpha} = T_{1}\\ [\\text{torque}]";
        "Q_{\\beta} = 0";
        "\\ddot{\\alpha} = \\frac{T_{1}}{J_{1}}\\ [\\text{torque}] - \\frac{k'\\, \\beta^{2}}{2\\, J_{1}}\\ [\\text{jump terms}]";
        "\\ddot{\\beta} = -\\frac{k\\, \\beta}{J_{2}}";
        "\\dot{\\alpha}_+^2 = \\dot{\\alpha}_-^2 - \\frac{\\Delta k\\, \\beta^{2}}{J_{1}}";
    }
}
