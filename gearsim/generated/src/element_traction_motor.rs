//! Equations of motion of `element_traction_motor`: a traction motor.
//!
//! Derived from the energies in `models/src/element_traction_motor.rs` by `cargo xtask derive element_traction_motor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_traction_motor.txt`, `latex/element_traction_motor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_traction_motor "a traction motor";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        Tp_x "N*m" required with traction_x, open 0.0 to inf, "peak torque of the traction motor of the drive {}, up to its base speed";
        Pp_x "W" required with traction_x, open 0.0 to inf, "peak power of the traction motor of the drive {}, above its base speed Pp/Tp";
        d_x "1" default 1.0 with traction_x, open -inf to inf,
            "demand on the traction motor of the drive {}: 1 drives with its peak torque or power, -1 brakes with them";
        round_x "1" default 0.01 with traction_x, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the drive {} at its base speed, relative to that";
    }
    laws {
    }
    motions {
    }
    effects { traction_x of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand"; }
    conditions {
    }

    constants { per_wb_x = Tp_x/Pp_x; }
    forces {
        T_traction_x {
            traction_x => 2.0*Tp_x*d_x/((round_x.powi(2) + (1.0 - per_wb_x*theta_dot).powi(2)).sqrt()
                + (round_x.powi(2) + (1.0 + per_wb_x*theta_dot).powi(2)).sqrt());
        }
    }
    partials {
        T_traction_x_by_theta_dot {
            traction_x => -2.0*Tp_x*d_x*(per_wb_x*(1.0 + per_wb_x*theta_dot)/(round_x.powi(2) + (1.0 + per_wb_x*theta_dot).powi(2)).sqrt()
                - per_wb_x*(1.0 - per_wb_x*theta_dot)/(round_x.powi(2) + (1.0 - per_wb_x*theta_dot).powi(2)).sqrt())
                /((round_x.powi(2) + (1.0 - per_wb_x*theta_dot).powi(2)).sqrt()
                + (round_x.powi(2) + (1.0 + per_wb_x*theta_dot).powi(2)).sqrt()).powi(2);
        }
    }
    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques {
        traction_x "torque of the traction motor of the drive {}" {}
        power { traction_x => T_traction_x*theta_dot; }
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { traction_x => T_traction_x; } }
    jacobian { theta theta_dot { traction_x => T_traction_x_by_theta_dot; } }
    cell {
        stiffness {
        }
        damping {
        }
        load {
        }
    }
    nonlinear_with { traction_x "T_traction_x in the torque `traction_x`"; }
    outputs {
        power_traction_x "W" with traction_x, "power of the torque of the traction motor of the drive {}: positive if it drives" {
            _ => traction_x_power;
        }
    }

    text "text/element_traction_motor.txt";
    latex "latex/element_traction_motor.tex";
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
// | constants (once a scene) | 0 | 1 | 0 |
// | named forces | 7 | 15 | 2 |
// | force | 0 | 0 | 0 |
// | acceleration | 0 | 1 | 0 |
