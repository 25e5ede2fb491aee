//! Equations of motion of `idler`: two gears with an idler between them.
//!
//! Derived from the energies in `models/src/idler.rs` by `cargo xtask derive idler`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/idler.txt`, `latex/idler.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model idler "two gears with an idler between them";
    source "standard torsional model; phase as Oh, Grosh & Barber (2005), on the idler";

    coordinates {
        theta "rad" start 0.0, "rotation of the idler times N2; one pitch is 2 pi";
        delta1 "m" start static, "deflection of the mesh of gears 1 and 2";
        delta2 "m" start static, "deflection of the mesh of gears 2 and 3";
    }
    parameters {
        N1 "1" teeth required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" teeth required, open 0.0 to inf, "number of teeth of gear 2";
        N3 "1" teeth required, open 0.0 to inf, "number of teeth of gear 3";
        r2 "m" base_radius required, open 0.0 to inf, "base radius of the idler";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the idler";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        b12 "m" required with backlash_12, open 0.0 to inf, "backlash of the mesh of gears 1 and 2: no contact within b/2 to either side";
        b23 "m" required with backlash_23, open 0.0 to inf, "backlash of the mesh of gears 2 and 3: no contact within b/2 to either side";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "working pressure angle, for friction";
        mu12 "1" required with sliding_friction_12, from 0.0 to inf, "coefficient of friction of the mesh of gears 1 and 2";
        w_mix12 "rad/s" default 0.1 with sliding_friction_12, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of gears 1 and 2 below which friction decreases to zero (mixed film)";
        mu_rise12 "1" default 0.0 with flank_stiction_12, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of gears 1 and 2 over that of sliding, relative to that";
        mu23 "1" required with sliding_friction_23, from 0.0 to inf, "coefficient of friction of the mesh of gears 2 and 3";
        w_mix23 "rad/s" default 0.1 with sliding_friction_23, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of gears 2 and 3 below which friction decreases to zero (mixed film)";
        mu_rise23 "1" default 0.0 with flank_stiction_23, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of gears 2 and 3 over that of sliding, relative to that";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the driving gear";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the driving gear: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the driving gear";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the driving gear";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the driving gear";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the driving gear, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the driving gear has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the driving gear";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf,
            "peak torque of the traction motor of the driving gear, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the driving gear, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the driving gear: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the driving gear at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the driving gear divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the driving gear below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the driven gear, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the driven gear: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the driven gear";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the driven gear";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the driven gear";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the driven gear, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the driven gear has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the driven gear";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the driven gear, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the driven gear, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the driven gear: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the driven gear at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the driven gear divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the driven gear below which the torque of its fan is linear instead of quadratic in the speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of gears 1 and 2 along the line of action";
        k23 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of gears 2 and 3 along the line of action";
        e12 "m" phase theta period 6.283185307179586 rolling with transmission_error_12,
            "transmission error of the mesh of gears 1 and 2 along the line of action";
        e23 "m" phase theta period 6.283185307179586 rolling with transmission_error_23,
            "transmission error of the mesh of gears 2 and 3 along the line of action";
        side12 "1" phase theta period 6.283185307179586 rolling with sliding_friction_12 as side,
            "share of the force of the mesh of gears 1 and 2 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm12 "m" phase theta period 6.283185307179586 rolling with sliding_friction_12 as arm,
            "mean distance of the force of the mesh of gears 1 and 2 from the pitch point along the line of action";
        side23 "1" phase theta period 6.283185307179586 rolling with sliding_friction_23 as side,
            "share of the force of the mesh of gears 2 and 3 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm23 "m" phase theta period 6.283185307179586 rolling with sliding_friction_23 as arm,
            "mean distance of the force of the mesh of gears 2 and 3 from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear"; }
    effects {
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_12 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_12 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        transmission_error_23 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_23 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_12 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_12 of flank_stiction requires(sliding_friction_12)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        sliding_friction_23 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_23 of flank_stiction requires(sliding_friction_23)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
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
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_12_and_jump_terms = transmission_error_12, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_23_and_jump_terms = transmission_error_23, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_12_and_sliding_friction_12_and_moving_phase = transmission_error_12, sliding_friction_12, stiffness_step,
            !frozen_phase;
        transmission_error_23_and_sliding_friction_23_and_moving_phase = transmission_error_23, sliding_friction_23, stiffness_step,
            !frozen_phase;
        sliding_friction_12_and_moving_phase = sliding_friction_12, stiffness_step, !frozen_phase;
        sliding_friction_23_and_moving_phase = sliding_friction_23, stiffness_step, !frozen_phase;
        transmission_error_12_and_backlash_12_and_moving_phase = transmission_error_12, backlash_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_moving_phase = transmission_error_12, stiffness_step, !frozen_phase;
        backlash_12_and_moving_phase = backlash_12, stiffness_step, !frozen_phase;
        transmission_error_23_and_backlash_23_and_moving_phase = transmission_error_23, backlash_23, stiffness_step, !frozen_phase;
        transmission_error_23_and_moving_phase = transmission_error_23, stiffness_step, !frozen_phase;
        backlash_23_and_moving_phase = backlash_23, stiffness_step, !frozen_phase;
    }

    constants {
        h = r2/N2;
        tan_a = alpha.sin()/alpha.cos();
        tiny12 = 1.0/1000000000000.0;
        tiny23 = 1.0/1000000000000.0;
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        over12 = delta1 - edge12 - e12;
        over23 = delta2 - edge23 - e23;
        tau12 = tan_a*delta1;
        psi12 = delta1/(h*N1) + theta/N1 + theta/N2;
        tau23 = tan_a*delta2;
        psi23 = theta/N2 - delta2/(h*N3) + theta/N3;
        theta_motor = delta1/(h*N1) + theta/N1;
        theta_load = theta/N3 - delta2/(h*N3);
    }
    forces {
        F_mu12 {
            sliding_friction_12 => mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_tau12 { sliding_friction_12 => F_mu12*over12/(tiny12.powi(2) + over12.powi(2)).sqrt(); }
        F_mu23 {
            sliding_friction_23 => mu23*k23*touch23*psi23_dot*(tiny23.powi(2) + over23.powi(2)).sqrt()
                /(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt();
            flank_stiction_23 => mu23*k23*slide_dir23*touch23*(tiny23.powi(2) + over23.powi(2)).sqrt()
                - mu23*k23*touch23*psi23_dot*(tiny23.powi(2) + over23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt();
        }
        F_tau23 { sliding_friction_23 => F_mu23*over23/(tiny23.powi(2) + over23.powi(2)).sqrt(); }
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
        F_mu12_by_over12 {
            sliding_friction_12 => mu12*k12*touch12*over12*psi12_dot
                /((tiny12.powi(2) + over12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*over12/(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*over12*psi12_dot/((tiny12.powi(2) + over12.powi(2)).sqrt()*(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt());
        }
        F_mu12_by_psi12_dot {
            sliding_friction_12 => mu12*k12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot.powi(2)*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_12 => mu12*k12*touch12*psi12_dot.powi(2)*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).powf(3.0/2.0)
                - mu12*k12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_mu12_by_k12 {
            sliding_friction_12 => mu12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
        F_tau12_by_over12 {
            sliding_friction_12 => F_mu12/(tiny12.powi(2) + over12.powi(2)).sqrt()
                - F_mu12*over12.powi(2)/(tiny12.powi(2) + over12.powi(2)).powf(3.0/2.0);
        }
        F_tau12_by_F_mu12 { sliding_friction_12 => over12/(tiny12.powi(2) + over12.powi(2)).sqrt(); }
        F_mu23_by_over23 {
            sliding_friction_23 => mu23*k23*touch23*over23*psi23_dot
                /((tiny23.powi(2) + over23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
            flank_stiction_23 => mu23*k23*slide_dir23*touch23*over23/(tiny23.powi(2) + over23.powi(2)).sqrt()
                - mu23*k23*touch23*over23*psi23_dot/((tiny23.powi(2) + over23.powi(2)).sqrt()*(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt());
        }
        F_mu23_by_psi23_dot {
            sliding_friction_23 => mu23*k23*touch23*(tiny23.powi(2) + over23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt()
                - mu23*k23*touch23*psi23_dot.powi(2)*(tiny23.powi(2) + over23.powi(2)).sqrt()
                /(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_23 => mu23*k23*touch23*psi23_dot.powi(2)*(tiny23.powi(2) + over23.powi(2)).sqrt()
                /(w_mix23.powi(2) + psi23_dot.powi(2)).powf(3.0/2.0)
                - mu23*k23*touch23*(tiny23.powi(2) + over23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt();
        }
        F_mu23_by_k23 {
            sliding_friction_23 => mu23*touch23*psi23_dot*(tiny23.powi(2) + over23.powi(2)).sqrt()
                /(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt();
            flank_stiction_23 => mu23*slide_dir23*touch23*(tiny23.powi(2) + over23.powi(2)).sqrt()
                - mu23*touch23*psi23_dot*(tiny23.powi(2) + over23.powi(2)).sqrt()/(w_mix23.powi(2) + psi23_dot.powi(2)).sqrt();
        }
        F_tau23_by_over23 {
            sliding_friction_23 => F_mu23/(tiny23.powi(2) + over23.powi(2)).sqrt()
                - F_mu23*over23.powi(2)/(tiny23.powi(2) + over23.powi(2)).powf(3.0/2.0);
        }
        F_tau23_by_F_mu23 { sliding_friction_23 => over23/(tiny23.powi(2) + over23.powi(2)).sqrt(); }
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
    switches {
        over12 "m" (touch12 1.0, edge12 0.0, damp12 1.0, clip12 0.0) with backlash_12, "play of the mesh of gears 1 and 2" {
            upper (1.0, b12/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper_loose {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until upper_hit {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            lower (1.0, -b12/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower_loose {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until lower_hit {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    over12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
                until lower {
                    over12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            upper_hit (1.0, b12/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            lower_hit (1.0, -b12/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            upper_loose (1.0, b12/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
            }
            lower_loose (1.0, -b12/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
            }
            loss { over12 { _ => k12*clip12*touch12; } }
        }
        over23 "m" (touch23 1.0, edge23 0.0, damp23 1.0, clip23 0.0) with backlash_23, "play of the mesh of gears 2 and 3" {
            upper (1.0, b23/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over23 { _ => 1.0; } }
                until upper_loose {
                    over23 { _ => k23; }
                    over23_dot { damping => beta_K*k23_mid; }
                }
                until upper_hit {
                    over23 { _ => k23; }
                    over23_dot { damping => -beta_K*k23_mid; }
                }
            }
            lower (1.0, -b23/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { over23 { _ => -1.0; } }
                until lower_loose {
                    over23 { _ => -k23; }
                    over23_dot { damping => -beta_K*k23_mid; }
                }
                until lower_hit {
                    over23 { _ => -k23; }
                    over23_dot { damping => beta_K*k23_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    over23 { _ => -1.0; }
                    one { _ => b23/2.0; }
                }
                until lower {
                    over23 { _ => 1.0; }
                    one { _ => b23/2.0; }
                }
            }
            upper_hit (1.0, b23/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over23 { _ => 1.0; } }
                until upper {
                    over23 { _ => -k23; }
                    over23_dot { damping => beta_K*k23_mid; }
                }
            }
            lower_hit (1.0, -b23/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { over23 { _ => -1.0; } }
                until lower {
                    over23 { _ => k23; }
                    over23_dot { damping => -beta_K*k23_mid; }
                }
            }
            upper_loose (1.0, b23/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over23 { _ => 1.0; } }
                until upper {
                    over23 { _ => -k23; }
                    over23_dot { damping => -beta_K*k23_mid; }
                }
            }
            lower_loose (1.0, -b23/2.0, 0.0, -1.0) counts "flanks met" {
                until free { over23 { _ => -1.0; } }
                until lower {
                    over23 { _ => k23; }
                    over23_dot { damping => beta_K*k23_mid; }
                }
            }
            loss { over23 { _ => k23*clip23*touch23; } }
        }
        psi12 "rad" (slide_dir12 0.0) with flank_stiction_12, "whether the flanks of the mesh of gears 1 and 2 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { over12 { _ => 1.0; } }
                until forward {
                    over12 { _ => mu12*mu_rise12*k12*touch12 + mu12*k12*touch12; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    over12 { _ => mu12*mu_rise12*k12*touch12 + mu12*k12*touch12; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { over12 { _ => -1.0; } }
                until forward_coast {
                    over12 { _ => -mu12*mu_rise12*k12*touch12 - mu12*k12*touch12; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    over12 { _ => -mu12*mu_rise12*k12*touch12 - mu12*k12*touch12; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { over12 { _ => 1.0; } }
                until stuck {
                    psi12_dot { _ => arm12; }
                    tau12_dot { _ => side12; }
                }
            }
            backward (-1.0) {
                until backward_coast { over12 { _ => 1.0; } }
                until stuck {
                    psi12_dot { _ => -arm12; }
                    tau12_dot { _ => -side12; }
                }
            }
            forward_coast (1.0) {
                until forward { over12 { _ => -1.0; } }
                until stuck_coast {
                    psi12_dot { _ => arm12; }
                    tau12_dot { _ => -side12; }
                }
            }
            backward_coast (-1.0) {
                until backward { over12 { _ => -1.0; } }
                until stuck_coast {
                    psi12_dot { _ => -arm12; }
                    tau12_dot { _ => side12; }
                }
            }
        }
        psi23 "rad" (slide_dir23 0.0) with flank_stiction_23, "whether the flanks of the mesh of gears 2 and 3 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { over23 { _ => 1.0; } }
                until forward {
                    over23 { _ => mu23*mu_rise23*k23*touch23 + mu23*k23*touch23; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    over23 { _ => mu23*mu_rise23*k23*touch23 + mu23*k23*touch23; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { over23 { _ => -1.0; } }
                until forward_coast {
                    over23 { _ => -mu23*mu_rise23*k23*touch23 - mu23*k23*touch23; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    over23 { _ => -mu23*mu_rise23*k23*touch23 - mu23*k23*touch23; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { over23 { _ => 1.0; } }
                until stuck {
                    psi23_dot { _ => arm23; }
                    tau23_dot { _ => side23; }
                }
            }
            backward (-1.0) {
                until backward_coast { over23 { _ => 1.0; } }
                until stuck {
                    psi23_dot { _ => -arm23; }
                    tau23_dot { _ => -side23; }
                }
            }
            forward_coast (1.0) {
                until forward { over23 { _ => -1.0; } }
                until stuck_coast {
                    psi23_dot { _ => arm23; }
                    tau23_dot { _ => -side23; }
                }
            }
            backward_coast (-1.0) {
                until backward { over23 { _ => -1.0; } }
                until stuck_coast {
                    psi23_dot { _ => -arm23; }
                    tau23_dot { _ => side23; }
                }
            }
        }
    }
    energies {
        kinetic {
            _ => (I1*(delta1_dot/(h*N1) + theta_dot/N1).powi(2) + I2*theta_dot.powi(2)/N2.powi(2)
                + I3*(theta_dot/N3 - delta2_dot/(h*N3)).powi(2))/2.0;
        }
        potential { _ => (k12*touch12*over12.powi(2) + k23*touch23*over23.powi(2))/2.0; }
        dissipation {
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*(delta1_dot/(h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*theta_dot.powi(2)/N2.powi(2)
                + I3*alpha_M*(theta_dot/N3 - delta2_dot/(h*N3)).powi(2) + beta_K*k12_mid*damp12*over12_dot.powi(2)
                + beta_K*k23_mid*damp23*over23_dot.powi(2))/2.0;
        }
    }
    torques {
        slide12 "friction of the mesh of gears 1 and 2, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_12 => -side12*F_tau12*tau12_dot; }
        roll12 "friction of the mesh of gears 1 and 2, through the rolling of the gears" {}
        power { sliding_friction_12 => -arm12*F_mu12*psi12_dot; }
        slide23 "friction of the mesh of gears 2 and 3, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_23 => -side23*F_tau23*tau23_dot; }
        roll23 "friction of the mesh of gears 2 and 3, through the rolling of the gears" {}
        power { sliding_friction_23 => -arm23*F_mu23*psi23_dot; }
        motor "driving torque of the driving gear" { torques => T_motor*(delta1/(h*N1) + theta/N1); }
        governor_motor "torque c n of the governor of the driving gear; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*(delta1/(h*N1) + theta/N1);
        }
        dc_motor "torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D" {
            dc_motor => Ts_motor*(delta1/(h*N1) + theta/N1);
        }
        induction_motor "torque of the induction motor of the driving gear" {}
        power { induction_motor => T_induction_motor*(delta1_dot/(h*N1) + theta_dot/N1); }
        traction_motor "torque of the traction motor of the driving gear" {}
        power { traction_motor => T_traction_motor*(delta1_dot/(h*N1) + theta_dot/N1); }
        fan_motor "torque of the fan of the driving gear, against the rotation" {}
        power { fan_motor => T_fan_motor*(delta1_dot/(h*N1) + theta_dot/N1); }
        load "load torque of the driven gear, against its rotation" { torques => T_load*(delta2/(h*N3) - theta/N3); }
        governor_load "torque c n of the governor of the driven gear; its part -c omega is in D" {
            governor_load => c_load*n_load*(theta/N3 - delta2/(h*N3));
        }
        dc_load "torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D" {
            dc_load => Ts_load*(theta/N3 - delta2/(h*N3));
        }
        induction_load "torque of the induction motor of the driven gear" {}
        power { induction_load => T_induction_load*(theta_dot/N3 - delta2_dot/(h*N3)); }
        traction_load "torque of the traction motor of the driven gear" {}
        power { traction_load => T_traction_load*(theta_dot/N3 - delta2_dot/(h*N3)); }
        fan_load "torque of the fan of the driven gear, against the rotation" {}
        power { fan_load => T_fan_load*(theta_dot/N3 - delta2_dot/(h*N3)); }
    }
    work {
        theta {
            torques => T_motor/N1 - T_load/N3;
            governor_motor => c_motor*n_motor/N1;
            dc_motor => Ts_motor/N1;
            governor_load => c_load*n_load/N3;
            dc_load => Ts_load/N3;
        }
        delta1 {
            torques => T_motor/(h*N1);
            governor_motor => c_motor*n_motor/(h*N1);
            dc_motor => Ts_motor/(h*N1);
        }
        delta2 {
            torques => T_load/(h*N3);
            governor_load => -c_load*n_load/(h*N3);
            dc_load => -Ts_load/(h*N3);
        }
    }
    mass {
        theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2) + I3/N3.powi(2); }
        theta delta1 { _ => I1/(h*N1.powi(2)); }
        theta delta2 { _ => -I3/(h*N3.powi(2)); }
        delta1 delta1 { _ => I1/(h.powi(2)*N1.powi(2)); }
        delta2 delta2 { _ => I3/(h.powi(2)*N3.powi(2)); }
    }
    force {
        theta {
            transmission_error_12_and_jump_terms => k12*de12*touch12*over12;
            transmission_error_23_and_jump_terms => k23*de23*touch23*over23;
            sliding_friction_12 => -arm12*F_mu12/N1 - arm12*F_mu12/N2;
            sliding_friction_23 => -arm23*F_mu23/N2 - arm23*F_mu23/N3;
            torques => T_motor/N1 - T_load/N3;
            governor_motor => c_motor*n_motor/N1 - c_motor*theta_motor_dot/N1;
            dc_motor => Ts_motor/N1 - Ts_motor*theta_motor_dot/(N1*n0_motor);
            induction_motor => T_induction_motor/N1;
            traction_motor => T_traction_motor/N1;
            fan_motor => T_fan_motor/N1;
            governor_load => c_load*n_load/N3 - c_load*theta_load_dot/N3;
            dc_load => Ts_load/N3 - Ts_load*theta_load_dot/(N3*n0_load);
            induction_load => T_induction_load/N3;
            traction_load => T_traction_load/N3;
            fan_load => T_fan_load/N3;
            damping => I3*alpha_M*delta2_dot/(h*N3.powi(2)) - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2)
                - I3*alpha_M*theta_dot/N3.powi(2) - I1*alpha_M*delta1_dot/(h*N1.powi(2));
            jump_terms => (-dk12*touch12*over12.powi(2) - dk23*touch23*over23.powi(2))/2.0;
        }
        delta1 {
            _ => -k12*touch12*over12;
            backlash_12 => -k12*clip12*touch12*over12;
            sliding_friction_12 => -tan_a*side12*F_tau12 - arm12*F_mu12/(h*N1);
            torques => T_motor/(h*N1);
            governor_motor => c_motor*n_motor/(h*N1) - c_motor*theta_motor_dot/(h*N1);
            dc_motor => Ts_motor/(h*N1) - Ts_motor*theta_motor_dot/(h*N1*n0_motor);
            induction_motor => T_induction_motor/(h*N1);
            traction_motor => T_traction_motor/(h*N1);
            fan_motor => T_fan_motor/(h*N1);
            damping => -beta_K*k12_mid*damp12*over12_dot - I1*alpha_M*delta1_dot/(h.powi(2)*N1.powi(2))
                - I1*alpha_M*theta_dot/(h*N1.powi(2));
        }
        delta2 {
            _ => -k23*touch23*over23;
            backlash_23 => -k23*clip23*touch23*over23;
            sliding_friction_23 => arm23*F_mu23/(h*N3) - tan_a*side23*F_tau23;
            torques => T_load/(h*N3);
            governor_load => c_load*theta_load_dot/(h*N3) - c_load*n_load/(h*N3);
            dc_load => Ts_load*theta_load_dot/(h*N3*n0_load) - Ts_load/(h*N3);
            induction_load => -T_induction_load/(h*N3);
            traction_load => -T_traction_load/(h*N3);
            fan_load => -T_fan_load/(h*N3);
            damping => I3*alpha_M*theta_dot/(h*N3.powi(2)) - beta_K*k23_mid*damp23*over23_dot
                - I3*alpha_M*delta2_dot/(h.powi(2)*N3.powi(2));
        }
    }
    jacobian {
        theta theta {
            transmission_error_12_and_sliding_friction_12_and_moving_phase => de12*arm12*F_mu12_by_over12/N1
                + de12*arm12*F_mu12_by_over12/N2;
            transmission_error_12_and_jump_terms => k12*dde12*touch12*over12 - k12*de12.powi(2)*touch12 + 2.0*de12*dk12*touch12*over12;
            transmission_error_23_and_sliding_friction_23_and_moving_phase => de23*arm23*F_mu23_by_over23/N2
                + de23*arm23*F_mu23_by_over23/N3;
            transmission_error_23_and_jump_terms => k23*dde23*touch23*over23 - k23*de23.powi(2)*touch23 + 2.0*de23*dk23*touch23*over23;
            sliding_friction_12_and_moving_phase => -darm12*F_mu12/N1 - dk12*arm12*F_mu12_by_k12/N1 - darm12*F_mu12/N2
                - dk12*arm12*F_mu12_by_k12/N2;
            sliding_friction_23_and_moving_phase => -darm23*F_mu23/N2 - dk23*arm23*F_mu23_by_k23/N2 - darm23*F_mu23/N3
                - dk23*arm23*F_mu23_by_k23/N3;
            jump_terms => (-ddk12*touch12*over12.powi(2) - ddk23*touch23*over23.powi(2))/2.0;
        }
        theta theta_dot { damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I3*alpha_M/N3.powi(2); }
        theta delta1_dot { damping => -I1*alpha_M/(h*N1.powi(2)); }
        theta delta2_dot { damping => I3*alpha_M/(h*N3.powi(2)); }
        theta over12 {
            transmission_error_12_and_jump_terms => k12*de12*touch12;
            sliding_friction_12 => -arm12*F_mu12_by_over12/N1 - arm12*F_mu12_by_over12/N2;
            jump_terms => -dk12*touch12*over12;
        }
        theta over23 {
            transmission_error_23_and_jump_terms => k23*de23*touch23;
            sliding_friction_23 => -arm23*F_mu23_by_over23/N2 - arm23*F_mu23_by_over23/N3;
            jump_terms => -dk23*touch23*over23;
        }
        theta psi12_dot { sliding_friction_12 => -arm12*F_mu12_by_psi12_dot/N1 - arm12*F_mu12_by_psi12_dot/N2; }
        theta psi23_dot { sliding_friction_23 => -arm23*F_mu23_by_psi23_dot/N2 - arm23*F_mu23_by_psi23_dot/N3; }
        theta theta_motor_dot {
            governor_motor => -c_motor/N1;
            dc_motor => -Ts_motor/(N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/N1;
            traction_motor => T_traction_motor_by_theta_motor_dot/N1;
            fan_motor => T_fan_motor_by_theta_motor_dot/N1;
        }
        theta theta_load_dot {
            governor_load => -c_load/N3;
            dc_load => -Ts_load/(N3*n0_load);
            induction_load => T_induction_load_by_theta_load_dot/N3;
            traction_load => T_traction_load_by_theta_load_dot/N3;
            fan_load => T_fan_load_by_theta_load_dot/N3;
        }
        delta1 theta {
            transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => tan_a*de12*side12*F_mu12_by_over12*F_tau12_by_F_mu12
                + tan_a*de12*side12*F_tau12_by_over12 + de12*arm12*F_mu12_by_over12/(h*N1);
            transmission_error_12_and_moving_phase => k12*de12*touch12;
            backlash_12_and_moving_phase => -dk12*clip12*touch12*over12;
            sliding_friction_12_and_moving_phase => -tan_a*dk12*side12*F_mu12_by_k12*F_tau12_by_F_mu12 - tan_a*dside12*F_tau12
                - darm12*F_mu12/(h*N1) - dk12*arm12*F_mu12_by_k12/(h*N1);
            moving_phase => -dk12*touch12*over12;
        }
        delta1 theta_dot { damping => -I1*alpha_M/(h*N1.powi(2)); }
        delta1 delta1_dot { damping => -I1*alpha_M/(h.powi(2)*N1.powi(2)); }
        delta1 over12 {
            _ => -k12*touch12;
            backlash_12 => -k12*clip12*touch12;
            sliding_friction_12 => -tan_a*side12*F_mu12_by_over12*F_tau12_by_F_mu12 - tan_a*side12*F_tau12_by_over12
                - arm12*F_mu12_by_over12/(h*N1);
        }
        delta1 over12_dot { damping => -beta_K*k12_mid*damp12; }
        delta1 psi12_dot { sliding_friction_12 => -tan_a*side12*F_mu12_by_psi12_dot*F_tau12_by_F_mu12 - arm12*F_mu12_by_psi12_dot/(h*N1); }
        delta1 theta_motor_dot {
            governor_motor => -c_motor/(h*N1);
            dc_motor => -Ts_motor/(h*N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/(h*N1);
            traction_motor => T_traction_motor_by_theta_motor_dot/(h*N1);
            fan_motor => T_fan_motor_by_theta_motor_dot/(h*N1);
        }
        delta2 theta {
            transmission_error_23_and_backlash_23_and_moving_phase => k23*de23*clip23*touch23;
            transmission_error_23_and_sliding_friction_23_and_moving_phase => tan_a*de23*side23*F_mu23_by_over23*F_tau23_by_F_mu23
                + tan_a*de23*side23*F_tau23_by_over23 - de23*arm23*F_mu23_by_over23/(h*N3);
            transmission_error_23_and_moving_phase => k23*de23*touch23;
            backlash_23_and_moving_phase => -dk23*clip23*touch23*over23;
            sliding_friction_23_and_moving_phase => darm23*F_mu23/(h*N3) - tan_a*dk23*side23*F_mu23_by_k23*F_tau23_by_F_mu23
                - tan_a*dside23*F_tau23 + dk23*arm23*F_mu23_by_k23/(h*N3);
            moving_phase => -dk23*touch23*over23;
        }
        delta2 theta_dot { damping => I3*alpha_M/(h*N3.powi(2)); }
        delta2 delta2_dot { damping => -I3*alpha_M/(h.powi(2)*N3.powi(2)); }
        delta2 over23 {
            _ => -k23*touch23;
            backlash_23 => -k23*clip23*touch23;
            sliding_friction_23 => arm23*F_mu23_by_over23/(h*N3) - tan_a*side23*F_mu23_by_over23*F_tau23_by_F_mu23
                - tan_a*side23*F_tau23_by_over23;
        }
        delta2 over23_dot { damping => -beta_K*k23_mid*damp23; }
        delta2 psi23_dot { sliding_friction_23 => arm23*F_mu23_by_psi23_dot/(h*N3) - tan_a*side23*F_mu23_by_psi23_dot*F_tau23_by_F_mu23; }
        delta2 theta_load_dot {
            governor_load => c_load/(h*N3);
            dc_load => Ts_load/(h*N3*n0_load);
            induction_load => -T_induction_load_by_theta_load_dot/(h*N3);
            traction_load => -T_traction_load_by_theta_load_dot/(h*N3);
            fan_load => -T_fan_load_by_theta_load_dot/(h*N3);
        }
    }
    cell {
        stiffness {
            over12 over12 {
                _ => k12*touch12;
                backlash_12 => k12*clip12*touch12;
            }
            over23 over23 {
                _ => k23*touch23;
                backlash_23 => k23*clip23*touch23;
            }
        }
        damping {
            theta theta { damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I3*alpha_M/N3.powi(2); }
            theta delta1 { damping => I1*alpha_M/(h*N1.powi(2)); }
            theta delta2 { damping => -I3*alpha_M/(h*N3.powi(2)); }
            delta1 delta1 { damping => I1*alpha_M/(h.powi(2)*N1.powi(2)); }
            delta2 delta2 { damping => I3*alpha_M/(h.powi(2)*N3.powi(2)); }
            over12 over12 { damping => beta_K*k12_mid*damp12; }
            over23 over23 { damping => beta_K*k23_mid*damp23; }
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
            theta {
                torques => T_motor/N1 - T_load/N3;
                governor_motor => c_motor*n_motor/N1;
                dc_motor => Ts_motor/N1;
                governor_load => c_load*n_load/N3;
                dc_load => Ts_load/N3;
            }
            delta1 {
                torques => T_motor/(h*N1);
                governor_motor => c_motor*n_motor/(h*N1);
                dc_motor => Ts_motor/(h*N1);
            }
            delta2 {
                torques => T_load/(h*N3);
                governor_load => -c_load*n_load/(h*N3);
                dc_load => -Ts_load/(h*N3);
            }
            over12 {
                _ => k12*touch12*edge12 + k12*touch12*e12;
                backlash_12 => k12*clip12*touch12*edge12 + k12*clip12*touch12*e12;
            }
            over23 {
                _ => k23*touch23*edge23 + k23*touch23*e23;
                backlash_23 => k23*clip23*touch23*edge23 + k23*clip23*touch23*e23;
            }
        }
    }
    nonlinear_with {
        sliding_friction_12 "-side12*F_tau12 in the torque `slide12`";
        sliding_friction_12 "-arm12*F_mu12 in the torque `roll12`";
        sliding_friction_23 "-side23*F_tau23 in the torque `slide23`";
        sliding_friction_23 "-arm23*F_mu23 in the torque `roll23`";
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
    }
    jump k12 { step { _ => dk12*touch12*over12.powi(2)/2.0; } }
    jump k23 { step { _ => dk23*touch23*over23.powi(2)/2.0; } }
    jump e12 { step { _ => k12*de12.powi(2)*touch12/2.0 - k12*de12*touch12*over12; } }
    jump e23 { step { _ => k23*de23.powi(2)*touch23/2.0 - k23*de23*touch23*over23; } }
    jump side12 { step {} }
    jump arm12 { step {} }
    jump side23 { step {} }
    jump arm23 { step {} }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the driving gear" { _ => delta1_dot/(h*N1) + theta_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the idler" { _ => theta_dot/N2; }
        rotor_speed_3 "rad/s", "rotational speed of the driven gear" { _ => theta_dot/N3 - delta2_dot/(h*N3); }
        contact_loss_12 "1" with backlash_12,
            "1 while no force passes the mesh of gears 1 and 2, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch12*(1.0 + clip12*(1.0 - clip12)/2.0);
        }
        mesh_force_12 "N",
            "force of the mesh of gears 1 and 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k12*touch12*over12;
            backlash_12 => k12*clip12*touch12*over12;
            damping => beta_K*k12_mid*damp12*over12_dot;
        }
        mesh_power_12 "W", "power that the first gear gives to the mesh of gears 1 and 2: force times the speed of its flank" {
            _ => mesh_force_12*(delta1_dot + h*theta_dot);
        }
        mesh_deflection_12 "m", "deflection of the mesh of gears 1 and 2 along the line of action, backlash not taken off" {
            _ => delta1 - e12;
        }
        dte_12 "m",
            "dynamic transmission error of the mesh of gears 1 and 2 along the line of action: positive if the driving gear is ahead" {
            _ => delta1;
        }
        mesh_loss_12 "W", "power that the damper of the mesh of gears 1 and 2 takes" {
            backlash_12 => k12*clip12*touch12*over12*over12_dot;
            damping => beta_K*k12_mid*damp12*over12_dot.powi(2);
        }
        contact_loss_23 "1" with backlash_23,
            "1 while no force passes the mesh of gears 2 and 3, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch23*(1.0 + clip23*(1.0 - clip23)/2.0);
        }
        mesh_force_23 "N",
            "force of the mesh of gears 2 and 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k23*touch23*over23;
            backlash_23 => k23*clip23*touch23*over23;
            damping => beta_K*k23_mid*damp23*over23_dot;
        }
        mesh_power_23 "W", "power that the first gear gives to the mesh of gears 2 and 3: force times the speed of its flank" {
            _ => h*theta_dot*mesh_force_23;
        }
        mesh_deflection_23 "m", "deflection of the mesh of gears 2 and 3 along the line of action, backlash not taken off" {
            _ => delta2 - e23;
        }
        dte_23 "m",
            "dynamic transmission error of the mesh of gears 2 and 3 along the line of action: positive if the driving gear is ahead" {
            _ => delta2;
        }
        mesh_loss_23 "W", "power that the damper of the mesh of gears 2 and 3 takes" {
            backlash_23 => k23*clip23*touch23*over23*over23_dot;
            damping => beta_K*k23_mid*damp23*over23_dot.powi(2);
        }
        power_slide12 "W" with sliding_friction_12,
            "power of the friction of the mesh of gears 1 and 2, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide12_power;
        }
        power_roll12 "W" with sliding_friction_12,
            "power of the friction of the mesh of gears 1 and 2, through the rolling of the gears: positive if it drives" {
            _ => roll12_power;
        }
        power_slide23 "W" with sliding_friction_23,
            "power of the friction of the mesh of gears 2 and 3, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide23_power;
        }
        power_roll23 "W" with sliding_friction_23,
            "power of the friction of the mesh of gears 2 and 3, through the rolling of the gears: positive if it drives" {
            _ => roll23_power;
        }
        power_motor "W" with torques, "power of the driving torque of the driving gear: positive if it drives" { _ => motor_power; }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the driving gear; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor,
            "power of the torque of the induction motor of the driving gear: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor,
            "power of the torque of the traction motor of the driving gear: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor,
            "power of the torque of the fan of the driving gear, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        power_load "W" with torques, "power of the load torque of the driven gear, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the driven gear; its part -c omega is in D: positive if it drives" {
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
            "power of the torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load,
            "power of the torque of the induction motor of the driven gear: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the driven gear: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load, "power of the torque of the fan of the driven gear, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*((I1*(delta1_dot/(h*N1) + theta_dot/N1).powi(2) + I2*theta_dot.powi(2)/N2.powi(2)
                + I3*(theta_dot/N3 - delta2_dot/(h*N3)).powi(2))/2.0);
        }
    }

    text "text/idler.txt";
    latex "latex/idler.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: every leading minor is a sum of products of positive quantities
// - at a step of k12, k23, e12, e23: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged
//   in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side12, arm12, side23, arm23: no impulse there
// - V is the same on both sides of the exits of over12: no impulse there
// - the force of the switch over12 takes energy or none: f over12_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dover12 and c = 1 or -1, since F over12 >= 0, over12_dot dD/dover12_dot >= 0 and c over12
//   dD/dover12_dot >= F over12
// - V is the same on both sides of the exits of over23: no impulse there
// - the force of the switch over23 takes energy or none: f over23_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dover23 and c = 1 or -1, since F over23 >= 0, over23_dot dD/dover23_dot >= 0 and c over23
//   dD/dover23_dot >= F over23
// - V is the same on both sides of the exits of psi12: no impulse there
// - V is the same on both sides of the exits of psi23: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll12` takes energy or none: its power is never positive
// - the friction `roll23` takes energy or none: its power is never positive
// - the friction `slide12` is the force of `roll12` times at most 1, along its sign or against it
// - the friction `slide12` takes with `roll12` energy or none where psi12_dot and arm12 psi12_dot + side12 tau12_dot have one sign, on the
//   coast flank with -side12: where flanks slide as rolling makes them
// - the friction `slide12` takes with `roll12` energy or none in every mode of psi12, in scenes with flank_stiction_12: from the guards
//   that hold in the mode
// - the friction `slide23` is the force of `roll23` times at most 1, along its sign or against it
// - the friction `slide23` takes with `roll23` energy or none where psi23_dot and arm23 psi23_dot + side23 tau23_dot have one sign, on the
//   coast flank with -side23: where flanks slide as rolling makes them
// - the friction `slide23` takes with `roll23` energy or none in every mode of psi23, in scenes with flank_stiction_23: from the guards
//   that hold in the mode
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk12*touch12*over12^2*theta_dot/2 -
//   k12*de12*touch12*over12*theta_dot - k23*de23*touch23*over23*theta_dot + dk23*touch23*over23^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 0 | 4 | 2 |
// | named forces | 44 | 134 | 18 |
// | force | 22 | 156 | 0 |
// | energy steps, all laws | 2 | 22 | 0 |
