//! Equations of motion of `chain_5`: a torsional chain of 5 discs.
//!
//! Derived from the energies in `models/src/chain.rs` by `cargo xtask derive chain_5`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/chain_5.txt`, `latex/chain_5.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model chain_5 "a torsional chain of 5 discs";
    source "e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9";

    coordinates {
        theta1 "rad" start 0.0, "rotation of disc 1";
        theta2 "rad" start static, "rotation of disc 2";
        theta3 "rad" start static, "rotation of disc 3";
        theta4 "rad" start static, "rotation of disc 4";
        theta5 "rad" start static, "rotation of disc 5";
    }
    parameters {
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 1";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 2";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 3";
        I4 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 4";
        I5 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 5";
        k1 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 1 and 2";
        k2 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 2 and 3";
        k3 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 3 and 4";
        k4 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 4 and 5";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the first disc";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the last disc, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions {
        speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; theta3_dot = 1.0; theta4_dot = 1.0; theta5_dot = 1.0; },
            "rotational speed of the shaft";
    }
    effects {
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    deflections {
        twist1 = theta1 - theta2;
        twist2 = theta2 - theta3;
        twist3 = theta3 - theta4;
        twist4 = theta4 - theta5;
    }
    energies {
        kinetic {
            _ => (I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2) + I3*theta3_dot.powi(2) + I4*theta4_dot.powi(2) + I5*theta5_dot.powi(2))
                /2.0;
        }
        potential { _ => (k1*twist1.powi(2) + k2*twist2.powi(2) + k3*twist3.powi(2) + k4*twist4.powi(2))/2.0; }
        dissipation {
            damping => (I1*alpha_M*theta1_dot.powi(2) + I2*alpha_M*theta2_dot.powi(2) + I3*alpha_M*theta3_dot.powi(2)
                + I4*alpha_M*theta4_dot.powi(2) + I5*alpha_M*theta5_dot.powi(2) + beta_K*k1*twist1_dot.powi(2)
                + beta_K*k2*twist2_dot.powi(2) + beta_K*k3*twist3_dot.powi(2) + beta_K*k4*twist4_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the first disc" { torques => T_motor*theta1; }
        load "load torque of the last disc, against its rotation" { torques => -T_load*theta5; }
    }
    work {
        theta1 { torques => T_motor; }
        theta5 { torques => -T_load; }
    }
    mass {
        theta1 theta1 { _ => I1; }
        theta2 theta2 { _ => I2; }
        theta3 theta3 { _ => I3; }
        theta4 theta4 { _ => I4; }
        theta5 theta5 { _ => I5; }
    }
    force {
        theta1 {
            _ => -k1*twist1;
            torques => T_motor;
            damping => -I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot;
        }
        theta2 {
            _ => k1*twist1 - k2*twist2;
            damping => beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot - beta_K*k2*twist2_dot;
        }
        theta3 {
            _ => k2*twist2 - k3*twist3;
            damping => beta_K*k2*twist2_dot - I3*alpha_M*theta3_dot - beta_K*k3*twist3_dot;
        }
        theta4 {
            _ => k3*twist3 - k4*twist4;
            damping => beta_K*k3*twist3_dot - I4*alpha_M*theta4_dot - beta_K*k4*twist4_dot;
        }
        theta5 {
            _ => k4*twist4;
            torques => -T_load;
            damping => beta_K*k4*twist4_dot - I5*alpha_M*theta5_dot;
        }
    }
    jacobian {
        theta1 theta1 { _ => -k1; }
        theta1 theta2 { _ => k1; }
        theta1 theta1_dot { damping => -I1*alpha_M - beta_K*k1; }
        theta1 theta2_dot { damping => beta_K*k1; }
        theta2 theta1 { _ => k1; }
        theta2 theta2 { _ => -k1 - k2; }
        theta2 theta3 { _ => k2; }
        theta2 theta1_dot { damping => beta_K*k1; }
        theta2 theta2_dot { damping => -I2*alpha_M - beta_K*k1 - beta_K*k2; }
        theta2 theta3_dot { damping => beta_K*k2; }
        theta3 theta2 { _ => k2; }
        theta3 theta3 { _ => -k2 - k3; }
        theta3 theta4 { _ => k3; }
        theta3 theta2_dot { damping => beta_K*k2; }
        theta3 theta3_dot { damping => -I3*alpha_M - beta_K*k2 - beta_K*k3; }
        theta3 theta4_dot { damping => beta_K*k3; }
        theta4 theta3 { _ => k3; }
        theta4 theta4 { _ => -k3 - k4; }
        theta4 theta5 { _ => k4; }
        theta4 theta3_dot { damping => beta_K*k3; }
        theta4 theta4_dot { damping => -I4*alpha_M - beta_K*k3 - beta_K*k4; }
        theta4 theta5_dot { damping => beta_K*k4; }
        theta5 theta4 { _ => k4; }
        theta5 theta5 { _ => -k4; }
        theta5 theta4_dot { damping => beta_K*k4; }
        theta5 theta5_dot { damping => -I5*alpha_M - beta_K*k4; }
    }
    cell {
        stiffness {
            theta1 theta1 { _ => k1; }
            theta1 theta2 { _ => -k1; }
            theta2 theta2 { _ => k1 + k2; }
            theta2 theta3 { _ => -k2; }
            theta3 theta3 { _ => k2 + k3; }
            theta3 theta4 { _ => -k3; }
            theta4 theta4 { _ => k3 + k4; }
            theta4 theta5 { _ => -k4; }
            theta5 theta5 { _ => k4; }
        }
        damping {
            theta1 theta1 { damping => I1*alpha_M + beta_K*k1; }
            theta1 theta2 { damping => -beta_K*k1; }
            theta2 theta2 { damping => I2*alpha_M + beta_K*k1 + beta_K*k2; }
            theta2 theta3 { damping => -beta_K*k2; }
            theta3 theta3 { damping => I3*alpha_M + beta_K*k2 + beta_K*k3; }
            theta3 theta4 { damping => -beta_K*k3; }
            theta4 theta4 { damping => I4*alpha_M + beta_K*k3 + beta_K*k4; }
            theta4 theta5 { damping => -beta_K*k4; }
            theta5 theta5 { damping => I5*alpha_M + beta_K*k4; }
        }
        load {
            theta1 { torques => T_motor; }
            theta5 { torques => -T_load; }
        }
    }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the disc 1" { _ => theta1_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the disc 2" { _ => theta2_dot; }
        rotor_speed_3 "rad/s", "rotational speed of the disc 3" { _ => theta3_dot; }
        rotor_speed_4 "rad/s", "rotational speed of the disc 4" { _ => theta4_dot; }
        rotor_speed_5 "rad/s", "rotational speed of the disc 5" { _ => theta5_dot; }
        shaft_twist_1 "rad", "twist of the shaft between discs 1 and 2" { _ => twist1; }
        shaft_torque_1 "N*m", "torque in the shaft between discs 1 and 2, damper included" {
            _ => k1*twist1;
            damping => beta_K*k1*twist1_dot;
        }
        shaft_power_1 "W", "power that enters the shaft between discs 1 and 2 at its first end: torque times the speed of that end" {
            _ => theta1_dot*shaft_torque_1;
        }
        shaft_loss_1 "W", "power that the damper of the shaft between discs 1 and 2 takes" { damping => beta_K*k1*twist1_dot.powi(2); }
        shaft_twist_2 "rad", "twist of the shaft between discs 2 and 3" { _ => twist2; }
        shaft_torque_2 "N*m", "torque in the shaft between discs 2 and 3, damper included" {
            _ => k2*twist2;
            damping => beta_K*k2*twist2_dot;
        }
        shaft_power_2 "W", "power that enters the shaft between discs 2 and 3 at its first end: torque times the speed of that end" {
            _ => theta2_dot*shaft_torque_2;
        }
        shaft_loss_2 "W", "power that the damper of the shaft between discs 2 and 3 takes" { damping => beta_K*k2*twist2_dot.powi(2); }
        shaft_twist_3 "rad", "twist of the shaft between discs 3 and 4" { _ => twist3; }
        shaft_torque_3 "N*m", "torque in the shaft between discs 3 and 4, damper included" {
            _ => k3*twist3;
            damping => beta_K*k3*twist3_dot;
        }
        shaft_power_3 "W", "power that enters the shaft between discs 3 and 4 at its first end: torque times the speed of that end" {
            _ => theta3_dot*shaft_torque_3;
        }
        shaft_loss_3 "W", "power that the damper of the shaft between discs 3 and 4 takes" { damping => beta_K*k3*twist3_dot.powi(2); }
        shaft_twist_4 "rad", "twist of the shaft between discs 4 and 5" { _ => twist4; }
        shaft_torque_4 "N*m", "torque in the shaft between discs 4 and 5, damper included" {
            _ => k4*twist4;
            damping => beta_K*k4*twist4_dot;
        }
        shaft_power_4 "W", "power that enters the shaft between discs 4 and 5 at its first end: torque times the speed of that end" {
            _ => theta4_dot*shaft_torque_4;
        }
        shaft_loss_4 "W", "power that the damper of the shaft between discs 4 and 5 takes" { damping => beta_K*k4*twist4_dot.powi(2); }
        power_motor "W" with torques, "power of the driving torque of the first disc: positive if it drives" { _ => motor_power; }
        power_load "W" with torques, "power of the load torque of the last disc, against its rotation: positive if it drives" {
            _ => load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2) + I3*theta3_dot.powi(2) + I4*theta4_dot.powi(2)
                + I5*theta5_dot.powi(2))/2.0);
        }
    }

    text "text/chain_5.txt";
    latex "latex/chain_5.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - every deflection equals the linear form by which the equations differentiate it
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | force | 11 | 34 | 0 |
