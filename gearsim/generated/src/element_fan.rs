//! Equations of motion of `element_fan`: a fan.
//!
//! Derived from the energies in `models/src/element_fan.rs` by `cargo xtask derive element_fan`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_fan.txt`, `latex/element_fan.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_fan "a fan";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        cf_x "N*m*s^2/rad^2" required with fan_x, from 0.0 to inf, "torque of the fan of the drive {} divided by the square of its speed";
        w0_x "rad/s" default 0.01 with fan_x, open 0.0 to inf,
            "speed of the drive {} below which the torque of its fan is linear instead of quadratic in the speed";
    }
    laws {
    }
    motions {
    }
    effects { fan_x of fan "a fan as load: torque proportional to the square of the speed, against the rotation"; }
    conditions {
    }

    forces { T_fan_x { fan_x => -cf_x*theta_dot*(w0_x.powi(2) + theta_dot.powi(2)).sqrt(); } }
    partials {
        T_fan_x_by_theta_dot {
            fan_x => -cf_x*theta_dot.powi(2)/(w0_x.powi(2) + theta_dot.powi(2)).sqrt() - cf_x*(w0_x.powi(2) + theta_dot.powi(2)).sqrt();
        }
    }
    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques {
        fan_x "torque of the fan of the drive {}, against the rotation" {}
        power { fan_x => T_fan_x*theta_dot; }
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { fan_x => T_fan_x; } }
    jacobian { theta theta_dot { fan_x => T_fan_x_by_theta_dot; } }
    cell {
        stiffness {
        }
        damping {
        }
        load {
        }
    }
    nonlinear_with { fan_x "T_fan_x in the torque `fan_x`"; }
    outputs {
        power_fan_x "W" with fan_x, "power of the torque of the fan of the drive {}, against the rotation: positive if it drives" {
            _ => fan_x_power;
        }
    }

    text "text/element_fan.txt";
    latex "latex/element_fan.tex";
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
// | named forces | 1 | 4 | 1 |
// | force | 0 | 0 | 0 |
// | acceleration | 0 | 1 | 0 |
