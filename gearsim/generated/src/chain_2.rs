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
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the first disc: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the first disc";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the first disc";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the first disc";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the first disc, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the first disc has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the first disc";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the first disc, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the first disc, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the first disc: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the first disc at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the first disc divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the first disc below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the last disc, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the last disc: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the last disc";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the last disc";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the last disc";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the last disc, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the last disc has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the last disc";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the last disc, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the last disc, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the last disc: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the last disc at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the last disc divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the last disc below which the torque of its fan is linear instead of quadratic in the speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions { speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; }, "rotational speed of the shaft"; }
    effects {
        torques "constant torques of motor and load";
        governor_motor of governor excludes(dc_motor, induction_motor, traction_motor)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_motor of dc excludes(induction_motor, traction_motor)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_motor of induction excludes(traction_motor) "an induction motor, its torque by the formula of Kloss";
        traction_motor of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_motor of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        governor_load of governor excludes(dc_load, induction_load, traction_load)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_load of dc excludes(induction_load, traction_load)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_load of induction excludes(traction_load) "an induction motor, its torque by the formula of Kloss";
        traction_load of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_load of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    constants {
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        twist1 = theta1 - theta2;
        theta_motor = theta1;
        theta_load = theta2;
    }
    forces {
        T_induction_motor {
            induction_motor => 2.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor)
                /(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2));
        }
        T_traction_motor {
            traction_motor => 2.0*Tp_motor*d_motor
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt());
        }
        T_fan_motor { fan_motor => -cf_motor*theta_motor_dot*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt(); }
        T_induction_load {
            induction_load => 2.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load)/(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2));
        }
        T_traction_load {
            traction_load => 2.0*Tp_load*d_load
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt());
        }
        T_fan_load { fan_load => -cf_load*theta_load_dot*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt(); }
    }
    partials {
        T_induction_motor_by_theta_motor_dot {
            induction_motor => 4.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor).powi(2)
                /(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)).powi(2))
                - 2.0*Tb_motor*sb_motor/(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)));
        }
        T_traction_motor_by_theta_motor_dot {
            traction_motor => -2.0*Tp_motor*d_motor
                *(per_wb_motor*(1.0 + per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                - per_wb_motor*(1.0 - per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt())
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_motor_by_theta_motor_dot {
            fan_motor => -cf_motor*theta_motor_dot.powi(2)/(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt()
                - cf_motor*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt();
        }
        T_induction_load_by_theta_load_dot {
            induction_load => 4.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load).powi(2)
                /(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)).powi(2))
                - 2.0*Tb_load*sb_load/(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)));
        }
        T_traction_load_by_theta_load_dot {
            traction_load => -2.0*Tp_load*d_load
                *(per_wb_load*(1.0 + per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()
                - per_wb_load*(1.0 - per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt())
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_load_by_theta_load_dot {
            fan_load => -cf_load*theta_load_dot.powi(2)/(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt()
                - cf_load*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt();
        }
    }
    energies {
        kinetic { _ => (I1*theta1_dot.powi(2) + I2*theta2_dot.powi(2))/2.0; }
        potential { _ => k1*twist1.powi(2)/2.0; }
        dissipation {
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*theta1_dot.powi(2) + I2*alpha_M*theta2_dot.powi(2) + beta_K*k1*twist1_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the first disc" { torques => T_motor*theta1; }
        governor_motor "torque c n of the governor of the first disc; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*theta1;
        }
        dc_motor "torque Ts of the DC motor of the first disc; its part -Ts omega/n0 is in D" { dc_motor => Ts_motor*theta1; }
        induction_motor "torque of the induction motor of the first disc" {}
        power { induction_motor => T_induction_motor*theta1_dot; }
        traction_motor "torque of the traction motor of the first disc" {}
        power { traction_motor => T_traction_motor*theta1_dot; }
        fan_motor "torque of the fan of the first disc, against the rotation" {}
        power { fan_motor => T_fan_motor*theta1_dot; }
        load "load torque of the last disc, against its rotation" { torques => -T_load*theta2; }
        governor_load "torque c n of the governor of the last disc; its part -c omega is in D" { governor_load => c_load*n_load*theta2; }
        dc_load "torque Ts of the DC motor of the last disc; its part -Ts omega/n0 is in D" { dc_load => Ts_load*theta2; }
        induction_load "torque of the induction motor of the last disc" {}
        power { induction_load => T_induction_load*theta2_dot; }
        traction_load "torque of the traction motor of the last disc" {}
        power { traction_load => T_traction_load*theta2_dot; }
        fan_load "torque of the fan of the last disc, against the rotation" {}
        power { fan_load => T_fan_load*theta2_dot; }
    }
    work {
        theta1 {
            torques => T_motor;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
        }
        theta2 {
            torques => -T_load;
            governor_load => c_load*n_load;
            dc_load => Ts_load;
        }
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
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
            damping => -I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot;
        }
        theta2 {
            _ => k1*twist1;
            torques => -T_load;
            governor_load => c_load*n_load - c_load*theta_load_dot;
            dc_load => Ts_load - Ts_load*theta_load_dot/n0_load;
            induction_load => T_induction_load;
            traction_load => T_traction_load;
            fan_load => T_fan_load;
            damping => beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot;
        }
    }
    jacobian {
        theta1 theta1_dot { damping => -I1*alpha_M; }
        theta1 twist1 { _ => -k1; }
        theta1 twist1_dot { damping => -beta_K*k1; }
        theta1 theta_motor_dot {
            governor_motor => -c_motor;
            dc_motor => -Ts_motor/n0_motor;
            induction_motor => T_induction_motor_by_theta_motor_dot;
            traction_motor => T_traction_motor_by_theta_motor_dot;
            fan_motor => T_fan_motor_by_theta_motor_dot;
        }
        theta2 theta2_dot { damping => -I2*alpha_M; }
        theta2 twist1 { _ => k1; }
        theta2 twist1_dot { damping => beta_K*k1; }
        theta2 theta_load_dot {
            governor_load => -c_load;
            dc_load => -Ts_load/n0_load;
            induction_load => T_induction_load_by_theta_load_dot;
            traction_load => T_traction_load_by_theta_load_dot;
            fan_load => T_fan_load_by_theta_load_dot;
        }
    }
    cell {
        stiffness { twist1 twist1 { _ => k1; } }
        damping {
            theta1 theta1 { damping => I1*alpha_M; }
            theta2 theta2 { damping => I2*alpha_M; }
            twist1 twist1 { damping => beta_K*k1; }
            theta_motor theta_motor {
                governor_motor => c_motor;
                dc_motor => Ts_motor/n0_motor;
            }
            theta_load theta_load {
                governor_load => c_load;
                dc_load => Ts_load/n0_load;
            }
        }
        load {
            theta1 {
                torques => T_motor;
                governor_motor => c_motor*n_motor;
                dc_motor => Ts_motor;
            }
            theta2 {
                torques => -T_load;
                governor_load => c_load*n_load;
                dc_load => Ts_load;
            }
        }
    }
    nonlinear_with {
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
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
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the first disc; its part -c omega is in D: positive if it drives" {
            _ => governor_motor_power;
        }
        net_power_governor_motor "W" with governor_motor,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_motor_power - braking_governor_motor;
        }
        braking_dc_motor "W" with dc_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_motor*theta_motor_dot.powi(2)/n0_motor;
        }
        power_dc_motor "W" with dc_motor,
            "power of the torque Ts of the DC motor of the first disc; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor,
            "power of the torque of the induction motor of the first disc: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor, "power of the torque of the traction motor of the first disc: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor,
            "power of the torque of the fan of the first disc, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        power_load "W" with torques, "power of the load torque of the last disc, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the last disc; its part -c omega is in D: positive if it drives" {
            _ => governor_load_power;
        }
        net_power_governor_load "W" with governor_load,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_load_power - braking_governor_load;
        }
        braking_dc_load "W" with dc_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_load*theta_load_dot.powi(2)/n0_load;
        }
        power_dc_load "W" with dc_load,
            "power of the torque Ts of the DC motor of the last disc; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load, "power of the torque of the induction motor of the last disc: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the last disc: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load, "power of the torque of the fan of the last disc, against the rotation: positive if it drives" {
            _ => fan_load_power;
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
// | constants (once a scene) | 0 | 2 | 0 |
// | named forces | 30 | 78 | 6 |
// | force | 6 | 18 | 0 |
// | acceleration | 6 | 36 | 0 |
