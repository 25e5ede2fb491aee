//! Equations of motion of `element_rotor`: a rotor.
//!
//! Derived from the energies in `models/src/element_rotor.rs` by `cargo xtask derive element_rotor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_rotor.txt`, `latex/element_rotor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_rotor "a rotor";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        I_x "kg*m^2" required, open 0.0 to inf, "moment of inertia of the rotor {}";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
    }
    laws {
    }
    motions {
    }
    effects { damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness"; }
    conditions {
    }

    energies {
        kinetic { _ => I_x*theta_dot.powi(2)/2.0; }
        dissipation { damping => I_x*alpha_M*theta_dot.powi(2)/2.0; }
    }
    torques {
    }
    work {
    }
    mass { theta theta { _ => I_x; } }
    mobility { theta theta { _ => 1.0/I_x; } }
    force { theta { damping => -I_x*alpha_M*theta_dot; } }
    jacobian { theta theta_dot { damping => -I_x*alpha_M; } }
    cell {
        stiffness {
        }
        damping { theta theta { damping => I_x*alpha_M; } }
        load {
        }
    }
    outputs {
        rotor_speed_x "rad/s", "rotational speed of the rotor {}" { _ => theta_dot; }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => I_x*alpha_M*theta_dot.powi(2);
        }
    }

    text "text/element_rotor.txt";
    latex "latex/element_rotor.tex";
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
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 2 | 0 |
// | acceleration | 0 | 1 | 0 |
