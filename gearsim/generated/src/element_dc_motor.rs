//! Equations of motion of `element_dc_motor`: a DC motor.
//!
//! Derived from the energies in `models/src/element_dc_motor.rs` by `cargo xtask derive element_dc_motor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_dc_motor.txt`, `latex/element_dc_motor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_dc_motor "a DC motor";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        Ts_x "N*m" required with dc_x, open 0.0 to inf, "stall torque of the DC motor of the drive {}";
        n0_x "rad/s" required with dc_x, open 0.0 to inf, "no-load speed of the DC motor of the drive {}";
    }
    laws {
    }
    motions {
    }
    effects { dc_x of dc "a DC motor at constant voltage: its torque falls linearly from stall to no load"; }
    conditions {
    }

    energies {
        kinetic { _ => J_theta*theta_dot.powi(2)/2.0; }
        dissipation { dc_x => Ts_x*theta_dot.powi(2)/(2.0*n0_x); }
    }
    torques { dc_x "torque Ts of the DC motor of the drive {}; its part -Ts omega/n0 is in D" { dc_x => Ts_x*theta; } }
    work { theta { dc_x => Ts_x; } }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { dc_x => Ts_x - Ts_x*theta_dot/n0_x; } }
    jacobian { theta theta_dot { dc_x => -Ts_x/n0_x; } }
    cell {
        stiffness {
        }
        damping { theta theta { dc_x => Ts_x/n0_x; } }
        load { theta { dc_x => Ts_x; } }
    }
    outputs {
        braking_dc_x "W" with dc_x,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_x*theta_dot.powi(2)/n0_x;
        }
        power_dc_x "W" with dc_x,
            "power of the torque Ts of the DC motor of the drive {}; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_x_power;
        }
        net_power_dc_x "W" with dc_x, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_x_power - braking_dc_x;
        }
    }

    text "text/element_dc_motor.txt";
    latex "latex/element_dc_motor.tex";
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
