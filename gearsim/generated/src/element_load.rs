//! Equations of motion of `element_load`: a load.
//!
//! Derived from the energies in `models/src/element_load.rs` by `cargo xtask derive element_load`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_load.txt`, `latex/element_load.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_load "a load";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        T_x "N*m" required with torques, open -inf to inf, "load torque of the load {}, against its rotation";
    }
    laws {
    }
    motions {
    }
    effects { torques "constant torques of motor and load"; }
    conditions {
    }

    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques { x "load torque of the load {}, against its rotation" { torques => -T_x*theta; } }
    work { theta { torques => -T_x; } }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { torques => -T_x; } }
    jacobian {
    }
    cell {
        stiffness {
        }
        damping {
        }
        load { theta { torques => -T_x; } }
    }
    outputs {
        power_x "W" with torques, "power of the load torque of the load {}, against its rotation: positive if it drives" { _ => x_power; }
    }

    text "text/element_load.txt";
    latex "latex/element_load.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - M M⁻¹ = 1, and M q'' = F, for M⁻¹ and the accelerations as written
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 0 | 0 | 0 |
// | acceleration | 0 | 1 | 0 |
