//! Equations of motion of `belt_drive`: a belt drive with a sprung tensioner.
//!
//! Derived from the energies in `models/src/belt_drive.rs` by `cargo xtask derive belt_drive`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/belt_drive.txt`, `latex/belt_drive.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model belt_drive "a belt drive with a sprung tensioner";
    source "rotational model of Beikmann, Perkins & Ulsoy (1996), J. Vib. Acoust. 118(3), with one accessory";

    coordinates {
        theta "rad" start 0.0, "rotation of the crankshaft";
        s "m" start static, "stretch of the pulling span, relative to its tension at rest";
        psi "rad" start static, "rotation of the tensioner arm, relative to its position at rest";
    }
    parameters {
        r1 "m" required, open 0.0 to inf, "radius of the crankshaft pulley";
        r2 "m" required, open 0.0 to inf, "radius of the accessory pulley";
        a "m" required, open 0.0 to inf, "length that the slack span gains per radian of the arm";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the crankshaft";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the accessory";
        I_t "kg*m^2" required, open 0.0 to inf, "moment of inertia of the tensioner arm";
        k_p "N/m" required, open 0.0 to inf, "stiffness of the pulling span";
        k_s "N/m" required, open 0.0 to inf, "stiffness of the slack span";
        k_t "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the spring of the tensioner arm";
        T_crank "N*m" required with torques, open -inf to inf, "driving torque of the crankshaft";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the accessory, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions { speed "rad/s" { theta_dot = 1.0; }, "rotational speed of the crankshaft"; }
    effects {
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    deflections {
        s_p = s;
        s_s = a*psi - s;
        twist_t = psi;
    }
    energies {
        kinetic { _ => (I1*theta_dot.powi(2) + I2*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*psi_dot.powi(2))/2.0; }
        potential { _ => (k_p*s_p.powi(2) + k_s*s_s.powi(2) + k_t*twist_t.powi(2))/2.0; }
        dissipation {
            damping => (I1*alpha_M*theta_dot.powi(2) + I2*alpha_M*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*alpha_M*psi_dot.powi(2)
                + beta_K*k_p*s_p_dot.powi(2) + beta_K*k_s*s_s_dot.powi(2) + beta_K*k_t*twist_t_dot.powi(2))/2.0;
        }
    }
    torques {
        crank "driving torque of the crankshaft" { torques => T_crank*theta; }
        load "load torque of the accessory, against its rotation" { torques => T_load*(s/r2 - r1*theta/r2); }
    }
    work {
        theta { torques => T_crank - T_load*r1/r2; }
        s { torques => T_load/r2; }
    }
    mass {
        theta theta { _ => I1 + I2*r1.powi(2)/r2.powi(2); }
        theta s { _ => -I2*r1/r2.powi(2); }
        s s { _ => I2/r2.powi(2); }
        psi psi { _ => I_t; }
    }
    force {
        theta {
            torques => T_crank - T_load*r1/r2;
            damping => I2*alpha_M*r1*s_dot/r2.powi(2) - I1*alpha_M*theta_dot - I2*alpha_M*r1.powi(2)*theta_dot/r2.powi(2);
        }
        s {
            _ => k_s*s_s - k_p*s_p;
            torques => T_load/r2;
            damping => I2*alpha_M*r1*theta_dot/r2.powi(2) - I2*alpha_M*s_dot/r2.powi(2) - beta_K*k_p*s_p_dot + beta_K*k_s*s_s_dot;
        }
        psi {
            _ => -a*k_s*s_s - k_t*twist_t;
            damping => -I_t*alpha_M*psi_dot - a*beta_K*k_s*s_s_dot - beta_K*k_t*twist_t_dot;
        }
    }
    jacobian {
        theta theta_dot { damping => -I1*alpha_M - I2*alpha_M*r1.powi(2)/r2.powi(2); }
        theta s_dot { damping => I2*alpha_M*r1/r2.powi(2); }
        s s { _ => -k_p - k_s; }
        s psi { _ => a*k_s; }
        s theta_dot { damping => I2*alpha_M*r1/r2.powi(2); }
        s s_dot { damping => -I2*alpha_M/r2.powi(2) - beta_K*k_p - beta_K*k_s; }
        s psi_dot { damping => a*beta_K*k_s; }
        psi s { _ => a*k_s; }
        psi psi { _ => -k_t - a.powi(2)*k_s; }
        psi s_dot { damping => a*beta_K*k_s; }
        psi psi_dot { damping => -I_t*alpha_M - beta_K*k_t - a.powi(2)*beta_K*k_s; }
    }
    cell {
        stiffness {
            s s { _ => k_p + k_s; }
            s psi { _ => -a*k_s; }
            psi psi { _ => k_t + a.powi(2)*k_s; }
        }
        damping {
            theta theta { damping => I1*alpha_M + I2*alpha_M*r1.powi(2)/r2.powi(2); }
            theta s { damping => -I2*alpha_M*r1/r2.powi(2); }
            s s { damping => I2*alpha_M/r2.powi(2) + beta_K*k_p + beta_K*k_s; }
            s psi { damping => -a*beta_K*k_s; }
            psi psi { damping => I_t*alpha_M + beta_K*k_t + a.powi(2)*beta_K*k_s; }
        }
        load {
            theta { torques => T_crank - T_load*r1/r2; }
            s { torques => T_load/r2; }
        }
    }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the crankshaft" { _ => theta_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the accessory" { _ => r1*theta_dot/r2 - s_dot/r2; }
        rotor_speed_t "rad/s", "rotational speed of the tensioner arm" { _ => psi_dot; }
        span_force_p "N", "force in the pulling span beyond its tension at rest, damper included" {
            _ => k_p*s_p;
            damping => beta_K*k_p*s_p_dot;
        }
        span_loss_p "W", "power that the damper of the pulling span takes" { damping => beta_K*k_p*s_p_dot.powi(2); }
        span_force_s "N", "force in the slack span beyond its tension at rest, damper included" {
            _ => k_s*s_s;
            damping => beta_K*k_s*s_s_dot;
        }
        span_loss_s "W", "power that the damper of the slack span takes" { damping => beta_K*k_s*s_s_dot.powi(2); }
        shaft_twist_t "rad", "twist of the spring of the tensioner arm" { _ => twist_t; }
        shaft_torque_t "N*m", "torque in the spring of the tensioner arm, damper included" {
            _ => k_t*twist_t;
            damping => beta_K*k_t*twist_t_dot;
        }
        shaft_power_t "W", "power that enters the spring of the tensioner arm at its first end: torque times the speed of that end" {
            _ => psi_dot*shaft_torque_t;
        }
        shaft_loss_t "W", "power that the damper of the spring of the tensioner arm takes" { damping => beta_K*k_t*twist_t_dot.powi(2); }
        power_crank "W" with torques, "power of the driving torque of the crankshaft: positive if it drives" { _ => crank_power; }
        power_load "W" with torques, "power of the load torque of the accessory, against its rotation: positive if it drives" {
            _ => load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*theta_dot.powi(2) + I2*(r1*theta_dot/r2 - s_dot/r2).powi(2) + I_t*psi_dot.powi(2))/2.0);
        }
    }

    text "text/belt_drive.txt";
    latex "latex/belt_drive.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 10 | 41 | 0 |
