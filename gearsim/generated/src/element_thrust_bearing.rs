//! Equations of motion of `element_thrust_bearing`: a thrust bearing and the mass on it.
//!
//! Derived from the energies in `models/src/element_thrust_bearing.rs` by `cargo xtask derive element_thrust_bearing`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/element_thrust_bearing.txt`, `latex/element_thrust_bearing.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model element_thrust_bearing "a thrust bearing and the mass on it";
    source "an element of trains";

    coordinates { z "m" start static, "axial displacement"; }
    parameters {
        ma_x "kg" required, open 0.0 to inf, "mass that moves along the axis on thrust bearing {}";
        ka_x "N/m" required, from 0.0 to inf, "axial stiffness of the thrust bearing {}";
        ca_x "N*s/m" required with viscous_friction_x, from 0.0 to inf, "axial damping of the thrust bearing {}: force per speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
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

    deflections { bz_x = z; }
    energies {
        kinetic { _ => ma_x*z_dot.powi(2)/2.0; }
        potential { _ => ka_x*bz_x.powi(2)/2.0; }
        dissipation {
            viscous_friction_x => ca_x*bz_x_dot.powi(2)/2.0;
            damping => (alpha_M*ma_x*z_dot.powi(2) + beta_K*ka_x*bz_x_dot.powi(2))/2.0;
        }
    }
    torques {
    }
    work {
    }
    mass { z z { _ => ma_x; } }
    mobility { z z { _ => 1.0/ma_x; } }
    force {
        z {
            _ => -ka_x*bz_x;
            viscous_friction_x => -ca_x*bz_x_dot;
            damping => -alpha_M*ma_x*z_dot - beta_K*ka_x*bz_x_dot;
        }
    }
    jacobian {
        z z_dot { damping => -alpha_M*ma_x; }
        z bz_x { _ => -ka_x; }
        z bz_x_dot {
            viscous_friction_x => -ca_x;
            damping => -beta_K*ka_x;
        }
    }
    cell {
        stiffness { bz_x bz_x { _ => ka_x; } }
        damping {
            z z { damping => alpha_M*ma_x; }
            bz_x bz_x {
                viscous_friction_x => ca_x;
                damping => beta_K*ka_x;
            }
        }
        load {
        }
    }
    outputs {
        thrust_deflection_x "m", "axial displacement of the rotor on the thrust bearing {}, along the positive axis" { _ => bz_x; }
        thrust_force_x "N", "axial force on the thrust bearing {}, damper included" {
            _ => ka_x*bz_x;
            viscous_friction_x => ca_x*bz_x_dot;
            damping => beta_K*ka_x*bz_x_dot;
        }
        thrust_loss_x "W", "power that the damper of the thrust bearing {} takes" {
            viscous_friction_x => ca_x*bz_x_dot.powi(2);
            damping => beta_K*ka_x*bz_x_dot.powi(2);
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" { _ => alpha_M*ma_x*z_dot.powi(2); }
    }

    text "text/element_thrust_bearing.txt";
    latex "latex/element_thrust_bearing.tex";
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
// | force | 1 | 6 | 0 |
// | acceleration | 1 | 8 | 0 |
