//! Equations of motion of `chain_32`: a torsional chain of 32 discs.
//!
//! Derived from the energies in `models/src/chain.rs` by `cargo xtask derive chain_32`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/chain_32.txt`, `latex/chain_32.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model chain_32 "a torsional chain of 32 discs";
    source "e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9";

    coordinates {
        theta1 "rad" start 0.0, "rotation of disc 1";
        theta2 "rad" start static, "rotation of disc 2";
        theta3 "rad" start static, "rotation of disc 3";
        theta4 "rad" start static, "rotation of disc 4";
        theta5 "rad" start static, "rotation of disc 5";
        theta6 "rad" start static, "rotation of disc 6";
        theta7 "rad" start static, "rotation of disc 7";
        theta8 "rad" start static, "rotation of disc 8";
        theta9 "rad" start static, "rotation of disc 9";
        theta10 "rad" start static, "rotation of disc 10";
        theta11 "rad" start static, "rotation of disc 11";
        theta12 "rad" start static, "rotation of disc 12";
        theta13 "rad" start static, "rotation of disc 13";
        theta14 "rad" start static, "rotation of disc 14";
        theta15 "rad" start static, "rotation of disc 15";
        theta16 "rad" start static, "rotation of disc 16";
        theta17 "rad" start static, "rotation of disc 17";
        theta18 "rad" start static, "rotation of disc 18";
        theta19 "rad" start static, "rotation of disc 19";
        theta20 "rad" start static, "rotation of disc 20";
        theta21 "rad" start static, "rotation of disc 21";
        theta22 "rad" start static, "rotation of disc 22";
        theta23 "rad" start static, "rotation of disc 23";
        theta24 "rad" start static, "rotation of disc 24";
        theta25 "rad" start static, "rotation of disc 25";
        theta26 "rad" start static, "rotation of disc 26";
        theta27 "rad" start static, "rotation of disc 27";
        theta28 "rad" start static, "rotation of disc 28";
        theta29 "rad" start static, "rotation of disc 29";
        theta30 "rad" start static, "rotation of disc 30";
        theta31 "rad" start static, "rotation of disc 31";
        theta32 "rad" start static, "rotation of disc 32";
    }
    parameters {
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 1";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 2";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 3";
        I4 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 4";
        I5 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 5";
        I6 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 6";
        I7 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 7";
        I8 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 8";
        I9 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 9";
        I10 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 10";
        I11 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 11";
        I12 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 12";
        I13 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 13";
        I14 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 14";
        I15 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 15";
        I16 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 16";
        I17 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 17";
        I18 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 18";
        I19 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 19";
        I20 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 20";
        I21 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 21";
        I22 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 22";
        I23 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 23";
        I24 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 24";
        I25 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 25";
        I26 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 26";
        I27 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 27";
        I28 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 28";
        I29 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 29";
        I30 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 30";
        I31 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 31";
        I32 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 32";
        k1 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 1 and 2";
        k2 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 2 and 3";
        k3 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 3 and 4";
        k4 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 4 and 5";
        k5 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 5 and 6";
        k6 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 6 and 7";
        k7 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 7 and 8";
        k8 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 8 and 9";
        k9 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 9 and 10";
        k10 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 10 and 11";
        k11 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 11 and 12";
        k12 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 12 and 13";
        k13 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 13 and 14";
        k14 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 14 and 15";
        k15 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 15 and 16";
        k16 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 16 and 17";
        k17 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 17 and 18";
        k18 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 18 and 19";
        k19 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 19 and 20";
        k20 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 20 and 21";
        k21 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 21 and 22";
        k22 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 22 and 23";
        k23 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 23 and 24";
        k24 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 24 and 25";
        k25 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 25 and 26";
        k26 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 26 and 27";
        k27 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 27 and 28";
        k28 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 28 and 29";
        k29 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 29 and 30";
        k30 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 30 and 31";
        k31 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 31 and 32";
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
    motions {
        speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; theta3_dot = 1.0; theta4_dot = 1.0; theta5_dot = 1.0; theta6_dot = 1.0;
            theta7_dot = 1.0; theta8_dot = 1.0; theta9_dot = 1.0; theta10_dot = 1.0; theta11_dot = 1.0; theta12_dot = 1.0; theta13_dot =
            1.0; theta14_dot = 1.0; theta15_dot = 1.0; theta16_dot = 1.0; theta17_dot = 1.0; theta18_dot = 1.0; theta19_dot = 1.0;
            theta20_dot = 1.0; theta21_dot = 1.0; theta22_dot = 1.0; theta23_dot = 1.0; theta24_dot = 1.0; theta25_dot = 1.0; theta26_dot
            = 1.0; theta27_dot = 1.0; theta28_dot = 1.0; theta29_dot = 1.0; theta30_dot = 1.0; theta31_dot = 1.0; theta32_dot = 1.0; },
            "rotational speed of the shaft";
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
        twist1 = theta1 - theta2;
        twist2 = theta2 - theta3;
        twist3 = theta3 - theta4;
        twist4 = theta4 - theta5;
        twist5 = theta5 - theta6;
        twist6 = theta6 - theta7;
        twist7 = theta7 - theta8;
        twist8 = theta8 - theta9;
        twist9 = theta9 - theta10;
        twist10 = theta10 - theta11;
        twist11 = theta11 - theta12;
        twist12 = theta12 - theta13;
        twist13 = theta13 - theta14;
        twist14 = theta14 - theta15;
        twist15 = theta15 - theta16;
        twist16 = theta16 - theta17;
        twist17 = theta17 - theta18;
        twist18 = theta18 - theta19;
        twist19 = theta19 - theta20;
        twist20 = theta20 - theta21;
        twist21 = theta21 - theta22;
        twist22 = theta22 - theta23;
        twist23 = theta23 - theta24;
        twist24 = theta24 - theta25;
        twist25 = theta25 - theta26;
        twist26 = theta26 - theta27;
        twist27 = theta27 - theta28;
        twist28 = theta28 - theta29;
        twist29 = theta29 - theta30;
        twist30 = theta30 - theta31;
        twist31 = theta31 - theta32;
        theta_motor = theta1;
        theta_load = theta32;
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
            _ => (I1*theta1_dot.powi(2) + I10*theta10_dot.powi(2) + I11*theta11_dot.powi(2) + I12*theta12_dot.powi(2)
                + I13*theta13_dot.powi(2) + I14*theta14_dot.powi(2) + I15*theta15_dot.powi(2) + I16*theta16_dot.powi(2)
                + I17*theta17_dot.powi(2) + I18*theta18_dot.powi(2) + I19*theta19_dot.powi(2) + I2*theta2_dot.powi(2)
                + I20*theta20_dot.powi(2) + I21*theta21_dot.powi(2) + I22*theta22_dot.powi(2) + I23*theta23_dot.powi(2)
                + I24*theta24_dot.powi(2) + I25*theta25_dot.powi(2) + I26*theta26_dot.powi(2) + I27*theta27_dot.powi(2)
                + I28*theta28_dot.powi(2) + I29*theta29_dot.powi(2) + I3*theta3_dot.powi(2) + I30*theta30_dot.powi(2)
                + I31*theta31_dot.powi(2) + I32*theta32_dot.powi(2) + I4*theta4_dot.powi(2) + I5*theta5_dot.powi(2)
                + I6*theta6_dot.powi(2) + I7*theta7_dot.powi(2) + I8*theta8_dot.powi(2) + I9*theta9_dot.powi(2))/2.0;
        }
        potential {
            _ => (k1*twist1.powi(2) + k10*twist10.powi(2) + k11*twist11.powi(2) + k12*twist12.powi(2) + k13*twist13.powi(2)
                + k14*twist14.powi(2) + k15*twist15.powi(2) + k16*twist16.powi(2) + k17*twist17.powi(2) + k18*twist18.powi(2)
                + k19*twist19.powi(2) + k2*twist2.powi(2) + k20*twist20.powi(2) + k21*twist21.powi(2) + k22*twist22.powi(2)
                + k23*twist23.powi(2) + k24*twist24.powi(2) + k25*twist25.powi(2) + k26*twist26.powi(2) + k27*twist27.powi(2)
                + k28*twist28.powi(2) + k29*twist29.powi(2) + k3*twist3.powi(2) + k30*twist30.powi(2) + k31*twist31.powi(2)
                + k4*twist4.powi(2) + k5*twist5.powi(2) + k6*twist6.powi(2) + k7*twist7.powi(2) + k8*twist8.powi(2)
                + k9*twist9.powi(2))/2.0;
        }
        dissipation {
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*theta1_dot.powi(2) + I10*alpha_M*theta10_dot.powi(2) + I11*alpha_M*theta11_dot.powi(2)
                + I12*alpha_M*theta12_dot.powi(2) + I13*alpha_M*theta13_dot.powi(2) + I14*alpha_M*theta14_dot.powi(2)
                + I15*alpha_M*theta15_dot.powi(2) + I16*alpha_M*theta16_dot.powi(2) + I17*alpha_M*theta17_dot.powi(2)
                + I18*alpha_M*theta18_dot.powi(2) + I19*alpha_M*theta19_dot.powi(2) + I2*alpha_M*theta2_dot.powi(2)
                + I20*alpha_M*theta20_dot.powi(2) + I21*alpha_M*theta21_dot.powi(2) + I22*alpha_M*theta22_dot.powi(2)
                + I23*alpha_M*theta23_dot.powi(2) + I24*alpha_M*theta24_dot.powi(2) + I25*alpha_M*theta25_dot.powi(2)
                + I26*alpha_M*theta26_dot.powi(2) + I27*alpha_M*theta27_dot.powi(2) + I28*alpha_M*theta28_dot.powi(2)
                + I29*alpha_M*theta29_dot.powi(2) + I3*alpha_M*theta3_dot.powi(2) + I30*alpha_M*theta30_dot.powi(2)
                + I31*alpha_M*theta31_dot.powi(2) + I32*alpha_M*theta32_dot.powi(2) + I4*alpha_M*theta4_dot.powi(2)
                + I5*alpha_M*theta5_dot.powi(2) + I6*alpha_M*theta6_dot.powi(2) + I7*alpha_M*theta7_dot.powi(2)
                + I8*alpha_M*theta8_dot.powi(2) + I9*alpha_M*theta9_dot.powi(2) + beta_K*k1*twist1_dot.powi(2)
                + beta_K*k10*twist10_dot.powi(2) + beta_K*k11*twist11_dot.powi(2) + beta_K*k12*twist12_dot.powi(2)
                + beta_K*k13*twist13_dot.powi(2) + beta_K*k14*twist14_dot.powi(2) + beta_K*k15*twist15_dot.powi(2)
                + beta_K*k16*twist16_dot.powi(2) + beta_K*k17*twist17_dot.powi(2) + beta_K*k18*twist18_dot.powi(2)
                + beta_K*k19*twist19_dot.powi(2) + beta_K*k2*twist2_dot.powi(2) + beta_K*k20*twist20_dot.powi(2)
                + beta_K*k21*twist21_dot.powi(2) + beta_K*k22*twist22_dot.powi(2) + beta_K*k23*twist23_dot.powi(2)
                + beta_K*k24*twist24_dot.powi(2) + beta_K*k25*twist25_dot.powi(2) + beta_K*k26*twist26_dot.powi(2)
                + beta_K*k27*twist27_dot.powi(2) + beta_K*k28*twist28_dot.powi(2) + beta_K*k29*twist29_dot.powi(2)
                + beta_K*k3*twist3_dot.powi(2) + beta_K*k30*twist30_dot.powi(2) + beta_K*k31*twist31_dot.powi(2)
                + beta_K*k4*twist4_dot.powi(2) + beta_K*k5*twist5_dot.powi(2) + beta_K*k6*twist6_dot.powi(2)
                + beta_K*k7*twist7_dot.powi(2) + beta_K*k8*twist8_dot.powi(2) + beta_K*k9*twist9_dot.powi(2))/2.0;
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
        load "load torque of the last disc, against its rotation" { torques => -T_load*theta32; }
        governor_load "torque c n of the governor of the last disc; its part -c omega is in D" { governor_load => c_load*n_load*theta32; }
        dc_load "torque Ts of the DC motor of the last disc; its part -Ts omega/n0 is in D" { dc_load => Ts_load*theta32; }
        induction_load "torque of the induction motor of the last disc" {}
        power { induction_load => T_induction_load*theta32_dot; }
        traction_load "torque of the traction motor of the last disc" {}
        power { traction_load => T_traction_load*theta32_dot; }
        fan_load "torque of the fan of the last disc, against the rotation" {}
        power { fan_load => T_fan_load*theta32_dot; }
    }
    work {
        theta1 {
            torques => T_motor;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
        }
        theta32 {
            torques => -T_load;
            governor_load => c_load*n_load;
            dc_load => Ts_load;
        }
    }
    mass {
        theta1 theta1 { _ => I1; }
        theta2 theta2 { _ => I2; }
        theta3 theta3 { _ => I3; }
        theta4 theta4 { _ => I4; }
        theta5 theta5 { _ => I5; }
        theta6 theta6 { _ => I6; }
        theta7 theta7 { _ => I7; }
        theta8 theta8 { _ => I8; }
        theta9 theta9 { _ => I9; }
        theta10 theta10 { _ => I10; }
        theta11 theta11 { _ => I11; }
        theta12 theta12 { _ => I12; }
        theta13 theta13 { _ => I13; }
        theta14 theta14 { _ => I14; }
        theta15 theta15 { _ => I15; }
        theta16 theta16 { _ => I16; }
        theta17 theta17 { _ => I17; }
        theta18 theta18 { _ => I18; }
        theta19 theta19 { _ => I19; }
        theta20 theta20 { _ => I20; }
        theta21 theta21 { _ => I21; }
        theta22 theta22 { _ => I22; }
        theta23 theta23 { _ => I23; }
        theta24 theta24 { _ => I24; }
        theta25 theta25 { _ => I25; }
        theta26 theta26 { _ => I26; }
        theta27 theta27 { _ => I27; }
        theta28 theta28 { _ => I28; }
        theta29 theta29 { _ => I29; }
        theta30 theta30 { _ => I30; }
        theta31 theta31 { _ => I31; }
        theta32 theta32 { _ => I32; }
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
            _ => k4*twist4 - k5*twist5;
            damping => beta_K*k4*twist4_dot - I5*alpha_M*theta5_dot - beta_K*k5*twist5_dot;
        }
        theta6 {
            _ => k5*twist5 - k6*twist6;
            damping => beta_K*k5*twist5_dot - I6*alpha_M*theta6_dot - beta_K*k6*twist6_dot;
        }
        theta7 {
            _ => k6*twist6 - k7*twist7;
            damping => beta_K*k6*twist6_dot - I7*alpha_M*theta7_dot - beta_K*k7*twist7_dot;
        }
        theta8 {
            _ => k7*twist7 - k8*twist8;
            damping => beta_K*k7*twist7_dot - I8*alpha_M*theta8_dot - beta_K*k8*twist8_dot;
        }
        theta9 {
            _ => k8*twist8 - k9*twist9;
            damping => beta_K*k8*twist8_dot - I9*alpha_M*theta9_dot - beta_K*k9*twist9_dot;
        }
        theta10 {
            _ => k9*twist9 - k10*twist10;
            damping => beta_K*k9*twist9_dot - I10*alpha_M*theta10_dot - beta_K*k10*twist10_dot;
        }
        theta11 {
            _ => k10*twist10 - k11*twist11;
            damping => beta_K*k10*twist10_dot - I11*alpha_M*theta11_dot - beta_K*k11*twist11_dot;
        }
        theta12 {
            _ => k11*twist11 - k12*twist12;
            damping => beta_K*k11*twist11_dot - I12*alpha_M*theta12_dot - beta_K*k12*twist12_dot;
        }
        theta13 {
            _ => k12*twist12 - k13*twist13;
            damping => beta_K*k12*twist12_dot - I13*alpha_M*theta13_dot - beta_K*k13*twist13_dot;
        }
        theta14 {
            _ => k13*twist13 - k14*twist14;
            damping => beta_K*k13*twist13_dot - I14*alpha_M*theta14_dot - beta_K*k14*twist14_dot;
        }
        theta15 {
            _ => k14*twist14 - k15*twist15;
            damping => beta_K*k14*twist14_dot - I15*alpha_M*theta15_dot - beta_K*k15*twist15_dot;
        }
        theta16 {
            _ => k15*twist15 - k16*twist16;
            damping => beta_K*k15*twist15_dot - I16*alpha_M*theta16_dot - beta_K*k16*twist16_dot;
        }
        theta17 {
            _ => k16*twist16 - k17*twist17;
            damping => beta_K*k16*twist16_dot - I17*alpha_M*theta17_dot - beta_K*k17*twist17_dot;
        }
        theta18 {
            _ => k17*twist17 - k18*twist18;
            damping => beta_K*k17*twist17_dot - I18*alpha_M*theta18_dot - beta_K*k18*twist18_dot;
        }
        theta19 {
            _ => k18*twist18 - k19*twist19;
            damping => beta_K*k18*twist18_dot - I19*alpha_M*theta19_dot - beta_K*k19*twist19_dot;
        }
        theta20 {
            _ => k19*twist19 - k20*twist20;
            damping => beta_K*k19*twist19_dot - I20*alpha_M*theta20_dot - beta_K*k20*twist20_dot;
        }
        theta21 {
            _ => k20*twist20 - k21*twist21;
            damping => beta_K*k20*twist20_dot - I21*alpha_M*theta21_dot - beta_K*k21*twist21_dot;
        }
        theta22 {
            _ => k21*twist21 - k22*twist22;
            damping => beta_K*k21*twist21_dot - I22*alpha_M*theta22_dot - beta_K*k22*twist22_dot;
        }
        theta23 {
            _ => k22*twist22 - k23*twist23;
            damping => beta_K*k22*twist22_dot - I23*alpha_M*theta23_dot - beta_K*k23*twist23_dot;
        }
        theta24 {
            _ => k23*twist23 - k24*twist24;
            damping => beta_K*k23*twist23_dot - I24*alpha_M*theta24_dot - beta_K*k24*twist24_dot;
        }
        theta25 {
            _ => k24*twist24 - k25*twist25;
            damping => beta_K*k24*twist24_dot - I25*alpha_M*theta25_dot - beta_K*k25*twist25_dot;
        }
        theta26 {
            _ => k25*twist25 - k26*twist26;
            damping => beta_K*k25*twist25_dot - I26*alpha_M*theta26_dot - beta_K*k26*twist26_dot;
        }
        theta27 {
            _ => k26*twist26 - k27*twist27;
            damping => beta_K*k26*twist26_dot - I27*alpha_M*theta27_dot - beta_K*k27*twist27_dot;
        }
        theta28 {
            _ => k27*twist27 - k28*twist28;
            damping => beta_K*k27*twist27_dot - I28*alpha_M*theta28_dot - beta_K*k28*twist28_dot;
        }
        theta29 {
            _ => k28*twist28 - k29*twist29;
            damping => beta_K*k28*twist28_dot - I29*alpha_M*theta29_dot - beta_K*k29*twist29_dot;
        }
        theta30 {
            _ => k29*twist29 - k30*twist30;
            damping => beta_K*k29*twist29_dot - I30*alpha_M*theta30_dot - beta_K*k30*twist30_dot;
        }
        theta31 {
            _ => k30*twist30 - k31*twist31;
            damping => beta_K*k30*twist30_dot - I31*alpha_M*theta31_dot - beta_K*k31*twist31_dot;
        }
        theta32 {
            _ => k31*twist31;
            torques => -T_load;
            governor_load => c_load*n_load - c_load*theta_load_dot;
            dc_load => Ts_load - Ts_load*theta_load_dot/n0_load;
            induction_load => T_induction_load;
            traction_load => T_traction_load;
            fan_load => T_fan_load;
            damping => beta_K*k31*twist31_dot - I32*alpha_M*theta32_dot;
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
        theta2 twist2 { _ => -k2; }
        theta2 twist1_dot { damping => beta_K*k1; }
        theta2 twist2_dot { damping => -beta_K*k2; }
        theta3 theta3_dot { damping => -I3*alpha_M; }
        theta3 twist2 { _ => k2; }
        theta3 twist3 { _ => -k3; }
        theta3 twist2_dot { damping => beta_K*k2; }
        theta3 twist3_dot { damping => -beta_K*k3; }
        theta4 theta4_dot { damping => -I4*alpha_M; }
        theta4 twist3 { _ => k3; }
        theta4 twist4 { _ => -k4; }
        theta4 twist3_dot { damping => beta_K*k3; }
        theta4 twist4_dot { damping => -beta_K*k4; }
        theta5 theta5_dot { damping => -I5*alpha_M; }
        theta5 twist4 { _ => k4; }
        theta5 twist5 { _ => -k5; }
        theta5 twist4_dot { damping => beta_K*k4; }
        theta5 twist5_dot { damping => -beta_K*k5; }
        theta6 theta6_dot { damping => -I6*alpha_M; }
        theta6 twist5 { _ => k5; }
        theta6 twist6 { _ => -k6; }
        theta6 twist5_dot { damping => beta_K*k5; }
        theta6 twist6_dot { damping => -beta_K*k6; }
        theta7 theta7_dot { damping => -I7*alpha_M; }
        theta7 twist6 { _ => k6; }
        theta7 twist7 { _ => -k7; }
        theta7 twist6_dot { damping => beta_K*k6; }
        theta7 twist7_dot { damping => -beta_K*k7; }
        theta8 theta8_dot { damping => -I8*alpha_M; }
        theta8 twist7 { _ => k7; }
        theta8 twist8 { _ => -k8; }
        theta8 twist7_dot { damping => beta_K*k7; }
        theta8 twist8_dot { damping => -beta_K*k8; }
        theta9 theta9_dot { damping => -I9*alpha_M; }
        theta9 twist8 { _ => k8; }
        theta9 twist9 { _ => -k9; }
        theta9 twist8_dot { damping => beta_K*k8; }
        theta9 twist9_dot { damping => -beta_K*k9; }
        theta10 theta10_dot { damping => -I10*alpha_M; }
        theta10 twist9 { _ => k9; }
        theta10 twist10 { _ => -k10; }
        theta10 twist9_dot { damping => beta_K*k9; }
        theta10 twist10_dot { damping => -beta_K*k10; }
        theta11 theta11_dot { damping => -I11*alpha_M; }
        theta11 twist10 { _ => k10; }
        theta11 twist11 { _ => -k11; }
        theta11 twist10_dot { damping => beta_K*k10; }
        theta11 twist11_dot { damping => -beta_K*k11; }
        theta12 theta12_dot { damping => -I12*alpha_M; }
        theta12 twist11 { _ => k11; }
        theta12 twist12 { _ => -k12; }
        theta12 twist11_dot { damping => beta_K*k11; }
        theta12 twist12_dot { damping => -beta_K*k12; }
        theta13 theta13_dot { damping => -I13*alpha_M; }
        theta13 twist12 { _ => k12; }
        theta13 twist13 { _ => -k13; }
        theta13 twist12_dot { damping => beta_K*k12; }
        theta13 twist13_dot { damping => -beta_K*k13; }
        theta14 theta14_dot { damping => -I14*alpha_M; }
        theta14 twist13 { _ => k13; }
        theta14 twist14 { _ => -k14; }
        theta14 twist13_dot { damping => beta_K*k13; }
        theta14 twist14_dot { damping => -beta_K*k14; }
        theta15 theta15_dot { damping => -I15*alpha_M; }
        theta15 twist14 { _ => k14; }
        theta15 twist15 { _ => -k15; }
        theta15 twist14_dot { damping => beta_K*k14; }
        theta15 twist15_dot { damping => -beta_K*k15; }
        theta16 theta16_dot { damping => -I16*alpha_M; }
        theta16 twist15 { _ => k15; }
        theta16 twist16 { _ => -k16; }
        theta16 twist15_dot { damping => beta_K*k15; }
        theta16 twist16_dot { damping => -beta_K*k16; }
        theta17 theta17_dot { damping => -I17*alpha_M; }
        theta17 twist16 { _ => k16; }
        theta17 twist17 { _ => -k17; }
        theta17 twist16_dot { damping => beta_K*k16; }
        theta17 twist17_dot { damping => -beta_K*k17; }
        theta18 theta18_dot { damping => -I18*alpha_M; }
        theta18 twist17 { _ => k17; }
        theta18 twist18 { _ => -k18; }
        theta18 twist17_dot { damping => beta_K*k17; }
        theta18 twist18_dot { damping => -beta_K*k18; }
        theta19 theta19_dot { damping => -I19*alpha_M; }
        theta19 twist18 { _ => k18; }
        theta19 twist19 { _ => -k19; }
        theta19 twist18_dot { damping => beta_K*k18; }
        theta19 twist19_dot { damping => -beta_K*k19; }
        theta20 theta20_dot { damping => -I20*alpha_M; }
        theta20 twist19 { _ => k19; }
        theta20 twist20 { _ => -k20; }
        theta20 twist19_dot { damping => beta_K*k19; }
        theta20 twist20_dot { damping => -beta_K*k20; }
        theta21 theta21_dot { damping => -I21*alpha_M; }
        theta21 twist20 { _ => k20; }
        theta21 twist21 { _ => -k21; }
        theta21 twist20_dot { damping => beta_K*k20; }
        theta21 twist21_dot { damping => -beta_K*k21; }
        theta22 theta22_dot { damping => -I22*alpha_M; }
        theta22 twist21 { _ => k21; }
        theta22 twist22 { _ => -k22; }
        theta22 twist21_dot { damping => beta_K*k21; }
        theta22 twist22_dot { damping => -beta_K*k22; }
        theta23 theta23_dot { damping => -I23*alpha_M; }
        theta23 twist22 { _ => k22; }
        theta23 twist23 { _ => -k23; }
        theta23 twist22_dot { damping => beta_K*k22; }
        theta23 twist23_dot { damping => -beta_K*k23; }
        theta24 theta24_dot { damping => -I24*alpha_M; }
        theta24 twist23 { _ => k23; }
        theta24 twist24 { _ => -k24; }
        theta24 twist23_dot { damping => beta_K*k23; }
        theta24 twist24_dot { damping => -beta_K*k24; }
        theta25 theta25_dot { damping => -I25*alpha_M; }
        theta25 twist24 { _ => k24; }
        theta25 twist25 { _ => -k25; }
        theta25 twist24_dot { damping => beta_K*k24; }
        theta25 twist25_dot { damping => -beta_K*k25; }
        theta26 theta26_dot { damping => -I26*alpha_M; }
        theta26 twist25 { _ => k25; }
        theta26 twist26 { _ => -k26; }
        theta26 twist25_dot { damping => beta_K*k25; }
        theta26 twist26_dot { damping => -beta_K*k26; }
        theta27 theta27_dot { damping => -I27*alpha_M; }
        theta27 twist26 { _ => k26; }
        theta27 twist27 { _ => -k27; }
        theta27 twist26_dot { damping => beta_K*k26; }
        theta27 twist27_dot { damping => -beta_K*k27; }
        theta28 theta28_dot { damping => -I28*alpha_M; }
        theta28 twist27 { _ => k27; }
        theta28 twist28 { _ => -k28; }
        theta28 twist27_dot { damping => beta_K*k27; }
        theta28 twist28_dot { damping => -beta_K*k28; }
        theta29 theta29_dot { damping => -I29*alpha_M; }
        theta29 twist28 { _ => k28; }
        theta29 twist29 { _ => -k29; }
        theta29 twist28_dot { damping => beta_K*k28; }
        theta29 twist29_dot { damping => -beta_K*k29; }
        theta30 theta30_dot { damping => -I30*alpha_M; }
        theta30 twist29 { _ => k29; }
        theta30 twist30 { _ => -k30; }
        theta30 twist29_dot { damping => beta_K*k29; }
        theta30 twist30_dot { damping => -beta_K*k30; }
        theta31 theta31_dot { damping => -I31*alpha_M; }
        theta31 twist30 { _ => k30; }
        theta31 twist31 { _ => -k31; }
        theta31 twist30_dot { damping => beta_K*k30; }
        theta31 twist31_dot { damping => -beta_K*k31; }
        theta32 theta32_dot { damping => -I32*alpha_M; }
        theta32 twist31 { _ => k31; }
        theta32 twist31_dot { damping => beta_K*k31; }
        theta32 theta_load_dot {
            governor_load => -c_load;
            dc_load => -Ts_load/n0_load;
            induction_load => T_induction_load_by_theta_load_dot;
            traction_load => T_traction_load_by_theta_load_dot;
            fan_load => T_fan_load_by_theta_load_dot;
        }
    }
    cell {
        stiffness {
            twist1 twist1 { _ => k1; }
            twist2 twist2 { _ => k2; }
            twist3 twist3 { _ => k3; }
            twist4 twist4 { _ => k4; }
            twist5 twist5 { _ => k5; }
            twist6 twist6 { _ => k6; }
            twist7 twist7 { _ => k7; }
            twist8 twist8 { _ => k8; }
            twist9 twist9 { _ => k9; }
            twist10 twist10 { _ => k10; }
            twist11 twist11 { _ => k11; }
            twist12 twist12 { _ => k12; }
            twist13 twist13 { _ => k13; }
            twist14 twist14 { _ => k14; }
            twist15 twist15 { _ => k15; }
            twist16 twist16 { _ => k16; }
            twist17 twist17 { _ => k17; }
            twist18 twist18 { _ => k18; }
            twist19 twist19 { _ => k19; }
            twist20 twist20 { _ => k20; }
            twist21 twist21 { _ => k21; }
            twist22 twist22 { _ => k22; }
            twist23 twist23 { _ => k23; }
            twist24 twist24 { _ => k24; }
            twist25 twist25 { _ => k25; }
            twist26 twist26 { _ => k26; }
            twist27 twist27 { _ => k27; }
            twist28 twist28 { _ => k28; }
            twist29 twist29 { _ => k29; }
            twist30 twist30 { _ => k30; }
            twist31 twist31 { _ => k31; }
        }
        damping {
            theta1 theta1 { damping => I1*alpha_M; }
            theta2 theta2 { damping => I2*alpha_M; }
            theta3 theta3 { damping => I3*alpha_M; }
            theta4 theta4 { damping => I4*alpha_M; }
            theta5 theta5 { damping => I5*alpha_M; }
            theta6 theta6 { damping => I6*alpha_M; }
            theta7 theta7 { damping => I7*alpha_M; }
            theta8 theta8 { damping => I8*alpha_M; }
            theta9 theta9 { damping => I9*alpha_M; }
            theta10 theta10 { damping => I10*alpha_M; }
            theta11 theta11 { damping => I11*alpha_M; }
            theta12 theta12 { damping => I12*alpha_M; }
            theta13 theta13 { damping => I13*alpha_M; }
            theta14 theta14 { damping => I14*alpha_M; }
            theta15 theta15 { damping => I15*alpha_M; }
            theta16 theta16 { damping => I16*alpha_M; }
            theta17 theta17 { damping => I17*alpha_M; }
            theta18 theta18 { damping => I18*alpha_M; }
            theta19 theta19 { damping => I19*alpha_M; }
            theta20 theta20 { damping => I20*alpha_M; }
            theta21 theta21 { damping => I21*alpha_M; }
            theta22 theta22 { damping => I22*alpha_M; }
            theta23 theta23 { damping => I23*alpha_M; }
            theta24 theta24 { damping => I24*alpha_M; }
            theta25 theta25 { damping => I25*alpha_M; }
            theta26 theta26 { damping => I26*alpha_M; }
            theta27 theta27 { damping => I27*alpha_M; }
            theta28 theta28 { damping => I28*alpha_M; }
            theta29 theta29 { damping => I29*alpha_M; }
            theta30 theta30 { damping => I30*alpha_M; }
            theta31 theta31 { damping => I31*alpha_M; }
            theta32 theta32 { damping => I32*alpha_M; }
            twist1 twist1 { damping => beta_K*k1; }
            twist2 twist2 { damping => beta_K*k2; }
            twist3 twist3 { damping => beta_K*k3; }
            twist4 twist4 { damping => beta_K*k4; }
            twist5 twist5 { damping => beta_K*k5; }
            twist6 twist6 { damping => beta_K*k6; }
            twist7 twist7 { damping => beta_K*k7; }
            twist8 twist8 { damping => beta_K*k8; }
            twist9 twist9 { damping => beta_K*k9; }
            twist10 twist10 { damping => beta_K*k10; }
            twist11 twist11 { damping => beta_K*k11; }
            twist12 twist12 { damping => beta_K*k12; }
            twist13 twist13 { damping => beta_K*k13; }
            twist14 twist14 { damping => beta_K*k14; }
            twist15 twist15 { damping => beta_K*k15; }
            twist16 twist16 { damping => beta_K*k16; }
            twist17 twist17 { damping => beta_K*k17; }
            twist18 twist18 { damping => beta_K*k18; }
            twist19 twist19 { damping => beta_K*k19; }
            twist20 twist20 { damping => beta_K*k20; }
            twist21 twist21 { damping => beta_K*k21; }
            twist22 twist22 { damping => beta_K*k22; }
            twist23 twist23 { damping => beta_K*k23; }
            twist24 twist24 { damping => beta_K*k24; }
            twist25 twist25 { damping => beta_K*k25; }
            twist26 twist26 { damping => beta_K*k26; }
            twist27 twist27 { damping => beta_K*k27; }
            twist28 twist28 { damping => beta_K*k28; }
            twist29 twist29 { damping => beta_K*k29; }
            twist30 twist30 { damping => beta_K*k30; }
            twist31 twist31 { damping => beta_K*k31; }
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
            theta32 {
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
        rotor_speed_3 "rad/s", "rotational speed of the disc 3" { _ => theta3_dot; }
        rotor_speed_4 "rad/s", "rotational speed of the disc 4" { _ => theta4_dot; }
        rotor_speed_5 "rad/s", "rotational speed of the disc 5" { _ => theta5_dot; }
        rotor_speed_6 "rad/s", "rotational speed of the disc 6" { _ => theta6_dot; }
        rotor_speed_7 "rad/s", "rotational speed of the disc 7" { _ => theta7_dot; }
        rotor_speed_8 "rad/s", "rotational speed of the disc 8" { _ => theta8_dot; }
        rotor_speed_9 "rad/s", "rotational speed of the disc 9" { _ => theta9_dot; }
        rotor_speed_10 "rad/s", "rotational speed of the disc 10" { _ => theta10_dot; }
        rotor_speed_11 "rad/s", "rotational speed of the disc 11" { _ => theta11_dot; }
        rotor_speed_12 "rad/s", "rotational speed of the disc 12" { _ => theta12_dot; }
        rotor_speed_13 "rad/s", "rotational speed of the disc 13" { _ => theta13_dot; }
        rotor_speed_14 "rad/s", "rotational speed of the disc 14" { _ => theta14_dot; }
        rotor_speed_15 "rad/s", "rotational speed of the disc 15" { _ => theta15_dot; }
        rotor_speed_16 "rad/s", "rotational speed of the disc 16" { _ => theta16_dot; }
        rotor_speed_17 "rad/s", "rotational speed of the disc 17" { _ => theta17_dot; }
        rotor_speed_18 "rad/s", "rotational speed of the disc 18" { _ => theta18_dot; }
        rotor_speed_19 "rad/s", "rotational speed of the disc 19" { _ => theta19_dot; }
        rotor_speed_20 "rad/s", "rotational speed of the disc 20" { _ => theta20_dot; }
        rotor_speed_21 "rad/s", "rotational speed of the disc 21" { _ => theta21_dot; }
        rotor_speed_22 "rad/s", "rotational speed of the disc 22" { _ => theta22_dot; }
        rotor_speed_23 "rad/s", "rotational speed of the disc 23" { _ => theta23_dot; }
        rotor_speed_24 "rad/s", "rotational speed of the disc 24" { _ => theta24_dot; }
        rotor_speed_25 "rad/s", "rotational speed of the disc 25" { _ => theta25_dot; }
        rotor_speed_26 "rad/s", "rotational speed of the disc 26" { _ => theta26_dot; }
        rotor_speed_27 "rad/s", "rotational speed of the disc 27" { _ => theta27_dot; }
        rotor_speed_28 "rad/s", "rotational speed of the disc 28" { _ => theta28_dot; }
        rotor_speed_29 "rad/s", "rotational speed of the disc 29" { _ => theta29_dot; }
        rotor_speed_30 "rad/s", "rotational speed of the disc 30" { _ => theta30_dot; }
        rotor_speed_31 "rad/s", "rotational speed of the disc 31" { _ => theta31_dot; }
        rotor_speed_32 "rad/s", "rotational speed of the disc 32" { _ => theta32_dot; }
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
        shaft_twist_5 "rad", "twist of the shaft between discs 5 and 6" { _ => twist5; }
        shaft_torque_5 "N*m", "torque in the shaft between discs 5 and 6, damper included" {
            _ => k5*twist5;
            damping => beta_K*k5*twist5_dot;
        }
        shaft_power_5 "W", "power that enters the shaft between discs 5 and 6 at its first end: torque times the speed of that end" {
            _ => theta5_dot*shaft_torque_5;
        }
        shaft_loss_5 "W", "power that the damper of the shaft between discs 5 and 6 takes" { damping => beta_K*k5*twist5_dot.powi(2); }
        shaft_twist_6 "rad", "twist of the shaft between discs 6 and 7" { _ => twist6; }
        shaft_torque_6 "N*m", "torque in the shaft between discs 6 and 7, damper included" {
            _ => k6*twist6;
            damping => beta_K*k6*twist6_dot;
        }
        shaft_power_6 "W", "power that enters the shaft between discs 6 and 7 at its first end: torque times the speed of that end" {
            _ => theta6_dot*shaft_torque_6;
        }
        shaft_loss_6 "W", "power that the damper of the shaft between discs 6 and 7 takes" { damping => beta_K*k6*twist6_dot.powi(2); }
        shaft_twist_7 "rad", "twist of the shaft between discs 7 and 8" { _ => twist7; }
        shaft_torque_7 "N*m", "torque in the shaft between discs 7 and 8, damper included" {
            _ => k7*twist7;
            damping => beta_K*k7*twist7_dot;
        }
        shaft_power_7 "W", "power that enters the shaft between discs 7 and 8 at its first end: torque times the speed of that end" {
            _ => theta7_dot*shaft_torque_7;
        }
        shaft_loss_7 "W", "power that the damper of the shaft between discs 7 and 8 takes" { damping => beta_K*k7*twist7_dot.powi(2); }
        shaft_twist_8 "rad", "twist of the shaft between discs 8 and 9" { _ => twist8; }
        shaft_torque_8 "N*m", "torque in the shaft between discs 8 and 9, damper included" {
            _ => k8*twist8;
            damping => beta_K*k8*twist8_dot;
        }
        shaft_power_8 "W", "power that enters the shaft between discs 8 and 9 at its first end: torque times the speed of that end" {
            _ => theta8_dot*shaft_torque_8;
        }
        shaft_loss_8 "W", "power that the damper of the shaft between discs 8 and 9 takes" { damping => beta_K*k8*twist8_dot.powi(2); }
        shaft_twist_9 "rad", "twist of the shaft between discs 9 and 10" { _ => twist9; }
        shaft_torque_9 "N*m", "torque in the shaft between discs 9 and 10, damper included" {
            _ => k9*twist9;
            damping => beta_K*k9*twist9_dot;
        }
        shaft_power_9 "W", "power that enters the shaft between discs 9 and 10 at its first end: torque times the speed of that end" {
            _ => theta9_dot*shaft_torque_9;
        }
        shaft_loss_9 "W", "power that the damper of the shaft between discs 9 and 10 takes" { damping => beta_K*k9*twist9_dot.powi(2); }
        shaft_twist_10 "rad", "twist of the shaft between discs 10 and 11" { _ => twist10; }
        shaft_torque_10 "N*m", "torque in the shaft between discs 10 and 11, damper included" {
            _ => k10*twist10;
            damping => beta_K*k10*twist10_dot;
        }
        shaft_power_10 "W", "power that enters the shaft between discs 10 and 11 at its first end: torque times the speed of that end" {
            _ => theta10_dot*shaft_torque_10;
        }
        shaft_loss_10 "W", "power that the damper of the shaft between discs 10 and 11 takes" { damping => beta_K*k10*twist10_dot.powi(2); }
        shaft_twist_11 "rad", "twist of the shaft between discs 11 and 12" { _ => twist11; }
        shaft_torque_11 "N*m", "torque in the shaft between discs 11 and 12, damper included" {
            _ => k11*twist11;
            damping => beta_K*k11*twist11_dot;
        }
        shaft_power_11 "W", "power that enters the shaft between discs 11 and 12 at its first end: torque times the speed of that end" {
            _ => theta11_dot*shaft_torque_11;
        }
        shaft_loss_11 "W", "power that the damper of the shaft between discs 11 and 12 takes" { damping => beta_K*k11*twist11_dot.powi(2); }
        shaft_twist_12 "rad", "twist of the shaft between discs 12 and 13" { _ => twist12; }
        shaft_torque_12 "N*m", "torque in the shaft between discs 12 and 13, damper included" {
            _ => k12*twist12;
            damping => beta_K*k12*twist12_dot;
        }
        shaft_power_12 "W", "power that enters the shaft between discs 12 and 13 at its first end: torque times the speed of that end" {
            _ => theta12_dot*shaft_torque_12;
        }
        shaft_loss_12 "W", "power that the damper of the shaft between discs 12 and 13 takes" { damping => beta_K*k12*twist12_dot.powi(2); }
        shaft_twist_13 "rad", "twist of the shaft between discs 13 and 14" { _ => twist13; }
        shaft_torque_13 "N*m", "torque in the shaft between discs 13 and 14, damper included" {
            _ => k13*twist13;
            damping => beta_K*k13*twist13_dot;
        }
        shaft_power_13 "W", "power that enters the shaft between discs 13 and 14 at its first end: torque times the speed of that end" {
            _ => theta13_dot*shaft_torque_13;
        }
        shaft_loss_13 "W", "power that the damper of the shaft between discs 13 and 14 takes" { damping => beta_K*k13*twist13_dot.powi(2); }
        shaft_twist_14 "rad", "twist of the shaft between discs 14 and 15" { _ => twist14; }
        shaft_torque_14 "N*m", "torque in the shaft between discs 14 and 15, damper included" {
            _ => k14*twist14;
            damping => beta_K*k14*twist14_dot;
        }
        shaft_power_14 "W", "power that enters the shaft between discs 14 and 15 at its first end: torque times the speed of that end" {
            _ => theta14_dot*shaft_torque_14;
        }
        shaft_loss_14 "W", "power that the damper of the shaft between discs 14 and 15 takes" { damping => beta_K*k14*twist14_dot.powi(2); }
        shaft_twist_15 "rad", "twist of the shaft between discs 15 and 16" { _ => twist15; }
        shaft_torque_15 "N*m", "torque in the shaft between discs 15 and 16, damper included" {
            _ => k15*twist15;
            damping => beta_K*k15*twist15_dot;
        }
        shaft_power_15 "W", "power that enters the shaft between discs 15 and 16 at its first end: torque times the speed of that end" {
            _ => theta15_dot*shaft_torque_15;
        }
        shaft_loss_15 "W", "power that the damper of the shaft between discs 15 and 16 takes" { damping => beta_K*k15*twist15_dot.powi(2); }
        shaft_twist_16 "rad", "twist of the shaft between discs 16 and 17" { _ => twist16; }
        shaft_torque_16 "N*m", "torque in the shaft between discs 16 and 17, damper included" {
            _ => k16*twist16;
            damping => beta_K*k16*twist16_dot;
        }
        shaft_power_16 "W", "power that enters the shaft between discs 16 and 17 at its first end: torque times the speed of that end" {
            _ => theta16_dot*shaft_torque_16;
        }
        shaft_loss_16 "W", "power that the damper of the shaft between discs 16 and 17 takes" { damping => beta_K*k16*twist16_dot.powi(2); }
        shaft_twist_17 "rad", "twist of the shaft between discs 17 and 18" { _ => twist17; }
        shaft_torque_17 "N*m", "torque in the shaft between discs 17 and 18, damper included" {
            _ => k17*twist17;
            damping => beta_K*k17*twist17_dot;
        }
        shaft_power_17 "W", "power that enters the shaft between discs 17 and 18 at its first end: torque times the speed of that end" {
            _ => theta17_dot*shaft_torque_17;
        }
        shaft_loss_17 "W", "power that the damper of the shaft between discs 17 and 18 takes" { damping => beta_K*k17*twist17_dot.powi(2); }
        shaft_twist_18 "rad", "twist of the shaft between discs 18 and 19" { _ => twist18; }
        shaft_torque_18 "N*m", "torque in the shaft between discs 18 and 19, damper included" {
            _ => k18*twist18;
            damping => beta_K*k18*twist18_dot;
        }
        shaft_power_18 "W", "power that enters the shaft between discs 18 and 19 at its first end: torque times the speed of that end" {
            _ => theta18_dot*shaft_torque_18;
        }
        shaft_loss_18 "W", "power that the damper of the shaft between discs 18 and 19 takes" { damping => beta_K*k18*twist18_dot.powi(2); }
        shaft_twist_19 "rad", "twist of the shaft between discs 19 and 20" { _ => twist19; }
        shaft_torque_19 "N*m", "torque in the shaft between discs 19 and 20, damper included" {
            _ => k19*twist19;
            damping => beta_K*k19*twist19_dot;
        }
        shaft_power_19 "W", "power that enters the shaft between discs 19 and 20 at its first end: torque times the speed of that end" {
            _ => theta19_dot*shaft_torque_19;
        }
        shaft_loss_19 "W", "power that the damper of the shaft between discs 19 and 20 takes" { damping => beta_K*k19*twist19_dot.powi(2); }
        shaft_twist_20 "rad", "twist of the shaft between discs 20 and 21" { _ => twist20; }
        shaft_torque_20 "N*m", "torque in the shaft between discs 20 and 21, damper included" {
            _ => k20*twist20;
            damping => beta_K*k20*twist20_dot;
        }
        shaft_power_20 "W", "power that enters the shaft between discs 20 and 21 at its first end: torque times the speed of that end" {
            _ => theta20_dot*shaft_torque_20;
        }
        shaft_loss_20 "W", "power that the damper of the shaft between discs 20 and 21 takes" { damping => beta_K*k20*twist20_dot.powi(2); }
        shaft_twist_21 "rad", "twist of the shaft between discs 21 and 22" { _ => twist21; }
        shaft_torque_21 "N*m", "torque in the shaft between discs 21 and 22, damper included" {
            _ => k21*twist21;
            damping => beta_K*k21*twist21_dot;
        }
        shaft_power_21 "W", "power that enters the shaft between discs 21 and 22 at its first end: torque times the speed of that end" {
            _ => theta21_dot*shaft_torque_21;
        }
        shaft_loss_21 "W", "power that the damper of the shaft between discs 21 and 22 takes" { damping => beta_K*k21*twist21_dot.powi(2); }
        shaft_twist_22 "rad", "twist of the shaft between discs 22 and 23" { _ => twist22; }
        shaft_torque_22 "N*m", "torque in the shaft between discs 22 and 23, damper included" {
            _ => k22*twist22;
            damping => beta_K*k22*twist22_dot;
        }
        shaft_power_22 "W", "power that enters the shaft between discs 22 and 23 at its first end: torque times the speed of that end" {
            _ => theta22_dot*shaft_torque_22;
        }
        shaft_loss_22 "W", "power that the damper of the shaft between discs 22 and 23 takes" { damping => beta_K*k22*twist22_dot.powi(2); }
        shaft_twist_23 "rad", "twist of the shaft between discs 23 and 24" { _ => twist23; }
        shaft_torque_23 "N*m", "torque in the shaft between discs 23 and 24, damper included" {
            _ => k23*twist23;
            damping => beta_K*k23*twist23_dot;
        }
        shaft_power_23 "W", "power that enters the shaft between discs 23 and 24 at its first end: torque times the speed of that end" {
            _ => theta23_dot*shaft_torque_23;
        }
        shaft_loss_23 "W", "power that the damper of the shaft between discs 23 and 24 takes" { damping => beta_K*k23*twist23_dot.powi(2); }
        shaft_twist_24 "rad", "twist of the shaft between discs 24 and 25" { _ => twist24; }
        shaft_torque_24 "N*m", "torque in the shaft between discs 24 and 25, damper included" {
            _ => k24*twist24;
            damping => beta_K*k24*twist24_dot;
        }
        shaft_power_24 "W", "power that enters the shaft between discs 24 and 25 at its first end: torque times the speed of that end" {
            _ => theta24_dot*shaft_torque_24;
        }
        shaft_loss_24 "W", "power that the damper of the shaft between discs 24 and 25 takes" { damping => beta_K*k24*twist24_dot.powi(2); }
        shaft_twist_25 "rad", "twist of the shaft between discs 25 and 26" { _ => twist25; }
        shaft_torque_25 "N*m", "torque in the shaft between discs 25 and 26, damper included" {
            _ => k25*twist25;
            damping => beta_K*k25*twist25_dot;
        }
        shaft_power_25 "W", "power that enters the shaft between discs 25 and 26 at its first end: torque times the speed of that end" {
            _ => theta25_dot*shaft_torque_25;
        }
        shaft_loss_25 "W", "power that the damper of the shaft between discs 25 and 26 takes" { damping => beta_K*k25*twist25_dot.powi(2); }
        shaft_twist_26 "rad", "twist of the shaft between discs 26 and 27" { _ => twist26; }
        shaft_torque_26 "N*m", "torque in the shaft between discs 26 and 27, damper included" {
            _ => k26*twist26;
            damping => beta_K*k26*twist26_dot;
        }
        shaft_power_26 "W", "power that enters the shaft between discs 26 and 27 at its first end: torque times the speed of that end" {
            _ => theta26_dot*shaft_torque_26;
        }
        shaft_loss_26 "W", "power that the damper of the shaft between discs 26 and 27 takes" { damping => beta_K*k26*twist26_dot.powi(2); }
        shaft_twist_27 "rad", "twist of the shaft between discs 27 and 28" { _ => twist27; }
        shaft_torque_27 "N*m", "torque in the shaft between discs 27 and 28, damper included" {
            _ => k27*twist27;
            damping => beta_K*k27*twist27_dot;
        }
        shaft_power_27 "W", "power that enters the shaft between discs 27 and 28 at its first end: torque times the speed of that end" {
            _ => theta27_dot*shaft_torque_27;
        }
        shaft_loss_27 "W", "power that the damper of the shaft between discs 27 and 28 takes" { damping => beta_K*k27*twist27_dot.powi(2); }
        shaft_twist_28 "rad", "twist of the shaft between discs 28 and 29" { _ => twist28; }
        shaft_torque_28 "N*m", "torque in the shaft between discs 28 and 29, damper included" {
            _ => k28*twist28;
            damping => beta_K*k28*twist28_dot;
        }
        shaft_power_28 "W", "power that enters the shaft between discs 28 and 29 at its first end: torque times the speed of that end" {
            _ => theta28_dot*shaft_torque_28;
        }
        shaft_loss_28 "W", "power that the damper of the shaft between discs 28 and 29 takes" { damping => beta_K*k28*twist28_dot.powi(2); }
        shaft_twist_29 "rad", "twist of the shaft between discs 29 and 30" { _ => twist29; }
        shaft_torque_29 "N*m", "torque in the shaft between discs 29 and 30, damper included" {
            _ => k29*twist29;
            damping => beta_K*k29*twist29_dot;
        }
        shaft_power_29 "W", "power that enters the shaft between discs 29 and 30 at its first end: torque times the speed of that end" {
            _ => theta29_dot*shaft_torque_29;
        }
        shaft_loss_29 "W", "power that the damper of the shaft between discs 29 and 30 takes" { damping => beta_K*k29*twist29_dot.powi(2); }
        shaft_twist_30 "rad", "twist of the shaft between discs 30 and 31" { _ => twist30; }
        shaft_torque_30 "N*m", "torque in the shaft between discs 30 and 31, damper included" {
            _ => k30*twist30;
            damping => beta_K*k30*twist30_dot;
        }
        shaft_power_30 "W", "power that enters the shaft between discs 30 and 31 at its first end: torque times the speed of that end" {
            _ => theta30_dot*shaft_torque_30;
        }
        shaft_loss_30 "W", "power that the damper of the shaft between discs 30 and 31 takes" { damping => beta_K*k30*twist30_dot.powi(2); }
        shaft_twist_31 "rad", "twist of the shaft between discs 31 and 32" { _ => twist31; }
        shaft_torque_31 "N*m", "torque in the shaft between discs 31 and 32, damper included" {
            _ => k31*twist31;
            damping => beta_K*k31*twist31_dot;
        }
        shaft_power_31 "W", "power that enters the shaft between discs 31 and 32 at its first end: torque times the speed of that end" {
            _ => theta31_dot*shaft_torque_31;
        }
        shaft_loss_31 "W", "power that the damper of the shaft between discs 31 and 32 takes" { damping => beta_K*k31*twist31_dot.powi(2); }
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
            _ => 2.0*alpha_M*((I1*theta1_dot.powi(2) + I10*theta10_dot.powi(2) + I11*theta11_dot.powi(2) + I12*theta12_dot.powi(2)
                + I13*theta13_dot.powi(2) + I14*theta14_dot.powi(2) + I15*theta15_dot.powi(2) + I16*theta16_dot.powi(2)
                + I17*theta17_dot.powi(2) + I18*theta18_dot.powi(2) + I19*theta19_dot.powi(2) + I2*theta2_dot.powi(2)
                + I20*theta20_dot.powi(2) + I21*theta21_dot.powi(2) + I22*theta22_dot.powi(2) + I23*theta23_dot.powi(2)
                + I24*theta24_dot.powi(2) + I25*theta25_dot.powi(2) + I26*theta26_dot.powi(2) + I27*theta27_dot.powi(2)
                + I28*theta28_dot.powi(2) + I29*theta29_dot.powi(2) + I3*theta3_dot.powi(2) + I30*theta30_dot.powi(2)
                + I31*theta31_dot.powi(2) + I32*theta32_dot.powi(2) + I4*theta4_dot.powi(2) + I5*theta5_dot.powi(2)
                + I6*theta6_dot.powi(2) + I7*theta7_dot.powi(2) + I8*theta8_dot.powi(2) + I9*theta9_dot.powi(2))/2.0);
        }
    }

    text "text/chain_32.txt";
    latex "latex/chain_32.tex";
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
// | constants (once a scene) | 0 | 2 | 0 |
// | named forces | 30 | 78 | 6 |
// | force | 96 | 258 | 0 |
