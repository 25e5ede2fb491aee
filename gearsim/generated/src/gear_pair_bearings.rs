//! Equations of motion of `gear_pair_bearings`: a gear pair on bearings, with x, y and rotation of each gear.
//!
//! Derived from the energies in `models/src/gear_pair_bearings.rs` by `cargo xtask derive gear_pair_bearings`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/gear_pair_bearings.txt`, `latex/gear_pair_bearings.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model gear_pair_bearings "a gear pair on bearings, with x, y and rotation of each gear";
    source "standard plane model, e.g. Kahraman & Singh (1991), J. Sound Vib. 146(1); phase as Oh, Grosh & Barber (2005)";

    coordinates {
        theta "rad" start 0.0, "mean rotation of gears 1 and 2; one pitch is 2 pi";
        s "m" start static, "motion of gear 1 relative to gear 2 along the line of action";
        x1 "m" start static, "x of the centre of gear 1";
        y1 "m" start static, "y of the centre of gear 1";
        x2 "m" start static, "x of the centre of gear 2";
        y2 "m" start static, "y of the centre of gear 2";
    }
    parameters {
        N1 "1" teeth required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" teeth required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" base_radius required, open 0.0 to inf, "base radius of gear 1";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        m1 "kg" required, open 0.0 to inf, "mass of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        m2 "kg" required, open 0.0 to inf, "mass of the driven gear";
        kb1 "N/m" required, from 0.0 to inf, "radial stiffness of the bearing of gear 1";
        cb1 "N*s/m" required with viscous_friction_1, from 0.0 to inf, "radial damping of the bearing of gear 1: force per speed";
        kb2 "N/m" required, from 0.0 to inf, "radial stiffness of the bearing of gear 2";
        cb2 "N*s/m" required with viscous_friction_2, from 0.0 to inf, "radial damping of the bearing of gear 2: force per speed";
        b12 "m" required with backlash_12, open 0.0 to inf, "backlash of the mesh: no contact within b/2 to either side";
        mu12 "1" required with sliding_friction_12, from 0.0 to inf, "coefficient of friction of the mesh";
        w_mix12 "rad/s" default 0.1 with sliding_friction_12, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh below which friction decreases to zero (mixed film)";
        mu_rise12 "1" default 0.0 with flank_stiction_12, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh over that of sliding, relative to that";
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
        k12 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh along the line of action";
        e12 "m" phase theta period 6.283185307179586 rolling with transmission_error_12,
            "transmission error of the mesh along the line of action";
        side12 "1" phase theta period 6.283185307179586 rolling with sliding_friction_12 as side,
            "share of the force of the mesh on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm12 "m" phase theta period 6.283185307179586 rolling with sliding_friction_12 as arm,
            "mean distance of the force of the mesh from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear"; }
    effects {
        viscous_friction_1 of viscous_friction "friction proportional to speed";
        viscous_friction_2 of viscous_friction "friction proportional to speed";
        moving_centres_12 of moving_centres
            "the line of action turns with the gears' centres, the pressure angle follows their distance, and the play opens with it";
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_12 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_12 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_12 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_12 of flank_stiction requires(sliding_friction_12)
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
        moving_centres_12_and_backlash_12 = moving_centres_12, backlash_12;
        moving_centres_12_and_damping = moving_centres_12, damping;
        transmission_error_12_and_sliding_friction_12_and_moving_phase = transmission_error_12, sliding_friction_12, stiffness_step,
            !frozen_phase;
        sliding_friction_12_and_moving_phase = sliding_friction_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_backlash_12_and_moving_phase = transmission_error_12, backlash_12, stiffness_step, !frozen_phase;
        transmission_error_12_and_moving_phase = transmission_error_12, stiffness_step, !frozen_phase;
        backlash_12_and_moving_phase = backlash_12, stiffness_step, !frozen_phase;
        moving_centres_12_and_transmission_error_12_and_backlash_12_and_moving_phase = moving_centres_12, transmission_error_12,
            backlash_12, stiffness_step, !frozen_phase;
        moving_centres_12_and_transmission_error_12_and_moving_phase = moving_centres_12, transmission_error_12, stiffness_step,
            !frozen_phase;
        moving_centres_12_and_backlash_12_and_moving_phase = moving_centres_12, backlash_12, stiffness_step, !frozen_phase;
        moving_centres_12_and_moving_phase = moving_centres_12, stiffness_step, !frozen_phase;
    }

    constants {
        h = r1/N1;
        cos_a = alpha.cos();
        sin_a = alpha.sin();
        R12 = h*N1 + h*N2;
        a12 = R12/cos_a;
        inv12 = sin_a/cos_a - alpha;
        tiny12 = 1.0/1000000000000.0;
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        bx1 = x1;
        by1 = y1;
        bx2 = x2;
        by2 = y2;
        x_c12 = x2 - x1;
        y_c12 = y2 - y1;
        drive12 = s - open12 - turn12 - e12 + cos_a*y1 - cos_a*y2 + sin_a*x1 - sin_a*x2;
        coast12 = open12 - turn12 + s - e12 + cos_a*y1 - cos_a*y2 - sin_a*x1 + sin_a*x2;
        opening12 = open12 - sin_a*x1 + sin_a*x2;
        over12 = s - turn12 - edge12 - e12 + cos_a*y1 - cos_a*y2 + sin_a*flank12*x1 - sin_a*flank12*x2 - flank12*open12;
        tau12 = cos_a*x2 - cos_a*x1 + sin_a*flank12*y1 - sin_a*flank12*y2 + sin_a*flank12*s/cos_a;
        psi12 = s/(2.0*h*N1) - s/(2.0*h*N2) + theta/N1 + theta/N2;
        theta_motor = s/(2.0*h*N1) + theta/N1;
        theta_load = theta/N2 - s/(2.0*h*N2);
    }
    functions {
        turn12 with moving_centres_12 = R12*(y_c12/(a12 + x_c12)).atan() - cos_a*y_c12;
        turn12_by_x_c12 with moving_centres_12 = -R12*y_c12/(y_c12.powi(2) + (a12 + x_c12).powi(2));
        turn12_by_y_c12 with moving_centres_12 = R12*(a12 + x_c12)/(y_c12.powi(2) + (a12 + x_c12).powi(2)) - cos_a;
        turn12_by_x_c12_by_x_c12 with moving_centres_12 = 2.0*R12*y_c12*(a12 + x_c12)/(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2);
        turn12_by_x_c12_by_y_c12 with moving_centres_12 = 2.0*R12*y_c12.powi(2)/(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2)
            - R12/(y_c12.powi(2) + (a12 + x_c12).powi(2));
        turn12_by_y_c12_by_y_c12 with moving_centres_12 = -2.0*R12*y_c12*(a12 + x_c12)/(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2);
        open12 with moving_centres_12 = (y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt() - R12*inv12
            - R12*((y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()/R12).atan() - sin_a*x_c12;
        open12_by_x_c12 with moving_centres_12 = (y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()*(a12 + x_c12)
            /(y_c12.powi(2) + (a12 + x_c12).powi(2)) - sin_a;
        open12_by_y_c12 with moving_centres_12 = y_c12*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()
            /(y_c12.powi(2) + (a12 + x_c12).powi(2));
        open12_by_x_c12_by_x_c12 with moving_centres_12 = (a12 + x_c12).powi(2)
            /((y_c12.powi(2) + (a12 + x_c12).powi(2))*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt())
            - 2.0*(a12 + x_c12).powi(2)*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()
            /(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2)
            + (y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()/(y_c12.powi(2) + (a12 + x_c12).powi(2));
        open12_by_x_c12_by_y_c12 with moving_centres_12 = y_c12*(a12 + x_c12)
            /((y_c12.powi(2) + (a12 + x_c12).powi(2))*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt())
            - 2.0*y_c12*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()*(a12 + x_c12)
            /(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2);
        open12_by_y_c12_by_y_c12 with moving_centres_12 = y_c12.powi(2)
            /((y_c12.powi(2) + (a12 + x_c12).powi(2))*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt())
            - 2.0*y_c12.powi(2)*(y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()
            /(y_c12.powi(2) + (a12 + x_c12).powi(2)).powi(2)
            + (y_c12.powi(2) - R12.powi(2) + (a12 + x_c12).powi(2)).sqrt()/(y_c12.powi(2) + (a12 + x_c12).powi(2));
    }
    rates {
        drive12_dot = s_dot + cos_a*y1_dot - cos_a*y2_dot + sin_a*x1_dot - sin_a*x2_dot + open12_by_x_c12*x1_dot - open12_by_x_c12*x2_dot
            + open12_by_y_c12*y1_dot - open12_by_y_c12*y2_dot + turn12_by_x_c12*x1_dot - turn12_by_x_c12*x2_dot + turn12_by_y_c12*y1_dot
            - turn12_by_y_c12*y2_dot;
        coast12_dot = s_dot + cos_a*y1_dot - cos_a*y2_dot - sin_a*x1_dot + sin_a*x2_dot - open12_by_x_c12*x1_dot + open12_by_x_c12*x2_dot
            - open12_by_y_c12*y1_dot + open12_by_y_c12*y2_dot + turn12_by_x_c12*x1_dot - turn12_by_x_c12*x2_dot + turn12_by_y_c12*y1_dot
            - turn12_by_y_c12*y2_dot;
        opening12_dot = sin_a*x2_dot - sin_a*x1_dot - open12_by_x_c12*x1_dot + open12_by_x_c12*x2_dot - open12_by_y_c12*y1_dot
            + open12_by_y_c12*y2_dot;
        over12_dot = s_dot + cos_a*y1_dot - cos_a*y2_dot + sin_a*flank12*x1_dot - sin_a*flank12*x2_dot + flank12*open12_by_x_c12*x1_dot
            - flank12*open12_by_x_c12*x2_dot + flank12*open12_by_y_c12*y1_dot - flank12*open12_by_y_c12*y2_dot + turn12_by_x_c12*x1_dot
            - turn12_by_x_c12*x2_dot + turn12_by_y_c12*y1_dot - turn12_by_y_c12*y2_dot;
    }
    forces {
        F_mu12 {
            sliding_friction_12 => mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()
                /(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
            flank_stiction_12 => mu12*k12*slide_dir12*touch12*(tiny12.powi(2) + over12.powi(2)).sqrt()
                - mu12*k12*touch12*psi12_dot*(tiny12.powi(2) + over12.powi(2)).sqrt()/(w_mix12.powi(2) + psi12_dot.powi(2)).sqrt();
        }
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
        over12 "m" (touch12 1.0, edge12 0.0, damp12 1.0, clip12 0.0, flank12 1.0) with backlash_12, "play of the mesh" {
            upper (1.0, b12/2.0, 1.0, 0.0, 1.0) rests counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper_loose {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until upper_hit {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until lower {
                    opening12 { _ => 1.0; }
                    over12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            lower (1.0, -b12/2.0, 1.0, 0.0, -1.0) rests counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower_loose {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until lower_hit {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until upper {
                    opening12 { _ => 1.0; }
                    over12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    drive12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
                until lower {
                    coast12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            upper_hit (1.0, b12/2.0, 0.0, 1.0, 1.0) counts "flanks met" {
                unless free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until lower {
                    opening12 { _ => 1.0; }
                    over12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            lower_hit (1.0, -b12/2.0, 0.0, 1.0, -1.0) counts "flanks met" {
                unless free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until upper {
                    opening12 { _ => 1.0; }
                    over12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
            }
            upper_loose (1.0, b12/2.0, 0.0, -1.0, 1.0) counts "flanks met" {
                until free { over12 { _ => 1.0; } }
                until upper {
                    over12 { _ => -k12; }
                    over12_dot { damping => -beta_K*k12_mid; }
                }
                until lower {
                    opening12 { _ => 1.0; }
                    over12 { _ => 1.0; }
                    one { _ => b12/2.0; }
                }
            }
            lower_loose (1.0, -b12/2.0, 0.0, -1.0, -1.0) counts "flanks met" {
                until free { over12 { _ => -1.0; } }
                until lower {
                    over12 { _ => k12; }
                    over12_dot { damping => beta_K*k12_mid; }
                }
                until upper {
                    opening12 { _ => 1.0; }
                    over12 { _ => -1.0; }
                    one { _ => b12/2.0; }
                }
            }
            loss { over12 { _ => k12*clip12*touch12; } }
        }
        psi12 "rad" (slide_dir12 0.0) with flank_stiction_12, "whether the flanks of the mesh stick" {
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
                    tau12_dot { _ => side12; }
                }
            }
            backward_coast (-1.0) {
                until backward { over12 { _ => -1.0; } }
                until stuck_coast {
                    psi12_dot { _ => -arm12; }
                    tau12_dot { _ => -side12; }
                }
            }
        }
    }
    energies {
        kinetic {
            _ => (I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2) + m1*x1_dot.powi(2)
                + m1*y1_dot.powi(2) + m2*x2_dot.powi(2) + m2*y2_dot.powi(2))/2.0;
        }
        potential { _ => (kb1*bx1.powi(2) + kb1*by1.powi(2) + kb2*bx2.powi(2) + kb2*by2.powi(2) + k12*touch12*over12.powi(2))/2.0; }
        dissipation {
            viscous_friction_1 => (cb1*bx1_dot.powi(2) + cb1*by1_dot.powi(2))/2.0;
            viscous_friction_2 => (cb2*bx2_dot.powi(2) + cb2*by2_dot.powi(2))/2.0;
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => (I1*alpha_M*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*alpha_M*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + alpha_M*m1*x1_dot.powi(2) + alpha_M*m1*y1_dot.powi(2) + alpha_M*m2*x2_dot.powi(2) + alpha_M*m2*y2_dot.powi(2)
                + beta_K*kb1*bx1_dot.powi(2) + beta_K*kb1*by1_dot.powi(2) + beta_K*kb2*bx2_dot.powi(2) + beta_K*kb2*by2_dot.powi(2)
                + beta_K*k12_mid*damp12*over12_dot.powi(2))/2.0;
        }
    }
    torques {
        slide12 "friction of the mesh, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_12 => -side12*F_mu12*tau12_dot; }
        roll12 "friction of the mesh, through the rolling of the gears" {}
        power { sliding_friction_12 => -arm12*F_mu12*psi12_dot; }
        motor "driving torque of the driving gear" { torques => T_motor*(s/(2.0*h*N1) + theta/N1); }
        governor_motor "torque c n of the governor of the driving gear; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*(s/(2.0*h*N1) + theta/N1);
        }
        dc_motor "torque Ts of the DC motor of the driving gear; its part -Ts omega/n0 is in D" {
            dc_motor => Ts_motor*(s/(2.0*h*N1) + theta/N1);
        }
        induction_motor "torque of the induction motor of the driving gear" {}
        power { induction_motor => T_induction_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        traction_motor "torque of the traction motor of the driving gear" {}
        power { traction_motor => T_traction_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        fan_motor "torque of the fan of the driving gear, against the rotation" {}
        power { fan_motor => T_fan_motor*(s_dot/(2.0*h*N1) + theta_dot/N1); }
        load "load torque of the driven gear, against its rotation" { torques => T_load*(s/(2.0*h*N2) - theta/N2); }
        governor_load "torque c n of the governor of the driven gear; its part -c omega is in D" {
            governor_load => c_load*n_load*(theta/N2 - s/(2.0*h*N2));
        }
        dc_load "torque Ts of the DC motor of the driven gear; its part -Ts omega/n0 is in D" {
            dc_load => Ts_load*(theta/N2 - s/(2.0*h*N2));
        }
        induction_load "torque of the induction motor of the driven gear" {}
        power { induction_load => T_induction_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
        traction_load "torque of the traction motor of the driven gear" {}
        power { traction_load => T_traction_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
        fan_load "torque of the fan of the driven gear, against the rotation" {}
        power { fan_load => T_fan_load*(theta_dot/N2 - s_dot/(2.0*h*N2)); }
    }
    work {
        theta {
            torques => T_motor/N1 - T_load/N2;
            governor_motor => c_motor*n_motor/N1;
            dc_motor => Ts_motor/N1;
            governor_load => c_load*n_load/N2;
            dc_load => Ts_load/N2;
        }
        s {
            torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
            governor_motor => c_motor*n_motor/(2.0*h*N1);
            dc_motor => Ts_motor/(2.0*h*N1);
            governor_load => -c_load*n_load/(2.0*h*N2);
            dc_load => -Ts_load/(2.0*h*N2);
        }
    }
    mass {
        theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2); }
        theta s { _ => (I1/(h*N1.powi(2)) - I2/(h*N2.powi(2)))/2.0; }
        s s { _ => (I1/(h.powi(2)*N1.powi(2)) + I2/(h.powi(2)*N2.powi(2)))/4.0; }
        x1 x1 { _ => m1; }
        y1 y1 { _ => m1; }
        x2 x2 { _ => m2; }
        y2 y2 { _ => m2; }
    }
    force {
        theta {
            transmission_error_12_and_jump_terms => k12*de12*touch12*over12;
            sliding_friction_12 => -arm12*F_mu12/N1 - arm12*F_mu12/N2;
            torques => T_motor/N1 - T_load/N2;
            governor_motor => c_motor*n_motor/N1 - c_motor*theta_motor_dot/N1;
            dc_motor => Ts_motor/N1 - Ts_motor*theta_motor_dot/(N1*n0_motor);
            induction_motor => T_induction_motor/N1;
            traction_motor => T_traction_motor/N1;
            fan_motor => T_fan_motor/N1;
            governor_load => c_load*n_load/N2 - c_load*theta_load_dot/N2;
            dc_load => Ts_load/N2 - Ts_load*theta_load_dot/(N2*n0_load);
            induction_load => T_induction_load/N2;
            traction_load => T_traction_load/N2;
            fan_load => T_fan_load/N2;
            damping => I2*alpha_M*s_dot/(2.0*h*N2.powi(2)) - I1*alpha_M*theta_dot/N1.powi(2) - I2*alpha_M*theta_dot/N2.powi(2)
                - I1*alpha_M*s_dot/(2.0*h*N1.powi(2));
            jump_terms => -dk12*touch12*over12.powi(2)/2.0;
        }
        s {
            _ => -k12*touch12*over12;
            backlash_12 => -k12*clip12*touch12*over12;
            sliding_friction_12 => arm12*F_mu12/(2.0*h*N2) - sin_a*side12*F_mu12*flank12/cos_a - arm12*F_mu12/(2.0*h*N1);
            torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
            governor_motor => (c_motor*n_motor/(h*N1) - c_motor*theta_motor_dot/(h*N1))/2.0;
            dc_motor => (Ts_motor/(h*N1) - Ts_motor*theta_motor_dot/(h*N1*n0_motor))/2.0;
            induction_motor => T_induction_motor/(2.0*h*N1);
            traction_motor => T_traction_motor/(2.0*h*N1);
            fan_motor => T_fan_motor/(2.0*h*N1);
            governor_load => (c_load*theta_load_dot/(h*N2) - c_load*n_load/(h*N2))/2.0;
            dc_load => (Ts_load*theta_load_dot/(h*N2*n0_load) - Ts_load/(h*N2))/2.0;
            induction_load => -T_induction_load/(2.0*h*N2);
            traction_load => -T_traction_load/(2.0*h*N2);
            fan_load => -T_fan_load/(2.0*h*N2);
            damping => I2*alpha_M*theta_dot/(2.0*h*N2.powi(2)) - beta_K*k12_mid*damp12*over12_dot
                - I1*alpha_M*s_dot/(4.0*h.powi(2)*N1.powi(2)) - I2*alpha_M*s_dot/(4.0*h.powi(2)*N2.powi(2))
                - I1*alpha_M*theta_dot/(2.0*h*N1.powi(2));
        }
        x1 {
            _ => -sin_a*k12*flank12*touch12*over12 - kb1*bx1;
            viscous_friction_1 => -cb1*bx1_dot;
            moving_centres_12 => -k12*flank12*touch12*open12_by_x_c12*over12 - k12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_x_c12*over12
                - k12*clip12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_damping => -beta_K*k12_mid*damp12*flank12*open12_by_x_c12*over12_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*over12_dot;
            backlash_12 => -sin_a*k12*clip12*flank12*touch12*over12;
            sliding_friction_12 => cos_a*side12*F_mu12;
            damping => -sin_a*beta_K*k12_mid*damp12*flank12*over12_dot - alpha_M*m1*x1_dot - beta_K*kb1*bx1_dot;
        }
        y1 {
            _ => -cos_a*k12*touch12*over12 - kb1*by1;
            viscous_friction_1 => -cb1*by1_dot;
            moving_centres_12 => -k12*flank12*touch12*open12_by_y_c12*over12 - k12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_y_c12*over12
                - k12*clip12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_damping => -beta_K*k12_mid*damp12*flank12*open12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*turn12_by_y_c12*over12_dot;
            backlash_12 => -cos_a*k12*clip12*touch12*over12;
            sliding_friction_12 => -sin_a*side12*F_mu12*flank12;
            damping => -cos_a*beta_K*k12_mid*damp12*over12_dot - alpha_M*m1*y1_dot - beta_K*kb1*by1_dot;
        }
        x2 {
            _ => sin_a*k12*flank12*touch12*over12 - kb2*bx2;
            viscous_friction_2 => -cb2*bx2_dot;
            moving_centres_12 => k12*flank12*touch12*open12_by_x_c12*over12 + k12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_x_c12*over12
                + k12*clip12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_x_c12*over12_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*over12_dot;
            backlash_12 => sin_a*k12*clip12*flank12*touch12*over12;
            sliding_friction_12 => -cos_a*side12*F_mu12;
            damping => sin_a*beta_K*k12_mid*damp12*flank12*over12_dot - alpha_M*m2*x2_dot - beta_K*kb2*bx2_dot;
        }
        y2 {
            _ => cos_a*k12*touch12*over12 - kb2*by2;
            viscous_friction_2 => -cb2*by2_dot;
            moving_centres_12 => k12*flank12*touch12*open12_by_y_c12*over12 + k12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_y_c12*over12
                + k12*clip12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*turn12_by_y_c12*over12_dot;
            backlash_12 => cos_a*k12*clip12*touch12*over12;
            sliding_friction_12 => sin_a*side12*F_mu12*flank12;
            damping => cos_a*beta_K*k12_mid*damp12*over12_dot - alpha_M*m2*y2_dot - beta_K*kb2*by2_dot;
        }
    }
    jacobian {
        theta theta {
            transmission_error_12_and_sliding_friction_12_and_moving_phase => de12*arm12*F_mu12_by_over12/N1
                + de12*arm12*F_mu12_by_over12/N2;
            transmission_error_12_and_jump_terms => k12*dde12*touch12*over12 - k12*de12.powi(2)*touch12 + 2.0*de12*dk12*touch12*over12;
            sliding_friction_12_and_moving_phase => -darm12*F_mu12/N1 - dk12*arm12*F_mu12_by_k12/N1 - darm12*F_mu12/N2
                - dk12*arm12*F_mu12_by_k12/N2;
            jump_terms => -ddk12*touch12*over12.powi(2)/2.0;
        }
        theta theta_dot { damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2); }
        theta s_dot { damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)))/2.0; }
        theta over12 {
            transmission_error_12_and_jump_terms => k12*de12*touch12;
            sliding_friction_12 => -arm12*F_mu12_by_over12/N1 - arm12*F_mu12_by_over12/N2;
            jump_terms => -dk12*touch12*over12;
        }
        theta psi12_dot { sliding_friction_12 => -arm12*F_mu12_by_psi12_dot/N1 - arm12*F_mu12_by_psi12_dot/N2; }
        theta theta_motor_dot {
            governor_motor => -c_motor/N1;
            dc_motor => -Ts_motor/(N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/N1;
            traction_motor => T_traction_motor_by_theta_motor_dot/N1;
            fan_motor => T_fan_motor_by_theta_motor_dot/N1;
        }
        theta theta_load_dot {
            governor_load => -c_load/N2;
            dc_load => -Ts_load/(N2*n0_load);
            induction_load => T_induction_load_by_theta_load_dot/N2;
            traction_load => T_traction_load_by_theta_load_dot/N2;
            fan_load => T_fan_load_by_theta_load_dot/N2;
        }
        s theta {
            transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => sin_a*de12*side12*F_mu12_by_over12*flank12/cos_a
                + de12*arm12*F_mu12_by_over12/(2.0*h*N1) - de12*arm12*F_mu12_by_over12/(2.0*h*N2);
            transmission_error_12_and_moving_phase => k12*de12*touch12;
            backlash_12_and_moving_phase => -dk12*clip12*touch12*over12;
            sliding_friction_12_and_moving_phase => darm12*F_mu12/(2.0*h*N2) - sin_a*dk12*side12*F_mu12_by_k12*flank12/cos_a
                - sin_a*dside12*F_mu12*flank12/cos_a - darm12*F_mu12/(2.0*h*N1) - dk12*arm12*F_mu12_by_k12/(2.0*h*N1)
                + dk12*arm12*F_mu12_by_k12/(2.0*h*N2);
            moving_phase => -dk12*touch12*over12;
        }
        s theta_dot { damping => (I2*alpha_M/(h*N2.powi(2)) - I1*alpha_M/(h*N1.powi(2)))/2.0; }
        s s_dot { damping => (-I1*alpha_M/(h.powi(2)*N1.powi(2)) - I2*alpha_M/(h.powi(2)*N2.powi(2)))/4.0; }
        s x_c12 {
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y2_dot - beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x2_dot - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y2_dot;
        }
        s y_c12 {
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y2_dot - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x2_dot - beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y2_dot;
        }
        s over12 {
            _ => -k12*touch12;
            backlash_12 => -k12*clip12*touch12;
            sliding_friction_12 => arm12*F_mu12_by_over12/(2.0*h*N2) - sin_a*side12*F_mu12_by_over12*flank12/cos_a
                - arm12*F_mu12_by_over12/(2.0*h*N1);
        }
        s over12_dot { damping => -beta_K*k12_mid*damp12; }
        s psi12_dot {
            sliding_friction_12 => arm12*F_mu12_by_psi12_dot/(2.0*h*N2) - sin_a*side12*F_mu12_by_psi12_dot*flank12/cos_a
                - arm12*F_mu12_by_psi12_dot/(2.0*h*N1);
        }
        s theta_motor_dot {
            governor_motor => -c_motor/(2.0*h*N1);
            dc_motor => -Ts_motor/(2.0*h*N1*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/(2.0*h*N1);
            traction_motor => T_traction_motor_by_theta_motor_dot/(2.0*h*N1);
            fan_motor => T_fan_motor_by_theta_motor_dot/(2.0*h*N1);
        }
        s theta_load_dot {
            governor_load => c_load/(2.0*h*N2);
            dc_load => Ts_load/(2.0*h*N2*n0_load);
            induction_load => -T_induction_load_by_theta_load_dot/(2.0*h*N2);
            traction_load => -T_traction_load_by_theta_load_dot/(2.0*h*N2);
            fan_load => -T_fan_load_by_theta_load_dot/(2.0*h*N2);
        }
        x1 theta {
            moving_centres_12_and_transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*flank12*touch12
                *open12_by_x_c12 + k12*de12*clip12*touch12*turn12_by_x_c12;
            moving_centres_12_and_transmission_error_12_and_moving_phase => k12*de12*flank12*touch12*open12_by_x_c12
                + k12*de12*touch12*turn12_by_x_c12;
            moving_centres_12_and_backlash_12_and_moving_phase => -dk12*clip12*flank12*touch12*open12_by_x_c12*over12
                - dk12*clip12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_moving_phase => -dk12*flank12*touch12*open12_by_x_c12*over12 - dk12*touch12*turn12_by_x_c12*over12;
            transmission_error_12_and_backlash_12_and_moving_phase => sin_a*k12*de12*clip12*flank12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => -cos_a*de12*side12*F_mu12_by_over12;
            transmission_error_12_and_moving_phase => sin_a*k12*de12*flank12*touch12;
            backlash_12_and_moving_phase => -sin_a*dk12*clip12*flank12*touch12*over12;
            sliding_friction_12_and_moving_phase => cos_a*dk12*side12*F_mu12_by_k12 + cos_a*dside12*F_mu12;
            moving_phase => -sin_a*dk12*flank12*touch12*over12;
        }
        x1 x1_dot { damping => -alpha_M*m1; }
        x1 bx1 { _ => -kb1; }
        x1 x_c12 {
            moving_centres_12 => -k12*flank12*touch12*open12_by_x_c12_by_x_c12*over12 - k12*touch12*turn12_by_x_c12_by_x_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_x_c12_by_x_c12*over12
                - k12*clip12*touch12*turn12_by_x_c12_by_x_c12*over12;
            moving_centres_12_and_damping => sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_x_c12*x2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_x_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*y1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*y2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*x1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*x2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*y1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*y2_dot;
        }
        x1 y_c12 {
            moving_centres_12 => -k12*flank12*touch12*open12_by_x_c12_by_y_c12*over12 - k12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_x_c12_by_y_c12*over12
                - k12*clip12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_damping => sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*x2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_y_c12_by_y_c12*y1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_y_c12_by_y_c12*y2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*x1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*x2_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12_by_y_c12*y1_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_x_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_x_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_y_c12_by_y_c12*y2_dot;
        }
        x1 over12 {
            _ => -sin_a*k12*flank12*touch12;
            moving_centres_12 => -k12*flank12*touch12*open12_by_x_c12 - k12*touch12*turn12_by_x_c12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_x_c12 - k12*clip12*touch12*turn12_by_x_c12;
            backlash_12 => -sin_a*k12*clip12*flank12*touch12;
            sliding_friction_12 => cos_a*side12*F_mu12_by_over12;
        }
        x1 bx1_dot {
            viscous_friction_1 => -cb1;
            damping => -beta_K*kb1;
        }
        x1 over12_dot {
            moving_centres_12_and_damping => -beta_K*k12_mid*damp12*flank12*open12_by_x_c12 - beta_K*k12_mid*damp12*turn12_by_x_c12;
            damping => -sin_a*beta_K*k12_mid*damp12*flank12;
        }
        x1 psi12_dot { sliding_friction_12 => cos_a*side12*F_mu12_by_psi12_dot; }
        y1 theta {
            moving_centres_12_and_transmission_error_12_and_backlash_12_and_moving_phase => k12*de12*clip12*flank12*touch12
                *open12_by_y_c12 + k12*de12*clip12*touch12*turn12_by_y_c12;
            moving_centres_12_and_transmission_error_12_and_moving_phase => k12*de12*flank12*touch12*open12_by_y_c12
                + k12*de12*touch12*turn12_by_y_c12;
            moving_centres_12_and_backlash_12_and_moving_phase => -dk12*clip12*flank12*touch12*open12_by_y_c12*over12
                - dk12*clip12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_moving_phase => -dk12*flank12*touch12*open12_by_y_c12*over12 - dk12*touch12*turn12_by_y_c12*over12;
            transmission_error_12_and_backlash_12_and_moving_phase => cos_a*k12*de12*clip12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => sin_a*de12*side12*F_mu12_by_over12*flank12;
            transmission_error_12_and_moving_phase => cos_a*k12*de12*touch12;
            backlash_12_and_moving_phase => -cos_a*dk12*clip12*touch12*over12;
            sliding_friction_12_and_moving_phase => -sin_a*dk12*side12*F_mu12_by_k12*flank12 - sin_a*dside12*F_mu12*flank12;
            moving_phase => -cos_a*dk12*touch12*over12;
        }
        y1 y1_dot { damping => -alpha_M*m1; }
        y1 by1 { _ => -kb1; }
        y1 x_c12 {
            moving_centres_12 => -k12*flank12*touch12*open12_by_x_c12_by_y_c12*over12 - k12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_x_c12_by_y_c12*over12
                - k12*clip12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_damping => cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x2_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y1_dot
                + cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y2_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x1_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x2_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y1_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_x_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_x_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*turn12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*turn12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*open12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*open12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*y2_dot;
        }
        y1 y_c12 {
            moving_centres_12 => -k12*flank12*touch12*open12_by_y_c12_by_y_c12*over12 - k12*touch12*turn12_by_y_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_y_c12_by_y_c12*over12
                - k12*clip12*touch12*turn12_by_y_c12_by_y_c12*over12;
            moving_centres_12_and_damping => cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x2_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y1_dot
                + cos_a*beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y2_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x1_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x2_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y1_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*turn12_by_y_c12*turn12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*turn12_by_y_c12*turn12_by_y_c12_by_y_c12*y2_dot
                - beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*over12_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*x1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*x2_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12*open12_by_y_c12_by_y_c12*y1_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12*open12_by_y_c12_by_y_c12*y2_dot;
        }
        y1 over12 {
            _ => -cos_a*k12*touch12;
            moving_centres_12 => -k12*flank12*touch12*open12_by_y_c12 - k12*touch12*turn12_by_y_c12;
            moving_centres_12_and_backlash_12 => -k12*clip12*flank12*touch12*open12_by_y_c12 - k12*clip12*touch12*turn12_by_y_c12;
            backlash_12 => -cos_a*k12*clip12*touch12;
            sliding_friction_12 => -sin_a*side12*F_mu12_by_over12*flank12;
        }
        y1 by1_dot {
            viscous_friction_1 => -cb1;
            damping => -beta_K*kb1;
        }
        y1 over12_dot {
            moving_centres_12_and_damping => -beta_K*k12_mid*damp12*flank12*open12_by_y_c12 - beta_K*k12_mid*damp12*turn12_by_y_c12;
            damping => -cos_a*beta_K*k12_mid*damp12;
        }
        y1 psi12_dot { sliding_friction_12 => -sin_a*side12*F_mu12_by_psi12_dot*flank12; }
        x2 theta {
            moving_centres_12_and_transmission_error_12_and_backlash_12_and_moving_phase => -k12*de12*clip12*flank12*touch12
                *open12_by_x_c12 - k12*de12*clip12*touch12*turn12_by_x_c12;
            moving_centres_12_and_transmission_error_12_and_moving_phase => -k12*de12*flank12*touch12*open12_by_x_c12
                - k12*de12*touch12*turn12_by_x_c12;
            moving_centres_12_and_backlash_12_and_moving_phase => dk12*clip12*flank12*touch12*open12_by_x_c12*over12
                + dk12*clip12*touch12*turn12_by_x_c12*over12;
            moving_centres_12_and_moving_phase => dk12*flank12*touch12*open12_by_x_c12*over12 + dk12*touch12*turn12_by_x_c12*over12;
            transmission_error_12_and_backlash_12_and_moving_phase => -sin_a*k12*de12*clip12*flank12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => cos_a*de12*side12*F_mu12_by_over12;
            transmission_error_12_and_moving_phase => -sin_a*k12*de12*flank12*touch12;
            backlash_12_and_moving_phase => sin_a*dk12*clip12*flank12*touch12*over12;
            sliding_friction_12_and_moving_phase => -cos_a*dk12*side12*F_mu12_by_k12 - cos_a*dside12*F_mu12;
            moving_phase => sin_a*dk12*flank12*touch12*over12;
        }
        x2 x2_dot { damping => -alpha_M*m2; }
        x2 bx2 { _ => -kb2; }
        x2 x_c12 {
            moving_centres_12 => k12*flank12*touch12*open12_by_x_c12_by_x_c12*over12 + k12*touch12*turn12_by_x_c12_by_x_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_x_c12_by_x_c12*over12
                + k12*clip12*touch12*turn12_by_x_c12_by_x_c12*over12;
            moving_centres_12_and_damping => sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_x_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_x_c12*x2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*y1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*y2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*x2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*y1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*y2_dot;
        }
        x2 y_c12 {
            moving_centres_12 => k12*flank12*touch12*open12_by_x_c12_by_y_c12*over12 + k12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_x_c12_by_y_c12*over12
                + k12*clip12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_damping => sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_x_c12_by_y_c12*x2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_y_c12_by_y_c12*y1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12*turn12_by_y_c12_by_y_c12*y2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*x1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*x2_dot
                + sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12_by_y_c12*y1_dot
                - sin_a*beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_x_c12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12*turn12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_x_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_x_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_x_c12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12*turn12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_x_c12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12*open12_by_y_c12_by_y_c12*y2_dot;
        }
        x2 over12 {
            _ => sin_a*k12*flank12*touch12;
            moving_centres_12 => k12*flank12*touch12*open12_by_x_c12 + k12*touch12*turn12_by_x_c12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_x_c12 + k12*clip12*touch12*turn12_by_x_c12;
            backlash_12 => sin_a*k12*clip12*flank12*touch12;
            sliding_friction_12 => -cos_a*side12*F_mu12_by_over12;
        }
        x2 bx2_dot {
            viscous_friction_2 => -cb2;
            damping => -beta_K*kb2;
        }
        x2 over12_dot {
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_x_c12 + beta_K*k12_mid*damp12*turn12_by_x_c12;
            damping => sin_a*beta_K*k12_mid*damp12*flank12;
        }
        x2 psi12_dot { sliding_friction_12 => -cos_a*side12*F_mu12_by_psi12_dot; }
        y2 theta {
            moving_centres_12_and_transmission_error_12_and_backlash_12_and_moving_phase => -k12*de12*clip12*flank12*touch12
                *open12_by_y_c12 - k12*de12*clip12*touch12*turn12_by_y_c12;
            moving_centres_12_and_transmission_error_12_and_moving_phase => -k12*de12*flank12*touch12*open12_by_y_c12
                - k12*de12*touch12*turn12_by_y_c12;
            moving_centres_12_and_backlash_12_and_moving_phase => dk12*clip12*flank12*touch12*open12_by_y_c12*over12
                + dk12*clip12*touch12*turn12_by_y_c12*over12;
            moving_centres_12_and_moving_phase => dk12*flank12*touch12*open12_by_y_c12*over12 + dk12*touch12*turn12_by_y_c12*over12;
            transmission_error_12_and_backlash_12_and_moving_phase => -cos_a*k12*de12*clip12*touch12;
            transmission_error_12_and_sliding_friction_12_and_moving_phase => -sin_a*de12*side12*F_mu12_by_over12*flank12;
            transmission_error_12_and_moving_phase => -cos_a*k12*de12*touch12;
            backlash_12_and_moving_phase => cos_a*dk12*clip12*touch12*over12;
            sliding_friction_12_and_moving_phase => sin_a*dk12*side12*F_mu12_by_k12*flank12 + sin_a*dside12*F_mu12*flank12;
            moving_phase => cos_a*dk12*touch12*over12;
        }
        y2 y2_dot { damping => -alpha_M*m2; }
        y2 by2 { _ => -kb2; }
        y2 x_c12 {
            moving_centres_12 => k12*flank12*touch12*open12_by_x_c12_by_y_c12*over12 + k12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_x_c12_by_y_c12*over12
                + k12*clip12*touch12*turn12_by_x_c12_by_y_c12*over12;
            moving_centres_12_and_damping => cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*x2_dot
                + cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*y2_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*x2_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y1_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_x_c12*turn12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_x_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_x_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*turn12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_x_c12*turn12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*open12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_x_c12*open12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*y2_dot;
        }
        y2 y_c12 {
            moving_centres_12 => k12*flank12*touch12*open12_by_y_c12_by_y_c12*over12 + k12*touch12*turn12_by_y_c12_by_y_c12*over12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_y_c12_by_y_c12*over12
                + k12*clip12*touch12*turn12_by_y_c12_by_y_c12*over12;
            moving_centres_12_and_damping => cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*x2_dot
                + cos_a*beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y1_dot
                - cos_a*beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*y2_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x1_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*x2_dot
                + cos_a*beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y1_dot
                - cos_a*beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_x_c12_by_y_c12*turn12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_x_c12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12*turn12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*turn12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*flank12*open12_by_y_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*turn12_by_x_c12_by_y_c12*turn12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*turn12_by_y_c12*turn12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*turn12_by_y_c12*turn12_by_y_c12_by_y_c12*y2_dot
                + beta_K*k12_mid*damp12*turn12_by_y_c12_by_y_c12*over12_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*x1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_x_c12_by_y_c12*open12_by_y_c12*x2_dot
                + beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12*open12_by_y_c12_by_y_c12*y1_dot
                - beta_K*k12_mid*damp12*flank12.powi(2)*open12_by_y_c12*open12_by_y_c12_by_y_c12*y2_dot;
        }
        y2 over12 {
            _ => cos_a*k12*touch12;
            moving_centres_12 => k12*flank12*touch12*open12_by_y_c12 + k12*touch12*turn12_by_y_c12;
            moving_centres_12_and_backlash_12 => k12*clip12*flank12*touch12*open12_by_y_c12 + k12*clip12*touch12*turn12_by_y_c12;
            backlash_12 => cos_a*k12*clip12*touch12;
            sliding_friction_12 => sin_a*side12*F_mu12_by_over12*flank12;
        }
        y2 by2_dot {
            viscous_friction_2 => -cb2;
            damping => -beta_K*kb2;
        }
        y2 over12_dot {
            moving_centres_12_and_damping => beta_K*k12_mid*damp12*flank12*open12_by_y_c12 + beta_K*k12_mid*damp12*turn12_by_y_c12;
            damping => cos_a*beta_K*k12_mid*damp12;
        }
        y2 psi12_dot { sliding_friction_12 => sin_a*side12*F_mu12_by_psi12_dot*flank12; }
    }
    cell {
        stiffness {
            bx1 bx1 { _ => kb1; }
            by1 by1 { _ => kb1; }
            bx2 bx2 { _ => kb2; }
            by2 by2 { _ => kb2; }
            over12 over12 {
                _ => k12*touch12;
                backlash_12 => k12*clip12*touch12;
            }
        }
        damping {
            theta theta { damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2); }
            theta s { damping => (I1*alpha_M/(h*N1.powi(2)) - I2*alpha_M/(h*N2.powi(2)))/2.0; }
            s s { damping => (I1*alpha_M/(h.powi(2)*N1.powi(2)) + I2*alpha_M/(h.powi(2)*N2.powi(2)))/4.0; }
            x1 x1 { damping => alpha_M*m1; }
            y1 y1 { damping => alpha_M*m1; }
            x2 x2 { damping => alpha_M*m2; }
            y2 y2 { damping => alpha_M*m2; }
            bx1 bx1 {
                viscous_friction_1 => cb1;
                damping => beta_K*kb1;
            }
            by1 by1 {
                viscous_friction_1 => cb1;
                damping => beta_K*kb1;
            }
            bx2 bx2 {
                viscous_friction_2 => cb2;
                damping => beta_K*kb2;
            }
            by2 by2 {
                viscous_friction_2 => cb2;
                damping => beta_K*kb2;
            }
            over12 over12 { damping => beta_K*k12_mid*damp12; }
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
                torques => T_motor/N1 - T_load/N2;
                governor_motor => c_motor*n_motor/N1;
                dc_motor => Ts_motor/N1;
                governor_load => c_load*n_load/N2;
                dc_load => Ts_load/N2;
            }
            s {
                torques => (T_motor/(h*N1) + T_load/(h*N2))/2.0;
                governor_motor => c_motor*n_motor/(2.0*h*N1);
                dc_motor => Ts_motor/(2.0*h*N1);
                governor_load => -c_load*n_load/(2.0*h*N2);
                dc_load => -Ts_load/(2.0*h*N2);
            }
            over12 {
                _ => k12*touch12*edge12 + k12*touch12*e12;
                backlash_12 => k12*clip12*touch12*edge12 + k12*clip12*touch12*e12;
            }
        }
    }
    nonlinear_with {
        sliding_friction_12 "-side12*F_mu12 in the torque `slide12`";
        sliding_friction_12 "-arm12*F_mu12 in the torque `roll12`";
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
        moving_centres_12 "the deflection drive12 bends";
        moving_centres_12 "the deflection coast12 bends";
        moving_centres_12 "the deflection opening12 bends";
        moving_centres_12 "the deflection over12 bends";
    }
    jump k12 { step { _ => dk12*touch12*over12.powi(2)/2.0; } }
    jump e12 { step { _ => k12*de12.powi(2)*touch12/2.0 - k12*de12*touch12*over12; } }
    jump side12 { step {} }
    jump arm12 { step {} }
    outputs {
        rotor_speed_1 "rad/s", "rotational speed of the driving gear" { _ => s_dot/(2.0*h*N1) + theta_dot/N1; }
        rotor_speed_2 "rad/s", "rotational speed of the driven gear" { _ => theta_dot/N2 - s_dot/(2.0*h*N2); }
        bearing_force_1_x "N", "force on the bearing of gear 1 along x" {
            _ => kb1*bx1;
            viscous_friction_1 => cb1*bx1_dot;
            damping => beta_K*kb1*bx1_dot;
        }
        bearing_force_1_y "N", "force on the bearing of gear 1 along y" {
            _ => kb1*by1;
            viscous_friction_1 => cb1*by1_dot;
            damping => beta_K*kb1*by1_dot;
        }
        bearing_force_1 "N", "magnitude of the force on the bearing of gear 1" {
            _ => (bearing_force_1_x.powi(2) + bearing_force_1_y.powi(2)).sqrt();
        }
        bearing_loss_1 "W", "power that the damper of the bearing of gear 1 takes" {
            viscous_friction_1 => cb1*bx1_dot.powi(2) + cb1*by1_dot.powi(2);
            damping => beta_K*kb1*bx1_dot.powi(2) + beta_K*kb1*by1_dot.powi(2);
        }
        bearing_force_2_x "N", "force on the bearing of gear 2 along x" {
            _ => kb2*bx2;
            viscous_friction_2 => cb2*bx2_dot;
            damping => beta_K*kb2*bx2_dot;
        }
        bearing_force_2_y "N", "force on the bearing of gear 2 along y" {
            _ => kb2*by2;
            viscous_friction_2 => cb2*by2_dot;
            damping => beta_K*kb2*by2_dot;
        }
        bearing_force_2 "N", "magnitude of the force on the bearing of gear 2" {
            _ => (bearing_force_2_x.powi(2) + bearing_force_2_y.powi(2)).sqrt();
        }
        bearing_loss_2 "W", "power that the damper of the bearing of gear 2 takes" {
            viscous_friction_2 => cb2*bx2_dot.powi(2) + cb2*by2_dot.powi(2);
            damping => beta_K*kb2*bx2_dot.powi(2) + beta_K*kb2*by2_dot.powi(2);
        }
        contact_loss_12 "1" with backlash_12, "1 while no force passes the mesh, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touch12*(1.0 + clip12*(1.0 - clip12)/2.0);
        }
        mesh_force_12 "N", "force of the mesh along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k12*touch12*over12;
            backlash_12 => k12*clip12*touch12*over12;
            damping => beta_K*k12_mid*damp12*over12_dot;
        }
        mesh_power_12 "W", "power that the first gear gives to the mesh: force times the speed of its flank" {
            _ => mesh_force_12*(s_dot/2.0 + cos_a*y1_dot + h*theta_dot + sin_a*flank12*x1_dot);
        }
        mesh_deflection_12 "m", "deflection of the mesh along the line of action, backlash not taken off" {
            _ => (2.0*s - (cos_a*y2 - sin_a*x2) - (cos_a*y2 + sin_a*x2) + 2.0*cos_a*y1)/2.0 - turn12 - e12
                - (open12 + (s - (s - (cos_a*y2 + sin_a*x2) + cos_a*y1 + sin_a*x1) - (cos_a*y2 - sin_a*x2) + cos_a*y1 - sin_a*x1)/2.0);
        }
        dte_12 "m", "dynamic transmission error of the mesh along the line of action: positive if the driving gear is ahead" {
            _ => (2.0*s - (cos_a*y2 - sin_a*x2) - (cos_a*y2 + sin_a*x2) + 2.0*cos_a*y1)/2.0 - turn12
                - (open12 + (s - (s - (cos_a*y2 + sin_a*x2) + cos_a*y1 + sin_a*x1) - (cos_a*y2 - sin_a*x2) + cos_a*y1 - sin_a*x1)/2.0);
        }
        mesh_loss_12 "W", "power that the damper of the mesh takes" {
            backlash_12 => k12*clip12*touch12*over12*over12_dot;
            damping => beta_K*k12_mid*damp12*over12_dot.powi(2);
        }
        play_opening_12 "m" with backlash_12, "half the opening of the play of the mesh by the motion of the gears' centres" {
            _ => open12 + (s - (s - (cos_a*y2 + sin_a*x2) + cos_a*y1 + sin_a*x1) - (cos_a*y2 - sin_a*x2) + cos_a*y1 - sin_a*x1)/2.0;
        }
        power_slide12 "W" with sliding_friction_12,
            "power of the friction of the mesh, through the sliding of the flanks at the pitch point: positive if it drives" {
            _ => slide12_power;
        }
        power_roll12 "W" with sliding_friction_12,
            "power of the friction of the mesh, through the rolling of the gears: positive if it drives" {
            _ => roll12_power;
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
            _ => 2.0*alpha_M*((I1*(s_dot/(2.0*h*N1) + theta_dot/N1).powi(2) + I2*(theta_dot/N2 - s_dot/(2.0*h*N2)).powi(2)
                + m1*x1_dot.powi(2) + m1*y1_dot.powi(2) + m2*x2_dot.powi(2) + m2*y2_dot.powi(2))/2.0);
        }
    }

    text "text/gear_pair_bearings.txt";
    latex "latex/gear_pair_bearings.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - at a step of k12, e12: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in
//   transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side12, arm12: no impulse there
// - V is the same on both sides of the exits of over12: no impulse there
// - the force of the switch over12 takes energy or none: f over12_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dover12 and c = 1 or -1, since F over12 >= 0, over12_dot dD/dover12_dot >= 0 and c over12
//   dD/dover12_dot >= F over12
// - V is the same on both sides of the exits of psi12: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll12` takes energy or none: its power is never positive
// - the friction `slide12` is the force of `roll12` times at most 1, along its sign or against it
// - the friction `slide12` takes with `roll12` energy or none where psi12_dot and arm12 psi12_dot + side12 tau12_dot have one sign, on the
//   coast flank with -side12: where flanks slide as rolling makes them
// - the friction `slide12` takes with `roll12` energy or none in every mode of psi12, in scenes with flank_stiction_12: from the guards
//   that hold in the mode
// - every deflection equals the linear form by which the equations differentiate it
// - every deflection that bends has the rate by which the equations differentiate it
// - every function of several positions has the gradient that is written
// - without the jump terms the balance fails: energy is created at the rate dk12*touch12*over12^2*theta_dot/2 -
//   k12*de12*touch12*over12*theta_dot
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 2 | 7 | 2 |
// | named forces | 36 | 102 | 11 |
// | force | 44 | 341 | 0 |
// | energy steps, all laws | 1 | 11 | 0 |
