//! Equations of motion of `element_support`: a torsional support.
//!
//! Derived from the energies in `models/src/element_support.rs` by `cargo xtask derive element_support`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_support.txt`, `latex/element_support.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_support "a torsional support";
    source "an element of trains";

    coordinates { theta "rad" start static, "twist"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        k_x "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the support {}";
        c_x "N*m*s/rad" required with viscous_friction_x, from 0.0 to inf, "torsional damping of the support {}: torque per speed";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions {
    }
    effects {
        viscous_friction_x of viscous_friction "friction proportional to speed";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    deflections { twist_x = theta; }
    energies {
        kinetic { _ => J_theta*theta_dot.powi(2)/2.0; }
        potential { _ => k_x*twist_x.powi(2)/2.0; }
        dissipation {
            viscous_friction_x => c_x*twist_x_dot.powi(2)/2.0;
            damping => beta_K*k_x*twist_x_dot.powi(2)/2.0;
        }
    }
    torques {
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force {
        theta {
            _ => -k_x*twist_x;
            viscous_friction_x => -c_x*twist_x_dot;
            damping => -beta_K*k_x*twist_x_dot;
        }
    }
    jacobian {
        theta twist_x { _ => -k_x; }
        theta twist_x_dot {
            viscous_friction_x => -c_x;
            damping => -beta_K*k_x;
        }
    }
    cell {
        stiffness { twist_x twist_x { _ => k_x; } }
        damping {
            twist_x twist_x {
                viscous_friction_x => c_x;
                damping => beta_K*k_x;
            }
        }
        load {
        }
    }
    outputs {
        shaft_twist_x "rad", "twist of the support {}" { _ => twist_x; }
        shaft_torque_x "N*m", "torque in the support {}, damper included" {
            _ => k_x*twist_x;
            viscous_friction_x => c_x*twist_x_dot;
            damping => beta_K*k_x*twist_x_dot;
        }
        shaft_loss_x "W", "power that the damper of the support {} takes" {
            viscous_friction_x => c_x*twist_x_dot.powi(2);
            damping => beta_K*k_x*twist_x_dot.powi(2);
        }
    }

    text "text/element_support.txt";
    latex "latex/element_support.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 4 | 0 |
// | acceleration | 0 | 7 | 0 |
