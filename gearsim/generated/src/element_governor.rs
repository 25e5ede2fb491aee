//! Equations of motion of `element_governor`: a motor with a speed governor.
//!
//! Derived from the energies in `models/src/element_governor.rs` by `cargo xtask derive element_governor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_governor.txt`, `latex/element_governor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_governor "a motor with a speed governor";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        c_x "N*m*s/rad" required with governor_x, open 0.0 to inf,
            "gain of the governor of the drive {}: torque per difference of set point and speed";
        n_x "rad/s" required with governor_x, open -inf to inf, "set point of the speed governor of the drive {}";
    }
    laws {
    }
    motions {
    }
    effects { governor_x of governor "a motor with a speed governor: its torque is proportional to the set point minus the speed"; }
    conditions {
    }

    energies {
        kinetic { _ => J_theta*theta_dot.powi(2)/2.0; }
        dissipation { governor_x => c_x*theta_dot.powi(2)/2.0; }
    }
    torques { governor_x "torque c n of the governor of the drive {}; its part -c omega is in D" { governor_x => c_x*n_x*theta; } }
    work { theta { governor_x => c_x*n_x; } }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { governor_x => c_x*n_x - c_x*theta_dot; } }
    jacobian { theta theta_dot { governor_x => -c_x; } }
    cell {
        stiffness {
        }
        damping { theta theta { governor_x => c_x; } }
        load { theta { governor_x => c_x*n_x; } }
    }
    outputs {
        braking_governor_x "W" with governor_x,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_x*theta_dot.powi(2);
        }
        power_governor_x "W" with governor_x,
            "power of the torque c n of the governor of the drive {}; its part -c omega is in D: positive if it drives" {
            _ => governor_x_power;
        }
        net_power_governor_x "W" with governor_x, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_x_power - braking_governor_x;
        }
    }

    text "text/element_governor.txt";
    latex "latex/element_governor.tex";
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
// | force | 1 | 2 | 0 |
// | acceleration | 1 | 4 | 0 |
