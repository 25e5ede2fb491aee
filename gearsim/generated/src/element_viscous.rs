//! Equations of motion of `element_viscous`: viscous friction.
//!
//! Derived from the energies in `models/src/element_viscous.rs` by `cargo xtask derive element_viscous`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_viscous.txt`, `latex/element_viscous.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_viscous "viscous friction";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        c_x "N*m*s/rad" required with viscous_friction_x, from 0.0 to inf, "viscous friction of the {}: torque per speed";
    }
    laws {
    }
    motions {
    }
    effects { viscous_friction_x of viscous_friction "friction proportional to speed"; }
    conditions {
    }

    energies {
        kinetic { _ => J_theta*theta_dot.powi(2)/2.0; }
        dissipation { viscous_friction_x => c_x*theta_dot.powi(2)/2.0; }
    }
    torques {
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { viscous_friction_x => -c_x*theta_dot; } }
    jacobian { theta theta_dot { viscous_friction_x => -c_x; } }
    cell {
        stiffness {
        }
        damping { theta theta { viscous_friction_x => c_x; } }
        load {
        }
    }
    outputs {
        viscous_loss_x "W" with viscous_friction_x, "power that the viscous friction of the {} takes" { _ => c_x*theta_dot.powi(2); }
    }

    text "text/element_viscous.txt";
    latex "latex/element_viscous.tex";
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
// | force | 0 | 1 | 0 |
// | acceleration | 0 | 2 | 0 |
