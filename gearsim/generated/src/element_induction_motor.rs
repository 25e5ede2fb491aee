//! Equations of motion of `element_induction_motor`: an induction motor.
//!
//! Derived from the energies in `models/src/element_induction_motor.rs` by `cargo xtask derive element_induction_motor`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_induction_motor.txt`, `latex/element_induction_motor.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_induction_motor "an induction motor";
    source "an element of trains";

    coordinates { theta "rad" start static, "rotation"; }
    parameters {
        J_theta "kg*m^2" required, open 0.0 to inf, "test inertia, 0 in trains";
        Tb_x "N*m" required with induction_x, open 0.0 to inf,
            "breakdown torque of the induction motor of the drive {}, its largest torque";
        sb_x "1" required with induction_x, open 0.0 to inf, "slip at which the induction motor of the drive {} has its breakdown torque";
        ns_x "rad/s" required with induction_x, open 0.0 to inf, "synchronous speed of the induction motor of the drive {}";
    }
    laws {
    }
    motions {
    }
    effects { induction_x of induction "an induction motor, its torque by the formula of Kloss"; }
    conditions {
    }

    forces { T_induction_x { induction_x => 2.0*Tb_x*sb_x*(1.0 - theta_dot/ns_x)/(sb_x.powi(2) + (1.0 - theta_dot/ns_x).powi(2)); } }
    partials {
        T_induction_x_by_theta_dot {
            induction_x => 4.0*Tb_x*sb_x*(1.0 - theta_dot/ns_x).powi(2)/(ns_x*(sb_x.powi(2) + (1.0 - theta_dot/ns_x).powi(2)).powi(2))
                - 2.0*Tb_x*sb_x/(ns_x*(sb_x.powi(2) + (1.0 - theta_dot/ns_x).powi(2)));
        }
    }
    energies { kinetic { _ => J_theta*theta_dot.powi(2)/2.0; } }
    torques {
        induction_x "torque of the induction motor of the drive {}" {}
        power { induction_x => T_induction_x*theta_dot; }
    }
    work {
    }
    mass { theta theta { _ => J_theta; } }
    mobility { theta theta { _ => 1.0/J_theta; } }
    force { theta { induction_x => T_induction_x; } }
    jacobian { theta theta_dot { induction_x => T_induction_x_by_theta_dot; } }
    cell {
        stiffness {
        }
        damping {
        }
        load {
        }
    }
    nonlinear_with { induction_x "T_induction_x in the torque `induction_x`"; }
    outputs {
        power_induction_x "W" with induction_x, "power of the torque of the induction motor of the drive {}: positive if it drives" {
            _ => induction_x_power;
        }
    }

    text "text/element_induction_motor.txt";
    latex "latex/element_induction_motor.tex";
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
// | named forces | 7 | 20 | 0 |
// | force | 0 | 0 | 0 |
// | acceleration | 0 | 1 | 0 |
