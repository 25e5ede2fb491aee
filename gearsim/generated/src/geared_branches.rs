//! Equations of motion of `geared_branches`: two shafts geared rigidly, with a motor and two discs.
//!
//! Derived from the energies in `models/src/geared_branches.rs` by `cargo xtask derive geared_branches`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/geared_branches.txt`, `latex/geared_branches.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model geared_branches "two shafts geared rigidly, with a motor and two discs";
    source "Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9: geared systems";

    coordinates {
        theta1 "rad" start 0.0, "rotation of the first shaft's gear";
        theta_m "rad" start static, "rotation of the motor";
        theta_a "rad" start static, "rotation of the first shaft's disc";
        theta_b "rad" start static, "rotation of the second shaft's disc";
    }
    parameters {
        N1 "1" teeth default 1.0, open 0.0 to inf, "number of teeth of the first shaft's gear";
        N2 "1" teeth default 1.0, open 0.0 to inf, "number of teeth of the second shaft's gear";
        I_m "kg*m^2" required, open 0.0 to inf, "moment of inertia of the motor";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the first shaft's gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the second shaft's gear";
        I_a "kg*m^2" required, open 0.0 to inf, "moment of inertia of the first shaft's disc";
        I_b "kg*m^2" required, open 0.0 to inf, "moment of inertia of the second shaft's disc";
        k_m "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the motor's shaft";
        k_a "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft to the first disc";
        k_b "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft to the second disc";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the motor";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the motor: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the motor";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the motor";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the motor";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the motor, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the motor has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the motor";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the motor, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the motor, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the motor: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the motor at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the motor divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the motor below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the second shaft's disc, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the second shaft's disc: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the second shaft's disc";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the second shaft's disc";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the second shaft's disc";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the second shaft's disc, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the second shaft's disc has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf,
            "synchronous speed of the induction motor of the second shaft's disc";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the second shaft's disc, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the second shaft's disc, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the second shaft's disc: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the second shaft's disc at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the second shaft's disc divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the second shaft's disc below which the torque of its fan is linear instead of quadratic in the speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions {
        speed "rad/s" { theta_m_dot = 1.0; theta1_dot = 1.0; theta_a_dot = 1.0; theta_b_dot = N1/N2; },
            "rotational speed of the first shaft";
    }
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
        twist_m = theta_m - theta1;
        twist_a = theta1 - theta_a;
        twist_b = N1*theta1/N2 - theta_b;
        theta_motor = theta_m;
        theta_load = theta_b;
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
        kinetic {
            _ => (I1*theta1_dot.powi(2) + I2*N1.powi(2)*theta1_dot.powi(2)/N2.powi(2) + I_a*theta_a_dot.powi(2) + I_b*theta_b_dot.powi(2)
                + I_m*theta_m_dot.powi(2))/2.0;
        }
        potential { _ => (k_a*twist_a.powi(2) + k_b*twist_b.powi(2) + k_m*twist_m.powi(2))/2.0; }
        dissipation {
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*theta1_dot.powi(2) + I2*N1.powi(2)*alpha_M*theta1_dot.powi(2)/N2.powi(2)
                + I_a*alpha_M*theta_a_dot.powi(2) + I_b*alpha_M*theta_b_dot.powi(2) + I_m*alpha_M*theta_m_dot.powi(2)
                + beta_K*k_a*twist_a_dot.powi(2) + beta_K*k_b*twist_b_dot.powi(2) + beta_K*k_m*twist_m_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the motor" { torques => T_motor*theta_m; }
        governor_motor "torque c n of the governor of the motor; its part -c omega is in D" { governor_motor => c_motor*n_motor*theta_m; }
        dc_motor "torque Ts of the DC motor of the motor; its part -Ts omega/n0 is in D" { dc_motor => Ts_motor*theta_m; }
        induction_motor "torque of the induction motor of the motor" {}
        power { induction_motor => T_induction_motor*theta_m_dot; }
        traction_motor "torque of the traction motor of the motor" {}
        power { traction_motor => T_traction_motor*theta_m_dot; }
        fan_motor "torque of the fan of the motor, against the rotation" {}
        power { fan_motor => T_fan_motor*theta_m_dot; }
        load "load torque of the second shaft's disc, against its rotation" { torques => -T_load*theta_b; }
        governor_load "torque c n of the governor of the second shaft's disc; its part -c omega is in D" {
            governor_load => c_load*n_load*theta_b;
        }
        dc_load "torque Ts of the DC motor of the second shaft's disc; its part -Ts omega/n0 is in D" { dc_load => Ts_load*theta_b; }
        induction_load "torque of the induction motor of the second shaft's disc" {}
        power { induction_load => T_induction_load*theta_b_dot; }
        traction_load "torque of the traction motor of the second shaft's disc" {}
        power { traction_load => T_traction_load*theta_b_dot; }
        fan_load "torque of the fan of the second shaft's disc, against the rotation" {}
        power { fan_load => T_fan_load*theta_b_dot; }
    }
    work {
        theta_m {
            torques => T_motor;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
        }
        theta_b {
            torques => -T_load;
            governor_load => c_load*n_load;
            dc_load => Ts_load;
        }
    }
    mass {
        theta1 theta1 { _ => I1 + I2*N1.powi(2)/N2.powi(2); }
        theta_m theta_m { _ => I_m; }
        theta_a theta_a { _ => I_a; }
        theta_b theta_b { _ => I_b; }
    }
    force {
        theta1 {
            _ => k_m*twist_m - N1*k_b*twist_b/N2 - k_a*twist_a;
            damping => beta_K*k_m*twist_m_dot - I1*alpha_M*theta1_dot - I2*N1.powi(2)*alpha_M*theta1_dot/N2.powi(2)
                - N1*beta_K*k_b*twist_b_dot/N2 - beta_K*k_a*twist_a_dot;
        }
        theta_m {
            _ => -k_m*twist_m;
            torques => T_motor;
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
            damping => -I_m*alpha_M*theta_m_dot - beta_K*k_m*twist_m_dot;
        }
        theta_a {
            _ => k_a*twist_a;
            damping => beta_K*k_a*twist_a_dot - I_a*alpha_M*theta_a_dot;
        }
        theta_b {
            _ => k_b*twist_b;
            torques => -T_load;
            governor_load => c_load*n_load - c_load*theta_load_dot;
            dc_load => Ts_load - Ts_load*theta_load_dot/n0_load;
            induction_load => T_induction_load;
            traction_load => T_traction_load;
            fan_load => T_fan_load;
            damping => beta_K*k_b*twist_b_dot - I_b*alpha_M*theta_b_dot;
        }
    }
    jacobian {
        theta1 theta1_dot { damping => -I1*alpha_M - I2*N1.powi(2)*alpha_M/N2.powi(2); }
        theta1 twist_m { _ => k_m; }
        theta1 twist_a { _ => -k_a; }
        theta1 twist_b { _ => -N1*k_b/N2; }
        theta1 twist_m_dot { damping => beta_K*k_m; }
        theta1 twist_a_dot { damping => -beta_K*k_a; }
        theta1 twist_b_dot { damping => -N1*beta_K*k_b/N2; }
        theta_m theta_m_dot { damping => -I_m*alpha_M; }
        theta_m twist_m { _ => -k_m; }
        theta_m twist_m_dot { damping => -beta_K*k_m; }
        theta_m theta_motor_dot {
            governor_motor => -c_motor;
            dc_motor => -Ts_motor/n0_motor;
            induction_motor => T_induction_motor_by_theta_motor_dot;
            traction_motor => T_traction_motor_by_theta_motor_dot;
            fan_motor => T_fan_motor_by_theta_motor_dot;
        }
        theta_a theta_a_dot { damping => -I_a*alpha_M; }
        theta_a twist_a { _ => k_a; }
        theta_a twist_a_dot { damping => beta_K*k_a; }
        theta_b theta_b_dot { damping => -I_b*alpha_M; }
        theta_b twist_b { _ => k_b; }
        theta_b twist_b_dot { damping => beta_K*k_b; }
        theta_b theta_load_dot {
            governor_load => -c_load;
            dc_load => -Ts_load/n0_load;
            induction_load => T_induction_load_by_theta_load_dot;
            traction_load => T_traction_load_by_theta_load_dot;
            fan_load => T_fan_load_by_theta_load_dot;
        }
    }
    cell {
        stiffness {
            twist_m twist_m { _ => k_m; }
            twist_a twist_a { _ => k_a; }
            twist_b twist_b { _ => k_b; }
        }
        damping {
            theta1 theta1 { damping => I1*alpha_M + I2*N1.powi(2)*alpha_M/N2.powi(2); }
            theta_m theta_m { damping => I_m*alpha_M; }
            theta_a theta_a { damping => I_a*alpha_M; }
            theta_b theta_b { damping => I_b*alpha_M; }
            twist_m twist_m { damping => beta_K*k_m; }
            twist_a twist_a { damping => beta_K*k_a; }
            twist_b twist_b { damping => beta_K*k_b; }
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
            theta_m {
                torques => T_motor;
                governor_motor => c_motor*n_motor;
                dc_motor => Ts_motor;
            }
            theta_b {
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
        rotor_speed_m "rad/s", "rotational speed of the motor" { _ => theta_m_dot; }
        rotor_speed_1 "rad/s", "rotational speed of the first shaft's gear" { _ => theta1_dot; }
        rotor_speed_2 "rad/s", "rotational speed of the second shaft's gear" { _ => N1*theta1_dot/N2; }
        rotor_speed_a "rad/s", "rotational speed of the first shaft's disc" { _ => theta_a_dot; }
        rotor_speed_b "rad/s", "rotational speed of the second shaft's disc" { _ => theta_b_dot; }
        shaft_twist_m "rad", "twist of the motor's shaft" { _ => twist_m; }
        shaft_torque_m "N*m", "torque in the motor's shaft, damper included" {
            _ => k_m*twist_m;
            damping => beta_K*k_m*twist_m_dot;
        }
        shaft_power_m "W", "power that enters the motor's shaft at its first end: torque times the speed of that end" {
            _ => theta_m_dot*shaft_torque_m;
        }
        shaft_loss_m "W", "power that the damper of the motor's shaft takes" { damping => beta_K*k_m*twist_m_dot.powi(2); }
        shaft_twist_a "rad", "twist of the shaft to the first disc" { _ => twist_a; }
        shaft_torque_a "N*m", "torque in the shaft to the first disc, damper included" {
            _ => k_a*twist_a;
            damping => beta_K*k_a*twist_a_dot;
        }
        shaft_power_a "W", "power that enters the shaft to the first disc at its first end: torque times the speed of that end" {
            _ => theta1_dot*shaft_torque_a;
        }
        shaft_loss_a "W", "power that the damper of the shaft to the first disc takes" { damping => beta_K*k_a*twist_a_dot.powi(2); }
        shaft_twist_b "rad", "twist of the shaft to the second disc" { _ => twist_b; }
        shaft_torque_b "N*m", "torque in the shaft to the second disc, damper included" {
            _ => k_b*twist_b;
            damping => beta_K*k_b*twist_b_dot;
        }
        shaft_power_b "W", "power that enters the shaft to the second disc at its first end: torque times the speed of that end" {
            _ => N1*theta1_dot*shaft_torque_b/N2;
        }
        shaft_loss_b "W", "power that the damper of the shaft to the second disc takes" { damping => beta_K*k_b*twist_b_dot.powi(2); }
        power_motor "W" with torques, "power of the driving torque of the motor: positive if it drives" { _ => motor_power; }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the motor; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the motor; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor, "power of the torque of the induction motor of the motor: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor, "power of the torque of the traction motor of the motor: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor, "power of the torque of the fan of the motor, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        power_load "W" with torques, "power of the load torque of the second shaft's disc, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the second shaft's disc; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the second shaft's disc; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load,
            "power of the torque of the induction motor of the second shaft's disc: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load,
            "power of the torque of the traction motor of the second shaft's disc: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load,
            "power of the torque of the fan of the second shaft's disc, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*theta1_dot.powi(2) + I2*N1.powi(2)*theta1_dot.powi(2)/N2.powi(2) + I_a*theta_a_dot.powi(2)
                + I_b*theta_b_dot.powi(2) + I_m*theta_m_dot.powi(2))/2.0);
        }
    }

    text "text/geared_branches.txt";
    latex "latex/geared_branches.tex";
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
// | constants (once a scene) | 0 | 2 | 0 |
// | named forces | 30 | 78 | 6 |
// | force | 13 | 44 | 0 |
