//! Equations of motion of `chain_2`: a torsional chain of 2 discs.
//!
//! Derived from the energies in `models/src/chain.rs` by `cargo xtask derive chain_2`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/chain_2.txt`, `latex/chain_2.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model chain_2 "a torsional chain of 2 discs";
    source "e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9";

    coordinates {
        theta1 "rad" start 0.0, "rotation of disc 1";
        theta2 "rad" start static, "rotation of disc 2";
    }
    parameters {
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 1";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 2";
        k1 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 1 and 2";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the first disc";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the last disc, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions { speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; }, "rotational speed of the shaft"; }
    effects {
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    deflections { twist1 = theta1 - theta2; }
    energies {
        kinetic { _ => (I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2))/2.0; }
        potential { _ => k1*twist1.powi(2)/2.0; }
        dissipation { damping => (I1*alpha_M*theta1_dot.powi(2) + I2*alpha_M*theta2_dot.powi(2) + beta_K*k1*twist1_dot.powi(2))/2.0; }
    }
    torques {
        motor "driving torque of the first disc" { torques => T_motor*theta1; }
        load "load torque of the last disc, against its rotation" { torques => -T_load*theta2; }
    }
    work {
        theta1 { torques => T_motor; }
        theta2 { torques => -T_load; }
    }
    mass {
        theta1 theta1 { _ => I1; }
        theta2 theta2 { _ => I2; }
    }
    mobility {
        theta1 theta1 { _ => 1.0/I1; }
        theta2 theta2 { _ => 1.0/I2; }
    }
    force {
        theta1 {
            _ => -k1*twist1;
            torques => T_motor;
            damping => -I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot;
        }
        theta2 {
            _ => k1*twist1;
            torques => -T_load;
            damping => beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot;
        }
    }
    jacobian {
        theta1 theta1 { _ => -k1; }
        theta1 theta2 { _ => k1; }
        theta1 theta1_dot { damping => -I1*alpha_M - beta_K*k1; }
        theta1 theta2_dot { damping => beta_K*k1; }
        theta2 theta1 { _ => k1; }
        theta2 theta2 { _ => -k1; }
        theta2 theta1_dot { damping => beta_K*k1; }
        theta2 theta2_dot { damping => -I2*alpha_M - beta_K*k1; }
    }
    cell {
        stiffness {
            theta1 theta1 { _ => k1; }
            theta1 theta2 { _ => -k1; }
            theta2 theta2 { _ => k1; }
        }
        damping {
            theta1 theta1 { damping => I1*alpha_M + beta_K*k1; }
            theta1 theta2 { damping => -beta_K*k1; }
            theta2 theta2 { damping => I2*alpha_M + beta_K*k1; }
        }
        load {
            theta1 { torques => T_motor; }
            theta2 { torques => -T_load; }
        }
    }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the disc 1" { _ => theta1_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the disc 2" { _ => theta2_dot; }
        shaft_twist_1 "rad", "twist of the shaft between discs 1 and 2" { _ => twist1; }
        shaft_torque_1 "N*m", "torque in the shaft between discs 1 and 2, damper included" {
            _ => k1*twist1;
            damping => beta_K*k1*twist1_dot;
        }
        shaft_power_1 "W", "power that enters the shaft between discs 1 and 2 at its first end: torque times the speed of that end" {
            _ => theta1_dot*shaft_torque_1;
        }
        shaft_loss_1 "W", "power that the damper of the shaft between discs 1 and 2 takes" { damping => beta_K*k1*twist1_dot.powi(2); }
        power_motor "W" with torques, "power of the driving torque of the first disc: positive if it drives" { _ => motor_power; }
        power_load "W" with torques, "power of the load torque of the last disc, against its rotation: positive if it drives" {
            _ => load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2))/2.0);
        }
    }

    text "text/chain_2.txt";
    latex "latex/chain_2.tex";
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
// | force | 2 | 10 | 0 |
// | acceleration | 2 | 14 | 0 |
